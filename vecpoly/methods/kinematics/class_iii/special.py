"""The special point (Assur point) of a central link: where the axes of two of its legs meet.

Across both axes its vector has one unknown each, so that one equation gives it;
the third leg then gives a second point of the link.
"""

from __future__ import annotations

from collections.abc import Iterator
from itertools import combinations

import numpy as np

from ....board.construction import View
from ....board.paper.marks import Dot, Role
from ....errors import DeadPointError
from ....foundation.slotted import dataclass
from ....names import At
from ....plane import Line, cross, lines_meet, nominal, unit
from ....words import Words
from ...desk import Desk
from .star import Axial, Guided, Hinged, Slotted, Star, axis_of, called

LETTERS = "SWZUTXYVQRNJL"
FLAT = 1e-9  # below this the three axes meet in one point, or are parallel
FAR = 1.2  # of the mechanism's size on paper: a special point further away is not drawn itself


@dataclass(frozen=True, slots=True, kw_only=True)
class Special:
    """The two legs whose axes meet, the third leg, and the special point's letter, thought on the central link."""

    pair: tuple[Axial, Axial]
    third: Axial
    at: At


def special_of(desk: Desk, star: Star) -> Special:
    """The pair whose axes meet best; parallel ones meet nowhere, and another pair is taken. Raises DeadPointError."""
    ways = sorted(_ways(desk, star), key=lambda way: -way[0])
    if not ways[0][0] > FLAT:
        raise DeadPointError(
            Words(
                f"构件 {star.links}：三个支链的轴线交于一点或互相平行，Ⅲ级杆组处于死点位置，速度没有唯一解；"
                "请改换原动件的位置。",
                f"links {star.links}: the axes of the three legs meet at one point or are parallel; the "
                "class III group is at a dead point and its velocities have no single value; choose "
                "another input position",
            ),
            code="dead-point",
        )
    _, pair, third = ways[0]
    return Special(pair=pair, third=third, at=At(_letter(desk, star.plate), star.plate))


def find_special(desk: Desk, star: Star, special: Special) -> None:
    """Extend the two axes on the diagram to their meeting point, once."""
    if special.at.point in desk.at:
        return
    one, two = (axis_of(desk, leg) for leg in special.pair)
    legs = called(*special.pair)
    desk.board.step(_words(star, special), View.MECHANISM)
    lines = [desk.board.parallel(line.at, line.along) for line in (one, two)]
    found = desk.board.meet(lines[0], lines[1], Words(f"{legs.zh} 的轴线", f"axes of {legs.en}"))
    desk.letter(special.at.point, found)
    here = complex(nominal(desk.at[special.at.point]))
    if _reach(desk, star, here) > FAR:
        desk.board.remark(
            Words(
                f"（${special.at.point}$ 落在图纸外，其方向和距离由作图延长线确定。）",
                f" (${special.at.point}$ falls off the sheet; the axes are produced beyond its edge.)",
            )
        )
        return
    for leg in special.pair:
        desk.board.join(View.MECHANISM, desk.at[_inner(leg)], here, Role.HIDDEN)
    desk.board.join(View.MECHANISM, desk.at[_inner(special.third)], here, Role.HIDDEN)
    desk.board.plot(View.MECHANISM, here, special.at.point, Dot.POINT)


def _inner(leg: Axial) -> str:
    return leg.outer if isinstance(leg, Slotted) else leg.inner


def _ways(desk: Desk, star: Star) -> Iterator[tuple[float, tuple[Axial, Axial], Axial]]:
    """Every pair with its worth: the sines of both meetings, less the farther the special point lies."""
    lines = {leg.link: _plain(axis_of(desk, leg)) for leg in star.axial}
    for one, two in combinations(star.axial, 2):
        third = next(leg for leg in star.axial if leg not in (one, two))
        with np.errstate(divide="ignore", invalid="ignore"):
            here = complex(lines_meet(lines[one.link], lines[two.link]))
            ray = complex(nominal(desk.at[_inner(third)])) - here
            worth = abs(
                float(cross(lines[one.link].along, lines[two.link].along) * cross(unit(ray), lines[third.link].along))
            )
            worth /= 1 + _reach(desk, star, here) ** 2
        yield (worth if np.isfinite(worth) else 0.0), (one, two), third


def _plain(line: Line) -> Line:
    return Line(complex(nominal(line.at)), complex(nominal(line.along)))


def _reach(desk: Desk, star: Star, here: complex) -> float:
    """How far the point lies from the middle of the central link's joints, in sizes of the mechanism."""
    joints = [complex(nominal(desk.at[_inner(leg)])) for leg in star.axial]
    return abs(here - sum(joints) / len(joints)) / desk.mm(desk.mech.scale)


def _letter(desk: Desk, plate: str) -> str:
    """A letter with which no point of the mechanism begins; the same one for velocity and acceleration."""
    taken = (
        {name[0] for link in desk.mech.links for name in link.points}
        | {name[0] for name in desk.mech.frame}
        | {getattr(j, "point", " ")[0] for j in desk.mech.joints}
    )
    free = (
        letter
        for letter in LETTERS
        if letter not in taken and (letter not in desk.at or desk.is_tip(View.VELOCITY, At(letter, plate)))
    )
    return next(free)


def _words(star: Star, special: Special) -> Words:
    one, two = (_axis_words(star, leg) for leg in special.pair)
    s, plate = special.at.point, star.plate
    return (
        Words("取特殊点：", "Take a special point: ")
        + one
        + Words("与", " and ")
        + two
        + Words(
            f"的交点为 ${s}$，将构件 {plate} 扩大至包含 ${s}$ 点（特殊点法）。",
            f" meet at ${s}$; extend the central link {plate} to contain ${s}$ (method of special points).",
        )
    )


def _axis_words(star: Star, leg: Axial) -> Words:
    match leg:
        case Hinged(outer=o, inner=b):
            return Words(f"构件 {leg.link} 的轴线 ${o}{b}$ ", f"the line ${o}{b}$ of link {leg.link}")
        case Guided(inner=b):
            return Words(
                f"过 ${b}$ 所作构件 {leg.link} 导路的垂线", f"the normal at ${b}$ to the guide of link {leg.link}"
            )
        case Slotted(outer=q, slide=slide) if slide.pin_in_slot:
            return Words(
                f"过 ${q}$ 所作构件 {star.plate} 的导槽的垂线", f"the normal at ${q}$ to the slot of link {star.plate}"
            )
        case Slotted(outer=q):
            return Words(
                f"过 ${q}$ 所作构件 {star.plate}、{leg.link} 间导路的垂线",
                f"the normal at ${q}$ to the slide between links {star.plate} and {leg.link}",
            )
