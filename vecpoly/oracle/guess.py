"""A rough first assembly for Newton: every link of the group laid through the known and guessed places of its points."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from ..errors import AssemblyError
from ..mechanism.assur import Group
from ..mechanism.model import Mechanism, Prismatic
from ..words import Words
from .state import Bodies


def first_guess(mech: Mechanism, group: Group, known: Bodies) -> NDArray[np.float64]:
    """1 × links × (x, y, φ): the best fit of each link to the places of its points (m, rad).

    Raises AssemblyError where a link has no point with a place.
    """
    places = dict(mech.guesses)
    for name, body in known.items():
        places |= {p: complex(body.point(local)[0]) for p, local in mech.link(name).points.items()}
    poses = {name: complex(body.unit[0]) for name, body in known.items()}
    loose = list(group.links)
    while loose:
        name = next((n for n in loose if _unit(mech, n, places, poses) is not None), loose[0])
        poses[name] = _unit(mech, name, places, poses) or 1 + 0j
        loose.remove(name)
    return np.array([[_pose(mech, group, name, places, poses[name]) for name in group.links]])


def _unit(mech: Mechanism, name: str, places: dict[str, complex], poses: dict[str, complex]) -> complex | None:
    """e^{iφ} of the link: from two of its points, or from its guide or block; None where neither is known."""
    link = mech.link(name)
    seen = [p for p in link.points if p in places]
    if len(seen) > 1:
        local = np.array([link.points[p] for p in seen])
        place = np.array([places[p] for p in seen])
        total = complex(np.sum((local - local.mean()).conj() * (place - place.mean())))
        return total / abs(total) if abs(total) > 0 else 1 + 0j
    for joint in mech.joints:
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


def _pose(mech: Mechanism, group: Group, name: str, places: dict[str, complex], unit: complex) -> list[float]:
    link = mech.link(name)
    seen = [p for p in link.points if p in places]
    if not seen:
        raise AssemblyError(Words(
            f"{group.name.zh}须迭代求解，需要大致位置；请用 guesses 给出构件 {name} 上 {', '.join(link.points)} 的位置",
            f"the {group.name.en} is solved by iteration and needs rough positions: give `guesses` for {', '.join(link.points)} of link {name}"))
    origin = complex(np.mean([places[p] - unit * link.points[p] for p in seen]))
    return [origin.real, origin.imag, float(np.angle(unit))]
