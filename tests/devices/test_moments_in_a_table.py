"""A moment over an angle that is written in columns is the same as one written in pairs, whatever the units."""

from __future__ import annotations

import pytest

from tests.flywheels import pairs, wheel
from vecpoly.oracle.devices.registry import device_answers

ROWS = ((0, 0), (90, 400), (180, 0), (360, 0))
ANGLES = {"deg": 1.0, "°": 1.0, "r": 1 / 360}  # a degree in each
MOMENTS = {"N*m": 1.0, "kN*m": 1e-3, "N*mm": 1e3}


@pytest.mark.parametrize("angle", ANGLES)
@pytest.mark.parametrize("moment", MOMENTS)
def test_columns_say_what_pairs_say(angle: str, moment: str) -> None:
    rows = [[str(phi * ANGLES[angle]), str(size * MOMENTS[moment])] for phi, size in ROWS]
    columns = [f"phi ({angle})", f"M ({moment})"]
    told = device_answers(wheel(M_d={"table": "m.csv", "columns": columns, "rows": rows}))
    assert told == pytest.approx(device_answers(wheel(M_d=pairs(ROWS))), rel=1e-12)
