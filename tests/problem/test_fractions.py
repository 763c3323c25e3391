"""A pure number may be a fraction or told in per cent, as textbooks write δ = 1/50 and η = 92 %."""

from __future__ import annotations

import pytest

import vecpoly
from vecpoly.errors import FaultError, ProblemFileError
from vecpoly.units.reading import pure

WHEEL = {"M_r": [["0 deg", "100 N*m"], ["90 deg", "600 N*m"], ["360 deg", "100 N*m"]], "n": "240 r/min"}


@pytest.mark.parametrize(("text", "value"), [("1/50", 0.02), ("1 / 2.5", 0.4), ("-3/4", -0.75), ("−3/4", -0.75)])
def test_a_fraction_is_a_pure_number(text: str, value: float) -> None:
    assert pure(text, "0.15") == pytest.approx(value, rel=1e-15)


SHARES = [("92 %", 0.92), ("5%", 0.05), ("-0.5 %", -0.005), ("5 ％", 0.05)]


@pytest.mark.parametrize(("text", "value"), SHARES)
def test_so_many_per_cent_are_a_pure_number(text: str, value: float) -> None:
    assert pure(text, "0.15") == pytest.approx(value, rel=1e-15)


@pytest.mark.parametrize("text", ["1/0", "1/2/3", "1/", "/2", "1/-2", "1/2 mm", "a/b", "%", "5 % %", "1/50 %"])
def test_what_is_no_fraction_of_two_numbers_is_refused(text: str) -> None:
    with pytest.raises(FaultError, match="no pure number"):
        pure(text, "0.15")


def test_a_flywheel_has_its_unevenness_as_a_fraction() -> None:
    told, reckoned = (
        vecpoly.problem({"id": "t", "title": "t", "device": "flywheel", "data": WHEEL | {"delta": delta}})
        .solve(by="exact")
        .answers["J_F"]
        .exact
        for delta in ("1/50", "0.02")
    )
    assert told == reckoned


def test_a_fraction_beyond_its_range_is_still_out_of_range() -> None:
    with pytest.raises(ProblemFileError, match="must not be negative"):
        vecpoly.problem({"id": "t", "title": "t", "device": "flywheel", "data": WHEEL | {"delta": "-1/50"}})
