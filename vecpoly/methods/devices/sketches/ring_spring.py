"""The sketch of a ring-spring buffer, and its wedges drawn apart."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ....board.construction import Place, View
from ....plane import Line, Points, lines_meet, nominal
from ..bench import Bench
from ..inclined import Press, between, body, concur, numbered, press, pull, ray

# mm: length of a face; upright ends; half the gap between the side wedges at the middle
REACH, WALL, GAP = 24.0, 6.0, 5.0
BELOW = 2.0  # mm that wedge 1 reaches past the side wedges, down and inwards at most: wedge 4 comes up as far


@dataclass(frozen=True, slots=True)
class Faces:
    """Directions as drawn, of the faces of the right side wedge 2; those of wedge 3 are their mirror images.

    over, under: normals into 2 of the faces that 1 and 4 press on;
    slides_over, slides_under: the sliding of 2 on 1 and on 4 while it moves out.
    """

    over: Points
    under: Points
    slides_over: Points
    slides_under: Points

    @property
    def two(self) -> tuple[Points, ...]:
        """Corners of wedge 2: inner above, outer above, outer below, inner below."""
        rise = self.slides_over * REACH
        return GAP + 0j, GAP + rise, GAP + np.conj(rise) - WALL * 1j, GAP - WALL * 1j

    @property
    def one(self) -> tuple[Points, ...]:
        """Corners of wedge 1: bottom right, right end of the face, the top, and so back on the left."""
        rise = self.slides_over * REACH
        along = self.slides_over / max(self.slides_over.real, self.slides_over.imag)
        foot, end = GAP - BELOW * along, GAP + rise
        top = complex(end.real, end.imag + WALL)
        return foot, end, top, _mirror(top), _mirror(end), _mirror(foot)


def faces(alpha: float) -> Faces:
    """Draw the directions from the given angle of the normals with F, which is upright."""
    out = np.exp(1j * alpha)
    return Faces(over=-1j * out, under=np.conj(-1j * out), slides_over=out, slides_under=np.conj(out))


def _mirror(p: Points) -> Points:
    return -np.conj(p)


def sketch(bench: Bench, it: Faces) -> None:
    """All four bodies, F, Q on both sides, the angle α."""
    view = View.MECHANISM
    below = tuple(np.conj(p) - WALL * 1j for p in it.one)
    body(bench, view, "link 1", *it.one)
    body(bench, view, "link 4", *below, fixed=True)
    body(bench, view, "link 2", *it.two)
    body(bench, view, "link 3", *(_mirror(p) for p in it.two))
    pull(bench, view, it.one[2].imag * 1j, -1j, "F")
    side = complex(it.two[1].real, -WALL / 2)
    pull(bench, view, side, -1 + 0j, "Q")
    pull(bench, view, _mirror(side), 1 + 0j, "Q")
    at = it.two[1]
    free = min(20.0, 0.75 * float(nominal(at.real)) / float(nominal(it.over.real)))  # short of the arrow of F
    ray(bench, view, at, -it.over, free, "n")
    ray(bench, view, at, 1j, free)
    between(bench, view, at, -it.over, 1j, 0.7 * free, "α")
    two = sum(it.two) / 4
    numbered(
        bench,
        view,
        (it.one[2].imag * 0.62j, "1"),
        (two + 2, "2"),
        (_mirror(two + 2), "3"),
        (it.one[2].real + 4 + (below[2].imag + 4) * 1j, "4"),
    )


def apart_two(bench: Bench, place: Place, it: Faces, r12: Points, r42: Points) -> None:
    """The side wedge 2 under Q, R_12 and R_42, whose lines meet in one point."""
    body(bench, place, "link 2", *it.two)
    outer = complex(nominal(it.two[1].real), -WALL / 2)
    middle = Line(outer, 1 + 0j)
    over = it.two[0] + it.slides_over * REACH * 0.5
    meeting = lines_meet(Line(over, r12), middle)
    under = lines_meet(Line(meeting, r42), Line(it.two[3], it.slides_under))
    press(
        bench, place, Press(symbol="R_{12}", at=over, normal=it.over, along=r12, slides=it.slides_over, speed="v_{21}")
    )
    press(
        bench,
        place,
        Press(symbol="R_{42}", at=under, normal=it.under, along=r42, slides=it.slides_under, speed="v_{24}"),
    )
    pull(bench, place, outer, -1 + 0j, "Q")
    concur(bench, place, meeting, over, under, outer)


def apart_one(bench: Bench, place: Place, it: Faces, r21: Points) -> None:
    """Wedge 1 under F, R_21 and R_31, whose lines meet on the axis."""
    body(bench, place, "link 1", *it.one)
    right = it.two[0] + it.slides_over * REACH * 0.5
    meeting = lines_meet(Line(right, r21), Line(0j, 1j))
    press(
        bench,
        place,
        Press(symbol="R_{21}", at=right, normal=-it.over, along=r21, slides=-it.slides_over, speed="v_{12}"),
    )
    press(
        bench,
        place,
        Press(
            symbol="R_{31}",
            at=_mirror(right),
            normal=_mirror(-it.over),
            along=_mirror(r21),
            slides=_mirror(-it.slides_over),
            speed="v_{13}",
        ),
    )
    pull(bench, place, it.one[2].imag * 1j, -1j, "F")
    concur(bench, place, meeting, right, _mirror(right), it.one[2].imag * 1j)
