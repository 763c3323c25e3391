"""A four-bar whose coupler point runs along a given curve, closed or open.

Curve and candidate are compared point by point at equal shares of their lengths. Where the linkage lies, how large it
is and how it is turned follows in closed form from the correlation of both: |z − α w − β|² is least for
α = Σ z w̄ / Σ |w|². Of closed curves all starting points are tried at once by the Fourier transform.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..cycle import cycle
from ..problem.problem import Problem
from ..words import Words
from .base import Measure
from .four_bar import HIGH, LOW, Reals, Written, coupler, longest, sound

Points = NDArray[np.complex128]
POINTS, CRANKS = 32, 64  # of a curve; places of the crank between which it is taken to be straight


@dataclass(frozen=True, eq=False, kw_only=True)
class PathSearch:
    """points: of the curve (m), in order; gamma: least transmission angle (rad); longest: of the sides of
    the links and of the frame (m)."""

    points: tuple[complex, ...]
    closed: bool
    gamma: float
    longest: float = np.inf

    @property
    def box(self) -> tuple[Reals, Reals]:
        """Beside the four-bar where the crank begins; of an open curve also how far it turns meanwhile (rad)."""
        span = () if self.closed else (1.0, 4.5)
        return np.array([*LOW, 0.0, *span[:1]]), np.array([*HIGH, 2 * np.pi, *span[1:]])

    @cached_property
    def target(self) -> Points:
        """The curve at equal shares of its length, about its middle."""
        line = np.array([*self.points, self.points[0]] if self.closed else self.points)
        even = even_points(line[None, :], self.closed)[0]
        centred: Points = even - even.mean()
        return centred

    def possible(self, x: Reals) -> NDArray[np.bool_]:
        """Cranks that turn right round."""
        return sound(x, self.gamma)

    def score(self, x: Reals) -> Reals:
        """The root mean square of the distances, over the size of the curve."""
        error = np.full(len(x), np.inf)
        good = self.possible(x)
        if good.any():
            error[good] = self._error(x[good])
        return error

    def _error(self, x: Reals) -> Reals:
        """Of linkages that turn right round."""
        best = np.zeros(len(x))
        curve, power = self._curves(x)
        for way in (1, -1):
            best = np.maximum(best, np.abs(self._correlated(curve, way)).max(axis=1) ** 2 / power)
        total = float(np.sum(np.abs(self.target) ** 2))
        error: Reals = np.sqrt(np.maximum(total - best, 0.0) / total)
        bars = np.sqrt(best / power) * longest(x)  # |α| is the size of AB
        return np.where(np.isfinite(error) & (bars <= self.longest), error, np.inf)

    def _curves(self, x: Reals) -> tuple[Points, Reals]:
        """Each candidate's curve at equal shares of its length, about its middle, and Σ |w|²."""
        even = even_points(coupler(x, self._cranks(x)), self.closed)
        even -= even.mean(axis=1)[:, None]
        return even, np.maximum(np.sum(even.real**2 + even.imag**2, axis=1), 1e-12)

    def _cranks(self, x: Reals) -> Points:
        turn = np.linspace(0.0, 1.0, CRANKS + 1)
        cranks: Points = np.exp(1j * (x[:, 6:7] + (2 * np.pi if self.closed else x[:, 7:8]) * turn))
        return cranks

    def _correlated(self, curve: Points, way: int) -> Points:
        """Σ z w̄ for every starting point, along the curve or backwards."""
        target = self.target[::way]
        if not self.closed:
            return (curve.conj() @ target)[:, None]
        return np.fft.ifft(np.fft.fft(target)[None, :] * np.fft.fft(curve, axis=1).conj(), axis=1)

    def _placed(self, x: Reals) -> tuple[complex, complex]:
        """α, and where A lies: β less what the middle of the curve is off."""
        curve, power = self._curves(x[None, :])
        found = [self._correlated(curve, way)[0] for way in (1, -1)]
        best = max((one[int(np.argmax(np.abs(one)))] for one in found), key=abs)
        alpha = complex(best / power[0])
        line = np.array([*self.points, self.points[0]] if self.closed else self.points)
        middle = even_points(line[None, :], self.closed)[0].mean()
        own = even_points(coupler(x[None, :], self._cranks(x[None, :])), self.closed)[0].mean()
        return alpha, complex(middle - alpha * own)

    def built(self, x: Reals) -> Mapping[str, Any]:
        """The four-bar with E on its coupler."""
        alpha, at = self._placed(x)
        made = Written(x=x, at=at, scale=alpha)
        start = 60.0 if self.closed else float(np.degrees(x[6] + x[7] / 2 + np.angle(alpha)) % 360)
        return made.four_bar() | {
            "input": {"link": "1", "phi": f"{start:.1f} deg", "omega": "1 rad/s ccw"},
            "target": {"point": "E", "through": [_written(at) for at in self.points], "closed": self.closed},
            "find": ["v_E", "a_E", "omega_3"],
        }

    def measured(self, problem: Problem) -> tuple[Measure, ...]:
        """How far the points of the curve lie from the path of E over the whole cycle."""
        path = np.asarray(cycle(problem, 3601).column("p_E"), np.complex128)
        off = np.array([distance(path, z) for z in self.points])
        return (
            Measure(name=Words("均方根误差", "RMS error"), value=1e3 * float(np.sqrt(np.mean(off**2))), unit="mm"),
            Measure(name=Words("最大误差", "worst error"), value=1e3 * float(off.max()), unit="mm"),
        )


def _written(at: complex) -> list[str]:
    """A place as a problem file has it."""
    return [f"{1e3 * at.real:.6g} mm", f"{1e3 * at.imag:.6g} mm"]


def distance(path: Points, z: complex) -> float:
    """From a point to a polygon."""
    steps, off = np.diff(path), z - path[:-1]
    square = np.maximum(steps.real**2 + steps.imag**2, 1e-300)
    share = np.clip((off.conj() * steps).real / square, 0.0, 1.0)
    return float(np.min(np.abs(off - share * steps)))


def even_points(lines: Points, closed: bool) -> Points:
    """Each row at POINTS equal shares of its length; of a closed one (its last point is its first) without the end."""
    steps = np.diff(lines, axis=1)
    length = np.concatenate([np.zeros((len(lines), 1)), np.cumsum(np.abs(steps), axis=1)], axis=1)
    length = length / np.maximum(length[:, -1:], 1e-300)
    rows = 2.0 * np.arange(len(lines))[:, None]
    shares = np.arange(POINTS) / POINTS if closed else np.linspace(0.0, 1.0, POINTS)
    known, asked = (length + rows).ravel(), (shares + rows).ravel()
    x, y = (np.interp(asked, known, part.ravel()) for part in (lines.real, lines.imag))
    return (x + 1j * y).reshape(len(lines), POINTS)
