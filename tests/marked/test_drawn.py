"""Drawings of a class: told whose they are by their names, graded vector by vector, and nobody stops the others."""

from __future__ import annotations

import csv
import json
from collections import Counter
from collections.abc import Callable
from dataclasses import replace
from functools import cache
from io import StringIO
from pathlib import Path

import pdfplumber
import pytest
from ezdxf.filemanagement import read as read_dxf
from ezdxf.math import Matrix44

from tests.grading.drawings.made import as_svg, by, changed, lying
from tests.grading.drawings.made import drawn as side_by_side
from tests.marked.classes import NUMBERS, answers, graded, register, wide
from vecpoly import Mistake, Slip, solve
from vecpoly.board.hand import hand
from vecpoly.board.otherwise.amended import AS_DRAWN
from vecpoly.board.place import View
from vecpoly.export.dxf.document import figure_dxf
from vecpoly.grading.compare.outcome import Basis
from vecpoly.grading.drawings.expected import shapes
from vecpoly.grading.drawings.judging.mark import Verdict
from vecpoly.grading.marking.lines import LineMark
from vecpoly.grading.rules import Lines, Rules
from vecpoly.grading.scheme import Scheme
from vecpoly.marked.drawn import grade_drawings
from vecpoly.marked.graded import Graded
from vecpoly.marked.intake.returned import Returned
from vecpoly.marked.out.items import items
from vecpoly.solution import constructed
from vecpoly.words import Words

WRONG = Slip(Mistake.HALVED, "v_B")


def silent(_: Words, done: int, of: int) -> None:
    assert 0 < done <= of


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """One right drawing, one with the given velocity half as long, one of nobody, one that is none."""
    made = tmp_path_factory.mktemp("drawn")
    for number, slip in ((NUMBERS[0], None), (NUMBERS[1], WRONG)):
        sheet = register().sheet(number)
        assert sheet is not None
        variant = register().variant(sheet.parts[0])
        own = solve(variant, by="exact", repeats=0, precise=False, slip=slip).construction
        (figure,) = (one for one in own.figures if one.view is View.VELOCITY)
        folder = made / number if slip else made
        folder.mkdir(exist_ok=True)
        name = "3-9.dxf" if slip else f"{number}_张三_3-9.dxf"
        (folder / name).write_bytes(figure_dxf(figure))
    (made / "2023009_3-9.dxf").write_text("0\nEOF\n", encoding="ascii")
    (made / f"{NUMBERS[2]}_3-9.dxf").write_text("no drawing", encoding="ascii")
    return made


def test_every_drawing_is_judged_and_what_is_nobodys_is_told(folder: Path, tmp_path: Path) -> None:
    drawn = grade_drawings(register(), Returned(), folder, tmp_path, "en", silent)
    right = {
        number: all(one.verdict is Verdict.RIGHT for one in work.mark.vectors)
        for (number, _), work in drawn.works.items()
    }
    assert right == {NUMBERS[0]: True, NUMBERS[1]: False}
    assert len(drawn.faults) == 2 and any("2023009" in one.words.en for one in drawn.faults)
    rows = list(csv.reader((tmp_path / "drawings.csv").read_text("utf-8-sig").splitlines()))
    assert {row[5] for row in rows[1:] if row[0] == NUMBERS[0] and row[4]} == {"right"}
    assert [row[6] for row in rows[1:] if row[0] == NUMBERS[0] and not row[4]] == [
        "Acceleration polygon: this polygon was not found on the drawing"
    ]
    assert ["v_B", "wrong"] in [row[4:6] for row in rows[1:] if row[0] == NUMBERS[1]]
    overlays = sorted(path.name for path in (tmp_path / "drawings").iterdir())
    assert overlays == [f"{number}_3-9.pdf" for number in NUMBERS[:2]]
    assert all((tmp_path / "drawings" / name).read_bytes().startswith(b"%PDF") for name in overlays)


