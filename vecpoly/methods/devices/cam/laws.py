"""The displacement diagram by each law's own construction; it gives s, and from the same lines ds/dφ and d²s/dφ²."""

from __future__ import annotations

from dataclasses import dataclass
from math import pi
from typing import assert_never

import numpy as np

from ....board.board import Board
from ....board.construction import View
from ....board.paper.marks import Role
from ....devices.cams.motion import Law, Piece
from ....plane import Line, Points, Reals, nominal, unit
from ....words import Words

HALF_WAY = 0.5 + 1e-9  # of a stroke: from here on a parabola is drawn from its other end
Rates = tuple[Points, Reals, Reals]  # the point of the curve; lengths on paper that are in proportion to s′ and s″


@dataclass(frozen=True, slots=True, kw_only=True)
class Lift:
    """A station on the diagram: foot on the axis, point on the curve; s read there, s′ and s″ (SI, a radian)."""

    foot: Points
    point: Points
    s: Reals
    slope: Reals
    bend: Reals


@dataclass(frozen=True, slots=True, kw_only=True)
class Stroke:
    """A piece on paper: the corner from which it rises, which way it goes, how wide and high it is (mm)."""

    board: Board
    place: View
    corner: complex
    way: int
    wide: float
    high: float
    angle: float

    @property
    def top(self) -> complex:
        """Where it arrives."""
        return self.corner + complex(self.way * self.wide, self.high)

    def rule(self, a: Points, b: Points) -> Line:
        """The line from a towards b."""
        return self.board.parallel(a, unit(b - a))

    def met(self, line: Line, upright: Line) -> Points:
        """Where a line meets the ordinate of the station, with its ink up to there."""
        at = self.board.meet(line, upright, Words("位移线图上的点", "the point of the displacement diagram"))
        self.board.join(self.place, line.at, at, Role.CONSTRUCTION)
        return at


def lift(board: Board, place: View, piece: Piece, phi: Reals, *, late: bool = False, letters: str = "") -> Lift:
    """The station at an angle of a piece; late: seen from after a jump of the acceleration in its middle."""
    mu, across = board.scale_of(place).value, board.scale_of(place).right.value
    foot = board.lay_off(0j, 1 + 0j, phi / across)
    upright = board.parallel(foot, 1j)
    way = 1 if piece.rises >= 0 else -1
    stroke = Stroke(
        board=board,
        place=place,
        corner=complex((piece.start if way > 0 else piece.end) / across, piece.low / mu),
        way=way,
        wide=piece.angle / across,
        high=piece.lift / mu,
        angle=piece.angle,
    )
    u = (phi - piece.start if way > 0 else piece.end - phi) / piece.angle
    point, first, second = _drawn(stroke, piece.law, u, upright, late)
    board.join(place, foot, point, Role.CONSTRUCTION)
    s = board.measure(foot, point, letters).value * mu
    return Lift(foot=foot, point=point, s=s, slope=way * first * mu, bend=second * mu)


def stretches(piece: Piece) -> tuple[tuple[float, float, bool], ...]:
    """Parts of a piece in which nothing jumps: from where, to where, and whether late; a parabola's are its halves."""
    if piece.law is not Law.PARABOLIC:
        return ((piece.start, piece.end, False),)
    middle = piece.start + piece.angle / 2  # drawn from its other end, a return begins with the late half
    return (piece.start, middle, piece.rises < 0), (middle, piece.end, piece.rises > 0)


def _drawn(stroke: Stroke, law: Law | None, u: Reals, upright: Line, late: bool) -> Rates:
    match law:
        case None:
            level = stroke.board.parallel(stroke.corner, 1 + 0j)
            return stroke.board.meet(level, upright, ""), 0.0 * u, 0.0 * u
        case Law.UNIFORM:
            at = stroke.met(stroke.rule(stroke.corner, stroke.top), upright)
            return at, 0.0 * u + stroke.high / stroke.angle, 0.0 * u
        case Law.PARABOLIC:
            return _parabola(stroke, u, upright, late or float(nominal(u)) > HALF_WAY)
        case Law.COSINE:
            return _semicircle(stroke, u, upright)
        case Law.SINE:
            return _rolling_circle(stroke, u, upright)
        case Law.POLYNOMIAL:
            return _table(stroke, u, upright)
        case _:
            assert_never(law)


def _parabola(it: Stroke, u: Reals, upright: Line, late: bool) -> Rates:
    """Rays from the vertex to equal divisions of the middle ordinate: heights as 1, 4, 9, increments as 1, 3, 5."""
    vertex, up, share = (it.top, -1j, 1 - u) if late else (it.corner, 1j, u)
    middle = complex((it.corner.real + it.top.real) / 2, vertex.imag)
    division = it.board.lay_off(middle, up, it.high * share)
    it.board.join(it.place, vertex, division, Role.CONSTRUCTION)
    at = it.board.meet(it.rule(vertex, division), upright, Words("抛物线上的点", "the point of the parabola"))
    rate = 4 * np.abs(division - middle) / it.angle
    return at, rate, 0.0 * u + (-4 if late else 4) * it.high / it.angle**2


def _semicircle(it: Stroke, u: Reals, upright: Line) -> Rates:
    """A semicircle over the stroke, divided equally: its points give the heights, its half chords ds/dφ."""
    centre = it.corner + 0.5j * it.high
    it.board.circle(it.place, centre, it.high / 2, Role.CONSTRUCTION, start=it.way * pi / 2, sweep=pi)
    division = it.board.lay_off(centre, -1j * np.exp(-1j * it.way * pi * u), it.high / 2)
    at = it.met(it.board.parallel(division, 1 + 0j), upright)
    per = pi / it.angle
    return at, per * it.way * (centre.real - division.real), per**2 * (centre.imag - division.imag)


def _rolling_circle(it: Stroke, u: Reals, upright: Line) -> Rates:
    """A circle that rolls once along the stroke: its point, projected on the axis, is carried on along the diagonal."""
    radius = it.high / (2 * pi)
    it.board.circle(it.place, it.corner, radius, Role.CONSTRUCTION)
    division = it.board.lay_off(it.corner, np.exp(-2j * pi * u), radius)
    axis = it.board.parallel(it.corner, 1j)
    start = it.board.meet(it.board.parallel(division, 1 + 0j), axis, "")
    it.board.join(it.place, division, start, Role.CONSTRUCTION)
    diagonal = it.rule(it.corner, it.top)
    at = it.met(Line(start, it.board.turn(diagonal.along)), upright)
    per = 2 * pi / it.angle
    return at, per * (radius - (division.real - it.corner.real)), per**2 * (it.corner.imag - division.imag)


def _table(it: Stroke, u: Reals, upright: Line) -> Rates:
    """s/h = 10u³ − 15u⁴ + 6u⁵: heights by the table."""
    level = complex(0.0, it.corner.imag)
    base = it.board.meet(it.board.parallel(level, 1 + 0j), upright, "")
    at = it.board.lay_off(base, 1j, it.high * (10 * u**3 - 15 * u**4 + 6 * u**5))
    rate = 30 * u**2 - 60 * u**3 + 30 * u**4
    change = 60 * u - 180 * u**2 + 120 * u**3
    return at, it.high * rate / it.angle, it.high * change / it.angle**2
