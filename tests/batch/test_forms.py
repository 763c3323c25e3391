"""Forms and exports, read back by other programs than those that wrote them."""

from __future__ import annotations

import re
import xml.etree.ElementTree as xml
from dataclasses import replace
from decimal import Decimal
from io import BytesIO
from pathlib import Path
from zipfile import ZipFile

import openpyxl
import pytest
from pypdf import PdfReader

from tests.batch.homework import TEXT, made
from tests.grading.cases import key_of, problem_of
from tests.marked.classes import register
from vecpoly.batch.bundles import merged, zipped
from vecpoly.batch.forms.columns import columns_of, per_mm
from vecpoly.batch.forms.profile import ColumnOf, Profile, read_profile, refuse_unknown, table_bytes
from vecpoly.batch.forms.workbooks import answers_bytes, key_bytes
from vecpoly.batch.moodle.quiz import Quizzes
from vecpoly.batch.register import Exercise, Part, Register, Sheet
from vecpoly.batch.run.tasks import question_file
from vecpoly.batch.sheet.compose import composed
from vecpoly.batch.sheet.write import sheet_bytes
from vecpoly.batch.student import Student
from vecpoly.errors import VecpolyError
from vecpoly.figures import scales
from vecpoly.grading.key import Kind
from vecpoly.grading.reading.written import State
from vecpoly.grading.sheet import sheet_of
from vecpoly.problem.ranges import Range
from vecpoly.solution import solve
from vecpoly.variants.seeds import Seed

CLASS = (Student(number="20230001", name="王小明", team="1"), Student(number="20230002", name="=1+1", team="@x"))
FRACTIONS = {
    100,
    90,
    83.33333,
    80,
    75,
    70,
    66.66667,
    60,
    50,
    40,
    33.33333,
    30,
    25,
    20,
    16.66667,
    14.28571,
    12.5,
    11.11111,
    10,
    5,
}


@pytest.fixture(scope="module")
def done(tmp_path_factory: pytest.TempPathFactory) -> tuple[Path, Register]:
    out = tmp_path_factory.mktemp("forms") / "hw"
    return out, made(out, CLASS, TEXT).register


def test_the_answers_form_locks_who_it_is_and_says_units_in_row_two(done: tuple[Path, Register]) -> None:
    page = openpyxl.load_workbook(BytesIO(answers_bytes(done[1]))).worksheets[0]
    heads, units = ([cell.value for cell in row] for row in page.iter_rows(max_row=2))
    assert heads[:4] == ["学号", "姓名", "班级", "卷号"] and page.protection.sheet
    columns = columns_of(done[1])
    assert heads[4:] == [column.head for column in columns] and units[4:] == [column.unit for column in columns]
    assert {"block:mu_v", "block:v_E", "block:v_E mm", "block:v_E deg", "block:omega_3", "block:omega_3 sense"} <= set(
        heads
    )
    assert [cell.value for cell in page[4][:4]] == ["20230002", "=1+1", "@x", done[1].sheets[1].sheet]
    assert all(cell.data_type == "s" and cell.protection.locked for cell in page[4][:4])
    assert not any(cell.protection.locked for cell in page[4][4:])


@pytest.mark.parametrize(
    ("mu", "unit"),
    [("mu_l", "m/mm"), ("mu_v", "(m/s)/mm"), ("mu_a", "(m/s²)/mm"), ("mu_F", "N/mm"), ("mu_W", "kg·m/mm")],
)
def test_every_scale_has_its_unit_in_row_two(mu: str, unit: str) -> None:
    assert per_mm(mu) == unit and all(map(per_mm, scales()))


def test_a_cell_takes_a_sense_from_a_list_and_a_length_that_fits_the_page(done: tuple[Path, Register]) -> None:
    page = openpyxl.load_workbook(BytesIO(answers_bytes(done[1]))).worksheets[0]
    rules = {str(rule.sqref).split(":")[0].rstrip("0123456789"): rule for rule in page.data_validations.dataValidation}
    letters = {cell.value: cell.column_letter for cell in page[1]}
    assert (
        rules[letters["block:omega_3 sense"]].type == "list" and "↺" in rules[letters["block:omega_3 sense"]].formula1
    )
    assert float(rules[letters["block:v_E mm"]].formula2) == 400