def test_a_polygon_that_does_not_close_is_told_in_the_table_and_to_the_student(tmp_path: Path, file: Path) -> None:
    sheet = register().sheet(NUMBERS[0])
    assert sheet is not None
    there = shapes(constructed(register().variant(sheet.parts[0]), hand("exact"), AS_DRAWN))
    plain = side_by_side(there)
    longer = changed(plain, "velocity:v_C2B", lambda one: replace(one, end=one.end + 5 * one.along / abs(one.along)))
    made = tmp_path / "drawn"
    made.mkdir()
    (made / f"{NUMBERS[0]}_3-9.svg").write_bytes(as_svg(longer))
    done = graded(tmp_path / "out", file, drawings=made, feedback=True)
    assert done.results[0].drawings["3-9"].mark["velocity"].gap == pytest.approx(5.0, abs=0.1)
    assert "多边形不封闭，缺口 5.0 mm" in (tmp_path / "out" / "drawings.csv").read_text("utf-8-sig")
    (sheet_file,) = (path for path in done.files if path.parent.name == "feedback" and NUMBERS[0] in path.name)
    with pdfplumber.open(sheet_file) as pdf:
        assert "多边形不封闭" in "".join(page.extract_text() for page in pdf.pages)


def test_a_polygon_that_is_turned_as_a_whole_is_told_with_its_angle_and_costs_once(tmp_path: Path, file: Path) -> None:
    sheet = register().sheet(NUMBERS[0])
    assert sheet is not None
    there = shapes(constructed(register().variant(sheet.parts[0]), hand("exact"), AS_DRAWN))
    turned = lying(there, side_by_side(there), velocity=by(17))
    made = tmp_path / "drawn"
    made.mkdir()
    (made / f"{NUMBERS[0]}_3-9.svg").write_bytes(as_svg(turned))
    done = graded(tmp_path / "out", file, drawings=made, feedback=True)
    said = "整个多边形逆时针转过了 17°"
    assert said in (tmp_path / "out" / "drawings.csv").read_text("utf-8-sig")
    lost = {key: one.worth - one.earned for key, one in lines(done, NUMBERS[0]).items() if one.earned < one.worth}
    assert list(lost) == ["v_B"] and not any(one.doubt for one in lines(done, NUMBERS[0]).values())
    (sheet_file,) = (path for path in done.files if path.parent.name == "feedback" and NUMBERS[0] in path.name)
    with pdfplumber.open(sheet_file) as pdf:
        assert "转过了" in "".join(page.extract_text() for page in pdf.pages)


def lines(done: Graded, number: str) -> dict[str, LineMark]:
    result = next(one for one in done.results if one.student.number == number)
    return {one.key: one for one in result.marks["3-9"].lines}


