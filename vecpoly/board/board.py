"""The board: a hand's acts on an emulated sheet, done at once and recorded for ever.

The board knows paper, rule, compass and set square; it knows nothing of mechanisms. A method gets its numbers only by
laying off, meeting, measuring and computing here. It is the one mutable object of the program, while it is drawn on.
"""

from __future__ import annotations

from collections.abc import Mapping
from math import asin, degrees

import numpy as np

from ..errors import AssemblyError, DeadPointError, EquilibriumError, NotAskedError, bilingual
from ..formula import Node, Row, row
from ..plane import Line, Points, Reals, circles_meet, cross, line_circle_meet, lines_meet, nominal, similar
from ..plane.geometry import dot, inclined
from ..quantity import Expr, Quantity, magnitude, paper, worked
from ..words import Words
from .construction import Place, Scale, View
from .hand import Hand
from .log import Log
from .marks import Arc, Dot, ImageOf, Point, RightAngle, Role, Segment, Vector
from .ruler import Ruler

OVERRUN = 6.0  # mm a ruled line runs past its meeting point
NO_LENGTH = 1e-9  # mm: points nearer than this are one point, and have no direction to each other
PARALLEL = 1e-9  # sine below which two ruled lines do not meet
GRAZING = 0.26  # sine (15°) below which a meeting is called uncertain


