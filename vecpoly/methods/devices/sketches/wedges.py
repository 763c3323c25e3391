"""The sketch of a wedge pair: both wedges, their guides, the angles; and each wedge drawn apart."""

from __future__ import annotations

from dataclasses import dataclass
from math import pi

import numpy as np

from ....board.construction import Place, View
from ....board.paper.marks import Role
from ....devices.wedges import Wedges
from ....foundation.slotted import replace
from ....plane import Line, Points, dot, lines_meet, nominal
from ..bench import Bench
from ..inclined import Press, body, concur, numbered, press, pull

HALF, TALL, THICK = 15.0, 24.0, 6.0  # mm: half of the face between the wedges; wedge 2 over it; hatched bodies
TOE, STEM = (
    5.0,
    20.0,
)  # mm: thickness of wedge 1 at its thin end; its stem, where the upper side of the guide holds it down
RAY, ARC = 15.0, 9.0


@dataclass(frozen=True, slots=True)
class Shapes:
    """The wedges as drawn, to no scale: the middle of the face between them is the origin.

    face: unit vector up along that face; guide: along the guide of wedge 1; one, two: corners (1: thin end, thick end,
    [stem above,] below, thin end; 2: left, right, right top, left top); held:
    whether the upper side of the guide holds wedge 1 down.
    """

    face: Points
    guide: Points
    one: tuple[Points, ...]
    two: tuple[Points, ...]
    held: bool

    @property
    def back(self) -> Points:
        """The middle of the end of wedge 1 on which F presses."""
        return (self.one[-3] + self.one[-2]) / 2

    @property
    def normal(self) -> Points:
        """Of the face between the wedges, from 1 into 2."""
        return -1j * self.face


def shapes(alpha: float, beta: float, held: bool) -> Shapes:
    """Draw the directions from the given angles, and fit bodies to them."""
    face, guide = 1j * np.exp(1j * beta), np.exp(1j * (pi / 2 - alpha))
    thin, thick = -face * HALF, face * (HALF + 10.0)
    base = Line(thin - 1j * guide * TOE, guide)
    low = base.at + guide * dot(guide, thick - base.at)
    one = (thin, thick, thick - guide * STEM, low - guide * STEM, base.at) if held else (thin, thick, low, base.at)
    left, right = face * HALF, -face * HALF
    top = 1j * (left.imag + TALL)
    return Shapes(face, guide, one, (left, right, right.real + top, left.real + top), held)


def sketch(bench: Bench, device: Wedges, it: Shapes) -> None:
    """Both wedges in their guides, F and Q, the angles α and β."""
    view = View.MECHANISM
    left, right, above, beside = it.two
    body(bench, view, "link 2", *it.two)
    body(bench, view, "link 1", *it.one)
    low, thin = it.one[-2] - it.guide * 8, it.one[-1] + it.guide * 6
    _rail(bench, low, thin, -1j * it.guide)
    _rail(bench, right + 5j, complex(right.real, above.imag - 4), 1 + 0j)
    _rail(bench, left + 9j, complex(left.real, above.imag - 4), -1 + 0j)
    if it.held:
        _rail(bench, it.one[2], it.one[1] - it.guide * 4, 1j * it.guide)
    pull(bench, view, it.back, it.guide, "F")
    pull(bench, view, (above + beside) / 2, -1j, "Q")
    _angle(bench, view, it.one[1], it.face, 1j, "β")
    _angle(bench, view, low, -it.guide, -1j, "α")
    numbered(
        bench,
        view,
        (sum(it.one[:2] + it.one[-2:]) / 4, "1"),
        (sum(it.two) / 4, "2"),
        ((low + thin) / 2 - 1j * it.guide * (THICK + 2), "3"),
    )


def _rail(bench: Bench, start: Points, end: Points, behind: Points) -> None:
    """A side of a fixed guide, its hatched body lying `behind` it."""
    corners = (start, end, end + behind * THICK, start + behind * THICK)
    body(bench, View.MECHANISM, "link 3", *corners, fixed=True)


def _angle(bench: Bench, view: View, at: Points, ray: Points, upright: Points, label: str) -> None:
    for side in (ray, upright):
        bench.board.join(view, at, at + side * RAY, Role.CENTRE)
    bench.board.angle(view, at, upright, np.angle(ray / upright), ARC, label)


def apart_two(bench: Bench, place: Place, it: Shapes, r12: Press, r32: Press) -> None:
    """Wedge 2 by itself under Q, R_12 and R_32, whose lines meet in one point."""
    body(bench, place, "link 2", *it.two)
    foot = it.face * HALF * 0.2
    meeting = foot + r12.along * TALL * 0.4
    wall = it.two[1] if nominal(r32.normal.real) < 0 else it.two[0]
    side = lines_meet(Line(meeting, r32.along), Line(wall, 1j))
    top = complex(meeting.real, it.two[2].imag)
    press(bench, place, replace(r12, at=foot))
    press(bench, place, replace(r32, at=side))
    pull(bench, place, top, -1j, "Q")
    concur(bench, place, meeting, foot, side, top)


def apart_one(bench: Bench, place: Place, it: Shapes, r21: Press, r31: Press) -> None:
    """Wedge 1 by itself under F, R_21 and R_31, whose lines meet where the guide's lower side carries it."""
    body(bench, place, "link 1", *it.one)
    foot = it.face * 4.0
    meeting = lines_meet(Line(it.back, it.guide), Line(foot, r21.along))
    above = float(nominal(dot(1j * it.guide, r31.normal))) < 0
    side = (it.one[1] + it.one[2]) / 2 if above else lines_meet(Line(meeting, r31.along), Line(it.one[-1], it.guide))
    press(bench, place, replace(r21, at=foot))
    press(bench, place, replace(r31, at=side))
    pull(bench, place, it.back, it.guide, "F")
    if not above:
        concur(bench, place, meeting, foot, side, it.back)
