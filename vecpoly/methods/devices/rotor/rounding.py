"""Weights as there are: rounded to a step, laid off again; what remains is a short vector from the pole."""

from __future__ import annotations

import numpy as np

from ....algebra.quantity import Quantity, number
from ....board.board import NO_LENGTH
from ....board.paper.marks import Dot, Role
from ....devices.balancing.asked import correction, residual, share
from ....devices.balancing.rotor import Rotor
from ....names import Named
from ....plane import Points, Reals, nominal
from ....words import Words, joined
from ..bench import Bench
from .polygon import Polygon, free_letters, heading

AS_NONE = 1e-9


def rounded_weight(bench: Bench, rotor: Rotor, end: str, polygon: Polygon, needed: Quantity) -> Points:
    """One weight, in the direction of W_b."""
    size = np.abs(polygon.tip)
    along = np.where(size > AS_NONE, -polygon.tip / np.where(size > AS_NONE, size, 1.0), 1.0)[()]
    return _laid(bench, rotor, end, polygon, ((along, needed.value),), (correction(end, rotor.weighing),))


def rounded_shares(
    bench: Bench, rotor: Rotor, end: str, polygon: Polygon, shares: tuple[tuple[float, float], tuple[Quantity, ...]]
) -> Points:
    """Two weights, at their places."""
    pairs = tuple((heading(turn), weight.value) for turn, weight in zip(*shares, strict=True))
    return _laid(bench, rotor, end, polygon, pairs, tuple(share(end, which, rotor.weighing) for which in (1, 2)))


def _laid(
    bench: Bench,
    rotor: Rotor,
    end: str,
    polygon: Polygon,
    weights: tuple[tuple[Points, Reals], ...],
    products: tuple[Named, ...],
) -> Points:
    """products: what the weights stand for, before they are rounded."""
    board, plane, unit = bench.board, rotor.planes[end], rotor.weighing
    assert plane.step is not None and plane.r is not None
    step = plane.step.si * unit.masses
    rounded = [np.sign(mass) * np.floor(np.abs(mass) / step + 0.5) * step for _, mass in weights]
    listed = "、".join(f"{number(float(nominal(mass)))} {unit.mass}" for mass in rounded)
    symbols = [one.symbol.replace("W_", "W′_", 1) for one in products]
    named, letter = joined([Words.same(f"${symbol}$") for symbol in symbols]), free_letters(bench, polygon.place)[0]
    board.step(
        Words(
            f"配重按 {plane.step.text} 取整：{listed}。把取整后的质径积 {named.zh} 自末端起首尾相接，"
            f"自 $O$ 到其末端 ${letter}$ 的矢量即剩余不平衡量：",
            f"The weights come in steps of {plane.step.text}: take {listed.replace('、', ' and ')}. Lay off "
            f"{named.en} from the last tip; the vector from $O$ to their end ${letter}$ is the residual unbalance:",
        ),
        polygon.place,
    )
    arm = plane.r.si * unit.products / unit.masses
    here = polygon.tip
    for (along, _), mass, symbol in zip(weights, rounded, symbols, strict=True):
        there = board.lay_off(here, along, board.to_paper(polygon.place, mass * arm))
        board.arrow(polygon.place, here, there, Role.GIVEN, label=symbol)
        here = there
    here = board.locate(polygon.place, letter, here)
    board.plot(polygon.place, here, letter, Dot.POINT)
    left = residual(end, unit)
    if float(nominal(np.abs(here))) > NO_LENGTH:
        board.arrow(polygon.place, 0j * here, here, Role.RESULT, key=left.key, label=left.symbol)
    bench.measured(left, polygon.place, 0j * here, here, f"O {letter}")
    return here
