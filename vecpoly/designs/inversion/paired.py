"""What belongs to the input in each pair, as numbers of which a range may be told."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from functools import partial

from ...words import Words
from ..base import Design
from ..ranged.datum import Datum, put
from .written import Pair


def of_pairs(design: Design, pairs: Sequence[Pair]) -> Iterator[Datum[Design]]:
    """The angle of the output link, or the place of the slider, of each pair, that of the last first; then the angles
    of the input link."""
    rows = [*enumerate(pairs, 1)][::-1]
    for n, pair in rows:
        zh, en = ("位移", "place") if pair.slides else ("从动件转角", "output angle")
        name = Words(f"第 {n} 组的{zh}", f"the {en} of pair {n}")
        unit, put_two = "mm" if pair.slides else "deg", partial(_ending, design, pairs, n)
        yield Datum(name=name, unit=unit, value=pair.two, signed=pair.slides, put=put_two)
    for n, pair in rows:
        name = Words(f"第 {n} 组的主动件转角", f"the input angle of pair {n}")
        yield Datum(name=name, unit="deg", value=pair.one, put=partial(_starting, design, pairs, n))


def _ending(design: Design, pairs: Sequence[Pair], n: int, two: float) -> Design:
    return _with(design, pairs, n, replace(pairs[n - 1], two=two))


def _starting(design: Design, pairs: Sequence[Pair], n: int, one: float) -> Design:
    return _with(design, pairs, n, replace(pairs[n - 1], one=one))


def _with(design: Design, pairs: Sequence[Pair], n: int, other: Pair) -> Design:
    return put(design, {"pairs": (*pairs[: n - 1], other, *pairs[n:])})
