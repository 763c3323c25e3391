"""A drawing is judged vector by vector: right in every format, wrong with its reason."""

from __future__ import annotations

from cmath import exp, pi
from dataclasses import replace
from itertools import product

import pytest

from tests.grading.drawings.made import (
    FORMATS,
    by_pencil,
    changed,
    drawn,
    in_another_order,
    key_of,
    marked,
    put,
    through,
    verdicts,
    with_points,
    with_slip,
)
from tests.laws import few
from vecpoly.grading.allowance import STUDENT
from vecpoly.grading.drawings.judging.mark import Basis, Verdict
from vecpoly.grading.drawings.segment import Drawing, Label, Segment

SEVERAL = ("3-9", "3-12", "A-27", "3-7a", "4-3a", "4-5")  # two six-bars, two with force polygons
FAIR = (Verdict.RIGHT, Verdict.CLOSE)


@pytest.mark.parametrize(("problem", "kind"), few([*product(SEVERAL, FORMATS)], 7))
def test_an_honest_drawing_is_right_in_every_format(problem: str, kind: str) -> None:
    key = key_of(problem)
    mark = marked(key, through(drawn(key.exact), kind))
    assert [one for one in mark.vectors if one.verdict is not Verdict.RIGHT] == []
    assert mark.right and mark.slips == () and not any(one.remarks or one.extra for one in mark.figures)


@pytest.mark.parametrize("problem", few(["3-9", "3-12", "4-3a"], 2))
def test_a_pencil_stays_within_what_students_are_allowed(problem: str) -> None:
    key = key_of(problem, STUDENT)
    marks = [one for seed in range(3) for one in marked(key, by_pencil(key, seed)).vectors]
    fair = sum(one.verdict in FAIR for one in marks)
    assert fair / len(marks) >= 0.95


@pytest.mark.parametrize("problem", few(SEVERAL, 4))
def test_another_order_of_addition_is_as_right(problem: str) -> None:
    mark = marked(key_of(problem), in_another_order(key_of(problem)))
    assert all(one.verdict is Verdict.RIGHT for one in mark.vectors) and mark.right


@pytest.mark.parametrize("problem", few(["3-9", "A-27"], 2))
def test_a_mistake_is_named_though_the_line_of_a_resultant_is_left_out(problem: str) -> None:
    """p'b3' is not drawn by everybody: its points are there by the other lines."""
    key, tried = key_of(problem), 0
    for slip, world in few(key.worlds, 30):
        whole = drawn(world)
        if marked(key, whole, declared=True).slip != slip:
            continue
        for line in whole.segments:
            others = [one for one in whole.segments if one is not line]
            ends = [end for one in others for end in (one.start, one.end)]
            loose = "mechanism" in line.where or not all(
                any(abs(end - z) < 1e-9 for z in ends) for end in (line.start, line.end)
            )
            if not loose:
                tried += 1
                assert slip in marked(key, replace(whole, segments=tuple(others)), declared=True).slips, line.where
    assert tried


@pytest.mark.parametrize("problem", few(["3-9", "3-7a", "4-3a"], 3))
def test_every_slip_that_is_drawn_is_caught_and_most_are_named(problem: str) -> None:
    key = key_of(problem)
    marks = [
        (slip, marked(key, drawn(world), declared=True))
        for slip, world in (few(key.worlds, 4) if len(key.worlds) >= 20 else key.worlds)
    ]
    assert [str(slip) for slip, mark in marks if mark.right] == []
    assert [str(slip) for slip, mark in marks if mark.slip not in (None, slip)] == []
    assert sum(mark.slip == slip for slip, mark in marks) >= 0.8 * len(marks)


def test_a_vector_of_the_wrong_length_is_the_only_one_and_what_follows_is_right_by_itself() -> None:
    key = key_of("3-9")
    mark = marked(key, drawn(with_slip(key, "ak_C2C3 halved")))
    by_key = {one.key: one for one in mark.vectors}
    assert [one.key for one in mark.vectors if one.verdict is Verdict.WRONG] == ["ak_C2C3"]
    assert by_key["at_C2B"].basis is by_key["a_E"].basis is Basis.OWN
    assert "应为" in by_key["ak_C2C3"].reason.zh and "should be" in by_key["ak_C2C3"].reason.en


