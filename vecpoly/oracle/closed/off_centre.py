"""A hinge off the centre of a gear that rolls: no closed form over the cycle, yet at the own position, where the gear's
angle is a datum, two circles."""

from __future__ import annotations

import numpy as np

from ...foundation.slotted import dataclass
from ...mechanism.gearing import reach
from ...mechanism.groups.assur import Group, is_held
from ...mechanism.model import Circle, Joint, Mechanism, Prismatic, Rack, Revolute, Rolling, Side
from ..iterated.standing import Turned, carriers, start_of
from ..state import Bodies
from .loci import slide


@dataclass(frozen=True, slots=True)
class _Path:
    """The hinge on a circle about `at`, or (radius 0) on the line through `at` along `along`."""

    at: complex
    radius: float = 0.0
    along: complex = 1.0


Sides = tuple[str, str, str]  # the hinge, and the two links that meet in it


def crossing(mech: Mechanism, group: Group) -> Sides | None:
    """The hinge inside the group whose two places tell its two assemblies apart at the own position;
    None where there is none."""
    rolls = [joint for joint in (*group.inner, *(out.joint for out in group.outer)) if isinstance(joint, Rolling)]
    if not rolls:
        return None
    for joint in group.inner:
        if not isinstance(joint, Revolute) or any(
            is_held(mech, roll) and joint.point in _centres(roll) for roll in rolls
        ):
            continue
        if all(_outer(group, link) is not None or _told(mech, group, link) for link in (joint.a, joint.b)):
            return joint.point, joint.a, joint.b
    return None


def places(mech: Mechanism, group: Group, known: Bodies, sign: float) -> dict[str, complex]:
    """The places (m) of the hinge where two links of the group meet, and of what hangs on arms and gears whose angles
    are told; empty where it cannot be."""
    cross = crossing(mech, group)
    assert cross is not None
    c, *links = cross
    spots = {
        p: complex(body.point(local)[0]) for name, body in known.items() for p, local in mech.link(name).points.items()
    }
    for start in (one for one in mech.starts if one.link in group.links and not one.slide):
        spots |= _set_out(mech, start.link, spots, known)
    if c in spots:
        return {}
    paths = [_path(mech, group, link, c, known, spots) for link in links]
    if paths[0] is None or paths[1] is None:
        return {}
    found = spots | {c: _meet(paths[0], paths[1], sign)}
    for link in links:
        joint = _outer(group, link)
        if isinstance(joint, Rolling) and _turns_with_centres(mech, joint, link):
            other, mine = _other(joint, link), _wheel(joint, link)
            assert isinstance(other, Circle) and mine is not None
            way = (found[c] - spots[other.centre]) / _out(mech, joint, link, c)
            found[mine.centre] = spots[other.centre] + way / abs(way) * reach(joint)
    return {letter: place for letter, place in found.items() if np.isfinite(place)}


def _centres(joint: Rolling) -> set[str]:
    return {circle.centre for circle in (joint.gear, joint.on) if isinstance(circle, Circle)}


def _outer(group: Group, link: str) -> Joint | None:
    """The joint by which a link of the group hangs on a known one: a hinge or a slide before a rolling pair."""
    joints = [out.joint for out in group.outer if out.link == link]
    return next((joint for joint in joints if not isinstance(joint, Rolling)), joints[0] if joints else None)


def _told(mech: Mechanism, group: Group, link: str) -> bool:
    """Whether the link hangs by a hinge on an arm of the group whose angle is told."""
    arms = {
        one.link
        for one in mech.starts
        if one.link in group.links and not one.slide and isinstance(_outer(group, one.link), Revolute)
    }
    return any(
        isinstance(joint, Revolute) and link in (joint.a, joint.b) and {joint.a, joint.b} & arms
        for joint in group.inner
    )


def _set_out(mech: Mechanism, link: str, spots: dict[str, complex], known: Bodies) -> dict[str, complex]:
    """The points of a link whose angle is told and one of whose points is known."""
    points, stands = mech.link(link).points, start_of(mech, link)
    seen = next((p for p in points if p in spots), None)
    if seen is None or not set(carriers(stands)) <= set(known):
        return {}
    turn = complex(np.exp(1j * stands.zero(known))[0])
    return {p: spots[seen] + turn * (local - points[seen]) for p, local in points.items()}


