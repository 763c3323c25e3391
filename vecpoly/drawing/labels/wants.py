"""What is to be lettered in a figure."""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterable
from dataclasses import dataclass, field, replace
from enum import Enum
from functools import lru_cache

from ...algebra.formula import Txt, row
from ...board.construction import View
from ...board.paper.marks import (
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
from ...typeset import Box, layout
from ...words import Lang
from ..hues import Tones, line_hue, mark_hue
from ..style import DOT_RADIUS, JOINT_RADIUS, LETTER, LINK, NOTE, POLE_RADIUS, RESULT, THIN, Hue
from ..symbols.angles import TAIL, TURN, narrow
from ..symbols.shapes import NEAR
from .notes import lines

FRACTIONS = (0.5, 0.42, 0.58, 0.34, 0.66, 0.26, 0.74, 0.18, 0.82)
_RADIUS = {Dot.JOINT: JOINT_RADIUS, Dot.POLE: POLE_RADIUS, Dot.POINT: DOT_RADIUS, Dot.NONE: 0.0}
Taken = tuple[complex, float]  # a place, and the radius of what is drawn there
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
    farther: bool = False  # whether its leader may be longer than is usual: a crowd leaves it no other place

    width: float = field(init=False)  # of the whole label, mm
    ascent: float = field(init=False)  # over the baseline, mm
    height: float = field(init=False)  # of the whole label, mm

    def __post_init__(self) -> None:
        ascent = max(p.box.ascent for p in self.pieces)
        object.__setattr__(self, "width", max(p.dx + p.box.width for p in self.pieces))
        object.__setattr__(self, "ascent", ascent)
        object.__setattr__(self, "height", ascent + max(p.box.descent for p in self.pieces))


def wants(view: View, marks: tuple[Mark, ...], lang: Lang = "zh", tones: Tones = None) -> tuple[Want, ...]:
    """All that is to be lettered; points at the same place share one label. tones: by which vectors are told apart."""
    taken = _taken(marks)
    found = list(_points(marks, taken, tones))
    for mark in marks:
        match mark:
            case Vector(label=label) if label:
                found.append(_vector(mark, mark_hue(mark, view, label, tones)))
            case LinkNumber(a=a, b=b, number=number):
                keep = LINK / 2 if abs(b - a) > NEAR else _keep(a, taken)
                found.append(_line_want(a, b, keep, (_piece(number, Hue.BLACK, mark.step),), Thing.LINK))
            case TurnArrow(at=at, radius=radius, start=start, ccw=ccw, label=label) if label:
                hue = mark_hue(mark, view, label, tones)
                found.append(_bow(at, radius, start, TURN if ccw else -TURN, _piece(label, hue, mark.step)))
            case AngleMark(at=at, radius=radius, start=start, sweep=sweep, label=label) if label:
                piece = _piece(label, Hue.BLACK, mark.step)
                found.append(_outside(mark, piece) if narrow(mark) else _bow(at, radius, start, sweep, piece))
            case FrictionCircle() if mark.label or mark.enlarged > 1:
                found.append(_circle(mark))
            case Note(at=at, words=words):
                piece = Piece(lines(words.of(lang), NOTE), 0.0, Hue.BLACK, mark.step)
                found.append(Want((piece,), (at,), (0j,), _keep(at, taken), (at, at)))
            case _:
                pass
    return tuple(found)


def _piece(text: str, hue: Hue, step: int, dx: float = 0.0) -> Piece:
    return Piece(_lettered(text), dx, hue, step)


@lru_cache(maxsize=1024)
def _lettered(text: str) -> Box:
    """A symbol in type; the same few come again and again."""
    return layout(row(text), LETTER)


def _points(marks: tuple[Mark, ...], taken: list[Taken], tones: Tones) -> Iterable[Want]:
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
            pieces.append(_piece(mark.label, line_hue(mark.key, tones, Hue.BLACK), mark.step, x))
        thing = Thing.POINT if any(mark.dot is not Dot.NONE for mark in group) else Thing.OTHER
        yield Want(tuple(pieces), (at,), (0j,), _keep(at, taken), (at, at), thing=thing)


def _taken(marks: tuple[Mark, ...]) -> list[Taken]:
    """Each place at which something is drawn, and the radius of that."""
    found: list[Taken] = []
    for mark in marks:
        match mark:
            case Point(at=here, dot=dot):
                found.append((here, _RADIUS[dot]))
            case Ground(at=here) | Block(at=here):
                found.append((here, JOINT_RADIUS))
            case FrictionCircle(centre=here, radius=r) if r < ROOMY:
                found.append((here, r))
            case _:
                pass
    return found


def _keep(at: complex, taken: list[Taken]) -> float:
    """The radius of whatever is drawn at a point."""
    return max((radius for here, radius in taken if abs(here - at) < NEAR), default=0.0)


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
    return Want(
        (piece,), tuple(mark.at + mark.radius * u for u in out), normals, THIN, (mark.at, mark.at), one_sided=True
    )


def _circle(mark: FrictionCircle) -> Want:
    """The letter of a friction circle, and how much larger than true it is drawn."""
    pieces: tuple[Piece, ...] = (_piece(mark.label, Hue.BLACK, mark.step),) if mark.label else ()
    if mark.enlarged > 1:
        x = pieces[0].box.width + 0.3 * LETTER if pieces else 0.0
        pieces += (Piece(layout(Txt(f"×{mark.enlarged:g}"), NOTE), x, Hue.BLACK, mark.step),)
    return Want(pieces, (mark.centre,), (0j,), mark.radius + THIN, (mark.centre, mark.centre))


def smaller(want: Want, factor: float) -> Want:
    """The label in smaller type: the last resort."""
    if factor == 1.0:
        return want
    pieces = tuple(replace(p, box=_scaled(p.box, factor), dx=p.dx * factor) for p in want.pieces)
    return replace(want, pieces=pieces, scale=want.scale * factor)


def _scaled(box: Box, k: float) -> Box:
    from ...typeset import Glyphs, Rule

    items: list[Glyphs | Rule] = []
    for item in box.items:
        match item:
            case Glyphs(font, size, x, y, text):
                items.append(Glyphs(font, size * k, x * k, y * k, text))
            case Rule(x, y, width, height):
                items.append(Rule(x * k, y * k, width * k, height * k))
    return Box(box.width * k, box.ascent * k, box.descent * k, tuple(items))
