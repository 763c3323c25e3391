"""What a crowded figure need not say: names of directions that the row of the equation tells anyhow, values of angles
that stand in the steps."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from ..board.construction import Figure
from ..foundation.slotted import replace
from ..typeset import Glyphs
from .labels.placing import BAD, Placed
from .labels.want import Thing, Want

ABOUT, MANY = 12.0, 4  # mm about a label in which no more stand than so many, itself included
FAR = 8.0  # mm from its line to a name on a leader, beyond which it no longer stands at it
LED = 2  # labels for which one on a leader counts
SERIES = 6  # numbers of points at least, of which some may be left out
MEET = 2.5  # mm between the feet of direction lines that meet in one point


def relieved(figure: Figure, placed: Sequence[Placed]) -> tuple[Want, ...]:
    """What is lettered, without the names of directions that crowd a polygon and numbers of a series that find no
    place, and with the symbols alone of angles whose values would stand far off, or in a crowd, on a leader."""
    idle = spared(figure, placed) | _numbers_astray(placed)
    return tuple(_brief(one, placed) for one in placed if one.want not in idle)


def _numbers_astray(placed: Sequence[Placed]) -> frozenset[Want]:
    """The numbers of points along a curve that find no place beside their points in a crowd: their neighbours tell."""
    numbers = [one for one in placed if one.want.thing is Thing.POINT and _is_number(one.want)]
    led = [one for one in numbers if one.foot is not None and _stands_in_crowd(one, placed)]
    return frozenset(one.want for one in led) if len(numbers) >= SERIES else frozenset()


def _is_number(want: Want) -> bool:
    return all(isinstance(one, Glyphs) and one.text.isdigit() for piece in want.pieces for one in piece.box.items)


def _brief(label: Placed, placed: Sequence[Placed]) -> Want:
    if not label.want.brief or label.foot is None or not (_is_far(label) or _stands_in_crowd(label, placed)):
        return label.want
    return replace(label.want, pieces=label.want.brief, brief=())


def spared(figure: Figure, placed: Sequence[Placed]) -> frozenset[Want]:
    """The names of directions of a polygon that stand on something, far off, or in a crowd; with each that of the line
    which it meets, for a point found by two lines tells of both, or of none."""
    if not figure.view.is_polygon:
        return frozenset()
    directions = [one for one in placed if one.want.thing is Thing.DIRECTION]
    crowding = [one for one in directions if one.cost > BAD or _is_far(one) or _stands_in_crowd(one, placed)]
    return frozenset(one.want for one in directions if any(_meet(one, other) for other in crowding))


def _is_far(label: Placed) -> bool:
    """Whether it stands far off on a leader."""
    if label.foot is None:
        return False
    half, off = complex(label.want.width, label.want.height) / 2, label.centre - label.foot
    return abs(complex(max(abs(off.real) - half.real, 0.0), max(abs(off.imag) - half.imag, 0.0))) > FAR


def _stands_in_crowd(label: Placed, placed: Sequence[Placed]) -> bool:
    return sum(_counts(placed, label)) > MANY


def _counts(placed: Sequence[Placed], label: Placed) -> Iterator[int]:
    """What each label near to this one counts."""
    return (LED if one.foot is not None else 1 for one in placed if abs(one.centre - label.centre) <= ABOUT)


def _meet(one: Placed, other: Placed) -> bool:
    return abs(one.want.own[0] - other.want.own[0]) <= MEET
