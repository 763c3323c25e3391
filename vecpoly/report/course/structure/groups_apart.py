"""Every Assur group drawn apart: its links at their given places, its outer joints open, to the scale of the sketch."""

from __future__ import annotations

import cmath
from collections.abc import Iterator, Mapping

from ....board.construction import Figure, Scale, View
from ....board.paper.extent import extent
from ....board.paper.marks import Dot, Ground, LinkNumber, Mark, Point, Role, Segment
from ....diagram.links import link_alone
from ....diagram.posed import Posed
from ....findings.study.study import Study
from ....foundation.slotted import replace
from ....mechanism.groups.assur import Group, decompose, ends
from ....mechanism.model import Mechanism, Prismatic, Revolute
from ....names import subscripted
from ....problem.problem import Problem
from ....words import Words, begun
from .kinds import kind_told, members

_WIDE, _HIGH = 70.0, 52.0  # mm that a group may take
BAR = 2  # centres that it joins; a block has one
_OVER = 1.5  # times that a group may take more


def apart(study: Study) -> list[Figure]:
    """The driving link (a cylinder is in its group), then the groups, each a figure of its own."""
    drive = study.mech.drive.link
    driving = () if study.mech.drive.between else (drive,)
    figures = [
        _figure(study, (link,), _pins(study, (link,)), Words(f"原动件 {link}", f"Driving link {link}"), "0")
        for link in driving
    ]
    for i, group in enumerate(decompose(study.mech), 1):
        names, kind = members(study, group), begun(kind_told(group))
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
    over = max(has / may for has, may in zip(extent(marks), (_WIDE, _HIGH), strict=True))
    if over > _OVER:  # discs and racks, of which letters do not tell the size
        mu *= over
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
    posed = _posed(problem, mech or problem.mechanism, at, turned, per_m)
    alone = (link_alone(posed, link, lettered=False) for link in links)
    bodies = (replace(mark, owner=symbol.owner) for symbol in alone for mark in symbol.marks)
    return (*bodies, *_thought(posed, links), *_joints(posed, links, pins))


def _thought(posed: Posed, links: tuple[str, ...]) -> Iterator[Mark]:
    """The bar between two centres that stands for a higher pair, dashed and with its letter; no link has it."""
    for contact in (one for one in posed.mech.contacts if one.substitute in links):
        places = [posed.at[letter] for letter in posed.body(contact.substitute).points]
        if len(places) == BAR:
            yield Segment(a=places[0], b=places[1], role=Role.HIDDEN)
            yield LinkNumber(a=places[0], b=places[1], number=contact.point)


def _posed(
    problem: Problem, mech: Mechanism, at: Mapping[str, complex], turned: Mapping[str, float], per_m: float
) -> Posed:
    """The mechanism where the exact motion has it."""
    spots = {letter: spot * per_m for letter, spot in at.items()}
    located = {}
    for link in mech.links:
        along = cmath.rect(1.0, turned[link.name])
        letter, local = next(iter(link.points.items()))
        located[link.name] = (spots[letter] - along * per_m * local, along)
    thought = {contact.substitute: contact.point for contact in mech.contacts}
    names = {link.name: thought.get(link.name, mech.number(link.name)) for link in mech.links}
    posed = Posed(mech=mech, shapes=problem.given.shapes, per_metre=per_m, at=spots, located=located, names=names)
    return replace(posed, at=spots | {contact.point: posed.touching(contact) for contact in mech.contacts})


def _joints(posed: Posed, links: tuple[str, ...], pins: tuple[str, ...]) -> Iterator[Mark]:
    """The hinges of the group, and its other letters."""
    for letter in dict.fromkeys((*pins, *(letter for link in links for letter in posed.body(link).points))):
        if letter in posed.mech.frame and links == (posed.mech.drive.link,):
            yield Ground(at=posed.at[letter], down=-1j)
        dot = Dot.JOINT if letter in pins else Dot.POINT
        yield Point(at=posed.at[letter], label=subscripted(letter), dot=dot)


def _outer(group: Group) -> tuple[str, ...]:
    return tuple(out.joint.point for out in group.outer if isinstance(out.joint, Revolute))


def _inner(group: Group) -> tuple[str, ...]:
    return tuple(joint.point for joint in group.inner if isinstance(joint, Revolute))


def _pins(study: Study, links: tuple[str, ...]) -> tuple[str, ...]:
    return tuple(
        dict.fromkeys(j.point for j in study.mech.joints if isinstance(j, Revolute) and set(ends(j)) & set(links))
    )
