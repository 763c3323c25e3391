"""What a cycle shows: which links turn and which rock, strokes and quick return,
transmission angles, dead points, peaks."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from ... import oracle
from ...foundation.slotted import replace
from ...mechanism.groups.assur import hinges
from ...mechanism.model import FRAME
from ..columns import dyads, slides
from ..cycle import Cycle
from ..extremes import Extremes, Spot, extremes
from .closing import laps_of, turns_of
from .rests import Stretch, rest
from .transmission import folded, is_told
from .transmission_range import Transmission, transmission_of

MEETING = 1e-5  # rad: a folded dyad


@dataclass(frozen=True, slots=True)
class Stroke:
    """An output that goes to and fro once a turn: its limit positions, and how long it takes there and back.

    K = (180° + θ) / (180° - θ), the ratio of the drive's angles of the slow and the quick stroke. forth: the drive's
    angle (rad) from the lower to the upper limit, back:
    from the upper to the lower, both in the sense in which the drive turns. rests: stretches of the drive in which it
    stands at the lower and at the upper limit, where it does; they belong to neither stroke.
    """

    key: str
    lower: Spot
    upper: Spot
    forth: float
    back: float
    rests: tuple[Stretch | None, Stretch | None] = (None, None)

    @property
    def swing(self) -> float:
        """Upper less lower limit (rad or m)."""
        return self.upper.value - self.lower.value

    @property
    def ratio(self) -> float:
        """K, never below 1."""
        return max(self.forth, self.back) / min(self.forth, self.back)

    @property
    def theta(self) -> float:
        """θ = 180° (K - 1) / (K + 1) in rad."""
        return float(np.pi * (self.ratio - 1) / (self.ratio + 1))


@dataclass(frozen=True, slots=True)
class Peak:
    """A largest |α| far above its usual size (rms), and what stands beside it:
    a nearly folded dyad, a short arm of a slotted link."""

    key: str
    spot: Spot
    rms: float
    beside: str = ""  # key: gamma_23 or d_45
    at: Spot | None = None


@dataclass(frozen=True, slots=True)
class Facts:
    """The facts of one cycle. turns: net turns of each link in one turn of the drive (0:
    it rocks); None of no whole cycle.

    laps: turns of the drive after which everything stands as it did, 1 as a rule, None where unknown. unlimited:
    whether a sliding drive can move on beyond its low, its high end, which then are merely as far as was looked.
    """

    ranges: tuple[str, ...]
    whole: bool
    turns: dict[str, float] | None
    laps: int | None
    unlimited: tuple[bool, bool]
    swings: tuple[Extremes, ...]  # of every rocker and slider on the frame: its limit positions, each to and fro
    strokes: tuple[Stroke, ...]
    transmissions: tuple[Transmission, ...]
    arms: tuple[Extremes, ...]
    dead: tuple[Spot, ...]  # of the drive itself: the ends of its range
    # change points of a drive that turns right round: key of γ, where a dyad lies in one line
    changes: tuple[tuple[str, tuple[Spot, ...]], ...]
    peaks: tuple[Peak, ...]


def facts(cycle: Cycle) -> Facts:
    """Everything at once, each to full accuracy."""
    even = cycle.once.steady
    outputs = tuple(extremes(even, key) for key in outputs_of(even))
    told = tuple(
        t
        for name, dyad in dyads(even.mech).items()
        if is_told(even.mech, dyad)
        if (t := transmission_of(even, name, dyad.kind))
    )
    arms = tuple(extremes(even, f"d_{name}") for name, dyad in dyads(even.mech).items() if dyad.kind == "RPR")
    unlimited = _unlimited(even)
    dead = (
        ()
        if even.whole
        else tuple(Spot(q, 0.0, True) for q, free in zip((even.low, even.high), unlimited, strict=True) if not free)
    )
    changes = tuple(_changes(even))
    strokes = () if changes else tuple(s for e in outputs if (s := _stroke(even, e)))
    return Facts(
        even.ranges,
        even.whole,
        turns_of(even),
        laps_of(even),
        unlimited,
        tuple(e for e in outputs if e.maxima),
        strokes,
        told,
        arms,
        dead,
        changes,
        tuple(p for name in even.mech.numbered if (p := _peak(even, name, told, arms))),
    )


def _changes(cycle: Cycle) -> Iterator[tuple[str, tuple[Spot, ...]]]:
    """Where two assemblies of a dyad meet though the drive goes on: which of them follows is not determined there."""
    for name, dyad in dyads(cycle.mech).items() if cycle.whole else ():
        if not is_told(cycle.mech, dyad) or dyad.kind == "RPR":
            continue
        found = extremes(cycle, f"gamma_{name}")
        spots = [s for s in (*found.maxima, *found.minima, *found.zeros) if float(folded(np.array(s.value))) < MEETING]
        if spots:
            apart = sorted(spots, key=lambda s: s.phi)
            yield found.key, tuple(s for i, s in enumerate(apart) if not i or s.phi - apart[i - 1].phi > 1e-4)


def _unlimited(cycle: Cycle) -> tuple[bool, bool]:
    """Whether a sliding drive's range ends only where the search for its ends does."""
    drive, reach = cycle.mech.drive, oracle.SEARCHED * cycle.mech.scale
    near = 1e-9 * cycle.mech.scale
    return (
        drive.slide and cycle.low <= drive.position - reach + near,
        drive.slide and cycle.high >= drive.position + reach - near,
    )


