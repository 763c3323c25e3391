"""Whether a mechanism is back where it began after one turn of its drive, and how far its links have turned."""

from __future__ import annotations

from fractions import Fraction
from math import lcm

import numpy as np

from ..columns import moving_points
from ..cycle import Cycle

SAME = 1e-6  # turns
INSIDE = 2.3  # rad beyond the start of a turn: no round angle
MOST = 100  # teeth: parts of a turn that a gear can be away


def turns_of(cycle: Cycle) -> dict[str, float] | None:
    """Net turns of every link in one turn of the input link, an int where it is a whole number;
    None where the drive cannot turn right round."""
    if not cycle.whole:
        return None
    ends = np.array([cycle.low, cycle.high])
    found = {name: np.asarray(cycle.at(f"phi_{name}", ends), np.float64) for name in cycle.mech.numbered}
    return {
        name: _counted(float(phi[1] - phi[0]) / (2 * np.pi)) for name, phi in found.items() if np.isfinite(phi).all()
    }


def _counted(turns: float) -> float:
    return round(turns) if abs(turns - round(turns)) < SAME else round(turns, 9)


def laps_of(cycle: Cycle) -> int | None:
    """After how many turns of the input link every link stands as it did:
    1 as a rule, more where gears have ratios that are no whole numbers.

    None where this is unknown: a drive that cannot turn right round,
    links that come back elsewhere, a ratio that is no fraction of small numbers.
    """
    turns = turns_of(cycle)
    if turns is None or not turns:
        return None
    parts = [Fraction(count).limit_denominator(MOST) for count in turns.values()]
    if any(abs(float(part) - count) > SAME for part, count in zip(parts, turns.values(), strict=True)):
        return None
    laps = lcm(*(part.denominator for part in parts))
    if laps > 1:
        return laps
    letters = moving_points(cycle.mech)
    return next((laps for laps in (1, 2) if all(_is_back(cycle, letter, laps) for letter in letters)), None)


def _is_back(cycle: Cycle, letter: str, laps: int) -> bool:
    """Whether the letter is where it was; looked at inside the turn, for at a change point two assemblies are one."""
    first, last = np.asarray(cycle.at(f"p_{letter}", cycle.low + INSIDE + np.array([0.0, 2 * np.pi * laps])))
    return bool(abs(last - first) <= SAME * cycle.mech.scale)
