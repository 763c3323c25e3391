"""Ink that stays behind: drawn at numbers that no longer know where they came from, while its place has moved."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import assert_never

from ..board import acts as done
from ..board.paper.marks import AngleMark, FixedGuide
from ..plane.derived import moves

STILL = 1e-6  # mm: what moves less stands still


def stale(recorded: Sequence[done.Act], anew: Sequence[done.Act]) -> Iterator[int]:
    """The acts whose ink stands still though it is elsewhere when drawn anew; none where other acts were done."""
    if [type(act) for act in recorded] != [type(act) for act in anew]:
        return
    for act, other in zip(recorded, anew, strict=True):
        if isinstance(act, done.Depict) and isinstance(other, done.Depict):
            if not act.head.owner.startswith("link") and _standing(act) != _standing(other):
                yield act.number
        elif any(not moves(a) and abs(a - b) > STILL for a, b in zip(_places(act), _places(other), strict=False)):
            yield act.number


def _standing(act: done.Depict) -> tuple[object, ...]:
    return tuple(repr(mark) for mark in act.marks if not isinstance(mark, AngleMark | FixedGuide))


def _places(act: done.Act) -> tuple[complex, ...]:
    """The places at which an act leaves ink."""
    if isinstance(act, done.Inkless):
        return ()
    match act:
        case done.Plot(at=at) | done.CurvedArrow(at=at) | done.Annotate(at=at):
            return (at,)
        case done.Angle(at=at):
            return (at,)  # its arc follows the links by rules of its own
        case done.Join(a=a, b=b) | done.Arrow(a=a, b=b) | done.Rule(a=a, b=b):
            return (a, b)
        case done.Swing(centre=centre, radius=radius):
            return (centre, radius)
        case done.Corner(at=at, u=u, v=v):
            return (at, u, v)
        case done.Tint(points=points) | done.Curve(points=points) | done.Hatch(points=points):
            return points
        case done.Depict():
            return ()  # a symbol is carried along by its owner
        case _:
            assert_never(act)
