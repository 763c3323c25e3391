"""ω and α of a link, read off the polygons: magnitude from the length,
sense by carrying the vector to the mechanism."""

from __future__ import annotations

import numpy as np

from ...algebra.quantity import Quantity, magnitude
from ...board.board import NO_LENGTH
from ...board.construction import View
from ...names import alpha, ascii_key, omega
from ...plane import Points, Reals, cross, nominal
from ...plane.geometry import dot
from ...words import Words
from ..desk import Desk, Turn
from ..lettered import lettered

ALONG = 1e-9  # what a vector along a link has across it, over its length: nothing but rounding


def angular_velocity(
    desk: Desk, link: str, about: str, point: str, ends: tuple[Points, Points], letters: str, symbol: str
) -> None:
    """ω = v / l from the relative velocity of `point` about `about`, v = μ_v × its length on paper; a velocity that was
    computed and then laid off is not read back."""
    told = _begin(desk, View.VELOCITY, f"ω_{link}", ends, letters)
    size = desk.board.ledger.laid_off(View.VELOCITY, ascii_key(symbol))
    rate = _rate(desk, View.VELOCITY, f"ω_{link}", "rad/s", about, point, ends, letters, size)
    desk.turns[omega(link)] = Turn(desk.board.conclude(omega(link).key, rate, "rad/s"))
    desk.board.remark(told + _sense(f"ω_{link}", symbol, point, nominal(rate), bool(told.en)))


def angular_acceleration(
    desk: Desk, link: str, about: str, point: str, ends: tuple[Points, Points], letters: str, symbol: str
) -> None:
    """α = a^t / l from the tangential acceleration of `point` about `about`."""
    standing = lettered(desk, View.ACCELERATION, ends, letters)
    told = _begin(desk, View.ACCELERATION, f"α_{link}", ends, standing)
    rate = _rate(desk, View.ACCELERATION, f"α_{link}", "rad/s^2", about, point, ends, standing)
    desk.turns[alpha(link)] = Turn(desk.board.conclude(alpha(link).key, rate, "rad/s^2"))
    desk.board.remark(told + _sense(f"α_{link}", symbol, point, nominal(rate), bool(told.en)))


def same_turn(desk: Desk, link: str, as_link: str, view: View, said: bool = True) -> None:
    """Links joined by a sliding pair turn alike."""
    kind = omega if view is View.VELOCITY else alpha
    desk.turns[kind(link)] = desk.turns[kind(as_link)]
    if said and not desk.turns[kind(link)].never and as_link != "0":
        greek = "ω" if view is View.VELOCITY else "α"
        desk.board.remark(
            Words(
                f"构件 {link} 与 {as_link} 组成移动副，$ {greek}_{link}$ = $ {greek}_{as_link}$。",
                f" Links {link} and {as_link} form a sliding pair: $ {greek}_{link}$ = $ {greek}_{as_link}$.",
            )
        )


def _begin(desk: Desk, view: View, name: str, ends: tuple[Points, Points], letters: str) -> Words:
    """Open the step; behind another link's turning no step is opened, but a sentence of that one begun."""
    board, (first, last) = desk.board, letters.split()
    none = abs(nominal(ends[1] - ends[0])) < NO_LENGTH
    if desk.turning == len(board.steps) > 0 and board.here is view:
        if none:
            return Words(f" ${last}$ 与 ${first}$ 重合，故", f" Point ${last}$ coincides with ${first}$, so")
        return Words("又", " ")
    board.step(
        Words(f"${last}$ 与 ${first}$ 重合，故", f"Point ${last}$ coincides with ${first}$, so")
        if none
        else Words(f"求 ${name}$：", f"Find ${name}$:"),
        view,
    )
    desk.turning = len(board.steps)
    return Words.same("")


def _rate(
    desk: Desk,
    view: View,
    name: str,
    unit: str,
    about: str,
    point: str,
    ends: tuple[Points, Points],
    letters: str,
    size: Quantity | None = None,
) -> Reals:
    board = desk.board
    none = abs(nominal(ends[1] - ends[0])) < NO_LENGTH
    expr = (board.mu(view) * board.measure(*ends, letters) if size is None else size) / desk.length(about, point)
    if not none:
        board.write_worked(magnitude(name, 0, unit).node, expr, unit)
    way = _way(desk.towards(about, point), ends[1] - ends[0])
    return np.where(np.abs(ends[1] - ends[0]) < NO_LENGTH, 0.0, expr.value * way)[()]


def _way(out: Points, vector: Points) -> Reals:
    """The sense of a vector across a link; who drew it along the link instead takes it for the one turned back."""
    across, along = cross(out, vector), dot(out, vector)
    return np.where(np.abs(across) > ALONG * np.abs(along), np.sign(across), -np.sign(along))[()]


def _sense(name: str, symbol: str, point: str, value: float, again: bool) -> Words:
    if abs(value) < 1e-12:
        return Words(f" ${name}$ = 0。", f" ${name}$ = 0.")
    way, way_en = ("逆时针方向", "counter-clockwise") if value > 0 else ("顺时针方向", "clockwise")
    if again:
        return Words(
            f"将 ${symbol}$ 移至 ${point}$ 点，知 ${name}$ 为{way}。",
            f"With ${symbol}$ placed at ${point}$, ${name}$ is {way_en}.",
        )
    return Words(
        f"将 ${symbol}$ 移至 ${point}$ 点，知其为{way}。",
        f" placing ${symbol}$ at ${point}$ shows that it is {way_en}.",
    )
