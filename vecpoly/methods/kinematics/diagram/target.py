"""The path of a point beside the curve that it should run along, and where it is farthest off."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import pairwise
from math import tau

import numpy as np

from ....board.construction import View
from ....board.paper.marks import Dot, Role
from ....errors import VecpolyError
from ....plane import nearest_between, nominal
from ....problem.asked.target import Target
from ....words import Words
from ...desk import Desk
from ...positions.placed import placed

PLACES = 120  # of the drive, over a turn


def draw_target(desk: Desk, target: Target) -> None:
    """The curve dashed, the path thin under the links, the maximum distance of a given point from the path."""
    board, view = desk.board, View.MECHANISM
    name, mark = target.point, "T" if "T" not in desk.at else "T′"
    board.step(
        Words(
            f"取原动件的一系列位置，描出 ${name}$ 点的轨迹（细实线），与给定曲线（虚线）比较；"
            f"最大偏差在 ${mark}$ 点，为：",
            f"Trace the path of ${name}$ (thin) through a turn of the driving link, beside the curve that is given "
            f"(dashed). The maximum deviation, at ${mark}$, is:",
        ),
        view,
    )
    path = _path(desk, name)
    if len(path) > 1:
        board.curve(view, [np.complex128(at) for at in path], Role.CONSTRUCTION)
    given = [desk.mm(1.0) * at for at in target.through]
    board.curve(view, [np.complex128(at) for at in (*given, *given[: target.closed])], Role.HIDDEN)
    at, foot = max(((spot, _foot(path, spot)) for spot in given), key=lambda pair: abs(pair[1] - pair[0]))
    on_paper = board.measure(np.complex128(at), np.complex128(foot), f"{mark} {mark}_0")
    board.compute("δ_{max}", board.mu(view) * on_paper, "m")
    board.join(view, np.complex128(at), np.complex128(foot), Role.RESULT)
    board.plot(view, np.complex128(at), mark, Dot.POINT)
    board.plot(view, np.complex128(foot), f"{mark}_0", Dot.POINT)


def _path(desk: Desk, point: str) -> list[complex]:
    """The path through a turn of the drive; as far as it goes to both sides where it does not turn right round."""
    ahead = list(_run(desk, point, 1))
    behind = [] if len(ahead) == PLACES else list(_run(desk, point, -1))
    return [*behind[::-1], complex(nominal(desk.at[point])), *ahead]


def _run(desk: Desk, point: str, sense: int) -> Iterator[complex]:
    """Places of the point, until the mechanism goes no farther."""
    for step in range(1, PLACES + 1):
        try:
            there = placed(desk, desk.mech.drive.position + sense * tau * step / PLACES)
        except VecpolyError:
            return
        yield complex(nominal(there.at[point]))


def _foot(path: Sequence[complex], spot: complex) -> complex:
    """The place of the path that is nearest to a point."""
    feet = (nearest_between(one, two, spot) for one, two in pairwise(path))
    return min(feet, key=lambda foot: abs(foot - spot), default=path[0])
