"""What is to be lettered in a figure."""

from __future__ import annotations

import cmath
import math

from ...algebra.formula import Txt
from ...board.construction import View
from ...board.paper.marks import (
    AngleMark,
    Block,
    Disc,
    Dot,
    FixedGuide,
    FrictionCircle,
    Ground,
    LinkNumber,
    Mark,
    Note,
    Passing,
    Point,
    Segment,
    TurnArrow,
    Vector,
)
from ...foundation.slotted import replace
from ...typeset import layout
from ...words import Lang
from ..hues import Tones, mark_hue
from ..style import (
    DOT_RADIUS,
    JOINT_RADIUS,
    LETTER,
    LINK,
    MASS_RADIUS,
    MULTIPLE_RADIUS,
    NOTE,
    POLE_RADIUS,
    RESULT,
    THIN,
    Hue,
)
from ..symbols.angles import TAIL, adjoins, narrow, sweep_of
from ..symbols.bodies import foot_of
from ..symbols.shapes import HATCH, NEAR
from .bows import along, bow
from .notes import lines
from .numbers import FRACTIONS, along_line, number_of_link, under
from .points import keep_at, piece, points
from .want import Line, Piece, Spot, Thing, Want

_RADIUS = {
    Dot.JOINT: JOINT_RADIUS,
    Dot.MULTIPLE: MULTIPLE_RADIUS,
    Dot.MASS: MASS_RADIUS,
    Dot.POLE: POLE_RADIUS,
    Dot.POINT: DOT_RADIUS,
    Dot.NONE: 0.0,
}
# mm along its axis by which a number may stand beside its tick
ASIDE = (0.0, 1.0, -1.0, 2.0, -2.0, 2.6, -2.6, 3.8, -3.8)
TICK = 8.0  # mm: a longer line at an axis is no tick, as an ordinate
ARC_ALONE = 0.8  # mm beside an arc that has no tails
ABOUT_HEAD = 2.8  # mm about the head of an arrow that turns
ROOMY = 7.0  # mm: a friction circle smaller than this does not hold the letter of its pin


def wants(view: View, marks: tuple[Mark, ...], lang: Lang = "zh", tones: Tones = None) -> tuple[Want, ...]:
    """All that is to be lettered; points at the same place share one label. tones: by which vectors are told apart."""
    taken = _taken(marks)
    found = list(points(marks, taken, lang, tones))
    for mark in marks:
        match mark:
            case Vector(label=label) if label:
                found.append(_vector(mark, mark_hue(mark, view, label, tones)))
            case LinkNumber(a=a, number=number) if (ground := _ground(mark, marks)) is not None:
                a, b = foot_of(ground)
                found.append(along_line(a, b, HATCH, (piece(number, Hue.BLACK, mark.step),), Thing.LINK))
            case LinkNumber(number=number) if (guide := _guide(mark, marks)) is not None:
                found.append(under(guide.a, guide.b, HATCH, piece(number, Hue.BLACK, mark.step)))
            case LinkNumber(a=a, b=b, number=number):
                keep = LINK / 2 if abs(b - a) > NEAR else max(keep_at(a, taken), _disc(a, marks))
                found.append(number_of_link(mark, piece(number, Hue.BLACK, mark.step), marks, keep))
            case TurnArrow(label=label) if label:
                hue = mark_hue(mark, view, label, tones)
                found.append(bow(mark, piece(label, hue, mark.step), marks, FRACTIONS))
            case AngleMark(label=label) if label:
                found.append(_angle(mark, marks))
            case FrictionCircle() if mark.label or mark.enlarged > 1:
                found.append(_circle(mark))
            case Note(at=at, words=words):
                note = Piece(lines(words.of(lang), NOTE), 0.0, Hue.BLACK, mark.step)
                found.append(_note(mark, note, marks, keep_at(at, taken)))
            case _:
                pass
    return tuple(found)


def _angle(mark: AngleMark, marks: tuple[Mark, ...]) -> Want:
    """The symbol of an angle, with its value where that has room."""
    its, (symbol, equals, _) = piece(mark.label, Hue.BLACK, mark.step), mark.label.partition(" = ")
    others = [one for one in marks if isinstance(one, AngleMark)]
    tail = ARC_ALONE if adjoins(mark, others) else TAIL
    want = _outside(mark, its, tail) if narrow(mark) else bow(mark, its, marks, FRACTIONS)
    return replace(want, brief=(piece(symbol, Hue.BLACK, mark.step),)) if equals else want


def _note(mark: Note, piece: Piece, marks: tuple[Mark, ...], keep: float) -> Want:
    """Words beside a place; the number of an axis on its side of it, else on the other, beyond the whole tick."""
    at, side = mark.at, mark.side
    if not side:
        return Want((piece,), (at,), (0j,), keep, (at, at), one_sided=False)
    short = (m for m in marks if isinstance(m, Segment) and abs(m.b - m.a) < TICK)
    ticks = (m for m in short if min(abs(m.a - at), abs(m.b - at)) < NEAR)
    over = next((m.a + m.b - at for m in ticks if ((m.a + m.b - 2 * at) * side.conjugate()).real < -NEAR), at)
    ends = ((at, side), (over, -side)) if over != at else ((at, side),)
    feet = tuple(end + 1j * side * by for end, _ in ends for by in ASIDE)
    ways = tuple(way for _, way in ends for _ in ASIDE)
    return Want((piece,), feet, ways, max(keep, RESULT / 2), (at, at), one_sided=True, level=True)


