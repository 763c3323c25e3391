"""The head of a column: whose answer to what it holds."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from enum import StrEnum

from ...batch.columns import NAME, NUMBER, TEAM, is_one
from ...errors import UnknownNameError
from ...grading.key import AnswerKey, Kind
from ...grading.reading.characters import plain
from ...grading.reading.symbol import keyed
from ...grading.reading.unit import unit

_IDENTITY = {"student": (*NUMBER, "student", "sid"), "name": NAME, "team": TEAM, "sheet": ("卷号", "sheet", "variant")}
NO_PROBLEM = "no-problem"
_SUFFIX = re.compile(
    r"^(?P<symbol>.*?)[\s_]*(?:\(?(?P<mm>mm)\)?|(?P<deg>deg|°|方向|direction)|(?P<sense>sense|转向))$", re.I
)


class Part(StrEnum):
    """Which part of an answer a column holds."""

    VALUE = "value"
    LENGTH = "mm"
    DIRECTION = "deg"
    SENSE = "sense"


@dataclass(frozen=True, slots=True)
class Head:
    """problem: as the key has it; symbol: of the key, or of a scale; unit: of what is written below, where it is
    told."""

    problem: str
    symbol: str
    part: Part
    unit: str = ""

    @property
    def what(self) -> tuple[str, str, Part]:
        """What it holds, in whatever unit: two columns of this are one too many."""
        return self.problem, self.symbol, self.part


def identity(cell: str) -> str | None:
    """What of a student a column holds: student, name, team, sheet."""
    return next((what for what, heads in _IDENTITY.items() if is_one(cell, heads)), None)


def head(cell: str, keys: Mapping[str, AnswerKey], default: str | None = None) -> Head:
    """``3-9:v_E mm``, or ``v_E mm`` on a page of its own or where there is one problem.

    Raises UnknownNameError for a problem or a symbol that is not there.
    """
    text = plain(cell)
    problem, colon, symbol = text.partition(":")
    if not colon or problem.strip() not in keys:
        problem, symbol = default or _only(keys, text, problem.strip() if colon else ""), text
    problem = problem.strip()
    key = keys[problem]
    names = [one.key for one in key.quantities] + list(key.scales) + [row.key for row in key.equations]
    found = _symbol(symbol.strip(), names)
    if found is None:
        return _with_unit(problem, symbol, names, key)
    return Head(problem, *found)


def _only(keys: Mapping[str, AnswerKey], text: str, named: str) -> str:
    """The one problem that there is; named: what stands before a colon, where that is none."""
    if len(keys) == 1:
        return next(iter(keys))
    from ...words import Words

    if named:
        raise UnknownNameError(
            Words(
                f"这次作业没有题 {named}；题号有 {'、'.join(keys)}",
                f"this class has no problem {named}; the problems are {', '.join(keys)}",
            ),
            code=NO_PROBLEM,
            numbers={"problem": named},
        )
    raise UnknownNameError(
        Words(
            f"列“{text}”没有写是哪一题；请写 题号:符号，题号有 {'、'.join(keys)}",
            f"column '{text}' does not say of which problem; write problem:symbol, the problems are {', '.join(keys)}",
        ),
        code="which-problem",
    )


def _symbol(symbol: str, names: Sequence[str]) -> tuple[str, Part] | None:
    """The symbol and the part; a symbol that ends like a part is itself where the key has it. None: neither."""
    found = _SUFFIX.match(symbol)
    for name, part in ((symbol, Part.VALUE), (found["symbol"] if found else "", _part(found))):
        try:
            return keyed(name, names), part
        except UnknownNameError:
            continue
    return None


def _part(found: re.Match[str] | None) -> Part:
    if found is None:
        return Part.VALUE
    return Part.LENGTH if found["mm"] else Part.DIRECTION if found["deg"] else Part.SENSE


def _with_unit(problem: str, symbol: str, names: Sequence[str], key: AnswerKey) -> Head:
    """v_E (m/s), ω_2/(rad·s⁻¹), v_E/mm: values in this unit; mm of what is no length is its length on paper.

    Raises UnknownNameError.
    """
    named = re.split(r"[/,(\[]", symbol, maxsplit=1)
    said = named[-1].strip(" /,()[]")
    if len(named) == 1 or unit(said) is None:
        keyed(symbol.strip(), names)  # raises, with the nearest
    name = keyed(named[0].strip(), names)
    one = key.find(name)
    part = Part.VALUE
    if one is not None and one.kind is Kind.VECTOR:
        part = {"mm": Part.LENGTH, "°": Part.DIRECTION, "deg": Part.DIRECTION, "度": Part.DIRECTION}.get(said, part)
    return Head(problem, name, part, said if part is Part.VALUE else "")
