"""How the links of a structural sketch are drawn (GB/T 4460):
bars, plates, cams, rollers, gears, guides. Places on paper in mm."""

from __future__ import annotations

import cmath
import math
from collections.abc import Callable, Iterator
from dataclasses import dataclass

from ....board.paper.marks import Arc, Disc, GearMark, LinkNumber, Mark, Outline, Plate, Role, Segment
from ....devices.structure_pairs import FRAME, Chain, Form, Pair

NEAR = 0.3  # mm: places closer than this are one
BEYOND, FACE, DEEP = (
    13.0,
    11.0,
    4.0,
)  # mm: a guide goes on past its block; half a flat face or a concave arc; thickness of a fixed profile


@dataclass(frozen=True, slots=True)
class Paper:
    """From places in m to places on paper, and a link to its printed number."""

    mm: Callable[[complex], complex]
    number: Callable[[str], str]


def body(chain: Chain, link: str, paper: Paper) -> Iterator[Mark]:
    """A moving link with its number: what joins its hinges, its profiles, and its guide."""
    pairs = chain.at(link)
    profiles = [pair for pair in pairs if not pair.form.is_lower]
    for pair in profiles:
        yield from profile(pair, link, paper)
    points = _points(pairs, link, paper)
    rods = [
        rod
        for pair in pairs
        if pair.form is Form.P and pair.links[1] == link
        for rod in _rod(paper.mm(pair.at), pair.along, BEYOND, points)
    ]
    rods += [
        rod
        for pair in profiles
        if _round(pair, link, paper)[0] is None
        for rod in _rod(paper.mm(pair.at), 1j * pair.normal, FACE, points)
    ]
    yield from rods
    if not rods:
        yield from _shape(points)
    yield _numbered(link, points, rods, profiles, paper)


def _points(pairs: tuple[Pair, ...], link: str, paper: Paper) -> list[complex]:
    """The places that the link's lines join, each once."""
    found: list[complex] = []
    solid = [paper.mm(p.at) for p in pairs if p.form.is_lower or _round(p, link, paper)[0] is None]
    for pair in pairs:
        if pair.form is Form.R or (pair.form is Form.P and pair.links[0] == link):
            found.append(paper.mm(pair.at))
        elif pair.form is Form.H:
            centre, radius = _round(pair, link, paper)
            if centre is None:
                continue
            if _hollow(pair, link):
                found.append(paper.mm(pair.at))
            elif not _on_body(centre, radius, solid):
                found.append(centre)
    return _once(found)


def _on_body(centre: complex, radius: float, solid: list[complex]) -> bool:
    """Whether a disc holds a joint of its link, or a part of the line between two."""
    return any(abs(h - centre) < radius for h in solid) or any(
        abs(centre - _foot(a, b, centre)) < radius for a in solid for b in solid if abs(b - a) > NEAR
    )


def _foot(a: complex, b: complex, p: complex) -> complex:
    """The point of the line from a to b nearest to p."""
    share = ((b - a).conjugate() * (p - a)).real / abs(b - a) ** 2
    return a + min(max(share, 0.0), 1.0) * (b - a)


def _once(places: list[complex]) -> list[complex]:
    kept: list[complex] = []
    for place in places:
        if all(abs(place - other) > NEAR for other in kept):
            kept.append(place)
    return kept


def _shape(points: list[complex]) -> Iterator[Mark]:
    """Nothing, a bar, or a plate through the points; a bar through points on one line."""
    if len(points) < 2:
        return
    a, b = max(((p, q) for p in points for q in points), key=lambda pq: abs(pq[1] - pq[0]))
    u = (b - a) / abs(b - a)
    if all(abs((u.conjugate() * (p - a)).imag) < NEAR for p in points):
        yield Segment(a=a, b=b, role=Role.LINK)
    else:
        yield Plate(points=hull(points))


def hull(points: list[complex]) -> tuple[complex, ...]:
    """The corners of the smallest convex polygon round the points, counter-clockwise."""
    ordered = sorted(points, key=lambda p: (p.real, p.imag))

    def chain(row: list[complex]) -> list[complex]:
        kept: list[complex] = []
        for p in row:
            while len(kept) > 1 and ((kept[-1] - kept[-2]).conjugate() * (p - kept[-1])).imag <= 0:
                kept.pop()
            kept.append(p)
        return kept[:-1]

    return tuple(chain(ordered) + chain(ordered[::-1]))


