"""The centre-point curve of four positions, point by point from an opposite-pole quadrilateral (Burmester).

From a centre point M the line to the pole P_ij halves the angle B_i M B_j. So the opposite sides P12 P13 and P24 P34 of
the quadrilateral are seen from M under one angle γ (or its supplement): for every γ two circles, over these sides with
the central angle 2γ, meet in two points of the curve.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from itertools import chain, pairwise

import numpy as np
import numpy.typing as npt

from ....board.construction import View
from ....board.paper.marks import Dot, Role
from ....board.place import Pane
from ....plane import Line, Points, Reals, circles_meet, cross, nominal, unit
from ....words import Words
from ..draft import Draft
from .sheet import Sheet, Stands

ANGLES = 6000  # circles of each side tried, over 180°
APART, JOINED = 1.2, 4.0  # mm: how far apart points are plotted, and up to where they are joined
STILL, LEVEL = 1e-6, 1e-9  # mm: a point that stays where it is; sine of two bisectors that do not meet
CORNERS = ((0, 1), (0, 2), (1, 3), (2, 3))  # P12, P13, P24, P34


def centre_point_curve(sheet: Sheet, body: str, found: Mapping[str, Points]) -> None:
    """Poles, quadrilateral and curve in a figure of their own, with the centre points that were found on lines."""
    starts = [at.start for at in sheet.bodies[body]]
    sought = (_pole(sheet.draft, sheet.bodies[body], i, j) for i, j in CORNERS)
    poles = [pole for pole in sought if pole is not None]
    if len(poles) < len(CORNERS):
        return
    spots = [complex(nominal(pole)) for pole in poles]
    middle, window = _window([*starts, *found.values()])
    if max(abs(spot - middle) for spot in spots) > 2 * window:
        return  # poles off the sheet serve no drawing
    middle, window = _window([*starts, *found.values(), *spots])
    place = _opened(sheet.draft)
    for (i, j), pole in zip(CORNERS, poles, strict=True):
        sheet.draft.board.plot(place, pole, f"P_{{{i + 1}{j + 1}}}", Dot.POINT)
    for start, end in ((0, 1), (1, 3), (3, 2), (2, 0)):
        sheet.draft.board.join(place, poles[start], poles[end], Role.CONSTRUCTION)
    for branch in chain.from_iterable(_branches(sides) for sides in _both(spots)):
        inside = branch[abs(branch - middle) < 1.1 * window]
        for one, two in pairwise(_spaced(inside.tolist())):
            if abs(two - one) < JOINED:
                sheet.draft.board.join(place, np.complex128(one), np.complex128(two), Role.CENTRE)
    for letter, at in found.items():
        sheet.draft.board.plot(place, at, letter, Dot.JOINT)


def _opened(draft: Draft) -> Pane:
    board = draft.board
    place = board.open_pane(View.MECHANISM, "centre points", Words("圆心曲线", "The centre-point curve"))
    board.step(
        Words(
            "作极点 $P_{12}$、$P_{13}$、$P_{24}$、$P_{34}$，得对极四边形。过 $P_{12}P_{13}$ 和 $P_{24}P_{34}$ 作"
            "圆周角同为 $γ$ 的两圆，其交点是圆心曲线上的点；改变 $γ$，逐点描出曲线。所得圆心点都在此曲线上。",
            "The poles $P_{12}$, $P_{13}$, $P_{24}$, $P_{34}$ make an opposite-pole quadrilateral. Two circles, over "
            "$P_{12}P_{13}$ and over $P_{24}P_{34}$ with the same inscribed angle $γ$, meet at points of the "
            "centre-point curve; other angles $γ$ give it point by point. The centre points that were found lie on it.",
        ),
        place,
    )
    return place


def _pole(draft: Draft, stands: Sequence[Stands], i: int, j: int) -> Points | None:
    """Where the bisectors of two points of the body meet: of a third point, where those of its line fall on each
    other; none of two positions without a turn between them."""
    board, one, two = draft.board, stands[i], stands[j]
    aside = tuple(at.start + 1j * (at.end - at.start) for at in (one, two))
    drawn: list[Line] = []
    for a, b in ((one.start, two.start), (one.end, two.end), aside):
        if abs(complex(nominal(b - a))) < STILL:
            continue
        line = board.parallel((a + b) / 2, 1j * unit(b - a))
        if any(abs(float(nominal(cross(other.along, line.along)))) > LEVEL for other in drawn):
            return board.meet(drawn[0], line, Words(f"求 $P_{{{i + 1}{j + 1}}}$", f"finding $P_{{{i + 1}{j + 1}}}$"))
        drawn = [line]
    return None


def _window(spots: Sequence[Points]) -> tuple[complex, float]:
    """The middle of what stands there, and how far it reaches."""
    at = np.array([complex(nominal(spot)) for spot in spots])
    low, high = complex(at.real.min(), at.imag.min()), complex(at.real.max(), at.imag.max())
    middle = (low + high) / 2
    return middle, float(np.abs(at - middle).max())


def _both(poles: Sequence[complex]) -> tuple[tuple[complex, ...], ...]:
    """Both pairs of opposite sides: where one is seen under angles that change too fast, the other is not."""
    p12, p13, p24, p34 = poles
    return (p12, p13, p24, p34), (p12, p24, p13, p34)


def _branches(poles: Sequence[complex]) -> Iterator[npt.NDArray[np.complex128]]:
    """The first meetings for every angle γ, and the second ones; NaN where there are none."""
    gammas = np.pi * (np.arange(ANGLES) + 0.5) / ANGLES
    return (np.asarray(branch) for branch in meetings(poles, gammas))


def _spaced(spots: Iterable[complex]) -> Iterator[complex]:
    """Every point that is far enough from the one before."""
    last: complex | None = None
    for at in spots:
        if last is None or abs(at - last) >= APART:
            last = at
            yield at


def meetings(poles: Sequence[complex], gamma: Reals) -> tuple[Points, Points]:
    """Where the circles over two opposite sides with the inscribed angles γ meet; NaN where they do not."""
    turn = np.exp(2j * gamma)
    a, b, c, d = poles
    one, two = (b - a * turn) / (1 - turn), (d - c * turn) / (1 - turn)
    return circles_meet(one, np.abs(a - one), two, np.abs(c - two))
