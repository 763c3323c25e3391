"""What a crowded figure need not say: names of directions that the row of the equation tells anyhow, values of angles
that stand in the steps."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping

from ..typeset.box import Glyphs
from .labels.want import Thing
from .weighing.placed import BAD, Placed

ABOUT, MANY = 12.0, 4  # mm about a label in which no more stand than so many, itself included
FAR = 8.0  # mm from its line to a name on a leader, beyond which it no longer stands at it
LED = 2  # labels for which one on a leader counts
FEW = 9  # labels of a figure that is drawn for the sake of its angles: their values stay, wherever they stand
SERIES = 6  # numbers of points at least, of which some may be left out
MEET = 2.5  # mm between the feet of direction lines that meet in one point


def relieved(placed: Mapping[int, Placed], *, polygon: bool, farther: bool) -> tuple[frozenset[int], frozenset[int]]:
    """Which labels are left out: names of directions that crowd a polygon, and numbers of a series that find no place
    farther off either; and which say less: angles whose values would stand far off, or in a crowd, on a leader, save
    where a like one keeps its value: γ′ = 48.6° asks for that of γ″."""
    left_out = _spared(placed) if polygon else frozenset[int]()
    left_out |= _numbers_astray(placed) if farther else frozenset[int]()
    if len(placed) <= FEW:
        return left_out, frozenset()
    brief = frozenset(i for i, one in placed.items() if i not in left_out and _tells_too_much(one, placed.values()))
    told = {_letter(one) for i, one in placed.items() if one.want.brief and i not in brief}
    return left_out, frozenset(i for i in brief if _letter(placed[i]) not in told)


def _letter(label: Placed) -> str:
    """The letter of an angle, without primes and indices."""
    return next((item.text[:1] for item in label.want.brief[0].box.items if isinstance(item, Glyphs)), "")


def _numbers_astray(placed: Mapping[int, Placed]) -> frozenset[int]:
    """The numbers of points along a curve that find no place beside their points in a crowd: their neighbours tell."""
    numbers = {i: one for i, one in placed.items() if one.want.thing is Thing.POINT and one.want.is_number}
    if len(numbers) < SERIES:
        return frozenset()
    return frozenset(i for i, one in numbers.items() if one.foot is not None and _stands_in_crowd(one, placed.values()))


def _tells_too_much(label: Placed, placed: Collection[Placed]) -> bool:
    return bool(label.want.brief) and label.foot is not None and (_is_far(label) or _stands_in_crowd(label, placed))


def _spared(placed: Mapping[int, Placed]) -> frozenset[int]:
    """The names of directions of a polygon that stand on something, or in a crowd; with each that of the line which it
    meets, for a point found by two lines tells of both, or of none. One on a long leader stays: it is in nobody's
    way."""
    names = {i: one for i, one in placed.items() if one.want.thing is Thing.DIRECTION}
    crowding = [one for one in names.values() if one.cost > BAD or _stands_in_crowd(one, placed.values())]
    return frozenset(i for i, one in names.items() if any(_meet(one, other) for other in crowding))


def _is_far(label: Placed) -> bool:
    """Whether it stands far off on a leader."""
    if label.foot is None:
        return False
    half, off = complex(label.want.width, label.want.height) / 2, label.centre - label.foot
    return abs(complex(max(abs(off.real) - half.real, 0.0), max(abs(off.imag) - half.imag, 0.0))) > FAR


def _stands_in_crowd(label: Placed, placed: Collection[Placed]) -> bool:
    return sum(_counts(placed, label)) > MANY


def _counts(placed: Collection[Placed], label: Placed) -> Iterator[int]:
    """What each label near to this one counts."""
    return (LED if one.foot is not None else 1 for one in placed if abs(one.centre - label.centre) <= ABOUT)


def _meet(one: Placed, other: Placed) -> bool:
    return abs(one.want.own[0] - other.want.own[0]) <= MEET
