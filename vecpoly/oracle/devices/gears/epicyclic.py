"""Exact speeds of an epicyclic train by Willis' equation: ω_1 − ω_H = i (ω_3 − ω_H)."""

from __future__ import annotations

import numpy as np

from ....devices.gears.epicyclic import Epicyclic
from ..registry import Values, answers

LINKS = ("1", "2", "3", "H")


@answers(Epicyclic)
def epicyclic(device: Epicyclic) -> Values:
    """Two meshes and the two given speeds, as linear equations in ω_1, ω_2, ω_3, ω_H."""
    z1, z2, last, z3 = device.sun, device.planet[0], device.planet[-1], device.other
    mesh = -1.0 if device.ring is None else 1.0  # an inner mesh keeps the sense
    rows = [[z1, z2, 0.0, -(z1 + z2)], [0.0, last, -mesh * z3, mesh * z3 - last]]
    right = [0.0, 0.0]
    for key, omega in device.omegas.items():
        if omega is not None:
            rows.append([float(link == key) for link in LINKS])
            right.append(omega.si)
    turns = dict(zip(LINKS, map(float, np.linalg.solve(np.array(rows), np.array(right))), strict=True))
    radii = device.radii
    speeds = {"v_A": turns["1"] * radii["1"], "v_O2": turns["H"] * radii["H"], "v_C": turns["3"] * radii["3"]}
    found = speeds | {f"omega_{link}": turn for link, turn in turns.items()}
    if device.ratio is not None and device.driver is not None:
        driven = turns[device.sought]
        found[device.ratio.key] = turns[device.driver] / driven if driven else float("nan")
    return found
