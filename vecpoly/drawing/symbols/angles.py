"""Angles on paper: curved arrows of turning, arcs with arrowheads, small angles pointed at from outside."""

from __future__ import annotations

import cmath
import math
from collections.abc import Sequence

from ...board.paper.marks import TURN, AngleMark, RightAngle, TurnArrow
from ..scene import Fill, Item, Layer, Stroke
from ..style import SYMBOL, THIN, Hue
from . import shapes
from .shapes import NEAR

SQUARE = 2.5  # mm: side of a right-angle square
Arc = AngleMark | TurnArrow
HEAD, PART = 2.4, 0.36  # mm: arrowheads of an arc; but no longer than this part of it
STEEPEST = 0.32  # rad: of an arc that its head takes
BROAD = 3.2  # times as long as half as wide is such a head
SAME_RAY = 1e-3  # rad
NARROW, TAIL, INNER_HEAD = 4.0, 4.6, 2.0  # mm: a shorter arc is pointed at from outside, with tails and heads so long


def sweep_of(arc: Arc) -> float:
    """How far an arc goes on from where it begins, counter-clockwise (rad)."""
    return arc.sweep if isinstance(arc, AngleMark) else TURN if arc.ccw else -TURN


def curved_head(centre: complex, radius: float, end: float, turn: float, length: float) -> tuple[complex, ...]:
    """An arrowhead at the end of an arc, its tip first (turn: +1 counter-clockwise): a straight one, as on a vector,
    which lies on the chord of its part of the arc, and short beside the radius, so that it leans to no side of it."""
    tip = centre + cmath.rect(radius, end)
    foot = centre + cmath.rect(radius, end - turn * min(STEEPEST, length / radius))
    side = 1j * (tip - foot) / BROAD
    return (tip, foot + side, foot - side)


def draw_turn(mark: TurnArrow, hue: Hue) -> tuple[Item, ...]:
    """A curved arrow about a point."""
    if mark.radius < NEAR:
        return ()
    turn = 1.0 if mark.ccw else -1.0
    length = min(shapes.head_length(mark.radius * TURN), STEEPEST * mark.radius)
    bow = shapes.arc(mark.at, mark.radius, mark.start, turn * (TURN - 0.6 * length / mark.radius))
    tip = curved_head(mark.at, mark.radius, mark.start + turn * TURN, turn, length)
    return (Stroke(points=bow, width=SYMBOL, hue=hue, step=mark.step), Fill(points=tip, hue=hue, step=mark.step))


def draw_angle(mark: AngleMark, others: Sequence[AngleMark] = ()) -> tuple[Item, ...]:
    """The arc of an angle, with arrowheads where there is room for them, between others that end at its rays none if it
    is narrow; no slot or block hides it."""
    bow = Stroke(
        points=shapes.arc(mark.at, mark.radius, mark.start, mark.sweep), width=THIN, layer=Layer.OVER, step=mark.step
    )
    if narrow(mark):
        return (bow,) if adjoins(mark, others) else (bow, *_pointed_at(mark))
    if (long := mark.radius * abs(mark.sweep)) < NARROW:
        return (bow,)
    turn, head = math.copysign(1.0, mark.sweep), min(HEAD, PART * long)
    tips = (
        curved_head(mark.at, mark.radius, mark.start + mark.sweep, turn, head),
        curved_head(mark.at, mark.radius, mark.start, -turn, head),
    )
    return (bow, *(Fill(points=tip, layer=Layer.HEAD, step=mark.step) for tip in tips))


def adjoins(mark: AngleMark, others: Sequence[AngleMark]) -> bool:
    """Whether a narrow angle is one of several side by side, which have arcs alone."""
    return any(_adjoin(mark, one) for one in others)


def _adjoin(mark: AngleMark, other: AngleMark) -> bool:
    """Whether a narrow angle ends where another begins, so that arrowheads of both would lie on each other."""
    if mark is other or abs(mark.at - other.at) > NEAR or abs(mark.radius - other.radius) > TAIL or not narrow(other):
        return False
    rays = ((a, b) for a in (mark.start, mark.start + mark.sweep) for b in (other.start, other.start + other.sweep))
    return any(abs(cmath.phase(cmath.rect(1.0, a - b))) < SAME_RAY for a, b in rays)


def narrow(mark: AngleMark) -> bool:
    """Whether the angle is too small to hold its letter, and is pointed at from outside: a friction angle."""
    return mark.radius > TAIL and NEAR < mark.radius * abs(mark.sweep) < NARROW


def _pointed_at(mark: AngleMark) -> tuple[Item, ...]:
    """The arc carried on beyond both rays, with arrowheads that meet them."""
    tail = math.copysign(TAIL / mark.radius, mark.sweep)
    items: list[Item] = []
    for ray, out in ((mark.start, -tail), (mark.start + mark.sweep, tail)):
        turn = -math.copysign(1.0, out)
        items.append(
            Stroke(points=shapes.arc(mark.at, mark.radius, ray, out), width=THIN, layer=Layer.OVER, step=mark.step)
        )
        items.append(
            Fill(points=curved_head(mark.at, mark.radius, ray, turn, INNER_HEAD), layer=Layer.HEAD, step=mark.step)
        )
    return tuple(items)


def draw_square(mark: RightAngle) -> tuple[Item, ...]:
    """The square in a right angle."""
    u, v = SQUARE * mark.u / abs(mark.u), SQUARE * mark.v / abs(mark.v)
    corner = (mark.at + u, mark.at + u + v, mark.at + v)
    return (Stroke(points=corner, width=THIN, layer=Layer.THIN, step=mark.step),)
