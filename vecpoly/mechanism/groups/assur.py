"""Which links move together: the mechanism taken apart into Assur groups, in the order of their solution. Frame and
driving links are known. An Assur group is a smallest set of links whose joints, among themselves and to known links,
fix all its 3k coordinates: two links and three joints (class II, a dyad), four links and six joints (class III or IV),
and so on. Once solved, its links are known and the next group follows. A hinge of several links is one letter; any two
links that carry it are pinned. A rolling joint fixes two coordinates (contact and no slip), or one where links hold the
gear's centre (`is_held`). Links that a drive joins are found together (`rams`).
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from functools import lru_cache
from itertools import combinations, islice, pairwise

from ...errors import MobilityError
from ...words import Words
from ..model import FRAME, Joint, Mechanism, Prismatic, Rack, Revolute, Rolling
from ..pitch_lines import pitch_lines
from ..rams import driven_kind, drives_within, units
from .contours import class_of, connected
from .group import Dyad, Group, Outer
from .jointed import Jointed

KEPT = 128  # mechanisms taken apart last: by lengths alone one differs from the next
MOST = 120_000  # sets of links that are tried for a group: all of 16 links; of 22 those of up to six

__all__ = [
    "Dyad",
    "Group",
    "Outer",
    "decompose",
    "dyad_of",
    "ends",
    "hinges",
    "holders",
    "is_held",
    "joint_letter",
    "pivot_of",
]


def decompose(mech: Mechanism, *, pressing: bool = False) -> tuple[Group, ...]:
    """The Assur groups for the mechanism's own drives, in order of solution.

    pressing: at a multiple joint only those links are joined that press on each other, as the mechanism's joints say.

    Raises MobilityError where links remain that no known link determines.
    """
    return _decomposed(Jointed(mech), pressing)


@lru_cache(maxsize=KEPT)
def _decomposed(jointed: Jointed, pressing: bool) -> tuple[Group, ...]:
    mech = jointed.mech
    known = [FRAME, *(drive.link for drive in mech.drives if not drive.between)]
    rest = list(units(mech))
    pins = {} if pressing else hinges(mech)
    held = frozenset(joint for joint in mech.joints if isinstance(joint, Rolling) and is_held(mech, joint))
    groups: list[Group] = []
    while rest:
        tried = _candidates(mech, tuple(rest), tuple(known), pins, pressing, held)
        group = next((one for one in islice(tried, MOST) if one is not None), None)
        if group is None:
            raise MobilityError(_unsolved(mech, [name for unit in rest for name in unit], known))
        groups.append(group)
        known += group.links
        rest = [unit for unit in rest if not set(unit) & set(group.links)]
    return tuple(groups)


def _unsolved(mech: Mechanism, rest: Iterable[str], known: Iterable[str]) -> Words:
    """Why what remains is no group; an open chain, whose last link a drive alone holds, is named as such."""
    left = ", ".join(name for name in rest if name[0].isdigit())  # a pin's own block has no number
    hung = next((one for one in mech.drives if one.between and len(one.pair & set(known)) == 1), None)
    told = Words(
        f"构件 {left.replace(', ', '、')} 与已知构件 {'、'.join(known)} 之间不成杆组：",
        f"links {left} form no Assur group on the known links {', '.join(known)}: ",
    )
    if hung is not None:
        return told + Words(
            f"构件 {hung.link} 只由相对构件 {hung.on} 的原动件带动，是开式链（如机械臂）；本程序只解闭链机构",
            f"link {hung.link} is held by its drive against link {hung.on} alone: an open chain, as of a robot's "
            "arm, and only closed chains are solved",
        )
    return told + Words("缺少或多出了运动副或原动件", "a joint or a drive is missing, or one too many")


def joint_letter(joint: Joint) -> str:
    """R, P or G."""
    match joint:
        case Revolute():
            return "R"
        case Prismatic():
            return "P"
        case Rolling():
            return "G"


def ends(joint: Joint) -> tuple[str, str]:
    """The two links which the joint connects: a and b, guide and block, gear and its partner."""
    match joint:
        case Revolute():
            return joint.a, joint.b
        case Prismatic():
            return joint.guide, joint.block
        case Rolling():
            return joint.gear.link, joint.on.link


def hinges(mech: Mechanism) -> dict[str, tuple[str, ...]]:
    """Letter of every hinge -> the links pinned there, in the order of the mechanism, the frame last."""
    at: dict[str, set[str]] = {}
    for joint in mech.joints:
        if isinstance(joint, Revolute):
            at.setdefault(joint.point, set()).update((joint.a, joint.b))
    order = [*(link.name for link in mech.links), FRAME]
    return {point: tuple(name for name in order if name in names) for point, names in at.items()}


def pivot_of(mech: Mechanism, link: str) -> str:
    """The letter of a moving link's pivot on the frame; "" where it has none."""
    return next((p for p, names in hinges(mech).items() if {FRAME, link} <= {*names} and link != FRAME), "")


def is_held(mech: Mechanism, rolling: Rolling) -> bool:
    """Whether links hold the gear's centre at its distance already; then only no slip is a constraint."""
    return bool(holders(mech, rolling))