@pytest.fixture(scope="module")
def file(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Right numbers of everybody."""
    return wide(tmp_path_factory.mktemp("answers") / "a.csv", {number: answers(number) for number in NUMBERS})


ByRule = Callable[[Lines], Graded]


@pytest.fixture(scope="module")
def by_rule(folder: Path, file: Path, tmp_path_factory: pytest.TempPathFactory) -> ByRule:
    """The class with its drawings, marked once by each rule that is asked for."""

    @cache
    def done(rule: Lines) -> Graded:
        return graded(tmp_path_factory.mktemp(rule), file, drawings=folder, scheme=Scheme(rules=Rules(drawing=rule)))

    return done


def test_whose_drawing_is_right_has_all_points_and_whose_is_wrong_loses_one_line(by_rule: ByRule) -> None:
    done = by_rule(Rules().drawing)
    right, wrong, plain = done.results
    assert right.total == right.worth == plain.total == plain.worth == 20.0
    assert [key for key, one in lines(done, NUMBERS[1]).items() if one.earned < one.worth] == ["v_B"]
    root = lines(done, NUMBERS[1])["v_B"]
    assert root.earned == root.worth * Rules().slip and wrong.worth == 20.0
    assert not lines(done, NUMBERS[2])


def test_whoever_hands_in_a_drawing_alone_has_the_points_for_its_scales(folder: Path, tmp_path: Path) -> None:
    """They are printed on the sheet, and count for whoever typed numbers."""
    there = wide(tmp_path / "a.csv", {NUMBERS[2]: answers(NUMBERS[2])})
    marks = graded(tmp_path / "out", there, drawings=folder).results[0].marks["3-9"]
    assert marks.lines and set(marks.stated) == {"mu_v"}
    assert marks.total == pytest.approx(sum(one.earned for one in marks.lines) + marks.stated["mu_v"], abs=0.5)


@pytest.mark.parametrize(
    ("rule", "without", "paid"), [("told", 20.0, False), ("given", 20.0, True), ("required", None, True)]
)
def test_the_rules_say_whether_a_drawing_is_told_or_paid_or_required(
    by_rule: ByRule, rule: Lines, without: float | None, paid: bool
) -> None:
    done = by_rule(rule)
    assert bool(lines(done, NUMBERS[0])) is paid
    last = done.results[2]
    assert last.total == without if without is not None else last.total < last.worth - 5
    assert all(one.worth == 20.0 for one in done.results)


def test_a_length_read_rightly_off_a_wrong_line_costs_nothing_more(folder: Path, tmp_path: Path) -> None:
    """The second student's velocity polygon is half as large, and the numbers are those of that polygon."""

    def read_off(key: str, text: str) -> str:
        return f"{float(text) / 2:.4g}" if key.startswith("v_") else text

    rows = {number: answers(number, read_off if number == NUMBERS[1] else lambda key, text: text) for number in NUMBERS}
    own = graded(tmp_path / "own", wide(tmp_path / "a.csv", rows), drawings=folder).results[1].marks["3-9"]
    for one in own.findings:
        if one.key in own.key.scales or one.key not in {line.key for line in own.lines}:
            continue
        assert one.basis is Basis.DRAWN and one.earned.total == own.key[one.key].points.total, one.key
    assert "read" not in {said.id.value for one in own.findings for said in one.messages if one.key == "v_B"}


def test_a_scale_that_nobody_stated_is_left_for_a_person(tmp_path: Path, file: Path) -> None:
    sheet = register().sheets[0]
    variant = register().variant(sheet.parts[0])
    figure = next(
        one
        for one in solve(variant, by="exact", repeats=0, precise=False).construction.figures
        if one.view is View.VELOCITY
    )
    scaled = figure_dxf(figure)
    (tmp_path / "drawn").mkdir()
    document = read_dxf(StringIO(scaled.decode()))
    for entity in list(document.modelspace()):
        if entity.dxftype() in ("TEXT", "MTEXT"):
            document.modelspace().delete_entity(entity)
        else:
            entity.transform(Matrix44.scale(0.7))
    document.saveas(tmp_path / "drawn" / f"{NUMBERS[0]}_3-9.dxf")
    done = graded(tmp_path / "out", file, drawings=tmp_path / "drawn")
    assert all(one.doubt is not None and one.earned == one.worth for one in lines(done, NUMBERS[0]).values())
    queue = list(csv.reader((tmp_path / "out" / "queue.csv").read_text("utf-8-sig").splitlines()))
    assert [row[:3] for row in queue[1:]] == [[NUMBERS[0], "3-9", "速度多边形"]] and "比例尺" in queue[1][5]


def test_grades_feedback_and_record_tell_of_the_lines(folder: Path, file: Path, tmp_path: Path) -> None:
    graded(tmp_path, file, drawings=folder, feedback=True)
    rows = list(csv.DictReader((tmp_path / "grades.csv").read_text("utf-8-sig").splitlines()))
    assert float(rows[0]["3-9:图线"]) > float(rows[1]["3-9:图线"]) > 0 == float(rows[2]["3-9:图线"])
    record = json.loads((tmp_path / "marks.json").read_text("utf-8"))
    assert [bool(one["problems"]["3-9"].get("lines")) for one in record["students"]] == [True, True, False]
    with pdfplumber.open(tmp_path / "feedback" / f"{NUMBERS[1]}_李四.pdf") as pages:
        text = "".join(page.extract_text() for page in pages.pages)
    assert "据此给图线分" in text and "不重复扣分" in text


@pytest.mark.parametrize("rule", ["told", "given"])
def test_the_item_analysis_counts_every_line_of_the_drawings_by_its_verdict(by_rule: ByRule, rule: Lines) -> None:
    done = by_rule(rule)
    found = {one.key.en: one for one in items(done.results)}
    assert found["v_B (line)"].counts == Counter(right=1, wrong=1)
    assert [(bool(words.en), count) for words, count in found["v_B (line)"].slips] == [(True, 1)]
    assert found["v_C2B (line)"].counts == Counter(right=1, own=1)  # follows from the wrong v_B
    assert found["a_B (line)"].counts == Counter(blank=2)  # nobody drew the accelerations
    assert found["v_B"].counts == Counter(right=3)
    assert (found["v_B (line)"].share > 0) is (rule == "given")


def handed_in(tmp_path: Path, folder: Path, *names: str) -> Path:
    """A folder with the first student's drawing under these names."""
    there = tmp_path / "drawn"
    there.mkdir()
    for name in names:
        (there / name).write_bytes(next(folder.glob(f"{NUMBERS[0]}*.dxf")).read_bytes())
    return there


def test_a_second_drawing_of_one_problem_is_refused_with_the_name_of_the_first(folder: Path, tmp_path: Path) -> None:
    again = handed_in(tmp_path, folder, *(f"{NUMBERS[0]}_{name}_3-9.dxf" for name in "ab"))
    drawn = grade_drawings(register(), Returned(), again, tmp_path, "en", silent)
    assert [one.code for one in drawn.faults] == ["twice"] and f"{NUMBERS[0]}_a_3-9.dxf" in drawn.faults[0].words.en


def test_a_file_that_no_reader_knows_is_told_with_whose_it_is_and_pays_by_numbers(
    folder: Path, file: Path, tmp_path: Path
) -> None:
    """A DWG or a photograph was passed over without a word; beside a drawing that is read it is no matter."""
    there = handed_in(tmp_path, folder, f"{NUMBERS[0]}_3-9.dxf")
    for name in (f"{NUMBERS[0]}_3-9.dwg", f"{NUMBERS[1]}_3-9.dwg", "Thumbs.db"):
        (there / name).write_bytes(b"AC1027")
    (there / f"{NUMBERS[2]}_3-9.dxf").write_text("no drawing", encoding="utf-8")
    done = graded(tmp_path / "out", file, drawings=there)
    assert [one.numbers["student"] for one in done.faults] == [NUMBERS[2], NUMBERS[1]]
    assert f"{NUMBERS[1]}_3-9.dwg" in done.faults[1].words.en and "save a DWG as DXF" in done.faults[1].words.en
    assert [one.aside for one in done.results] == [False, True, True]
    assert all(one.total == 20.0 for one in done.results)
    assert f"{NUMBERS[1]}," in (tmp_path / "out" / "queue.csv").read_text("utf-8-sig")


def test_a_drawing_on_which_nothing_is_of_the_problem_is_left_for_a_person(
    folder: Path, file: Path, tmp_path: Path
) -> None:
    """Another student's: what follows from the own lines is right by these alone."""
    there = handed_in(tmp_path, folder, f"{NUMBERS[2]}_3-9.dxf")
    theirs = lines(graded(tmp_path / "out", file, drawings=there), NUMBERS[2]).values()
    assert theirs and all(one.doubt is not None and "another student's" in one.doubt.en for one in theirs)
    own = lines(graded(tmp_path / "own", file, drawings=folder), NUMBERS[0]).values()
    assert own and not [one for one in own if one.doubt is not None]
