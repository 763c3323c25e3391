"""A rough first assembly for Newton:
every link of the group laid through the known and guessed places of its points."""

from __future__ import annotations

from collections.abc import Mapping
from types import MappingProxyType

import numpy as np
from numpy.typing import NDArray

from ...errors import AssemblyError
from ...mechanism.assembly.start import Start
from ...mechanism.groups.assur import Group
from ...mechanism.model import Mechanism, Prismatic, Rack, Rolling, Side
from ...words import Words
from ..state import Bodies

NOWHERE: Mapping[str, complex] = MappingProxyType({})


def first_guess(
    mech: Mechanism, group: Group, known: Bodies, about: Mapping[str, complex] = NOWHERE
) -> NDArray[np.float64]:
    """1 × links × (x, y, φ): the best fit of each link to the places of its points (m, rad).
    about: places found beforehand.

    Raises AssemblyError where a link has no point with a place.
    """
    places = dict(about or mech.guesses)
    for name, body in known.items():
        places |= {p: complex(body.point(local)[0]) for p, local in mech.link(name).points.items()}
    told = _told(mech, group, bool(about))
    poses = _laid(mech, group, known, told, places)
    _slid(mech, group, known, places)
    return np.array([[_pose(mech, group, name, places, poses[name]) for name in group.links]])


def _told(mech: Mechanism, group: Group, centred: bool) -> dict[str, Start]:
    """What is told of the directions of the links; a gear whose centre is given (centred) starts unturned."""
    wheels = {
        circle.link
        for joint in (*group.inner, *(out.joint for out in group.outer))
        if isinstance(joint, Rolling)
        for circle in (joint.gear, joint.on)
    }
    told = {
        link: Start(link=link, value=0.0)
        for link in group.links
        if link in wheels and len(mech.link(link).points) > 1 and centred
    }
    return told | {one.link: one for one in mech.starts if one.link in group.links}


def _laid(
    mech: Mechanism, group: Group, known: Bodies, told: dict[str, Start], places: dict[str, complex]
) -> dict[str, complex]:
    """e^{iφ} of every link, the surest first; each link so laid gives its points their places."""
    poses = {name: complex(body.unit[0]) for name, body in known.items()}
    loose = list(group.links)
    while loose:
        for one in (told[n] for n in loose if n in told and told[n].slide):
            _slide(mech, one, known, places)
        name = next((n for n in loose if _sure(mech, n, told, places, poses)), loose[0])
        poses[name] = _unit(mech, name, told, places, poses) or 1 + 0j
        loose.remove(name)
        link = mech.link(name)
        if name in told or len([p for p in link.points if p in places]) > 1:
            seen = next((p for p in link.points if p in places), None)
            if seen is not None:
                at, own = places[seen], link.points[seen]
                places |= {p: at + poses[name] * (local - own) for p, local in link.points.items() if p not in places}
    return poses


def _slid(mech: Mechanism, group: Group, known: Bodies, places: dict[str, complex]) -> None:
    """Places on the links that have none yet: of the pin of a slide, else as guessed."""
    for name in group.links:
        points = mech.link(name).points
        slid = [j for j in mech.joints if isinstance(j, Prismatic) and j.block == name]
        placed = any(p in places for p in points)
        spot = _anywhere(mech, name, known, places) if slid and not placed else None
        if spot is not None:
            places[slid[0].pin] = spot
        if not any(p in places for p in points):
            places |= {p: at for p, at in mech.guesses.items() if p in points}


def _sure(
    mech: Mechanism, name: str, told: dict[str, Start], places: dict[str, complex], poses: dict[str, complex]
) -> bool:
    """Whether the link's direction and the place of one of its points are known."""
    return _unit(mech, name, told, places, poses) is not None and any(p in places for p in mech.link(name).points)


def _anywhere(mech: Mechanism, name: str, known: Bodies, places: dict[str, complex]) -> complex | None:
    """A place for the pin of a link that only slides on a known guide, where nothing else tells it:
    beside the points that are known."""
    joint = next((j for j in mech.joints if isinstance(j, Prismatic) and j.block == name and j.guide in known), None)
    if joint is None or not places:
        return None
    body, along = known[joint.guide], complex(np.exp(1j * joint.direction))
    base, way = complex(body.point(joint.origin)[0]), complex(body.unit[0]) * along
    middle = complex(np.mean(list(places.values())))
    return base + way * ((way.conjugate() * (middle - base)).real + 1j * joint.offset)


