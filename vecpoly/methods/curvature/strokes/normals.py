"""The normals of two known paths of a link, in this or in another position of the mechanism."""

from __future__ import annotations

from ....board.board import Board
from ....errors import NotAskedError
from ....plane import Line, unit
from ....words import Words
from ...desk import Desk
from ..pairs import Pair
from ..state import Ray, sine

PARALLEL = 1e-7  # sine below which two normals do not meet


def normal_of(desk: Desk, pair: Pair, factor: float, board: Board) -> Ray:
    """The normal as it lies on a figure `factor` times as large as the diagram on the desk."""
    x = desk.at[pair.moving] * factor if pair.moving else None
    o = desk.at[pair.fixed] * factor if pair.fixed else None
    if x is not None and o is not None:
        return Ray(moving=pair.moving, fixed=pair.fixed, x=x, o=o, line=Line(o, unit(x - o)))
    at = x if x is not None else o
    assert at is not None and pair.joint is not None
    across = board.turn(1j * desk.guide_line(pair.joint).along)
    return Ray(moving=pair.moving, fixed=pair.fixed, x=x, o=o, line=Line(at, across))


def refuse_parallel(one: Ray, two: Ray, number: str) -> None:
    """Raise NotAskedError where the normals do not meet: the pole of the link with this number is at infinity."""
    if sine(one.line.along, two.line.along) < PARALLEL:
        raise NotAskedError(
            Words(
                f"两法线平行：构件 {number} 的绝对瞬心在无穷远处，没有拐点圆；请另取原动件位置",
                f"the two normals are parallel: the pole of link {number} is at infinity and there is no inflection "
                "circle; choose another input position",
            ),
            code="pole-at-infinity",
        )
