"""The dimensions a problem gives, each by name: coordinates of pivots, lengths and angles, places of guides."""

from __future__ import annotations

import cmath
from collections.abc import Iterator
from dataclasses import dataclass

from ..mechanism.dimensions import values as dimension
from ..mechanism.dimensions import vary as dims
from ..mechanism.dimensions.values import ANGLES, Bar, Coordinate, Led, Part, Placed
from ..mechanism.dimensions.vary import upright, value, varied
from ..mechanism.model import ByAngle, ByLengths, ByOffsets, Link, Mechanism, Placement, Prismatic
from ..words import Words

_NEAR = 1e-9


@dataclass(frozen=True, slots=True)
class Dimension:
    """A given dimension: its name, the mechanism that has it, which one it is; unsigned: of it the size is told."""

    name: Words
    mech: Mechanism
    one: dimension.Dimension
    unsigned: bool = False

    @property
    def size(self) -> float:
        """What it is (m, or rad)."""
        now = value(self.mech, self.one)
        return abs(now) if self.unsigned else now

    @property
    def is_angle(self) -> bool:
        """Whether it is an angle."""
        return isinstance(self.one, Placed | Led) and self.one.part in ANGLES

    def enlarged(self, more: float) -> Mechanism:
        """The mechanism in which it alone is larger by so much; ValueError where no triangle closes."""
        now = value(self.mech, self.one)
        other = varied(self.mech, self.one, now - more if self.unsigned and now < 0 else now + more)
        if isinstance(self.one, Placed) and any(cmath.isnan(at) for at in other.link(self.one.link).points.values()):
            raise ValueError(f"no triangle: {self.name.en}")
        return other


def given_dimensions(mech: Mechanism, written: frozenset[str] = frozenset()) -> Iterator[Dimension]:
    """All dimensions of a mechanism as its file gives them; the frame is told from the input link's pivot.

    written: symbols of lengths as the problem writes them, l_CD.
    """
    drive = mech.link(mech.drive.link).points
    origin = next((letter for letter in mech.frame if letter in drive), next(iter(mech.frame), ""))
    for link in mech.links:
        yield from _of_link(mech, link, written)
    for letter in mech.frame:
        if letter != origin:
            yield from (
                Dimension(Words.same(f"${axis}_{{{letter}}}$"), mech, Coordinate(letter=letter, axis=axis))
                for axis in "xy"
            )
    for i, joint in enumerate(mech.joints):
        if isinstance(joint, Prismatic) and joint.block not in mech.substitutes:
            yield from (_of_guide(mech, joint, one) for one in dims.of_guide(i, joint))
    for disc in dict.fromkeys(disc for contact in mech.contacts for disc in dims.of_contact(contact)):
        yield Dimension(Words.same(f"$r_{{{mech.disc_number(disc.link)}}}$"), mech, disc)


def _of_link(mech: Mechanism, link: Link, written: frozenset[str]) -> Iterator[Dimension]:
    """The distance of its first two points, then what sets out the others; points at one foot share it."""
    for one in dims.of_link(mech, link):
        if isinstance(one, Bar):
            yield Dimension(_length(written, *link.axis), mech, one)
        else:
            yield from _of_placement(mech, link, one, written)


def _of_placement(mech: Mechanism, link: Link, one: Placed, written: frozenset[str]) -> Iterator[Dimension]:
    (i,), placement = one.places, link.placements[one.places[0]]
    axis = _axis(mech, link, placement)
    match placement:
        case ByLengths(point=point, base=base):
            yield Dimension(_length(written, base[one.part is Part.SECOND], point), mech, one)
        case ByAngle(point=point, base=base) if one.part is Part.DISTANCE:
            yield Dimension(_length(written, base[0], point), mech, one)
        case ByAngle(point=point, base=base):
            known = (
                Words.same(f"$∠{base[1]}{base[0]}{point}$")
                if len(base) == 2
                else Words(f"${base[0]}{point}$ 的倾角", f"angle of ${base[0]}{point}$")
            )
            yield Dimension(known, mech, one)
        case ByOffsets(point=point, base=base, left=left) if one.part is Part.ALONG:
            feet = tuple(k for k, other in enumerate(link.placements) if _one_foot(other, placement))
            if feet[0] == i:
                name = (
                    Words(
                        f"${point}$ 沿{axis.zh}到 ${base[0]}$ 的距离",
                        f"distance of ${point}$ from ${base[0]}$ along {axis.en}",
                    )
                    if left
                    else _length(written, base[0], point)
                )
                yield Dimension(name, mech, Placed(link=link.name, places=feet, part=Part.ALONG))
        case ByOffsets(point=point, base=base, left=left) if left:
            name = Words(f"${point}$ 到{axis.zh}的距离", f"distance of ${point}$ from {axis.en}")
            yield Dimension(name, mech, one, unsigned=True)


def _axis(mech: Mechanism, link: Link, placement: Placement) -> Words:
    """The line along which a point is set out: $AB$; through one point alone the axis of the link."""
    line = "".join(placement.base)
    if len(placement.base) > 1:
        return Words(f" ${line}$ ", f"${line}$")
    number = mech.number(link.name)
    return Words(f"构件 {number} 的轴线", f"the axis of link {number}")


def _one_foot(other: Placement, placement: ByOffsets) -> bool:
    return isinstance(other, ByOffsets) and other.base == placement.base and abs(other.along - placement.along) < _NEAR


def _length(written: frozenset[str], a: str, b: str) -> Words:
    """l_AB, lettered as the problem does."""
    return Words.same(f"$l_{{{b}{a}}}$" if f"l_{b}{a}" in written else f"$l_{{{a}{b}}}$")


def _of_guide(mech: Mechanism, guide: Prismatic, one: Led) -> Dimension:
    """The place of a fixed guide, or its angle through a pivot; the offset of a pin, the turn of a block."""
    pin, number = guide.pin, mech.number(guide.block)
    match one.part:
        case Part.PLACE:
            return Dimension(Words.same(f"${'x' if upright(guide) else 'y'}_{{{pin}}}$"), mech, one)
        case Part.DIRECTION:
            return Dimension(Words("导路的倾角", "angle of the guide"), mech, one)
        case Part.OFFSET:
            return Dimension(Words.same(f"$e_{{{number}}}$"), mech, one, unsigned=True)
        case _:
            return Dimension(Words(f"构件 {number} 与导路的夹角", f"angle of link {number} to its guide"), mech, one)
