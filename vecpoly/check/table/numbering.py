"""A table may number the links otherwise than the problem:
its links in order are matched to those whose angles they have."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import combinations

import numpy as np

from ...mechanism.model import Mechanism
from ...oracle import Motion
from ...oracle.run import wrapped
from .target import Reals, Target

NEAR = 0.25  # rad, or relative: how far the median row may be off where a link is another's number

Values = tuple[Target, Reals]


def renumbered(columns: Sequence[Values], mech: Mechanism, motion: Motion) -> dict[str, str]:
    """The table's link number → the problem's; empty where all its numbers exist, or where no assignment fits."""
    numbers = sorted(
        {target.of_link for target, _ in columns if target.of_link},
        key=lambda name: (int("".join(filter(str.isdigit, name))), name),
    )
    fixed = {drive.link for drive in mech.drives}
    numbers = [number for number in numbers if number not in fixed]
    links = [link for link in mech.numbered if link not in fixed]
    if set(numbers) <= set(links) or len(numbers) > len(links):
        return {}
    ways = [dict(zip(numbers, chosen, strict=True)) for chosen in combinations(links, len(numbers))]
    best = min(ways, key=lambda way: sum(_misfits(columns, way, motion).values()))
    misfits = _misfits(columns, best, motion)
    if any(misfits.get(number, np.inf) > NEAR for number, link in best.items() if number != link):
        return {}
    return {number: link for number, link in best.items() if number != link}


def _misfits(columns: Sequence[Values], way: dict[str, str], motion: Motion) -> dict[str, float]:
    """By the table's link number: how far its angle is off in the median row;
    its ω, relatively, where it has no angle."""
    found: dict[str, float] = {}
    for target, values in sorted(columns, key=lambda column: not column[0].is_angle):
        number = target.of_link
        if number not in way or number in found or not (target.is_angle or target.key.startswith("omega")):
            continue
        exact = target.on(way[number]).of(motion)
        if target.is_angle:
            off = wrapped(values - exact)
            found[number] = float(min(np.nanmedian(np.abs(off)), np.nanmedian(np.abs(wrapped(off + np.pi)))))
        else:
            found[number] = float(np.nanmedian(np.abs(values - exact)) / max(float(np.nanmax(np.abs(exact))), 1e-300))
    return found
