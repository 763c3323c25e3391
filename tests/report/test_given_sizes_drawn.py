"""What the data of a mechanism give by a letter, or by two lengths, stands on the sketch beside them, as large."""

from __future__ import annotations

import re
from cmath import phase
from collections.abc import Iterator
from functools import cache
from math import pi

import pytest

from tests.drawn_library import LIBRARY, drawn, given, ids
from tests.each import Later, each
from tests.found import FOUND
from vecpoly.board.construction import Figure
from vecpoly.board.paper.marks import AngleMark, Arc, Disc, GearMark, Point, Segment, Vector
from vecpoly.devices.balancing.field import FieldBalancing
from vecpoly.devices.balancing.rotor import Rotor
from vecpoly.mechanism.model import Rolling
from vecpoly.report.question.sketch import sketched

IDS = Later(lambda: [name for name in (*ids(), *FOUND) if given(name).acting is not None or given(name).given.data])
WIDTH, HEIGHT = 165.0, 90.0  # mm
OFF = re.compile(r"lies ([\d.]+) mm from .* and ([\d.]+) mm to its (?:left|right)")


@cache
def sketch(name: str) -> Figure:
    figure = sketched(given(name), drawn(name).construction, WIDTH, HEIGHT)
    assert figure is not None
    return figure


def sizes(figure: Figure) -> list[float]:
    """All lengths between the ends of thin lines and arrows (m)."""
    return [abs(m.b - m.a) * figure.scale.value for m in figure.marks if isinstance(m, Segment | Vector)]


def letters(figure: Figure) -> set[str]:
    return {mark.label for mark in figure.marks if isinstance(mark, Point | AngleMark)}


def radii(name: str) -> Iterator[tuple[str, float]]:
    """Of wheels, discs and rollers; those of balancing masses, and of gears that roll on nothing, are on no circle."""
    mech = given(name).mechanism
    rolling = {one.link for j in mech.joints if isinstance(j, Rolling) for one in (j.gear, j.on)}
    touching = {one.link for contact in mech.contacts for one in (contact.disc, contact.on)}
    round_ones = rolling | touching | {roller for roller, _ in mech.welded}
    for datum in given(name).given.data:
        if re.fullmatch(r"r_\d\D?\D?", datum.symbol) and datum.symbol[2] in round_ones:
            yield datum.symbol, datum.si
        for symbol, size in re.findall(r"pitch radius \$(r_\w)\$ = ([\d.]+) mm", datum.of("en")):
            yield symbol, 1e-3 * float(size)


def coordinates(name: str) -> Iterator[tuple[str, float]]:
    """Of guides beside an axis, and of driving blocks."""
    for datum in given(name).given.data:
        if re.fullmatch(r"[xy]_\w|s_\d", datum.symbol) and abs(datum.si) > 1e-6:
            yield datum.symbol, abs(datum.si)


def beside(name: str) -> Iterator[tuple[str, float]]:
    """Offsets of pins from guides, as words tell them, with their letters (m)."""
    for datum in given(name).given.data:
        for letter, text in re.findall(r"^offset \$(e\S*)\$ = ([\d.]+) mm \(\$\w\$ to the", datum.of("en")):
            yield letter, 1e-3 * float(text)


@each(Later(lambda: [name for name in IDS if any(radii(name))]))
def test_the_radius_of_every_wheel_and_disc_is_drawn_to_its_rim(name: str) -> None:
    figure = sketch(name)
    round_marks = [m for m in figure.marks if isinstance(m, Arc | Disc | GearMark)]
    arrows = [m for m in figure.marks if isinstance(m, Vector)]
    for symbol, size in radii(name):
        like = [m for m in round_marks if m.radius * figure.scale.value == pytest.approx(size, rel=2e-3)]
        assert symbol in letters(figure), symbol
        assert any(abs(abs(arrow.b - m.centre) - m.radius) < 1e-6 for m in like for arrow in arrows), symbol


@each(Later(lambda: [name for name in IDS if any(coordinates(name))]))
def test_every_guide_beside_an_axis_and_every_driving_block_is_dimensioned(name: str) -> None:
    figure = sketch(name)
    for symbol, size in coordinates(name):
        assert symbol in letters(figure), symbol
        assert any(one == pytest.approx(size, rel=1e-6) for one in sizes(figure)), symbol


