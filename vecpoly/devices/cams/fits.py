"""Whether a cam and its follower go together: the guide meets the base circle, the arm reaches it and can swing."""

from __future__ import annotations

from collections.abc import Iterable
from math import acos, asin, degrees, pi

from ...errors import FaultError
from ...foundation.bounds import below
from ...units.reading import Quantity
from ...words import Words
from .follower import Arm, Follower
from .motion import Piece

SWUNG = pi * 0.95  # rad: an arm stays this far from stretched
UPRIGHT = pi * 0.45  # rad: a flat face stays this far from standing across OA


def first_angle(r0: Quantity, arm: Arm, *, flat: bool = False) -> float:
    """The angle OAB at the start, or that between OA and a flat face (rad)."""
    oa, ab = arm.OA.si, arm.length
    return asin((r0.si - arm.off) / oa) if flat else acos((oa**2 + ab**2 - r0.si**2) / (2 * oa * ab))


def may_be_sized(follower: Follower) -> None:
    """The minimum base circle is sought of a guided follower whose offset is free."""
    if follower.flat or follower.arm or follower.offset:
        raise FaultError(
            Words(
                "由 alpha 求最小基圆只用于直动尖顶或滚子从动件，偏距一并求出；请略去 flat、arm、offset",
                "the minimum base circle is found for a translating knife edge or roller, together with its "
                "offset; leave out flat, arm and offset",
            ),
            code="contradiction",
            keys=tuple(("follower", key) for key in ("flat", "offset", "arm")),
        )


def clears(r0: Quantity, follower: Follower) -> None:
    """The guide passes the base circle, and the roller leaves a cam."""
    if abs(follower.e) >= r0.si:
        raise FaultError(
            Words(
                f"偏距 {_mm(follower.e)} 不小于基圆半径 r0 = {r0.text}，导路不与基圆相交；|offset| 应小于 r0",
                f"the offset {_mm(follower.e)} is not below r0 = {r0.text}: the guide misses the base "
                "circle; |offset| must be less than r0",
            ),
            code="out-of-range",
            keys=(("follower", "offset"), "r0"),
        )
    if follower.radius >= r0.si:
        raise FaultError(
            Words(
                f"滚子半径 {_mm(follower.radius)} 不小于 r0 = {r0.text}，凸轮没有实体；滚子半径应小于 r0",
                f"the roller's radius {_mm(follower.radius)} is not below r0 = {r0.text} and leaves no cam; "
                "it must be less than r0",
            ),
            code="out-of-range",
            keys=(("follower", "roller"), "r0"),
        )


def closes(r0: Quantity, follower: Follower, lift: float) -> None:
    """O, A and B make a triangle, and the arm does not come to lie along OA."""
    assert follower.arm
    if follower.flat:
        _tangent(r0, follower.arm, lift)
        return
    oa, ab = follower.arm.OA.si, follower.arm.length
    if not abs(oa - ab) < r0.si < oa + ab:
        raise FaultError(
            Words(
                f"r0 = {r0.text}、OA = {_mm(oa)}、AB = {_mm(ab)} 不能构成三角形；r0 应在 {_mm(abs(oa - ab))} "
                f"与 {_mm(oa + ab)} 之间",
                f"r0 = {r0.text}, OA = {_mm(oa)} and AB = {_mm(ab)} make no triangle; r0 must lie between "
                f"{_mm(abs(oa - ab))} and {_mm(oa + ab)}",
            ),
            code="out-of-range",
            keys=("r0", ("follower", "arm")),
        )
    psi0 = first_angle(r0, follower.arm)
    if psi0 + lift >= SWUNG:
        raise FaultError(
            Words(
                f"摆杆初始角 {degrees(psi0):.4g} deg，再摆 {degrees(lift):.4g} deg 就伸直了；摆角应小于 "
                f"{degrees(SWUNG - psi0):.4g} deg",
                f"the arm starts at {degrees(psi0):.4g} deg and after {degrees(lift):.4g} deg more it "
                f"would be stretched; let it swing less than {degrees(SWUNG - psi0):.4g} deg",
            ),
            code="out-of-range",
            keys=("r0", "motion", ("follower", "arm")),
        )


def _tangent(r0: Quantity, arm: Arm, lift: float) -> None:
    """The face touches the base circle from above, and its arm does not come to stand across OA."""
    oa, level = arm.OA.si, r0.si - arm.off
    if not 0 < level < oa:
        raise FaultError(
            Words(
                f"r0 − face = {_mm(level)}，平底不能从上方切于基圆；face 应在 {_mm(r0.si - oa)} 与 {_mm(r0.si)} 之间",
                f"r0 − face = {_mm(level)}: the face does not touch the base circle from above; face must lie "
                f"between {_mm(r0.si - oa)} and {_mm(r0.si)}",
            ),
            code="out-of-range",
            keys=("r0", ("follower", "arm")),
        )
    psi0 = first_angle(r0, arm, flat=True)
    if psi0 + lift >= UPRIGHT:
        raise FaultError(
            Words(
                f"平底初始角 {degrees(psi0):.4g} deg，再摆 {degrees(lift):.4g} deg 就近于与 OA 垂直；"
                "摆角应小于 "
                f"{degrees(UPRIGHT - psi0):.4g} deg",
                f"the face starts at {degrees(psi0):.4g} deg and after {degrees(lift):.4g} deg more it "
                f"would stand nearly across OA; let it swing less than {degrees(UPRIGHT - psi0):.4g} deg",
            ),
            code="out-of-range",
            keys=("r0", "motion", ("follower", "arm")),
        )


def stays_behind(pieces: Iterable[Piece], way: int) -> None:
    """A flat face that swings with the cam (in the pieces that go this way) is slower than it: else the contact is at
    infinity where both turn alike."""
    for piece in pieces:
        if piece.law is None or piece.rises != way or below(piece.law.fastest * piece.lift, piece.angle):
            continue
        swing, angle = degrees(piece.lift), degrees(piece.angle)
        most, least = angle / piece.law.fastest, swing * piece.law.fastest
        raise FaultError(
            Words(
                f"平底在凸轮转过 {angle:.4g} deg 时随凸轮同向摆 {swing:.4g} deg（{piece.law.called.zh}），某刻与凸轮"
                f"转得一样快，切点在无穷远处；摆角应小于 {most:.4g} deg，或转角应大于 {least:.4g} deg",
                f"the face swings {swing:.4g} deg with the cam while that turns {angle:.4g} deg "
                f"({piece.law.called.en}): for a moment both turn alike, and the contact is at infinity; let it swing "
                f"less than {most:.4g} deg, or take more than {least:.4g} deg of the cam for it",
            ),
            code="out-of-range",
            numbers={"swing": swing, "angle": angle},
            keys=("motion",),
        )


def _mm(metres: float) -> str:
    return f"{1e3 * metres:.6g} mm"
