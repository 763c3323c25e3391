"""The report on forces and devices as a person reads it:
what is given, what acts, where the forces lie, what a question may show."""

from __future__ import annotations

import cmath
import json
import re
from collections.abc import Iterator
from contextlib import closing
from dataclasses import replace
from functools import cache
from math import isfinite, radians
from pathlib import Path

import pypdfium2
import pytest

from tests.at_once import exactly
from tests.each import each
from tests.laws import few
from vecpoly.board.construction import View
from vecpoly.board.paper.marks import Cell, Note, Outline, Role, TurnArrow, Vector
from vecpoly.problem.library import entries
from vecpoly.problem.load import load, loads
from vecpoly.report.document import write_report
from vecpoly.report.picture import picture
from vecpoly.report.question.framed.fields import FIELDS
from vecpoly.report.question.framed.frames import frames
from vecpoly.report.question.framed.known import by_data
from vecpoly.report.question.framed.readings import READ
from vecpoly.report.titles import subject
from vecpoly.report.values import rough, value
from vecpoly.solution import Solution, solve
from vecpoly.words import Lang

FORCES = sorted(e.id for e in entries() if e.path.parent.name in ("ch4", "ch5"))
LANGS: tuple[Lang, Lang] = ("zh", "en")


@cache
def solved(name: str) -> Solution:
    return solve(load(name), repeats=40)


def text_of(path: Path) -> str:
    with closing(pypdfium2.PdfDocument(path)) as document:
        return "\n".join(page.get_textpage().get_text_range().replace("\r\n", "\n") for page in document)


@pytest.fixture(scope="module")
def pages(tmp_path_factory: pytest.TempPathFactory):  # type: ignore[no-untyped-def]
    folder = tmp_path_factory.mktemp("pages")

    @cache
    def text(name: str, lang: Lang, style: str = "solution") -> str:
        return text_of(
            write_report([solved(name)], folder / f"{name}.{style}.{lang}.pdf", lang=lang, style=style)
        ).replace("\n", " ")

    return text


# -- the page -----------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("name", few(FORCES, 12))
@pytest.mark.parametrize("style", ["solution", "question"])
def test_every_problem_of_chapters_4_and_5_becomes_a_report(name: str, style: str, pages) -> None:  # type: ignore[no-untyped-def]
    """The solution in one language, the question in the other, and the next problem the other way round."""
    lang = LANGS[(FORCES.index(name) + (style == "question")) % 2]
    text = pages(name, lang, style)
    assert load(name).title.of(lang).replace(" ", "")[:6] in text.replace(" ", "")
    assert "nan" not in text and "None" not in text and "Words(" not in text


def test_a_report_on_forces_is_not_called_kinematics(pages) -> None:  # type: ignore[no-untyped-def]
    assert "平面机构力分析图解作业" in pages("4-3a", "zh") and "Graphical force analysis of planar mechanisms" in pages(
        "4-3a", "en"
    )
    assert "机械的效率和自锁" in pages("5-7", "zh") and "Efficiency and self-locking" in pages("5-7", "en")
    mixed = subject([solved("3-4a"), solved("4-3a")])
    assert "运动分析" not in mixed.zh and "kinematics" not in mixed.en.lower()
    assert subject([solved("3-4a")]).en == "Graphical kinematics of planar mechanisms"


def test_the_loads_the_friction_and_the_frame_s_number_are_told(pages) -> None:  # type: ignore[no-untyped-def]
    en = pages("4-3a", "en")
    assert "1000 N" in en and "6 mm" in en and "The frame is link 4" in en
    assert "机架为构件4" in re.sub(r"\s+", "", pages("4-3a", "zh"))  # wherever the line is broken


def test_a_device_is_told_without_links_and_freedoms(pages) -> None:  # type: ignore[no-untyped-def]
    text = pages("5-7", "en")
    assert "moving links" not in text and "frame" not in text and "5 kW" in text


def test_the_structure_of_a_cam_counts_its_higher_pair_and_its_groups_the_substitute(pages) -> None:  # type: ignore[no-untyped-def]
    en, zh = pages("4-4", "en"), pages("4-4", "zh")
    assert "2 moving links" in en and "3×2 − 2×2 − 1 = 1" in en and "RRR" in en
    assert "高副低代" in zh.replace(" ", "")