@each(Later(lambda: [name for name in IDS if any(OFF.search(datum.of("en")) for datum in given(name).given.data)]))
def test_a_point_that_is_set_off_from_a_bar_has_both_lengths(name: str) -> None:
    figure = sketch(name)
    for datum in given(name).given.data:
        if (found := OFF.search(datum.of("en"))) is not None:
            for text in found.groups():
                assert text in letters(figure), text
                assert any(one == pytest.approx(1e-3 * float(text), rel=1e-4) for one in sizes(figure)), text


def test_a_cam_with_a_roller_has_the_base_circle_of_its_pitch_curve() -> None:
    figure, sizes = sketch("cam-moves-roller"), []
    for mark in figure.marks:
        if isinstance(mark, Arc) and abs(mark.sweep) > 6:
            sizes.append(mark.radius * figure.scale.value)
    assert any(radius == pytest.approx(0.050, rel=1e-3) for radius in sizes) and "r_0" in letters(figure)


@each(Later(lambda: [name for name in LIBRARY if isinstance(given(name).subject, FieldBalancing)]))
def test_the_radii_of_weights_and_the_angles_of_those_that_are_not_at_nought_stand_on_the_rotor(name: str) -> None:
    figure, device = sketch(name), given(name).subject
    assert isinstance(device, FieldBalancing)
    named = {part for label in letters(figure) for part in label.split(", ")}
    assert {"r_t", "r_b"} <= named
    angles = {m.label: m.sweep for m in figure.marks if isinstance(m, AngleMark)}
    for i, trial in enumerate(device.trials, 1):
        symbol = f"θ_{{t{i}}}" if len(device.trials) > 1 else "θ_t"
        assert not trial.at.si or angles[symbol] == pytest.approx(trial.at.si % (2 * pi)), symbol


@pytest.mark.parametrize("name", ["engine-single", "engine-single-best"])
def test_an_engine_has_its_sizes_and_the_rod_s_centre_of_mass(name: str) -> None:
    figure = sketch(name)
    at = {mark.label: mark.at for mark in figure.marks if isinstance(mark, Point)}
    assert {"r", "l", "r_c", "S_2"} <= set(at)
    assert abs(at["S_2"] - at["B"]) * figure.scale.value == pytest.approx(0.060, rel=1e-4)


@each(Later(lambda: [name for name in IDS if any(beside(name))]))
def test_the_offset_of_a_pin_from_its_guide_is_drawn(name: str) -> None:
    figure = sketch(name)
    for letter, size in beside(name):
        assert letter in letters(figure) and any(one == pytest.approx(size, rel=1e-4) for one in sizes(figure)), size


def test_the_line_of_an_offset_guide_bar_has_its_way_from_the_pivot() -> None:
    figure = sketch("8-3c")
    assert "e" in letters(figure) and any(size == pytest.approx(0.023, rel=1e-4) for size in sizes(figure))


def test_the_offset_of_a_slider_has_one_name() -> None:
    assert "e" in letters(sketch("8-3b")) and "y_C" not in letters(sketch("8-3b"))


@each(Later(lambda: [name for name in LIBRARY if isinstance(given(name).subject, Rotor)]))
def test_the_arm_of_every_mass_of_a_rotor_has_the_letter_of_its_radius_at_its_middle(name: str) -> None:
    rotor = given(name).subject
    assert isinstance(rotor, Rotor)
    views = [one for one in drawn(name).construction.figures if one.view.name == "end-view" and not one.name]
    for view in views:
        at = {mark.label: mark.at for mark in view.marks if isinstance(mark, Point)}
        for which, mass in rotor.masses.items():
            size = 0.0 if mass.r is None else mass.r.si / view.scale.value
            if size > 10.0 and "at" not in mass.unknown:
                turn = phase(at[f"r_{{{which}}}"] / at[f"m_{{{which}}}"])
                assert abs(turn) < 1e-6 and 0.25 < abs(at[f"r_{{{which}}}"]) / size < 0.5, which
    assert all(mass.r is None for mass in rotor.masses.values()) or views
