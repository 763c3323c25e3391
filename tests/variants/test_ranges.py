"""A range is a grid of written values; whatever is wrong with one is told with its place and both numbers."""

from __future__ import annotations

from decimal import Decimal

import pytest
from hypothesis import given
from hypothesis import strategies as st

import vecpoly
from tests.variants.block import TEXT, block
from vecpoly.errors import ProblemFileError
from vecpoly.problem.gate import Gate
from vecpoly.units.reading import Dim, read


def test_a_grid_holds_both_ends_and_every_step_between() -> None:
    first = block().ranges[0]
    assert [first.at(i) for i in range(first.count)] == [f"{mm} mm" for mm in range(24, 41, 2)]
    assert block().ranges[3].at(1) == "8.5 rad/s cw"


@given(st.integers(1, 400), st.integers(1, 40), st.integers(1, 60))
def test_a_value_of_the_grid_is_exact_however_many_steps_lie_before_it(low: int, step: int, count: int) -> None:
    tenths = [Decimal(low + step * i) / 10 for i in (0, 1, count)]
    written = f"vary: {{AB: {tenths[0]} mm .. {tenths[2]} mm by {Decimal(step) / 10} mm}}\n"
    found = vecpoly.loads(f"id: r\ntitle: r\nextends: 3-9\n{written}").ranges[0]
    assert found.count == count + 1
    assert read(found.at(count), Dim.LENGTH).si == read(f"{tenths[2]} mm", Dim.LENGTH).si


@pytest.mark.parametrize(
    ("text", "says"),
    [
        ("AB: 28 mm .. 41 mm by 2 mm", "end at 40 or 42"),
        ("AB: 28 mm", "is no range"),
        ("AB: 2.8 cm .. 40 mm by 2 mm", "cm, mm, mm"),
        ("AB: 28 .. 40 mm by 2 mm", "'28' has no unit"),
        ("AB: 40 mm .. 28 mm by 2 mm", "the end above the start"),
        ("AB: 28 mm .. 40 mm by 0 mm", "the step must be above zero"),
        ("AB: 1 mm .. 900 mm by 0.01 mm", "10000 at most"),
        ("phi: 0 mm .. 40 mm by 2 mm", "is not an angle"),
        ("XB: 1 mm .. 2 mm by 1 mm", "nothing that is given is called 'XB'"),
        ("C: 1 mm .. 2 mm by 1 mm", "vary x_C and y_C"),
        ("phi: 0 deg .. 40 deg by 2 deg, phi_1: 0 deg .. 40 deg by 2 deg", "one quantity"),
    ],
)
def test_a_wrong_range_is_refused_at_its_place(text: str, says: str) -> None:
    with pytest.raises(ProblemFileError) as refused:
        vecpoly.loads(f"id: r\ntitle: r\nextends: 3-9\nvary: {{{text}}}\n")
    assert says in str(refused.value)
    assert "line 4" in str(refused.value) and "vary." in str(refused.value)
    assert all(fault.said.zh != fault.said.en for fault in refused.value.faults)


def test_a_coefficient_of_friction_and_the_data_of_a_device_may_vary() -> None:
    wedge = vecpoly.loads("id: r\ntitle: r\nextends: 5-5\nvary: {f: 0.08 .. 0.14 by 0.01, d: 22 mm .. 30 mm by 2 mm}\n")
    assert [one.at(1) for one in wedge.ranges] == ["0.09", "24 mm"]


def test_the_gate_reads_per_cent_and_keeps_its_defaults() -> None:
    gate = block("deviation: 12 %, vectors: 1 cm, alike: no").gate
    assert (gate.deviation, gate.vectors, gate.alike) == (0.12, 10.0, False)
    assert (gate.meetings, gate.apart) == (Gate().meetings, Gate().apart)
    with pytest.raises(ProblemFileError, match="cannot be negative"):
        vecpoly.loads(TEXT + "gate: {apart: -1}\n")


def test_of_an_angle_that_counts_from_a_line_the_angle_alone_varies() -> None:
    """210 deg from EG becomes 205 deg from EG; where the link has a line of its own it is not lost."""
    leg = vecpoly.loads("id: r\ntitle: r\nextends: klann-leg\nvary: {angle_H: 200 deg .. 220 deg by 5 deg}\n")
    assert leg.ranges[0].at(1) == "205 deg"
    told = vecpoly.load("klann-leg").vary(angle_H="205 deg").text
    assert '"EH": "89.7 mm", "angle": "205 deg from EG"' in told
