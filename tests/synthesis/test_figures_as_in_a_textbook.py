"""The figures of a synthesis are drawn as in a textbook: pivots on their ground, sliders on hatched guides, angles with
arcs and values, the positions that are not thick in dashes."""

from __future__ import annotations

from collections.abc import Iterator

import pytest

from tests.drawn_library import IDS, Drawn, drawn, given
from tests.each import Later, each
from vecpoly.algebra.quantity import number
from vecpoly.algebra.rounding import in_tenths
from vecpoly.board.construction import Figure
from vecpoly.board.paper.marks import AngleMark, Arc, Block, FixedGuide, Ground, Mark, Point, Role, Segment
from vecpoly.designs.base import Design
from vecpoly.drawing.figure import drawing
from vecpoly.drawing.labels.want import Thing
from vecpoly.drawing.sheets.sheet import Placed, Sheet, sheets
from vecpoly.printed.digits import drawn_number

DESIGNS = Later(lambda: (name for name in IDS if isinstance(given(name).subject, Design)))
FULL = 2.0  # mm: a shorter line tells nothing
ANGLES = ("theta", "psi", "gamma_min", "alpha_max")


def _marks(one: Drawn) -> list[Mark]:
    return [mark for figure in one.construction.figures for mark in figure.marks]


def _angles(one: Drawn) -> list[AngleMark]:
    return [mark for mark in _marks(one) if isinstance(mark, AngleMark)]


@each(DESIGNS)
def test_a_figure_with_links_has_its_fixed_pivots_on_ground(name: str) -> None:
    if all(len(candidate.pins) < 2 for candidate in drawn(name).construction.candidates):
        return  # lengths beside each other, and no linkage
    for figure in drawn(name).construction.figures:
        if any(isinstance(mark, Segment) and mark.role is Role.LINK for mark in figure.marks):
            assert any(isinstance(mark, Ground) for mark in figure.marks), figure.name


@each(DESIGNS)
def test_an_angle_that_is_asked_stands_in_a_figure_with_an_arc_and_the_value_of_the_answer(name: str) -> None:
    one = drawn(name)
    for key, answer in one.solution.answers.items():
        if key.rstrip("_123456789") not in ANGLES or not answer.drawn or answer.undefined:
            continue
        told = {drawn_number(answer), in_tenths(answer.drawn)}  # as the protractor shows it, or as it was computed
        told |= {
            in_tenths(90.0 - answer.drawn),
            number(90.0 - answer.drawn),
        }  # of γ_min = 90° − α_max the pressure angle is marked
        ends = tuple(f" = {value}°" for value in told)
        assert any(mark.label.endswith(ends) for mark in _angles(one)), (key, ends)


@each(DESIGNS)
def test_an_arc_is_as_wide_as_the_angle_written_beside_it(name: str) -> None:
    for mark in _angles(drawn(name)):
        if " = " in mark.label and mark.label.endswith("°"):
            written = abs(
                float(mark.label.rpartition(" = ")[2].rstrip("°").replace("−", "-"))
            )  # clockwise is less than 0
            assert abs(abs(mark.sweep) * 57.29577951308232 - min(written, 360.0 - written)) < 0.06, mark.label


@each(DESIGNS)
def test_links_are_thick_in_one_position_and_dashed_in_the_others_and_in_thin_dashes_where_rejected(name: str) -> None:
    one = drawn(name)
    valid = [candidate for candidate in one.construction.candidates if candidate.reason is None]
    shared = {place for candidate in valid for place in candidate.pins.values()}
    for candidate in one.construction.candidates:
        for before, after in (("A", "B"), ("B", "C"), ("C", "D")):
            for n in "234":
                ends = (candidate.pins.get(before, candidate.pins.get(before + n)), candidate.pins.get(after + n))
                if ends[0] is None or ends[1] is None or abs(ends[1] - ends[0]) < FULL:
                    continue
                roles = {
                    mark.role
                    for mark in one.construction.figures[0].marks
                    if isinstance(mark, Segment) and {_near(mark.a, ends), _near(mark.b, ends)} == {0, 1}
                }
                of_a_valid_one = candidate in valid or set(ends) <= shared
                told = {Role.OTHER, Role.LINK, Role.SECOND} if of_a_valid_one else {Role.HIDDEN}
                assert not roles or roles & told, (candidate.number, before, after, n, roles)


def _near(at: complex, ends: tuple[complex | None, complex | None]) -> int:
    return next((n for n, end in enumerate(ends) if end is not None and abs(at - end) < 1e-6), -1)


