"""The shape of a plate cam in words: its base circle, and how the follower moves over a turn."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from math import degrees

from ...words import Words
from .follower import Follower
from .motion import Piece


def shape_told(base_circle: str, pieces: Sequence[Piece], *, swings: bool) -> Words:
    """基圆半径 r_0 = 40 mm，0～180° 按等速运动上升 30 mm，180°～360° 按等速运动返回."""
    told = [_from_to(piece, swings=swings) for piece in pieces]
    return Words(
        f"基圆半径 $r_0$ = {base_circle}，从动件在凸轮转角 {'，'.join(one.zh for one in told)}",
        f"base circle $r_0$ = {base_circle}; the follower " + ", ".join(one.en for one in told),
    )


def motion_told(follower: Follower, pieces: Sequence[Piece], *, clockwise: bool) -> Words:
    """凸轮逆时针匀速转动，滚子移动从动件（导路在 O 右侧）在 120° 内按余弦加速度运动上升 30 mm，停歇 30°……"""
    zh, en = ("顺时针", "clockwise") if clockwise else ("逆时针", "counter-clockwise")
    end = _FLAT if follower.flat else _ROLLER if follower.roller else _KNIFE
    way = Words("摆动", "oscillating") if follower.arm else Words("移动", "translating")
    side, told = _side(follower), [_within(piece, swings=bool(follower.arm)) for piece in pieces]
    return Words(
        f"凸轮{zh}匀速转动，{end.zh}{way.zh}从动件{side.zh}{'，'.join(one.zh for one in told)}",
        f"the cam turns uniformly {en}; its {way.en} {end.en} follower{side.en} {', '.join(one.en for one in told)}",
    )


_KNIFE, _ROLLER, _FLAT = Words("尖顶", "knife-edge"), Words("滚子", "roller"), Words("平底", "flat-faced")


def _side(follower: Follower) -> Words:
    """On which side of O it is guided, or pivoted."""
    beside = follower.e if follower.arm is None else follower.arm.sign
    if not beside:
        return Words("", "")
    zh, en = ("右", "right") if beside > 0 else ("左", "left")
    if follower.arm is not None:
        return Words(f"（转轴 $A$ 在 $O$ {zh}侧）", f", pivoted at $A$ to the {en} of $O$,")
    return Words(f"（导路在 $O$ {zh}侧）", f", guided to the {en} of $O$,")


def _from_to(piece: Piece, *, swings: bool) -> Words:
    start, end = (f"{degrees(angle):g}°" for angle in (piece.start, piece.end))
    if not piece.rises or piece.law is None:
        return Words(f"{start}～{end} 停歇", f"dwells from {start} to {end}")
    way, lift, law = _way(piece, swings=swings), _lift(piece, swings=swings), piece.law.called
    return Words(f"{start}～{end} 按{law.zh}{way.zh} {lift}", f"{way.en} {lift} from {start} to {end} by {law.en}")


def _within(piece: Piece, *, swings: bool) -> Words:
    angle = f"{degrees(piece.angle):g}°"
    if not piece.rises or piece.law is None:
        return Words(f"停歇 {angle}", f"dwells for {angle}")
    way, lift, law = _way(piece, swings=swings), _lift(piece, swings=swings), piece.law.called
    return Words(f"在 {angle} 内按{law.zh}{way.zh} {lift}", f"{way.en} {lift} in {angle} by {law.en}")


def _way(piece: Piece, *, swings: bool) -> Words:
    up = piece.rises > 0
    zh = ("摆出" if swings else "上升") if up else ("摆回" if swings else "返回")
    return Words(zh, ("swings out" if swings else "rises") if up else ("swings back" if swings else "returns"))


def _lift(piece: Piece, *, swings: bool) -> str:
    return f"{degrees(piece.lift):g}°" if swings else f"{1e3 * piece.lift:g} mm"


def cam_task(follower: Follower, *, sized: bool, bounded: bool) -> Words:
    """Which cam it is, in which letters; sized: whether the least base circle is sought; bounded: with [α_0], too."""
    end = _FLAT if follower.flat else _ROLLER if follower.roller else _KNIFE
    way = Words("摆动", "an oscillating") if follower.arm else Words("直动", "a translating")
    rest = (_ALLOWED + _THIRD if bounded else _ALLOWED) if sized else _BASES[bool(follower.roller)]
    own = "".join(one.zh for one in _own(follower)), "".join(one.en for one in _own(follower))
    return Words(
        f"{way.zh}{end.zh}从动件盘形凸轮绕 $O$ 转动，$φ$ 为凸轮自推程起点的转角{rest.zh}{own[0]}。",
        f"A plate cam turns about $O$ and moves {way.en} {end.en} follower; $φ$ is the cam's angle from the beginning "
        f"of the rise{rest.en}{own[1]}.",
    )


_BASES = {
    False: Words("，$r_0$ 为基圆半径", "; $r_0$ is the radius of the base circle"),
    True: Words("，$r_0$ 为理论廓线的基圆半径", "; $r_0$ is the radius of the base circle of the pitch curve"),
}
_ALLOWED = Words(
    "，$[α_1]$、$[α_2]$ 为推程和回程的许用压力角，求最小的基圆",
    "; $[α_1]$ and $[α_2]$ are the pressure angles allowed on the rise and on the return, and the smallest base circle "
    "is sought",
)
_THIRD = Words(
    "，$[α_0]$ 为推程起始处另一侧的许用压力角", ", with $[α_0]$ allowed to the other side where the rise begins"
)


def _own(follower: Follower) -> Iterator[Words]:
    """What is given of the follower."""
    if follower.roller:
        yield Words("，滚子半径为 $r_r$", ", $r_r$ that of the roller")
    if follower.offset is not None:
        yield Words(
            "，偏距为 $e$（导路在 $O$ 右侧为正）", ", $e$ the offset of the guide, positive to the right of $O$"
        )
    if follower.arm is None:
        return
    yield Words("，$l_{OA}$ 为 $O$ 到摆动中心 $A$ 的距离", ", $l_{OA}$ the distance of the pivot $A$ from $O$")
    if follower.arm.AB is not None:
        yield Words("，$l_{AB}$ 为摆杆的长度", ", $l_{AB}$ the length of the arm")
    if follower.arm.face is not None:
        yield Words(
            "，$d$ 为平底到 $A$ 的距离（背离凸轮为正）",
            ", $d$ the distance of the face from $A$, positive away from the cam",
        )
