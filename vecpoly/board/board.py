"""The board: a hand's acts on an emulated sheet, done at once and recorded for ever.

The board knows paper, rule, compass and set square; it knows nothing of mechanisms. A method gets its numbers only by
laying off, meeting, measuring and computing here; what it gets knows the act that gave it (`plane.traced`), so that the next act knows what
it needed. It is the one mutable object of the program, while it is drawn on.
"""

from __future__ import annotations

from collections.abc import Mapping
from math import asin, degrees
from typing import Any

import numpy as np

from ..errors import AssemblyError, DeadPointError, EquilibriumError, bilingual
from ..formula import Node, Row, row
from ..names import ascii_key
from ..plane import Line, Points, Reals, circles_meet, cross, line_circle_meet, lines_meet, nominal, similar
from ..plane.geometry import dot, inclined
from ..plane.traced import Acts, acts_of, traced
from ..quantity import Expr, Quantity, magnitude, paper, worked
from ..words import Words
from . import acts as done
from .amended import AS_DRAWN, Amended, plain_letters
from .construction import Reading, Scale
from .hand import Hand
from .hand import hand as hand_of
from .log import Log
from .marks import Dot, Role, Vector
from .place import Place, View
from .ruler import Ruler

OVERRUN = 6.0  # mm a ruled line runs past its meeting point
NO_ARROW = 1e-6  # mm: shorter vectors are not drawn
NO_LENGTH = 1e-9  # mm: points nearer than this are one point, and have no direction to each other
PARALLEL = 1e-9  # sine below which two ruled lines do not meet
GRAZING = 0.26  # sine (15°) below which a meeting is called uncertain


