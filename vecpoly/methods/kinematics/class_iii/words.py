"""The sentences of the class III constructions."""

from __future__ import annotations

from typing import assert_never

from ....mechanism.model import FRAME
from ....words import Words
from .star import Axial, Guided, Hinged, Slotted, Star


def trial_words(star: Star, legs: tuple[Axial, ...]) -> Words:
    """How the central link is tried: held by two legs, checked by the third."""
    one, two = (keeps(star, leg) for leg in legs[:2])
    last = tried(star, legs[2])
    return (
        Words(
            f"Ⅲ级杆组用试凑法定位：暂不计构件 {legs[2].link}，给中心构件 {star.plate} 取几个试方位，使",
            f"The class III group is found by trial: leave link {legs[2].link} out and try the central "
            f"link {star.plate} in several orientations, with ",
        )
        + one
        + Words("，且", " and ")
        + two
        + last
    )


def led_words(star: Star, legs: tuple[Axial, ...]) -> Words:
    """The central link's orientation is given: two loci place it."""
    leg = star.parallel
    assert leg is not None
    one, two = (keeps(star, other) for other in legs)
    of_frame = leg.parent == FRAME
    base = Words("机架", "the frame") if of_frame else Words(f"构件 {leg.parent}", f"link {leg.parent}")
    return (
        Words(
            f"构件 {leg.link} 与{base.zh}、构件 {star.plate} 都组成移动副，故中心构件 {star.plate} "
            f"的方位已定：平移构件 {star.plate}，使",
            f"Link {leg.link} forms sliding pairs both with {base.en} and with link {star.plate}, which "
            f"fixes the orientation of the central link {star.plate}: shift it so that ",
        )
        + one
        + Words("，且", " and ")
        + two
    )


def keeps(star: Star, leg: Axial) -> Words:
    """What a leg demands of the central link's place."""
    match leg:
        case Hinged(outer=o, inner=b):
            return Words(
                f" ${b}$ 在以 ${o}$ 为圆心、$l_{o}{b}/μ_l$ 为半径的弧上",
                f"${b}$ on the arc about ${o}$ with the radius $l_{o}{b}/μ_l$",
            )
        case Guided(inner=b):
            return Words(f" ${b}$ 在其导路线上", f"${b}$ on its guide line")
        case Slotted(outer=q):
            return Words(
                f"构件 {star.plate} 与构件 {leg.link} 间的导路通过 ${q}$（或与 ${q}$ 保持偏距）",
                f"its slide on link {leg.link} passing ${q}$ (at the given offset, if any)",
            )
        case _:
            assert_never(leg)


def tried(star: Star, leg: Axial) -> Words:
    """How the third leg tells which trial is right."""
    match leg:
        case Hinged(outer=o, inner=b):
            return Words(
                f"，描出 ${b}$ 的轨迹；它与以 ${o}$ 为圆心、$l_{o}{b}/μ_l$ 为半径的弧的交点即为 ${b}$",
                f"; trace the path of ${b}$. Where it cuts the arc about ${o}$ with the radius $l_{o}{b}/μ_l$ is ${b}$",
            )
        case Guided(inner=b):
            return Words(
                f"，描出 ${b}$ 的轨迹；它与 ${b}$ 的导路线的交点即为 ${b}$",
                f"; trace the path of ${b}$. Where it cuts the guide line of ${b}$ is ${b}$",
            )
        case Slotted(outer=q):
            return Words(
                f"；直到构件 {star.plate} 与构件 {leg.link} 间的导路也通过 ${q}$（或与 ${q}$ 保持偏距）为止",
                f", until its slide on link {leg.link} passes ${q}$ too (at the given offset, if any)",
            )
        case _:
            assert_never(leg)
