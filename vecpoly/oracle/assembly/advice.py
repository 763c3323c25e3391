"""What a lecturer may say to tell two assemblies apart: 'C left of BD'."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from itertools import product

from ...mechanism.assembly.branch import margin, opposite
from ...mechanism.model import Circle, Mechanism, Revolute, Rolling, Side, SideOf
from ...words import Words
from ..closed.dyads import Hinged
from ..iterated.newton import Newton
from ..steps import Step

Places = dict[str, complex]


def is_hinged(step: Step) -> bool:
    """Whether the two assemblies differ in the place of a hinge, whose letter is the step's joint."""
    return isinstance(step, Hinged) or (isinstance(step, Newton) and step.two)


def advice(mech: Mechanism, step: Step, before: Places, after: list[Places]) -> Words:
    """; say which: 'C left of BD' or 'C right of BD'."""
    if len(after) < 2 or not is_hinged(step):
        return Words.same("")
    for statement in _statements(mech, step, before, after[0]):
        here, there = (margin(statement, at) for at in after)
        if min(abs(here), abs(there)) > 1e-6 * mech.scale and here * there < 0:
            return Words(
                f"；请指明“{statement}”或“{opposite(statement)}”",
                f"; say which: '{statement}' or '{opposite(statement)}'",
            )
    return Words(
        f"；没有字母点能区分两者，请以 guesses: {{{step.joint}: [x mm, y mm]}} 给出大致位置",
        f"; no lettered point tells them apart: give a rough place, guesses: {{{step.joint}: [x mm, y mm]}}",
    )


def _statements(mech: Mechanism, step: Step, before: Places, after: Mapping[str, complex]) -> Iterator[SideOf]:
    """Sentences a lecturer may say about the group, the plainest first."""
    outer = [out.joint.point for out in step.group.outer if isinstance(out.joint, Revolute)]
    gears = [
        end.centre
        for out in step.group.outer
        if isinstance(out.joint, Rolling)
        for end in (out.joint.gear, out.joint.on)
        if isinstance(end, Circle) and end.link == out.parent
    ]
    points = [step.joint, *(p for p in after if p not in before and p != step.joint)]
    refs = [p for p in (*outer, *gears) if p in before]
    others = [p for p in before if p not in refs]
    apart = 1e-9 * mech.scale
    pairs = [(a, b) for a, b in product((*refs, *others), repeat=2) if abs(before[a] - before[b]) > apart]
    for point in points:
        if len(refs) == 2:
            yield SideOf(point=point, side=Side.LEFT, ref=(refs[0], refs[1]))
        for ref, side in product((*refs, *others), (Side.LEFT, Side.ABOVE)):
            yield SideOf(point=point, side=side, ref=(ref,))
        for pair in pairs:
            yield SideOf(point=point, side=Side.LEFT, ref=pair)
