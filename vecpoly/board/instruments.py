"""The acts that give points and directions: laying off, ruling parallels, meeting, touching, similar figures."""

from __future__ import annotations

from collections.abc import Mapping
from math import asin, degrees
from typing import Any

import numpy as np

from ..errors import DeadPointError, EquilibriumError, bilingual
from ..names import At
from ..plane import (
    Line,
    Points,
    Reals,
    ahead,
    circles_meet,
    cross,
    line_circle_meet,
    lines_meet,
    nominal,
    similar,
    unit,
)
from ..plane.geometry import crossing, dot, inclined, turned_over
from ..plane.traced import acts_of, traced
from ..words import Words
from . import acts as done
from .acts.inkless import FOUND_ON
from .construction import Scale
from .hand import Hand
from .ledger import Stood
from .otherwise.amended import AS_DRAWN, Amended, plain_letters
from .otherwise.slip import FOUND_AMISS, Mistake, Slip
from .otherwise.wrongly import FACTOR, as_taken, before
from .place import Place, View
from .said.apart import arcs_apart, line_apart, no_tangent
from .strokes import NO_LENGTH, Strokes, amount, spot

PARALLEL = 1e-9  # sine below which two ruled lines do not meet
GRAZING = 0.26  # sine (15°) below which a meeting is called uncertain


