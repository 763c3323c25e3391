"""Points of lines by a drawing that was handed in: what each vector is worth, what it earns, and why."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from typing import Any, assert_never

from ...foundation.slotted import replace
from ...words import Words
from ..drawings.judging.askew import leaning
from ..drawings.judging.mark import NO_WORDS, Basis, DrawingMark, FigureMark, VectorMark, Verdict
from ..drawings.judging.reason import FAIR
from ..key import AnswerKey, Graded, Kind
from ..rules import Rules
from ..told.slip import told_of

NOTHING_DRAWN = Words("没有交图", "no drawing was handed in")
UNDECLARED = Words(
    "没有写比例尺：或是另取了比例尺，或是已知矢量画错；请核对",
    "its scale is not stated: another scale, or a known vector that is wrong; check it",
)


@dataclass(frozen=True, slots=True, kw_only=True)
class LineMark:
    """The line of one quantity. figure: its title; doubt: why a person must look at it; costs: whether it is a mistake
    of its own."""

    key: str
    symbol: str
    figure: Words
    verdict: Verdict
    worth: float
    earned: float
    reason: Words
    costs: bool
    doubt: Words | None = None

    def as_json(self) -> dict[str, Any]:
        """Plain data."""
        return {
            "key": self.key, "figure": self.figure.en, "verdict": self.verdict.value, "worth": self.worth,
            "points": self.earned, "zh": self.reason.zh, "en": self.reason.en, "for_a_person": self.doubt is not None,
        }  # fmt: skip


def paid_by_lines(key: AnswerKey, drawing: DrawingMark | None, rules: Rules) -> tuple[AnswerKey, tuple[LineMark, ...]]:
    """The key without the method points of vectors that are paid by the drawing, and what the drawing earns of them.

    Only figures that are drawn pay, unless the rules want a drawing; other lines are paid by their numbers.
    """
    if rules.drawing == "told" or (drawing is None and rules.drawing != "required"):
        return key, ()
    there = dict(_there(drawing, rules)) if drawing is not None else {}
    lines: list[LineMark] = []
    for one in key.quantities:
        if _has_line(one) and (one.key in there or rules.drawing == "required"):
            lines.append(_line(one, there.get(one.key), drawing, rules))
    if drawing is not None:
        lines = _once_for_each(lines, drawing, rules)
    paid = {one.key for one in lines}
    quantities = tuple(_unpaid(one) if one.key in paid else one for one in key.quantities)
    return replace(key, quantities=quantities), tuple(lines)


def _once_for_each(lines: list[LineMark], drawing: DrawingMark, rules: Rules) -> list[LineMark]:
    """A polygon that lies askew as a whole costs the directions of one vector: of the first that is asked for, where
    that by which it is told is not."""
    for figure in (one for one in drawing.figures if one.turned or one.mirrored):
        here = [n for n, one in enumerate(lines) if one.figure == figure.title and one.verdict is Verdict.WRONG]
        if here and not any(lines[n].costs for n in here):
            first = lines[here[0]]
            by = next(one.turned for one in figure.vectors if first.key in one.keys)
            earned = min(first.earned, first.worth * rules.turned)
            lines[here[0]] = replace(first, earned=earned, reason=leaning(by), costs=True)
    return lines


def drawn_by(key: AnswerKey, drawing: DrawingMark | None) -> Mapping[str, complex]:
    """Quantity → the vector as it was drawn, in its own unit: what a number may have been read off."""
    if drawing is None:
        return {}
    scales = {one.key: key.scales[one.mu] for one in key.quantities if one.mu in key.scales and _is_vector(one)}
    own = {name: mark.own for mark in drawing.vectors if mark.own is not None for name in mark.keys}
    return {name: along * scales[name] for name, along in own.items() if name in scales}


def with_lengths(key: AnswerKey, drawn: Mapping[str, complex]) -> Mapping[str, complex]:
    """With the lengths from which these vectors are read off, under their own letters."""
    lengths = {one.line: drawn[one.key] for one in key.quantities if one.line and one.key in drawn}
    return {**drawn, **lengths}


def _there(drawing: DrawingMark, rules: Rules) -> Iterator[tuple[str, tuple[FigureMark, VectorMark]]]:
    """Quantity → its figure and vector, of the figures that are drawn or have to be."""
    for figure in drawing.figures:
        for mark in figure.vectors if figure.drawn or rules.drawing == "required" else ():
            yield from ((name, (figure, mark)) for name in mark.keys)


def _has_line(one: Graded) -> bool:
    return _is_vector(one) and one.points.method > 0


def _is_vector(one: Graded) -> bool:
    return one.kind is Kind.VECTOR and bool(one.mm)


def _unpaid(one: Graded) -> Graded:
    return replace(one, points=replace(one.points, method=0.0))


def _line(
    one: Graded, found: tuple[FigureMark, VectorMark] | None, drawing: DrawingMark | None, rules: Rules
) -> LineMark:
    if found is None or drawing is None:
        return LineMark(
            key=one.key, symbol=one.symbol, figure=Words.same(""), verdict=Verdict.MISSING, worth=one.points.method,
            earned=0.0, reason=NOTHING_DRAWN, costs=True,
        )  # fmt: skip
    figure, mark = found
    doubt = drawing.doubt or figure.doubt or (None if figure.declared else UNDECLARED)
    why = Words("；", "; ") + told_of(drawing.slip).words if mark.costs and drawing.slip is not None else NO_WORDS
    return LineMark(
        key=one.key, symbol=one.symbol, figure=figure.title, verdict=mark.verdict, worth=one.points.method,
        earned=one.points.method * _share(mark, drawing, rules), reason=mark.reason + why, costs=mark.costs,
        doubt=doubt,
    )  # fmt: skip


def _share(mark: VectorMark, drawing: DrawingMark, rules: Rules) -> float:
    """Of the method points: all of a line that is right, or follows; some of one whose sense or direction alone is
    wrong, or whose mistake is named."""
    if drawing.mirrored:
        return rules.turned
    match mark.basis:
        case Basis.SLIP:
            return 1.0
        case Basis.EXACT | Basis.OWN:
            if mark.verdict in FAIR:
                whole = rules.own if mark.basis is Basis.OWN else 1.0
                return whole if mark.sense is not None else min(whole, rules.turned)
            turned = mark.length in FAIR and (mark.direction in FAIR) is not (mark.sense is not False)
            return max(rules.turned if turned else 0.0, rules.slip if drawing.slip is not None else 0.0)
        case _:
            assert_never(mark.basis)
