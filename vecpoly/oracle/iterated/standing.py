"""Where a link stands at the problem's own position: the data by which the angles of gears count, as equations."""

from __future__ import annotations

import numpy as np

from ...errors import MobilityError
from ...foundation.slotted import dataclass
from ...mechanism.assembly.start import Start
from ...mechanism.groups.assur import Group, ends
from ...mechanism.model import Circle, Mechanism, Prismatic, Rolling
from ...words import Words
from ..state import Bodies, Body, Points, Reals

Carriers = tuple[tuple[str, complex], ...]  # links that carry a letter, and its place on each


@dataclass(frozen=True, slots=True)
class Turned:
    """φ = value + arg(Q - P) at the own position; without a ray φ = value. Its gap is an angle (rad)."""

    link: str
    value: float
    ray: tuple[Carriers, ...] = ()

    def _ends(self, bodies: Bodies) -> tuple[tuple[Body, complex], ...]:
        found = []
        for carriers in self.ray:
            seen = next(((bodies[name], local) for name, local in carriers if name in bodies), None)
            if seen is None:
                raise MobilityError(
                    Words(
                        f"构件 {self.link} 的相位所依据的直线此时尚未确定；请改用机架上的线、连心线或 x 轴",
                        f"the line from which the angle of link {self.link} counts is not "
                        "known before that link; count it from the x axis, a line of the "
                        "frame or the line of centres",
                    )
                )
            found.append(seen)
        return tuple(found)

    def zero(self, bodies: Bodies) -> Reals:
        """φ (rad), up to full turns."""
        if not self.ray:
            return np.full(1, self.value)
        (p, at_p), (q, at_q) = self._ends(bodies)
        return np.asarray(self.value + np.angle(q.point(at_q) - p.point(at_p)))

    def gap(self, bodies: Bodies) -> Reals:
        """How far the link is turned from there (rad)."""
        return np.asarray(np.angle(bodies[self.link].unit * np.exp(-1j * self.zero(bodies))))

    def jac(self, bodies: Bodies, links: tuple[str, ...]) -> Reals:
        """∂gap / ∂(x, y, φ) of each link: positions × links × 3."""
        count = len(bodies[self.link].unit)
        rows = np.zeros((count, len(links), 3))
        rows[:, links.index(self.link), 2] += 1.0
        if self.ray:
            (p, at_p), (q, at_q) = self._ends(bodies)
            ray = q.point(at_q) - p.point(at_p)
            for sign, carriers, local in ((1.0, self.ray[1], at_q), (-1.0, self.ray[0], at_p)):
                name = next(one for one, _ in carriers if one in bodies)
                if name in links:
                    rows[:, links.index(name), :] -= sign * _part(bodies[name], local, ray)
        return rows


def _part(body: Body, local: complex, ray: Points) -> Reals:
    """∂ arg(ray) by (x, y, φ) of the link that carries its end."""
    return np.stack([(1 / ray).imag, (1j / ray).imag, (1j * body.unit * local / ray).imag], axis=-1)


@dataclass(frozen=True, slots=True)
class Slid:
    """The pin of a slide stands at the travel `value` (m) from the guide's origin. Its gap is that length over
    `size`."""

    link: str
    value: float
    guide: str
    block: str
    origin: complex
    along: complex
    pin: complex
    size: float

    def gap(self, bodies: Bodies) -> Reals:
        """How far it is slid from there, over the mechanism's size."""
        guide, block = bodies[self.guide], bodies[self.block]
        travel = ((guide.unit * self.along).conj() * (block.point(self.pin) - guide.point(self.origin))).real
        return np.asarray((travel - self.value) / self.size)

    def jac(self, bodies: Bodies, links: tuple[str, ...]) -> Reals:
        """∂gap / ∂(x, y, φ) of each link."""
        guide, block = bodies[self.guide], bodies[self.block]
        back, ray = (guide.unit * self.along).conj(), block.point(self.pin) - guide.point(self.origin)
        rows = np.zeros((len(np.broadcast_arrays(back, ray)[0]), len(links), 3))
        arms = (
            (block, self.block, 1.0, 1j * block.unit * self.pin),
            (guide, self.guide, -1.0, 1j * guide.unit * self.origin + 1j * ray),
        )
        for _, name, sign, arm in arms:
            if name in links:
                rows[:, links.index(name), :] += (
                    sign
                    * np.stack(np.broadcast_arrays(back.real, (1j * back).real, (back * arm).real), axis=-1)
                    / self.size
                )
        return rows


Standing = Turned | Slid


def standing(mech: Mechanism, start: Start) -> Standing:
    """The start as an equation at the own position."""
    if start.slide:
        joint = next(j for j in mech.joints if isinstance(j, Prismatic) and start.link in ends(j))
        return Slid(
            start.link,
            start.value,
            joint.guide,
            joint.block,
            joint.origin,
            complex(np.exp(1j * joint.direction)),
            mech.link(joint.block).points[joint.pin],
            mech.scale,
        )
    rays = tuple(
        tuple((name, mech.link(name).points[letter]) for name in mech.links_at(letter)) for letter in start.ray
    )
    return Turned(start.link, start.value, rays)


def carriers(stand: Standing) -> tuple[str, ...]:
    """The links on which the line lies from which the angle counts."""
    return tuple(name for letter in stand.ray for name, _ in letter) if isinstance(stand, Turned) else ()


def start_of(mech: Mechanism, link: str) -> Turned:
    """Where a gear stands at the own position: as told, else with its x axis along the frame's."""
    told = next((one for one in mech.starts if one.link == link and not one.slide), None)
    found = standing(mech, told or Start(link=link, value=0.0))
    assert isinstance(found, Turned)
    return found


def standings(mech: Mechanism, group: Group) -> tuple[Standing, ...]:
    """As many as the group has rolling pairs: those told, then gears that are not."""
    rolls = [j for j in (*group.inner, *(out.joint for out in group.outer)) if isinstance(j, Rolling)]
    told = [one for one in mech.starts if one.link in group.links]
    wheels = [
        circle.link
        for joint in rolls
        for circle in (joint.gear, joint.on)
        if isinstance(circle, Circle) and circle.link in group.links
    ]
    rest = [link for link in dict.fromkeys(wheels) if link not in {one.link for one in told}]
    return (*(standing(mech, one) for one in told), *(start_of(mech, link) for link in rest))[: len(rolls)]
