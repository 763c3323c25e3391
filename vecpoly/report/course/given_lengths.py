"""The dimensions a problem gives, each of which may be changed alone: coordinates of pivots, lengths and angles of links, places of guides."""

from __future__ import annotations

import cmath
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, replace
from math import cos, sin

from ...mechanism.model import (
    FRAME,
    ByAngle,
    ByLengths,
    ByOffsets,
    Circle,
    Contact,
    Joint,
    Link,
    Mechanism,
    Placement,
    Prismatic,
    Side,
)
from ...words import Words

_NEAR = 1e-9


@dataclass(frozen=True, slots=True)
class Dimension:
    """A given dimension (m, or rad), and the mechanism in which it alone is larger by so much; ValueError where no triangle closes."""

    name: Words
    size: float
    enlarged: Callable[[float], Mechanism]
    is_angle: bool = False


def given_dimensions(mech: Mechanism, written: frozenset[str] = frozenset()) -> Iterator[Dimension]:
    """All dimensions of a mechanism as its file gives them; the drive's pivot is the origin from which the frame is told.

    written: symbols of lengths as the problem writes them, l_CD.
    """
    drive = mech.link(mech.drive.link).points
    origin = next((letter for letter in mech.frame if letter in drive), next(iter(mech.frame), ""))
    for link in mech.links:
        yield from _of_link(mech, link, written)
    for letter, place in mech.frame.items():
        for axis, size, way in (("x", place.real, 1.0), ("y", place.imag, 1j)):
            if letter != origin:
                yield Dimension(Words.same(f"${axis}_{{{letter}}}$"), size, lambda more, letter=letter, way=way: _moved(mech, FRAME, {**mech.frame, letter: mech.frame[letter] + more * way}))  # type: ignore[misc]
    for i, joint in enumerate(mech.joints):
        if isinstance(joint, Prismatic) and joint.block not in mech.substitutes:
            yield from _of_guide(mech, i, joint)
    for contact in mech.contacts:
        yield from _of_discs(mech, contact)


def _of_link(mech: Mechanism, link: Link, written: frozenset[str]) -> Iterator[Dimension]:
    """The distance of its first two points, then what sets out the others."""
    letters = list(link.points)
    placed = {one.point for one in link.placements}
    if len(letters) > 1 and letters[1] not in placed and link.name not in mech.substitutes:
        span = link.points[letters[1]].real
        yield Dimension(_length(written, *letters[:2]), span, lambda more: _set_out(mech, link, link.placements, span + more))
    for i, one in enumerate(link.placements):
        def changed(i: int = i, **new: object) -> Mechanism:
            return _set_out(mech, link, (*link.placements[:i], replace(link.placements[i], **new), *link.placements[i + 1:]))  # type: ignore[arg-type]

        match one:
            case ByLengths(point=point, base=(a, b), lengths=(p, q)):
                yield Dimension(_length(written, a, point), p, lambda more, c=changed, p=p, q=q: c(lengths=(p + more, q)))  # type: ignore[misc]
                yield Dimension(_length(written, b, point), q, lambda more, c=changed, p=p, q=q: c(lengths=(p, q + more)))  # type: ignore[misc]
            case ByAngle(point=point, base=base, distance=r, angle=angle):
                yield Dimension(_length(written, base[0], point), r, lambda more, c=changed, r=r: c(distance=r + more))  # type: ignore[misc]
                name = Words.same(f"$∠{base[1]}{base[0]}{point}$") if len(base) == 2 else Words(f"${base[0]}{point}$ 的倾角", f"angle of ${base[0]}{point}$")
                yield Dimension(name, angle, lambda more, c=changed, angle=angle: c(angle=angle + more), True)  # type: ignore[misc]
            case ByOffsets(point=point, base=base, along=along, left=left):
                line = "".join(base)
                foot = any(isinstance(o, ByOffsets) and o.base == base and abs(o.along - along) < _NEAR for o in link.placements[:i])
                if not foot:
                    name = Words(f"${point}$ 沿 ${line}$ 的距离", f"${point}$ along ${line}$") if left else _length(written, base[0], point)
                    yield Dimension(name, along, lambda more, base=base, along=along: _set_out(mech, link, tuple(  # type: ignore[misc]
                        replace(o, along=o.along + more) if isinstance(o, ByOffsets) and o.base == base and abs(o.along - along) < _NEAR else o for o in link.placements)))
                if left:
                    yield Dimension(Words(f"${point}$ 到 ${line}$ 的距离", f"${point}$ off ${line}$"), abs(left), lambda more, c=changed, left=left: c(left=left + (more if left > 0 else -more)))  # type: ignore[misc]


def _length(written: frozenset[str], a: str, b: str) -> Words:
    """l_AB, lettered as the problem does."""
    return Words.same(f"$l_{{{b}{a}}}$" if f"l_{b}{a}" in written else f"$l_{{{a}{b}}}$")


