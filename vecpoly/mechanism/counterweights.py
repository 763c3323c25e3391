"""Full balance of the inertia forces of a linkage 完全平衡: which link carries what mass on to which other.

A mass on a link is passed on towards the frame through hinges: a link with a counterweight passes all it carries to its
pivot, one that only translates to a hinge, any other to two of its hinges by shares. SI.
"""

from __future__ import annotations

from collections.abc import Iterable

from ..errors import FaultError
from ..foundation.slotted import dataclass
from ..words import Words
from .groups.assur import hinges
from .joints import FRAME, Prismatic
from .loads import Loads, Mass
from .model import Mechanism

FAR = 10**6  # of a link from which no chain of hinges leads to the frame


@dataclass(frozen=True, slots=True)
class Outlet:
    """A hinge, and the link on which a mass at it is carried further."""

    point: str
    to: str


@dataclass(frozen=True, slots=True, kw_only=True)
class Passing:
    """A link that carries masses, and where it passes them on: at its pivot (`r`, m, is that of its counterweight),
    at the hinge of a link that only translates, or at two hinges by shares."""

    link: str
    outlets: tuple[Outlet, ...]
    r: float | None = None
    towards: str = ""  # from the pivot to this point of the link its counterweight's angle is measured


@dataclass(frozen=True, slots=True, kw_only=True)
class Counterweights:
    """The masses of a linkage (`loads`), and the links that carry them in the order in which they are passed on."""

    loads: Loads
    order: tuple[Passing, ...]

    @property
    def mounts(self) -> tuple[Passing, ...]:
        """The links with a counterweight."""
        return tuple(one for one in self.order if one.r is not None)

    @property
    def own(self) -> float:
        """The mass of the linkage without them (kg)."""
        return sum(mass.mass for mass in self.loads.masses)


def counterweights_of(mech: Mechanism, loads: Loads, radii: dict[str, float]) -> Counterweights:
    """Plan how every mass is carried to the frame; radii: of the counterweights (m).

    Raises FaultError where a mass has no way to the frame through hinges, or goes round in a circle.
    """
    here = _Carrying(mech=mech, masses=loads.masses, named=tuple(radii))
    stands = here.sources()
    for link in radii:
        if link not in stands:
            raise _idle(mech, link)
    order = _ordered(mech, {link: here.outlets(link, points) for link, points in stands.items()})
    return Counterweights(
        loads=loads,
        order=tuple(
            Passing(
                link=link,
                outlets=outlets,
                r=radii.get(link),
                towards=_towards(mech, link, outlets[0].point) if link in radii else "",
            )
            for link, outlets in order.items()
        ),
    )


@dataclass(frozen=True, slots=True, kw_only=True)
class _Carrying:
    mech: Mechanism
    masses: tuple[Mass, ...]
    named: tuple[str, ...]

    def sources(self) -> dict[str, frozenset[str]]:
        """Every link that carries masses -> the points at which they stand."""
        found: dict[str, frozenset[str]] = {mass.link: frozenset((mass.centre,)) for mass in self.masses}
        while True:
            more = dict(found)
            for link, points in found.items():
                for out in self.outlets(link, points):
                    if out.to != FRAME:
                        more[out.to] = more.get(out.to, frozenset()) | {out.point}
            if more == found:
                return found
            found = more

    def outlets(self, link: str, points: frozenset[str]) -> tuple[Outlet, ...]:
        """Where masses at these points leave a link. Raises FaultError."""
        ways = sorted(self._hinges(link), key=self._rank)
        if not ways or self.far(ways[0].to) >= FAR:
            raise no_way(self.mech, link)
        if link in self.named or link in translating(self.mech):
            return (ways[0],)
        known = self.mech.link(link).points
        at = {known[point] for point in points}
        near = self._rank(ways[:2][-1])  # not to links farther out, which would give it back
        whole = [way for way in ways if at == {known[way.point]} and self._rank(way) <= near]
        if whole or len(ways) > 1:
            return (whole[0],) if whole else (ways[0], ways[1])
        raise _hangs(self.mech, link, ways[0].point)

    def _hinges(self, link: str) -> list[Outlet]:
        """One for every hinge of the link: the neighbour that is nearest to the frame."""
        found = []
        for point, names in hinges(self.mech).items():
            others = [name for name in names if name != link and (name == FRAME or name in self.mech.numbered)]
            if link in names and others:
                found.append(min((Outlet(point, name) for name in others), key=self._rank))
        return found

    def _rank(self, way: Outlet) -> tuple[int, int]:
        """First the frame, then links with counterweights, then by the number of hinges to the frame."""
        first = 0 if way.to == FRAME else 1 if way.to in self.named else 2
        return (first if self.far(way.to) < FAR else 3, self.far(way.to))

    def far(self, link: str) -> int:
        """How many hinges lie between a link and the frame."""
        reached, distance = {FRAME}, 0
        while link not in reached:
            near = {name for names in hinges(self.mech).values() if reached & {*names} for name in names}
            if near <= reached:
                return FAR
            reached, distance = reached | near, distance + 1
        return distance


