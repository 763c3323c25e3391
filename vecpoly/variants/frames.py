"""The frames of the printed sheet, of one size whatever the answer is, and scales with which a figure stays inside."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from ..board.construction import Construction, Figure
from ..board.paper.extent import corners, figured
from ..board.paper.scales import HALF, SERIES, round_up
from ..figures import View
from ..foundation.slotted import replace
from ..problem.problem import Problem

WIDTH, HEIGHT = 160.0, 150.0  # mm
JITTER = 8.0  # mm that a pole stands off the middle of its frame, at most
CLEAR = 6.0  # mm that stay free inside the frame
CLOSE = 3.0  # mm that stay free beside a figure whose scale was not chosen for it
ROOM = WIDTH / 2 - JITTER - CLEAR, HEIGHT / 2 - JITTER - CLEAR  # mm on each side of a pole
POLED = (View.VELOCITY, View.ACCELERATION)
LENGTHS = tuple(sorted((*SERIES, HALF)))  # 1 : 1.5 among them, where a mechanism would be small at 1 : 2
FRAMED = (View.MECHANISM, *POLED, View.FORCE)


def filled(figure: Figure) -> float:
    """How much of its frame a figure takes, in the direction in which it takes more: above 1 it leaves the frame."""
    points = [p for mark in figured(figure.marks) for p in corners(mark)]
    if not points:
        return 0.0
    if figure.view in POLED:
        return max(float(max(abs(p.real) / ROOM[0], abs(p.imag) / ROOM[1])) for p in points)
    wide, high = (max(parts) - min(parts) for parts in zip(*((p.real, p.imag) for p in points), strict=True))
    return max(float(wide) / (WIDTH - 2 * CLEAR), float(high) / (HEIGHT - 2 * CLEAR))


def scaled(problem: Problem, drawn: Construction) -> Problem | None:
    """The problem with round scales at which every figure fits its frame; None where one that is given does not."""
    scales = problem.scales
    for view in FRAMED:
        figures = [one for one in drawn.figures if one.view is view and not one.aside and one.scale.symbol]
        if not figures:
            continue
        least = max(filled(one) * one.scale.value for one in figures)  # each may have been drawn to a scale of its own
        if (given := problem.scales.of(view.mu)) is not None:
            if least > given * (1 + 1e-9):
                return None
        elif least > 0:
            scales = scales.changed(view.mu, round_up(least, LENGTHS if view is View.MECHANISM else SERIES))
    return replace(problem, scales=scales)


def on_sheet(figures: Iterable[Figure]) -> tuple[Figure, ...]:
    """The figures that get a frame on the question sheet: those whose scales were chosen for it, others if they fit; no
    sketch, which has no scale."""
    drawn = (figure for figure in figures if not figure.aside and figure.scale.symbol)
    return tuple(figure for figure in drawn if figure.view in FRAMED or _fits(figure))


def _fits(figure: Figure) -> bool:
    larger = min((side - 2 * CLOSE) / (side - 2 * CLEAR) for side in (WIDTH, HEIGHT))
    return figure.view is not View.BODY and filled(figure) <= larger


def beside_sheet(figures: Sequence[Figure]) -> tuple[Figure, ...]:
    """The diagrams to scale that are too large for a frame: they are drawn where the work is done."""
    framed = on_sheet(figures)
    drawn = (one for one in figures if not one.aside and one.scale.symbol and one.view is not View.BODY)
    return tuple(one for one in drawn if not any(one is other for other in framed))
