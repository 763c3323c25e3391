"""The frames of the printed sheet, of one size whatever the answer is, and scales with which a figure stays inside."""

from __future__ import annotations

from collections.abc import Iterable

from ..board.construction import Construction, Figure
from ..board.paper.extent import corners, figured
from ..board.paper.scales import round_up
from ..figures import View
from ..foundation.slotted import replace
from ..problem.problem import Problem

WIDTH, HEIGHT = 160.0, 150.0  # mm
JITTER = 8.0  # mm that a pole stands off the middle of its frame, at most
CLEAR = 6.0  # mm that stay free inside the frame
ROOM = WIDTH / 2 - JITTER - CLEAR, HEIGHT / 2 - JITTER - CLEAR  # mm on each side of a pole
POLED = (View.VELOCITY, View.ACCELERATION)
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
        fullest = max(figures, key=filled)
        if (given := problem.scales.of(view.mu)) is not None:
            if filled(fullest) * fullest.scale.value > given * (1 + 1e-9):
                return None
        elif filled(fullest) > 0:
            scales = scales.changed(view.mu, round_up(fullest.scale.value * filled(fullest)))
    return replace(problem, scales=scales)


def on_sheet(figures: Iterable[Figure]) -> tuple[Figure, ...]:
    """The figures that get a frame on the question sheet: those whose scales were chosen for it, others if they fit; no
    sketch, which has no scale."""
    drawn = (figure for figure in figures if not figure.aside and figure.scale.symbol)
    return tuple(figure for figure in drawn if figure.view in FRAMED or _fits(figure))


def _fits(figure: Figure) -> bool:
    return figure.view is not View.BODY and filled(figure) <= 1
