"""What is to be lettered in a figure, and all the places where each letter could stand."""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterable
from dataclasses import dataclass, replace
from enum import Enum

import numpy as np

from ..board.construction import View
from ..board.marks import (
    AngleMark,
    Block,
    Dot,
    FrictionCircle,
    Ground,
    LinkNumber,
    Mark,
    Note,
    Point,
    TurnArrow,
    Vector,
)
from ..formula import Txt, row
from ..typeset import Box, layout
from ..words import Lang
from .notes import lines
from .obstacles import Complexes, Floats
from .style import DOT_RADIUS, JOINT_RADIUS, LETTER, LINK, NOTE, POLE_RADIUS, RESULT, THIN, Hue, kind_hue
from .symbols import NEAR, TAIL, TURN, narrow

DIRECTIONS = np.exp(2j * np.pi * np.arange(24) / 24)
GAPS = (0.55, 1.1, 1.9, 3.0, 4.4)
FAR = (6.5, 9.5, 13.0, 18.0)
FRACTIONS = (0.5, 0.42, 0.58, 0.34, 0.66, 0.26, 0.74, 0.18, 0.82)
LEADER = 22.0  # what resorting to a leader line costs
PER_DISTANCE, PER_FRACTION = 1.2, 6.0
ROOMY = 7.0  # mm: a friction circle smaller than this does not hold the letter of its pin


@dataclass(frozen=True, slots=True)
class Piece:
    """Type that belongs to one step, at an offset from the left of its label."""

    box: Box
    dx: float
    hue: Hue
    step: int


class Thing(Enum):
    """What a label can be taken to name when it stands beside it."""

    OTHER, POINT, LINK, VECTOR = range(4)


@dataclass(frozen=True, slots=True)
class Want:
    """A label to be placed beside points of a curve: each with a normal (0: all directions) and a radius to keep."""

    pieces: tuple[Piece, ...]
    feet: tuple[complex, ...]
    normals: tuple[complex, ...]  # unit vectors to one side; 0j where every direction will do
    radius: float
    own: tuple[complex, complex]
    one_sided: bool = False
    scale: float = 1.0
    thing: Thing = Thing.OTHER

    @property
    def width(self) -> float:
        """Of the whole label, mm."""
        return max(p.dx + p.box.width for p in self.pieces)

    @property
    def ascent(self) -> float:
        """Over the baseline, mm."""
        return max(p.box.ascent for p in self.pieces)

    @property
    def height(self) -> float:
        """Of the whole label, mm."""
        return self.ascent + max(p.box.descent for p in self.pieces)


@dataclass(frozen=True, slots=True)
class Spots:
    """Places for the middle of a label: what each costs, and the foot of its leader line (nan: none)."""

    centre: Complexes
    cost: Floats
    foot: Complexes


def spots(want: Want, middle: complex) -> Spots:
    """All the places to be tried for a label; `middle`: of the figure, from which letters tend away."""
    half, all_round = complex(want.width / 2, want.height / 2), want.normals[0] == 0
    feet, number = np.array(want.feet)[:, None], np.arange(len(want.feet))[:, None] / len(want.feet)
    normals = np.array(want.normals)[:, None]
    sides = DIRECTIONS[None] if all_round else normals if want.one_sided else np.hstack([normals, -normals])
    away, reach = feet - middle, np.abs(feet - middle)
    away = np.where(reach > 1, away / np.maximum(reach, 1.0), 0j)
    base = PER_FRACTION * number + 1.0 * (1 - (sides * away.conjugate()).real)
    gap, far = np.array(GAPS)[:, None], np.array(FAR)[:, None]
    near = feet[..., None] + _offset(sides[:, None], want.radius + gap, half, all_round)
    led = want.feet[0] + _offset(DIRECTIONS, want.radius + far, half, True)
    at = np.broadcast_to(want.feet[0] + DIRECTIONS * (want.radius if all_round else 0.0), led.shape)
    return Spots(
        np.concatenate([near.ravel(), led.ravel()]),
        np.concatenate([(base[:, None] + PER_DISTANCE * gap).ravel(), np.broadcast_to(LEADER + PER_DISTANCE * far, led.shape).ravel()]),
        np.concatenate([np.full(near.size, complex(math.nan, math.nan)), at.ravel()]))


def _offset(u: Complexes, distance: Floats, half: complex, round_point: bool) -> Complexes:
    """From a point to the middle of a box that stands clear of it by `distance` in direction u."""
    if round_point:  # the box slides round the point
        x, y = np.clip(u.real * 1.42, -1, 1), np.clip(u.imag * 1.42, -1, 1)
        return distance * u + half.real * x + 1j * half.imag * y
    return u * (distance + half.real * np.abs(u.real) + half.imag * np.abs(u.imag))


def wants(view: View, marks: tuple[Mark, ...], lang: Lang = "zh") -> tuple[Want, ...]:
    """All that is to be lettered; points at the same place share one label."""
    found = list(_points(marks))
    for mark in marks:
        match mark:
            case Vector(label=label) if label:
                found.append(_vector(mark, kind_hue(view, label)))
            case LinkNumber(a=a, b=b, number=number):
                keep = LINK / 2 if abs(b - a) > NEAR else _keep(a, marks)
                found.append(_line_want(a, b, keep, (_piece(number, Hue.BLACK, mark.step),), Thing.LINK))
            case TurnArrow(at=at, radius=radius, start=start, ccw=ccw, label=label) if label:
                found.append(_bow(at, radius, start, TURN if ccw else -TURN, _piece(label, kind_hue(view, label), mark.step)))
            case AngleMark(at=at, radius=radius, start=start, sweep=sweep, label=label) if label:
                piece = _piece(label, Hue.BLACK, mark.step)
                found.append(_outside(mark, piece) if narrow(mark) else _bow(at, radius, start, sweep, piece))
            case FrictionCircle() if mark.label or mark.enlarged > 1:
                found.append(_circle(mark))
            case Note(at=at, words=words):
                piece = Piece(lines(words.of(lang), NOTE), 0.0, Hue.BLACK, mark.step)
                found.append(Want((piece,), (at,), (0j,), _keep(at, marks), (at, at)))
            case _:
                pass
    return tuple(found)