def test_a_velocity_is_held_against_the_own_diagram() -> None:
    key = key_of("3-12")
    crank = next(one.at for one in key.exact.shapes[0].vertices if one.letters == ("B",))
    own = with_points(key, B=crank * 1.005 * exp(0.05j))
    mark = marked(key, drawn(own))
    assert marked(key, drawn(own, diagram=False))["velocity"]["v_B"].verdict is Verdict.WRONG
    assert all(one.verdict in FAIR for one in mark["velocity"].vectors)
    assert mark["velocity"]["v_B"].basis is Basis.OWN


def test_a_reversed_arrow_is_told_apart_from_a_wrong_vector() -> None:
    key = key_of("3-9")
    mark = marked(key, changed(drawn(key.exact), "velocity:v_C2B", Segment.turned))
    wrong = [one for one in mark.vectors if one.verdict is not Verdict.RIGHT]
    assert [(one.key, one.sense, one.length, one.direction) for one in wrong] == [
        ("v_C2B", False, Verdict.RIGHT, Verdict.RIGHT)
    ]
    assert "由 b 指向 c2" in wrong[0].reason.zh


def test_a_vector_without_its_arrow_among_others_that_have_theirs_is_told() -> None:
    key = key_of("3-9")
    mark = marked(key, changed(drawn(key.exact), "velocity:v_C2B", lambda one: replace(one, headed=False)))
    assert mark["velocity"]["v_C2B"].sense is None and "箭头" in mark["velocity"]["v_C2B"].reason.zh


def test_a_direction_that_is_off_is_told_in_degrees() -> None:
    key = key_of("3-9")
    mark = marked(key, changed(drawn(key.exact), "velocity:v_E", _leaning))
    one = mark["velocity"]["v_E"]
    assert (one.verdict, one.length, one.direction) == (Verdict.WRONG, Verdict.RIGHT, Verdict.WRONG)
    assert one.turned == pytest.approx(6.0, abs=0.1)


def _leaning(one: Segment) -> Segment:
    return replace(one, end=one.start + one.along * exp(1j * pi / 30))


def test_missing_extra_and_doubled_lines_are_told() -> None:
    key = key_of("3-9")
    whole = drawn(key.exact)
    mark = marked(key, changed(whole, "acceleration:a_D", lambda one: None))
    assert [one.key for one in mark.vectors if one.verdict is Verdict.MISSING] == ["a_D"]
    stray = Segment(start=APART_POLE, end=APART_POLE + (12 + 31j), headed=True, where="stray")
    assert [one.where for one in marked(key, _with(whole, stray))["velocity"].extra] == ["stray"]
    assert len(marked(key, _with(whole, whole.segments[-1])).twice) == 1


def test_a_line_that_is_missing_is_told_whole_as_it_should_be_and_for_all_that_it_stands_for() -> None:
    key = key_of("3-9")
    whole = {(shape.name, edge.key): edge for shape in key.exact.shapes for edge in shape.edges}
    for name in ("velocity:v_D", "acceleration:a_D", "velocity:v_C2B"):
        figure, quantity = name.split(":")
        one = marked(key, changed(drawn(key.exact), name, lambda line: None))[figure][quantity]
        edge = whole[figure, quantity]
        assert (one.verdict, one.length, one.direction, one.sense) == (*[Verdict.MISSING] * 3, None)
        assert (one.own, one.should, one.tail, one.keys) == (None, edge.along, edge.a, edge.keys)
        assert one.allowed == key.allowed[figure, quantity].mm > 0 and one.costs
        assert one.reason.zh and one.reason.en


APART_POLE = 300 + 0j  # where made.py has the pole of the velocity polygon


def _with(drawing: Drawing, *more: Segment) -> Drawing:
    return replace(drawing, segments=(*drawing.segments, *more))


def test_a_gap_is_measured_on_the_sheet() -> None:
    key = key_of("3-9")
    ajar = changed(drawn(key.exact), "velocity:v_C2B", lambda one: replace(one, start=one.start + 3, end=one.end + 3))
    mark = marked(key, ajar)
    assert mark["velocity"].gap == pytest.approx(3.0, abs=0.01)
    assert any("不封闭" in words.zh for words in mark["velocity"].remarks)


def test_an_image_turned_over_is_named() -> None:
    key = key_of("3-9")
    shape = key.exact.shape("velocity")
    assert shape is not None
    b, d, e = shape.images[1]
    flipped = b + ((e - b) / (d - b)).conjugate() * (d - b)
    mark = marked(key, changed(drawn(key.exact), "velocity:v_E", lambda one: replace(one, end=one.start + flipped)))
    assert mark["velocity"]["v_E"].verdict is Verdict.WRONG
    assert any("字母顺序" in words.zh and "bde" in words.zh for words in mark["velocity"].remarks)


