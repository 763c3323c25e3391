"""Twelve positions: J_e and M_e by the same polygon, as a table, and J_e as a curve."""

from __future__ import annotations

import numpy as np

from ...algebra.columns import column
from ...board.construction import Listing, Pane
from ...board.paper.marks import Dot, Role
from ...plane import Points
from ...words import Words
from ..diagrams.axes import Axes, angle_ticks, draw_axes
from .period import Period, shown
from .scales import INERTIA, Sizes

TITLE = Words("等效转动惯量线图", "Equivalent moment of inertia")
FINE = np.radians(7.5)


def draw_positions(period: Period, sizes: Sizes) -> None:
    """The table of what was found on the polygons, and the curve of J_e over φ."""
    board, count = period.board, len(period.read) - 1
    pane = board.open_pane(INERTIA, "inertia", TITLE, sizes.inertia, aside=True)
    board.step(
        Words(
            f"取原动件的 {count} 个等分位置，用同样的方法在各位置作速度多边形，求得 $J_e$ 和各已知力（矩）的 $M_e$"
            "（逆时针为正），列成表，并按 $μ_J$、$μ_φ$ 作 $J_e$–$φ$ 线图。",
            f"In {count} equal positions of the driving link draw the velocity polygon in the same way; $J_e$, and "
            "$M_e$ of the given loads (counter-clockwise positive), are in the table. Plot $J_e$ versus $φ$ to the "
            "scales $μ_J$ and $μ_φ$.",
        )
        + period.beginning,
        pane,
    )
    board.tabulate(_table(period))
    _draw(period, pane)


def _table(period: Period) -> Listing:
    head = (Words.same("$φ$ /°"), Words.same("$J_e$ /(kg·m²)"), Words.same("$M_e$ /(N·m)"))
    step = period.curve.period / (len(period.read) - 1)
    read = period.read[:-1]
    angles = column([period.degrees(step * k) for k in range(len(read))])
    found = column([shown(one.inertia) for one in read]), column([shown(one.moment) for one in read])
    return Listing(head=head, rows=tuple(zip(angles, *found, strict=True)))


def _draw(period: Period, pane: Pane) -> None:
    board, curve = period.board, period.curve
    grid = [float(psi) for psi in np.linspace(0.0, curve.period, round(curve.period / FINE) + 1)]
    high = board.to_paper(pane, max(curve.inertia(psi) for psi in grid))
    wide = board.to_paper_across(pane, curve.period)
    axes = Axes(wide=float(wide), low=0.0, high=float(high), across="φ", up="J_e")
    draw_axes(board, pane, axes, angle_ticks(board, pane, curve.period))
    board.curve(pane, [_point(period, pane, psi) for psi in grid], Role.RESULT)
    for k in range(len(period.read)):
        board.plot(pane, _point(period, pane, curve.period * k / (len(period.read) - 1)), "", Dot.POINT)


def _point(period: Period, pane: Pane, psi: float) -> Points:
    board = period.board
    foot = board.lay_off(0j, 1 + 0j, board.to_paper_across(pane, psi))
    return board.lay_off(foot, 1j, board.to_paper(pane, period.inertia(psi)))
