"""A six-bar that dwells: the coupler point E of a four-bar runs along a circle for a while, about whose centre F rests.

EF is the radius of the circle that fits E's path best while the output GF is to rest; its centre is F.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..cycle import cycle
from ..oracle.families import circles, hinge
from ..problem.problem import Problem
from ..words import Words
from .base import Measure
from .four_bar import HIGH, LOW, Reals, Written, coupler, longest, sound

Points = NDArray[np.complex128]
STEPS, INSIDE = 48, 16  # positions of a turn; of the dwell
WIDEST = 170.0  # degrees of swing: beyond, angles from the dwell are not told apart
MISSING = 4.0  # degrees of ripple that a degree of missing swing counts for


@dataclass(frozen=True, eq=False, kw_only=True)
class DwellSearch:
    """dwell: the crank's angle while the output is to rest (rad); swing: of the output at least (rad); crank: AB (m);
    gamma: least transmission angle of both loops (rad); longest: of the sides of the links and of the frame AD (m)."""

    dwell: float
    swing: float
    crank: float
    gamma: float
    longest: float = np.inf

    @property
    def box(self) -> tuple[Reals, Reals]:
        """Beside the four-bar: where the dwell begins, GF, the direction of FG in the dwell, the side of F."""
        return np.array([*LOW, 0.0, 0.5, 0.0, -1.0]), np.array([*HIGH, 2 * np.pi, 6.0, 2 * np.pi, 1.0])

    def possible(self, x: Reals) -> NDArray[np.bool_]:
        """Cranks that turn right round."""
        return sound(x, self.gamma)

    def score(self, x: Reals) -> Reals:
        """What GF moves in the dwell (degrees), more where it swings less than asked; infinite where it jams."""
        ripple, swing, gamma, radius = self._output(x)
        missing = np.maximum(np.degrees(self.swing) - swing, 0.0)
        small = self.crank * np.maximum(longest(x), radius) <= self.longest
        good = self.possible(x) & np.isfinite(swing) & (swing < WIDEST) & (gamma >= self.gamma) & small
        return np.where(good, ripple + MISSING * missing, np.inf)

    def _output(self, x: Reals) -> tuple[Reals, Reals, Reals, Reals]:
        """Ripple and swing in degrees, the least transmission angle at F (rad), the length of EF."""
        inside = np.exp(1j * (x[:, 6:7] + self.dwell * np.linspace(0.0, 1.0, INSIDE)))
        whole = np.exp(1j * (x[:, 6:7] + 2 * np.pi * np.arange(STEPS) / STEPS))
        f_rests, radius = circles(coupler(x, inside))
        g = f_rests + x[:, 7] * np.exp(1j * x[:, 8])
        angles = []
        for cranks in (inside, whole):
            f = hinge(coupler(x, cranks), np.broadcast_to(g[:, None], cranks.shape), radius, x[:, 7], _side(x))
            angles.append(np.degrees(np.angle((f - g[:, None]) * (f_rests - g).conj()[:, None])))
        rest, turn = angles
        reach = np.abs(coupler(x, whole) - g[:, None])
        cosine = (radius[:, None] ** 2 + x[:, 7:8] ** 2 - reach**2) / (2 * radius[:, None] * x[:, 7:8])
        gamma = np.arccos(np.clip(np.abs(cosine), 0.0, 1.0)).min(axis=1)
        return np.ptp(rest, axis=1), np.ptp(turn, axis=1), gamma, radius

    def built(self, x: Reals) -> Mapping[str, Any]:
        """The six-bar, its crank in the middle of the dwell."""
        made = Written(x=x, at=0j, scale=complex(self.crank))
        row = x[None, :]
        inside = np.exp(1j * (row[:, 6:7] + self.dwell * np.linspace(0.0, 1.0, INSIDE)))
        f_rests, radius = circles(coupler(row, inside))
        g = complex(f_rests[0] + x[7] * np.exp(1j * x[8]))
        four = made.four_bar()
        middle = float(np.degrees(x[6] + self.dwell / 2)) % 360
        return {
            "frame": four["frame"] | {"G": made.place(g)},
            "links": four["links"]
            | {"4": {"EF": made.length(float(radius[0]))}, "5": {"GF": made.length(float(x[7]))}},
            "input": {"link": "1", "phi": f"{middle:.3f} deg", "omega": "1 rad/s ccw"},
            "branch": [*four["branch"], f"F {'left' if x[9] >= 0 else 'right'} of EG"],
            "find": ["v_E", "omega_5", "a_E", "alpha_5"],
        }

    def measured(self, problem: Problem) -> tuple[Measure, ...]:
        """Ripple in the dwell and swing of GF."""
        drive = problem.mechanism.drive.position
        turn = cycle(problem, 721)
        near = drive + self.dwell * np.linspace(-0.5, 0.5, 361)
        rest = np.unwrap(np.asarray(turn.at("phi_5", near), np.float64))
        off = rest - (rest.max() + rest.min()) / 2
        return (
            Measure(
                name=Words("停歇中的均方根偏差", "RMS off the dwell"), value=float(np.degrees(off.std())), unit="deg"
            ),
            Measure(
                name=Words("停歇中的最大偏差", "worst off the dwell"), value=float(np.degrees(np.abs(off).max())),
                unit="deg",
            ),
            Measure(name=Words("摆角", "swing"), value=float(np.degrees(np.ptp(turn.real("phi_5")))), unit="deg"),
        )  # fmt: skip


def _side(x: Reals) -> Reals:
    return np.where(x[:, 9] < 0, -1.0, 1.0)