def _set_out(mech: Mechanism, link: Link, placements: tuple[Placement, ...], span: float | None = None) -> Mechanism:
    """The mechanism with this link's points set out anew."""
    letters, placed = list(link.points), {one.point for one in placements}
    points = {letter: place for letter, place in link.points.items() if letter not in placed}
    if span is not None:
        points[letters[1]] = complex(span)
    for one in placements:
        points[one.point] = _place(one, points)
    return _moved(mech, link.name, {letter: points[letter] for letter in letters}, placements)


def _place(one: Placement, points: Mapping[str, complex]) -> complex:
    """Where the point lies; ValueError where no triangle closes."""
    start = points[one.base[0]]
    ray = points[one.base[1]] - start if len(one.base) > 1 else 1.0 + 0j
    unit = ray / abs(ray)
    match one:
        case ByOffsets():
            return start + unit * complex(one.along, one.left)
        case ByAngle():
            return start + unit * cmath.rect(one.distance, one.angle)
        case ByLengths(lengths=(p, q)):
            x = (p * p - q * q + abs(ray) ** 2) / (2 * abs(ray))
            if p < abs(x):
                raise ValueError(f"no triangle: {one.point}")
            return start + unit * complex(x, (p * p - x * x) ** 0.5 * (1 if one.side is Side.LEFT else -1))


def _moved(mech: Mechanism, name: str, points: Mapping[str, complex], placements: tuple[Placement, ...] | None = None) -> Mechanism:
    """The mechanism with the points of one link, or of the frame, moved, and the guide lines through them with them."""
    old = mech.link(name).points
    joints = tuple(_led(joint, old, points) if isinstance(joint, Prismatic) and joint.guide == name else joint for joint in mech.joints)
    if name == FRAME:
        return replace(mech, frame=points, joints=joints)
    links = tuple(replace(one, points=points, placements=one.placements if placements is None else placements) if one.name == name else one for one in mech.links)
    return replace(mech, links=links, joints=joints)


def _led(guide: Prismatic, old: Mapping[str, complex], new: Mapping[str, complex]) -> Joint:
    """The guide line through its letter, and through a second letter that lay on it."""
    if guide.through not in old:
        return guide
    start, unit = old[guide.through], cmath.rect(1.0, guide.direction)
    other = next((letter for letter, place in old.items() if abs(place - start) > _NEAR and abs(((place - start) / unit).imag) < _NEAR), "")
    turned = cmath.phase((new[other] - new[guide.through]) / (old[other] - start)) if other else 0.0
    return replace(guide, origin=new[guide.through] + (guide.origin - start) * cmath.rect(1.0, turned), direction=guide.direction + turned)


def _of_guide(mech: Mechanism, i: int, guide: Prismatic) -> Iterator[Dimension]:
    """The place of a fixed guide, or its angle where it is set out from a pivot; the offset of a pin, the turn of a block."""
    def changed(**new: object) -> Mechanism:
        return replace(mech, joints=(*mech.joints[:i], replace(guide, **new), *mech.joints[i + 1:]))  # type: ignore[arg-type]

    pin, number = guide.pin, mech.number(guide.block)
    if guide.guide == FRAME and not guide.through:
        upright = abs(sin(guide.direction)) > abs(cos(guide.direction))
        way, size = (1.0, guide.origin.real) if upright else (1j, guide.origin.imag)
        yield Dimension(Words.same(f"${'x' if upright else 'y'}_{{{pin}}}$"), size, lambda more: changed(origin=guide.origin + more * way))
    elif guide.guide == FRAME:
        yield Dimension(Words("导路的倾角", "angle of the guide"), guide.direction, lambda more: changed(direction=guide.direction + more), True)
    if guide.offset:
        yield Dimension(Words.same(f"$e_{{{number}}}$"), abs(guide.offset), lambda more: changed(offset=guide.offset + (more if guide.offset > 0 else -more)))
    if guide.turn:
        yield Dimension(Words(f"构件 {number} 与导路的夹角", f"angle of link {number} to its guide"), guide.turn, lambda more: changed(turn=guide.turn + more), True)


def _of_discs(mech: Mechanism, contact: Contact) -> Iterator[Dimension]:
    """The radii of the profiles that touch: disc on disc at a fixed distance of centres, disc on a face at a fixed distance from it."""
    if isinstance(contact.on, Circle):
        bar = mech.link(contact.substitute)
        first, second = bar.points
        for disc, sign in ((contact.disc, -1.0 if contact.internal else 1.0), (contact.on, 1.0)):
            if disc.radius:
                yield Dimension(Words.same(f"$r_{{{mech.number(disc.link)}}}$"), disc.radius, lambda more, sign=sign: _moved(mech, bar.name, {first: bar.points[first], second: bar.points[second] + sign * more}))  # type: ignore[misc]
    elif contact.disc.radius:
        i = next(i for i, joint in enumerate(mech.joints) if isinstance(joint, Prismatic) and joint.block == contact.substitute)
        led, left = mech.joints[i], 1j if contact.side is Side.LEFT else -1j
        assert isinstance(led, Prismatic)
        yield Dimension(Words.same(f"$r_{{{mech.number(contact.disc.link)}}}$"), contact.disc.radius, lambda more: replace(mech, joints=(
            *mech.joints[:i], replace(led, origin=led.origin + more * left * cmath.rect(1.0, led.direction)), *mech.joints[i + 1:])))
