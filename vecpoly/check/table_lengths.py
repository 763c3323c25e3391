"""The lengths of a mechanism, one at a time: each by name, with its value, and the mechanism with another in its place."""

from __future__ import annotations

import cmath
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, replace
from functools import partial
from typing import assert_never

from ..mechanism.branch import opposite
from ..mechanism.model import (
    ByAngle,
    ByLengths,
    ByOffsets,
    Joint,
    Link,
    Mechanism,
    Placement,
    Prismatic,
    Shaped,
    Side,
    SideOf,
    Statement,
)
from ..words import Words

Points = dict[str, complex]
_OTHER = {Side.LEFT: Side.RIGHT, Side.RIGHT: Side.LEFT, Side.ABOVE: Side.BELOW, Side.BELOW: Side.ABOVE}
_SIDE = {Side.LEFT: "左侧", Side.RIGHT: "右侧", Side.ABOVE: "上方", Side.BELOW: "下方"}


@dataclass(frozen=True, slots=True, kw_only=True)
class Length:
    """One length: how it is called, its link (FRAME for the frame), its value (m), and whether it may be negative."""

    words: Words
    link: str
    value: float
    change: Callable[[float], Mechanism]
    signed: bool = False

    def instead(self, value: float) -> Mechanism:
        """The mechanism with this value (m) for this length, all else as it was."""
        return self.change(value)


def lengths(mech: Mechanism) -> tuple[Length, ...]:
    """Every length that a table may have been computed with another value of: bars, placed points, offsets, frame."""
    return (*_of_links(mech), *_of_frame(mech), *_offsets(mech))


def _of_links(mech: Mechanism) -> Iterator[Length]:
    for link in mech.links:
        placed = {placement.point for placement in link.placements}
        bases = [letter for letter in link.points if letter not in placed]
        if len(bases) == 2:
            first, second = bases
            yield Length(words=Words.same(f"$l_{{{first}{second}}}$"), link=link.name, value=abs(link.points[second] - link.points[first]),
                         change=partial(_bar, mech, link, first, second))
        for i, placement in enumerate(link.placements):
            for words, value, signed, put in _of_placement(placement):
                yield Length(words=words, link=link.name, value=value, signed=signed, change=partial(_replaced, mech, link, i, put))


def _of_placement(placement: Placement) -> Iterator[tuple[Words, float, bool, Callable[[float], Placement]]]:
    p, base = placement.point, "".join(placement.base)
    match placement:
        case ByAngle():
            yield Words.same(f"$l_{{{placement.base[0]}{p}}}$"), placement.distance, False, lambda v: replace(placement, distance=v)
        case ByLengths():
            for i, letter in enumerate(placement.base):
                yield Words.same(f"$l_{{{letter}{p}}}$"), placement.lengths[i], False, partial(_one_of_two, placement, i)
        case ByOffsets():
            if placement.along:
                words = Words(f"${p}$ 在 ${base}$ 上的垂足到 ${base[0]}$ 的距离", f"the distance of the foot of ${p}$ on ${base}$ from ${base[0]}$")
                yield words, placement.along, True, lambda v: replace(placement, along=v)
            if placement.left:
                words = Words(f"${p}$ 到 ${base}$ 的距离（左侧为正）", f"the distance of ${p}$ from ${base}$ (positive to the left)")
                yield words, placement.left, True, lambda v: replace(placement, left=v)


def _one_of_two(placement: ByLengths, i: int, value: float) -> Placement:
    first, second = placement.lengths
    return replace(placement, lengths=(value, second) if i == 0 else (first, value))


def _of_frame(mech: Mechanism) -> Iterator[Length]:
    for letter, place in mech.frame.items():
        for axis, value in (("x", place.real), ("y", place.imag)):
            if value:
                yield Length(words=Words.same(f"${axis}_{letter}$"), link="0", value=value, signed=True, change=partial(_moved, mech, letter, axis))


def _offsets(mech: Mechanism) -> Iterator[Length]:
    for i, joint in enumerate(mech.joints):
        if isinstance(joint, Prismatic) and joint.offset:
            words = Words(f"${joint.pin}$ 对导路的偏距（左侧为正）", f"the offset of ${joint.pin}$ from its guide (positive to the left)")
            yield Length(words=words, link=joint.guide, value=joint.offset, signed=True, change=partial(_offset, mech, i, joint))


def _moved(mech: Mechanism, letter: str, axis: str, value: float) -> Mechanism:
    place = mech.frame[letter]
    moved = complex(value, place.imag) if axis == "x" else complex(place.real, value)
    return replace(mech, frame={**mech.frame, letter: moved}, joints=_guides(mech, "0", {letter: moved - place}))