def _slide(mech: Mechanism, start: Start, known: Bodies, places: dict[str, complex]) -> None:
    """The pin of a slide whose travel is told."""
    joint = next(j for j in mech.joints if isinstance(j, Prismatic) and start.link in (j.guide, j.block))
    if joint.guide in known:
        foot = joint.origin + complex(np.exp(1j * joint.direction)) * (start.value + 1j * joint.offset)
        places[joint.pin] = complex(known[joint.guide].point(foot)[0])


def _unit(
    mech: Mechanism, name: str, told: dict[str, Start], places: dict[str, complex], poses: dict[str, complex]
) -> complex | None:
    """e^{iφ} of the link: as told, from two of its points, or from its guide or block;
    None where nothing of it is known."""
    link, start = mech.link(name), told.get(name)
    if start is not None and not start.slide and set(start.ray) <= set(places):
        ray = places[start.ray[1]] - places[start.ray[0]] if start.ray else 1 + 0j
        return ray / abs(ray) * complex(np.exp(1j * start.value))
    seen = [p for p in link.points if p in places]
    if len(seen) > 1:
        local = np.array([link.points[p] for p in seen])
        place = np.array([places[p] for p in seen])
        total = complex(np.sum((local - local.mean()).conj() * (place - place.mean())))
        return total / abs(total) if abs(total) > 0 else 1 + 0j
    for joint in mech.joints:
        if (
            isinstance(joint, Rolling)
            and isinstance(joint.on, Rack)
            and joint.on.link == name
            and seen
            and joint.gear.centre in places
        ):
            return _tangent(joint, joint.on, link.points[seen[0]], places[joint.gear.centre] - places[seen[0]])
        if not isinstance(joint, Prismatic) or name not in (joint.guide, joint.block):
            continue
        turn = complex(np.exp(1j * (joint.direction + joint.turn)))
        if joint.block == name and joint.guide in poses:
            return poses[joint.guide] * turn
        if joint.guide == name and joint.block in poses:
            return poses[joint.block] / turn
        if joint.guide == name and seen and joint.pin in places and joint.pin != seen[0]:
            ray = places[joint.pin] - places[seen[0]]
            return ray / abs(ray) * complex(np.exp(-1j * joint.direction))
    return None


def _tangent(joint: Rolling, rack: Rack, pin: complex, ray: complex) -> complex | None:
    """e^{iφ} of a rack hinged at `pin` that touches a gear whose centre lies at `ray` from there,
    ahead along the rack."""
    beside = (np.exp(-1j * rack.direction) * (pin - rack.origin)).imag
    left = (1 if joint.side is Side.LEFT else -1) * joint.gear.radius - beside
    if abs(ray) <= abs(left):
        return None
    return complex(ray / abs(ray) * np.exp(-1j * (np.arcsin(left / abs(ray)) + rack.direction)))


def _pose(mech: Mechanism, group: Group, name: str, places: dict[str, complex], unit: complex) -> list[float]:
    """The link laid through its known points;
    without rolling, a link that has none starts in the middle of all that are known."""
    link = mech.link(name)
    seen = [p for p in link.points if p in places]
    if not seen and any(isinstance(joint, Rolling) for joint in (*group.inner, *(out.joint for out in group.outer))):
        raise AssemblyError(
            Words(
                f"{group.name.zh}须迭代求解，需要大致位置；请用 guesses 给出构件 {name} 上 "
                f"{', '.join(link.points)} 的位置",
                f"the {group.name.en} is solved by iteration and needs rough positions: give `guesses` for "
                f"{', '.join(link.points)} of link {name}",
            )
        )
    origin = complex(np.mean([places[p] - unit * link.points[p] for p in seen] or list(places.values()) or [0j]))
    return [origin.real, origin.imag, float(np.angle(unit))]