def test_letters_at_each_others_points_are_told_and_letters_at_their_own_are_not() -> None:
    key = key_of("3-9")
    shape = key.exact.shape("velocity")
    assert shape is not None
    at = {letter: one.at + APART_POLE + (1 + 1j) for one in shape.vertices for letter in one.letters}
    right = tuple(Label(text=letter, at=z) for letter, z in at.items())
    swapped = tuple(Label(text={"d": "e", "e": "d"}.get(one.text, one.text), at=one.at) for one in right)
    assert marked(key, replace(drawn(key.exact), labels=right))["velocity"].remarks == ()
    told = marked(key, replace(drawn(key.exact), labels=swapped))["velocity"].remarks
    assert [words.en for words in told] == ["the letter e stands at the point d", "the letter d stands at the point e"]


def test_a_name_is_believed_before_geometry_and_two_exchanged_names_are_told() -> None:
    key = key_of("3-9")
    names = {"v_D": "v_E", "v_E": "v_D"}
    whole = drawn(key.exact, names=True)
    swapped = replace(whole, segments=tuple(replace(one, name=names.get(one.name, one.name)) for one in whole.segments))
    mark = marked(key, swapped)
    assert {one.key for one in mark.vectors if one.verdict is Verdict.WRONG} == {"v_D", "v_E"}
    assert any("exchanged" in words.en for words in mark["velocity"].remarks)


def test_a_drawing_without_heads_is_read_by_the_order_of_its_ends_and_says_so() -> None:
    key = key_of("3-9")
    plain = drawn(key.exact, heads=False)
    mark = marked(key, plain)
    assert mark.right and any("箭头" in words.zh for words in mark.remarks)
    assert marked(key, changed(plain, "velocity:v_D", Segment.turned))["velocity"]["v_D"].sense is False


def test_a_polygon_that_is_not_there_is_told_as_one_thing() -> None:
    key = key_of("3-9")
    lines = tuple(one for one in drawn(key.exact).segments if not one.where.startswith("acceleration"))
    mark = marked(key, Drawing(file="made", segments=lines))
    assert not mark["acceleration"].drawn and mark["velocity"].drawn and not mark.right
    assert {one.figure for one in mark.vectors} == {"velocity"}


@pytest.mark.parametrize("mirror", [-1, 1])
@pytest.mark.parametrize("problem", few(["3-9", "A-27", "4-3a"], 2))
def test_a_mirrored_drawing_is_told_and_not_accepted(problem: str, mirror: int) -> None:
    key = key_of(problem)
    mark = marked(key, put(drawn(key.exact), lambda z: mirror * z.conjugate()))
    assert mark.mirrored and not mark.right
    assert verdicts(mark) == verdicts(marked(key, drawn(key.exact)))


def test_a_sheet_put_out_at_another_size_is_told_where_the_scales_are_declared() -> None:
    key = key_of("3-9")
    mark = marked(key, put(drawn(key.exact), lambda z: 0.97 * z), declared=True)
    assert mark.right and any("0.970" in words.zh for words in mark.remarks)


def test_pieces_of_one_line_are_one_vector() -> None:
    key = key_of("3-9")
    lines: list[Segment] = []
    for one in drawn(key.exact).segments:
        middle = one.start + 0.37 * one.along
        cut = not one.where.startswith("mechanism")
        lines += [replace(one, end=middle, headed=False), replace(one, start=middle)] if cut else [one]
    mark = marked(key, Drawing(file="made", segments=tuple(lines)))
    assert mark.right and not any(one.extra for one in mark.figures)


@pytest.mark.parametrize("turn", [1j, -1, -1j])
@pytest.mark.parametrize("problem", few(["3-9", "3-12", "A-27", "4-3a"], 4))
def test_a_sheet_that_lies_on_its_side_is_held_upright_and_left_to_a_person(problem: str, turn: complex) -> None:
    key = key_of(problem)
    mark = marked(key, put(drawn(key.exact), lambda z: turn * z))
    assert mark.right and not mark.mirrored and abs(mark.turned) == (180.0 if turn == -1 else 90.0)
    assert any("turned by" in words.en for words in mark.told)


def test_polygons_that_are_turned_beside_an_upright_diagram_are_not_held_upright() -> None:
    key = key_of("3-9")
    polygons = put(drawn(key.exact, diagram=False), lambda z: 1j * z)
    diagram = [one for one in drawn(key.exact).segments if one.where.startswith("mechanism:")]
    mark = marked(key, _with(polygons, *diagram))
    assert not mark.right and not mark.turned
