"""Exact answers for a screw jack: the collar by integrating its pressure over rings,
the nut by the balance of two components."""

from __future__ import annotations

import numpy as np

from ...devices.screw_jack import ScrewJack
from .registry import Values, answers


@answers(ScrewJack)
def screw_jack(device: ScrewJack) -> Values:
    """Moments per unit of load (mm), angles (deg), efficiencies; then the load or the force, and the moments (N·m)."""
    mean = (device.d.si + device.d1.si) / 4 * 1e3
    lead = device.starts * device.p.si * 1e3
    f = device.thread.si / (np.cos(device.beta.si) if device.beta else 1.0)
    up, down = mean * _push(lead / mean, f), mean * _push(lead / mean, -f)
    rub = _collar(device.D.si / 2 * 1e3, device.d0.si / 2 * 1e3, device.collar.si)
    ideal = lead / (2 * np.pi)
    total, back = up + rub, rub - down
    arm = device.lever.si * 1e3
    load = device.Q.si if device.Q else device.F.si * arm / total if device.F else np.nan
    tan = lead / (2 * np.pi * mean)
    values = {
        "phi": np.degrees(np.arctan2(f, 1.0)),
        "tan_alpha": tan,
        "alpha": np.degrees(np.arctan2(lead, 2 * np.pi * mean)),
        "M1_over_Q": rub,
        "M2_over_Q": up,
        "M_over_Q": total,
        "M0_over_Q": ideal,
        "eta": ideal / total,
        "eta_thread": ideal / up,
        "Q": load,
        "F": load * total / arm,
        "self_locking": down <= 0,
        "M_r_over_Q": back,
        "eta_r": -back / ideal,
    }
    values |= {name: load * values[f"{name}_over_Q"] / 1e3 for name in ("M1", "M2", "M", "M0")}
    return {key: float(value) for key, value in values.items()}


def _push(lead_per_radius: float, f: float) -> float:
    """Horizontal force per unit of load that moves the nut evenly; f < 0: on its way down.

    Unknown normal force N and push H: along and across the slope of the thread,
    N (t_perp − f t) balances load and push.
    """
    along = np.array([2 * np.pi, lead_per_radius]) / np.hypot(2 * np.pi, lead_per_radius)
    normal = np.array([-along[1], along[0]])
    pressed = normal - f * along  # friction acts down the slope when the nut moves up
    matrix = np.column_stack([pressed, [1.0, 0.0]])
    return float(np.linalg.solve(matrix, [0.0, 1.0])[1])


def _collar(outer: float, inner: float, f: float) -> float:
    """Moment per unit of load of an even pressure on a ring, ∫ f p r dA, by Gauss's rule over the radius."""
    nodes, weights = np.polynomial.legendre.leggauss(4)
    half = (outer - inner) / 2
    r = inner + half * (nodes + 1)
    area = 2 * np.pi * r * weights * half
    return float(np.sum(f * r * area) / np.sum(area))