def outputs_of(cycle: Cycle) -> tuple[str, ...]:
    """Keys of the links that are pinned to, or slide on, the frame, without the drive:
    φ of the rockers, s of the sliders."""
    mech, turns = cycle.mech, turns_of(cycle) or {}
    pinned = {name for names in hinges(mech).values() if FRAME in names for name in names}
    rockers = [
        f"phi_{name}" for name in mech.numbered if name in pinned and name != mech.drive.link and not turns.get(name, 0)
    ]
    frame = mech.frame_number
    sliders = [
        f"s_{pair}"
        for pair, joint in slides(mech).items()
        if FRAME in (joint.guide, joint.block) and pair.removesuffix(frame).removeprefix(frame) != mech.drive.link
    ]
    return (*rockers, *sliders)


def _stroke(cycle: Cycle, found: Extremes) -> Stroke | None:
    if not cycle.whole or len(found.maxima) != 1 or len(found.minima) != 1 or not _closes(cycle, found.key):
        return None
    lower, upper = found.minima[0], found.maxima[0]
    forth = (upper.phi - lower.phi) % (2 * np.pi)
    forth = forth if cycle.mech.drive.rate > 0 else 2 * np.pi - forth
    low, high = (rest(cycle, found.key, spot, upper.value - lower.value) for spot in (lower, upper))
    stroke = Stroke(found.key, lower, upper, forth, 2 * np.pi - forth, (low, high))
    return _rested(cycle, stroke) if any(stroke.rests) else stroke


def _rested(cycle: Cycle, stroke: Stroke) -> Stroke:
    """The strokes without the rests between them."""
    low, high = stroke.rests
    from_low, to_low = (low[1], low[0]) if low else (stroke.lower.phi, stroke.lower.phi)
    from_high, to_high = (high[1], high[0]) if high else (stroke.upper.phi, stroke.upper.phi)
    up, down = (to_high - from_low) % (2 * np.pi), (to_low - from_high) % (2 * np.pi)
    if cycle.mech.drive.rate < 0:  # it goes through each stretch from its end
        up, down = down, up
    return replace(stroke, forth=up, back=down)


def _closes(cycle: Cycle, key: str) -> bool:
    """Whether the column comes back to its value after a turn."""
    first, last = np.asarray(cycle.at(key, np.array([cycle.low, cycle.high])), np.float64)
    return bool(abs(last - first) < 1e-6 * (cycle.mech.scale if cycle.info(key).unit == "m" else 1.0))


def _peak(cycle: Cycle, name: str, told: tuple[Transmission, ...], arms: tuple[Extremes, ...]) -> Peak | None:
    """|α| above 2.5 times its rms,
    within 20° of a dyad's least angle below 40° or of an arm shorter than a third of its longest."""
    key = f"alpha_{name}"
    phi, alpha = cycle.on_grid(key)
    known = np.isfinite(alpha)
    phi, square = phi[known], np.abs(alpha[known]) ** 2
    rms = float(np.sqrt((square[1:] + square[:-1]) @ np.diff(phi) / 2 / np.ptp(phi))) if known.sum() > 1 else 0.0
    found = extremes(cycle, key)
    if found.highest is None or found.lowest is None or found.is_constant:
        return None
    top = max(found.highest, found.lowest, key=lambda s: abs(s.value))
    if abs(top.value) < 2.5 * rms or not np.isfinite(top.value):
        return None
    near = [(t.key, t.least) for t in told if t.is_poor]
    near += [(a.key, a.lowest) for a in arms if a.lowest and a.highest and a.lowest.value < a.highest.value / 3]
    beside = min(
        ((_apart(cycle, top, spot), which, spot) for which, spot in near), default=None, key=lambda item: item[0]
    )
    if beside is None or beside[0] > np.radians(20.0):
        return Peak(key, top, rms)
    return Peak(key, top, rms, beside[1], beside[2])


def _apart(cycle: Cycle, one: Spot, other: Spot) -> float:
    gap = abs(one.phi - other.phi)
    return min(gap, 2 * np.pi - gap) if cycle.whole else gap
