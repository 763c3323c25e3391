"""A polygon that is right but for how it lies is wrong in its directions from one cause; its lengths are paid."""

from __future__ import annotations

from dataclasses import replace

import pytest

from tests.grading.cases import key_of as sheet_key
from tests.grading.drawings.made import (
    FORMATS,
    by,
    by_pencil,
    changed,
    drawn,
    key_of,
    lying,
    marked,
    put,
    through,
    with_slip,
)
from tests.laws import few
from vecpoly.grading.allowance import STUDENT
from vecpoly.grading.drawings.expected import Expected
from vecpoly.grading.drawings.judging.mark import DrawingMark, Verdict
from vecpoly.grading.drawings.segment import Segment
from vecpoly.grading.key import NOTHING
from vecpoly.grading.marking.lines import paid_by_lines
from vecpoly.grading.rules import Rules


def exact() -> Expected:
    return key_of("3-9").exact


def costs(mark: DrawingMark) -> list[str]:
    return [f"{one.figure}:{one.key}" for figure in mark.figures for one in figure.vectors if one.costs]


@pytest.mark.parametrize("kind", FORMATS)
@pytest.mark.parametrize("degrees", few([17.0, 90.0, -90.0, 133.0], 4))
def test_a_polygon_turned_as_a_whole_has_right_lengths_and_one_mistake_in_every_format(
    kind: str, degrees: float
) -> None:
    mark = marked(key_of("3-9"), through(lying(exact(), drawn(exact()), velocity=by(degrees)), kind))
    figure = mark["velocity"]
    assert figure.drawn and figure.turned == pytest.approx(degrees, abs=0.05) and not mark.turned and not mark.right
    assert all(one.length is Verdict.RIGHT and one.direction is Verdict.WRONG for one in figure.vectors)
    assert all(one.turned == pytest.approx(degrees, abs=0.05) for one in figure.vectors)
    assert costs(mark) == ["velocity:v_B"] and figure.gap < 0.01 and mark.doubt is figure.doubt is None
    assert all(one.verdict is Verdict.RIGHT for one in mark["acceleration"].vectors)


def test_the_angle_is_told_in_both_languages_and_of_which_cause_the_others_are() -> None:
    figure = marked(key_of("3-9"), lying(exact(), drawn(exact()), velocity=by(17)))["velocity"]
    assert "整个多边形逆时针转过了 17°" in figure.remarks[0].zh and "turned by 17° ccw" in figure.remarks[0].en
    assert "+17.0°" in figure["v_B"].reason.zh and "+17.0°" in figure["v_B"].reason.en
    assert "不重复扣分" in figure["v_E"].reason.zh and "v_{B}" in figure["v_E"].reason.en


@pytest.mark.parametrize("kind", FORMATS)
def test_a_polygon_in_a_mirror_is_one_mistake_in_every_format(kind: str) -> None:
    mirrored = lying(exact(), drawn(exact()), acceleration=lambda z: z.conjugate())
    mark = marked(key_of("3-9"), through(mirrored, kind))
    figure = mark["acceleration"]
    assert figure.mirrored and not mark.mirrored and len(costs(mark)) == 1
    assert all(one.length is Verdict.RIGHT for one in figure.vectors)
    assert "镜像" in figure.remarks[0].zh and "mirror" in figure.remarks[0].en


@pytest.mark.parametrize("kind", FORMATS)
def test_one_polygon_at_another_scale_than_was_told_is_right_and_left_for_a_person_in_every_format(kind: str) -> None:
    key = key_of("3-9")
    mark = marked(key, through(lying(exact(), drawn(key.exact), velocity=lambda z: 0.7 * z), kind), declared=True)
    figure = mark["velocity"]
    assert not costs(mark) and not figure.declared and figure.mu == pytest.approx(0.006 / 0.7, rel=1e-3)
    assert "0.008571" in figure.remarks[0].zh and figure.doubt is not None and mark["acceleration"].declared


@pytest.mark.parametrize("problem", few(["3-9", "4-3a", "A-27", "3-12"], 4))
def test_of_every_polygon_of_a_problem_it_is_told(problem: str) -> None:
    key = key_of(problem)
    for shape in key.exact.shapes:
        if not shape.diagram:
            mark = marked(key, lying(key.exact, drawn(key.exact), **{shape.name: by(40)}), declared=True)
            assert len(costs(mark)) == 1 and mark[shape.name].turned == pytest.approx(40), shape.name


def test_polygons_that_are_turned_alike_have_one_cause_and_those_that_are_not_have_two() -> None:
    whole = drawn(exact())
    alike = marked(key_of("3-9"), lying(exact(), whole, velocity=by(17), acceleration=by(17)))
    apart = marked(key_of("3-9"), lying(exact(), whole, velocity=by(17), acceleration=by(-30)))
    assert costs(alike) == ["velocity:v_B"] and costs(apart) == ["velocity:v_B", "acceleration:a_B"]


def test_what_is_wrong_in_a_turned_polygon_costs_beside_its_turn() -> None:
    longer = changed(drawn(exact()), "velocity:v_E", lambda one: replace(one, end=one.end + 5 * _way(one)))
    mark = marked(key_of("3-9"), lying(exact(), longer, velocity=by(17)))
    assert costs(mark) == ["velocity:v_B", "velocity:v_E"]
    assert mark["velocity"]["v_E"].length is Verdict.WRONG


