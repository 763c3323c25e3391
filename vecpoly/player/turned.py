"""The same problem with its drive at other places, all through the cycle: the scales stay, and so does the way it was assembled."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace
from math import degrees, pi

import numpy as np
from numpy.typing import NDArray

from .. import oracle
from ..board.construction import Construction, View
from ..errors import VecpolyError
from ..mechanism.branch import margin
from ..mechanism.model import Mechanism, Side, SideOf
from ..problem.problem import Problem, Scales
from ..solution import Solution, solve

Places = NDArray[np.float64]
_OPPOSITE = {Side.LEFT: Side.RIGHT, Side.RIGHT: Side.LEFT, Side.ABOVE: Side.BELOW, Side.BELOW: Side.ABOVE}
TRAVEL = 4.0  # sizes of the mechanism to each side that a sliding drive is tried in
TRIALS = 721  # places tried of a sliding drive


@dataclass(frozen=True, slots=True)
class Turned:
    """The solution with the drive at another place, and what the drive's datum reads there: 75°, 120 mm."""

    shown: str
    solution: Solution


@dataclass(frozen=True, slots=True)
class Cycle:
    """The places that can be drawn, in the sense in which the drive moves; which of them is the given one; whether none is missing."""

    turns: tuple[Turned, ...]
    start: int = 0
    whole: bool = False


def cycle(solution: Solution, count: int, *, seed: int = 0) -> Cycle:
    """The solution at `count` places of the drive over a full turn (or its travel); nothing for a device."""
    problem = solution.problem
    if not isinstance(problem.subject, Mechanism) or count < 2:
        return Cycle(())
    mech, hand = problem.subject, solution.construction.hand
    fixed = replace(problem, scales=_scales(solution.construction))
    found: dict[int, Turned] = {}
    for number, place, branches in _assembled(mech, _places(mech, count)):
        drive = replace(mech.drive, position=place)
        moved = replace(fixed, subject=replace(mech, drives=(drive,), branches=branches))
        try:
            found[number] = Turned(_shown(problem, place - mech.drive.position), solve(moved, by=hand, seed=seed, repeats=0))
        except VecpolyError:
            continue  # a dead point, or a load that cannot act as it is said to there: no drawing of this place
    order = sorted(found) if mech.drive.slide else _unbroken(sorted(found), count)
    own = _given(order, _places(mech, count), mech.drive.position)
    return Cycle(tuple(found[number] for number in order), own, len(order) == count and not mech.drive.slide)


def _unbroken(numbers: list[int], count: int) -> list[int]:
    """The numbers round the turn, beginning after the widest gap, so that what hangs together is run through in one go."""
    gaps = [(after - before) % count for before, after in zip([*numbers[-1:], *numbers], numbers, strict=False)]
    first = gaps.index(max(gaps)) if len(numbers) < count else 0
    return numbers[first:] + numbers[:first]


def _given(order: list[int], places: Places, own: float) -> int:
    """Where in the order the given place stands."""
    return min(range(len(order)), key=lambda i: abs(float(places[order[i]]) - own), default=0)


def _places(mech: Mechanism, count: int) -> Places:
    """Places of the drive from its own one on: a full turn, or the whole travel to both sides."""
    drive = mech.drive
    sense = -1.0 if drive.rate < 0 else 1.0
    if not drive.slide:
        return drive.position + sense * 2 * pi * np.arange(count) / count
    tried = drive.position + TRAVEL * mech.scale * np.linspace(-1.0, 1.0, TRIALS)
    good = np.isfinite(_along(mech, tried))
    own = TRIALS // 2
    low = own - int(np.argmin(good[own::-1])) + 1 if not good[: own + 1].all() else 0
    high = own + int(np.argmin(good[own:])) - 1 if not good[own:].all() else TRIALS - 1
    return np.sort(np.append(np.linspace(tried[low], tried[high], count - 1), drive.position))[:: 1 if sense > 0 else -1]


def _along(mech: Mechanism, places: Places) -> Places:
    """A number for each place where everything can be assembled, NaN elsewhere."""
    motion = oracle.solve(mech, places, order=0, strict=False)
    return np.asarray(sum(np.real(motion.origin(link.name)) + np.real(motion.angle(link.name)) for link in mech.links), dtype=np.float64)


def _assembled(mech: Mechanism, places: Places) -> Iterator[tuple[int, float, tuple[SideOf, ...]]]:
    """The places where it can be assembled, with the statements that describe the given assembly there: 'above' may have become 'below'."""
    motion = oracle.solve(mech, places, order=0, strict=False)
    letters = {letter for s in mech.branches for letter in (s.point, *s.ref)}
    at = {letter: np.broadcast_to(motion.position(letter), places.shape) for letter in letters}
    for i in np.flatnonzero(np.isfinite(_along(mech, places))):
        here = {letter: complex(values[i]) for letter, values in at.items()}
        yield int(i), float(places[i]), tuple(s if margin(s, here) >= 0 else replace(s, side=_OPPOSITE[s.side]) for s in mech.branches)


def _scales(construction: Construction) -> Scales:
    """The scales of the given place; those of levers are their own."""
    used = {f.view: f.scale.value for f in reversed(construction.figures) if not f.name.startswith("lever")}
    return Scales(mu_l=used.get(View.MECHANISM), mu_v=used.get(View.VELOCITY), mu_a=used.get(View.ACCELERATION), mu_f=used.get(View.FORCE))


def _shown(problem: Problem, by: float) -> str:
    """What the datum of the drive reads when it has moved on by this much (rad, or m)."""
    datum = problem.given.motion[0]
    if problem.mechanism.drive.slide:
        return f"{1e3 * (datum.si + by):.4g} mm".replace("-", "−")
    turn = round(degrees(datum.si + by) % 360.0, 2) % 360.0
    return f"{turn:g}°"
