"""Constructions of a few strokes that methods of synthesis are made of: circles, bisectors, rays at a given angle."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from math import pi, radians, tau

import numpy as np

from ..plane import Line, Points, Reals, nominal, unit
from ..plane.traced import traced
from ..words import Words
from . import acts as done
from .instruments import Instruments
from .otherwise.amended import plain_letters
from .otherwise.slip import Mistake
from .place import Place
from .strokes import amount, spot

WIDER = 0.62  # of a segment: radius of the equal arcs about its ends that bisect it
JOINED = radians(100)  # nearer meetings of a circle lie on one arc
PAST = 7.0  # mm beyond its last meeting
TOUCHED, FAR = radians(45), 15.0  # on either side of a single one, but no farther than so (mm)


class Compass(Instruments):
    """Compass and protractor in a hand."""

    def arc(self, view: Place, centre: Points, radius: Reals, start: Points, end: Points) -> None:
        """Leave a compass arc from one point to another, counter-clockwise."""
        head = self.head(centre, radius, start, end, on=view)
        first, sweep = amount(np.angle(start - centre)), amount(np.angle((end - centre) / (start - centre)))
        self.log(done.Swing(head=head, centre=spot(centre), radius=amount(radius), start=first, sweep=sweep % (2 * pi)))

    def arcs_past(self, view: Place, centre: Points, radius: Reals, *at: Points) -> None:
        """Leave of a circle what is needed to see its meetings: an arc past those that are near each other, a wider one
        about a single point, where it is touched."""
        middle, far = spot(centre), amount(radius)
        if not float(far):  # by somebody's mistake: there is no circle
            return
        beyond = min((FAR if len(at) == 1 else PAST) / max(float(far), PAST), TOUCHED)
        for first, last in _near(at, complex(middle)):
            start, end = spot(first) - middle, spot(last) - middle
            sweep = 0.0 if first is last else amount(np.angle(end / start)) % tau
            head, begin = self.head(centre, radius, first, last, on=view), amount(np.angle(start)) - beyond
            whole = float(sweep) + 2 * beyond >= tau
            over = tau if whole else sweep + 2 * beyond
            self.log(done.Swing(head=head, centre=middle, radius=far, start=begin, sweep=over))

    def bisector(self, view: Place, a: Points, b: Points) -> Line:
        """The perpendicular bisector of a segment, by equal arcs about both ends; it is ruled through both meetings."""
        radius = WIDER * np.abs(b - a)
        one, other = self.arcs(a, radius, b, radius, Words("作中垂线", "the perpendicular bisector"))
        for centre in (a, b):
            for end in (one, other):
                self.swing(view, centre, radius, end)
        self.rule(view, Line(one, unit(other - one)), other)
        return Line(other, unit(one - other))

    def either(self, at: Points) -> Points:
        """One of two meetings that are mirror images of each other: to take the other one is no mistake."""
        return traced(at, self.log(done.Meet(head=self.head(at), at=spot(at))))

    def ray(self, at: Points, base: Points, angle: Reals, *, key: str = "") -> Line:
        """A ray at an angle (rad, counter-clockwise) from a drawn direction, by protractor."""
        angle = self._set_out(angle, key)
        along = self.hand.tilt(base * np.exp(1j * angle))
        act = self.log(done.Ray(head=self.head(at, base, angle, key=key), at=spot(at), along=spot(along)))
        return Line(traced(at, act), traced(along, act))

    def _set_out(self, angle: Reals, key: str) -> Reals:
        """The angle as it is set out, by somebody's mistake too."""
        wrong = self.amended.wrong(self.here, key)
        return self.amended.altered(angle, ((hand, _misread(slip.mistake, angle)) for hand, slip in wrong))

    def leaned(self, normal: Points, angle: Reals, *, key: str) -> Points:
        """A direction that leans from another by a known angle (rad): from a normal by that of friction, of the
        reaction of this key."""
        along = normal * np.exp(1j * self._set_out(angle, key))
        act = done.Ray(head=self.head(normal, key=key), at=0j, along=spot(along), known=True)
        return traced(along, self.log(act))

    def judged(self, view: Place, letter: str, *, crosses: bool) -> Reals:
        """What two lines do at a lettered point: −1 where they cross, so that what follows has the other sign; 1 where
        they only touch."""
        key = plain_letters(letter)
        counted = (hand for hand, slip in self.amended.wrong(view, key) if slip.mistake is Mistake.COUNTED)
        taken = self.amended.altered(-1.0 if crosses else 1.0, ((hand, -1.0) for hand in counted))
        return self.gave(taken, done.Judge(head=self.head(on=view, key=key), crosses=amount(taken) < 0))

    def inverted(self, back: Points, forwards: Callable[[], Points], *, key: str) -> Points:
        """A point of a figure that is turned back with its link; forwards: where somebody has it who carries it on."""
        wrong = [hand for hand, slip in self.amended.wrong(self.here, key) if slip.mistake is Mistake.FORWARDS]
        at = self.amended.altered(back, ((hand, forwards()) for hand in wrong))
        return traced(at, self.log(done.Invert(head=self.head(at, key=key), at=spot(at))))


def _near(points: Sequence[Points], centre: complex) -> Iterator[tuple[Points, Points]]:
    """The first and the last of every row of points on a circle, counter-clockwise, that are near each other."""
    ordered = sorted(points, key=lambda at: _way(at, centre))
    ways = [_way(at, centre) for at in ordered]
    gaps = [(way - before) % tau for before, way in zip((ways[-1], *ways[:-1]), ways, strict=True)]
    gaps = gaps if len(gaps) > 1 else [tau]
    heads = [n for n, gap in enumerate(gaps) if gap > JOINED] or [max(range(len(gaps)), key=gaps.__getitem__)]
    for head, after in zip(heads, (*heads[1:], heads[0] + len(ordered)), strict=True):
        yield ordered[head], ordered[(after - 1) % len(ordered)]


def _way(at: Points, centre: complex) -> float:
    """In which direction from the centre it lies, on the nominal sheet."""
    return float(np.angle(complex(nominal(at)) - centre))


def _misread(mistake: Mistake, angle: Reals) -> Reals:
    """The angle as somebody sets it out who takes its complement, or the other side."""
    if mistake is Mistake.COMPLEMENT:
        return (pi / 2 if float(nominal(angle)) > 0 else -pi / 2) - angle
    return -angle if mistake is Mistake.OTHER_SIDE else angle