def _piece(text: str, hue: Hue, step: int, dx: float = 0.0) -> Piece:
    return Piece(layout(row(text), LETTER), dx, hue, step)


def _points(marks: tuple[Mark, ...]) -> Iterable[Want]:
    groups: list[tuple[complex, list[Point]]] = []
    for mark in marks:
        if isinstance(mark, Point) and mark.label:
            home = next((g for at, g in groups if abs(at - mark.at) < NEAR), None)
            if home is None:
                groups.append((mark.at, [mark]))
            elif all(other.label != mark.label for other in home):
                home.append(mark)
    for at, group in groups:
        pieces: list[Piece] = []
        for mark in group:
            x = pieces[-1].dx + pieces[-1].box.width if pieces else 0.0
            if pieces:
                comma = Piece(layout(Txt(","), LETTER), x, Hue.BLACK, mark.step)
                pieces.append(comma)
                x += comma.box.width + 0.3 * LETTER
            pieces.append(_piece(mark.label, Hue.BLACK, mark.step, x))
        thing = Thing.POINT if any(mark.dot is not Dot.NONE for mark in group) else Thing.OTHER
        yield Want(tuple(pieces), (at,), (0j,), _keep(at, marks), (at, at), thing=thing)


def _keep(at: complex, marks: tuple[Mark, ...]) -> float:
    """The radius of whatever is drawn at a point."""
    radius = {Dot.JOINT: JOINT_RADIUS, Dot.POLE: POLE_RADIUS, Dot.POINT: DOT_RADIUS, Dot.NONE: 0.0}
    found = [0.0]
    for mark in marks:
        match mark:
            case Point(at=here, dot=dot) if abs(here - at) < NEAR:
                found.append(radius[dot])
            case Ground(at=here) | Block(at=here) if abs(here - at) < NEAR:
                found.append(JOINT_RADIUS)
            case FrictionCircle(centre=here, radius=r) if abs(here - at) < NEAR and r < ROOMY:
                found.append(r)
            case _:
                pass
    return max(found)


def _vector(mark: Vector, hue: Hue) -> Want:
    return _line_want(mark.a, mark.b, RESULT / 2, (_piece(mark.label, hue, mark.step),), Thing.VECTOR)


def _line_want(a: complex, b: complex, radius: float, pieces: tuple[Piece, ...], thing: Thing) -> Want:
    if abs(b - a) < NEAR:
        return Want(pieces, (a,), (0j,), radius, (a, a), thing=thing)
    n = 1j * (b - a) / abs(b - a)
    feet = tuple(a + (b - a) * f for f in FRACTIONS)
    return Want(pieces, feet, (n,) * len(feet), radius, (a, b), thing=thing)


def _bow(at: complex, radius: float, start: float, sweep: float, piece: Piece) -> Want:
    out = tuple(cmath.exp(1j * (start + sweep * f)) for f in FRACTIONS)
    return Want((piece,), tuple(at + radius * u for u in out), out, THIN, (at, at))


def _outside(mark: AngleMark, piece: Piece) -> Want:
    """Beyond the arc of a narrow angle, or beside the ends of its tails."""
    turn = math.copysign(TAIL / mark.radius, mark.sweep)
    along = (mark.start + mark.sweep / 2, mark.start + mark.sweep + turn, mark.start - turn)
    out = tuple(cmath.exp(1j * a) for a in along)
    normals = (out[0], out[1] * 1j * math.copysign(1, turn), out[2] * -1j * math.copysign(1, turn))
    return Want((piece,), tuple(mark.at + mark.radius * u for u in out), normals, THIN, (mark.at, mark.at), one_sided=True)


def _circle(mark: FrictionCircle) -> Want:
    """The letter of a friction circle, and how much larger than true it is drawn."""
    pieces: tuple[Piece, ...] = (_piece(mark.label, Hue.BLACK, mark.step),) if mark.label else ()
    if mark.enlarged > 1:
        x = pieces[0].box.width + 0.3 * LETTER if pieces else 0.0
        pieces += (Piece(layout(Txt(f"×{mark.enlarged:g}"), NOTE), x, Hue.BLACK, mark.step),)
    return Want(pieces, (mark.centre,), (0j,), mark.radius + THIN, (mark.centre, mark.centre))


def smaller(want: Want, factor: float) -> Want:
    """The label in smaller type: the last resort."""
    pieces = tuple(replace(p, box=_scaled(p.box, factor), dx=p.dx * factor) for p in want.pieces)
    return replace(want, pieces=pieces, scale=want.scale * factor)


def _scaled(box: Box, k: float) -> Box:
    from ..typeset import Glyphs, Rule

    items: list[Glyphs | Rule] = []
    for item in box.items:
        match item:
            case Glyphs(font, size, x, y, text):
                items.append(Glyphs(font, size * k, x * k, y * k, text))
            case Rule(x, y, width, height):
                items.append(Rule(x * k, y * k, width * k, height * k))
    return Box(box.width * k, box.ascent * k, box.descent * k, tuple(items))
