"""The M–φ diagram of a linkage: its loads, the constant moment by the rectangle of equal area, the areas between."""

from __future__ import annotations

from dataclasses import dataclass
from itertools import pairwise

import numpy as np

from ...algebra.columns import TOTAL, column, summed
from ...algebra.quantity import Quantity, number
from ...board.acts import Way
from ...board.construction import Listing, Pane
from ...board.paper.marks import Dot, Role
from ...mechanism.asked.machine import DW
from ...names import Named
from ...plane import Points, Reals
from ...words import Words
from ..diagrams.axes import Axes, angle_ticks, draw_axes
from ..diagrams.graph import Graph, axis, level, name_curve, trace
from ..diagrams.indicator import SMALL, indicator, shared_out
from ..diagrams.lobes import Lobes, lobes_between
from ..diagrams.works import equal_height, work_scale
from .period import Period, kept, shown
from .scales import INDICATOR, TORQUE, Sizes

FINE = np.radians(6.0)
LETTERS = "abcdefghijklmnopqrstuvwxyz"
MOMENTS, BAR = Words("力矩线图", "Diagram of moments"), Words("能量指示图", "Energy-fluctuation diagram")


@dataclass(frozen=True, slots=True, kw_only=True)
class Moments:
    """The pane; the curve of the loads (its sign: +1 where it is the driving one), the line of the constant moment."""

    pane: Pane
    loads: Graph
    other: Graph
    drives: bool


def draw_moments(period: Period, sizes: Sizes, constant: Named | None) -> Moments:
    """Both lines; the constant one from the area under the other."""
    board, curve = period.board, period.curve
    pane = board.open_pane(TORQUE, "moments", MOMENTS, sizes.torque, aside=True)
    drives = curve.mean <= 0 if constant is not None else True
    which = ("d", "驱动", "driving") if drives else ("r", "阻", "resisting")
    leaps = Words("；载荷突变处，力矩也突变", "; where a load begins or ends, it jumps")
    board.step(
        Words(
            f"按 $μ_M$、$μ_φ$ 作已知力（矩）的等效{which[1]}力矩 $M_{{e{which[0]}}}$ 的线图",
            f"Plot the equivalent {which[2]} moment $M_{{e{which[0]}}}$ of the given loads to the scales $μ_M$ and "
            "$μ_φ$",
        )
        + (leaps if curve.corners else Words("", ""))
        + Words("。", "."),
        pane,
    )
    loads = _graph(period, pane, 1.0 if drives else -1.0)
    _axes(period, pane, loads, abs(curve.mean))
    trace(board, pane, loads)
    name_curve(board, pane, loads, f"M_{{e{which[0]}}}")
    other = axis(loads) if constant is None else _constant(period, pane, loads, constant, drives=drives)
    return Moments(pane=pane, loads=loads, other=other, drives=drives)


def rows_of(period: Period, sign: float) -> list[tuple[float, Reals]]:
    """Corners of the curve: close together, and so that the area of every piece is that under the curve itself."""
    curve = period.curve
    cuts = sorted({*map(float, curve.cuts), *curve.crossings(-curve.mean)})
    rows: list[tuple[float, Reals]] = []
    for a, b in pairwise(cuts):
        parts = max(2, round((b - a) / FINE))
        places = [a + (b - a) * k / parts for k in range(parts + 1)]
        heights = [curve.moment(psi, before=psi == b) for psi in places]
        step, area = (b - a) / parts, curve.work(b, 0.0) - curve.work(a, 0.0)
        short = (area - step * (sum(heights) - (heights[0] + heights[-1]) / 2)) / (step * (parts - 1))
        heights[1:-1] = [height + short for height in heights[1:-1]]
        if rows and abs(shown(rows[-1][1]) - sign * heights[0]) < 1e-9 * (1 + abs(heights[0])):
            rows.pop()
        rows += [(psi, sign * height * period.factor(psi)) for psi, height in zip(places, heights, strict=True)]
    return rows


def _graph(period: Period, pane: Pane, sign: float) -> Graph:
    board, rows = period.board, rows_of(period, sign)
    corners: list[Points] = []
    for psi, moment in rows:
        foot = board.lay_off(0j, 1 + 0j, board.to_paper_across(pane, psi))
        corners.append(board.lay_off(foot, 1j, board.to_paper(pane, moment)))
    right = board.scale_of(pane).right.value
    return Graph(corners=tuple(corners), xs=tuple(psi / right for psi, _ in rows))


def _axes(period: Period, pane: Pane, loads: Graph, mean: float) -> None:
    board = period.board
    axes = Axes(
        wide=loads.xs[-1],
        low=min(0.0, *loads.ys),
        high=max(float(board.to_paper(pane, mean)), *loads.ys),
        across="φ",
        up="M",
    )
    draw_axes(board, pane, axes, angle_ticks(board, pane, period.curve.period))


