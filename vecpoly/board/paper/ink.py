"""What acts leave on the paper: marks follow from them, and from nothing else."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace
from typing import assert_never

from .. import acts as done
from ..acts import Act, Head
from ..place import Place
from .marks import Arc, Dot, ImageOf, Mark, Point, RightAngle, Role, Segment, Vector


def marks(acts: Iterable[Act]) -> dict[Place, tuple[Mark, ...]]:
    """The marks of every figure, in the order in which they were drawn."""
    found: dict[Place, list[Mark]] = {}
    for act in acts:
        if act.head.place is not None:
            found.setdefault(act.head.place, []).extend(marks_of(act))
    return {place: tuple(left) for place, left in found.items() if left}


def marks_of(act: Act) -> tuple[Mark, ...]:
    """The marks of one act: each knows the act, its step, its owner and, where it stands for a quantity, its key."""
    h = act.head
    match act:
        case done.Plot():
            return (
                Point(at=act.at, label=act.label, dot=act.dot, step=h.step, act=h.number, key=h.key, owner=h.owner),
            )
        case done.Join():
            return (Segment(a=act.a, b=act.b, role=act.role, step=h.step, act=h.number, key=h.key, owner=h.owner),)
        case done.Arrow():
            return (
                (
                    Vector(
                        a=act.a,
                        b=act.b,
                        role=act.role,
                        label=act.label,
                        step=h.step,
                        act=h.number,
                        key=h.key,
                        owner=h.owner,
                    ),
                )
                if act.shown
                else ()
            )
        case done.Rule():
            return _ruled(act, h)
        case done.Swing():
            return (
                Arc(
                    centre=act.centre,
                    radius=act.radius,
                    start=act.start,
                    sweep=act.sweep,
                    role=Role.CONSTRUCTION,
                    step=h.step,
                    act=h.number,
                    key=h.key,
                    owner=h.owner,
                ),
            )
        case done.Corner():
            return (RightAngle(at=act.at, u=act.u, v=act.v, step=h.step, act=h.number, key=h.key, owner=h.owner),)
        case done.Tint():
            return (ImageOf(points=act.points, step=h.step, act=h.number, key=h.key, owner=h.owner),)
        case done.Depict():
            return tuple(
                replace(
                    mark, step=mark.step or h.step, act=h.number, key=mark.key or h.key, owner=mark.owner or h.owner
                )
                for mark in act.marks
            )
        case (
            done.Locate()
            | done.Turn()
            | done.Parallel()
            | done.LayOff()
            | done.Follow()
            | done.Transfer()
            | done.Meet()
            | done.Touch()
            | done.Image()
            | done.Measure()
            | done.Gauge()
            | done.Compute()
            | done.Answer()
        ):
            return ()
        case _:
            assert_never(act)


def _ruled(act: done.Rule, h: Head) -> tuple[Mark, ...]:
    line = Segment(a=act.a, b=act.b, role=Role.DIRECTION, step=h.step, act=h.number, key=h.key, owner=h.owner)
    if not act.label:
        return (line,)
    return line, Point(at=act.b, label=act.label, dot=Dot.NONE, step=h.step, act=h.number, key=h.key, owner=h.owner)