def _way(one: Segment) -> complex:
    return one.along / abs(one.along)


def test_what_follows_from_a_turned_polygon_is_continued_from_its_lengths() -> None:
    """A velocity read too long, and all accelerations by it: the turn is the only other mistake."""
    world = with_slip(key_of("3-9"), "v_B halved")
    plain, turned = drawn(world), lying(exact(), drawn(world), acceleration=by(25))
    assert len(costs(marked(key_of("3-9"), turned, declared=True))) == 1 + len(
        costs(marked(key_of("3-9"), plain, declared=True))
    )


def test_all_velocities_reversed_are_the_known_mistake_and_no_turn() -> None:
    mark = marked(key_of("3-9"), lying(exact(), drawn(exact()), velocity=lambda z: -z))
    assert str(mark.slip) == "v_B reversed" and not mark["velocity"].turned


def test_a_sheet_that_lay_askew_with_its_diagram_is_right_and_left_for_a_person() -> None:
    mark = marked(key_of("3-9"), put(drawn(exact()), by(17)))
    assert mark.right and mark.turned == pytest.approx(17) and mark.doubt is not None
    assert any("17°" in said.zh for said in mark.remarks)


def test_a_polygon_turned_on_a_sheet_without_a_diagram_is_left_for_a_person() -> None:
    bare = drawn(exact(), diagram=False)
    mark = marked(key_of("3-9"), put(bare, by(17)))
    assert costs(mark) == ["velocity:v_B"] and all(one.doubt is not None for one in mark.figures)


@pytest.mark.parametrize("problem", few(["3-9", "4-3a", "A-27"], 3))
def test_a_pencil_drawing_that_is_turned_is_told_to_a_degree(problem: str) -> None:
    key = key_of(problem, STUDENT)
    figure = next(shape.name for shape in key.exact.shapes if not shape.diagram)
    for seed in range(3):
        mark = marked(key, lying(key.exact, by_pencil(key, seed), **{figure: by(-17)}))
        assert mark[figure].turned == pytest.approx(-17, abs=1.0) and len(costs(mark)) == 1, seed


def test_a_sheet_turned_with_a_part_of_its_diagram_may_have_lain_askew() -> None:
    key = key_of("3-9")
    whole = put(drawn(key.exact), lambda z: 1j * z)
    polygons = [one for one in whole.segments if not one.where.startswith("mechanism")]
    diagram = [one for one in whole.segments if one.where.startswith("mechanism")][:2]
    mark = marked(key, replace(whole, segments=(*diagram, *polygons)))
    assert mark.doubt is not None and "lie askew" in mark.doubt.en


def test_what_stands_upright_is_never_called_askew_whatever_mistake_is_in_it() -> None:
    key = key_of("3-9", STUDENT)
    sheets = [by_pencil(key, seed) for seed in range(3)] + [drawn(world) for _, world in few(key.worlds, 9)]
    assert not any(one.turned or one.mirrored for sheet in sheets for one in marked(key, sheet).figures)


def test_the_turn_costs_as_much_where_the_vector_by_which_it_is_told_is_not_asked_for() -> None:
    key = sheet_key("3-9")
    asked = replace(key, quantities=tuple(one for one in key.quantities if one.key != "v_B"))
    drawing = lying(exact(), drawn(exact()), velocity=by(17))
    lines = paid_by_lines(asked, marked(key_of("3-9"), drawing, declared=True), Rules())[1]
    lost = [(one.key, one.worth - one.earned) for one in lines if one.earned < one.worth - 1e-9]
    assert [key for key, _ in lost] == ["v_C2C3"] and lost[0][1] == pytest.approx(asked["v_C2C3"].points.method / 2)


def test_the_turn_costs_half_of_one_vector_whatever_else_it_spoils() -> None:
    drawing = lying(exact(), drawn(exact()), velocity=by(17))
    lines = paid_by_lines(sheet_key("3-9"), marked(key_of("3-9"), drawing, declared=True), Rules())[1]
    lost = {one.key: one.worth - one.earned for one in lines if one.earned < one.worth - 1e-9}
    assert lost == {"v_B": pytest.approx(next(one.worth for one in lines if one.key == "v_B") / 2)}
    assert all(one.doubt is None for one in lines)


def test_the_line_with_which_an_askew_polygon_is_paid_is_not_said_to_cost_nothing() -> None:
    """Where v_B, by which the turn is told, is not asked, the next vector pays, and said that it does not."""
    key = sheet_key("3-9")
    unasked = replace(
        key, quantities=tuple(replace(one, points=NOTHING) if one.key == "v_B" else one for one in key.quantities)
    )
    mark = marked(key_of("3-9"), lying(exact(), drawn(exact()), velocity=by(-17)))
    lines = [one for one in paid_by_lines(unasked, mark, Rules())[1] if one.verdict is Verdict.WRONG]
    paying = [one for one in lines if one.earned < one.worth]
    assert len(lines) > 1 and [one.reason.zh for one in paying] == ["长度可以，方向随整个多边形偏了 −17.0°"]
    assert all("不重复扣分" in one.reason.zh for one in lines if one not in paying)
