"""The check of a rotor in balance: its couples about a third plane close, those of what was added included."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from math import degrees

import numpy as np

from ....algebra.quantity import Quantity, number
from ....devices.balancing.rotor import Rotor
from ....names import Named
from ....plane import Points, nominal
from ....words import Words
from ..bench import Bench
from .polygon import Laid, Polygon, summed
from .scales import COUPLES
from .views.along import THIRD, third_plane


def about_a_third_plane(
    bench: Bench,
    rotor: Rotor,
    sizes: Mapping[str, Quantity],
    polygons: Mapping[str, Polygon],
    found: Mapping[str, Quantity],
) -> None:
    """ΣW l = 0 about the plane midway between the first and the last place on the axis."""
    board = bench.board
    here = (max(rotor.stations) + min(rotor.stations)) / 2
    board.section(Words("对第三平面复核", "Check about a third plane"))
    title = Words(f"对平面 ${THIRD}$ 的力偶多边形", f"Couples about plane ${THIRD}$")
    place = board.open_pane(COUPLES, "III", title)
    board.step(
        Words(
            f"校核：对 $z$ = {number(1e3 * here)} mm 处的第三平面 ${THIRD}$（画入轴向简图）取矩，按 $μ_{{Wl}}$ "
            f"作各力偶 $W l$（$l$ 为到平面 ${THIRD}$ 的距离；矢量转过 90°，沿 $W$ 的方向画，"
            "平面左侧的反向），连同已量得的平衡质径积。多边形应封闭；量其缺口：",
            f"Check: take moments about a third plane ${THIRD}$, at $z$ = {number(1e3 * here)} mm (drawn into the view "
            "along the axis). To the scale $μ_{Wl}$ draw the "
            "couples $W l$ ($l$: distance from the plane), turned by 90° so that "
            "they lie along $W$ (to the left of the plane: reversed), with the "
            "balancing products as they were read. The polygon should close; measure the gap:",
        ),
        place,
    )
    third_plane(bench, rotor, here)
    laid = [*_of_masses(rotor, sizes, here), *_of_corrections(bench, rotor, polygons, found, here)]
    closed = summed(bench, place, laid, None, known=False)
    gap = board.measure(0j * closed.tip, closed.tip, f"O {closed.letter}")
    board.remark(
        Words(
            f"缺口 {number(float(nominal(gap.value)), 2)} mm。",
            f" The gap is {number(float(nominal(gap.value)), 2)} mm.",
        )
    )


def _of_masses(rotor: Rotor, sizes: Mapping[str, Quantity], here: float) -> Iterator[Laid]:
    for name, mass in rotor.masses.items():
        arm = (-1.0 if mass.removed else 1.0) * (mass.place - here) / rotor.weighing.products
        yield Laid(named=_couple(name), size=sizes[name].value * arm, degrees=degrees(mass.at.si))


def _of_corrections(
    bench: Bench, rotor: Rotor, polygons: Mapping[str, Polygon], found: Mapping[str, Quantity], here: float
) -> Iterator[Laid]:
    """What was added, as it was read off the polygons."""
    for end, plane in rotor.planes.items():
        arm = (plane.at - here) / rotor.weighing.products
        turn = _degrees_of(bench, -polygons[end].tip)
        yield Laid(named=_couple(f"b{end}"), size=found[end].value * arm, degrees=turn)


def _degrees_of(bench: Bench, vector: Points) -> float:
    """The direction of what was read, by protractor."""
    if abs(complex(nominal(vector))) < 1e-9:
        return 0.0
    return float(nominal(np.degrees(bench.board.gauge(0j * vector, vector))))


def _couple(name: str) -> Named:
    return Named(f"C_{name}", f"C_{{{name}}}", "kg·m^2")