def _wheel(joint: Rolling, link: str) -> Circle | None:
    mine = joint.gear if joint.gear.link == link else joint.on
    return mine if isinstance(mine, Circle) else None


def _other(joint: Rolling, link: str) -> Circle | Rack:
    return joint.on if joint.gear.link == link else joint.gear


def _turns_with_centres(mech: Mechanism, joint: Rolling, link: str) -> bool:
    mine, other = _wheel(joint, link), _other(joint, link)
    told = next((one for one in mech.starts if one.link == link), None)
    return (
        told is not None
        and mine is not None
        and isinstance(other, Circle)
        and set(told.ray) == {mine.centre, other.centre}
    )


def _out(mech: Mechanism, joint: Rolling, link: str, c: str) -> complex:
    """The hinge from the other centre, along the line of centres and across it (m)."""
    told, mine = next(one for one in mech.starts if one.link == link), _wheel(joint, link)
    assert mine is not None
    points, sign = mech.link(link).points, 1.0 if told.ray[1] == mine.centre else -1.0
    return complex(reach(joint) + sign * np.exp(1j * told.value) * (points[c] - points[mine.centre]))


def _path(mech: Mechanism, group: Group, link: str, c: str, known: Bodies, spots: dict[str, complex]) -> _Path | None:
    """What the link's known point, its slide or its rolling leaves the hinge."""
    body = mech.link(link)
    seen = next((p for p in body.points if p in spots), None)
    if seen is not None:
        return _Path(spots[seen], abs(body.points[c] - body.points[seen]))
    joint = _outer(group, link)
    parent = next((out.parent for out in group.outer if out.link == link and out.joint is joint), "")
    match joint:
        case Prismatic():
            line = slide(joint, link, body.points[c], mech.link(joint.block).points[joint.pin])
            return _Path(complex(line.base(known)[0]), 0.0, complex(line.direction(known)[0]))
        case Rolling():
            return _rolled(mech, joint, link, parent, c, known)
    return None


def _rolled(mech: Mechanism, joint: Rolling, link: str, parent: str, c: str, known: Bodies) -> _Path | None:
    mine, other, points, base = _wheel(joint, link), _other(joint, link), mech.link(link).points, known[parent]
    if mine is None:
        return None
    if isinstance(other, Circle) and _turns_with_centres(mech, joint, link):
        return _Path(complex(base.point(mech.link(parent).points[other.centre])[0]), abs(_out(mech, joint, link, c)))
    stands: Turned = start_of(mech, link)
    arm = (points[c] - points[mine.centre]) * complex(np.exp(1j * stands.zero(known))[0])
    if isinstance(other, Rack):
        along = complex(base.unit[0]) * complex(np.exp(1j * other.direction))
        side = 1.0 if joint.side is Side.LEFT else -1.0
        return _Path(complex(base.point(other.origin)[0]) + 1j * side * along * mine.radius + arm, 0.0, along)
    return _Path(complex(base.point(mech.link(parent).points[other.centre])[0]) + arm, reach(joint))


def _meet(one: _Path, two: _Path, sign: float) -> complex:
    """The meeting point; of two the one to the left of the ray between the centres, or ahead on the line, where sign is
    1. NaN where none."""
    if one.radius and two.radius:
        ray = two.at - one.at
        if abs(ray) < 1e-12 * (one.radius + two.radius):
            return complex(np.nan)
        share = 0.5 + (one.radius**2 - two.radius**2) / (2 * abs(ray) ** 2)
        square = (one.radius / abs(ray)) ** 2 - share**2
        return one.at + ray * (share + 1j * sign * square**0.5) if square >= 0 else complex(np.nan)
    if one.radius or two.radius:
        arc, line = (one, two) if one.radius else (two, one)
        ahead = line.along.conjugate() * (arc.at - line.at)
        square = arc.radius**2 - ahead.imag**2
        return line.at + line.along * (ahead.real + sign * square**0.5) if square >= 0 else complex(np.nan)
    det = (one.along.conjugate() * two.along).imag
    return one.at + one.along * ((two.at - one.at).conjugate() * two.along).imag / det if det else complex(np.nan)