def test_each_reaction_is_told_with_its_line_of_action(pages) -> None:  # type: ignore[no-untyped-def]
    en, zh = pages("4-3a", "en"), pages("4-3a", "zh").replace(" ", "")
    assert "tangent to the friction circle of C (upper side), moment counter-clockwise" in en
    assert "tangent to the friction circle of A (upper side), moment clockwise" in en
    assert "inclined to the normal of the guide by φ_34 = 8°" in en
    assert "切于C的摩擦圆上侧，对其中心之矩逆时针" in zh and "偏离导路法线φ_34=8°" in zh


def test_moments_have_a_sense_and_efficiencies_a_percentage(pages) -> None:  # type: ignore[no-untyped-def]
    text = pages("4-3a", "zh")
    answer = solved("4-3a").answers["eta"]
    assert f"{answer.drawn:.3f} ({100 * answer.drawn:.1f} %)" in text and "N·m 顺时针" in text


def test_values_by_formula_alone_have_no_deviation(pages) -> None:  # type: ignore[no-untyped-def]
    text = pages("5-7", "en")
    before, _, after = text.partition("Textbook answers compared")
    assert after and "Deviation" not in before and "Expected error" not in before
    assert "analytic" not in before  # nothing was drawn: the formulas are the analytic solution
    assert all(a.computed for a in solved("5-7").answers.values())
    assert not any(a.computed for a in solved("4-3a").answers.values())


def test_a_formula_that_misses_the_exact_value_is_not_hidden() -> None:
    answer = solved("5-7").answers["eta"]
    assert not replace(answer, drawn=answer.exact * 1.001).computed


@pytest.mark.parametrize(
    ("given", "printed"),
    [
        ((0.05245, "m", "en"), "52.45 mm"),
        ((30.0, "deg", "zh"), "30°"),
        ((1.0, "yes/no", "zh"), "是"),
        ((0.0, "yes/no", "en"), "no"),
        ((8.0258, "kW", "en"), "8.026 kW"),
        ((0.7952, "", "en", "eta"), "0.7952 (79.52 %)"),
        ((-2.55, "", "en", "eta_r"), "−2.55"),
        ((0.141, "", "en", "f_V"), "0.141"),
    ],
)
def test_values_are_printed_as_a_textbook_prints_them(given: tuple[float, str, Lang], printed: str) -> None:
    assert value(*given) == printed


def test_hundreds_need_no_power_of_ten() -> None:
    assert rough(193.7) == "190" and rough(0.01234) == "0.012"


# -- the picture and the question ---------------------------------------------------------------------------------


def test_the_sketch_shows_the_given_loads_and_no_reaction() -> None:
    it = solved("4-3a")
    drawn = picture(it.problem, it.construction, 125.0, 62.0)
    assert drawn is not None
    forces = [m for m in drawn.marks if isinstance(m, Vector) and m.role is not Role.CONSTRUCTION]
    assert [m.label for m in forces] == ["F"]  # others are the arrows of a dimension
    assert {m.label for m in drawn.marks if isinstance(m, TurnArrow)} == {"ω_1", "M"}  # it is told to resist
    circles = [m for m in drawn.marks if type(m).__name__ == "FrictionCircle"]
    assert len(circles) == 3


def test_the_sketch_of_a_cam_shows_neither_normal_nor_pressure_angle() -> None:
    it = solved("4-4")
    drawn = picture(it.problem, it.construction, 125.0, 62.0)
    assert drawn is not None
    labels = [getattr(m, "label", "") for m in drawn.marks]
    assert "Q" in labels and "φ_1" in labels and not {"n", "α"} & set(labels)


def test_a_device_s_sketch_is_what_its_first_step_draws() -> None:
    train = picture(solved("5-7").problem, solved("5-7").construction, 125.0, 62.0)
    assert (
        train is not None
        and any(isinstance(m, Cell) for m in train.marks)
        and not any(isinstance(m, Note) for m in train.marks)
    )
    wedges = picture(solved("4-2").problem, solved("4-2").construction, 125.0, 62.0)
    assert wedges is not None and not [m for m in wedges.marks if isinstance(m, Vector) and m.label.startswith("R_")]


def test_a_given_moment_turns_on_the_sketch_as_it_is_given() -> None:
    text = (load("4-3a").text).replace(
        "F: {on: 3, at: C, size: 1000 N, direction: 180 deg, role: driving}",
        'F: {on: 3, at: C, size: "?", direction: 180 deg, role: driving}',
    )
    text = text.replace('M: {on: 1, size: "?", role: resisting}', "M: {on: 1, size: 64 N*m cw, role: resisting}")
    it = solve(loads(re.sub(r"find: .*", "find: [F]", text)), repeats=0, precise=False)
    drawn = picture(it.problem, it.construction, 125.0, 62.0)
    assert drawn is not None
    (moment,) = [m for m in drawn.marks if isinstance(m, TurnArrow) and m.label == "M"]
    assert not moment.ccw