@pytest.mark.parametrize(
    ("name", "key", "unit", "choice"), [("2-9", "determined", "✓ ×", "是,否"), ("2-9", "class_1", "Ⅱ Ⅲ Ⅳ", "Ⅱ,Ⅲ,Ⅳ")]
)
def test_what_is_told_in_words_is_chosen_from_them(name: str, key: str, unit: str, choice: str) -> None:
    """A spreadsheet warned whoever typed 是 that a number was expected."""
    part = Part(problem=name, attempt=0, values={}, scales={}, key=key_of(name))
    sheet = Sheet(sheet="S", student=CLASS[0], parts=(part,))
    few = replace(register(), sheets=(sheet,), exercises=(Exercise(id=name, data={}, fingerprint=""),))
    page = openpyxl.load_workbook(BytesIO(answers_bytes(few))).worksheets[0]
    (cell,) = (cell for cell in page[1] if cell.value == f"{name}:{key}")
    assert page.cell(2, cell.column).value == unit
    (rule,) = (one for one in page.data_validations.dataValidation if f"{cell.column_letter}3" in str(one.sqref))
    assert rule.type == "list" and rule.formula1 == f'"{choice}"'
    sheet_read = sheet_of(key_of(name), {key: choice.partition(",")[0]})
    assert sheet_read.answers[key].state is State.READ


def test_a_place_is_asked_by_both_coordinates_from_a_point_that_is_named() -> None:
    """On the sheet, in the form and in the key alike: (x, y) in mm."""
    key = key_of("D-1")
    part = Part(problem="D-1", attempt=0, values={}, scales={}, key=key)
    sheet = Sheet(sheet="S", student=CLASS[0], parts=(part,))
    few = replace(register(), sheets=(sheet,), exercises=(Exercise(id="D-1", data={}, fingerprint=""),))
    units = {column.head: column.unit for column in columns_of(few)}
    assert units["D-1:P_13"] == "(x, y) mm, A = (0, 0)"
    page = openpyxl.load_workbook(BytesIO(key_bytes(few)))["D-1"]
    cells = dict(zip((cell.value for cell in page[1]), (cell.value for cell in page[3]), strict=True))
    assert key.scales and {mu: cells[mu] for mu in key.scales} == pytest.approx(dict(key.scales))
    assert cells["P_13"] == "(-31.9341, 0)" and cells["P_13 T"] == pytest.approx(1e3 * key["P_13"].allowed, rel=1e-5)
    solution = solve(problem_of("D-1"))
    pages = composed([(solution, key, Seed(assignment="hw", problem="D-1", student="1"))], "en")
    (blank,) = [blank for one in pages for blank in one.page.blanks if blank.key == "P_13"]
    assert (blank.place, blank.origin, blank.unit, blank.plain) == (True, "A", "mm", False)
    whole = sheet_bytes(pages, title="t", assignment="hw", sheet="S", student=CLASS[0], lang="en")
    text = " ".join(page.extract_text() for page in PdfReader(BytesIO(whole)).pages)
    assert text.count("right and up") == 6


def test_the_key_has_the_exact_values_of_the_register(done: tuple[Path, Register]) -> None:
    page = openpyxl.load_workbook(BytesIO(key_bytes(done[1])))["block"]
    heads = [cell.value for cell in page[1]]
    for row, sheet in enumerate(done[1].sheets, 3):
        cells = dict(zip(heads, (cell.value for cell in page[row]), strict=True))
        assert cells["AB"] == sheet.parts[0].values["AB"] and cells["卷号"] == sheet.sheet
        for one in sheet.parts[0].key.quantities:
            if one.asked and not one.demoted:
                assert cells[one.key] == pytest.approx(one.exact, rel=1e-5)
                assert cells[f"{one.key} T"] == pytest.approx(one.allowed, rel=1e-5)


