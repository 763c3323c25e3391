"""The mechanism as thin lines: each link through its points, each moving guide from its pivot to the pin of its block,
along its own line where that passes beside them; its blocks."""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from ..cycle import Cycle
from ..cycle.sample import sample
from ..mechanism.model import FRAME, Prismatic

Points = NDArray[np.complex128]
_BESIDE = 1e-9  # m: a line that is nearer passes through a point


class BlockAt(NamedTuple):
    """The middle of a block (mm), and the direction in which it slides, of length 1."""

    at: complex
    along: complex


def skeleton(cycle: Cycle, phi: NDArray[np.float64]) -> list[Points]:
    """For every line of the mechanism its points at these positions of the drive (mm): shape (points, positions)."""
    mech = cycle.mech
    found = []
    for letters in (list(mech.link(name).points) for name in mech.bodies):
        if len(set(letters)) > 1:
            places = np.array([_place(cycle, letter, phi) for letter in letters])
            found.append(np.vstack([places, places[:1]]) if len(letters) > 2 else places)
    for joint in mech.joints:
        if isinstance(joint, Prismatic) and FRAME not in (joint.guide, joint.block) and joint.pin:
            line = _guide(cycle, joint, phi)
            found += [line] if len(line) > 1 else []
    return found


def blocks(cycle: Cycle, phi: float) -> Iterator[BlockAt]:
    """The blocks at one position of the drive, those that swing about a pivot among them; a pin in a slot has none."""
    for joint in cycle.mech.joints:
        if isinstance(joint, Prismatic) and joint.pin and not joint.pin_in_slot:
            where = np.array([phi])
            along = complex(_along(cycle, joint, where)[0])
            at = complex(_place(cycle, joint.pin, where)[0]) - 1e3j * along * joint.offset
            if np.isfinite(at):
                yield BlockAt(at, along)


def _place(cycle: Cycle, letter: str, phi: NDArray[np.float64]) -> Points:
    return 1e3 * np.asarray(cycle.at(f"p_{letter}", phi), np.complex128)


def _along(cycle: Cycle, joint: Prismatic, phi: NDArray[np.float64]) -> Points:
    """The direction of a guide's line."""
    turned = 0.0 if joint.guide == FRAME else np.asarray(_turned(cycle, joint.guide, phi))
    return np.asarray(np.exp(1j * (turned + joint.direction)) * np.ones(len(phi)), np.complex128)


def _turned(cycle: Cycle, link: str, phi: NDArray[np.float64]) -> NDArray[np.float64]:
    return np.asarray(sample(cycle.mech, None, phi).motion.angle(link), np.float64)


def _guide(cycle: Cycle, joint: Prismatic, phi: NDArray[np.float64]) -> Points:
    """From the first point of the guide to the pin; where its line passes beside these, along it from foot to foot."""
    own = cycle.mech.link(joint.guide).points
    first = next(iter(own), "")
    if not first:
        return np.zeros((0, len(phi)), np.complex128)
    if first == joint.pin:
        return np.array([_place(cycle, first, phi)])
    start, end = _place(cycle, first, phi), _place(cycle, joint.pin, phi)
    beside = ((own[first] - joint.origin) * np.exp(-1j * joint.direction)).imag
    across = 1e3j * _along(cycle, joint, phi)
    feet = [start - beside * across] if abs(beside) > _BESIDE else []
    return np.array([start, *feet, end - joint.offset * across])
