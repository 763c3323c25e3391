"""Bilingual words: every sentence is one value with a Chinese and an English face."""

from __future__ import annotations

import os
import re
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Literal

Lang = Literal["zh", "en"]


@dataclass(frozen=True, slots=True)
class Words:
    """A sentence in Chinese and English; ``$...$`` holds symbols in the notation of `formula`."""

    zh: str
    en: str

    def of(self, lang: Lang) -> str:
        """The sentence in one language."""
        return self.zh if lang == "zh" else self.en

    @property
    def plain(self) -> Words:
        """Without the signs of its symbols, for where no type can be set."""
        return Words(bare(self.zh), bare(self.en))

    @classmethod
    def same(cls, text: str) -> Words:
        """A text that is the same in both languages: symbols, letters of a direction."""
        return cls(text, text)

    def __add__(self, other: Words) -> Words:
        return Words(self.zh + other.zh, self.en + other.en)


def begun(words: Words) -> Words:
    """The same where a sentence begins with it: Gear 3 rolls ..."""
    return Words(words.zh, words.en[:1].upper() + words.en[1:])


def joined(names: Sequence[Words]) -> Words:
    """Their names, the last joined by 和 / and; nothing of none."""
    if len(names) < 2:
        return names[0] if names else Words.same("")
    return Words(
        "、".join(w.zh for w in names[:-1]) + "和" + names[-1].zh,
        ", ".join(w.en for w in names[:-1]) + " and " + names[-1].en,
    )


def many(count: int, what: str) -> str:
    """1 student, 2 students; 0 answers or rows."""
    return (
        f"{count} {what}"
        if count != 1
        else f"{count} {' or '.join(one.removesuffix('s') for one in what.split(' or '))}"
    )


_JOINTS = (" (", " of ", " of", " between ", " at ", " on ", " counter-clockwise ")


def plural(name: str) -> str:
    """The name of several: balancing masses, angular positions of the holes; what follows a bracket stays."""
    ends = [at for joint in _JOINTS if (at := name.find(joint)) >= 0]
    head, rest = (name[: min(ends)], name[min(ends) :]) if ends else (name, "")
    joint = next((one for one in _JOINTS if rest.startswith(one)), "")
    tail = rest.removeprefix(joint)
    each = tail.startswith("the ") and head.endswith("position")  # of things of which there are several
    return f"{_several(head)}{joint}{plural(tail) if each else tail}"


def _several(noun: str) -> str:
    if noun.endswith("radius"):
        return noun.removesuffix("us") + "i"
    if noun.endswith("ty"):
        return noun.removesuffix("y") + "ies"
    return noun + ("es" if noun.endswith("s") else "s")


def stopped(text: str, lang: Lang) -> str:
    """A sentence with its full stop, where it has none."""
    return text if text.rstrip(" ")[-1:] in _STOPS else text + ("。" if lang == "zh" else ".")


_STOPS = tuple("。！？.!?")


def bare(text: str) -> str:
    """A sentence without the signs of its symbols: a_C for $a_{C}$."""
    return text.translate(_MARKS)


def unmarked(text: str) -> str:
    """A text that may hold more than a sentence, the symbols in it bare: {along: BC} keeps its braces, $a_{C}$ not."""
    return _SYMBOL.sub(lambda found: bare(found[1]), text)


_SYMBOL = re.compile(r"\$([^$\n]+)\$")
_MARKS = {ord(sign): None for sign in "${}"}


def language() -> Lang:
    """The reader's language: what VECPOLY_LANG says, English else."""
    return "zh" if os.environ.get("VECPOLY_LANG") == "zh" else "en"


def label(problem_id: str) -> Words:
    """题 4-3a / Problem 4-3a: what a numbered exercise is called;
    nothing for an id that is a name, which its title says better."""
    found = re.match(r"\d+-\d+[a-z]?(?![a-z])", problem_id)
    return Words(f"题 {found[0]}", f"Problem {found[0]}") if found else Words.same("")