# Moodle's own patterns (qtype_multianswer, renderer and import), typed anew in Python
_ANSWER = r"(?:=|%-?[0-9]+(?:[.,][0-9]*)?%)?.+?(?<!\\)(?=[~#}]|$)(?:#.*?(?<!\\)(?=[~}]|$))?"
_BLANK = re.compile(rf"\{{\s*([0-9]*)\s*:(NUMERICAL|MULTICHOICE_S|MULTICHOICE):({_ANSWER}(?:~{_ANSWER})*)\}}")
_NUMERICAL = re.compile(
    r"(?:=|%(-?[0-9]+)%)?(-?(?:[0-9]+[.,]?[0-9]*|[.,][0-9]+)(?:[eE][-+]?[0-9]+)?):([0-9.]+)(?:#.*)?"
)


def test_every_blank_of_a_cloze_question_is_one_to_moodle(done: tuple[Path, Register]) -> None:
    root = xml.fromstring(Quizzes(done[1]).cloze())
    questions = root.findall("question[@type='cloze']")
    assert len(questions) == 2 and root[0].get("type") == "category"
    for question, sheet in zip(questions, sorted(done[1].sheets, key=lambda one: one.sheet), strict=True):
        text = question.findtext("questiontext/text") or ""
        blanks = _BLANK.findall(text)
        assert text.count("{") == len(blanks) and all(weight.isdigit() for weight, _, _ in blanks)
        numbers = [body for _, sort, body in blanks if sort == "NUMERICAL"]
        graded = [one for one in sheet.parts[0].key.quantities if one.asked and not one.demoted]
        assert len(numbers) == len(graded)
        for body, one in zip(numbers, graded, strict=True):
            answers = [_NUMERICAL.fullmatch(part) for part in re.split(r"(?<!\\)~", body)]
            first = answers[0]
            assert all(answers) and first is not None and first[1] == "100"
            assert float(first[2]) == pytest.approx(abs(one.exact), rel=1e-5)
            assert {float(found[1]) for found in answers if found is not None} <= FRACTIONS
        assert sum("↺" in body for _, _, body in blanks) == sum(one.kind is Kind.SIGNED for one in graded)


def test_a_numerical_question_tries_the_narrow_band_before_the_wide_one(done: tuple[Path, Register]) -> None:
    root = xml.fromstring(Quizzes(done[1]).numerical())
    questions = root.findall("question[@type='numerical']")
    assert questions
    for question in questions:
        answers = question.findall("answer")
        bands = [
            (
                float(one.findtext("text") or "nan"),
                float(one.findtext("tolerance") or "nan"),
                float(one.get("fraction", "nan")),
            )
            for one in answers
        ]
        assert bands[0][2] == 100 and bands[1][2] == 50 and bands[0][0] == bands[1][0] and bands[0][1] < bands[1][1]
        assert {fraction for _, _, fraction in bands} <= FRACTIONS
        for value, allowed, _ in bands[2:]:
            assert abs(value - bands[0][0]) > allowed + bands[0][1] - 1e-9, (
                "the band of a slip would take right answers"
            )
    names = [question.findtext("idnumber") for question in questions]
    assert len(set(names)) == len(names)


def test_merged_sheets_have_an_outline_of_students(done: tuple[Path, Register]) -> None:
    out, register = done
    book = PdfReader(BytesIO(merged(register, out)))
    alone = [len(PdfReader(out / question_file(sheet.student)).pages) for sheet in register.sheets]
    assert len(book.pages) == sum(alone)
    names = [entry.title for entry in book.outline if not isinstance(entry, list)]
    assert [name.split()[0] for name in names if name] == [sheet.student.number for sheet in register.sheets]


def test_an_archive_has_neither_dates_nor_another_order(done: tuple[Path, Register]) -> None:
    out, register = done
    paths = [out / question_file(sheet.student) for sheet in register.sheets]
    assert zipped(paths, out) == zipped(paths[::-1], out)
    assert sorted(ZipFile(BytesIO(zipped(paths, out))).namelist()) == sorted(
        question_file(sheet.student) for sheet in register.sheets
    )


def test_the_key_says_yes_and_no_in_words() -> None:
    """Beside the truth of whether a motion is determined stood 1, with the tolerance 0."""
    whole = register()
    first = whole.sheets[0]
    part = replace(first.parts[0], key=replace(first.parts[0].key, quantities=(key_of("5-5")["self_locking"],)))
    book = openpyxl.load_workbook(BytesIO(key_bytes(replace(whole, sheets=(replace(first, parts=(part,)),)))))
    head, units, row = list(book.worksheets[0].iter_rows(values_only=True))[:3]
    at = head.index("self_locking")
    assert row[at] == "是" and not row[at + 1] and units[head.index("mu_v")] == "(m/s)/mm"


