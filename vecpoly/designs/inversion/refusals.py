"""Why positions give no linkage: the reason, the numbers, and what the lecturer changes."""

from __future__ import annotations

from cmath import phase
from collections.abc import Sequence
from math import degrees

from ...errors import AssemblyError
from ...words import Words
from .plan import FRAME, Assemble, CentrePoints, Find, Limits


def collinear(stage: Find, seen: Sequence[complex], along: complex) -> AssemblyError:
    """The places of the known pin lie on a line: the sought pin is at infinity."""
    pin, known = stage.pin, stage.known
    places = ", ".join(f"({1e3 * at.real:.6g}, {1e3 * at.imag:.6g})" for at in seen)
    where = (
        Words("", "") if stage.on == FRAME else Words(f"（在构件 {stage.on} 看来）", f" as link {stage.on} sees them")
    )
    slope = degrees(phase(along)) % 180
    return AssemblyError(
        Words(
            f"{known} 的三个位置 {places} mm{where.zh}共线，两中垂线平行，{pin} 在无穷远处：{known} 需要一个滑块，"
            f"其导路与 x 轴成 {slope:.6g}°；请改用滑块，或另取 {known}",
            f"the three places {places} mm of {known}{where.en} lie on a straight line, the bisectors are parallel and "
            f"{pin} is at infinity: {known} needs a slider, on a guide at {slope:.6g} deg to the x axis; use a slider, "
            f"or choose another {known}",
        ),
        code="collinear",
        numbers={"slope": slope},
    )


def coincident(stage: Find) -> AssemblyError:
    """Two places of the known pin are one: their bisector is any line."""
    return AssemblyError(
        Words(
            f"{stage.known} 的两个位置（在 {stage.pin} 所在构件看来）重合，中垂线不定，{stage.pin} 不能确定；"
            f"请另取 {stage.known} 或另给位置",
            f"two places of {stage.known}, as the body of {stage.pin} sees them, are one: their bisector is any line, "
            f"and {stage.pin} remains undetermined; choose another {stage.known}, or other positions",
        ),
        code="undetermined",
    )


def parallel(stage: Find, along: complex) -> AssemblyError:
    """The bisector does not meet the line on which the pin must lie."""
    slope = degrees(phase(along)) % 180
    return AssemblyError(
        Words(
            f"{stage.known} 两位置连线的中垂线与 {stage.pin} 所在的直线平行（与 x 轴成 {slope:.6g}°），没有交点；"
            f"请为 {stage.pin} 另取一条直线",
            f"the bisector of the two places of {stage.known} is parallel to the line on which {stage.pin} must lie "
            f"(at {slope:.6g} deg to the x axis), and does not meet it; choose another line for {stage.pin}",
        ),
        code="parallel",
        numbers={"slope": slope},
    )


def out_of_reach(stage: Assemble, apart: float) -> AssemblyError:
    """Two links cannot be joined in one of the positions."""
    one, two = 1e3 * stage.to_one, 1e3 * stage.to_two
    least, most = abs(one - two), one + two
    return AssemblyError(
        Words(
            f"{stage.pin}：{stage.one}、{stage.two} 相距 {1e3 * apart:.6g} mm，长 {one:.6g} mm 与 {two:.6g} mm "
            f"的两构件只能联接相距 {least:.6g} 至 {most:.6g} mm 的两点；请改变长度或位置",
            f"{stage.pin}: {stage.one} and {stage.two} are {1e3 * apart:.6g} mm apart, and links of {one:.6g} mm and "
            f"{two:.6g} mm join points between {least:.6g} and {most:.6g} mm apart; change lengths or positions",
        ),
        code="out-of-reach",
    )


def no_limit(stage: Limits, met: int) -> AssemblyError:
    """No ray at θ to the given limit meets the rocker's circle on the side where the other limit must be."""
    theta, side = degrees(stage.theta), stage.limit.label
    c = stage.pin
    return AssemblyError(
        Words(
            f"与 {stage.about}{c}1 成 θ = {theta:.6g}° 的射线与 {c} 的圆弧有 {met} 个交点，没有一个使 {c}1 成为"
            f"{side.zh}极限；请改变 K，或另取 {c}1",
            f"the rays at θ = {theta:.6g} deg to {stage.about}{c}1 meet the circle of {c} in {met} points, none of "
            f"which makes {c}1 the {side.en} limit; change K, or choose another {c}1",
        ),
        code="no-limit",
        numbers={"theta": theta},
    )


def no_centre_point(stage: CentrePoints, found: int, valid: int = 0) -> AssemblyError:
    """The centre-point curve does not meet the lines in pins for two bars; valid: with how many an ideal hand does."""
    if valid:
        return _lost(found, valid)
    pins = f"{stage.one[0]}, {stage.two[0]}"
    return AssemblyError(
        Words(
            f"给定直线与四个位置的圆心曲线只有 {found} 个可用的交点，不足以取两个固定铰链 {pins}；请移动直线",
            f"the given lines meet the centre-point curve of the four positions in only {found} "
            f"point{'' if found == 1 else 's'} that serve{'s' if found == 1 else ''}, too few for the two fixed pins "
            f"{pins}; move the lines",
        ),
        code="no-centre-point",
        numbers={"found": found},
    )


def _lost(found: int, valid: int) -> AssemblyError:
    """A hand that scatters does not find what is there."""
    return AssemblyError(
        Words(
            f"作图条件差，误差大：按此手法作图只得到 {found} 个圆心点，而准确作图有 {valid} 个解；"
            "请用 --hand drafting 或改变所给位置",
            f"ill-conditioned: this hand finds only {found} centre point{'' if found == 1 else 's'}, where an exact "
            f"drawing has {valid} solution{'' if valid == 1 else 's'}; use --hand drafting, or other positions",
        ),
        code="lost-by-hand",
        numbers={"found": found, "solutions": valid},
    )
