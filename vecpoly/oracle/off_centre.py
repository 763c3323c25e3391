"""A hinge off the centre of a gear that rolls: no closed form over the cycle, yet at the own position, where the gear's angle is a datum, two circles."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ..mechanism.assur import Group
from ..mechanism.gearing import reach
from ..mechanism.model import Circle, Joint, Mechanism, Prismatic, Rack, Revolute, Rolling, Side
from .loci import slide
from .standing import Turned, start_of
from .state import Bodies


@dataclass(frozen=True, slots=True)
class _Path:
    """The hinge on a circle about `at`, or (radius 0) on the line through `at` along `along`."""

    at: complex
    radius: float = 0.0
    along: complex = 1.0


def is_off_centre(mech: Mechanism, group: Group) -> bool:
    """Whether the group is a dyad with a hinge inside, off the centre of a gear of it that rolls on a known link."""
    d = group.dyad
    if d is None or not isinstance(d.inner, Revolute):
        return False
    outer = ((d.outer_j, d.link_j), (d.outer_k, d.link_k))
    return any(isinstance(joint, Rolling) and (mine := _wheel(joint, link)) is not None and mine.centre != d.inner.point for joint, link in outer)


def hinge_of(group: Group) -> str:
    """The letter of the dyad's inner hinge."""
    assert group.dyad is not None and isinstance(group.dyad.inner, Revolute)
    return group.dyad.inner.point


def places(mech: Mechanism, group: Group, known: Bodies, sign: float) -> dict[str, complex]:
    """The places (m) of the hinge, and of the centre of a gear whose angle counts from the line of centres, in the assembly of this sign."""
    d = group.dyad
    assert d is not None and isinstance(d.inner, Revolute)
    c = d.inner.point
    sides = ((d.outer_j, d.link_j, d.parent_j), (d.outer_k, d.link_k, d.parent_k))
    one, two = (_path(mech, joint, link, parent, c, known) for joint, link, parent in sides)
    found = {} if one is None or two is None else {c: _meet(one, two, sign)}
    for joint, link, parent in sides:
        if isinstance(joint, Rolling) and found and _turns_with_centres(mech, joint, link):
            other = _other(joint, link)
            assert isinstance(other, Circle)
            o = complex(known[parent].point(mech.link(parent).points[other.centre])[0])
            mine = _wheel(joint, link)
            assert mine is not None
            way = (found[c] - o) / _out(mech, joint, link, c)
            found[mine.centre] = o + way / abs(way) * reach(joint)
    return {letter: place for letter, place in found.items() if np.isfinite(place)}


def _wheel(joint: Rolling, link: str) -> Circle | None:
    mine = joint.gear if joint.gear.link == link else joint.on
    return mine if isinstance(mine, Circle) else None


def _other(joint: Rolling, link: str) -> Circle | Rack:
    return joint.on if joint.gear.link == link else joint.gear


def _turns_with_centres(mech: Mechanism, joint: Rolling, link: str) -> bool:
    mine, other = _wheel(joint, link), _other(joint, link)
    told = next((one for one in mech.starts if one.link == link), None)
    return told is not None and mine is not None and isinstance(other, Circle) and set(told.ray) == {mine.centre, other.centre}


def _out(mech: Mechanism, joint: Rolling, link: str, c: str) -> complex:
    """The hinge from the other centre, along the line of centres and across it (m)."""
    told, mine = next(one for one in mech.starts if one.link == link), _wheel(joint, link)
    assert mine is not None
    points, sign = mech.link(link).points, 1.0 if told.ray[1] == mine.centre else -1.0
    return complex(reach(joint) + sign * np.exp(1j * told.value) * (points[c] - points[mine.centre]))


def _path(mech: Mechanism, joint: Joint, link: str, parent: str, c: str, known: Bodies) -> _Path | None:
    body, base = mech.link(link), known[parent]
    match joint:
        case Revolute():
            at = complex(base.point(mech.link(parent).points[joint.point])[0])
            return _Path(at, abs(body.points[c] - body.points[joint.point]))
        case Prismatic():
            line = slide(joint, link, body.points[c], mech.link(joint.block).points[joint.pin])
            return _Path(complex(line.base(known)[0]), 0.0, complex(line.direction(known)[0]))
        case Rolling():
            return _rolled(mech, joint, link, parent, c, known)


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
    """The meeting point; of two the one to the left of the ray between the centres, or ahead on the line, where sign is 1. NaN where none."""
    if one.radius and two.radius:
        ray = two.at - one.at
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
