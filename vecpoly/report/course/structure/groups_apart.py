"""Every Assur group drawn apart: its links at their given places, its outer joints open, to the scale of the sketch."""

from __future__ import annotations

import cmath
from collections.abc import Iterator, Mapping

from ....board.construction import Figure, Scale, View
from ....board.paper.marks import Block, Dot, GearMark, Ground, LinkNumber, Mark, Plate, Point, Role, Segment, Slot
from ....findings.study.study import Study
from ....mechanism.groups.assur import Group, decompose, ends
from ....mechanism.model import Circle, Mechanism, Prismatic, Revolute, Rolling
from ....names import subscripted
from ....problem.problem import Problem, Shape
from ....words import Words
from ...structure import kind_of
from .kinds import ROLLING

_WIDE, _HIGH = 70.0, 52.0  # mm that a group may take
_HALF_SLOT, _BEYOND, _FLAT = 11.0, 9.0, 0.02


def apart(study: Study) -> list[Figure]:
    """The driving link (a cylinder is in its group), then the groups, each a figure of its own."""
    drive = study.mech.drive.link
    driving = () if study.mech.drive.between else (drive,)
    figures = [
        _figure(study, (link,), _pins(study, (link,)), Words(f"原动件 {link}", f"Driving link {link}"), "0")
        for link in driving
    ]
    for i, group in enumerate(decompose(study.mech), 1):
        names = [study.name(link) for link in group.links]
        kind = ROLLING.get(
            group.kind,
            Words(f"{kind_of(group).zh} 杆组", f"{kind_of(group).en} group")
            if group.dyad or group.ram or group.kind == "driven"
            else Words(f"{group.kind.removeprefix('class ')} 级杆组", f"{group.kind} group"),
        )
        many = "links" if len(names) > 1 else "link"
        title = Words(f"{kind.zh}（构件 {'、'.join(names)}）", f"{kind.en} ({many} {', '.join(names)})")
        figures.append(_figure(study, group.links, _outer(group) + _inner(group), title, str(i)))
    return figures


def _figure(study: Study, links: tuple[str, ...], pins: tuple[str, ...], title: Words, name: str) -> Figure:
    places = [study.at[p] for link in links for p in study.mech.link(link).points] + [study.at[p] for p in pins]
    places += [
        study.at[j.pin]
        for j in study.mech.joints
        if isinstance(j, Prismatic) and set(ends(j)) & set(links) and j.pin in study.at
    ]
    wide = max((abs(a.real - b.real) for a in places for b in places), default=0.0)
    high = max((abs(a.imag - b.imag) for a in places for b in places), default=0.0)
    mu = max(wide / (_WIDE - 25), high / (_HIGH - 20), study.mech.scale / 60)
    marks = sketched(study.problem, study.at, study.turned, 1 / mu, links, pins, study.mech)
    return Figure(view=View.MECHANISM, title=title, scale=Scale(symbol="", value=mu, unit="m"), marks=marks, name=name)


def sketched(
    problem: Problem,
    at: Mapping[str, complex],
    turned: Mapping[str, float],
    per_m: float,
    links: tuple[str, ...],
    pins: tuple[str, ...],
    mech: Mechanism | None = None,
) -> tuple[Mark, ...]:
    """These links with these hinges as marks: places of letters (m), angles of links (rad), mm for a metre."""
    sketch = _Sketch(problem, mech or problem.mechanism, at, turned, per_m, links)
    return (*(mark for link in links for mark in sketch.link(link)), *sketch.joints(pins))


def _outer(group: Group) -> tuple[str, ...]:
    return tuple(out.joint.point for out in group.outer if isinstance(out.joint, Revolute))


def _inner(group: Group) -> tuple[str, ...]:
    return tuple(joint.point for joint in group.inner if isinstance(joint, Revolute))


def _pins(study: Study, links: tuple[str, ...]) -> tuple[str, ...]:
    return tuple(
        dict.fromkeys(j.point for j in study.mech.joints if isinstance(j, Revolute) and set(ends(j)) & set(links))
    )


_ALIKE = {Shape.CYLINDER: Shape.SLOT, Shape.PISTON: Shape.BLOCK}  # links apart are sketched as pairs are


