"""The minimum base circle under allowed pressure angles: the loop of s over ds/dφ, and the bounds that touch it."""

from __future__ import annotations

from collections.abc import Sequence
from math import cos, sin

import numpy as np

from ....board.board import Board
from ....board.paper.marks import Dot, Role
from ....devices.cams.asked import APEX, CENTRAL, R0, S0, E
from ....devices.cams.cam import Allowed, Cam
from ....devices.cams.motion import Piece
from ....names import Named
from ....plane import Line, Points, Reals, cross, nominal
from ....words import Words
from ..bench import Bench, trial_board
from ..inclined import between
from .extremes import Merit, best
from .laws import Lift, lift
from .nearest import BELOW, MARK, nearest, tell_start, third_bound
from .read.readings import length
from .scales import DISPLACEMENT, LOOP, steepest

EACH = 6  # stations of half a rise or a return that are drawn of the loop
BEYOND = 10.0  # mm: the axes past the loop


def least_circle(bench: Bench, cam: Cam) -> None:
    """r0, e and s0 of the least circle; of the apex; r0 without offset."""
    assert cam.alpha is not None
    bounds = _loop(bench, cam, cam.alpha)
    apex = _apex(bench, cam, bounds)
    third = third_bound(bench, cam.alpha.start.si, apex) if cam.alpha.start else None
    at, letter = nearest(bench.board, bounds, apex, third)
    _measured(bench, at, (R0, E, S0), letter, cam.sense)
    if third is None:
        tell_start(bench.board, at, cam.alpha)
    _central(bench, bounds)


def _loop(bench: Bench, cam: Cam, allowed: Allowed) -> tuple[Line, Line]:
    """The loop through its stations, and the line on either side that touches it."""
    board = bench.board
    board.section(Words("最小基圆半径", "The minimum base circle"))
    board.step(
        Words(
            "以 d$s$/d$φ$ 为横坐标、$s$ 为纵坐标（比例尺同为 $μ_s$；凸轮顺时针转时，图中横坐标以向左为正）作推程和回"
            "程的线图，各值由运动规律的作图得出。凸轮轴心 $O$ 若在此图的 ($e$, $−s_0$)，则压力角就是它与曲线上各点的"
            "连线和纵轴的夹角。作与纵轴成 $[α]$ 并与曲线相切的两条直线，$O$ 应在两线之下（各程只限制法线偏向受推一侧"
            "的压力角）。",
            "Draw the loop with d$s$/d$φ$ to the right and $s$ upwards, both to $μ_s$, from the constructions of the "
            "laws (for a cam that turns clockwise right and left change). If $O$ lies at ($e$, $−s_0$) on it, the "
            "pressure angle is that between the vertical and the line from $O$ to the point of the loop. Draw the "
            "lines at $[α]$ to the vertical that touch the loop: $O$ must lie below both (of each stroke only the "
            "side to which the cam pushes is bounded).",
        ),
        LOOP,
    )
    _axes(board, cam)
    sides = []
    for way, angle in ((1, allowed.rise.si), (-1, allowed.back.si)):
        pieces = [piece for piece in cam.pieces if piece.rises == way]
        _curves(board, pieces)
        along = complex(-way * sin(angle), -cos(angle))
        spot = best(board, DISPLACEMENT, pieces, _touching(along, way))
        at = lift(board.scratch(), DISPLACEMENT, spot.piece, spot.phi, late=spot.late)
        touch = _point(board, at)
        board.plot(LOOP, touch, "T_1" if way > 0 else "T_2", Dot.POINT)
        sides.append(board.parallel(touch, along))
    board.plot(LOOP, 0j, "B_0", Dot.POLE)
    return sides[0], sides[1]


