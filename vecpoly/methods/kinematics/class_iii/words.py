"""The sentences of the class III constructions."""

from __future__ import annotations

from typing import assert_never

from ....mechanism.model import FRAME
from ....words import Words
from ...desk import Desk
from .star import Axial, Guided, Hinged, Slotted, Star, called

NO_OFFSET = 1e-9  # m: a slide nearer to its pin than this passes through it


def trial_words(desk: Desk, star: Star, legs: tuple[Axial, ...]) -> Words:
    """How the central link is tried: held by two legs, checked by the third."""
    one, two = (keeps(desk, star, leg) for leg in legs[:2])
    last, left = tried(desk, star, legs[2]), called(legs[2])
    return (
        Words(
            f"Ⅲ级杆组用试凑法定位：暂不计{left.zh}，给中心构件 {star.plate} 取几个试方位，使",
            f"The class III group is found by trial: leave {left.en} out and try the central "
            f"link {star.plate} in several orientations such that ",
        )
        + one
        + Words("，且", " and ")
        + two
        + last
    )


def led_words(desk: Desk, star: Star, legs: tuple[Axial, ...]) -> Words:
    """The central link's orientation is given: two loci place it."""
    leg = star.parallel
    assert leg is not None
    one, two = (keeps(desk, star, other) for other in legs)
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


def keeps(desk: Desk, star: Star, leg: Axial) -> Words:
    """What a leg demands of the central link's place."""
    match leg:
        case Hinged(outer=o, inner=b):
            return Words(
                f" ${b}$ 在以 ${o}$ 为圆心、$l_{o}{b}/μ_l$ 为半径的弧上",
                f"${b}$ lies on the arc about ${o}$ with the radius $l_{o}{b}/μ_l$",
            )
        case Guided(inner=b):
            return Words(f" ${b}$ 在其导路线上", f"${b}$ lies on its guide line")
        case Slotted():
            slide, way = _slide(star, leg), _past(desk, leg)
            return Words(f"{slide.zh}{way.zh}", f"{slide.en} passes {way.en}")
        case _:
            assert_never(leg)


def tried(desk: Desk, star: Star, leg: Axial) -> Words:
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
        case Slotted():
            slide, way = _slide(star, leg), _past(desk, leg)
            return Words(
                f"，直至{slide.zh}也{way.zh}", f"; the right one is that in which {slide.en} also passes {way.en}"
            )
        case _:
            assert_never(leg)


def _slide(star: Star, leg: Slotted) -> Words:
    """What the central link slides with: on another link, or a slot of its own in which a pin runs."""
    if leg.slide.pin_in_slot:
        return Words(f"构件 {star.plate} 的导槽", "its slot")
    return Words(f"构件 {star.plate} 与构件 {leg.link} 间的导路", f"its slide on link {leg.link}")


def _past(desk: Desk, leg: Slotted) -> Words:
    """How a slide lies to the pin of its block: through it, or beside it."""
    q = f"${leg.outer}$"
    if abs(desk.offset(leg.slide, leg.link, leg.outer)) < NO_OFFSET:
        return Words(f"通过 {q}", f"through {q}")
    return Words(f"与 {q} 保持给定的偏距", f"{q} at its given offset")
