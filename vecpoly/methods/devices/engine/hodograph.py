"""The hodograph 矢端曲线 of a shaking force: its points on scratch paper, the farthest of them, the fraction that makes
that one nearest."""

from __future__ import annotations

from math import pi, sqrt

import numpy as np

from ....board.board import Board
from ....foundation.slotted import dataclass
from ....plane import Points, Reals
from ..bench import trial_board

TRIED, FIRST = 21, 181  # places in a row, in the first row
NARROW = 2e-5  # rad: between places that are looked at no closer
GOLD, ROUNDS = (sqrt(5) - 1) / 2, 70
ALIKE = 9  # decimals of mm


@dataclass(frozen=True, slots=True, kw_only=True)
class Orders:
    """Amplitudes of first and second order on paper (mm)."""

    first: Reals
    second: Reals


def parts(board: Board, orders: Orders, phi: Reals, c: Reals, keys: tuple[str, str, str]) -> tuple[Points, ...]:
    """First and second order along the cylinder, as projections from their circles, and the counterweight's force."""
    along = np.exp(1j * phi)
    one = board.lay_off(0j, along, orders.first, key=keys[0])
    two = board.lay_off(0j, along**2, orders.second, key=keys[1])
    return one.real + 0j, two.real + 0j, board.lay_off(0j, -along, c * orders.first, key=keys[2])


def tip(board: Board, orders: Orders, phi: Reals, c: Reals) -> Points:
    """The whole force at an angle of the crank."""
    return sum(parts(board, orders, phi, c, ("", "", "")))


def farthest(board: Board, orders: Orders, c: float) -> tuple[float, float]:
    """The angle from 0 to π at which the force is largest, the first of equals; and how long it is (mm)."""
    tried = np.linspace(0.0, pi, FIRST)
    size = np.abs(tip(trial_board(board), orders, tried, c))
    beside = np.pad(size, 1, constant_values=-1.0)
    tops = np.flatnonzero((size >= beside[:-2]) & (size >= beside[2:]))  # each of them may be the highest
    ends = [(max(int(top) - 1, 0), min(int(top) + 1, FIRST - 1)) for top in tops]
    found = [_closer(board, orders, c, float(tried[one]), float(tried[other])) for one, other in ends]
    at, _ = max(found, key=lambda one: round(one[1], ALIKE))
    return at, max(size for _, size in found)


def _closer(board: Board, orders: Orders, c: float, low: float, high: float) -> tuple[float, float]:
    """The highest place between two angles, looked at ever closer; at last the vertex of a parabola through three."""
    middle = (low + high) / 2
    while high - low > NARROW:
        tried = np.linspace(low, high, TRIED)
        size = np.abs(tip(trial_board(board), orders, tried, c))
        middle = float(tried[int(np.argmax(size))])
        step = float(tried[1] - tried[0])
        low, high = middle - step, middle + step
    beside = np.abs(tip(trial_board(board), orders, middle + NARROW * np.array([-1.0, 0.0, 1.0]), c))
    bend = float(beside[0] - 2 * beside[1] + beside[2])
    vertex = middle + (0.5 * NARROW * float(beside[0] - beside[2]) / bend if bend else 0.0)
    at = min(max(vertex, 0.0), pi)
    return at, float(np.abs(tip(trial_board(board), orders, np.array([at]), c))[0])


def best_fraction(board: Board, orders: Orders, most: float) -> float:
    """The fraction with which the farthest point is nearest to the pole."""
    low, high = 0.0, most
    for _ in range(ROUNDS):
        one, other = high - GOLD * (high - low), low + GOLD * (high - low)
        if farthest(board, orders, one)[1] <= farthest(board, orders, other)[1]:
            high = other
        else:
            low = one
    return (low + high) / 2
