"""How the determinants of the groups' linear equations vary over the cycle,
and where each is least, to full accuracy."""

from __future__ import annotations

from dataclasses import dataclass
from math import radians

import numpy as np
from numpy.typing import NDArray

from ..analytic.equations import GroupModel
from ..analytic.expr import Var
from ..cycle.facts.transmission_range import POOR, USUAL, Transmission
from ..words import Words
from .study.study import Study

ILL = float(np.sin(np.radians(10.0)))
SHORT = 0.35  # of its largest value: a determinant that is no sine of an angle
NONE = 1e-6  # a measure that is none, as at a change point
_NEAR = 1e-2  # of the range: how far a position of the grid may be from the extreme beside it
_ALIKE = 1e-6  # of the largest size: two extremes are one
_ZOOM, _ROUNDS = 21, 5  # places in a bracket; each round makes it ten times narrower


@dataclass(frozen=True, slots=True, eq=False)
class Conditioning:
    """How a group's determinant varies over the cycle: least and largest absolute value, and all the places of each,
    in order."""

    group: GroupModel
    least: float
    largest: float
    lows: tuple[float, ...]
    tops: tuple[float, ...]
    gamma: Transmission | None = None  # where the determinant is a product of lengths and sin γ

    @property
    def phi(self) -> float:
        """Where it is least."""
        return self.lows[0]

    @property
    def measure(self) -> float:
        """sin γ at its least, or the least determinant as a share of its largest: by 1/measure errors are magnified."""
        return float(np.sin(self.gamma.least.value)) if self.gamma is not None else self.ratio

    @property
    def times(self) -> str:
        """How many times errors are magnified: 1/measure."""
        return "∞" if self.is_none else f"{1 / self.measure:.1f}"

    @property
    def is_none(self) -> bool:
        """Whether errors are magnified without bound, as at a change point."""
        return self.measure <= NONE

    @property
    def is_poor(self) -> bool:
        """γ below 40°, the one bound of chapters 5, 8 and 9; of other determinants a range of nearly 3 : 1."""
        return self.measure < (float(np.sin(POOR)) if self.gamma is not None else SHORT)

    @property
    def is_ill(self) -> bool:
        """γ below 10°, and as much for other determinants."""
        return self.measure < ILL

    @property
    def verdict(self) -> Words:
        if self.is_ill:
            return Words("病态", "ill-conditioned")
        if self.is_poor:
            return Words("较差", "poor")
        just = self.gamma is not None and self.gamma.least.value < radians(USUAL)
        return Words("略低于 40°", "just below 40°") if just else Words("良好", "good")

    @property
    def ratio(self) -> float:
        return self.least / self.largest if self.largest else 0.0

    @property
    def symbol(self) -> str:
        """G_1, or the travel s by which the rates are divided."""
        return self.group.determinant.symbol if isinstance(self.group.determinant, Var) else "G_1"


def conditioning(study: Study) -> list[Conditioning]:
    """One entry a group that has a determinant."""
    found = []
    for group in study.model.groups:
        if group.determinant is None:
            continue
        sizes = determinant(study, group, study.turn.phi)
        if np.isfinite(sizes).any() and np.nanmax(sizes) > 0:
            least, largest = _refined(study, group, sizes, -1.0), _refined(study, group, sizes, 1.0)
            found.append(Conditioning(group, least[1], largest[1], least[0], largest[0], _gamma(study, group)))
    return found


def _gamma(study: Study, group: GroupModel) -> Transmission | None:
    """The transmission angle of an RRR or RRP group, whose G_1 is a product of lengths and sin γ."""
    found = next(
        (t for t in study.facts.transmissions if sorted(t.links) == sorted("".join(group.links).replace("pin", ""))),
        None,
    )
    return found if found is not None and study.whole.whole and found.kind in ("RRR", "RRP") else None


def determinant(study: Study, group: GroupModel, phi: NDArray[np.float64]) -> NDArray[np.float64]:
    """|determinant| of a group at these positions."""
    assert group.determinant is not None
    with np.errstate(invalid="ignore"):
        return np.abs(
            np.broadcast_to(
                np.asarray(
                    group.determinant.value(study.env if phi is study.turn.phi else study.model.values(phi)), np.float64
                ),
                phi.shape,
            )
        )


def _refined(
    study: Study, group: GroupModel, sizes: NDArray[np.float64], sign: float
) -> tuple[tuple[float, ...], float]:
    """The places and the value of the largest (sign 1) or least (−1) size, between the positions of the grid."""
    k, size = int(np.nanargmax(sign * sizes)), float(np.nanmax(sizes))
    span = float(np.ptp(sizes[np.isfinite(sizes)]))
    if span < 1e-9 * size:
        return (float(study.turn.phi[k]),), float(sizes[k])
    heights = np.nan_to_num(sign * sizes, nan=-np.inf)
    edged = np.pad(heights, 1, constant_values=-np.inf)
    peaks = (heights >= edged[:-2]) & (heights >= edged[2:]) & (heights >= heights[k] - _NEAR * span)
    found = [_zoomed(study, group, sizes, int(j), sign) for j in np.flatnonzero(peaks)]
    best = max(found, key=lambda one: sign * one[1])
    alike = [at for at, value in found if abs(value - best[1]) <= _ALIKE * size]
    return tuple(sorted(alike)), best[1]


def _zoomed(study: Study, group: GroupModel, sizes: NDArray[np.float64], k: int, sign: float) -> tuple[float, float]:
    """The same about one position of the grid."""
    phi = study.turn.phi
    at, half = float(phi[k]), float(phi[1] - phi[0])
    for _ in range(_ROUNDS if study.model.closed else 0):
        near = at + np.linspace(-half, half, _ZOOM)
        near = near if study.whole.whole else np.clip(near, study.whole.low, study.whole.high)
        values = determinant(study, group, near)
        at, half = float(near[int(np.nanargmax(sign * values))]), half / 10
    value = float(determinant(study, group, np.array([at]))[0]) if study.model.closed else float(sizes[k])
    return study.reduced(at), value
