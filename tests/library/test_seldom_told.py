"""Claims that a run of mutants found missing: each kills slips that nobody had noticed."""

from __future__ import annotations

from types import SimpleNamespace
from typing import Any

import pytest

from tests.drawn_library import drawn, ids
from tests.each import Later, each
from tests.texts import CRANK
from vecpoly.diagram.bars import weld
from vecpoly.drawing.scene import Fill
from vecpoly.drawing.symbols.bodies import WELD
from vecpoly.drawing.symbols.bodies import weld as filled
from vecpoly.errors import VecpolyError
from vecpoly.foundation.data import data_dir
from vecpoly.problem.load import load, loads
from vecpoly.problem.values.current import _motion
from vecpoly.problem.values.given import Given, as_printed
from vecpoly.report.course.modelling.example import _valued


def test_nobody_changes_what_is_given() -> None:
    shapes: dict[str, Any] = dict(load("3-9").given.shapes)
    given = Given(shapes=shapes)
    shapes.clear()
    assert given.shapes == load("3-9").given.shapes and given.shapes
    with pytest.raises(TypeError):
        given.shapes["9"] = None  # type: ignore[index]


def test_a_weld_is_a_small_triangle_between_its_two_bars() -> None:
    (corner,) = filled(weld(1 + 1j, 30 + 0j, 70j))
    assert isinstance(corner, Fill) and corner.points == pytest.approx((1 + 1j, 1 + WELD + 1j, 1 + 1j + WELD * 1j))
    (other,) = filled(weld(0j, -3 + 0j, 2 - 2j))
    assert isinstance(other, Fill) and other.points[1:] == pytest.approx((-WELD, WELD * (1 - 1j) / 2**0.5))


@pytest.mark.parametrize(
    ("symbol", "value", "text"),
    [
        ("ω_1", 0.5, "0.5 rad/s ccw"),
        ("ω_1", -0.5, "0.5 rad/s cw"),
        ("ω_1", 0.0, "0 rad/s"),
        ("α_1", -2.0, "2 rad/s^2 cw"),
        ("φ_1", 7.0, "41.0705 deg"),
        ("φ_1", -1.0, "-57.2958 deg"),
        ("s_3", 0.12, "120 mm"),
        ("v_3", -0.5, "-0.5 m/s"),
        ("a_3", 2.0, "2 m/s^2"),
    ],
)
def test_a_changed_motion_is_written_with_its_sense_and_unit(symbol: str, value: float, text: str) -> None:
    assert _motion(SimpleNamespace(symbol=symbol), value) == text  # type: ignore[arg-type]


@pytest.mark.parametrize(
    ("written", "meant"), [("blok: C", "block"), ("slto: C", "slot"), ("gaer: C", "gear"), ("x: C", "")]
)
def test_a_misspelt_key_of_a_link_is_told_with_the_one_that_is_meant(written: str, meant: str) -> None:
    with pytest.raises(VecpolyError) as caught:
        loads(CRANK.replace("block: C", written))
    assert (
        ("did you mean" in str(caught.value)) == bool(meant)
        and meant in str(caught.value)
        and "is no key of a link" in str(caught.value)
    )


@each(Later(lambda: ids(mechanisms=False)))
def test_what_is_read_off_a_device_in_millimetres_tells_its_line_and_its_scale(name: str) -> None:
    construction = drawn(name).construction
    scales = {one.symbol for figure in construction.figures for one in (figure.scale, figure.scale.right)}
    for reading in (*construction.readings.values(), *construction.forces.values()):
        assert (reading.mm is None) == (reading.scale == ""), reading.key
        assert reading.scale in {"", *scales} and (reading.line == "" or reading.mm is not None), reading.key


def test_devices_are_read_in_millimetres() -> None:
    assert (
        sum(
            reading.mm is not None
            for name in ids(mechanisms=False)
            for reading in drawn(name).construction.readings.values()
        )
        > 10
    )


def test_a_pin_that_runs_in_two_slots_has_no_turn_of_its_own_to_tell() -> None:
    said = [step.words for step in drawn("pin-in-two-slots").construction.steps]
    assert said and not any("组成移动副" in words.zh or "form a sliding pair" in words.en for words in said)


@pytest.mark.parametrize(("value", "text"), [(0.5, "28.648"), (-0.5, "−28.648"), (4.0, "−130.817"), (-6.0, "16.225")])
def test_an_angle_of_the_worked_example_lies_within_half_a_turn_and_has_a_true_minus(value: float, text: str) -> None:
    assert _valued("φ_{2}", value) == _valued("ψ_{2}", value) == (text, "°")


@pytest.mark.parametrize(
    ("given", "symbol", "text"), [("length: 1500 mm", "l_DC", "1500 mm"), ("s: 1500 mm", "s_32", "1500 mm")]
)
def test_the_given_position_of_a_cylinder_is_its_length_or_its_travel(given: str, symbol: str, text: str) -> None:
    file = data_dir("problems") / "machines" / "lift-gate.yaml"
    problem = loads(file.read_text(encoding="utf-8").replace("length: 1500 mm", given))
    first, speed, _ = problem.given.motion
    assert (first.symbol, first.si, first.text) == (symbol, 1.5, text) and speed.symbol == "v_C3C2"


def test_a_degree_of_freedom_is_no_unit_where_values_are_printed() -> None:
    assert as_printed("a passive degree of freedom, 45 deg cw", "en") == "a passive degree of freedom, 45° (clockwise)"
    assert as_printed("45 deg from BC", "zh") == "45° 自 BC"