class _Sketch:
    """Links as marks at a scale (mm per m)."""

    def __init__(
        self,
        problem: Problem,
        mech: Mechanism,
        at: Mapping[str, complex],
        turned: Mapping[str, float],
        per_m: float,
        links: tuple[str, ...],
    ) -> None:
        shapes = {name: _ALIKE.get(shape, shape) for name, shape in problem.given.shapes.items()}
        self.shapes, self.mech, self.at, self.turned, self.k, self.links = shapes, mech, at, turned, per_m, links

    def name(self, link: str) -> str:
        """Its number; the contact's letter for the substitute of a high pair."""
        return next((c.point for c in self.mech.contacts if c.substitute == link), self.mech.number(link))

    def spot(self, letter: str) -> complex:
        return self.at[letter] * self.k

    def link(self, name: str) -> Iterator[Mark]:
        """The body of a link with its number."""
        mech, shape = self.mech, self.shapes.get(name, Shape.BAR)
        spots = [self.spot(p) for p in mech.link(name).points]
        slides = [j for j in mech.joints if isinstance(j, Prismatic) and name in (j.guide, j.block)]
        for joint in slides:
            yield from self._sliding(name, joint, shape, spots)
        guided = shape in (Shape.SLOT, Shape.ROD) and bool(slides)
        if len(spots) > 1 and (not guided or shape is Shape.SLOT):
            yield from (
                _body(spots)
                if shape is not Shape.BLOCK
                else (Segment(a=spots[0], b=s, role=Role.LINK) for s in spots[1:])
            )
        for rolling in (j for j in mech.joints if isinstance(j, Rolling)):
            yield from (
                GearMark(centre=self.spot(c.centre), radius=c.radius * self.k)
                for c in (rolling.gear, rolling.on)
                if isinstance(c, Circle) and c.link == name
            )
        if spots:
            yield LinkNumber(a=spots[0], b=spots[min(1, len(spots) - 1)], number=self.name(name))

    def _sliding(self, name: str, joint: Prismatic, shape: Shape, spots: list[complex]) -> Iterator[Mark]:
        lean = self.turned.get(joint.guide, 0.0) + joint.direction
        along = cmath.rect(1.0, lean)
        pin = self.spot(joint.pin) if joint.pin in self.at else (spots[0] if spots else 0j)
        middle = pin - 1j * along * joint.offset * self.k
        if name == joint.block and shape is not Shape.PIN:
            yield Block(at=middle, along=along, on_rod=self.shapes.get(joint.guide) is Shape.ROD)
            if abs(pin - middle) > 3.0:
                yield Segment(a=middle, b=pin, role=Role.LINK)
        elif name == joint.guide and shape is Shape.SLOT:
            start, end = middle - along * _HALF_SLOT, middle + along * _HALF_SLOT
            yield Slot(a=start, b=end)
            yield from (
                Segment(a=p, b=min((start, end), key=lambda s: abs(s - p)), role=Role.LINK)
                for p in spots
                if abs(p - middle) > _HALF_SLOT
            )
        elif name == joint.guide:
            ways = [(along.conjugate() * (p - middle)).real for p in spots]
            a, b = min([*ways, -_BEYOND]), max([*ways, _BEYOND])
            yield Segment(a=middle + a * along, b=middle + b * along, role=Role.LINK)
            for p, way in zip(spots, ways, strict=True):
                if abs(p - middle - way * along) > 0.3:
                    yield Segment(a=middle + way * along, b=p, role=Role.LINK)

    def joints(self, pins: tuple[str, ...]) -> Iterator[Mark]:
        """The hinges of the group, and its other letters."""
        drive = self.mech.drive.link
        for letter in dict.fromkeys((*pins, *(p for link in self.links for p in self.mech.link(link).points))):
            if letter in self.mech.frame and self.links == (drive,):
                yield Ground(at=self.spot(letter), down=-1j)
            yield Point(at=self.spot(letter), label=subscripted(letter), dot=Dot.JOINT if letter in pins else Dot.POINT)


def _body(spots: list[complex]) -> Iterator[Mark]:
    """A bar, or a plate where the points are not in one line."""
    far = max(spots, key=lambda s: abs(s - spots[0]))
    ray = far - spots[0]
    flat = all(abs((ray.conjugate() * (s - spots[0])).imag) < _FLAT * abs(ray) ** 2 for s in spots)
    if flat:
        ends_ = sorted(spots, key=lambda s: (ray.conjugate() * s).real)
        yield Segment(a=ends_[0], b=ends_[-1], role=Role.LINK)
    else:
        yield Plate(points=tuple(spots))
