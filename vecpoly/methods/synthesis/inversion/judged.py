"""Circuit, branch and order of a linkage as its positions on paper show them.

Of a Grashof chain the two joints that are not on its shortest link only rock: the sense of the angle in them tells the
circuit. The sense of the angle opposite the driver tells between which dead points it stands.
"""

from __future__ import annotations

from functools import partial
from itertools import pairwise
from math import tau
from typing import assert_never

import numpy as np

from ....designs.inversion.loops import Hinged, Loop, Sliding, chains
from ....designs.verdict import Verdict
from ....plane import nominal
from .chained import Spots, reaches
from .sheet import Sheet

DEAD = 1e-6  # sine: at a dead point either side is as good
NONE = 1e-5  # mm: a link shorter than that has no length


def judged(sheet: Sheet) -> Verdict:
    """The verdict on the whole linkage, by the first loop that fails; either link may drive where the plan says so."""
    if _shrunk(sheet):
        return Verdict.NO_LINK
    hung = {chain[-1]: chain for chain in chains(sheet.plan.loops)}
    verdicts = [(loop, _loop(sheet, loop)) for loop in sheet.plan.loops]
    wrong = next((verdict for loop, verdict in verdicts if not _harmless(verdict, loop in hung)), Verdict.VALID)
    if wrong is Verdict.VALID and not all(reaches(chain, partial(_spots, sheet)) for chain in hung.values()):
        return Verdict.BRANCH
    return wrong


def _harmless(verdict: Verdict, hung: bool) -> bool:
    """Whether a loop may be so: one that hangs on a rocker may be driven to and fro."""
    return verdict is Verdict.VALID or (hung and verdict is Verdict.ORDER)


def _shrunk(sheet: Sheet) -> bool:
    """Whether a link has no length on paper."""
    bars = ((_spots(sheet, one)[0], _spots(sheet, two)[0]) for one, two in sheet.plan.bars())
    return any(abs(two - one) < NONE for one, two in bars)


def drives(sheet: Sheet, loop: Loop) -> tuple[Verdict, Verdict | None]:
    """The verdict with the first link of a loop as the driver, and with the last one of four bars."""
    match loop:
        case Hinged():
            a, b, c, d = (_spots(sheet, letter) for letter in (loop.a, loop.b, loop.c, loop.d))
            return _four_bar(a, b, c, d), _four_bar(d, c, b, a)
        case Sliding():
            a, b, c = (_spots(sheet, letter) for letter in (loop.a, loop.b, loop.c))
            return _slider_crank(a, b, c, loop.along), None
        case _:
            assert_never(loop)


def turns_fully(sheet: Sheet, loop: Sliding) -> bool:
    """Whether the link on the frame turns fully with its slider: AB + e ≤ BC."""
    a, b, c = (_spots(sheet, letter)[0] for letter in (loop.a, loop.b, loop.c))
    return abs(b - a) + abs(((c - a) / loop.along).imag) <= abs(c - b)


def _loop(sheet: Sheet, loop: Loop) -> Verdict:
    first, last = drives(sheet, loop)
    return Verdict.VALID if sheet.plan.either and last is Verdict.VALID else first


def _spots(sheet: Sheet, letter: str) -> Spots:
    return tuple(complex(nominal(at)) for at in sheet.pins[letter])


def _four_bar(a: Spots, b: Spots, c: Spots, d: Spots) -> Verdict:
    sides = abs(b[0] - a[0]), abs(c[0] - b[0]), abs(d[0] - c[0]), abs(a[0] - d[0])
    shortest = sides.index(min(sides))
    grashof = 2 * (min(sides) + max(sides)) < sum(sides)
    corners = (d, a, b), (a, b, c), (b, c, d), (c, d, a)
    rocking = corners[(shortest + 2) % 4]  # a joint of the link opposite the shortest
    driven = [_sense(*three) for three in zip(b, c, d, strict=True)]
    circuit = [_sense(*three) for three in zip(*rocking, strict=True)] if grashof else []
    full = grashof and shortest in (0, 3)
    beyond = -1 if sides[0] + sides[3] < sides[1] + sides[2] else 1  # whether B comes through DA produced
    return _verdict(circuit, driven, [beyond * (at - a[0]) / (d[0] - a[0]) for at in b], full)


def _slider_crank(a: Spots, b: Spots, c: Spots, along: complex) -> Verdict:
    crank, rod, offset = abs(b[0] - a[0]), abs(c[0] - b[0]), abs(((c[0] - a[0]) / along).imag)
    grashof = offset < abs(rod - crank)
    ahead = [_sense(one, two, two + 1j * along) for one, two in zip(b, c, strict=True)]
    rocking = ahead if crank < rod else [_sense(two, one, one + 1j * along) for one, two in zip(a, b, strict=True)]
    full = grashof and crank < rod
    towards = 1j * along * (-1 if ((c[0] - a[0]) / along).imag < 0 else 1)
    return _verdict(rocking if grashof else [], ahead, [(at - a[0]) / towards for at in b], full)


def _verdict(circuit: list[int], driven: list[int], rays: list[complex], full: bool) -> Verdict:
    if not _alike(circuit):
        return Verdict.CIRCUIT
    if not _alike(driven):
        return Verdict.BRANCH
    return Verdict.VALID if _in_order(rays, full) else Verdict.ORDER


def _in_order(rays: list[complex], full: bool) -> bool:
    """Whether the driver comes through the positions one after another; rays: from the middle of its range."""
    angles = [float(np.angle(ray)) for ray in rays]
    steps = [two - one for one, two in pairwise(angles)]
    if full:
        return any(sum((sense * step) % tau for step in steps) < tau + 1e-9 for sense in (1, -1))
    return all(step > 0 for step in steps) or all(step < 0 for step in steps)


def _sense(one: complex, joint: complex, other: complex) -> int:
    """On which hand the angle at a joint opens; none where it is straight."""
    u, v = one - joint, other - joint
    shorter = sorted((abs(u), abs(v), abs(u - v)))[:2]  # the largest sine in the triangle: bars may be long
    across = (u.conjugate() * v).imag / (shorter[0] * shorter[1] or 1.0)
    return 0 if abs(across) < DEAD else 1 if across > 0 else -1


def _alike(senses: list[int]) -> bool:
    return not {1, -1} <= set(senses)