def holders(mech: Mechanism, rolling: Rolling) -> tuple[str, ...]:
    """The links that hold the gear's centre at its distance from its partner.

    They are pinned at both centres; or pinned at the gear's centre, with slides along the pitch line of the rack.
    """
    pins = hinges(mech)
    mine, on = {*pins.get(rolling.gear.centre, ()), rolling.gear.link}, rolling.on
    both = (
        mine & pitch_lines(mech, on).keys() - {rolling.gear.link}
        if isinstance(on, Rack)
        else mine & {*pins.get(on.centre, ()), on.link}
    )
    return tuple(name for name in (*(link.name for link in mech.links), FRAME) if name in both)


Pins = Mapping[str, tuple[str, ...]]  # letter of a hinge -> the links pinned there


def _candidates(
    mech: Mechanism,
    rest: tuple[tuple[str, ...], ...],
    known: tuple[str, ...],
    pins: Pins,
    pressing: bool,
    held: frozenset[Rolling],
) -> Iterator[Group | None]:
    """Groups that the known links determine, the smallest first, in the order of the links; None for each set of links
    that is none.

    Links joined by a drive count as one.
    """
    for size in range(1, len(rest) + 1):
        for chosen in combinations(rest, size):
            yield _group(mech, tuple(name for unit in chosen for name in unit), known, pins, pressing, held)


def _group(
    mech: Mechanism,
    links: tuple[str, ...],
    known: tuple[str, ...],
    pins: Pins,
    pressing: bool,
    held: frozenset[Rolling],
) -> Group | None:
    """The group of just these links, or None where they are not one. held: rolling pairs whose gear is held at its
    distance."""
    inner, outer = _joints(mech, links, known, pins, pressing)
    drives = drives_within(mech, links)
    constraints = sum(1 if joint in held else 2 for joint in (*inner, *(out.joint for out in outer))) + len(drives)
    if constraints != 3 * len(links) or not connected(links, [ends(joint) for joint in inner]):
        return None
    if drives:
        kind, ram = driven_kind(mech, drives, inner, tuple((out.joint, out.link, out.parent) for out in outer))
        return Group(kind=kind, links=links, inner=inner, outer=outer, ram=ram)
    if len(links) == 1:
        return Group(kind=_alone(links[0], outer), links=links, inner=inner, outer=outer)
    if len(links) == 2 and len(inner) == 1 and {out.link for out in outer} == set(links) and len(outer) == 2:
        dyad = dyad_of(inner[0], *sorted(outer, key=lambda out: links.index(out.link)))
        return Group(kind=dyad.kind, links=(dyad.link_j, dyad.link_k), inner=inner, outer=outer, dyad=dyad)
    rolls = any(isinstance(joint, Rolling) for joint in (*inner, *(out.joint for out in outer)))
    kind = "gear train" if rolls else f"class {class_of(links, [ends(joint) for joint in inner])}"
    return Group(kind=kind, links=links, inner=inner, outer=outer)


def _alone(link: str, outer: tuple[Outer, ...]) -> str:
    """The kind of a group of one link: a gear or a rack that rolls on what is known, or class I."""
    rolls = [out.joint for out in outer if isinstance(out.joint, Rolling)]
    if not rolls:
        return "class I"
    return "rack" if isinstance(rolls[0].on, Rack) and rolls[0].on.link == link else "gear"


def _joints(
    mech: Mechanism, links: tuple[str, ...], known: tuple[str, ...], pins: Pins, pressing: bool
) -> tuple[tuple[Joint, ...], tuple[Outer, ...]]:
    """Joints within the links, and joints from them to known links; `pins`:
    the hinges, none where links are joined as they press."""
    inner: list[Joint] = []
    outer: list[Outer] = []
    for point, names in pins.items():
        mine = [name for name in links if name in names]
        if not mine:
            continue
        parent = next((name for name in known if name in names), None)
        if parent is not None:
            hung = (Revolute(point=point, a=parent, b=name) for name in mine)
            outer += [Outer(joint=pin, link=pin.b, parent=parent) for pin in hung]
        else:
            inner += [Revolute(point=point, a=a, b=b) for a, b in pairwise(mine)]
    for joint in mech.joints:
        if isinstance(joint, Revolute) and not pressing:
            continue
        a, b = ends(joint)
        if a in links and b in links:
            inner.append(joint)
        elif a in links and b in known:
            outer.append(Outer(joint=joint, link=a, parent=b))
        elif b in links and a in known:
            outer.append(Outer(joint=joint, link=b, parent=a))
    return tuple(inner), tuple(outer)


_RANK = {"R": 0, "P": 1, "G": 2}


def dyad_of(inner: Joint, one: Outer, two: Outer) -> Dyad:
    """The dyad in normal order: the simpler outer joint first (R before P before G)."""
    if _RANK[joint_letter(two.joint)] < _RANK[joint_letter(one.joint)]:
        one, two = two, one
    kind = joint_letter(one.joint) + joint_letter(inner) + joint_letter(two.joint)
    return Dyad(
        kind=kind,
        link_j=one.link,
        link_k=two.link,
        outer_j=one.joint,
        parent_j=one.parent,
        inner=inner,
        outer_k=two.joint,
        parent_k=two.parent,
    )
