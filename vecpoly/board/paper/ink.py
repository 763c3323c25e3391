"""What acts leave on the paper: marks follow from them, and from nothing else."""

from __future__ import annotations

from collections.abc import Iterable
from typing import TypeGuard, assert_never, get_args

from ...foundation.slotted import replace
from .. import acts as done
from ..acts import Act, Leaving
from ..place import Place, called
from .marks import (
    AngleMark,
    Arc,
    Curve,
    Dot,
    Hatched,
    ImageOf,
    Mark,
    Note,
    Point,
    RightAngle,
    Role,
    Segment,
    TurnArrow,
    Vector,
)
from .smooth import smooth

_LEAVING = frozenset(get_args(Leaving))


def marks(acts: Iterable[Act]) -> dict[Place, tuple[Mark, ...]]:
    """The marks of every figure, in the order in which they were drawn."""
    found: dict[Place, list[Mark]] = {}
    for act in acts:
        if act.head.place is not None:
            found.setdefault(act.head.place, []).extend(marks_of(act))
    return {place: tuple(left) for place, left in found.items() if left}


def marks_of(act: Act) -> tuple[Mark, ...]:
    """The marks of one act: each knows the act, its step, its owner and, where it stands for a quantity, its key.

    What belongs to no link and no joint is its figure's own: the polygon's.
    """
    if not leaves_ink(act):
        return ()
    h = act.head
    owner = h.owner or (called(h.place) if h.place is not None else "")
    return tuple(
        replace(mark, step=mark.step or h.step, act=h.number, key=mark.key or h.key, owner=mark.owner or owner)
        for mark in _left(act)
    )


def ends_of(act: done.Arrow | done.Depict) -> list[tuple[complex, complex]]:
    """Tail and head of the vectors that an act leaves."""
    return [(mark.a, mark.b) for mark in _left(act) if isinstance(mark, Vector)]


def leaves_ink(act: Act) -> TypeGuard[Leaving]:
    """Whether it may leave marks."""
    return type(act) in _LEAVING


def _left(act: Leaving) -> tuple[Mark, ...]:
    """The bare marks."""
    match act:
        case done.Plot():
            return (Point(at=act.at, label=act.label, dot=act.dot),)
        case done.Join():
            return (Segment(a=act.a, b=act.b, role=act.role),)
        case done.Arrow():
            return (Vector(a=act.a, b=act.b, role=act.role, label=act.label),) if act.shown else ()
        case done.Rule():
            line = Segment(a=act.a, b=act.b, role=Role.DIRECTION)
            end = Point(at=act.b, label=act.label, dot=Dot.NONE, said=act.said)
            return (line, end) if act.label or act.said else (line,)
        case done.Swing():
            return (Arc(centre=act.centre, radius=act.radius, start=act.start, sweep=act.sweep, role=act.role),)
        case done.Curve():
            return (Curve(points=smooth(act.points), role=act.role),)
        case done.Corner():
            return (RightAngle(at=act.at, u=act.u, v=act.v),)
        case done.Tint():
            return (ImageOf(points=act.points),)
        case done.Hatch():
            return (Hatched(points=act.points, rising=act.rising),)
        case done.Angle():
            return (AngleMark(at=act.at, radius=act.radius, start=act.start, sweep=act.sweep, label=act.label),)
        case done.CurvedArrow():
            return (TurnArrow(at=act.at, radius=act.radius, start=act.start, ccw=act.ccw, label=act.label),)
        case done.Annotate():
            return (Note(at=act.at, words=act.words, side=act.side),)
        case done.Depict():
            return act.marks
        case _:
            assert_never(act)
