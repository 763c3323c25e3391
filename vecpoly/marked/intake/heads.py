"""The head of a column: whose answer to what it holds."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from enum import StrEnum

from ...batch.columns import NAME, NUMBER, TEAM, is_one
from ...errors import UnknownNameError
from ...grading.key import AnswerKey
from ...grading.reading.characters import plain
from ...grading.reading.symbol import keyed

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
    """problem: as the key has it; symbol: of the key, or of a scale."""

    problem: str
    symbol: str
    part: Part


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
    return Head(problem, *_symbol(symbol.strip(), names))


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


def _symbol(symbol: str, names: Sequence[str]) -> tuple[str, Part]:
    """The symbol and the part; a symbol that ends like a part is itself where the key has it."""
    try:
        return keyed(symbol, names), Part.VALUE
    except UnknownNameError:
        found = _SUFFIX.match(symbol)
        if found is None:
            raise
        part = Part.LENGTH if found["mm"] else Part.DIRECTION if found["deg"] else Part.SENSE
        return keyed(found["symbol"], names), part
