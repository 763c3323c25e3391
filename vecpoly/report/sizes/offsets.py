"""On the sketch of a mechanism: the offset e of a guide that passes beside its pin, the angle of a bar to its guide."""

from __future__ import annotations

import cmath
from collections.abc import Iterator, Mapping
from math import isclose, pi, remainder

from ...board.construction import Figure
from ...board.paper.marks import Mark, Point
from ...cycle.sample import sample
from ...mechanism.model import FRAME, Mechanism, Prismatic
from ...mechanism.offsets import offset_symbol
from ...problem.problem import Problem
from ...problem.values.seen import OffItsGuide
from .lines import angle, span
from .set_off import in_degrees

_BESIDE, _AWAY = 8.0, 15.0  # mm: from the pin to its dimension; from the block to the arc of an angle
_NEAR = 1e-9  # m
_CLOSE = 0.02  # rad
_FLAT = 1e-9  # rad


def mechanism(problem: Problem, figure: Figure) -> Iterator[Mark]:
    """What is given of guides, at the places of the sketch."""
    mech, spots = problem.mechanism, {m.label: m.at for m in figure.marks if isinstance(m, Point) and m.label}
    slides = [j for j in mech.joints if isinstance(j, Prismatic) and not j.pin_in_slot]
    guides = [j for j in slides if j.guide != FRAME]
    for joint in slides:
        if joint.guide == FRAME and joint.aside and joint.pin in spots:
            along = cmath.rect(1.0, joint.direction)
            symbol = offset_symbol(mech, joint)
            yield from _from_pin(symbol, spots[joint.pin], along, joint.offset / figure.scale.value, -along)
    if not guides:
        return
    motion = sample(mech, None, mech.drive.position).motion
    turns = {joint: float(motion.angle(joint.guide)) + joint.direction for joint in guides}
    for joint in guides:
        if joint.aside:
            yield from _offset(mech, joint, cmath.rect(1.0, turns[joint]), spots, figure.scale.value)
    for datum in problem.given.data:
        if isinstance(told := datum.seen, OffItsGuide) and {told.at, told.end} <= set(spots) and _opens(told.turn):
            way = next((turn for joint, turn in turns.items() if told.link in (joint.block, joint.guide)), None)
            if way is not None:
                yield from _to_guide(spots[told.at], spots[told.end], way, told.turn)


def _offset(
    mech: Mechanism, joint: Prismatic, along: complex, spots: Mapping[str, complex], mm: float
) -> Iterator[Mark]:
    """Square to the guide, from its pivot where the block's pin lies on it, else from that pin."""
    pivot = next((p for p in mech.link(joint.guide).points if p in spots and p != joint.pin), "")
    if not pivot or joint.pin not in spots:
        return
    symbol, ray = offset_symbol(mech, joint), spots[joint.pin] - spots[pivot]
    if joint.offset:
        away = along if (along.conjugate() * ray).real > 0 else -along
        yield from _from_pin(symbol, spots[joint.pin], along, joint.offset / mm, away)
        return
    foot = spots[pivot] + 1j * along * (along.conjugate() * ray).imag
    ahead = along if (along.conjugate() * ray).real > 0 else -along
    yield from span(spots[pivot], foot, symbol, _BESIDE * ahead)


def _from_pin(symbol: str, pin: complex, along: complex, off: float, away: complex) -> Iterator[Mark]:
    """e from a pin, so far to the left of its guide, to the guide."""
    yield from span(pin, pin - 1j * along * off, symbol, _BESIDE * away)


def _opens(turn: float) -> bool:
    """Whether there is an angle to mark: a bar in the direction of its guide, or opposite to it, has none."""
    return abs(remainder(turn, pi)) > _FLAT


def _to_guide(at: complex, end: complex, turn: float, given: float) -> Iterator[Mark]:
    """The angle between the guide and a bar from its block, from that side of the guide from which it is so large."""
    way = cmath.phase(end - at)
    for start in (turn, turn + pi):
        sweep = cmath.phase(cmath.rect(1.0, way - start))
        if isclose(abs(sweep), abs(given), abs_tol=_CLOSE):
            yield from angle(at, sweep, in_degrees(given), _AWAY, start)
            return