def _guide(number: LinkNumber, marks: tuple[Mark, ...]) -> FixedGuide | None:
    """The fixed guide of which this is the number: the frame's, where it has no pivot. On a sketch it is not reduced
    with the rest: the nearest of those of its direction."""
    along = (number.b - number.a).conjugate()
    found = [
        mark
        for mark in marks
        if isinstance(mark, FixedGuide) and mark.owner == number.owner and abs(number.b - number.a) > NEAR
        if abs(((mark.b - mark.a) * along).imag) < NEAR * abs(along) * abs(mark.b - mark.a)
    ]
    return min(found, key=lambda guide: abs(guide.a + guide.b - number.a - number.b), default=None)


def _ground(number: LinkNumber, marks: tuple[Mark, ...]) -> Ground | None:
    """The ground at a pivot of which this is the number: the frame's."""
    grounds = (mark for mark in marks if isinstance(mark, Ground) and mark.owner == number.owner)
    return next((ground for ground in grounds if number.a == number.b == ground.at), None)


def unnamed(marks: tuple[Mark, ...]) -> tuple[Spot, ...]:
    """The points without a letter."""
    points = [mark for mark in marks if isinstance(mark, Point) and mark.dot is not Dot.NONE]
    named = {mark.at for mark in points if mark.label}
    silent = {mark.at: _RADIUS[mark.dot] for mark in points if mark.at not in named}
    return tuple((at, radius) for at, radius in silent.items() if all(abs(at - other) > NEAR for other in named))


def heads(marks: tuple[Mark, ...]) -> tuple[Spot, ...]:
    """The heads of arrows that turn, by which a letter could be meant: what is nearer to one than to its own thing."""
    turning = (mark for mark in marks if isinstance(mark, TurnArrow) and mark.radius > NEAR)
    return tuple((one.at + cmath.rect(one.radius, one.start + sweep_of(one)), ABOUT_HEAD) for one in turning)


def _taken(marks: tuple[Mark, ...]) -> list[Spot]:
    """Each place at which something is drawn, and the radius of that."""
    found: list[Spot] = []
    for mark in marks:
        match mark:
            case Point(at=here, dot=dot):
                found.append((here, _RADIUS[dot]))
            case Passing(at=here):
                found.append((here, JOINT_RADIUS + LINK))
            case Ground(at=here) | Block(at=here):
                found.append((here, JOINT_RADIUS))
            case FrictionCircle(centre=here, radius=r) if r < ROOMY:
                found.append((here, r))
            case _:
                pass
    return found


def _disc(at: complex, marks: tuple[Mark, ...]) -> float:
    """The radius of a roller about a place: the number of a roller stands beside its rim."""
    return max((m.radius for m in marks if isinstance(m, Disc) and abs(m.centre - at) < NEAR), default=0.0)


def grounds(marks: tuple[Mark, ...]) -> tuple[Line, ...]:
    """Both edges of what is hatched as fixed: under pivots and along guides."""
    found: list[Line] = []
    for mark in marks:
        if isinstance(mark, Ground):
            found.append(foot_of(mark))
        elif isinstance(mark, FixedGuide) and abs(mark.b - mark.a) > NEAR:
            found.append((mark.a, mark.b))
    deep = [-1j * HATCH * (b - a) / abs(b - a) for a, b in found]
    return (*found, *((a + by, b + by) for (a, b), by in zip(found, deep, strict=True)))


def _vector(mark: Vector, hue: Hue) -> Want:
    return along_line(mark.a, mark.b, RESULT / 2, (piece(mark.label, hue, mark.step),), Thing.VECTOR)


def _outside(mark: AngleMark, piece: Piece, tail: float) -> Want:
    """Beyond the arc of a narrow angle, or beside the ends of its tails."""
    turn = math.copysign(tail / mark.radius, mark.sweep)
    ways = (mark.start + mark.sweep / 2, mark.start + mark.sweep + turn, mark.start - turn)
    out = tuple(cmath.exp(1j * a) for a in ways)
    normals = (out[0], out[1] * 1j * math.copysign(1, turn), out[2] * -1j * math.copysign(1, turn))
    feet, own = tuple(mark.at + mark.radius * u for u in out), (mark.at, mark.at)
    return Want((piece,), feet, normals, THIN, own, one_sided=True, thing=Thing.ARC, bow=along(mark))


def _circle(mark: FrictionCircle) -> Want:
    """The letter of a friction circle, and how much larger than true it is drawn."""
    pieces: tuple[Piece, ...] = (piece(mark.label, Hue.BLACK, mark.step),) if mark.label else ()
    if mark.enlarged > 1:
        x = pieces[0].box.width + 0.3 * LETTER if pieces else 0.0
        pieces += (Piece(layout(Txt(f"×{mark.enlarged:g}"), NOTE), x, Hue.BLACK, mark.step),)
    return Want(pieces, (mark.centre,), (0j,), mark.radius + THIN, (mark.centre, mark.centre))
