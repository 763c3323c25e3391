"""Other letters, other numbers of the links."""

from __future__ import annotations

import re
from collections.abc import Callable
from typing import Any

import numpy as np

from vecpoly.foundation.indices import BELOW
from vecpoly.solution import Solution

from ..family import family
from ..library import Data, data_of
from .original import Change, compared, original, text_of, told

_LETTER = r"[A-Z][a-z]?"
_WORD = re.compile(r"[A-Za-z]\w*")
_POINTS = re.compile(rf"((?:p|v|a|an|at|ak|ar|l)_)?((?:{_LETTER}\d*)+)")
_FORCE = re.compile(r"-?[\d.e+-]+ k?N(\*m)?( c?cw)?")
_LOOSE = re.compile(r"(?<![\w.\-^])(\d+)(?![\w.]| mm| deg)")  # a link in a joint, no number of a quantity
_KEYS = re.compile(r"(omega|alpha|h|m|J|F_I|M_I)(_?)(\d+)((?:_0)?)")
_REACTION = re.compile(r"R_(?:(\d)(\d)|(\d+)_([1-9]\d*))((?:_0)?)")  # R_12, R_1_11, both with friction left out


class Names:
    """Letter → letter, number → number."""

    def __init__(self, rng: np.random.Generator, data: Data) -> None:
        self.links = list(data["links"])
        self.number = dict(zip(self.links, map(str, rng.permutation(np.array(self.links, dtype=int))), strict=True))
        self.letters = sorted({p for word in _words(data) for p in re.findall(_LETTER, word)})
        self.letter = dict(zip(self.letters, map(str, rng.permutation(self.letters)), strict=True))
        pivots = [letter for letter in self.letters if letter in data["frame"]]
        moving = {new[0] for old, new in self.letter.items() if old not in pivots}
        self.indexed = bool(rng.random() < 0.5 and "O" not in moving and len(pivots) < 10)
        if self.indexed:  # as many books call the fixed pivots: O1, O2
            self.letter |= {letter: f"O{n}" for n, letter in enumerate(pivots, 1)}

    def points(self, word: str) -> str:
        """v_B3B2 → v_K1K4, AB → KD; load names and units stay."""
        if m := _KEYS.fullmatch(word):
            return f"{m[1]}{m[2]}{self.number.get(m[3], m[3])}{m[4]}"
        if m := _REACTION.fullmatch(word):
            return self._reaction(m[1] or m[3], m[2] or m[4]) + m[5]
        m = _POINTS.fullmatch(word)
        if m is None or not set(re.findall(_LETTER, m[2])) <= set(self.letters):
            return word
        return (m[1] or "") + re.sub(
            rf"({_LETTER})(\d*)", lambda n: self.letter[n[1]] + self.number.get(n[2], n[2]), m[2]
        )

    def _reaction(self, first: str, second: str) -> str:
        """R_12; R_1_11, where one of the numbers has two digits."""
        one, other = (self.number.get(link, link) for link in (first, second))
        return f"R_{one}{other}" if len(one) == len(other) == 1 else f"R_{one}_{other}"

    def answer(self, key: str) -> str:
        """The key of the renamed solution: an indexed pivot is one letter there, O₁."""
        new = self.points(key)
        return re.sub(r"O(\d)", lambda n: "O" + n[1].translate(BELOW), new) if self.indexed else new

    def text(self, text: str) -> str:
        """A text of the file: a statement, a key."""
        if _FORCE.fullmatch(text):
            return text
        return _WORD.sub(lambda m: self.points(m[0]), text)

    def joint(self, text: str) -> str:
        """A sentence of a joint, in which numbers are links."""
        return _LOOSE.sub(lambda m: str(self.number.get(m[1], m[1])), self.text(text))

    def tree(self, value: Any) -> Any:
        match value:
            case dict():
                return {self.text(key): self.tree(inner) for key, inner in value.items()}
            case list():
                return [self.tree(inner) for inner in value]
            case str():
                return self.text(value)
            case _:
                return value

    def data(self, data: Data) -> Data:
        """All of the file: its links in another order, too."""
        new = {
            key: self.tree(value)
            for key, value in data.items()
            if key not in ("id", "title", "links", "joints", "masses", "loads", "friction")
        }
        new["joints"] = [self.joint(text) for text in data.get("joints") or []]
        for key in ("links", "masses"):
            if key in data:
                new[key] = {
                    self.number[name]: self.tree(value)
                    for name, value in sorted(data[key].items(), key=lambda item: self.number[item[0]])
                }
        if "friction" in data:
            new["friction"] = {self._pair(name): value for name, value in data["friction"].items()}
        if "loads" in data:
            new["loads"] = {name: self._load(load) for name, load in data["loads"].items()}
        new["input"] = self._load(data["input"])
        if "pins" in data:
            new["pins"] = {self.text(letter): self.number.get(name, name) for letter, name in data["pins"].items()}
        return {"id": data["id"], **new}

    def _pair(self, name: str) -> str:
        return "-".join(self.number.get(part, part) for part in name.split("-")) if "-" in name else self.text(name)

    def _load(self, load: Data) -> Data:
        linked: dict[str, Callable[[str], str | None]] = {
            "on": self.number.get,
            "link": self.number.get,
            "cylinder": self._pair,
        }
        return {key: linked[key](value) if key in linked else self.text(value) for key, value in load.items()}


def _words(data: Data) -> list[str]:
    """Where letters are made known: the frame and the links."""
    found = list(data["frame"])
    for link in data["links"].values():
        for key, value in link.items():
            found += [key] if re.fullmatch(rf"({_LETTER})+", key) else []
            found += [value] if isinstance(value, str) and re.fullmatch(_LETTER, value) else []
            found += [value["through"]] if isinstance(value, dict) and "through" in value else []
    return found + re.findall(rf"(?:through|at|about) ({_LETTER})\b", " ".join(data.get("joints", [])))


def renaming(mark: str, seed: int) -> tuple[Data, Names]:
    """The original's data and the names they get; the same for the same seed."""
    data = data_of(text_of(mark))
    return data, Names(np.random.default_rng(seed), data)


def under_other_names(solution: Solution) -> str:
    """The answers are the original's, under the other names."""
    mark, _, seed = str(solution.problem.title.en).rpartition(" ")
    return compared(solution, Change(key=renaming(mark, int(seed))[1].answer), mark)


@family("retold-names", also=under_other_names, often=1)
def with_other_names(rng: np.random.Generator) -> str:
    """Any member of the other families, its letters and numbers permuted."""
    mark, _ = original(rng)
    data, names = renaming(mark, seed := int(rng.integers(10**6)))
    return told(names.data(data), f"{mark} {seed}")