class Board(Log):
    """One sheet under one hand (and its repetitions)."""

    def __init__(self, hand: Hand, scales: Mapping[View, Scale] | Mapping[Place, Scale]) -> None:
        super().__init__(scales)
        self.hand = hand
        self._ruler = Ruler(hand)

    # -- acts -------------------------------------------------------------------------------------------------

    def plot(self, view: Place, at: Points, label: str, dot: Dot = Dot.POINT) -> None:
        """Letter a point."""
        self.mark(view, Point(at=complex(nominal(at)), label=label, dot=dot))

    def join(self, view: Place, a: Points, b: Points, role: Role) -> None:
        """Rule a line from a to b."""
        self.mark(view, Segment(a=complex(nominal(a)), b=complex(nominal(b)), role=role))

    def arrow(self, view: Place, a: Points, b: Points, role: Role) -> None:
        """Draw the vector from a to b."""
        start, end = complex(nominal(a)), complex(nominal(b))
        if abs(end - start) > 1e-6:
            self.mark(view, Vector(a=start, b=end, role=role))

    def arrow_once(self, view: Place, a: Points, b: Points) -> None:
        """Draw the result vector from a to b unless a vector stands there already."""
        start, end = complex(nominal(a)), complex(nominal(b))
        there = any(isinstance(m, Vector) and abs(m.a - start) + abs(m.b - end) < 1e-6 for m in self._marks[view])
        if not there:
            self.arrow(view, a, b, Role.RESULT)

    def right_angle(self, view: Place, at: Points, u: Points, v: Points) -> None:
        """Mark a right angle."""
        self.mark(view, RightAngle(at=complex(nominal(at)), u=complex(nominal(u)), v=complex(nominal(v))))

    def lay_off(self, start: Points, along: Points, mm: Reals) -> Points:
        """Lay off a length from a point in a direction carried by set square."""
        return start + self.hand.tilt(along) * self.hand.carry(mm)

    def parallel(self, at: Points, along: Points) -> Line:
        """Rule a line through a point parallel to a drawn direction."""
        return Line(at, self.hand.tilt(along))

    def rule(self, view: Place, line: Line, to: Points, label: str = "") -> None:
        """Leave a direction line on the paper, from its start to a little past `to`, as a ruler leaves it."""
        start, end = complex(nominal(line.at)), complex(nominal(to))
        along = complex(nominal(line.along))
        past = along if abs(end - start) < NO_LENGTH else (end - start) / abs(end - start)
        back = 0.0 if abs(end - start) > 2 * OVERRUN else OVERRUN
        self.mark(view, Segment(a=start - past * back, b=end + past * OVERRUN, role=Role.DIRECTION))
        if label:
            self.mark(view, Point(at=end + past * OVERRUN, label=label, dot=Dot.NONE))

    def meet(self, g: Line, h: Line, what: Words | str) -> Points:
        """Meeting point of two ruled lines; parallel lines are a dead point, grazing ones are remarked unless both start at their meeting point."""
        sine = abs(float(nominal(cross(g.along, h.along))))
        if sine < PARALLEL:
            raise DeadPointError(
                bilingual(what) + Words(
                "：两方向线平行，多边形不能闭合于一点；此为死点或转折点位置，请另取原动件位置",
                ": the two direction lines are parallel, the polygon does not close at one point; this is a dead point or change point, choose another input position")
            )
        if sine < GRAZING and abs(complex(nominal(g.at - h.at))) > NO_LENGTH:
            angle = degrees(asin(sine))
            self.remark(Words(f"（两方向线交角仅 {angle:.0f}°，交点不易准确。）", f" (The two lines meet at only {angle:.0f}°: an uncertain point.)"))
        return lines_meet(g, h)

    def swing(self, view: Place, centre: Points, radius: Reals, through: Points) -> None:
        """Leave the short compass arc about a centre near the point it passes."""
        c, p = complex(nominal(centre)), complex(nominal(through))
        size = float(nominal(radius))
        half = min(0.5, 7.0 / max(size, 1e-6))
        start = float(np.angle(p - c)) - half
        self.mark(view, Arc(centre=c, radius=size, start=start, sweep=2 * half, role=Role.CONSTRUCTION))

    def arcs(self, c1: Points, r1: Reals, c2: Points, r2: Reals, what: Words | str) -> tuple[Points, Points]:
        """Two compass arcs: both meeting points, the one left of c1 → c2 first."""
        a, b = circles_meet(c1, self.hand.carry(r1), c2, self.hand.carry(r2))
        if not np.isfinite(nominal(a)):
            d, s = float(nominal(abs(c2 - c1))), float(nominal(r1)) + float(nominal(r2))
            raise AssemblyError(bilingual(what) + Words(
                f"：半径 {nominal(r1):.2f} mm 与 {nominal(r2):.2f} mm 的两弧圆心相距 {d:.2f} mm，不相交（半径之和 {s:.2f} mm）",
                f": the arcs of {nominal(r1):.2f} mm and {nominal(r2):.2f} mm about points {d:.2f} mm apart do not meet (sum {s:.2f} mm)"))
        return a, b

    def arc_on_line(self, line: Line, centre: Points, radius: Reals, what: Words | str) -> tuple[Points, Points]:
        """A compass arc on a ruled line: both meeting points, the one further along the line first."""
        a, b = line_circle_meet(line, centre, self.hand.carry(radius))
        if not np.isfinite(nominal(a)):
            gap = abs(float(nominal(cross(line.along, centre - line.at))))
            raise AssemblyError(bilingual(what) + Words(f"：半径 {nominal(radius):.2f} mm 的弧达不到相距 {gap:.2f} mm 的直线", f": an arc of {nominal(radius):.2f} mm does not reach a line {gap:.2f} mm away"))
        return a, b

    def tangent_from(self, x: Points, centre: Points, radius: Reals, moment: float, towards: Points) -> Points:
        """Direction u of a force through x tangent to a friction circle: u · towards > 0, moment about the centre of sign `moment`.

        The foot of the arm is centre − i u moment radius. Raises EquilibriumError where x lies inside the circle.
        """
        away, size = float(nominal(np.abs(x - centre))), float(nominal(radius))
        if away <= max(size * abs(moment), NO_LENGTH):
            raise EquilibriumError(Words(
                f"作用线须过距摩擦圆圆心 {away:.2f} mm 的一点，而摩擦圆半径为 {size:.2f} mm，该点在圆内，无切线，在此摩擦下不能平衡；请减小 f 或 ρ",
                f"a line of action must pass through a point {away:.2f} mm from the centre of a friction circle of radius {size:.2f} mm, inside it: no tangent, there is no equilibrium with this friction; lower f or ρ"))
        ahead, behind = inclined(x - centre, moment * radius / np.abs(x - centre))
        return self.hand.tilt(ahead if nominal(dot(ahead - behind, towards)) > 0 else behind)

    def tangent_to_both(self, p: Points, rho_p: Reals, moment_p: float, q: Points, rho_q: Reals, moment_q: float, sense: float) -> Line:
        """Line of action of a two-force body: its force along u at p, along −u at q, each with a moment of the given sign about its pin.

        sense +1: u points from p towards q, −1 the other way. The line starts where it touches p's circle. Raises EquilibriumError
        where the circles overlap too far.
        """
        span, arms = np.abs(q - p), moment_p * rho_p + moment_q * rho_q
        if abs(float(nominal(arms))) >= float(nominal(span)):
            raise EquilibriumError(Words(
                f"两转动副相距 {float(nominal(span)):.2f} mm，摩擦圆半径为 {float(nominal(rho_p)):.2f} mm 和 {float(nominal(rho_q)):.2f} mm，无公切线，力不能经此构件传递；请减小 f 或 ρ",
                f"two pins {float(nominal(span)):.2f} mm apart have friction circles of {float(nominal(rho_p)):.2f} mm and {float(nominal(rho_q)):.2f} mm: no common tangent, no force passes through this link; lower f or ρ"))
        u = inclined(q - p, arms / span)[0 if sense > 0 else 1]
        return Line(p - 1j * u * moment_p * rho_p, self.hand.tilt(u))

    def image(self, of: tuple[Points, Points, Points], on: tuple[Points, Points]) -> Points:
        """The third corner of the similar figure on `on` that keeps the letter order of `of`."""
        return similar(*of, *on) + self.hand.carry(0.0) + 1j * self.hand.carry(0.0)

    # -- measuring and computing --------------------------------------------------------------------------------

    def measure(self, a: Points, b: Points, letters: str) -> Quantity:
        """Read a length off the rule (mm): here, and only here, rounding happens. A segment is read once, from either end."""
        return paper(letters_node(letters), self._ruler.length(a, b))

    def bearing(self, a: Points, b: Points) -> Points:
        """The direction from a to b read off the protractor, as a unit vector; a segment is read once, from either end."""
        return self._ruler.bearing(a, b)

    def compute(self, symbol: str, expr: Expr, unit_text: str) -> Quantity:
        """Write symbol = formula = numbers = result into the step and go on with the result; NotAskedError where it is 0/0."""
        if np.isnan(nominal(expr.value)):
            raise NotAskedError(Words(f"{symbol} 无从量取：图上相应的线段没有长度；请检查各长度是否相差过大，或用 vecpoly exact",
                                      f"{symbol} cannot be read: its lines on paper have no length; check whether the given lengths are too unlike, or use 'vecpoly exact'"), code="unreadable")
        result = magnitude(symbol, expr.value, unit_text)
        self.write(worked(result.node, expr, unit_text))
        return result

    def write_length(self, view: Place, letters: str, quantity: Quantity) -> None:
        """Write how long a quantity becomes on paper: pb = v_B / μ_v = 50 mm."""
        self.write(worked(paper(letters_node(letters), 0.0).node, quantity / self.mu(view), "mm"))

    def tint(self, view: Place, points: tuple[Points, ...]) -> None:
        """Tint the image of a link."""
        self.mark(view, ImageOf(points=tuple(complex(nominal(p)) for p in points)))


def letters_node(letters: str) -> Node:
    """Letters of a paper length side by side: ``p c_2`` → p c₂."""
    return Row(tuple(item for word in letters.split() for item in row(word).items))