def _axes(board: Board, cam: Cam) -> None:
    """ds/dφ to both sides, the return's being negative, and s upwards."""
    scale = board.scale_of(LOOP).value
    right, left = (steepest(cam, way) / scale + BEYOND for way in (1, -1))
    for start, end, label in ((-left, right + 0j, "ds/dφ"), (0j, 1j * (cam.lift / scale + BEYOND), "s")):
        board.arrow(LOOP, start, end, Role.DIRECTION)
        board.plot(LOOP, end, label, Dot.NONE)


def _curves(board: Board, pieces: Sequence[Piece]) -> None:
    for piece in pieces:
        trial = trial_board(board)
        middle = piece.start + piece.angle / 2  # where the acceleration may jump, the loop has a corner
        for low, high in ((piece.start, middle), (middle, piece.end)):
            found = [lift(trial, DISPLACEMENT, piece, phi) for phi in np.linspace(low, high, EACH + 1)]
            board.curve(LOOP, [_point(trial, at) for at in found], Role.RESULT)


def _point(board: Board, at: Lift) -> Points:
    """ds/dφ to the right, s upwards."""
    mm = board.scale_of(LOOP).value
    return board.lay_off(board.lay_off(0j, 1 + 0j, at.slope / mm), 1j, at.s / mm)


def _touching(along: complex, way: int) -> Merit:
    """How far a point of the loop lies out of the line through the origin with this direction."""

    def merit(trial: Board, phi: Reals, at: Lift) -> Reals:
        return way * cross(along, at.slope + 1j * at.s)

    return merit


def _apex(bench: Bench, cam: Cam, bounds: tuple[Line, Line]) -> Points:
    board = bench.board
    board.step(Words("两线交于 $D$。$O$ 取在 $D$ 时：", "The lines meet at $D$. With $O$ at $D$ these are:"), LOOP)
    apex = board.meet(*bounds, Words("两条许用压力角界线", "the two bounds"))
    for line, label in zip(bounds, ("[α_1]", "[α_2]"), strict=True):
        end = line.at + (apex - line.at) * BELOW
        board.join(LOOP, line.at, end, Role.DIRECTION)
        board.join(LOOP, end, end + 1j * (MARK + 6), Role.CENTRE)
        between(bench, LOOP, end, 1j + 0j, line.at - end, MARK, label)
    board.plot(LOOP, apex, "D", Dot.POINT)
    _measured(bench, apex, APEX, "D", cam.sense)
    return apex


def _measured(bench: Bench, at: Points, named: tuple[Named, Named, Named], letter: str, sense: int) -> None:
    """r0 = B_0 O; e and s0 are its parts to the right and down."""
    board = bench.board
    board.join(LOOP, 0j, at, Role.CONSTRUCTION)
    level = at.real + 0j
    board.join(LOOP, 0j, level, Role.CENTRE)
    board.join(LOOP, level, at, Role.CONSTRUCTION)
    board.plot(LOOP, level, f"{letter}′", Dot.POINT)
    length(bench, named[0], LOOP, 0j, at, f"B_0 {letter}")
    right = 1 if float(nominal(at.real)) >= 0 else -1
    length(bench, named[1], LOOP, 0j, level, f"B_0 {letter}′", right * sense)
    length(bench, named[2], LOOP, level, at, f"{letter}′ {letter}")


def _central(bench: Bench, bounds: tuple[Line, Line]) -> None:
    board = bench.board
    board.step(
        Words(
            "对心布置（$e$ = 0）时，取两线与纵轴交点中的低者：",
            "Without offset ($e$ = 0), take the lower of the two points in which the lines meet the vertical axis:",
        ),
        LOOP,
    )
    axis = Line(0j, board.turn(-1j))
    spots = [board.meet(line, axis, Words("界线与纵轴", "a bound and the axis")) for line in bounds]
    low = min(spots, key=lambda at: float(nominal(at).imag))
    board.join(LOOP, 0j, low, Role.CENTRE)
    board.plot(LOOP, low, "O_c", Dot.POINT)
    length(bench, CENTRAL, LOOP, 0j, low, "B_0 O_c")
