"""What the symbols asked of a cam stand for: no drawing that a student is given tells them."""

from __future__ import annotations

import re

from ...devices.cams.cam import Cam
from ...words import Words

_AT_D = " with the axis at the tip $D$ of the allowed region"
_MEANT = {
    "s0": Words("从动件的起始高度", "the follower's height at the start"),
    "psi0": Words("摆杆的初始摆角", "the arm's angle at the start"),
    "alpha_max": Words("最大压力角", "the maximum pressure angle"),
    "alpha_rise": Words("推程的最大压力角", "the maximum pressure angle of the rise"),
    "alpha_return": Words("回程的最大压力角", "the maximum pressure angle of the return"),
    "rho_min": Words("最小曲率半径", "the minimum radius of curvature"),
    "rho_profile": Words("实际廓线的最小曲率半径", "the minimum radius of curvature of the actual profile"),
    "b_rise": Words("推程所需的平底长度（自导路量起）", "the face's minimum reach from its guide on the rise"),
    "b_return": Words("回程所需的平底长度（自导路量起）", "the face's minimum reach from its guide on the return"),
    "l_min": Words(
        "切点离 $A$ 在平底上垂足的最小距离", "the contact's minimum distance from the foot of $A$ on the face"
    ),
    "l_max": Words(
        "切点离 $A$ 在平底上垂足的最大距离", "the contact's maximum distance from the foot of $A$ on the face"
    ),
    "r0": Words("基圆半径", "the radius of the base circle"),
    "e": Words("偏距", "the offset"),
    "r0_central": Words("对心布置时的基圆半径", "the base circle's radius of a central follower"),
    "r0_apex": Words("轴心取在许用区域尖点 $D$ 时的基圆半径", f"the base circle's radius{_AT_D}"),
    "e_apex": Words("轴心取在 $D$ 时的偏距", f"the offset{_AT_D}"),
    "s0_apex": Words("轴心取在 $D$ 时从动件的起始高度", f"the follower's height at the start{_AT_D}"),
}
_PITCH = Words("理论廓线的最小曲率半径", "the minimum radius of curvature of the pitch curve")  # beside the actual one
_STATIONS = {
    "s": Words("时从动件的位移", "the follower's travel"),
    "psi": Words("时摆杆的摆角", "the arm's angle"),
    "alpha": Words("时的压力角", "the pressure angle"),
    "r": Words("时廓线上点的向径", "the distance of the profile from the cam's axis"),
    "theta": Words(
        "时廓线上点的极角（自起始点的径线按逆时针量）",
        "the profile's polar angle (counter-clockwise from the radius to its first point)",
    ),
}
_STATION = re.compile(r"(s|psi|alpha|r|theta)_(\d+(?:\.\d+)?)")


def meant_by(subject: object, key: str, symbol: str) -> Words | None:
    """The quantity with what it is, $φ$ = 60° 时的压力角 $α_{60}$; None of what the statement tells."""
    if not isinstance(subject, Cam):
        return None
    if (station := _STATION.fullmatch(key)) is not None:
        what, at = _STATIONS[station[1]], f"$φ$ = {station[2]}°"
        return Words(f"{at} {what.zh} {symbol}", f"{what.en} {symbol} at {at}")
    rolls = any(named.key == "rho_profile" for named in subject.quantities())
    meant = _PITCH if key == "rho_min" and rolls else _MEANT.get(key)
    return None if meant is None else Words(f"{meant.zh} {symbol}", f"{meant.en} {symbol}")
