"""The crank-rocker with the greatest minimum transmission angle among all of one K whose swing lies in a range."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..cycle import cycle, facts
from ..problem.problem import Problem
from ..words import Words
from .base import Measure, Reals

NO_CHANGE = np.radians(5.0)  # of γ_min: below, the linkage all but lies in one line once a turn


@dataclass(frozen=True, eq=False, kw_only=True)
class TransmissionSearch:
    """ratio: K; swing: range of ψ (rad); rocker: CD (m)."""

    ratio: float
    swing: tuple[float, float]
    rocker: float

    @property
    def theta(self) -> float:
        """θ = π (K − 1) / (K + 1)."""
        return float(np.pi * (self.ratio - 1) / (self.ratio + 1))

    @property
    def box(self) -> tuple[Reals, Reals]:
        """ψ, where A lies on the circle that sees C₁C₂ under θ (share of its half), and which circle."""
        return np.array([self.swing[0], 0.0, -1.0]), np.array([self.swing[1], 1.0, 1.0])

    def possible(self, x: Reals) -> NDArray[np.bool_]:
        """Both limits of the rocker on one side of AD, and no change point near."""
        good: NDArray[np.bool_] = self.score(x) < -NO_CHANGE
        return good

    def score(self, x: Reals) -> Reals:
        """−γ_min (rad)."""
        a, b, d, good = self._lengths(x)
        cosines = [(b * b + 1.0 - (d - way * a) ** 2) / (2 * b) for way in (1.0, -1.0)]
        gamma = np.arccos(np.clip(np.maximum(*np.abs(cosines)), 0.0, 1.0))
        return np.where(good & (gamma > NO_CHANGE), -gamma, np.inf)

    def _lengths(self, x: Reals) -> tuple[Reals, Reals, Reals, NDArray[np.bool_]]:
        """AB, BC, AD of CD = 1, and whether the rocker can swing from one limit to the other."""
        half, height = np.sin(x[:, 0] / 2), np.cos(x[:, 0] / 2)
        side = np.where(x[:, 2] < 0, -1.0, 1.0)
        middle, radius = 1j * (height + side * half / np.tan(self.theta)), half / np.sin(self.theta)
        a_pin = middle - radius * np.exp(-1j * side * (x[:, 1] * (np.pi - self.theta) - np.pi / 2))
        ends = [sign * half + 1j * height for sign in (-1.0, 1.0)]
        near, far = np.sort(np.abs(np.stack([end - a_pin for end in ends])), axis=0)
        a, b, d = (far - near) / 2, (far + near) / 2, np.abs(a_pin)
        turns = [((-a_pin).conjugate() * (end - a_pin)).imag for end in ends]
        seen = np.abs(np.angle((ends[1] - a_pin) / (ends[0] - a_pin)))
        return a, b, d, (turns[0] * turns[1] > 0) & (np.abs(seen - self.theta) < 1e-9) & (a > 1e-3)

    def built(self, x: Reals) -> Mapping[str, Any]:
        """The crank-rocker with A in the origin."""
        a, b, d, _ = (float(one[0]) for one in self._lengths(x[None, :]))
        lengths = {"AB": a, "BC": b, "CD": 1.0}
        mm = {key: f"{1e3 * self.rocker * size:.3f} mm" for key, size in lengths.items()}
        return {
            "frame": {"A": ["0 mm", "0 mm"], "D": [f"{1e3 * self.rocker * d:.3f} mm", "0 mm"]},
            "links": {str(n): {key: mm[key]} for n, key in enumerate(mm, 1)},
            "input": {"link": "1", "phi": "60 deg", "omega": "1 rad/s ccw"},
            "branch": ["C left of BD"],
            "find": ["v_C", "omega_3", "a_C", "alpha_3"],
        }

    def measured(self, problem: Problem) -> tuple[Measure, ...]:
        """γ_min, K and ψ of the linkage as it moves."""
        seen = facts(cycle(problem, 721))
        least = min(one.least.value for one in seen.transmissions)
        stroke = seen.strokes[-1]
        return (
            Measure(name=Words("最小传动角", "minimum transmission angle"), value=float(np.degrees(least)), unit="deg"),
            Measure(name=Words("行程速比系数 K", "time ratio K"), value=stroke.ratio, unit=""),
            Measure(name=Words("摆角", "swing"), value=float(np.degrees(stroke.swing)), unit="deg"),
        )