class Board(Log):
    """One sheet under one hand (and its repetitions), drawn as the hand would, or with amendments."""

    def __init__(self, hand: Hand, scales: Mapping[View, Scale] | Mapping[Place, Scale], amended: Amended = AS_DRAWN) -> None:
        super().__init__(scales)
        self.hand = hand
        self.amended = amended
        self.readings: dict[str, Reading] = {}  # what was found of the quantities: each in one place, as it is read
        self.found: dict[str, Reals] = {}  # the same by every hand
        self._ruler = Ruler(hand)

    def scratch(self, scales: Mapping[View, Scale] | None = None) -> Board:
        """Scratch paper for an exact hand: its acts are not remembered, and what it gives came from where its inputs came from."""
        return _Scratch(hand_of("exact"), scales or self.scales)

    # -- acts that leave ink ----------------------------------------------------------------------------------

    def plot(self, view: Place, at: Points, label: str, dot: Dot = Dot.POINT) -> None:
        """Letter a point."""
        self.log(done.Plot(head=self.head(at, on=view), at=spot(at), label=label, dot=dot))

    def join(self, view: Place, a: Points, b: Points, role: Role) -> None:
        """Rule a line from a to b."""
        self.log(done.Join(head=self.head(a, b, on=view), a=spot(a), b=spot(b), role=role))

    def arrow(self, view: Place, a: Points, b: Points, role: Role, *, key: str = "", label: str = "") -> None:
        """Draw the vector `key` from a to b; one without length leaves no ink."""
        start, end = spot(a), spot(b)
        self.log(done.Arrow(head=self.head(a, b, on=view, key=key), a=start, b=end, role=role, label=label, shown=abs(end - start) > NO_ARROW))

    def arrow_once(self, view: Place, a: Points, b: Points, *, key: str = "") -> None:
        """Draw the result vector from a to b unless a vector stands there already."""
        start, end = spot(a), spot(b)
        there = any(isinstance(m, Vector) and abs(m.a - start) + abs(m.b - end) < NO_ARROW for m in self._marks[view])
        shown = not there and abs(end - start) > NO_ARROW
        self.log(done.Arrow(head=self.head(a, b, on=view, key=key), a=start, b=end, role=Role.RESULT, shown=shown))

    def right_angle(self, view: Place, at: Points, u: Points, v: Points) -> None:
        """Mark a right angle."""
        self.log(done.Corner(head=self.head(at, u, v, on=view), at=spot(at), u=spot(u), v=spot(v)))

    def rule(self, view: Place, line: Line, to: Points, label: str = "") -> None:
        """Leave a direction line on the paper, from its start to a little past `to`, as a ruler leaves it."""
        start, end = spot(line.at), spot(to)
        along = spot(line.along)
        past = along if abs(end - start) < NO_LENGTH else (end - start) / abs(end - start)
        back = 0.0 if abs(end - start) > 2 * OVERRUN else OVERRUN
        self.log(done.Rule(head=self.head(line, to, on=view), a=start - past * back, b=end + past * OVERRUN, label=label))

    def swing(self, view: Place, centre: Points, radius: Reals, through: Points) -> None:
        """Leave the short compass arc about a centre near the point it passes."""
        c, p = spot(centre), spot(through)
        size = float(nominal(radius))
        half = min(0.5, 7.0 / max(size, 1e-6))
        start = float(np.angle(p - c)) - half
        self.log(done.Swing(head=self.head(centre, radius, through, on=view), centre=c, radius=size, start=start, sweep=2 * half))

    def tint(self, view: Place, points: tuple[Points, ...]) -> None:
        """Tint the image of a link."""
        self.log(done.Tint(head=self.head(points, on=view), points=tuple(spot(p) for p in points)))

    # -- acts that give points and directions -----------------------------------------------------------------

    def locate(self, view: Place, letter: str, at: Points) -> Points:
        """From now on the point has this letter; goes on with a point of somebody's own where there is one."""
        at = self.amended.point(view, letter, at)
        return traced(at, self.log(done.Locate(head=self.head(at, on=view, key=plain_letters(letter)), at=spot(at))))

    def turn(self, along: Points) -> Points:
        """Carry a direction to another place with the set square."""
        carried = self.hand.tilt(along)
        return traced(carried, self.log(done.Turn(head=self.head(along), along=spot(carried))))

    def transfer(self, vector: Points) -> Points:
        """Carry a whole vector to another place with the dividers."""
        carried = self.hand.carry_vector(vector)
        return traced(carried, self.log(done.Transfer(head=self.head(vector), by=spot(carried))))

    def lay_off(self, start: Points, along: Points, mm: Reals, *, key: str = "") -> Points:
        """Lay off a length from a point in a direction carried by set square."""
        at = start + self.hand.tilt(along) * self.hand.carry(mm)
        act = done.LayOff(head=self.head(start, along, mm, key=key), start=spot(start), at=spot(at), mm=float(nominal(mm)))
        return traced(at, self.log(act))

    def parallel(self, at: Points, along: Points) -> Line:
        """Rule a line through a point parallel to a drawn direction."""
        carried = self.hand.tilt(along)
        act = self.log(done.Parallel(head=self.head(at, along), at=spot(at), along=spot(carried)))
        return Line(traced(at, act), traced(carried, act))

    def meet(self, g: Line, h: Line, what: Words | str) -> Points:
        """Meeting point of two ruled lines; parallel lines are a dead point, grazing ones are remarked unless both start at their meeting point."""
        sine = abs(float(nominal(cross(g.along, h.along))))
        if sine < PARALLEL:
            raise DeadPointError(
                bilingual(what) + Words(
                "：两方向线平行，多边形不能闭合于一点；此为死点或转折点位置，请另取原动件位置",
                ": the two direction lines are parallel, the polygon does not close at one point; this is a dead point or change point, choose another input position")
            )
        if sine < GRAZING and abs(spot(g.at - h.at)) > NO_LENGTH:
            angle = degrees(asin(sine))
            self.remark(Words(f"（两方向线交角仅 {angle:.0f}°，交点不易准确。）", f" (The two lines meet at only {angle:.0f}°: an uncertain point.)"))
        at = lines_meet(g, h)
        return traced(at, self.log(done.Meet(head=self.head(g, h), at=spot(at))))

    def arcs(self, c1: Points, r1: Reals, c2: Points, r2: Reals, what: Words | str) -> tuple[Points, Points]:
        """Two compass arcs: both meeting points, the one left of c1 → c2 first."""
        a, b = circles_meet(c1, self.hand.carry(r1), c2, self.hand.carry(r2))
        if not np.isfinite(nominal(a)):
            d, s = float(nominal(abs(c2 - c1))), float(nominal(r1)) + float(nominal(r2))
            raise AssemblyError(bilingual(what) + Words(
                f"：半径 {nominal(r1):.2f} mm 与 {nominal(r2):.2f} mm 的两弧圆心相距 {d:.2f} mm，不相交（半径之和 {s:.2f} mm）",
                f": the arcs of {nominal(r1):.2f} mm and {nominal(r2):.2f} mm about points {d:.2f} mm apart do not meet (sum {s:.2f} mm)"))
        return self._both(a, b, c1, r1, c2, r2)

    def arc_on_line(self, line: Line, centre: Points, radius: Reals, what: Words | str) -> tuple[Points, Points]:
        """A compass arc on a ruled line: both meeting points, the one further along the line first."""
        a, b = line_circle_meet(line, centre, self.hand.carry(radius))
        if not np.isfinite(nominal(a)):
            gap = abs(float(nominal(cross(line.along, centre - line.at))))
            raise AssemblyError(bilingual(what) + Words(f"：半径 {nominal(radius):.2f} mm 的弧达不到相距 {gap:.2f} mm 的直线", f": an arc of {nominal(radius):.2f} mm does not reach a line {gap:.2f} mm away"))
        return self._both(a, b, line, centre, radius)

    def _both(self, a: Points, b: Points, *inputs: Any) -> tuple[Points, Points]:
        """Both meetings of an arc, each an act that knows the other."""
        here = self.log(done.Meet(head=self.head(*inputs), at=spot(a), other=spot(b)))
        there = self.log(done.Meet(head=self.head(*inputs), at=spot(b), other=spot(a)))
        return traced(a, here), traced(b, there)

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
        taken = self.hand.tilt(ahead if nominal(dot(ahead - behind, towards)) > 0 else behind)
        return self._touching(taken, (ahead, behind), x, centre, radius, towards)

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
        ways = inclined(q - p, arms / span)
        u = ways[0 if sense > 0 else 1]
        return Line(p - 1j * u * moment_p * rho_p, self._touching(self.hand.tilt(u), ways, p, rho_p, q, rho_q))

    def _touching(self, taken: Points, ways: tuple[Points, Points], *inputs: Any) -> Points:
        """The tangent that was taken; the act knows the other."""
        along = spot(taken)
        other = min((spot(way) for way in ways), key=lambda way: (way * along.conjugate()).real)
        return traced(taken, self.log(done.Touch(head=self.head(*inputs), along=along, other=other)))

    def image(self, of: tuple[Points, Points, Points], on: tuple[Points, Points]) -> Points:
        """The third corner of the similar figure on `on` that keeps the letter order of `of`."""
        at = similar(*of, *on) + self.hand.carry(0.0) + 1j * self.hand.carry(0.0)
        return traced(at, self.log(done.Image(head=self.head(of, on), at=spot(at))))

    # -- measuring and computing --------------------------------------------------------------------------------

    def measure(self, a: Points, b: Points, letters: str) -> Quantity:
        """Read a length off the rule (mm): here, and only here, rounding happens. A segment is read once, from either end."""
        mm = self._ruler.length(a, b, lambda read: self._measured(read, a, b, letters))
        return paper(letters_node(letters), mm)

    def _measured(self, read: Reals, a: Points, b: Points, letters: str) -> Reals:
        place = next((act.head.place for n in sorted(acts_of(a, b), reverse=True) if (act := self._act(n)) is not None and act.head.place is not None), None)
        mm = self.amended.reading(place, letters, read)
        key = plain_letters(letters)
        return traced(mm, self.log(done.Measure(head=self.head(a, b, on=place, key=key), a=spot(a), b=spot(b), mm=float(nominal(mm)))))

    def _act(self, number: int) -> done.Act | None:
        return self.acts[number] if number < len(self.acts) else None  # scratch paper remembers none

    def bearing(self, a: Points, b: Points) -> Points:
        """The direction from a to b read off the protractor, as a unit vector; a segment is read once, from either end."""
        return self._ruler.bearing(a, b, lambda read: traced(read, self.log(done.Gauge(head=self.head(a, b), angle=float(np.angle(nominal(read)))))))

    def gauge(self, a: Points, b: Points) -> Reals:
        """The angle of the direction from a to b as the protractor shows it (rad)."""
        read = self.hand.gauge(np.angle(b - a))
        return traced(read, self.log(done.Gauge(head=self.head(a, b), angle=float(nominal(read)))))

    def coordinates(self, at: Points, letter: str) -> Points:
        """How far a point lies to the right of the origin and above it, both read off the rule (mm)."""
        read = self.hand.read(at.real) + 1j * self.hand.read(at.imag)
        act = done.Measure(head=self.head(at, key=plain_letters(letter)), a=0j, b=spot(at), mm=abs(spot(read)))
        return traced(read, self.log(act))

    def keep(self, reading: Reading, value: Reals) -> None:
        """Keep an answer, as it is read and by every hand."""
        self.readings[reading.key], self.found[reading.key] = reading, value
        self.answer(reading.key, reading.scalar if reading.vector is None else reading.vector, reading.unit, value)

    def answer(self, key: str, value: complex, unit: str, *found: Points | Reals) -> None:
        """Write down what was found of a quantity (SI), and from what."""
        self.log(done.Answer(head=self.head(*found, key=key), value=value, unit=unit))

    def conclude(self, key: str, value: Reals, unit: str) -> Reals:
        """A value follows from others (SI): ω of a link, with its sense."""
        return traced(value, self.log(done.Compute(head=self.head(value, key=key), value=float(nominal(value)), unit=unit)))

    def compute(self, symbol: str, expr: Expr, unit_text: str) -> Quantity:
        """Write symbol = formula = numbers = result into the step and go on with the result."""
        value = expr.value
        act = self.log(done.Compute(head=self.head(value, key=ascii_key(symbol)), value=float(nominal(value)), unit=unit_text))
        result = magnitude(symbol, traced(value, act), unit_text)
        self.write(worked(result.node, expr, unit_text))
        return result

    def write_length(self, view: Place, letters: str, quantity: Quantity) -> None:
        """Write how long a quantity becomes on paper: pb = v_B / μ_v = 50 mm."""
        self.write(worked(paper(letters_node(letters), 0.0).node, quantity / self.mu(view), "mm"))


class _Scratch(Board):
    """Paper that is thrown away."""

    def log(self, act: done.Act) -> Acts:
        self.ink(act)
        return frozenset(act.inputs)


def spot(at: Points) -> complex:
    """The point on the nominal sheet."""
    return complex(nominal(at))


def letters_node(letters: str) -> Node:
    """Letters of a paper length side by side: ``p c_2`` → p c₂."""
    return Row(tuple(item for word in letters.split() for item in row(word).items))
