"""The shape of a plate cam in words: its base circle, and how the follower moves over a turn."""

from __future__ import annotations

from math import degrees

from ...words import Words
from .cam import Cam
from .motion import Piece


def shape_told(cam: Cam) -> Words:
    """基圆半径 r_0 = 40 mm，0～180° 按等速运动上升 30 mm，180°～360° 按等速运动返回."""
    assert cam.r0 is not None
    told = [_piece(piece, swings=bool(cam.arm)) for piece in cam.pieces]
    text = cam.r0.text
    return Words(
        f"基圆半径 $r_0$ = {text}，从动件在凸轮转角 {'，'.join(one.zh for one in told)}",
        f"base circle $r_0$ = {text}; the follower " + ", ".join(one.en for one in told),
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
