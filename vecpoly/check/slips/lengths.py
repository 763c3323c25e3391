"""The lengths of a mechanism, each by name, with its value, and the mechanism with another in its place."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import assert_never

from ...foundation.slotted import replace
from ...mechanism.assembly.branch import opposite
from ...mechanism.dimensions.set_out import firm, set_out
from ...mechanism.dimensions.values import Bar, Coordinate, Dimension, Led, Part, Placed
from ...mechanism.dimensions.vary import value, varied
from ...mechanism.model import (
    FRAME,
    ByAngle,
    ByLengths,
    ByOffsets,
    Mechanism,
    Placement,
    Prismatic,
    Shaped,
    Side,
    SideOf,
    Statement,
)
from ...words import Words

_OTHER = {Side.LEFT: Side.RIGHT, Side.RIGHT: Side.LEFT, Side.ABOVE: Side.BELOW, Side.BELOW: Side.ABOVE}
_SIDE = {Side.LEFT: "左侧", Side.RIGHT: "右侧", Side.ABOVE: "上方", Side.BELOW: "下方"}


@dataclass(frozen=True, slots=True, kw_only=True)
class Length:
    """One length: its name, its link (FRAME for the frame), which one it is, and whether it may be negative."""

    words: Words
    link: str
    mech: Mechanism
    one: Dimension
    signed: bool = False

    @property
    def value(self) -> float:
        """What it is (m)."""
        return value(self.mech, self.one)

    def instead(self, to: float) -> Mechanism:
        """The mechanism with this value (m) for this length, all else as it was."""
        return varied(self.mech, self.one, to)


def lengths(mech: Mechanism) -> tuple[Length, ...]:
    """Every length that a table may have been computed with another value of: bars, placed points, offsets, frame."""
    return (*_of_links(mech), *_of_frame(mech), *_offsets(mech))


def _of_links(mech: Mechanism) -> Iterator[Length]:
    for link in mech.links:
        if len(firm(link)) == 2:
            yield Length(
                words=Words.same(f"$l_{{{''.join(firm(link))}}}$"), link=link.name, mech=mech, one=Bar(link=link.name)
            )
        for i, placement in enumerate(link.placements):
            for words, part in _of_placement(placement):
                one = Placed(link=link.name, places=(i,), part=part)
                yield Length(words=words, link=link.name, mech=mech, one=one, signed=isinstance(placement, ByOffsets))


def _of_placement(placement: Placement) -> Iterator[tuple[Words, Part]]:
    p, base = placement.point, "".join(placement.base)
    match placement:
        case ByAngle():
            yield Words.same(f"$l_{{{placement.base[0]}{p}}}$"), Part.DISTANCE
        case ByLengths(base=(first, second)):
            yield Words.same(f"$l_{{{first}{p}}}$"), Part.FIRST
            yield Words.same(f"$l_{{{second}{p}}}$"), Part.SECOND
        case ByOffsets():
            if placement.along:
                yield (
                    Words(
                        f"${p}$ 在 ${base}$ 上的垂足到 ${base[0]}$ 的距离",
                        f"the distance of the foot of ${p}$ on ${base}$ from ${base[0]}$",
                    ),
                    Part.ALONG,
                )
            if placement.left:
                yield (
                    Words(
                        f"${p}$ 到 ${base}$ 的距离（左侧为正）",
                        f"the distance of ${p}$ from ${base}$ (positive to the left)",
                    ),
                    Part.LEFT,
                )


def _of_frame(mech: Mechanism) -> Iterator[Length]:
    for letter in mech.frame:
        for axis in "xy":
            one = Coordinate(letter=letter, axis=axis)
            if value(mech, one):
                yield Length(words=Words.same(f"${axis}_{letter}$"), link=FRAME, mech=mech, one=one, signed=True)


def _offsets(mech: Mechanism) -> Iterator[Length]:
    for i, joint in enumerate(mech.joints):
        if isinstance(joint, Prismatic) and joint.offset:
            words = Words(
                f"${joint.pin}$ 对导路的偏距（左侧为正）",
                f"the offset of ${joint.pin}$ from its guide (positive to the left)",
            )
            yield Length(words=words, link=joint.guide, mech=mech, one=Led(joint=i, part=Part.OFFSET), signed=True)


def other_assemblies(mech: Mechanism) -> Iterator[tuple[Words, Mechanism]]:
    """The mechanism in every other assembly that one wrong side gives: another branch, or a placed point mirrored."""
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
                yield (
                    words,
                    set_out(mech, link, firm(link), (*link.placements[:i], mirrored, *link.placements[i + 1 :])),
                )


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
            return Words(
                f"装配分支取 ${point}$ 在 ${ref}$ {_SIDE[side]}", f"assembled with ${point}$ {side.value} {of}${ref}$"
            )
        case Shaped(form=form):
            corners = "".join(branch.corners)
            return Words(f"装配分支取 ${corners}$ 为{form.words.zh}", f"assembled with ${corners}$ as {form.words.en}")
        case _:
            assert_never(branch)
