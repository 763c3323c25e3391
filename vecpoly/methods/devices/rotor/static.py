"""Static balance 静平衡: one polygon of all products; its closing side balances them."""

from __future__ import annotations

from collections.abc import Mapping
from math import degrees

from ....algebra.quantity import Quantity
from ....devices.balancing.asked import bearing, correction, product_of
from ....devices.balancing.rotor import Rotor
from ....words import Words
from ..bench import Bench
from .correct import corrected
from .grade import permitted_circles
from .polygon import Laid, chain, read_closing
from .scales import polygon_view


def in_one_plane(bench: Bench, rotor: Rotor, sizes: Mapping[str, Quantity]) -> None:
    """W_1 + W_2 + … + W_b = 0."""
    board, unit, view = bench.board, rotor.weighing, polygon_view(rotor)
    symbol, balance = view.mu.symbol, correction("", unit)
    board.section(Words("质径积多边形", "Mass–radius polygon"))
    place = board.open_pane(view, "", view.title)
    board.step(
        Words(
            f"静平衡条件是各质径积的矢量和为零。自极点 $O$ 按 ${symbol}$ 依次首尾相接作各质径积矢量，自末端指向 $O$ "
            "的封闭边"
            "即平衡质径积 $W_b$；量其长度和方向：",
            "For static balance the vector sum of all products is zero. From the pole $O$ lay the products off head to "
            f"tail to the scale ${symbol}$; the closing side, from the last tip back to $O$, is the balancing product "
            "$W_b$. Measure its length and its direction:",
        ),
        place,
    )
    laid = [laid_whole(rotor, name, size) for name, size in sizes.items()]
    closing = correction("", unit)
    polygon = chain(bench, place, laid, closing)
    found = read_closing(bench, polygon, balance, bearing(""))
    circles = permitted_circles(bench, rotor, {"": polygon}) if rotor.tolerance is not None else {}
    corrected(bench, rotor, "", polygon, found, circles.get(""))


def laid_whole(rotor: Rotor, name: str, size: Quantity) -> Laid:
    """The product of a mass; of a hole it points the opposite way."""
    mass = rotor.masses[name]
    sign = -1.0 if mass.removed else 1.0
    return Laid(named=product_of(name, rotor.weighing), size=sign * size.value, degrees=degrees(mass.at.si))
