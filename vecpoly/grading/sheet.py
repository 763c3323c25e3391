"""One student's answers to one problem, as they were written."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field

from ..board.construction import Scale
from ..board.place import views
from ..errors import FaultError
from ..figures import scales as kinds
from ..foundation.roman import CLASS
from ..units.names import plain, unit_of
from ..units.reading import PerMm, read
from ..words import Words
from .key import AnswerKey
from .reading.characters import plain as typed
from .reading.number import NUMBER, Number, number
from .reading.rank import rank
from .reading.symbol import keyed
from .reading.written import State, Written, written

__all__ = ["Scale", "Sheet", "sheet_of", "views"]


@dataclass(frozen=True, slots=True, kw_only=True)
class Sheet:
    """answers: key → what was written. scales: ``mu_v`` → the student's own (SI per mm); stated: which scales were
    written down.

    ticks: row of an equation → the signs in it. drawn: quantity → its vector on the student's own drawing (x + iy, in
    its unit). faults: what could not be read of the scales, each in words.
    """

    answers: Mapping[str, Written]
    scales: Mapping[str, float] = field(default_factory=dict)
    stated: frozenset[str] = frozenset()
    drawn: Mapping[str, complex] = field(default_factory=dict)
    ticks: Mapping[str, str] = field(default_factory=dict)
    faults: tuple[Words, ...] = ()


def sheet_of(key: AnswerKey, cells: Mapping[str, str | float | None], *, printed_scales: bool = True) -> Sheet:
    """A sheet of cells: symbol, or scale, → what was written there. Raises UnknownNameError for what is neither.

    printed_scales: the sheet prints the scales of the key, so that they count as stated.
    """
    names, rows = {one.key for one in key.quantities}, {row.key for row in key.equations}
    answers: dict[str, Written] = {}
    own: dict[str, float] = {}
    faults: list[Words] = []
    marks: dict[str, str] = {}
    for symbol, cell in cells.items():
        mu = _scale_named(symbol, key)
        if mu is None:
            meant = symbol if symbol in names else keyed(symbol, names | rows)
            if meant in rows:
                marks[meant] = "" if cell is None else str(cell)
            else:
                answers[meant] = rank(cell) if meant.startswith(CLASS) else written(cell)
        elif (value := _scale(mu, cell, faults)) is not None:
            own[mu] = value
    _asked_by_symbol(key, answers)
    stated = frozenset(key.scales) if printed_scales else frozenset(own)
    return Sheet(answers=answers, scales=own, stated=stated, ticks=marks, faults=tuple(faults))


def _asked_by_symbol(key: AnswerKey, answers: dict[str, Written]) -> None:
    """What stands under the printed symbol of what is asked, l_AB, answers that (AB) and no step of the same symbol."""
    for one in key.quantities:
        if one.asked and (one.key not in answers or answers[one.key].state is State.BLANK):
            for step in [name for name in one.needs if name in answers and key[name].symbol == one.symbol]:
                answers[one.key] = answers.pop(step)


def _scale_named(symbol: str, key: AnswerKey) -> str | None:
    """The scale that a column is about: mu_v, μ_v, μv."""
    name = symbol.strip().replace("μ", "mu").replace("_", "").lower()
    return next((mu for mu in key.scales if mu.replace("_", "").lower() == name), None)


def _scale(mu: str, cell: str | float | None, faults: list[Words]) -> float | None:
    """A scale in SI per mm; a bare number is taken in the unit of its kind per mm."""
    text = "" if cell is None else str(cell).strip()
    if not text:
        return None
    try:
        value = scale_read(mu, text)
    except FaultError as fault:
        faults.append(Words.same(f"{mu.replace('mu', 'μ')} = {text}: ") + fault.words)
        return None
    if value <= 0:
        said = Words("比例尺应大于零；请改正", "a scale must be above zero; correct it")
        faults.append(Words.same(f"{mu.replace('mu', 'μ')} = {text}: ") + said)
        return None
    return value


def scale_read(mu: str, text: str) -> float:
    """What a scale says, in the unit of its kind per mm; a bare number is one of these. Raises FaultError."""
    kind = kinds()[mu]
    unit = f"({kind.unit})/mm" if "/" in kind.unit else f"{kind.unit}/mm"
    digits, behind = _numbered(text)
    value = read(f"{digits} {behind or unit}".strip(), PerMm(kind.called, kind.unit, kind.example)).si
    return value / unit_of(plain(kind.unit))[0]


def _numbered(text: str) -> tuple[str, str]:
    """A scale as its number, with a decimal point, and what stands behind: all of it where it begins otherwise."""
    found = NUMBER.match(text := typed(text))
    value = number(found) if found is not None else None
    if found is None or not isinstance(value, Number):
        return "", text
    return f"{value.value:.12g}", text[found.end() :].strip()