def test_a_column_that_would_hold_nothing_is_refused_before_anything_is_made() -> None:
    varied = replace(
        problem_of("3-9"), ranges=(Range(name="AB", first=Decimal(24), step=Decimal(2), count=9, unit="mm"),)
    )
    known = Profile(file="x.csv", columns=(ColumnOf(head="a", holds="3-9:AB"), ColumnOf(head="b", text="x")))
    refuse_unknown(known, [varied])
    with pytest.raises(VecpolyError, match="3-9:phi"):
        refuse_unknown(Profile(file="x.csv", columns=(ColumnOf(head="c", holds="3-9:phi"),)), [varied])


def test_a_profile_gives_the_columns_of_another_platform_and_guards_formulas(
    done: tuple[Path, Register], tmp_path: Path
) -> None:
    file = tmp_path / "p.yaml"
    file.write_text(
        "file: x.csv\ncolumns: [{head: 学号, holds: number}, {head: 姓名, holds: name}, {head: a, holds: "
        "'block:AB'}, {head: 课程, text: 机械原理}]\n",
        encoding="utf-8",
    )
    text = table_bytes(done[1], read_profile(file)).decode("utf-8-sig").splitlines()
    assert text[0] == "学号,姓名,a,课程"
    assert text[2] == f"20230002,'=1+1,{done[1].sheets[1].parts[0].values['AB']},机械原理"
    file.write_text("file: x.csv\ncolumns: [{head: a, holds: 'block:XY'}]\n", encoding="utf-8")
    with pytest.raises(VecpolyError, match="block:AB"):
        table_bytes(done[1], read_profile(file))
    file.write_text("file: x.csv\ncolumns: [{heat: a}]\n", encoding="utf-8")
    with pytest.raises(VecpolyError, match="head"):
        read_profile(file)


def test_a_value_below_zero_is_no_formula_of_a_student(done: tuple[Path, Register]) -> None:
    """'-43 mm stood in the table."""
    first = done[1].sheets[0]
    part = replace(first.parts[0], values={"x_C": "-43 mm"})
    below = replace(done[1], sheets=(replace(first, parts=(part,)),))
    profile = Profile(file="x.csv", columns=(ColumnOf(head="x", holds=f"{part.problem}:x_C"),))
    assert table_bytes(below, profile).decode("utf-8-sig").splitlines() == ["x", "-43 mm"]


SPOILT = {
    "file: x.csv\ncolumns: [{head: a, holds: name, text: b}]": ("只留一个", "has holds and text; leave one of them"),
    "file: x.csv\ncolumns: [{heat: a}]": ("columns.0.heat: 未知的键“heat”", "unknown key 'heat'; did you mean 'head'?"),
    "file: x.csv\ncolumns: 5": ("columns: 此处应为列表", "columns: a list is expected here"),
    "file: x.xlsx\ncolumns: [{head: a}]": ("“x.xlsx”不是文件名", "'x.xlsx' is no name of the file"),
    "file: x.csv\ncolumns: []": ("columns: 此处至少要有一项", "columns: at least one entry is needed here"),
    "file: x.csv\nmark: maybe\ncolumns: [{head: a}]": ("mark: 此处应为 true 或 false", "mark: true or false"),
    "columns: [{head: a}]": ("缺少“file”", "'file' is missing"),
}


@pytest.mark.parametrize("text", list(SPOILT))
def test_what_is_wrong_with_a_profile_is_said_in_the_language_of_whoever_reads_it(text: str, tmp_path: Path) -> None:
    file = tmp_path / "p.yaml"
    file.write_text(text, encoding="utf-8")
    with pytest.raises(VecpolyError) as refused:
        read_profile(file)
    zh, en = SPOILT[text]
    said = refused.value.words
    assert zh in said.zh and en in said.en
    assert not re.search(r"\b(input|should|field|extra)\b", said.zh, re.IGNORECASE)
