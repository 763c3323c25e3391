"""What acts leave on the paper: marks follow from them, and from nothing else."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace
from typing import assert_never

from . import acts as done
from .acts import Act
from .marks import Arc, ImageOf, Mark, Point, RightAngle, Role, Segment, Vector
from .place import Place


def marks(acts: Iterable[Act]) -> dict[Place, tuple[Mark, ...]]:
    """The marks of every figure, in the order in which they were drawn."""
    found: dict[Place, list[Mark]] = {}
    for act in acts:
        if act.head.place is not None:
            found.setdefault(act.head.place, []).extend(marks_of(act))
    return {place: tuple(left) for place, left in found.items() if left}


def marks_of(act: Act) -> tuple[Mark, ...]:
    """The marks of one act: each knows the act, its step, its owner and, where it stands for a quantity, its key."""
    head = act.head
    return tuple(replace(mark, step=mark.step or head.step, act=head.number, key=mark.key or head.key, owner=mark.owner or head.owner)
                 for mark in _ink(act))


def _ink(act: Act) -> tuple[Mark, ...]:
    match act:
        case done.Plot():
            return (Point(at=act.at, label=act.label, dot=act.dot),)
        case done.Join():
            return (Segment(a=act.a, b=act.b, role=act.role),)
        case done.Arrow():
            return (Vector(a=act.a, b=act.b, role=act.role, label=act.label),) if act.shown else ()
        case done.Rule():
            return _ruled(act)
        case done.Swing():
            return (Arc(centre=act.centre, radius=act.radius, start=act.start, sweep=act.sweep, role=Role.CONSTRUCTION),)
        case done.Corner():
            return (RightAngle(at=act.at, u=act.u, v=act.v),)
        case done.Tint():
            return (ImageOf(points=act.points),)
        case done.Depict():
            return act.marks
        case (done.Locate() | done.Turn() | done.Parallel() | done.LayOff() | done.Follow() | done.Transfer() | done.Meet() | done.Touch() | done.Image()
              | done.Measure() | done.Gauge() | done.Compute() | done.Answer()):
            return ()
        case _:
            assert_never(act)


def _ruled(act: done.Rule) -> tuple[Mark, ...]:
    from .marks import Dot

    line = Segment(a=act.a, b=act.b, role=Role.DIRECTION)
    return (line, Point(at=act.b, label=act.label, dot=Dot.NONE)) if act.label else (line,)
