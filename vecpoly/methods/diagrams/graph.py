"""A curve on a diagram, drawn from place to place of a table: its corners as every hand has them."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise

from ...board.board import Board
from ...board.construction import Place
from ...board.paper.marks import Dot, Role
from ...plane import Line, Points, Reals, nominal, unit

SAME = 1e-9  # mm to the right: corners nearer than this stand over each other


def _up(corner: Points) -> float:
    return complex(nominal(corner)).imag


@dataclass(frozen=True, slots=True, kw_only=True)
class Graph:
    """The corners, from left to right, and how far to the right each was set out (mm), two alike where it jumps."""

    corners: tuple[Points, ...]
    xs: tuple[float, ...]

    @property
    def ys(self) -> tuple[float, ...]:
        """How high each stands on the nominal sheet (mm)."""
        return tuple(map(_up, self.corners))

    def stretch(self, x: float, *, before: bool) -> int:
        """The number of the corner from which it runs on over a place; at a corner the one before it, or behind."""
        xs = self.xs
        pieces = [i for i, (a, b) in enumerate(pairwise(xs)) if b > a + SAME]
        over = [
            i
            for i in pieces
            if (xs[i] + SAME < x <= xs[i + 1] + SAME if before else xs[i] - SAME <= x < xs[i + 1] - SAME)
        ]
        return over[0] if over else pieces[0 if x <= xs[pieces[0]] else -1]

    def height(self, x: float, *, before: bool) -> float:
        """How high it stands there (mm)."""
        i = self.stretch(x, before=before)
        (a, b), (u, v) = self.xs[i : i + 2], map(_up, self.corners[i : i + 2])
        return u + (v - u) * (x - a) / (b - a)

    def line(self, i: int) -> Line:
        """The ruled line from a corner to the next."""
        a, b = self.corners[i], self.corners[i + 1]
        return Line(a, unit(b - a))

    def jump(self, x: float) -> int | None:
        """The number of the corner at the beginning of a jump that stands there."""
        return next(
            (i for i, (a, b) in enumerate(pairwise(self.xs)) if abs(a - x) <= SAME and abs(b - x) <= SAME), None
        )


def plotted(board: Board, place: Place, rows: Sequence[tuple[float, Reals]]) -> Graph:
    """The corners laid off: to the right by μ_φ, upwards by μ_M (SI)."""
    corners = []
    for across, up in rows:
        foot = board.lay_off(0j, 1 + 0j, board.to_paper_across(place, across))
        corners.append(board.lay_off(foot, 1j, board.to_paper(place, up)))
    return Graph(corners=tuple(corners), xs=tuple(across / board.scale_of(place).right.value for across, _ in rows))


def level(board: Board, wide: float, height: Points) -> Graph:
    """A line at one height, from a point of the left axis so far to the right (mm)."""
    line = board.parallel(height, 1 + 0j)
    return Graph(corners=(line.at, line.at + line.along * wide), xs=(0.0, wide))


def trace(board: Board, place: Place, graph: Graph, role: Role = Role.RESULT) -> None:
    """Join the corners."""
    for a, b in pairwise(graph.corners):
        board.join(place, a, b, role)


def name_curve(board: Board, place: Place, graph: Graph, symbol: str) -> None:
    """Its name, beside the middle of what is highest of it."""
    highest = max(range(len(graph.ys)), key=lambda n: abs(graph.ys[n]))
    a, b = (graph.corners[min(n, len(graph.ys) - 1)] for n in (highest, highest + 1))
    board.plot(place, (a + b) / 2, symbol, Dot.NONE)


def axis(graph: Graph) -> Graph:
    """The axis below a curve, or above it."""
    return Graph(corners=(0j, graph.corners[-1].real + 0j), xs=(0.0, graph.xs[-1]))