@pytest.mark.parametrize("name", few(FORCES, 4))
def test_a_question_shows_no_number_that_is_sought(name: str, pages) -> None:  # type: ignore[no-untyped-def]
    it = solved(name)
    text = pages(name, "en", "question")
    said = {float(n) for n in re.findall(r"(?<![\d.])\d+(?:\.\d+)?(?![\d.])", text)}
    given = {float(n) for n in re.findall(r"\d+(?:\.\d+)?", it.problem.text.split("printed:")[0])}
    for answer in it.answers.values():
        if answer.reading.unit != "yes/no" and answer.drawn and isfinite(answer.drawn):
            for factor in (1.0, 1e3):
                shown = float(f"{abs(answer.drawn) * factor:.4g}")
                assert shown not in said - given, answer.key


@each(few(FORCES, 4))
def test_the_frames_of_a_question_are_empty_but_for_what_is_given(name: str) -> None:
    it = solved(name)
    for figure in frames(it.construction, it.problem)[0].figures:
        if figure.view is not View.MECHANISM:
            inside = [m for m in figure.marks if m.key not in FIELDS]  # but for the lines to write on
            bodies = [m for m in inside if isinstance(m, Outline)]  # of a wedge, where data tell it and nothing is read
            assert not bodies or (figure.view is View.BODY and not any(m.key == READ for m in figure.marks))
            assert {m.act for m in bodies} <= by_data(it.construction.acts)
            assert not [m for m in inside if isinstance(m, (Vector, Note, Cell))]
            assert all(getattr(m, "role", Role.DIRECTION) is Role.DIRECTION for m in inside)


# -- the plain data -----------------------------------------------------------------------------------------------


def reactions() -> Iterator[tuple[str, str, dict[str, object]]]:
    for name in FORCES:
        it = solved(name)
        if it.problem.loads is not None:
            yield from (
                (name, key, data) for key, data in it.as_json()["answers"].items() if re.fullmatch(r"R_\d\d", key)
            )


def test_every_reaction_is_given_with_a_point_of_its_line() -> None:
    found = list(reactions())
    assert len(found) > 20
    for name, key, data in found:
        assert {
            "drawn",
            "exact",
            "direction_deg",
            "exact_direction_deg",
            "point",
            "exact_point",
            "tangent",
            "exact_tangent",
        } <= set(data), (name, key)
        assert data["tangent"] in ("ccw", "cw", None) and data["tangent"] == data["exact_tangent"], (name, key)


def test_the_drawn_point_lies_on_the_exact_line() -> None:
    for name in FORCES:
        problem = load(name)
        if problem.loads is None:
            continue
        for answer in exactly(problem).answers.values():
            if answer.exact_acts is not None and answer.reading.acts is not None and answer.exact_vector:
                along = answer.exact_vector / abs(answer.exact_vector)
                off = (along.conjugate() * (answer.reading.acts.point - answer.exact_acts.point)).imag
                assert abs(off) < 1e-9, (name, answer.key)


def test_the_point_and_the_direction_give_the_moment_about_the_pin() -> None:
    """4-3a: R_41 is tangent to the circle of 6 mm about A, the origin."""
    data = solved("4-3a").as_json()["answers"]["R_41"]
    turn = complex(*data["exact_point"]).conjugate() * cmath.rect(1.0, radians(data["exact_direction_deg"]))
    assert abs(turn.imag) == pytest.approx(0.006, rel=1e-9) and data["exact_tangent"] == (
        "ccw" if turn.imag > 0 else "cw"
    )


def test_moments_of_a_mechanism_turn_and_those_of_a_screw_do_not() -> None:
    moment = solved("4-3a").as_json()["answers"]["M"]
    assert moment["sense"] == "cw" and moment["drawn"] < 0 and moment["unit"] == "N·m"
    assert "sense" not in solved("4-3a").as_json()["answers"]["eta"]
    assert "sense" not in solved("5-5").as_json()["answers"]["M"]


def test_yes_and_no_are_truth_values_and_all_of_it_is_json() -> None:
    for name in FORCES:
        data = solved(name).as_json()
        json.dumps(data, allow_nan=False)
        for one in data["answers"].values():
            assert isinstance(one["exact"], bool) == (one["unit"] == "yes/no")
