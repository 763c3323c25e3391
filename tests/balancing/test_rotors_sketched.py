"""What the views of a rotor show: every plane on its shaft; each plane from its end, with the parts that fall to it."""

from __future__ import annotations

import re
from cmath import rect
from math import sin

import pytest

from tests.drawn_library import LIBRARY, drawn, given
from tests.each import Later, each
from vecpoly.board.construction import Figure, View
from vecpoly.board.paper.marks import Arc, Disc, Point, Role, Segment
from vecpoly.devices.balancing.rotor import Rotor
from vecpoly.drawing.figure import drawing
from vecpoly.methods.devices.rotor.views.along import LOW

CLOSED = ("6-3a", "6-3b", "6-4", "6-7")  # two planes, masses with radii


def view(name: str, title: str) -> Figure:
    return next(figure for figure in drawn(name).construction.figures if figure.title.zh == title)


def rotor(name: str) -> Rotor:
    device = drawn(name).problem.device
    assert isinstance(device, Rotor)
    return device


def points(figure: Figure) -> dict[str, complex]:
    return {mark.label: mark.at for mark in figure.marks if isinstance(mark, Point)}


@pytest.mark.parametrize("name", [*CLOSED, "6-5", "rotor-grade"])
def test_every_plane_stands_on_the_shaft_where_it_is_with_its_name_the_one_of_the_check_too(name: str) -> None:
    told, figure = rotor(name), drawn(name).construction.figure(View.MECHANISM)
    assert figure is not None
    upright = {round(m.a.real, 6) for m in figure.marks if isinstance(m, Segment) and abs((m.b - m.a).real) < 1e-9}
    corrected = {plane.at for plane in told.correct.values()}
    own = {number: mass.place for number, mass in told.masses.items() if mass.place not in corrected}
    middle = (max(told.stations) + min(told.stations)) / 2
    places = {end: plane.at for end, plane in told.correct.items()} | own | {"P": middle}
    for letter, place in places.items():
        at = (place - min(told.stations)) / figure.scale.value
        assert points(figure)[letter].real == pytest.approx(at) and round(at, 6) in upright


@pytest.mark.parametrize("name", CLOSED)
def test_a_plane_seen_from_its_end_has_the_parts_of_the_masses_where_these_are_and_what_balances_it(name: str) -> None:
    told = rotor(name)
    for end, shares in told.shares.items():
        figure = view(name, f"平面 ${end}$ 端视图")
        seen, mm = points(figure), figure.scale.value
        there = {number for number, share in shares.items() if abs(share) > 1e-9}
        assert {f"m_{{{number}{end}}}" for number in there} | {"O", "x", f"m_{{b{end}}}"} >= set(seen)
        for number in there:
            mass = told.masses[number]
            assert mass.r is not None
            assert seen[f"m_{{{number}{end}}}"] == pytest.approx(rect(mass.r.si / mm, mass.at.si))


@each(Later(lambda: [name for name in LIBRARY if _is_long_rotor(name)]))
def test_along_the_axis_a_mass_stands_on_the_side_of_its_angle_and_one_whose_angle_is_sought_nowhere(name: str) -> None:
    told, figure = rotor(name), drawn(name).construction.figure(View.MECHANISM)
    assert figure is not None
    seen, mm, left = points(figure), figure.scale.value, min(told.stations)
    radii = [mass.r.si for mass in told.masses.values() if mass.r is not None]
    for number, mass in told.masses.items():
        at = next(
            (seen[label] for label in (f"m_{{{number}}}", f"W_{{{number}}}", f"U_{{{number}}}") if label in seen), None
        )
        if "at" in mass.unknown:
            assert at is None
            assert number in seen, "its plane is there"
            continue
        assert at is not None and at.real == pytest.approx((mass.place - left) / mm)
        side = sin(mass.at.si)
        assert abs(at.imag) < 1e-6 if abs(side) < 1e-9 else at.imag * side > 0
        if mass.r is not None and max(radii) / mm >= LOW:
            assert at.imag == pytest.approx(mass.r.si * side / mm)


def _is_long_rotor(name: str) -> bool:
    device = given(name).subject
    return isinstance(device, Rotor) and device.length > 0


def test_a_part_that_counts_as_negative_is_drawn_as_a_ring_like_a_hole() -> None:
    figure = view("6-7", "平面 $I$ 端视图")
    assert rotor("6-7").shares["I"]["1"] < 0
    rings = [m.centre for m in figure.marks if isinstance(m, Arc) and m.role is Role.HIDDEN]
    discs = [m.centre for m in figure.marks if isinstance(m, Disc)]
    seen = points(figure)
    assert rings == [pytest.approx(seen["m_{1I}"])]
    assert discs == [pytest.approx(seen["m_{2I}"]), pytest.approx(seen["m_{3I}"])]


def test_both_answers_of_dalby_are_seen_from_their_end_mirrored() -> None:
    one, other = (points(view("rotor-dalby", f"端视图（解 {which}）")) for which in (1, 2))
    assert set(one) == set(other) == {"O", "x", *(f"m_{{{name}}}" for name in "ABCD")}
    for letter, at in one.items():
        assert other[letter] == pytest.approx(at.conjugate(), abs=1e-6)


def test_an_end_view_of_products_alone_claims_no_scale_and_calls_them_as_the_polygons_do() -> None:
    for name in ("6-5", "rotor-grade"):
        figure = view(name, "端视图（示意）")
        assert not figure.scale.symbol
        named = {getattr(mark, "label", "") for mark in figure.marks if getattr(mark, "key", "").startswith(("W", "U"))}
        assert named <= {f"W_{{{number}}}" for number in rotor(name).masses}


@pytest.mark.parametrize("name", [*CLOSED, "6-5", "rotor-dalby"])
def test_the_letters_of_distances_stand_over_their_lines(name: str) -> None:
    figure = drawn(name).construction.figure(View.MECHANISM)
    assert figure is not None
    lengths = [label for label in drawing(figure).labels if label.want.own[0] != label.want.own[1]]
    assert lengths
    for label in lengths:
        assert label.foot is None and 0 < label.centre.imag - label.want.own[0].imag < 4


@pytest.mark.parametrize("name", ["6-4", "6-5", "6-7", "rotor-dalby", "engine-four"])
def test_the_names_of_planes_stand_in_line_with_them(name: str) -> None:
    figure = drawn(name).construction.figure(View.MECHANISM)
    assert figure is not None
    tops = {m.b for m in figure.marks if isinstance(m, Segment) and m.role in (Role.CENTRE, Role.HIDDEN)}
    names = [label for label in drawing(figure).labels if label.want.own[0] in tops]
    assert len(names) > 2
    for label in names:
        at = label.want.own[0]
        assert abs(label.centre.real - at.real) < 0.1 and 0 < label.centre.imag - at.imag < 4


@pytest.mark.parametrize("name", ["6-2", "6-4", "6-7", "rotor-grade", "rotor-dalby"])
def test_the_distance_by_which_a_product_is_multiplied_is_told_where_it_is_named(name: str) -> None:
    """Dalby's couples were W z, and those with l < 0 were reversed, though no mass lay left of the plane."""
    told = [
        step.words for step in drawn(name).construction.steps if re.search(r"\$W [lz]\$|\$[lz]\$ < 0", step.words.zh)
    ]
    assert told
    for words in told:
        assert "$l$" not in words.zh or ("$l$ 为" in words.zh and "$l$: distance" in words.en), words.zh
        assert name != "rotor-dalby" or "< 0" not in words.zh
