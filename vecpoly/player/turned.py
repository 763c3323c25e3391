"""The same problem with its drive at other places, all through the cycle:
it stays assembled as it was, and keeps its scales where they will do."""

from __future__ import annotations

from dataclasses import dataclass
from math import degrees, pi

import numpy as np
from numpy.typing import NDArray

from .. import oracle
from ..board.construction import Construction
from ..cycle.pose import posed
from ..errors import VecpolyError
from ..foundation.slotted import replace
from ..mechanism.model import Mechanism
from ..methods.desk import Desk
from ..methods.plan import sketched
from ..problem.problem import Problem, Scales
from ..solution import Solution, scales_of, solve
from .fitting import fitted
from .inverted import Turned, inverted

Places = NDArray[np.float64]
TRAVEL = 4.0  # sizes of the mechanism to each side that a sliding drive is tried in
PASSED = 2  # steps from place to place over which a drive still goes round: a dead point between them is passed
TRIALS = 721  # places tried of a sliding drive


@dataclass(frozen=True, slots=True)
class Cycle:
    """The places that can be drawn, in the sense in which the drive moves; which is the given one; whether none is
    missing; whether it goes round; whether the follower of a standing cam goes round instead of a drive."""

    turns: tuple[Turned, ...]
    start: int = 0
    whole: bool = False
    round: bool = False
    inverts: bool = False

    def thinned(self) -> Cycle:
        """Every second place, the given one among them; one place alone is no cycle."""
        kept = self.turns[self.start % 2 :: 2]
        return replace(self, turns=kept if len(kept) > 1 else (), start=self.start // 2)


def cycle(solution: Solution, count: int, *, seed: int = 0) -> Cycle:
    """The solution at `count` places of the drive over a full turn (or its travel); of a cam that is designed the
    stations of its inversion; nothing for another device."""
    problem = solution.problem
    if not isinstance(problem.subject, Mechanism) or count < 2:
        return Cycle(()) if count < 2 else Cycle(inverted(solution), 0, True, True, inverts=True)
    mech, hand, tones = problem.subject, solution.construction.hand, solution.construction.tones
    fixed = replace(problem, scales=scales_of(solution.construction))
    places = _places(mech, count)
    sketches: dict[int, _Sketched] = {}
    for number, moved in enumerate(posed(fixed, places)):
        if moved is None:
            continue
        try:
            sketches[number] = _Sketched(moved, *sketched(moved))
        except VecpolyError:
            continue  # a dead point, or a load that cannot act as it is said to there: no drawing of this place
    order, _ = (sorted(sketches), False) if mech.drive.slide else in_order(sorted(sketches), count)
    fits = fitted([sketches[number].construction for number in order], _given(order, places, mech.drive.position))
    found = {
        number: Turned(_shown(problem, float(places[number]) - mech.drive.position), drawn.toned(tones))
        for number, scales in zip(order, fits, strict=True)
        if (drawn := _drawn(sketches[number], scales, hand, seed)) is not None
    }
    order, goes_round = (sorted(found), False) if mech.drive.slide else in_order(sorted(found), count)
    own = _given(order, places, mech.drive.position)
    return Cycle(
        tuple(found[number] for number in order), own, len(order) == count and not mech.drive.slide, goes_round
    )


@dataclass(frozen=True, slots=True)
class _Sketched:
    """The problem with the drive at another place, drawn once by an exact hand:
    its polygons tell the scales, its readings are the ideal ones."""

    problem: Problem
    desk: Desk
    construction: Construction


def _drawn(sketch: _Sketched, scales: Scales, hand: str, seed: int) -> Solution | None:
    """The place drawn at these scales; at its own where what is small there is too small to be drawn so:
    it leaves its pane."""
    for tried in (scales, sketch.problem.scales):
        try:
            return solve(
                replace(sketch.problem, scales=tried), by=hand, seed=seed, repeats=0, precise=False, sketch=sketch.desk
            )
        except VecpolyError:
            continue
    return None


def in_order(numbers: list[int], count: int) -> tuple[list[int], bool]:
    """The places of a turn in the order in which they are run through, and whether it can go round.

    One that cannot begins after its widest gap, so that what hangs together is run through in one go.
    """
    gaps = [
        (after - before) % count or count for before, after in zip([*numbers[-1:], *numbers], numbers, strict=False)
    ]
    widest = max(gaps, default=count)
    if widest <= PASSED:
        return numbers, True
    first = gaps.index(widest) if gaps else 0
    return numbers[first:] + numbers[:first], False


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
    return np.sort(np.append(np.linspace(tried[low], tried[high], count - 1), drive.position))[
        :: 1 if sense > 0 else -1
    ]


def _along(mech: Mechanism, places: Places) -> Places:
    """A number for each place where everything can be assembled, NaN elsewhere."""
    motion = oracle.solve(mech, places, order=0, strict=False)
    return np.asarray(
        sum(np.real(motion.origin(link.name)) + np.real(motion.angle(link.name)) for link in mech.links),
        dtype=np.float64,
    )


def _shown(problem: Problem, by: float) -> str:
    """What the datum of the drive reads when it has moved on by this much (rad, or m)."""
    datum = problem.given.motion[0]
    if problem.mechanism.drive.slide:
        return f"{1e3 * (datum.si + by):.4g} mm".replace("-", "−")
    turn = round(degrees(datum.si + by) % 360.0, 2) % 360.0
    return f"{turn:g}°"
