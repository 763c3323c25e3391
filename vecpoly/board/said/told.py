"""A construction as a readable list: its steps, and under each the acts with what they gave and what they needed."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from typing import Protocol, assert_never
from unicodedata import east_asian_width

from ...algebra.quantity import number
from ...names import written_unit
from ...words import Lang, Words, bare
from .. import acts as done
from ..acts import Act, Leaving

VERB, OBJECT = 14, 28  # columns of a terminal: what is done, and with what


class Stepped(Protocol):
    """A step, as far as it is told here."""

    @property
    def number(self) -> int: ...

    @property
    def section(self) -> Words: ...

    @property
    def words(self) -> Words: ...


def told(steps: Sequence[Stepped], acts: Sequence[Act], lang: Lang = "zh") -> str:
    """Steps and acts, one a line, each act with its number; lengths and places in mm on paper, values in SI units."""
    return "\n".join(_lines(steps, acts, lang))


def _lines(steps: Sequence[Stepped], acts: Sequence[Act], lang: Lang) -> Iterator[str]:
    section = ""
    for step in steps:
        if step.section.of(lang) != section:
            section = step.section.of(lang)
            yield f"— {primed(section)} —"
        yield f"{step.number}. {primed(step.words.of(lang))}"
        yield from (_line(act, acts, lang) for act in acts if act.head.step == step.number and _shown(act))


def _line(act: Act, acts: Sequence[Act], lang: Lang) -> str:
    """Number, verb, object, and what was needed, in columns that Chinese letters keep too."""
    needed = ("、" if lang == "zh" else ", ").join(dict.fromkeys(acts[n].key or f"#{n}" for n in act.inputs))
    verb, what = (act.verb or Words.same("")).of(lang), _object(act)
    return f"{f'#{act.number}':>7s}  {wide(verb, VERB)}{wide(what, OBJECT)}{'← ' + needed if needed else ''}".rstrip()


def wide(text: str, columns: int) -> str:
    """The text with blanks up to this many columns of a terminal, at least one; a Chinese letter takes two."""
    taken = sum(2 if east_asian_width(letter) in "WF" else 1 for letter in text)
    return text + " " * max(columns - taken, 1)


def primed(text: str) -> str:
    """A sentence without the signs of its symbols: n_2′ for $n_2^′$."""
    return re.sub(" {2,}", " ", bare(re.sub(r"\^\{?([′'])\}?", r"\1", text)))


def _shown(act: Act) -> bool:
    """Acts that only leave ink are not told, nor vectors and lines without a name."""
    return act.verb is not None and bool(act.key or isinstance(act, done.Meet | done.Image))


def _object(act: Act) -> str:
    """What was done it with, and what it gave."""
    if isinstance(act, Leaving):
        return act.key
    match act:
        case done.Locate() | done.Image() | done.Meet() | done.Invert():
            return f"{act.key} ({_mm(act.at.real)}, {_mm(act.at.imag)}) mm".lstrip()
        case done.LayOff():
            return f"{act.key}: {number(act.mm)} mm"
        case done.Measure():
            return f"{act.key} = {number(act.mm)} mm"
        case done.Area():
            return f"{act.key} = {number(act.mm2)} mm²"
        case done.Judge():
            return f"{act.key}: {'×' if act.crosses else '∥'}"
        case done.Compute():
            return f"{act.key} = {_value(act.value, act.unit)}"
        case done.Answer():
            return f"{act.key} = {_value(abs(act.value) if isinstance(act.value, complex) else act.value, act.unit)}"
        case done.Turn() | done.Parallel() | done.Ray() | done.Follow() | done.Transfer() | done.Touch() | done.Gauge():
            return act.key
        case _:
            assert_never(act)


def _value(value: float, name: str) -> str:
    printed, mark = primed(number(value)), written_unit(name)
    return f"{printed}°" if mark == "°" else f"{printed} {mark}".rstrip()


def _mm(place: float) -> str:
    return f"{place + 0.0:.2f}".replace("-0.00", "0.00").replace("-", "−")
