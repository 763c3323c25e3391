"""A line is the vector whose letters stand at its ends, where geometry alone would take it for another."""

from __future__ import annotations

from dataclasses import replace
from itertools import combinations

import pytest

from tests.each import each
from tests.grading.drawings.made import APART, changed, drawn, key_of, marked
from vecpoly.grading.drawings.expected import NOTHING, Expected
from vecpoly.grading.drawings.judging.mark import DrawingMark, Verdict
from vecpoly.grading.drawings.matching.naming import named
from vecpoly.grading.drawings.segment import Drawing, Label, Segment


def exact() -> Expected:
    return key_of("3-9").exact


def lettered(drawing: Drawing, **places: complex) -> Drawing:
    """With a letter 1 mm beside each of these places."""
    labels = tuple(Label(text=letter, at=at + complex(1, 1)) for letter, at in places.items())
    return replace(drawing, labels=labels)


def without_d_and_with_a_short_c2(share: float) -> tuple[Drawing, dict[str, complex]]:
    """v_C2B drawn too short, p-c2 to where it then ends, no p-d: the line p-c2 is nearly as d's should be."""
    shape = next(one for one in exact().shapes if one.name == "velocity")
    b, c2 = shape.edge("v_C2B"), shape.edge("v_C2C3")
    assert b is not None and c2 is not None
    ahead = APART * next(n for n, one in enumerate(exact().shapes) if one is shape)
    end = b.a + share * b.along + ahead
    made = changed(drawn(exact()), "velocity:v_C2B", lambda one: replace(one, end=end))
    made = changed(made, "velocity:v_C2C3", lambda one: replace(one, end=end))
    made = changed(made, "velocity:v_D", lambda one: None)
    return made, {"p": c2.a + ahead, "b": b.a + ahead, "c2": end}


def wrong(mark: DrawingMark) -> dict[str, Verdict]:
    return {one.key: one.verdict for one in mark["velocity"].vectors if one.costs}


def test_a_line_lettered_c2_is_not_taken_for_d() -> None:
    made, places = without_d_and_with_a_short_c2(0.5)
    bare, told = marked(key_of("3-9"), made), marked(key_of("3-9"), lettered(made, **places))
    assert wrong(told) == {"v_C2C3": Verdict.WRONG, "v_D": Verdict.MISSING}  # v_C2B follows from the own c2
    assert wrong(bare) != wrong(told)


def test_letters_that_stand_between_two_points_name_nothing() -> None:
    made, places = without_d_and_with_a_short_c2(0.5)
    between = (places["b"] + places["c2"]) / 2 - complex(1, 1)
    said = lettered(made, **places | {"c2": between, "b": between})
    assert wrong(marked(key_of("3-9"), said)) == wrong(marked(key_of("3-9"), made))


def test_right_lines_need_no_letters_and_wrong_letters_spoil_none() -> None:
    made = drawn(exact())
    ends = {one.where.partition(":")[2]: one.end for one in made.segments if one.where.startswith("velocity")}
    swapped = lettered(made, b=ends["v_E"], e=ends["v_B"])
    assert marked(key_of("3-9"), swapped).right


def test_a_polygon_in_a_mirror_beside_an_upright_diagram_of_which_a_line_is_missing_is_no_mirrored_sheet() -> None:
    made = drawn(exact())
    frame = next(one for one in made.segments if one.where.startswith("mechanism"))

    def over(one: Segment) -> Segment:
        """In a mirror about a level line through the pole."""
        return replace(one, start=one.start.conjugate(), end=one.end.conjugate())

    lines = tuple(over(one) if one.where.startswith("velocity") else one for one in made.segments if one is not frame)
    mark = marked(key_of("3-9"), replace(made, segments=lines))
    assert not mark.mirrored and mark["velocity"].mirrored


@each(("3-9", "boom-thrust"))
def test_each_place_of_a_figure_is_one_with_all_its_letters(name: str) -> None:
    for shape in key_of(name).exact.shapes:
        spots = [one.at for one in shape.vertices]
        assert all(abs(a - b) > NOTHING for a, b in combinations(spots, 2)), shape.name


@pytest.mark.parametrize("name", ["R_41", "F_41", "F41", "f41"])
def test_a_reaction_is_found_by_its_name_whether_it_begins_with_r_or_f(name: str) -> None:
    assert named(name, "", key_of("boom-thrust").exact.shapes) == ("force 1", "R_41")
