"""What a synthesis is given stands on its sketch: a linkage with all its pins, the axes and lines of coordinates."""

from __future__ import annotations

import re

import pytest

import vecpoly
from tests.drawn_library import IDS, drawn, given
from tests.each import Later, each
from tests.report.test_statement_figures import letters, pictured, plain
from vecpoly.board.paper.marks import AngleMark, Dot, GearMark, Point, Role, Segment, Vector
from vecpoly.designs.base import Design
from vecpoly.designs.inversion.cognates import Cognates
from vecpoly.designs.inversion.positions import Positions
from vecpoly.devices.dynamics.reduced import ReducedTrain
from vecpoly.report.picture import picture

PLACED = Later(lambda: [name for name in IDS if isinstance(given(name).subject, Positions)])
DESIGNS = Later(lambda: [name for name in IDS if isinstance(given(name).subject, Design)])
_ANGLE = re.compile(r"-?[\d.]+ deg")


@each(PLACED)
def test_positions_stand_beside_the_axes_of_their_coordinates(name: str) -> None:
    shown = pictured(name)
    assert shown is not None and {"x", "y"} <= letters([shown])
    axes = [mark for mark in shown.marks if isinstance(mark, Vector) and abs(mark.a) < 1e-9]
    assert len([axis for axis in axes if axis.b.imag == 0 or axis.b.real == 0]) >= 2


@each(PLACED)
def test_a_line_on_which_a_pivot_is_to_lie_is_drawn_where_it_is_with_the_letter(name: str) -> None:
    shown, subject = pictured(name), drawn(name).problem.subject
    assert shown is not None and isinstance(subject, Positions)
    for symbol, text in subject.given():
        if (found := re.fullmatch(r"([xy])_\{?([AD])\}?", symbol)) is None:
            continue
        at = float(text.removesuffix(" mm")) * 1e-3 / shown.scale.value
        lines = [m for m in shown.marks if isinstance(m, Segment) and m.role is Role.CENTRE]
        ends = [(m.a.real, m.b.real) if found[1] == "x" else (m.a.imag, m.b.imag) for m in lines]
        assert any(max(abs(one - at), abs(other - at)) < 0.01 for one, other in ends)
        assert any(found[2] in text.split(", ") for text in letters([shown]))


def test_a_linkage_of_which_cognates_are_sought_is_given_whole() -> None:
    shown = pictured("cognates")
    assert isinstance(drawn("cognates").problem.subject, Cognates) and shown is not None
    assert set("ABCDE") <= letters([shown]) and not set("FGHMN") & letters([shown])
    assert {"l_AB", "l_BC", "l_CD", "l_AD", "φ"} <= letters([shown])


@each(DESIGNS)
def test_a_pin_between_two_given_bars_stands_on_the_sketch_with_its_letter(name: str) -> None:
    """Of the four-bar to which a rocker is added, C in the first position."""
    shown, subject = pictured(name), drawn(name).problem.subject
    if shown is None or not isinstance(subject, Design):
        return
    here = {mark.label[0] for mark in shown.marks if isinstance(mark, Point) and mark.dot is Dot.JOINT and mark.label}
    bars = [plain(symbol)[2:] for symbol, _ in subject.given() if re.fullmatch(r"l_[A-Z]{2}", plain(symbol))]
    for letter in {letter for bar in bars for letter in bar}:
        ends = {end for bar in bars if letter in bar for end in bar if end != letter}
        if len(ends) > 1 and ends <= here:
            assert letter in here, letter


def test_the_known_four_bar_is_drawn_before_a_rocker_is_added() -> None:
    shown = pictured("8-12")
    assert shown is not None and {"A", "B_1", "C_1", "D", "l_BC", "l_CD"} <= letters([shown])
    assert "C_2" not in letters([shown]) and "E_1" not in letters([shown])


@each(DESIGNS)
def test_a_single_angle_of_a_link_on_the_frame_is_marked_on_the_sketch(name: str) -> None:
    shown, subject = pictured(name), drawn(name).problem.subject
    if shown is None or not isinstance(subject, Design):
        return
    pivots = {mark.label for mark in shown.marks if isinstance(mark, Point)}
    marked = {plain(mark.label) for mark in shown.marks if isinstance(mark, AngleMark)}
    for symbol, text in subject.given():
        if symbol in ("φ", "φ_1", "ψ_1") and _ANGLE.fullmatch(text) and {"A", "D"} <= pivots:
            assert symbol in marked, (symbol, text)


def test_a_face_that_all_but_passes_its_pivot_has_no_way_d_to_be_told_on_the_sketch() -> None:
    text = vecpoly.load("cam-flat-arm").text
    for face, told in (("1 mm", False), ("6 mm", True)):
        problem = vecpoly.loads(re.sub(r"face: [^,}]*", f"face: {face}", text))
        drawn = picture(problem, problem.solve(by="exact").construction, 90.0, 60.0)
        assert drawn is not None and any(getattr(mark, "label", "") == "d" for mark in drawn.marks) is told


@pytest.mark.parametrize(
    ("name", "pins", "sizes"),
    [
        ("8-3a", "ABCD", {"l_AB", "l_BC", "l_CD", "l_AD"}),
        ("8-3b", "ABC", {"l_AB", "l_BC", "e"}),
        ("8-3c", "ABC", {"l_AB", "l_AC"}),
    ],
)
def test_a_linkage_whose_limits_are_sought_is_sketched_between_them(name: str, pins: str, sizes: set[str]) -> None:
    shown = pictured(name)
    assert shown is not None and {*pins} <= letters([shown]) and sizes <= letters([shown])
    assert not {"φ_1", "ω_1"} & letters([shown])
    at = {mark.label: mark.at for mark in shown.marks if isinstance(mark, Point)}
    crank = at["B"] - at["A"]
    others = [at[pin] - at["B"] for pin in pins[2:]]
    assert all(abs((crank.conjugate() * other).imag) > 0.2 * abs(crank) * abs(other) for other in others)


@pytest.mark.parametrize("name", ["hoist", "7-2a", "7-3"])
def test_pitch_circles_that_mesh_touch_on_the_sketch_of_a_train(name: str) -> None:
    """As large as their teeth tell: a least radius made wheels of 20 and 80 teeth overlap."""
    shown = pictured(name)
    subject = drawn(name).problem.subject
    assert shown is not None and isinstance(subject, ReducedTrain)
    wheels = {(m.centre.real, m.centre.imag, m.radius) for m in shown.marks if isinstance(m, GearMark)}
    for pair in subject.pairs:
        if not pair.belt:
            share = pair.sizes[0] / pair.sizes[1]
            assert any(
                abs(abs(complex(a, b) - complex(x, y)) - r - s) < 1e-3 and abs(r / s - share) < 1e-3
                for a, b, r in wheels
                for x, y, s in wheels
            )