def _rod(at: complex, u: complex, half: float, points: list[complex]) -> Iterator[Segment]:
    """A guide that moves, or a flat face: a rod through its block or contact, on to its hinges;
    a hinge beside it is joined to it at right angles."""
    aside = [p for p in points if abs((u.conjugate() * (p - at)).imag) > NEAR]
    along = [(u.conjugate() * (p - at)).real for p in points]
    back, ahead = min([-half, *along]), max([half, *along])
    yield Segment(a=at + back * u, b=at + ahead * u, role=Role.LINK)
    for p in aside:
        yield Segment(a=at + u * (u.conjugate() * (p - at)).real, b=p, role=Role.LINK)


def profile(pair: Pair, link: str, paper: Paper) -> Iterator[Mark]:
    """The profile of a link at a high pair: a gear's pitch circle, a disc,
    a hollow arc, a flat face; of the frame hatched."""
    centre, radius = _round(pair, link, paper)
    at = paper.mm(pair.at)
    if pair.form is Form.G:
        assert centre is not None
        yield GearMark(centre=centre, radius=radius)
    elif link == FRAME:
        yield Outline(points=_fixed(pair, at, centre, radius), fixed=True)
    elif centre is None:
        return  # a flat face is drawn with its link
    elif _hollow(pair, link):
        half = min(FACE / radius, math.pi / 3)
        yield Arc(centre=centre, radius=radius, start=cmath.phase(at - centre) - half, sweep=2 * half, role=Role.LINK)
    else:
        yield Disc(centre=centre, radius=radius)


def _round(pair: Pair, link: str, paper: Paper) -> tuple[complex | None, float]:
    """Centre and radius of a profile on paper; no centre where it is flat."""
    if pair.form.is_lower:
        return None, 0.0
    centre = pair.about[pair.links.index(link)]
    return (None, 0.0) if centre is None else (paper.mm(centre), abs(paper.mm(pair.at) - paper.mm(centre)))


def _hollow(pair: Pair, link: str) -> bool:
    """Whether the profile is the outer one of two that curve the same way."""
    mine, its = (pair.about[i] for i in (pair.links.index(link), 1 - pair.links.index(link)))
    if mine is None or its is None:
        return False
    same = ((mine - pair.at).conjugate() * (its - pair.at)).real > 0
    return same and abs(mine - pair.at) > abs(its - pair.at)


def _fixed(pair: Pair, at: complex, centre: complex | None, radius: float) -> tuple[complex, ...]:
    """A strip of a fixed profile about the contact."""
    if centre is None:
        side = 1 if pair.links.index(FRAME) == 1 else -1
        t, back = 1j * pair.normal * FACE, side * pair.normal * DEEP
        return at - t, at + t, at + t + back, at - t + back
    inward = -1.0 if not _hollow(pair, FRAME) else 1.0
    half = min(1.6 * FACE / radius, math.pi / 3)
    turns = [cmath.rect(1.0, cmath.phase(at - centre) + half * (i / 8 - 1)) for i in range(17)]
    return (*(centre + radius * t for t in turns), *(centre + (radius + inward * DEEP) * t for t in reversed(turns)))


def _numbered(link: str, points: list[complex], rods: list[Segment], profiles: list[Pair], paper: Paper) -> LinkNumber:
    """Its number beside its longest line; within its profile or beside its block where it has no line."""
    number = paper.number(link)
    lines = [(rod.a, rod.b) for rod in rods]
    if not lines and len(points) > 1:
        corners = list(hull(points)) if len(points) > 2 else points
        lines = list(zip(corners, corners[1:] + corners[:1], strict=True))
    if lines:
        a, b = max(lines, key=lambda ab: abs(ab[1] - ab[0]))
        return LinkNumber(a=a, b=b, number=number)
    if profiles:
        centre, radius = max((_round(p, link, paper) for p in profiles), key=lambda cr: cr[1])
        at = (centre or 0j) + (0.55 * radius if radius > 8 else 0.0) * cmath.rect(1.0, -2.2)
        return LinkNumber(a=at, b=at, number=number)
    return LinkNumber(a=points[0], b=points[0], number=number)
