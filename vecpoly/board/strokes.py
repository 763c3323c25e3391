"""The acts that leave ink: letters, lines, vectors, arcs, right angles, tints."""

from __future__ import annotations

from collections.abc import Sequence
from math import tau

import numpy as np

from ..names import ascii_key
from ..plane import Line, Points, Reals, nominal
from ..plane.derived import Derived
from ..plane.traced import Acts
from ..words import Words
from . import acts as done
from .ledger import Stood
from .log import Log
from .paper.marks import Dot, Role
from .place import Place, View, view_of

OVERRUN = 6.0  # mm a ruled line runs past its meeting point
NO_ARROW = 1e-6  # mm: shorter vectors are not drawn
NO_LENGTH = 1e-9  # mm: points nearer than this are one point, and have no direction to each other


def spot(at: Points) -> complex:
    """The point on the nominal sheet; on a recorded one it still knows how it was computed."""
    found = nominal(at)
    return found if type(found) is Derived else complex(found)  # type: ignore[return-value]


def amount(value: Reals) -> float:
    """The length, or the number, on the nominal sheet; on a recorded one it still knows how it was computed."""
    found = nominal(value)
    return found if type(found) is Derived else float(found)  # type: ignore[return-value]


class Strokes(Log):
    """The pen."""

    def plot(self, view: Place, at: Points, label: str, dot: Dot = Dot.POINT, *, key: str = "") -> None:
        """Letter a point; key: where the letter is that of a quantity."""
        self.log(done.Plot(head=self.head(at, on=view, key=key), at=spot(at), label=label, dot=dot))

    def join(self, view: Place, a: Points, b: Points, role: Role, *, key: str = "") -> None:
        """Rule a line from a to b; key: of the quantity that acts along it."""
        self.log(done.Join(head=self.head(a, b, on=view, key=key), a=spot(a), b=spot(b), role=role))

    def arrow(self, view: Place, a: Points, b: Points, role: Role, *, key: str = "", label: str = "") -> Acts:
        """Draw the vector `key` (by default that of its label) from a to b; one without length leaves no ink. Gives
        what is to be known by whatever follows from the arrow."""
        shown = bool(abs(spot(b) - spot(a)) > NO_ARROW)
        return self._arrow(view, a, b, role, key or ascii_key(label), label, shown)

    def arrow_once(self, view: Place, a: Points, b: Points, *, key: str = "") -> None:
        """Draw the result vector from a to b unless a vector stands there already."""
        start, end = spot(a), spot(b)
        shown = bool(abs(end - start) > NO_ARROW) and not self.stands(view, start, end)
        self._arrow(view, a, b, Role.RESULT, key, "", shown)

    def stands(self, view: Place, start: complex, end: complex) -> bool:
        """Whether a vector stands there already."""
        return self._ends[view].has(start, end)

    def letters_at(self, view: Place, at: complex) -> tuple[str, ...]:
        """The letters of a place so far, in the order in which they were given."""
        return tuple(one.label for one in self._letters[view] if abs(one.at - at) < NO_ARROW)

    def lettered(self, view: View, *, besides: Place | None = None) -> frozenset[str]:
        """The letters of the points on all figures of a kind, or on all but one."""
        places = [place for place in self._letters if place != besides and view_of(place) is view]
        return frozenset(one.label for place in places for one in self._letters[place])

    def _arrow(self, view: Place, a: Points, b: Points, role: Role, key: str, label: str, shown: bool) -> Acts:
        head = self.head(a, b, on=view, key=key)
        drawn = self.log(done.Arrow(head=head, a=spot(a), b=spot(b), role=role, label=label, shown=shown))
        if key:
            self.ledger.vectors[view, key] = Stood(a, b)
        return drawn

    def right_angle(self, view: Place, at: Points, u: Points, v: Points) -> None:
        """Mark a right angle."""
        self.log(done.Corner(head=self.head(at, u, v, on=view), at=spot(at), u=spot(u), v=spot(v)))

    def rule(self, view: Place, line: Line, to: Points, label: str = "", said: Words | None = None) -> None:
        """Leave a direction line on the paper, from its start to a little past `to`, as a ruler leaves it; label, or in
        words said: its direction."""
        start, end = spot(line.at), spot(to)
        along = spot(line.along)
        past = along if abs(end - start) < NO_LENGTH else (end - start) / abs(end - start)
        back = 0.0 if abs(end - start) > 2 * OVERRUN else OVERRUN
        a, b = start - past * back, end + past * OVERRUN
        self.log(done.Rule(head=self.head(line, to, on=view), a=a, b=b, label=label, said=said))

    def swing(self, view: Place, centre: Points, radius: Reals, through: Points) -> None:
        """Leave the short compass arc about a centre near the point it passes."""
        c, p = spot(centre), spot(through)
        far = amount(radius)
        half = min(0.5, 7.0 / max(far, 1e-6))
        start = amount(np.angle(p - c)) - half
        self.log(
            done.Swing(
                head=self.head(centre, radius, through, on=view), centre=c, radius=far, start=start, sweep=2 * half
            )
        )

    def circle(
        self,
        view: Place,
        centre: Points,
        radius: Reals,
        role: Role = Role.CONSTRUCTION,
        *,
        start: float = 0.0,
        sweep: float = tau,
    ) -> None:
        """Leave a whole circle, or a part of it: from angle `start` over `sweep` (rad)."""
        head, far = self.head(centre, radius, on=view), amount(radius)
        self.log(done.Swing(head=head, centre=spot(centre), radius=far, start=start, sweep=sweep, role=role))

    def curve(self, view: Place, points: Sequence[Points], role: Role) -> None:
        """Lead a smooth curve through points."""
        head = self.head(tuple(points), on=view)
        self.log(done.Curve(head=head, points=tuple(spot(p) for p in points), role=role))

    def angle(
        self, view: Place, at: Points, start: Points, sweep: Reals, radius: float, label: str, *, key: str = ""
    ) -> None:
        """Mark an angle with its symbol: from the direction `start` over `sweep` (rad); key: where the label is more
        than the symbol."""
        head, first = self.head(at, start, sweep, on=view, key=key or ascii_key(label)), amount(np.angle(start))
        self.log(done.Angle(head=head, at=spot(at), radius=radius, start=first, sweep=amount(sweep), label=label))

    def curved_arrow(self, view: Place, at: Points, radius: float, start: float, ccw: bool, label: str) -> None:
        """Draw ω, or a moment, as a curved arrow about a point that begins in the direction `start` (rad)."""
        head = self.head(at, on=view, key=ascii_key(label))
        self.log(done.CurvedArrow(head=head, at=spot(at), radius=radius, start=start, ccw=ccw, label=label))

    def note(self, view: Place, at: Points, words: Words, side: complex = 0j) -> None:
        """Write a short note beside a point, on any side of it or on this one."""
        self.log(done.Annotate(head=self.head(at, on=view), at=spot(at), words=words, side=side))

    def hatch(self, view: Place, outline: Sequence[Points], *, rising: bool) -> None:
        """Hatch an area: a surplus with lines that rise to the right, a deficit with lines that fall."""
        head = self.head(tuple(outline), on=view)
        self.log(done.Hatch(head=head, points=tuple(spot(p) for p in outline), rising=rising))

    def tint(self, view: Place, points: tuple[Points, ...]) -> None:
        """Tint the image of a link."""
        self.log(done.Tint(head=self.head(points, on=view), points=tuple(spot(p) for p in points)))