class Instruments(Strokes):
    """Rule, compass and set square in a hand."""

    def __init__(
        self, hand: Hand, scales: Mapping[View, Scale] | Mapping[Place, Scale], amended: Amended = AS_DRAWN
    ) -> None:
        super().__init__(scales)
        self.hand, self.amended = hand, amended
        self._others: dict[int, Points] = {}  # of a meeting that was found the one that was not
        self._slipped: set[str] = set()  # what was computed wrongly is laid off as computed

    def locate(self, view: Place, letter: str, at: Points, of: At | None = None, *, found_on: bool = False) -> Points:
        """From now on the point has this letter; goes on with a point of somebody's own where there is one.
        of: the point of the mechanism that it stands for on a polygon. found_on: it is none, but constructed there.
        """
        key = plain_letters(letter)
        other = next((self._others[n] for n in acts_of(at) if n in self._others), at)
        swapped = (hand for hand, slip in self.amended.wrong(view, key) if slip.mistake in FOUND_AMISS)
        at = self.amended.altered(at, ((hand, other) for hand in swapped))
        at = self.amended.point(view, letter, at)
        head = self.head(at, on=view, key=key, owner=FOUND_ON if found_on else "" if of is None else f"point {of}")
        found = self.gave(at, done.Locate(head=head, at=spot(at)))
        self.ledger.spots[view, key] = found
        if of is not None:
            self.ledger.points[view, of] = found
        return found

    def turn(self, along: Points) -> Points:
        """Carry a direction to another place with the set square."""
        carried = self.hand.tilt(along)
        return traced(carried, self.log(done.Turn(head=self.head(along), along=spot(carried))))

    def follow(self, view: Place, start: Points, vector: Points, key: str) -> Points:
        """Go from a point along a vector that stands on the polygon already; gives its end.

        One that was laid off wrongly is gone along as it stands.
        """
        if (view, key) not in self.ledger.laid:
            vector = self._wrongly(view, key, vector)
        end = start + traced(vector, self.log(done.Follow(head=self.head(vector, on=view, key=key), by=spot(vector))))
        self.ledger.vectors[view, key] = Stood(start, end)
        return end

    def transfer(self, view: Place, vector: Points, key: str) -> Points:
        """Carry a whole vector to another place with the dividers."""
        carried = self.hand.carry_vector(self._wrongly(view, key, vector))
        return traced(carried, self.log(done.Transfer(head=self.head(vector, on=view, key=key), by=spot(carried))))

    def lay_off(self, start: Points, along: Points, mm: Reals, *, key: str = "") -> Points:
        """Lay off a length from a point in a direction carried by set square."""
        along = self._wrongly(self.here, key, along)
        self.ledger.laid[self.here, key] = self.ledger.sizes.get(key)
        at = ahead(start, self.hand.tilt(along), self.hand.carry(mm))
        act = done.LayOff(head=self.head(start, along, mm, key=key), start=spot(start), at=spot(at), mm=amount(mm))
        return traced(at, self.log(act))

    def parallel(self, at: Points, along: Points, *, key: str = "") -> Line:
        """Rule a line through a point: parallel to a drawn direction, that of the vector `key`, or to another point."""
        wrong = [(hand, self._led(slip, at, along)) for hand, slip in self.amended.wrong(self.here, key)]
        carried = self.hand.tilt(self.amended.altered(along, wrong))
        act = self.log(done.Parallel(head=self.head(at, along, key=key), at=spot(at), along=spot(carried)))
        return Line(traced(at, act), traced(carried, act))

    def meet(self, g: Line, h: Line, what: Words | str) -> Points:
        """Meeting point of two ruled lines; parallel lines are a dead point,
        grazing ones are remarked unless both start at their meeting point."""
        sine = abs(float(nominal(cross(g.along, h.along))))
        if sine < PARALLEL:
            raise DeadPointError(
                bilingual(what)
                + Words(
                    "：两方向线平行，多边形不能闭合于一点；此为死点或转折点位置，请另取原动件位置",
                    ": the two direction lines are parallel, the polygon does not close at one point; this is "
                    "a dead point or change point, choose another input position",
                )
            )
        if sine < GRAZING and abs(spot(g.at - h.at)) > NO_LENGTH:
            self.graze(degrees(asin(sine)))
        at = lines_meet(g, h)
        return traced(at, self.log(done.Meet(head=self.head(g, h), at=spot(at))))

    def arcs(self, c1: Points, r1: Reals, c2: Points, r2: Reals, what: Words | str) -> tuple[Points, Points]:
        """Two compass arcs: both meeting points, the one left of c1 → c2 first."""
        a, b = circles_meet(c1, self.hand.carry(r1), c2, self.hand.carry(r2))
        if not np.isfinite(nominal(a)):
            raise arcs_apart(what, *(float(nominal(size)) for size in (abs(c2 - c1), r1, r2)))
        return self._both((a, b), crossing(spot(a - c1), spot(a - c2)), c1, r1, c2, r2)

    def arc_on_line(self, line: Line, centre: Points, radius: Reals, what: Words | str) -> tuple[Points, Points]:
        """A compass arc on a ruled line: both meeting points, the one further along the line first."""
        a, b = line_circle_meet(line, centre, self.hand.carry(radius))
        if not np.isfinite(nominal(a)):
            raise line_apart(what, float(nominal(radius)), abs(float(nominal(cross(line.along, centre - line.at)))))
        return self._both((a, b), crossing(spot(line.along), 1j * spot(a - centre)), line, centre, radius)

    def _both(self, pair: tuple[Points, Points], angle: float, *inputs: Any) -> tuple[Points, Points]:
        """Both meetings of an arc, each an act that knows the other."""
        a, b = pair
        here = self.log(done.Meet(head=self.head(*inputs), at=spot(a), other=spot(b), angle=angle))
        there = self.log(done.Meet(head=self.head(*inputs), at=spot(b), other=spot(a), angle=angle))
        one, two = traced(a, here), traced(b, there)
        self._others |= dict.fromkeys(here, two) | dict.fromkeys(there, one)
        return one, two

    def tangent_from(
        self, x: Points, centre: Points, radius: Reals, moment: float, towards: Points, *, key: str = ""
    ) -> Points:
        """Direction u of a force through x tangent to a friction circle:
        u · towards > 0, moment about the centre of sign `moment`.

        The foot of the arm is centre − i u moment radius. Raises EquilibriumError where x lies inside the circle.
        """
        away, size = float(nominal(np.abs(x - centre))), float(nominal(radius))
        if away <= max(size * abs(moment), NO_LENGTH):
            raise no_tangent(away, size)
        ahead, behind = inclined(x - centre, moment * self._side(key) * radius / np.abs(x - centre))
        taken = self.hand.tilt(ahead if nominal(dot(ahead - behind, towards)) > 0 else behind)
        return self._touching(taken, key, not size, x, centre, radius, towards)

    def tangent_to_both(
        self,
        p: Points,
        rho_p: Reals,
        moment_p: float,
        q: Points,
        rho_q: Reals,
        moment_q: float,
        sense: float,
        *,
        key: str = "",
    ) -> Line:
        """Line of action of a two-force body:
        its force along u at p, along −u at q, each with a moment of the given sign about its pin.

        sense +1: u points from p towards q, −1 the other way. The line starts where it touches p's circle. Raises
        EquilibriumError where the circles overlap too far.
        """
        side = self._side(key)
        span, arms = np.abs(q - p), side * (moment_p * rho_p + moment_q * rho_q)
        if abs(float(nominal(arms))) >= float(nominal(span)):
            raise EquilibriumError(
                Words(
                    f"两转动副相距 {float(nominal(span)):.2f} mm，摩擦圆半径为 {float(nominal(rho_p)):.2f} mm "
                    f"和 {float(nominal(rho_q)):.2f} mm，无公切线，力不能经此构件传递；请减小 f 或 ρ",
                    f"two pins {float(nominal(span)):.2f} mm apart have friction circles of "
                    f"{float(nominal(rho_p)):.2f} mm and {float(nominal(rho_q)):.2f} mm: no common tangent, no "
                    "force passes through this link; lower f or ρ",
                )
            )
        u = inclined(q - p, arms / span)[0 if sense > 0 else 1]
        free = not nominal(rho_p) and not nominal(rho_q)
        return Line(
            p - 1j * u * side * moment_p * rho_p, self._touching(self.hand.tilt(u), key, free, p, rho_p, q, rho_q)
        )

    def _side(self, key: str) -> Reals:
        """On which side of the circles: −1 for somebody who takes the other tangent."""
        wrong = (hand for hand, slip in self.amended.wrong(None, key) if slip.mistake is Mistake.OTHER_TANGENT)
        return self.amended.altered(1.0, ((hand, -1.0) for hand in wrong))

    def _touching(self, taken: Points, key: str, free: bool, *inputs: Any) -> Points:
        return traced(taken, self.log(done.Touch(head=self.head(*inputs, key=key), along=spot(taken), free=free)))

    def image(self, of: tuple[Points, Points, Points], on: tuple[Points, Points]) -> Points:
        """The third corner of the similar figure on `on` that keeps the letter order of `of`."""
        missed = self.hand.carry(0.0) + 1j * self.hand.carry(0.0)
        at, other = similar(*of, *on) + missed, turned_over(*of, *on) + missed
        in_line = abs(spot(other - at)) < NO_LENGTH
        act = self.log(done.Image(head=self.head(of, on), at=spot(at), other=None if in_line else spot(other)))
        self._others |= dict.fromkeys(act, traced(other, act))
        return traced(at, act)

    def _led(self, slip: Slip, at: Points, along: Points) -> Points:
        """The direction of a ruled line by this mistake; as it is where the wrong centre has not been found yet."""
        if slip.mistake is Mistake.OTHER_CENTRE:
            other = None if self.here is None else self.ledger.spots.get((self.here, slip.instead))
            return along if other is None else unit(other - at)
        return 1j * along if slip.mistake is Mistake.TURNED else along

    def _wrongly(self, place: Place | None, key: str, vector: Points) -> Points:
        """A known vector as somebody takes it who makes a mistake with it."""
        if place is None:
            return vector
        taken = [(hand, self._taken(place, key, slip, vector)) for hand, slip in self.amended.wrong(place, key)]
        return self.amended.altered(vector, taken)

    def _taken(self, place: Place, key: str, slip: Slip, vector: Points) -> Points:
        """The vector by this mistake; one of its size was made already where the size was computed."""
        if slip.mistake in FACTOR and key in self._slipped:
            return vector
        if slip.mistake is Mistake.COINCIDENT:
            return self.ledger.spots.get((place, slip.instead), vector)
        scale, other = self.scale_of(place), self.scale_of(before(place, self.scales))
        return as_taken(slip.mistake, vector, scale.value / other.value)