def translating(mech: Mechanism) -> frozenset[str]:
    """The links that never turn: they slide on the frame, or on a link that does."""
    pairs = [{joint.guide, joint.block} for joint in mech.joints if isinstance(joint, Prismatic)]
    found = {FRAME}
    while more := {name for pair in pairs if pair & found for name in pair} - found:
        found |= more
    return frozenset(found - {FRAME})


def _ordered(mech: Mechanism, ways: dict[str, tuple[Outlet, ...]]) -> dict[str, tuple[Outlet, ...]]:
    """Links whose masses come from others after these. Raises FaultError where masses go round in a circle."""
    left, order = dict(ways), dict[str, tuple[Outlet, ...]]()
    while left:
        led = {out.to for outlets in left.values() for out in outlets}
        ready = [link for link in left if link not in led]
        if not ready:
            raise _circle(mech, _in_circle(left))
        order |= {link: left.pop(link) for link in ready}
    return order


def _in_circle(ways: dict[str, tuple[Outlet, ...]]) -> tuple[str, ...]:
    """Without the links to which masses only come."""
    while ends := [link for link, outs in ways.items() if not any(out.to in ways for out in outs)]:
        ways = {link: outs for link, outs in ways.items() if link not in ends}
    return tuple(ways)


def _towards(mech: Mechanism, link: str, pivot: str) -> str:
    """The point to which the link's line goes out from its pivot: another hinge, else any other point."""
    points = mech.link(link).points
    others = [name for name, at in points.items() if at != points[pivot]]
    joined = [name for name in others if name in hinges(mech)]
    return next(iter((*joined, *others)), pivot)


def _listed(mech: Mechanism, links: Iterable[str]) -> tuple[str, str]:
    numbers = [mech.number(link) for link in links]
    return "、".join(numbers), " and ".join(numbers)


def no_way(mech: Mechanism, link: str, rest: Words | None = None) -> FaultError:
    """Why no counterweight can balance this link; rest: what the best of them leaves."""
    number = mech.number(link)
    why = Words(
        f"构件 {number} 没有仅由转动副通向机架的路径，其惯性力不能用配重完全平衡",
        f"no way leads from link {number} to the frame through turning pairs alone: counterweights cannot balance "
        "its inertia force fully",
    )
    return FaultError(why + rest if rest is not None else why, code="no-balance", numbers={"link": number})


def _hangs(mech: Mechanism, link: str, point: str) -> FaultError:
    number = mech.number(link)
    return FaultError(
        Words(
            f"构件 {number} 只在 {point} 处铰接，其质心绕 {point} 转动；请给它加配重，如 {number}: {{r: 60 mm}}",
            f"link {number} is hinged at {point} alone, and its masses swing about {point}; give it a counterweight, "
            f"e.g. {number}: {{r: 60 mm}}",
        ),
        code="no-balance",
        numbers={"link": number},
    )


def _circle(mech: Mechanism, links: tuple[str, ...]) -> FaultError:
    zh, en = _listed(mech, links)
    turning = [mech.number(link) for link in links if link not in translating(mech)]
    return FaultError(
        Words(
            f"构件 {zh} 的质量相互代换，到不了机架；请再给构件 {'或 '.join(turning)} 加配重",
            f"links {en} pass their masses to each other and never to the frame; give link {' or '.join(turning)} a "
            "counterweight too",
        ),
        code="no-balance",
        numbers={"links": " ".join(links)},
    )


def _idle(mech: Mechanism, link: str) -> FaultError:
    number = mech.number(link)
    return FaultError(
        Words(
            f"构件 {number} 不承担任何质量，用不着配重；请删去，或给出它的质量",
            f"link {number} carries no mass and needs no counterweight; leave it out, or give its mass",
        ),
        number,
        code="contradiction",
    )