def _constant(period: Period, pane: Pane, loads: Graph, named: Named, *, drives: bool) -> Graph:
    """The rectangle over the period that has the area under the curve."""
    board, symbol = period.board, named.symbol
    board.step(
        Words(
            "一个周期内驱动功等于阻力功：量出曲线与 $φ$ 轴之间的各块面积 $S_i$（轴下为负）和周期的长度 $OT$，"
            f"等面积矩形的高即为 ${symbol}$。",
            "Over the period $OT$ the work of the driving moment equals that of the resisting moment. Measure the "
            "areas $S_i$ between the curve and the $φ$ axis (negative below it); the rectangle of the same area over "
            f"$OT$ has the height ${symbol}$.",
        ),
        pane,
    )
    sense = period.curve.sense * (-1 if drives else 1)
    size = kept(board, named, equal_height(board, pane, loads, Way.SQUARES), sense)
    line = level(board, loads.xs[-1], board.lay_off(0j, 1j, board.to_paper(pane, size.value)))
    trace(board, pane, line, Role.RESULT)
    board.plot(pane, line.corners[1], symbol, Dot.NONE)
    return line


def draw_surplus(period: Period, sizes: Sizes, moments: Moments) -> Quantity:
    """The areas between the lines, arrow by arrow on the indicator bar: ΔW_max."""
    board, pane = period.board, moments.pane
    upper, lower = (moments.loads, moments.other) if moments.drives else (moments.other, moments.loads)
    board.step(
        Words(
            "驱动力矩大于阻力矩处为盈功，反之为亏功；量出各块面积，乘以 $μ_A$ = $μ_M$ $μ_φ$（$μ_φ$ 以弧度计）得"
            "盈亏功。",
            "Where the driving moment is greater than the resisting moment there is a surplus of work, elsewhere a "
            "deficit. Measure the areas between the curves and multiply them by $μ_A$ = $μ_M$ $μ_φ$ ($μ_φ$ in "
            "radians).",
        ),
        pane,
    )
    scale = work_scale(board, pane)
    lobes = lobes_between(board, pane, upper, lower, _letters(upper, lower, period), Way.SQUARES)
    works = [lobe.sign * lobe.area.value * scale.value for lobe in lobes.lobes]
    left, even = shared_out(works)
    board.tabulate(_table(lobes, works))
    board.remark(_missed(shown(left), sum(abs(shown(work)) for work in works)))
    return _bar(period, sizes, even, lobes.letters)


def _missed(left: float, whole: float) -> Words:
    """What the works miss zero by, which is shared out; nothing where they add up."""
    if abs(left) <= SMALL * whole:
        return Words("各功之和为零。", " Their sum is zero.")
    return Words(
        f"各功之和应为零，读数之差 {number(left)} J 按大小分摊。",
        f" Their sum should be zero; the reading error of {number(left)} J is distributed in proportion to "
        "their sizes.",
    )


def _letters(upper: Graph, lower: Graph, period: Period) -> tuple[str, ...]:
    from ..diagrams.meetings import meetings

    count = len(meetings(period.board.scratch(), upper, lower).meetings)
    return (*LETTERS[: count + 1], "a′")


def _table(lobes: Lobes, works: list[Reals]) -> Listing:
    head = (Words("区间", "from–to"), Words.same("$A$ /mm²"), Words.same("$ΔW$ /J"))
    ends = [f"{a}–{b}" for a, b in pairwise(lobes.letters)]
    areas = column([shown(lobe.area.value) for lobe in lobes.lobes])
    *told, total = summed([shown(work) for work in works])
    rows = tuple(zip(ends, areas, told, strict=True))
    return Listing(head=head, rows=(*rows, (TOTAL, "", total)), blocks=1)


def _bar(period: Period, sizes: Sizes, works: tuple[Reals, ...], letters: tuple[str, ...]) -> Quantity:
    board = period.board
    pane = board.open_pane(INDICATOR, "indicator", BAR, sizes.indicator, aside=True)
    board.step(
        Words(
            "作能量指示图：自基线起依次画出各盈亏功，盈功向上，亏功向下，终点回到基线。最高点处动能最大，最低点处动能"
            "最小，两者之差即最大盈亏功。",
            "Draw the energy-fluctuation diagram: beginning at the base line, lay off the works one after the other, "
            "surpluses upwards and deficits downwards; the last one ends on the base line. The kinetic energy is "
            "greatest at the highest point and least at the lowest; their difference is the maximum surplus of work.",
        ),
        pane,
    )
    bar = indicator(board, pane, works, letters, DW.symbol)
    expr = board.mu(pane) * bar.swing
    return kept(board, DW, expr)
