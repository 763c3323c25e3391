"""Rotors whose answers were worked out elsewhere, and how such a case is written as a device."""

from __future__ import annotations

import json
from math import isnan
from pathlib import Path
from typing import Any

from tests.cam_cases import device, drawn
from vecpoly.devices.base import Device
from vecpoly.oracle.devices.registry import device_answers

CASES: dict[str, Any] = json.loads((Path(__file__).parent / "data" / "rotors.json").read_text(encoding="utf-8"))


def holes(case: str) -> dict[str, Any]:
    """The unbalances of a disc: holes, a keyway, lumps, numbered in this order."""
    told = CASES[case]["inputs"]
    found = [{"hole": f"{one['d_mm']} mm", **_at(one)} for one in told["holes"]]
    if (key := told.get("keyway")) is not None:
        place = {"r": f"{key['centroid_r_mm']} mm", "at": f"{key['at_deg']} deg"}
        found.append({"keyway": f"{key['width_mm']} mm", "depth": f"{key['depth_mm']} mm", **place})
    found += [{"m": f"{one['m_kg']} kg", **_at(one)} for one in told["lumps"]]
    thick = told.get("thickness_mm", told.get("width_mm"))
    disc = {"b": f"{thick} mm", "density": f"{told['density_kg_m3']} kg/m^3"}
    return {"disc": disc, "masses": {str(i): one for i, one in enumerate(found, 1)}}


def _at(one: dict[str, Any]) -> dict[str, str]:
    return {"r": f"{one['r_mm']} mm", "at": f"{one['at_deg']} deg"}


def two_planes() -> Device:
    """Three masses between two planes (A06)."""
    told = CASES["A06"]["inputs"]
    masses = {
        str(i): {"m": f"{one['m_kg']} kg", "z": f"{one['z_mm']} mm", **_at(one)}
        for i, one in enumerate(told["masses"], 1)
    }
    planes = zip(("I", "II"), told["planes_mm"], told["r_b_mm"], strict=True)
    return device("rotor", masses=masses, correct={n: {"z": f"{z} mm", "r": f"{r} mm"} for n, z, r in planes})


def dalby(couples: tuple[float, float, float] | None = None) -> Device:
    """Four masses of which C and D are turned and A is sought (A08); or with these couples of B, C, D."""
    told = CASES["A08"]["inputs"]
    masses: dict[str, dict[str, str]] = {}
    for i, name in enumerate("ABCD"):
        z, r = told["planes_mm"][name], told["radii_mm"][name]
        weight = told["masses_kg"][name]
        if couples is not None and i:
            weight = couples[i - 1] / (z * r * 1e-6)
        masses[name] = {
            "m": "?" if weight == "?" else f"{weight!r} kg",
            "r": f"{r} mm",
            "z": f"{z} mm",
            "at": "0 deg" if name == "B" else "?",
        }
    return device("rotor", masses=masses)


def grade() -> Device:
    """Residual unbalances within G 6.3 (A11)."""
    told = CASES["A11"]["inputs"]
    ends = (("I", 0, told["residual_I_gmm"]), ("II", told["L_mm"], told["residual_II_gmm"]))
    masses = {
        str(i): {"U": f"{left['U']} g*mm", "at": f"{left['at_deg']} deg", "z": f"{z} mm"}
        for i, (_, z, left) in enumerate(ends, 1)
    }
    tolerance = {
        "G": f"{told['G_mm_s']} mm/s",
        "mass": f"{told['m_kg']} kg",
        "n": f"{told['n_rpm']} r/min",
        "z": f"{told['centre_of_mass_from_I_mm']} mm",
    }
    return device("rotor", masses=masses, correct={n: {"z": f"{z} mm"} for n, z, _ in ends}, tolerance=tolerance)


def runs(case: str, unit: str = "um") -> Device:
    """Trial runs without phase."""
    told = CASES[case]["inputs"]
    radius = f"{told.get('trial_r_mm', 100)} mm"
    trials = [
        {"m": f"{told['trial_m_g']} g", "r": radius, "at": f"{at} deg", "reading": f"{shown} {unit}"}
        for at, shown in zip(told["trial_at_deg"], told["runs"], strict=True)
    ]
    return device("field-balancing", initial=f"{told['initial']} {unit}", trials=trials, correct={"r": radius})


def influence(trial: str) -> Device:
    """One trial weight with phases (A13), taken off or left."""
    told = CASES["A13"]["inputs"]
    v0, v1, weight = told["V0"], told["V1"], told["trial"]
    run = {"m": f"{weight['m_g']} g", **_at(weight), "reading": f"{v1['um']} um at {v1['phase_deg']} deg"}
    first = f"{v0['um']} um at {v0['phase_deg']} deg"
    correct = {"r": f"{told['correction_r_mm']} mm", "trial": trial}
    return device("field-balancing", initial=first, trials=[run], correct=correct)


def agree(subject: Device, within: float = 1e-9) -> dict[str, Any]:
    """Everything that may be asked, vectors as such, by the exact hand and by the oracle; gives what was drawn."""
    readings, exact = drawn(subject).readings, device_answers(subject)
    found = {key: one.scalar if one.vector is None else one.vector for key, one in readings.items()}
    assert set(found) == {named.key for named in subject.quantities()}
    largest: dict[str, float] = {"deg": 180.0} | dict(subject.likely)  # an angle near 0 is no rounder than another
    for key, one in readings.items():
        if not isnan(abs(exact[key])):
            largest[one.unit] = max(abs(exact[key]), largest.get(one.unit, 1e-6))
    for key, one in readings.items():
        gap = found[key] - exact[key]
        off = abs((gap + 180.0) % 360.0 - 180.0) if one.unit == "deg" and not isinstance(gap, complex) else abs(gap)
        nothing = isnan(abs(exact[key])) and isnan(abs(found[key]))
        assert nothing or off <= within * largest[one.unit], (key, found[key], exact[key])
    return found


def blind(**more: str) -> dict[str, Any]:
    """A pulley from which a blind hole is drilled (A03)."""
    told = CASES["A03"]["inputs"]["correction"]
    plane = {"r": f"{told['r_mm']} mm", "hole": f"{told['drill_d_mm']} mm", **more}
    return holes("A03") | {"correct": {"I": plane}}


def lumps(*masses: tuple[float, float, float]) -> dict[str, Any]:
    """Masses by their product (kg·m), direction and place along the axis (mm)."""
    return {
        str(i): {"m": f"{w!r} kg", "r": "1 m", "at": f"{at!r} deg", "z": f"{z!r} mm"}
        for i, (w, at, z) in enumerate(masses, 1)
    }


def planes(one: float, other: float) -> dict[str, Any]:
    """Two planes of correction, by their places (mm)."""
    return {"I": {"z": f"{one!r} mm", "r": "1 m"}, "II": {"z": f"{other!r} mm", "r": "1 m"}}
