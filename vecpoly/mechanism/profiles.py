"""A plate cam in a mechanism: its profile is no circle, and moves its follower by a law of motion."""

from __future__ import annotations

from collections.abc import Hashable, Sequence

from ..errors import NoMethodError
from ..foundation.slotted import dataclass
from ..words import Words


@dataclass(frozen=True, slots=True, kw_only=True)
class CamProfile:
    """The profile of a driving link, and who follows it.

    pivot: where the link turns on the frame; centre: letter of the profile's centre of curvature at the contact (of
    the pitch curve's too), which wanders on the cam; end: letter of the follower's tip, or of a point of its face.
    cam: data of the device, known to whoever draws or solves it. outline: points of the profile in the link's
    coordinates (m), where a drawing has found them.
    """

    link: str
    pivot: str
    centre: str
    point: str  # letter of the contact
    follower: str
    end: str
    cam: Hashable
    outline: tuple[complex, ...] = ()


def refuse_profiles(cams: Sequence[CamProfile], what: Words) -> None:
    """Raise NoMethodError for what holds at one place of a cam alone, where it would be told of all its places."""
    if cams:
        raise NoMethodError(
            Words(
                f"{what.zh}不适用于带廓线的凸轮 {cams[0].link}：其曲率中心随位置而变；请用 vecpoly cycle 或 vecpoly "
                "play",
                f"{what.en} does not go with the profile of cam {cams[0].link}, whose centre of curvature changes from "
                "place to place; take 'vecpoly cycle' or 'vecpoly play'",
            ),
            code="cam-profile",
        )


def refuse_centre(cams: Sequence[CamProfile], point: str) -> None:
    """Raise NoMethodError for the path of a profile's centre of curvature."""
    for cam in (one for one in cams if one.centre == point):
        raise NoMethodError(
            Words(
                f"{point} 是凸轮 {cam.link} 的廓线在接触点的曲率中心，在每一位置为凸轮上另一点，没有自己的轨迹；"
                "请另取一点",
                f"{point} is the centre of curvature of the profile of cam {cam.link} at the contact, another point of "
                "the cam in each position: it has no path of its own; choose another point",
            ),
            code="centre-of-curvature",
        )
