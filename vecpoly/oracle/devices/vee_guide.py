"""Exact answers for a slide on a flat and a V guide:
force and moment balance as linear systems, friction summed over the faces."""

from __future__ import annotations

import numpy as np

from ...devices.vee_guide import VeeGuide
from .registry import Values, answers


@answers(VeeGuide)
def vee_guide(device: VeeGuide) -> Values:
    """Shares of the load, flank force, friction (N), equivalent coefficients."""
    load, f = device.G.si, device.f.si
    on_v, on_flat = np.linalg.solve([[1.0, 1.0], [-device.l1.si, device.l2.si]], [load, 0.0])
    flanks = np.exp(
        1j * np.array([np.pi - device.theta.si, device.theta.si])
    )  # normals of the right and the left flank, into the slide
    right, left = np.linalg.solve([flanks.real, flanks.imag], [0.0, on_v])
    on_vee, below = f * (right + left), f * on_flat
    return {
        "F1": float(on_v),
        "F2": float(on_flat),
        "N_flank": float(right),
        "F_f_V": float(on_vee),
        "F_f_flat": float(below),
        "F_f": float(on_vee + below),
        "f_vee": float(on_vee / on_v),
        "f_V": float((on_vee + below) / load),
    }