def _offset(mech: Mechanism, i: int, joint: Prismatic, value: float) -> Mechanism:
    return replace(mech, joints=(*mech.joints[:i], replace(joint, offset=value), *mech.joints[i + 1 :]))


def _bar(mech: Mechanism, link: Link, first: str, second: str, value: float) -> Mechanism:
    start, end = link.points[first], link.points[second]
    return _with(mech, link, {first: start, second: start + value * (end - start) / abs(end - start)}, link.placements)


def _replaced(mech: Mechanism, link: Link, i: int, put: Callable[[float], Placement], value: float) -> Mechanism:
    placed = {placement.point for placement in link.placements}
    bases = {letter: place for letter, place in link.points.items() if letter not in placed}
    return _with(mech, link, bases, (*link.placements[:i], put(value), *link.placements[i + 1 :]))


def _with(mech: Mechanism, link: Link, points: Points, placements: tuple[Placement, ...]) -> Mechanism:
    """The mechanism with this link's first points and placements; the placed points follow, guides through its letters too."""
    for old, new in zip(link.placements, placements, strict=True):
        start, unit = points[new.base[0]], _ray(link, old, points)
        points[new.point] = start + unit * _local(new, points)
    points = {letter: points[letter] for letter in link.points}
    changed = replace(link, points=points, placements=placements)
    moves = {letter: place - link.points[letter] for letter, place in points.items()}
    return replace(mech, links=tuple(changed if other is link else other for other in mech.links), joints=_guides(mech, link.name, moves))


def _ray(link: Link, placement: Placement, points: Mapping[str, complex]) -> complex:
    """Direction of the base's ray; of a single letter (the guide's direction) it is what it was."""
    if len(placement.base) == 2:
        ray = points[placement.base[1]] - points[placement.base[0]]
    else:
        ray = (link.points[placement.point] - link.points[placement.base[0]]) / _local(placement, link.points)
    return ray / abs(ray)


def _local(placement: Placement, points: Mapping[str, complex]) -> complex:
    """The placed point as seen along the base's ray; NaN where its triangle does not close."""
    match placement:
        case ByAngle():
            return cmath.rect(placement.distance, placement.angle)
        case ByOffsets():
            return complex(placement.along, placement.left)
        case ByLengths(lengths=(p, q)):
            c = abs(points[placement.base[1]] - points[placement.base[0]])
            x = (p * p - q * q + c * c) / (2 * c)
            square = p * p - x * x
            return complex(x, (square**0.5 if square >= 0 else float("nan")) * (1 if placement.side is Side.LEFT else -1))


def _guides(mech: Mechanism, link: str, moves: Mapping[str, complex]) -> tuple[Joint, ...]:
    return tuple(
        replace(joint, origin=joint.origin + moves.get(joint.through, 0j))
        if isinstance(joint, Prismatic) and joint.guide == link and joint.through else joint
        for joint in mech.joints
    )


def other_assemblies(mech: Mechanism) -> Iterator[tuple[Words, Mechanism]]:
    """The mechanism in every other assembly that one wrong side gives: a branch statement, or a placed point mirrored."""
    for i, branch in enumerate(mech.branches):
        other = opposite(branch)
        yield _told(other), replace(mech, branches=(*mech.branches[:i], other, *mech.branches[i + 1 :]))
    if len(mech.branches) > 1:
        words = Words("全部装配分支都取另一侧", "every assembly taken on its other side")
        yield words, replace(mech, branches=tuple(opposite(branch) for branch in mech.branches))
    for link in mech.links:
        for i, placement in enumerate(link.placements):
            if (mirrored := _mirrored(placement)) is not None:
                p, base = placement.point, "".join(placement.base)
                words = Words(f"${p}$ 取在 ${base}$ 的另一侧", f"${p}$ taken on the other side of ${base}$")
                yield words, _replaced(mech, link, i, lambda _, to=mirrored: to, 0.0)  # type: ignore[misc]


def _mirrored(placement: Placement) -> Placement | None:
    match placement:
        case ByAngle():
            return replace(placement, angle=-placement.angle)
        case ByOffsets():
            return replace(placement, left=-placement.left) if placement.left else None
        case ByLengths():
            return replace(placement, side=_OTHER[placement.side])


def _told(branch: Statement) -> Words:
    match branch:
        case SideOf(point=point, side=side):
            ref, of = "".join(branch.ref), "of " if side in (Side.LEFT, Side.RIGHT) else ""
            return Words(f"装配分支取 ${point}$ 在 ${ref}$ {_SIDE[side]}", f"assembled with ${point}$ {side.value} {of}${ref}$")
        case Shaped(form=form):
            corners = "".join(branch.corners)
            return Words(f"装配分支取 ${corners}$ 为{form.words.zh}", f"assembled with ${corners}$ as {form.words.en}")
        case _:
            assert_never(branch)
