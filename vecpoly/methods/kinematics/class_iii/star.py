"""A class III group as the textbook sees it: a central link, and three legs by which it hangs on known links.

Each leg lets one point of the central link move in one direction only and holds it in the other, along the leg's axis:

    hinged   R-R  a bar O B:                             B moves ⊥ OB, the axis is OB
    guided   P-R  a slider on a known link, pinned at B: B moves ∥ guide, the axis is the guide's normal at B
    slotted  R-P  a pin at Q and a slide on the plate:   Q of the plate moves ∥ slide, the axis is its normal at Q
    parallel P-P  two slides: the central link turns as the leg's parent does, and has no axis
"""

from __future__ import annotations

from typing import assert_never

from ....errors import NoMethodError
from ....foundation.slotted import dataclass
from ....mechanism.groups.assur import Group, Outer, ends
from ....mechanism.groups.stars import plate_of
from ....mechanism.model import FRAME, Joint, Prismatic, Revolute
from ....names import At
from ....plane import Line
from ....words import Words
from ...desk import Desk


@dataclass(frozen=True, slots=True, kw_only=True)
class Hinged:
    """A bar with a pin on a known link and a pin on the central one."""

    link: str
    parent: str
    outer: str
    inner: str


@dataclass(frozen=True, slots=True, kw_only=True)
class Guided:
    """A slider on a known link, pinned to the central one."""

    link: str
    parent: str
    slide: Prismatic
    inner: str


@dataclass(frozen=True, slots=True, kw_only=True)
class Slotted:
    """A link pinned to a known one, in a sliding pair with the central one."""

    link: str
    parent: str
    outer: str
    slide: Prismatic


@dataclass(frozen=True, slots=True, kw_only=True)
class Parallel:
    """A link that slides on a known one and on the central one."""

    link: str
    parent: str
    guide: Prismatic
    slide: Prismatic


Axial = Hinged | Guided | Slotted  # the legs that have an axis
Leg = Axial | Parallel


def called(*legs: Leg) -> Words:
    """The links of some legs; a pin that runs in a slot of the central link stands for a link that is none."""
    pins = [f"${leg.outer}$" for leg in legs if isinstance(leg, Slotted) and leg.slide.pin_in_slot]
    links = [leg.link for leg in legs if not (isinstance(leg, Slotted) and leg.slide.pin_in_slot)]
    zh = [*([f"构件 {'、'.join(links)}"] if links else []), *(f"销 {pin}" for pin in pins)]
    of = [f"link{'s' * (len(links) > 1)} {' and '.join(links)}"] if links else []
    return Words("、".join(zh), " and ".join([*of, *(f"the pin {pin}" for pin in pins)]))


@dataclass(frozen=True, slots=True, kw_only=True)
class Star:
    """The central link ("plate") and its three legs."""

    plate: str
    legs: tuple[Leg, Leg, Leg]

    @property
    def axial(self) -> tuple[Axial, ...]:
        """The legs that have an axis."""
        return tuple(leg for leg in self.legs if not isinstance(leg, Parallel))

    @property
    def parallel(self) -> Parallel | None:
        """The leg that makes the central link turn with a known one, if there is such a leg."""
        return next((leg for leg in self.legs if isinstance(leg, Parallel)), None)

    @property
    def links(self) -> str:
        """The links' numbers, for messages."""
        return ", ".join((self.plate, *(leg.link for leg in self.legs)))


def star_of(group: Group) -> Star:
    """The central link and its legs; raises NoMethodError where the group is of another shape."""
    found = _star(group)
    if found is None:
        raise NoMethodError(
            Words(
                f"{group.name.zh}不是一个中心构件带三个支链",
                f"the {group.name.en} is not one central link on three legs",
            ),
            code="no-method",
        )
    return found


def is_star(group: Group) -> bool:
    """Whether a class III group is one central link on three legs of two joints each."""
    return plate_of(group) is not None


def _star(group: Group) -> Star | None:
    plate = plate_of(group)
    if plate is None:
        return None
    inner = {name: [joint for joint in group.inner if name in ends(joint)] for name in group.links}
    one, two, three = (leg for outer in group.outer if (leg := _leg(outer, inner[outer.link])) is not None)
    return Star(plate=plate, legs=(one, two, three))


def _leg(outer: Outer, inner: list[Joint]) -> Leg | None:
    """The leg that hangs by this joint on a known link; None where it has more joints than two."""
    link, parent = outer.link, outer.parent
    if len(inner) != 1:
        return None
    match outer.joint, inner[0]:
        case Revolute(point=o), Revolute(point=b):
            return Hinged(link=link, parent=parent, outer=o, inner=b)
        case Prismatic() as slide, Revolute(point=b):
            return Guided(link=link, parent=parent, slide=slide, inner=b)
        case Revolute(point=o), Prismatic() as slide:
            return Slotted(link=link, parent=parent, outer=o, slide=slide)
        case Prismatic() as guide, Prismatic() as slide:
            return Parallel(link=link, parent=parent, guide=guide, slide=slide)
    return None


def letters_on_legs(group: Group) -> dict[str, str]:
    """Letters at which points of several links of a class III group coincide,
    and the leg whose point is meant first."""
    if not group.kind.startswith("class III"):
        return {}
    inner = {name: [joint for joint in group.inner if name in ends(joint)] for name in group.links}
    letters = {}
    for leg in (_leg(outer, inner[outer.link]) for outer in group.outer):
        match leg:
            case Slotted(outer=point, link=link):
                letters[point] = link
            case Guided(inner=point, link=link, parent=parent) if parent != FRAME:
                letters[point] = link
    return letters


def point_of(star: Star, leg: Axial) -> At:
    """The point of the central link whose direction of motion the leg tells."""
    match leg:
        case Hinged(inner=b) | Guided(inner=b):
            return At(b)
        case Slotted(outer=q):
            return At(q, star.plate)
        case _:
            assert_never(leg)


def axis_of(desk: Desk, leg: Axial) -> Line:
    """The leg's axis as drawn, through that point: across it the point moves."""
    match leg:
        case Hinged(outer=o, inner=b):
            return Line(desk.at[b], desk.towards(o, b))
        case Guided(slide=slide, inner=b):
            return Line(desk.at[b], 1j * desk.guide_line(slide).along)
        case Slotted(slide=slide, outer=q):
            return Line(desk.at[q], 1j * desk.guide_line(slide).along)
        case _:
            assert_never(leg)
