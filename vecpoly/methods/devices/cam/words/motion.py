"""What the steps of a cam's construction say of its motion."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise
from math import degrees

from .....algebra.quantity import number
from .....board.board import Board
from .....board.construction import View
from .....devices.cams.cam import Cam
from .....devices.cams.motion import Law, Piece
from .....plane import nominal
from .....words import Words, begun
from ...bench import trial_board
from ..laws import lift, stretches

JUMP = 1e-6  # of the stroke over the angle, or its square: a smaller jump is none
_HOW = {
    Law.UNIFORM: Words("连接起点与终点的直线", "the straight line from start to end"),
    Law.PARABOLIC: Words(
        "中点处的纵距等分，自顶点向各分点引射线，交各分点的纵线（纵距增量之比为 1∶3∶5…，后半程自终点反向作）",
        "the ordinate in the middle is divided equally and rays are drawn from the vertex to the divisions, to meet "
        "the ordinates of the stations (increments as 1 : 3 : 5 ...; the second half from the other end)",
    ),
    Law.COSINE: Words(
        "以行程为直径作半圆，按相同的份数等分，由各分点作水平线",
        "a semicircle over the stroke is divided into as many parts, and levels are drawn from its points",
    ),
    Law.SINE: Words(
        "以行程的 1/2π 为半径的滚圆按相同的份数等分，各分点投影到纵轴后作对角线的平行线",
        "a rolling circle whose radius is the stroke over 2π is divided into as many parts; its points are projected "
        "on the axis and carried on parallel to the diagonal",
    ),
    Law.POLYNOMIAL: Words(
        "位移为行程的 10$u$³ − 15$u$⁴ + 6$u$⁵ 倍（$u$ 为转过的角度与该段运动角之比），列表取值",
        "the displacement is the stroke times 10$u$³ − 15$u$⁴ + 6$u$⁵, $u$ being the ratio of the angle turned through "
        "to that of this motion; its values are tabulated",
    ),
}


def how_drawn(cam: Cam) -> Words:
    """The construction of every law that occurs."""
    laws = dict.fromkeys(piece.law for piece in cam.pieces if piece.law is not None)
    zh = "；".join(f"{law.called.zh}：{_HOW[law].zh}" for law in laws)
    en = "; ".join(f"{law.called.en}: {_HOW[law].en}" for law in laws)
    return begun(Words(zh, en))


def shocks(board: Board, place: View, cam: Cam) -> Words:
    """Where velocity or acceleration jump, read off the diagrams from both sides."""
    trial = trial_board(board)
    ends = [(_ends(trial, place, piece), piece) for piece in cam.pieces]
    hard, soft = [], []
    for (before, piece), (after, _) in pairwise([*ends, ends[0]]):
        big = cam.lift
        if abs(after[0][0] - before[1][0]) > JUMP * big:
            hard.append(piece.end)
        elif abs(after[0][1] - before[1][1]) > JUMP * big:
            soft.append(piece.end)
    soft += [piece.start + piece.angle / 2 for piece in cam.pieces if piece.law is Law.PARABOLIC]
    return _said(sorted(hard), sorted(soft))


def corners(board: Board, place: View, cam: Cam) -> bool:
    """Whether the velocity drops at once somewhere: the pitch curve has a corner there that points outward."""
    trial = trial_board(board)
    ends = [_ends(trial, place, piece) for piece in cam.pieces]
    return any(after[0][0] - before[1][0] < -JUMP * cam.lift for before, after in pairwise([*ends, ends[0]]))


def _ends(trial: Board, place: View, piece: Piece) -> tuple[tuple[float, float], tuple[float, float]]:
    """s′ and s″ at the start and at the end of a piece."""
    (*_, first), (*_, last) = (stretches(piece)[i] for i in (0, -1))
    found = lift(trial, place, piece, piece.start, late=first), lift(trial, place, piece, piece.end, late=last)
    start, end = ((float(nominal(at.slope)), float(nominal(at.bend))) for at in found)
    return start, end


def _said(hard: Sequence[float], soft: Sequence[float]) -> Words:
    if not hard and not soft:
        return Words("速度和加速度均无突变，没有冲击。", " Neither velocity nor acceleration jumps: there is no shock.")
    told = Words("", "")
    if hard:
        told += Words(
            f"在 $φ$ = {_listed(hard, '、')} 处速度突变，有刚性冲击。",
            f" The velocity jumps at $φ$ = {_listed(hard, ', ')}: rigid shock.",
        )
    if soft:
        told += Words(
            f"在 $φ$ = {_listed(soft, '、')} 处加速度突变，有柔性冲击。",
            f" The acceleration jumps at $φ$ = {_listed(soft, ', ')}: soft shock.",
        )
    return told


def _listed(angles: Sequence[float], mark: str) -> str:
    return mark.join(f"{number(degrees(angle))}°" for angle in angles)
