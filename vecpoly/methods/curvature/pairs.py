"""Which points of a moving link run about known centres: what every construction of its curvatures goes out from."""

from __future__ import annotations

from collections.abc import Iterator

from ...errors import NoMethodError
from ...foundation.slotted import dataclass
from ...mechanism.groups.assur import ends, hinges, pivot_of
from ...mechanism.model import FRAME, Circle, Mechanism, Prismatic, Rolling
from ...words import Words


@dataclass(frozen=True, slots=True, kw_only=True)
class Pair:
    """A point of the link (`moving`) and the centre of its path (`fixed`), by their letters.

    One of them is at infinity, across the slide `joint`: the centre, where the point runs on a line; the point, where a
    line of the link always passes at one distance from the centre.
    """

    moving: str = ""
    fixed: str = ""
    joint: Prismatic | None = None


def pairs_of(mech: Mechanism, link: str) -> tuple[Pair, Pair]:
    """Two pairs of the link, those without a point at infinity first.

    Raises NoMethodError where the link only turns or slides on the frame, or fewer than two are known.
    """
    _refuse_plain(mech, link)
    found = sorted({*_pinned(mech, link), *_sliding(mech, link)}, key=lambda one: (one.joint is not None, _name(one)))
    if len(found) < 2:
        number = mech.number(link)
        raise NoMethodError(
            Words(
                f"构件 {number} 上须有两点（或两条线），其轨迹的曲率中心在机架上为已知：铰接于连架杆、机架上的滑块，"
                f"或穿过机架上的摇块；此处只有 {len(found)} 个",
                f"of link {number} two points, or lines, must run about known centres of the frame: pinned to links "
                "that turn or slide on the frame, or led through blocks that swing on it; here there is "
                f"{len(found) or 'none'}",
            )
        )
    return found[0], found[1]


def rolling_of(mech: Mechanism, link: str) -> Rolling | None:
    """How the link rolls on the frame as a gear; None where it does not. A rack that rolls on a fixed gear does not."""
    rolling = (joint for joint in mech.joints if isinstance(joint, Rolling))
    return next((joint for joint in rolling if joint.gear.link == link and joint.on.link == FRAME), None)


def rolled(joint: Rolling) -> Pair:
    """The gear's centre, and the centre of its path: that of the fixed circle; on a rack it runs straight."""
    return Pair(moving=joint.gear.centre, fixed=joint.on.centre if isinstance(joint.on, Circle) else "")


def _name(pair: Pair) -> str:
    return pair.moving + pair.fixed


def _refuse_plain(mech: Mechanism, link: str) -> None:
    """A link that is joined to the frame itself has no curvature worth a drawing."""
    if any({link, FRAME} == set(ends(joint)) for joint in mech.joints if not isinstance(joint, Rolling)):
        number = mech.number(link)
        raise NoMethodError(
            Words(
                f"构件 {number} 直接与机架相连，其上各点的轨迹为圆弧或直线，不需作图；请求连杆的曲率",
                f"link {number} is joined to the frame itself: its points run on circles or lines, and nothing need be "
                "drawn; ask the curvatures of a coupler",
            )
        )


def _pinned(mech: Mechanism, link: str) -> Iterator[Pair]:
    """Pins at which the link hangs on links that turn, or slide, on the frame."""
    for point, names in hinges(mech).items():
        for other in names if link in names else ():
            if (pivot := pivot_of(mech, other)) and pivot != point:
                yield Pair(moving=point, fixed=pivot)
            elif (slide := _slide_of(mech, other)) is not None:
                yield Pair(moving=point, joint=slide)


def _sliding(mech: Mechanism, link: str) -> Iterator[Pair]:
    """Slides of the link against links that turn on the frame."""
    for joint in mech.joints:
        if isinstance(joint, Prismatic) and link in (joint.guide, joint.block):
            other = joint.block if joint.guide == link else joint.guide
            if pivot := pivot_of(mech, other):
                yield Pair(fixed=pivot, joint=joint)


def _slide_of(mech: Mechanism, link: str) -> Prismatic | None:
    """The slide of a block on the frame."""
    slides = (joint for joint in mech.joints if isinstance(joint, Prismatic))
    return next((joint for joint in slides if {joint.guide, joint.block} == {link, FRAME} and link != FRAME), None)
