"""Cases of machines in motion that were worked out elsewhere, and how one is written as a device."""

from __future__ import annotations

import json
from collections.abc import Sequence
from pathlib import Path
from typing import Any

from tests.cam_cases import device
from vecpoly.devices.base import Device

CASES: dict[str, Any] = json.loads(
    (Path(__file__).resolve().parent / "data" / "dynamics-areas.json").read_text(encoding="utf-8")
)


def pairs(rows: Sequence[Sequence[float]]) -> list[list[str]]:
    return [[f"{phi} deg", f"{moment} N*m"] for phi, moment in rows]


def wheel(**data: Any) -> Device:
    return device("flywheel", **{"n": "600 r/min", "delta": "0.02"} | data)


def two_stroke() -> Device:
    """B14."""
    told = CASES["B14"]["inputs"]
    return wheel(
        M_d=pairs(told["M_d"]), n=f"{told['n_rpm']} r/min", delta=str(told["delta"]), J=f"{told['J_other']} kg*m^2"
    )


def rimmed() -> Device:
    """B11."""
    told = CASES["B11"]["inputs"]
    rim = told["rim"]
    return wheel(
        areas=[str(one) for one in told["areas_mm2"]],
        mu_A=told["mu"].replace("mm2", "mm^2"),
        n=f"{told['n_m_rpm']} r/min",
        delta=str(told["delta"]),
        rim={
            "D": f"{rim['D_mean_mm']} mm",
            "b/h": str(rim["b_over_h"]),
            "density": f"{rim['density']} kg/m^3",
            "v_max": f"{rim['v_max_m_s']} m/s",
        },
    )
