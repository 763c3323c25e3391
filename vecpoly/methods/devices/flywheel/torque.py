"""The diagram of moments: both curves, the constant one by the rectangle of equal area, the areas between."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from ....algebra.formula import Txt
from ....algebra.quantity import Quantity, magnitude
from ....board.acts import Way
from ....board.paper.marks import Dot
from ....devices.dynamics.asked import M_D, M_R, POWER, place
from ....devices.dynamics.flywheel import Flywheel
from ....devices.dynamics.given import Torques
from ....plane import Reals
from ...diagrams.axes import Axes, angle_ticks, draw_axes
from ...diagrams.graph import Graph, level, name_curve, plotted, trace
from ...diagrams.lobes import Lobes, lobes_between
from ...diagrams.works import equal_height, work_scale
from ..bench import Bench
from ..cam.read.readings import noted
from .pieces import Pieces, letters_of, works_of
from .scales import TORQUE
from .words import AREAS, POWERS, SECTION, constant, curves_drawn

Rows = Sequence[tuple[float, Reals]]
THOUSAND = Quantity(Txt("1000"), 1000.0, "")


def measured_areas(bench: Bench, wheel: Flywheel, load: Torques, omega: Quantity) -> Pieces:
    """Draw both curves, and read what lies between them."""
    board = bench.board
    board.section(SECTION)
    rows = _rows(bench, wheel, load, omega)
    board.step(curves_drawn(load), TORQUE)
    _axes(bench, load, [angle for curve in rows.values() for angle, _ in curve])
    drawn = {key: _curve(bench, key, corners) for key, corners in rows.items()}
    if load.sought:
        (other,) = drawn.values()
        drawn[load.sought] = _equal_area(bench, wheel, load, other, omega)
    board.step(AREAS, TORQUE)
    lobes = lobes_between(board, TORQUE, drawn["d"], drawn["r"], letters_of(load.count), Way(wheel.measured))
    scale = work_scale(board, TORQUE)
    _places(bench, lobes)
    sizes = [lobe.area for lobe in lobes.lobes]
    works = works_of(bench, sizes, [lobe.sign for lobe in lobes.lobes], scale, lobes.letters)
    return Pieces(works=works, letters=lobes.letters, ends=lobes.ends)


def _axes(bench: Bench, load: Torques, corners: Sequence[float]) -> None:
    scale, (low, high) = bench.board.scale_of(TORQUE), load.highest
    axes = Axes(
        wide=load.period / scale.right.value, low=low / scale.value, high=high / scale.value, across="φ", up="M"
    )
    draw_axes(bench.board, TORQUE, axes, angle_ticks(bench.board, TORQUE, load.period, corners))


def _rows(bench: Bench, wheel: Flywheel, load: Torques, omega: Quantity) -> dict[str, Rows]:
    """The corners of the curves that are given: of powers as the moments that they make."""
    if wheel.powers is None:
        curves = {"d": load.driving, "r": load.resisting}
        return {key: curve.over(load.period) for key, curve in curves.items() if key != load.sought}
    bench.board.step(POWERS)
    corners: list[tuple[float, Reals]] = []
    for n, (angle, power) in enumerate(wheel.powers, 1):
        moment = bench.board.compute(f"M_r{n}", magnitude(f"P_{n}", power.si, "W") / omega, "N·m")
        start = corners[-1][0] if corners else 0.0
        corners += [(start, moment.value), (start + angle.si, moment.value)]
    return {"r": tuple(corners)}


def _curve(bench: Bench, key: str, rows: Rows) -> Graph:
    graph = plotted(bench.board, TORQUE, rows)
    trace(bench.board, TORQUE, graph)
    name_curve(bench.board, TORQUE, graph, f"M_{key}")
    return graph


def _equal_area(bench: Bench, wheel: Flywheel, load: Torques, graph: Graph, omega: Quantity) -> Graph:
    """The constant moment: the height of a rectangle over the period whose area is that under the other curve."""
    board, named = bench.board, M_D if load.sought == "d" else M_R
    board.step(constant(load), TORQUE)
    size = bench.worked(named, equal_height(board, TORQUE, graph, Way(wheel.measured)))
    bench.worked(POWER, size * omega / THOUSAND)
    line = level(board, graph.xs[-1], board.lay_off(0j, 1j, board.to_paper(TORQUE, size.value)))
    trace(board, TORQUE, line)
    board.plot(TORQUE, line.corners[1], named.symbol, Dot.NONE)
    return line


def _places(bench: Bench, lobes: Lobes) -> None:
    """φ of every meeting, read on the axis."""
    board, mu = bench.board, bench.board.scale_of(TORQUE).right
    for number, (end, name) in enumerate(zip(lobes.ends[1:-1], lobes.letters[1:-1], strict=True), 1):
        read = board.measure(0j, end.real + 0j, f"O {name}")
        noted(bench, place(number), np.degrees(read.value * mu.value), read.value, f"O {name}", mu.symbol)
