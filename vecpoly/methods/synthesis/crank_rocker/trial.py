"""A found by trial: γ_min of the linkage with its A here or there, on scratch paper, until it is as wanted."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from math import pi

import numpy as np
import numpy.typing as npt

from ....designs.crank_rocker import CrankRocker
from ....designs.verdict import Verdict
from ....plane import Points, nominal
from ....words import Words
from ..draft import SHEET, Draft
from ..eta import Eta, Locus, Straight
from ..limits import judged
from .rocker import Rocker

PLACES = 1440  # of A on the arc, tried in turn
REFINED = 100  # halvings, or golden sections
GOLDEN = (5**0.5 - 1) / 2
Tried = npt.NDArray[np.float64]
Angle = Callable[[float], float]


def by_trial(draft: Draft, design: CrankRocker, rocker: Rocker, locus: Locus) -> Iterator[Points]:
    """Every A with the given γ_min; or the one with the greatest."""
    best = design.best is not None
    draft.board.step(
        Words(
            "在此轨迹上依次取 $A$，作出各机构曲柄与机架共线的两位置，量得 $γ_min$ 随 $A$ 的变化，"
            + ("取 $γ_min$ 最大的一点为 $A$。" if best else "取 $γ_min$ 等于给定值的点为 $A$。"),
            "Take $A$ here and there on this locus, draw each linkage with its crank on the line of the frame and read "
            + (
                "how $γ_min$ changes; $A$ is where it is greatest."
                if best
                else "how $γ_min$ changes; $A$ is where it is as given."
            ),
        ),
        SHEET,
    )
    track = _Track(rocker, locus)
    places = np.linspace(0.0, 1.0, PLACES + 2)[1:-1]
    tried = np.array([track.gamma(float(t)) for t in places])
    if best:
        found = _summit(track.gamma, places, tried)
    else:
        assert design.gamma_min is not None
        found = _crossings(track.gamma, places, tried, design.gamma_min.si)
    for t in found:
        yield track.on_sheet(draft, t)


class _Track:
    """The left half of a locus, from its end on C₁ (0) to the bisector, or far away (1)."""

    def __init__(self, rocker: Rocker, locus: Locus) -> None:
        self.locus = locus
        self.d, self.c1, self.c2 = (complex(nominal(at)) for at in (rocker.d, rocker.c1, rocker.c2))
        self.c = abs(self.c1 - self.d)

    def turn(self, t: float) -> float:
        """From C₁ the angle about O, away from C₂, as far as the bisector."""
        assert isinstance(self.locus, Eta)
        centre = complex(nominal(self.locus.centre))
        start = float(np.angle(self.c1 - centre))
        end = self.locus.side * pi / 2
        sweep = (end - start) % (2 * pi)
        return start + t * (sweep if sweep <= pi else sweep - 2 * pi)

    def at(self, t: float) -> complex:
        """The place of A."""
        if isinstance(self.locus, Straight):
            return self.c1 - (self.c2 - self.c1) * t / (1 - t)
        return complex(nominal(self.locus.centre) + nominal(self.locus.radius) * np.exp(1j * self.turn(t)))

    def on_sheet(self, draft: Draft, t: float) -> Points:
        """A there, set out on the sheet."""
        if isinstance(self.locus, Straight):
            line = self.locus.line
            return draft.board.lay_off(line.at, -line.along, abs(self.at(t) - self.c1))
        return draft.board.lay_off(self.locus.centre, np.exp(1j * self.turn(t)), self.locus.radius)

    def gamma(self, t: float) -> float:
        """The least transmission angle with A there, rad, by arcs on scratch paper; NaN where it is no solution."""
        a = self.at(t)
        if judged(a, self.d, self.c1, self.c2) is not Verdict.VALID:
            return float("nan")
        near, far = sorted((abs(self.c1 - a), abs(self.c2 - a)))
        crank, coupler, frame = (far - near) / 2, (far + near) / 2, abs(self.d - a)
        return min(_transmission(frame - side * crank, coupler, self.c) for side in (1, -1))


def _transmission(base: float, coupler: float, rocker: float) -> float:
    """∠BCD, or its supplement, over the base BD."""
    along = (base * base + coupler * coupler - rocker * rocker) / (2 * base)
    c = complex(along, abs(coupler * coupler - along * along) ** 0.5)
    angle = abs(float(np.angle((base - c) / -c)))
    return min(angle, pi - angle)


def _crossings(of: Angle, places: Tried, tried: Tried, wanted: float) -> Iterator[float]:
    for i in range(len(places) - 1):
        here, there = tried[i] - wanted, tried[i + 1] - wanted
        if here * there < 0:
            yield _halved(lambda t: of(t) - wanted, float(places[i]), float(places[i + 1]), here > 0)


def _halved(of: Angle, low: float, high: float, above: bool) -> float:
    for _ in range(REFINED):
        middle = (low + high) / 2
        low, high = (middle, high) if (of(middle) > 0) == above else (low, middle)
    return (low + high) / 2


def _summit(of: Angle, places: Tried, tried: Tried) -> Iterator[float]:
    if np.isnan(tried).all():
        return
    i = int(np.nanargmax(tried))
    low, high = float(places[max(i - 1, 0)]), float(places[min(i + 1, len(places) - 1)])
    for _ in range(REFINED):
        left, right = high - GOLDEN * (high - low), low + GOLDEN * (high - low)
        low, high = (left, high) if of(left) < of(right) else (low, right)
    yield (low + high) / 2
