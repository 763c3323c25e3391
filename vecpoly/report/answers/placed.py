"""Drawn beside exact places: both coordinates, how far they are apart, and within what a point is found."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from math import hypot

from ...algebra.rounding import read_back
from ...printed.digits import coordinates
from ...printed.places import place_parts
from ...solution import Answer, Solution
from ...words import Lang, Words
from ..flow.table import DataTable
from ..tables import trimmed
from ..values import rough
from .errors import NOTHING, alike

PLACES = (
    Words("点", "Point"),
    Words("量得 $x$ /mm", "Drawn $x$ /mm"),
    Words.same("$y$ /mm"),
    Words("精确 $x$ /mm", "Exact $x$ /mm"),
    Words.same("$y$ /mm"),
    Words("距离 /mm", "Distance /mm"),
    Words("预期误差 /mm", "Expected error /mm"),
)
ALIGN_PLACES = "ldddddd"
_APART = 1e-9  # m: places that all hands find alike, a fixed pivot


def angle(turn: float) -> str:
    """An angle to a tenth of a degree: −76.1°."""
    return f"{turn:.1f}°".replace("-", "−")


def clean(answer: Answer) -> float:
    """The exact value; zero where only rounding noise is left."""
    return 0.0 if abs(answer.exact) < 1e-9 * max(1.0, abs(answer.expected_error)) else answer.exact


def endless(answer: Answer) -> bool:
    """Whether it is a place at infinity, on paper and exactly."""
    return answer.is_place and answer.drawn_vector is None and answer.exact_vector is None and not answer.undefined


def places_table(answers: list[Answer], solution: Solution, lang: Lang) -> DataTable:
    """The table of the places."""
    ends = zip(gaps(answers), reaches(answers), strict=True)
    rows = [(*place_row(one), *end) for one, end in zip(answers, ends, strict=True)]
    return trimmed([head.of(lang) for head in PLACES], rows, (), ALIGN_PLACES, lang)


def place_row(answer: Answer) -> tuple[str, ...]:
    """A point (m): both coordinates as drawn and exact."""
    drawn, exact = answer.drawn_vector, answer.exact_vector
    assert drawn is not None and exact is not None
    places = coordinates(answer)
    return (f"${answer.reading.symbol}$", *place_parts(drawn, places), *place_parts(exact, places + 1))


def endless_words(answers: Iterable[Answer], lang: Lang) -> str:
    """Where the places at infinity lie, drawn and exactly, in a sentence; nothing where there is none, or all lie
    exactly where the box of answers tells."""
    told = [
        Words(
            f"${one.reading.symbol}$ 为 {angle(one.drawn)}（精确值 {angle(clean(one))}{_within(one).zh}）",
            f"${one.reading.symbol}$ at {angle(one.drawn)} (exactly {angle(clean(one))}{_within(one).en})",
        ).of(lang)
        for one in answers
        if endless(one) and angle(one.drawn) != angle(clean(one))
    ]
    if not told:
        return ""
    zh, en = "，".join(told), ", ".join(told)
    return Words(f"在无穷远处的瞬心，其方向{zh}。", f"The centres at infinity lie in these directions: {en}.").of(lang)


def _within(answer: Answer) -> Words:
    error = rough(answer.expected_error)
    return Words(f"，预期误差 {error}°", f", expected error {error}°") if answer.expected_error else Words("", "")


def place_words(answer: Answer, lang: Lang) -> str:
    """The same of a point that is the only one, as a sentence."""
    symbol, x, y, true_x, true_y = place_row(answer)
    (gap,), (reach,) = gaps([answer]), reaches([answer])
    error = Words("", "") if reach == NOTHING else Words(f"（预期误差 {reach} mm）", f" (expected error {reach} mm)")
    said = Words(
        f"点 {symbol} 量得 ({x}, {y}) mm，精确为 ({true_x}, {true_y}) mm，相距 {gap} mm",
        f"Point {symbol} was drawn at ({x}, {y}) mm; exactly it is at ({true_x}, {true_y}) mm, {gap} mm away",
    )
    return (said + error + Words("。", ".")).of(lang)


def gaps(answers: Iterable[Answer]) -> Iterator[str]:
    """How far apart (mm) the drawn and the exact point are, as they stand beside each other: to a hundredth, for the
    coordinates have no more."""
    yield from (NOTHING if off is None else f"{off:.2f}" for off in map(_gap, answers))


def _gap(answer: Answer) -> float | None:
    """As printed (mm); nothing where there is no place on paper, or none at all."""
    drawn, exact = answer.drawn_vector, answer.exact_vector
    if endless(answer) or drawn is None or exact is None:
        return None
    places = coordinates(answer)
    told = (*place_parts(drawn, places), *place_parts(exact, places + 1))
    x, y, true_x, true_y = (read_back(text)[0] for text in told)
    return hypot(x - true_x, y - true_y)


def reaches(answers: Sequence[Answer]) -> Iterator[str]:
    """Within which distance (mm) a point is found."""
    told = iter(alike([1e3 * one.expected_error for one in answers if one.expected_error > _APART]))
    yield from (next(told) if one.expected_error > _APART else NOTHING for one in answers)
