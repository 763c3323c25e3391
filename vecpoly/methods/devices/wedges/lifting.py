"""The lifting way: both wedges drawn apart, with the friction against it, and their polygon measured."""

from __future__ import annotations

from collections.abc import Mapping

from ....algebra.quantity import Quantity
from ....board.construction import View
from ....devices.wedges import DRIVE, FACES, Wedges
from ....names import Named
from ....plane import Points
from ....words import Words
from ..bench import Bench
from ..inclined import Press
from ..sketches.wedges import Shapes, apart_one, apart_two
from .polygon import LIFT, R12, R21, R31, R32, Angles, Lines, lines_of, over, polygon


def lift(bench: Bench, device: Wedges, it: Shapes, phi: Angles) -> Quantity:
    """Both wedges drawn apart, and the polygon of the lifting way."""
    board, lines = bench.board, lines_of(it, phi, 1)
    sign = {face: device.angle(face).symbol for face in FACES}
    board.section(Words("正行程：$F$ 为驱动力", "Lifting: $F$ drives"))
    _wedge_two(bench, it, lines, sign)
    _wedge_one(bench, it, lines, sign)
    if over(it, lines):
        board.remark(
            Words(
                "这里 $R_21$ 把楔块 1 压向导路的上侧面，$R_31$ 由上侧面作用。",
                " Here $R_21$ presses wedge 1 against the upper side of its guide, from which $R_31$ acts.",
            )
        )
    ends = polygon(bench, device, it, lines, LIFT, Words.same(""))
    board.step(Words("量各边，乘以 $μ_F$。", "Measure the sides and multiply by $μ_F$."), ends.place)
    bench.measured(R32, ends.place, ends.b, ends.c, "b c")
    bench.measured(R12, ends.place, ends.c, ends.a, "c a")
    bench.measured(R31, ends.place, ends.c, ends.d, "c d")
    return bench.measured(DRIVE, ends.place, ends.d, ends.a, "d a")


def _wedge_two(bench: Bench, it: Shapes, lines: Lines, sign: Mapping[str, str]) -> None:
    """Wedge 2 apart: it slides up the face of 1, and up along 3. sign: symbols of the friction angles, by face."""
    place = bench.board.open_pane(View.BODY, "2", Words("楔块 2 受力图（正行程）", "Free body of wedge 2, lifting"))
    bench.board.step(
        Words(
            "先取楔块 2 为分离体：$Q$ 已知，$R_12$、$R_32$ 只有大小未知，可解（楔块 1 上三力的大小都未知）。"
            f"2 相对 1 沿接触面向上滑动（$v_21$），故 $R_12$ 自法线 $n$ 逆滑动方向偏转 ${sign['12']}$；"
            f"2 相对 3 向上滑动（$v_23$），故 $R_32$ 自法线向下偏转 ${sign['23']}$；三力汇交于一点。",
            "Take wedge 2 first: $Q$ is known, and of $R_12$ and $R_32$ only the magnitudes are "
            "unknown, whereas on wedge 1 the magnitudes of all three forces are. Wedge 2 slides "
            f"up the face of 1 ($v_21$), so $R_12$ is turned from the normal $n$ by ${sign['12']}$ "
            "against that sliding; it slides up along 3 ($v_23$), so $R_32$ is turned down by "
            f"${sign['23']}$; the three forces are concurrent.",
        ),
        place,
    )
    by_1 = _press(R12, it.normal, lines.r12, sign["12"], it.face, "v_{21}")
    apart_two(bench, place, it, by_1, _press(R32, lines.n32, lines.r32, sign["23"], 1j, "v_{23}"))


def _wedge_one(bench: Bench, it: Shapes, lines: Lines, sign: Mapping[str, str]) -> None:
    """Wedge 1 apart: it slides forward along its guide, and down the face of 2."""
    place = bench.board.open_pane(View.BODY, "1", Words("楔块 1 受力图（正行程）", "Free body of wedge 1, lifting"))
    bench.board.step(
        Words(
            "再取楔块 1 为分离体：$R_21 = −R_12$ 已求得；1 沿导路向前滑动（$v_13$），故 $R_31$ 自法线向后偏转 "
            f"${sign['13']}$；$F$ 沿导路。$R_31$、$F$ 的大小待求。",
            "Then wedge 1: $R_21 = −R_12$ has been found; 1 slides forward along its guide "
            f"($v_13$), so $R_31$ is turned back by ${sign['13']}$; $F$ acts along the guide. The "
            "magnitudes of $R_31$ and $F$ are sought.",
        ),
        place,
    )
    by_2 = _press(R21, -it.normal, -lines.r12, sign["12"], -it.face, "v_{12}")
    apart_one(bench, place, it, by_2, _press(R31, lines.n31, lines.r31, sign["13"], it.guide, "v_{13}"))


def _press(force: Named, normal: Points, along: Points, angle: str, slides: Points, speed: str) -> Press:
    """A reaction whose place the sketch tells."""
    return Press(symbol=force.symbol, at=0j, normal=normal, along=along, angle=angle, slides=slides, speed=speed)
