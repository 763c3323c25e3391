"""The shape of a plate cam in words: its base circle, and how the follower moves over a turn."""

from __future__ import annotations

from collections.abc import Sequence
from math import degrees

from ...words import Words
from .follower import Follower
from .motion import Piece


def shape_told(radius: str, pieces: Sequence[Piece], *, swings: bool) -> Words:
    """基圆半径 r_0 = 40 mm，0～180° 按等速运动上升 30 mm，180°～360° 按等速运动返回."""
    return Words(f"基圆半径 $r_0$ = {radius}，", f"base circle $r_0$ = {radius}; ") + _moved(pieces, swings=swings)


def cam_told(turns: str, follower: Follower, pieces: Sequence[Piece]) -> Words:
    """凸轮顺时针匀速转动；从动件为滚子摆动从动件，A 在 O 左侧；从动件在凸轮转角 0～130° 按……"""
    zh, en = ("逆时针", "counter-clockwise") if turns == "ccw" else ("顺时针", "clockwise")
    turning = Words(f"凸轮{zh}匀速转动，", f"the cam turns uniformly {en}, ")
    moved = _moved(pieces, swings=follower.arm is not None)
    return turning + _ended(follower) + Words("，", "; ") + moved


def _ended(follower: Follower) -> Words:
    """What kind of follower it is, and on which side it is guided or pivoted."""
    zh, en = ("尖顶", "a knife edge") if follower.knife else ("平底", "a flat face") if follower.flat else _ROLLER
    if follower.arm is not None:
        side = Words("右", "right") if follower.arm.sign > 0 else Words("左", "left")
        where = Words(f"，转轴 $A$ 在 $O$ {side.zh}侧", f" that swings about $A$ on the {side.en} of $O$")
        return Words(f"{zh}摆动从动件", f"the follower is an arm with {en}") + where
    guided = Words(f"{zh}直动从动件", f"the follower has {en} and is guided in a straight line")
    if not follower.e:
        return guided
    side = Words("右", "right") if follower.e > 0 else Words("左", "left")
    return guided + Words(f"，导路在 $O$ {side.zh}侧", f" to the {side.en} of $O$")


_ROLLER = ("滚子", "a roller")


def _moved(pieces: Sequence[Piece], *, swings: bool) -> Words:
    """How the follower moves over a turn."""
    told = [_piece(piece, swings=swings) for piece in pieces]
    return Words(
        f"从动件在凸轮转角 {'，'.join(one.zh for one in told)}", "the follower " + ", ".join(one.en for one in told)
    )


def _piece(piece: Piece, *, swings: bool) -> Words:
    start, end = (f"{degrees(angle):g}°" for angle in (piece.start, piece.end))
    if not piece.rises or piece.law is None:
        return Words(f"{start}～{end} 停歇", f"dwells from {start} to {end}")
    lift = f"{degrees(piece.lift):g}°" if swings else f"{1e3 * piece.lift:g} mm"
    law, up = piece.law.called, piece.rises > 0
    zh = ("摆出" if swings else "上升") if up else ("摆回" if swings else "返回")
    en = ("swings out" if swings else "rises") if up else ("swings back" if swings else "returns")
    return Words(f"{start}～{end} 按{law.zh}{zh} {lift}", f"{en} {lift} from {start} to {end} by {law.en}")
