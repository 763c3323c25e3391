"""Where O stands under the bounds of the allowed pressure angles: in the nearest place to B_0."""

from __future__ import annotations

from collections.abc import Sequence
from math import atan2, cos, degrees, sin

import numpy as np

from ....board.board import Board
from ....board.paper.marks import Dot, Role
from ....devices.cams.cam import Allowed
from ....plane import Line, Points, cross, foot, nominal
from ....words import Words
from ..bench import Bench
from ..inclined import FLAT, between
from .scales import LOOP

BELOW, MARK = 1.35, 24.0  # how far the bounds run past the apex; mm: an angle mark
ON = 1e-6  # mm, or °: a place so near to a bound lies on it


def third_bound(bench: Bench, angle: float, apex: Points) -> Line:
    """Through B_0: what bounds the other side where the rise begins."""
    board = bench.board
    board.step(
        Words(
            "推程起始处（$s$ = 0，d$s$/d$φ$ = 0）法线偏向另一侧，压力角即 $B_0 O$ 与纵轴的夹角。过 $B_0$ 作与纵轴成"
            "$[α_0]$ 的第三条界线，$O$ 应在三线之下。",
            "Where the rise begins ($s$ = 0, d$s$/d$φ$ = 0) the follower is pushed to the other side: the pressure "
            "angle is that between $B_0 O$ and the vertical. Draw the third bound through $B_0$ at $[α_0]$ to the "
            "vertical: $O$ must lie below all three.",
        ),
        LOOP,
    )
    line = board.parallel(0j, complex(sin(angle), -cos(angle)))
    end = line.at + (np.abs(apex) * BELOW) * line.along
    board.join(LOOP, 0j, end, Role.DIRECTION)
    between(bench, LOOP, 0j, -1j + 0j, line.along, MARK, "[α_0]")
    return line


def nearest(board: Board, bounds: tuple[Line, Line], apex: Points, third: Line | None) -> tuple[Points, str]:
    """The foot of the perpendicular from B_0 on a bound, where the others allow it; else the nearest corner."""
    every = bounds if third is None else (*bounds, third)
    good = [_inside(foot(line, 0j), every) for line in bounds]
    which = next((i for i, ok in enumerate(good) if ok), None)
    cut = None if third is None or which is not None else _cut(board.scratch(), bounds, apex, third)
    letter = "E" if which is not None else "D" if cut is None else "G"
    below = ("两线", "both lines") if third is None else ("三线", "all three lines")
    board.step(
        Words(
            f"求{below[0]}之下的区域内离 $B_0$ 最近的点：",
            f"Find the point of the region below {below[1]} that is nearest to $B_0$: ",
        )
        + (_feet_out(letter) if which is None else _foot_in(which)),
        LOOP,
    )
    at = apex
    if which is not None:
        across = board.parallel(0j, 1j * bounds[which].along)
        at = board.meet(across, bounds[which], "")
        board.right_angle(LOOP, at, bounds[which].along, -across.along)
    elif third is not None and cut is not None:
        at = board.meet(cut, third, _MEETING)
        board.join(LOOP, apex, at, Role.DIRECTION)
    if letter != "D":
        board.plot(LOOP, at, letter, Dot.POINT)
    return at, letter


def _feet_out(letter: str) -> Words:
    return Words(
        f"$B_0$ 到 $[α_1]$、$[α_2]$ 界线的垂足都在区域之外，最近点是区域的顶点 ${letter}$。",
        "the feet of the perpendiculars on the bounds of $[α_1]$ and $[α_2]$ lie outside; it is the corner "
        f"${letter}$ of the region.",
    )


def _foot_in(which: int) -> Words:
    return Words(
        f"$B_0$ 到 $[α_{which + 1}]$ 界线的垂足 $E$ 在区域内，它比顶点更近。",
        f"the foot $E$ of the perpendicular on the bound of $[α_{which + 1}]$ lies in it, nearer than any corner.",
    )


_MEETING = Words("许用压力角界线与过 B_0 的界线", "a bound and the line through B_0")


def _cut(trial: Board, bounds: tuple[Line, Line], apex: Points, third: Line) -> Line | None:
    """The bound that meets the third line in the corner nearest to B_0; None where that corner is D."""
    meeting = [line for line in bounds if abs(nominal(cross(line.along, third.along))) > FLAT]
    corners = [(apex, None), *((trial.meet(line, third, _MEETING), line) for line in meeting)]
    allowed = [one for one in corners if _inside(one[0], (*bounds, third))]
    return min(allowed, key=lambda one: float(abs(nominal(one[0]))))[1]


def tell_start(board: Board, at: Points, allowed: Allowed) -> None:
    """Where the rise begins the follower is pushed to the other side, if O lies to the right: what is not bounded."""
    spot = complex(nominal(at))
    angle = degrees(atan2(spot.real, -spot.imag))
    if angle <= degrees(allowed.rise.si) + ON:
        return
    board.step(
        Words(
            f"推程起始处（$s$ = 0，d$s$/d$φ$ = 0）的压力角即 $B_0 O$ 与纵轴的夹角，约 {angle:.0f}°，法线偏向另一侧，"
            "大于 $[α_1]$。若这一侧也须限制，应再过 $B_0$ 作与纵轴成 $[α_1]$ 的第三条界线，$O$ 取在三线之下。",
            "Where the rise begins ($s$ = 0, d$s$/d$φ$ = 0) the pressure angle is that between $B_0 O$ and the "
            f"vertical, about {angle:.0f}°; the follower is pushed to the other side there, at more than $[α_1]$. If "
            "that side is to be bounded too, a third line is drawn through $B_0$ at $[α_1]$ to the vertical, and $O$ "
            "must lie below all three.",
        ),
        LOOP,
    )


def _inside(at: Points, bounds: Sequence[Line]) -> bool:
    """Whether a place lies below the bounds: right of the first as it runs down, left of the others."""
    spot = complex(nominal(at))
    ways = (1, *(-1 for _ in bounds[1:]))
    return all(way * nominal(cross(line.along, spot - line.at)) > -ON for way, line in zip(ways, bounds, strict=True))
