"""The three precision points of a function by Chebyshev's spacing: a semicircle over the range, divided in three."""

from __future__ import annotations

from math import pi

import numpy as np

from ....algebra.quantity import magnitude
from ....algebra.worked import stated
from ....board.construction import Scale, View
from ....board.paper.marks import Dot, Role
from ....board.place import Pane
from ....designs.generator.function_generator import FunctionGenerator
from ....plane import Line, Reals, foot
from ....plane.traced import acts_of, traced
from ....words import Words
from ..draft import Draft

ACROSS = 100.0  # mm: the range of x on paper
Pair = tuple[Reals, Reals]


def precision_pairs(draft: Draft, design: FunctionGenerator) -> tuple[Pair, ...]:
    """φ and ψ (rad) at the three precision points, x as read off the semicircle."""
    assert design.x is not None
    board = draft.board
    board.section(Words("精确点", "The precision points"))
    span = design.x[1].si - design.x[0].si
    across = Scale(symbol="μ_x", value=abs(span) / ACROSS, unit="")
    place = board.open_pane(View.MECHANISM, "precision points", Words("精确点", "Precision points"), across, aside=True)
    board.step(_TOLD, place)
    shares = [mm / ACROSS for mm in _feet(draft, place)]
    pairs = []
    for n, share in enumerate(shares, 1):
        pair, x = design.angles_at(share), design.x_at(share)
        for symbol, value, unit in (
            (f"x_{n}", x, ""),
            (f"y_{n}", design.y(x), ""),
            (f"φ_{n}", np.degrees(pair[0]), "deg"),
            (f"ψ_{n}", np.degrees(pair[1]), "deg"),
        ):
            board.write(stated(magnitude(symbol, value, unit)))
        pairs.append((pair[0], traced(pair[1], acts_of(share))))  # the formula forgets what it is worked out from
    return tuple(pairs)


_TOLD = Words(
    "以自变量 $x$ 的范围 $x_0$ 至 $x_4$ 为直径作半圆，将其六等分，过第一、三、五分点作直径的垂线，垂足即切比雪夫精确点 "
    "$x_1$、$x_2$、$x_3$。量其位置，算出 $y$，再按比例换算成 $φ$、$ψ$：",
    "On the range of $x$, from $x_0$ to $x_4$, as the diameter draw a semicircle and divide it into six equal parts. "
    "The perpendiculars through the first, third and fifth division meet the diameter in Chebyshev's precision points "
    "$x_1$, $x_2$, $x_3$. Read where they lie, compute $y$, and go over to $φ$ and $ψ$ in proportion:",
)


def _feet(draft: Draft, place: Pane) -> list[Reals]:
    """How far the three points are from the beginning (mm)."""
    board = draft.board
    start, centre, end = (np.complex128(at) for at in (0.0, ACROSS / 2, ACROSS))
    board.join(place, start, end, Role.GIVEN)
    board.circle(place, centre, ACROSS / 2, sweep=pi)
    for at, letter in ((start, "x_0"), (end, "x_4")):
        board.plot(place, at, letter, Dot.POINT)
    found = []
    for n in (1, 2, 3):
        ray = board.ray(centre, 1 + 0j, pi - (2 * n - 1) * pi / 6)
        on_arc = board.lay_off(centre, ray.along, ACROSS / 2)
        below = foot(Line(start, np.complex128(1)), on_arc)
        board.join(place, centre, on_arc, Role.CONSTRUCTION)
        board.join(place, on_arc, below, Role.CONSTRUCTION)
        board.plot(place, below, f"x_{n}", Dot.POINT)
        found.append(board.measure(start, below, f"x_0 x_{n}").value)
    return found