@pytest.mark.parametrize("name", ["8-3b", "8-9", "8-10", "8-13", "8-16", "8-17"])
def test_a_slider_is_a_block_on_a_hatched_guide(name: str) -> None:
    marks = _marks(drawn(name))
    blocks = [mark for mark in marks if isinstance(mark, Block)]
    guides = [mark for mark in marks if isinstance(mark, FixedGuide)]
    assert blocks and guides
    for guide in guides:
        along = (guide.b - guide.a) / abs(guide.b - guide.a)
        assert any(0 < ((block.at - guide.a) * along.conjugate()).imag < 5 for block in blocks)


@pytest.mark.parametrize("name", ["8-3a", "8-3b"])
def test_crank_and_coupler_are_as_long_in_one_limit_as_in_the_other(name: str) -> None:
    at = {mark.label: mark.at for mark in _marks(drawn(name)) if isinstance(mark, Point) and mark.label}
    assert abs(at["B_1"] - at["A"]) == pytest.approx(abs(at["B_2"] - at["A"]))
    assert abs(at["C_1"] - at["B_1"]) == pytest.approx(abs(at["C_2"] - at["B_2"]))


@pytest.mark.parametrize("name", ["8-3a", "8-3b", "8-3c", "8-4", "8-5", "8-15", "8-16", "8-17", "drag-link"])
def test_the_pin_of_a_crank_goes_round_on_a_dash_dotted_circle(name: str) -> None:
    rounds = [mark for mark in _marks(drawn(name)) if isinstance(mark, Arc) and mark.role is Role.CENTRE]
    grounds = [mark.at for mark in _marks(drawn(name)) if isinstance(mark, Ground)]
    assert rounds and all(min(abs(one.centre - at) for at in grounds) < 1e-6 for one in rounds)


TWO = ["K-crank-rocker-AD", "K-crank-rocker-BC", "8-15"]


@each([name for name in TWO if name != "K-crank-rocker-BC"])
def test_two_solutions_stand_one_below_the_other_each_beside_its_transmission_angles(name: str) -> None:
    (sheet,) = sheets(drawn(name).construction)
    at = {one.title.en.partition(" (")[0][:5] + one.title.en[-2]: place.extents for one, place in _titled(sheet)}
    assert set(at) == {"Synth1", "Synth2", "Minim1", "Minim2"}
    for n in "12":
        assert at[f"Synth{n}"].x1 < at[f"Minim{n}"].x0 and at[f"Minim{n}"].y0 < at[f"Synth{n}"].y1
    assert at["Synth2"].y1 < at["Synth1"].y0 and at["Minim2"].y1 < at["Minim1"].y0


def test_two_solutions_that_no_whole_circle_buries_are_one_figure_beside_their_transmission_angles() -> None:
    (sheet,) = sheets(drawn("K-crank-rocker-BC").construction)
    assert [one.title.en[-12:] for one, _ in [*_titled(sheet)][1:]] == ["(solution 1)", "(solution 2)"]


@each([*TWO, "K-crank-rocker-line"])
def test_a_figure_of_transmission_angles_is_larger_where_its_links_were_short_and_none_else(name: str) -> None:
    main, *angles = drawn(name).construction.figures
    for figure in angles:
        assert figure.scale.value <= main.scale.value / 1.25 and figure.scale.symbol != main.scale.symbol
        pins = [mark.at for mark in figure.marks if isinstance(mark, Point) and mark.label[0] in "ABCD"]
        assert 40.0 < max(abs(a - b) for a in pins for b in pins) < 90.0
    assert any("μ_l′" in step.words.zh for step in drawn(name).construction.steps)
    shared = drawn("8-4").construction.figures  # of which the sheet's scale is large enough
    assert len({figure.scale.value for figure in shared}) == 1


@each(TWO)
def test_transmission_angles_stand_with_their_values_for_whose_sake_their_figure_is_drawn(name: str) -> None:
    angles = drawn(name).construction.figures[1:]
    for figure in angles:
        labels = drawing(figure, lang="zh").labels
        widths = [label.want.width for label in labels if label.want.thing is Thing.ARC]
        assert len(widths) == 2 and min(widths) > 15.0, (figure.name, widths)  # γ″⁽²⁾ alone is 7 mm wide


def _titled(sheet: Sheet) -> Iterator[tuple[Figure, Placed]]:
    return ((one.figure, one) for one in sheet.figures if one.figure is not None)
