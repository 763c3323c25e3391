"""What comes out negative is read as a length like any other: the minus stands before all of its line, for a scale is
positive."""

from __future__ import annotations

import pytest

import vecpoly
from vecpoly.algebra.formula import plain

CAM = {
    "follower": {"knife": "yes"},
    "alpha": {"rise": "43 deg", "return": "60 deg"},
    "turns": "cw",
    "motion": ["rise 16 mm in 84 deg uniform", "dwell 1 deg", "return in 107 deg sine", "dwell 168 deg"],
}
ROTOR = {
    "masses": {
        "A": {"m": "?", "r": "120 mm", "at": "?", "z": "0 mm"},
        "B": {"m": "2.530 kg", "r": "167 mm", "at": "141.69 deg", "z": "473 mm"},
        "C": {"m": "?", "r": "93 mm", "at": "46.92 deg", "z": "-518 mm"},
        "D": {"m": "?", "r": "177 mm", "at": "288.50 deg", "z": "714 mm"},
        "E": {"m": "2.996 kg", "r": "90 mm", "at": "129.53 deg", "z": "-397 mm"},
    }
}


def lines(device: str, data: dict[str, object], find: str, beginning: str) -> list[str]:
    asked = {"id": "t", "title": "t", "device": device, "data": data, "find": [find]}
    solution = vecpoly.problem(asked).solve(by="exact")
    assert not any(answer.suspect for answer in solution.answers.values())
    told = [plain(line).replace("\u2009", " ") for step in solution.construction.steps for line in step.formulas]
    return [line for line in told if line.startswith(beginning)]


@pytest.mark.parametrize(
    ("device", "data", "find", "beginning"),
    [
        ("cam", CAM, "e", "e = −μ_s B_0D′ = −0.0003 × 14.93 = −0.00448 m = "),
        ("rotor", ROTOR, "m_C", "C_C = −μ_Wl bp = −0.002 × "),
    ],
)
def test_the_minus_of_what_lies_the_other_way_stands_before_the_scale(
    device: str, data: dict[str, object], find: str, beginning: str
) -> None:
    assert len(lines(device, data, find, beginning)) == 1
