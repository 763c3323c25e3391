"""A class is marked from whatever file its answers come in; nothing is lost or guessed, a mark has a reason."""

from __future__ import annotations

import csv
import io
import json
import re
from pathlib import Path

import pdfplumber
import pytest
from openpyxl import Workbook, load_workbook

from tests.marked.classes import NUMBERS, answers, everybody, graded, register, wide
from vecpoly.batch.run.tasks import question_file
from vecpoly.errors import TableError, UnknownNameError, VecpolyError
from vecpoly.grading.key import Points
from vecpoly.grading.rules import Rules
from vecpoly.grading.scheme import Scheme
from vecpoly.marked.out.feedback import _table
from vecpoly.marked.out.record import read_record
from vecpoly.marked.scheme import read_scheme


def halved(key: str, text: str) -> str:
    """Half of the Coriolis term, and what follows from it left out."""
    after = ("at_C2B", "ar_C2C3", "a_D", "a_E", "alpha_2", "alpha_3")
    return f"{float(text) / 2:.4g}" if key == "ak_C2C3" else "" if key in after else text


def lengthened(key: str, text: str) -> str:
    """A length read too long, ω₂ as it follows from it, and a normal acceleration that follows from nothing."""
    size, *sense = text.split()
    return " ".join([f"{float(size) * 1.3:.4g}", *sense]) if key in ("v_C2B", "omega_2", "an_C2B") else text


@pytest.mark.parametrize(
    ("encoding", "mark"), [("utf-8", ","), ("utf-8-sig", ";"), ("gb18030", "\t"), ("gb18030", ",")]
)
def test_right_answers_have_all_points_in_whatever_encoding(tmp_path: Path, encoding: str, mark: str) -> None:
    done = graded(tmp_path / "out", wide(tmp_path / "a.csv", everybody(), encoding=encoding, mark=mark))
    assert [one.total for one in done.results] == [one.worth for one in done.results] == [20.0] * 3
    assert not done.faults


def test_a_workbook_with_columns_for_parts_says_the_same(tmp_path: Path) -> None:
    book = Workbook()
    page = book.active
    assert page is not None
    page.append(["学号", "姓名", "3-9:v_E mm", "3-9:v_E", "3-9:v_E deg", "3-9:omega_3", "3-9:omega_3 sense"])
    page.append(["", "", "mm", "m/s", "°", "rad/s", "↻ ↺"])
    for number in NUMBERS:
        sheet = register().sheet(number)
        assert sheet is not None
        v, w = sheet.parts[0].key["v_E"], sheet.parts[0].key["omega_3"]
        page.append(
            [number, "", round(v.mm or 0, 1), v.exact, round(v.degrees or 0), abs(w.exact), "↺" if w.exact > 0 else "↻"]
        )
    book.save(tmp_path / "a.xlsx")
    done = graded(tmp_path / "out", tmp_path / "a.xlsx")
    for one in done.results:
        marks = one.marks["3-9"]
        assert marks["v_E"].is_right and marks["pe"].is_right and marks["omega_3"].earned.sense > 0


def test_long_tables_and_documents_are_read_too(tmp_path: Path) -> None:
    lines = ["student_id,step,value,unit,sense"]
    lines += [
        f"{NUMBERS[0]},{key},{text.split()[0]},,{(text + ' ').split(' ')[1]}"
        for key, text in answers(NUMBERS[0]).items()
    ]
    (tmp_path / "long.csv").write_text("\n".join(lines), encoding="utf-8")
    (tmp_path / "one.yaml").write_text(
        json.dumps({"student": NUMBERS[1], "answers": {"3-9": answers(NUMBERS[1])}}, ensure_ascii=False),
        encoding="utf-8",
    )
    done = graded(tmp_path / "out", tmp_path / "long.csv", tmp_path / "one.yaml")
    assert [one.total for one in done.results] == [20.0, 20.0, 0.0] and not done.results[2].returned


def test_a_slip_costs_once_and_is_counted_in_the_item_analysis(tmp_path: Path) -> None:
    done = graded(tmp_path / "out", wide(tmp_path / "a.csv", {number: answers(number, halved) for number in NUMBERS}))
    assert all({str(slip) for slip in one.marks["3-9"].slips.values()} <= {"ak_C2C3 halved"} for one in done.results)
    pages = load_workbook(tmp_path / "out" / "grades.xlsx")
    rows = list(pages["逐题分析"].iter_rows(values_only=True))
    row = next(row for row in rows if row[1] == "ak_C2C3")
    assert row[7] == 3  # wrong


def test_what_cannot_be_used_is_told_with_its_place_and_stops_nobody(tmp_path: Path) -> None:
    rows = everybody() | {"2099999": answers(NUMBERS[0])}
    rows[NUMBERS[0]]["v_E"] = "O.17"
    rows[NUMBERS[1]] = {**rows[NUMBERS[1]], "v_E": "1,234"}
    file = wide(tmp_path / "a.csv", rows, mark=";")
    text = file.read_text("utf-8").replace("v_D", "v_Q", 1)
    file.write_text(text + f"\r\n{NUMBERS[2]}" + ";" * 16 + "\r\n", encoding="utf-8")
    done = graded(tmp_path / "out", file)
    assert [fault.code for fault in done.faults] == ["column", "stranger"]
    assert "line 6, column 1" in done.faults[1].words.en and "2099999" in done.faults[1].words.en
    queue = list(csv.reader(io.StringIO((tmp_path / "out" / "queue.csv").read_text("utf-8-sig"))))
    assert [row[3] for row in queue[1:3]] == ["O.17", "1,234"] and "第 3 行" in queue[1][4]
    assert done.results[2].marks["3-9"]["v_E"].is_right


def test_a_second_row_of_one_student_is_told_and_changes_nothing(tmp_path: Path) -> None:
    first = wide(tmp_path / "a.csv", everybody())
    again = wide(tmp_path / "b.csv", {NUMBERS[0]: answers(NUMBERS[0], lambda key, text: "99")})
    done = graded(tmp_path / "out", first, again)
    assert done.results[0].total == 20 and [fault.code for fault in done.faults] == ["twice"]


def test_no_cell_of_the_grades_is_taken_for_a_formula(tmp_path: Path) -> None:
    rows = everybody()
    rows[NUMBERS[0]]["v_E"] = "=HYPERLINK(1)"
    graded(tmp_path / "out", wide(tmp_path / "a.csv", rows))
    for name in ("grades.csv", "queue.csv"):
        data = (tmp_path / "out" / name).read_bytes()
        assert data.startswith(b"\xef\xbb\xbf")
        cells = [cell for row in csv.reader(io.StringIO(data.decode("utf-8-sig"))) for cell in row]
        assert cells and not [cell for cell in cells if cell[:1] in "=+@" and cell]
    for page in load_workbook(tmp_path / "out" / "grades.xlsx").worksheets:
        assert not [cell for row in page.iter_rows() for cell in row if cell.data_type == "f"]


def test_marked_again_the_same_answers_have_the_same_marks_to_the_byte(tmp_path: Path) -> None:
    rows = {number: answers(number, halved) for number in NUMBERS}
    turned = dict(reversed(rows.items()))
    graded(tmp_path / "one", wide(tmp_path / "a.csv", rows))
    done = graded(tmp_path / "two", wide(tmp_path / "b.csv", turned), before=tmp_path / "one")
    assert done.changed == ()
    assert (tmp_path / "one" / "marks.json").read_bytes() == (tmp_path / "two" / "marks.json").read_bytes()


def test_a_regrade_tells_what_changed_and_nothing_else(tmp_path: Path) -> None:
    graded(tmp_path / "one", wide(tmp_path / "a.csv", everybody()))
    rows = everybody()
    rows[NUMBERS[1]]["a_E"] = "7.7"
    done = graded(tmp_path / "two", wide(tmp_path / "b.csv", rows), before=tmp_path / "one")
    assert done.changed is not None and [row[:3] for row in done.changed] == [(NUMBERS[1], "3-9", "a_E")]
    assert (tmp_path / "two" / "changes.csv").exists()
    with pytest.raises(VecpolyError, match="no marks"):
        read_record(tmp_path / "a.csv")


def test_everybody_who_returned_something_gets_a_sheet_that_names_the_reason(tmp_path: Path) -> None:
    rows = {number: answers(number, change) for number, change in zip(NUMBERS, (halved, lengthened), strict=False)}
    done = graded(tmp_path / "out", wide(tmp_path / "a.csv", rows), feedback=True)
    sheets = sorted(path.name for path in (tmp_path / "out" / "feedback").iterdir())
    assert sheets == ["2023001_张三.pdf", "2023002_李四.pdf"] and not done.results[2].returned
    assert [f"questions/{name}" for name in sheets] == [question_file(one.student) for one in done.results[:2]]
    with pdfplumber.open(tmp_path / "out" / "feedback" / sheets[0]) as book:
        texts = [page.extract_text() for page in book.pages]
        lines = sum(len(page.lines) + len(page.curves) for page in book.pages)
    text = "".join(texts)
    assert all("-S0-F" in page for page in texts), "the sheet's id is not on every page"
    assert "漏乘 2" in text and "张三" in text and "2023001" in text and lines > 20 and "由前正确" not in text
    with pdfplumber.open(tmp_path / "out" / "feedback" / sheets[1]) as book:
        text = book.pages[0].extract_text()
    verdicts = [len(re.findall(rf"(?<!\S){one}(?!\S)", text)) for one in ("由前正确", "错误", "正确")]
    assert verdicts == [1, 2, 13]


def test_while_answers_can_be_handed_in_again_no_feedback_gives_them_away(tmp_path: Path) -> None:
    rows = {NUMBERS[0]: answers(NUMBERS[0], lambda key, text: "9.99" if key == "a_E" else text)}
    scheme = Scheme(rules=Rules(open=True))
    graded(tmp_path / "out", wide(tmp_path / "a.csv", rows), scheme=scheme, feedback=True)
    with pdfplumber.open(next((tmp_path / "out" / "feedback").iterdir())) as book:
        text = "".join(page.extract_text() for page in book.pages)
        assert len(book.pages) == 1
    assert "不正确" in text and "相差" not in text and "允许" not in text


@pytest.mark.parametrize(("scale", "unit", "told"), [
    (0, 1, ("Units: 1 point lost (once a problem).",)), (1, 0.5, ("Scales: 2 points.", "Units: 0.5 points lost")),
])  # fmt: skip
def test_feedback_tells_what_a_unit_cost_with_scales_or_without(
    tmp_path: Path, scale: float, unit: float, told: tuple[str, ...]
) -> None:
    file = tmp_path / "rules.yaml"
    rubric = f"velocity: {{scale: {scale}, drawn: 5, values: 1}}, acceleration: {{scale: {scale}, drawn: 7, values: 2}}"
    file.write_text(f"rules: {{printed: false, unit: {unit}}}\nrubric: {{{rubric}}}\n", encoding="utf-8")
    rows = {NUMBERS[0]: answers(NUMBERS[0], lambda key, text: f"{text} N" if key == "v_E" else text)}
    graded(
        tmp_path / "out", wide(tmp_path / "a.csv", rows), scheme=read_scheme(file, register()), feedback=True, lang="en"
    )
    with pdfplumber.open(next((tmp_path / "out" / "feedback").iterdir())) as book:
        text = " ".join(page.extract_text() for page in book.pages)
    assert all(sentence in text for sentence in told)


def test_rules_and_points_are_the_lecturers(tmp_path: Path) -> None:
    file = tmp_path / "rules.yaml"
    file.write_text(
        "rules: {own: 0.5, printed: false}\npoints: {3-9: {v_E: {method: 3, accuracy: 2}}}\n", encoding="utf-8"
    )
    scheme = read_scheme(file, register())
    assert scheme.rules.own == 0.5 and scheme.points["3-9"]["v_E"] == Points(method=3, accuracy=2)
    done = graded(tmp_path / "out", wide(tmp_path / "a.csv", everybody()), scheme=scheme)
    assert done.results[0].marks["3-9"]["v_E"].earned.total == 5


def test_the_rules_of_the_manual_can_be_used(tmp_path: Path) -> None:
    text = (Path(__file__).parents[2] / "docs" / "class.md").read_text(encoding="utf-8")
    (tmp_path / "rules.yaml").write_text(text.split("```yaml\n")[-1].partition("```")[0], encoding="utf-8")
    assert read_scheme(tmp_path / "rules.yaml", register()).rules.independent == ("bc2",)


@pytest.mark.parametrize(("text", "why"), [
    ("points: {3-9: {v_Q: {method: 1}}}", "line 1, column 16: points.3-9.v_Q: no quantity 'v_Q'"),
    ("points: {9-9: {v_E: {method: 1}}}", "9-9"),
    ("rules: {owl: 1}", "unknown key 'owl'; did you mean 'own'"),
    ("points: {3-9: {v_E: {methods: 1}}}", "unknown key 'methods'; did you mean 'method'"),
    ("rules:\n  own: 1\n  independent: [bc2, bc7]", "line 3, column 22.*no quantity 'bc7'"),
    ("rules: {own: much}", "a number is expected"), ("rubric: {speed: {drawn: 3}}", "unknown key 'speed'"),
    ("totals: {3-9: 21}", "come to 20, totals says 21"), ("rules: {own: 2}", "rules.own: 2 must be not above 1"),
])  # fmt: skip
def test_rules_that_cannot_be_meant_are_refused_with_where(tmp_path: Path, text: str, why: str) -> None:
    (tmp_path / "rules.yaml").write_text(text, encoding="utf-8")
    with pytest.raises((VecpolyError, UnknownNameError), match=why):
        read_scheme(tmp_path / "rules.yaml", register())


@pytest.mark.parametrize(("name", "data"), [
    ("a.csv", b"name,v_E\nx,1\n"), ("a.xlsx", b"no workbook"),
    ("a.csv", b"\xff\xff\xff\xfe\x80\x81"), ("a.yaml", b"answers: 3\n"),
])  # fmt: skip
def test_a_file_of_no_answers_is_refused_by_name(tmp_path: Path, name: str, data: bytes) -> None:
    (tmp_path / name).write_bytes(data)
    with pytest.raises((TableError, VecpolyError), match=name):
        graded(tmp_path / "out", tmp_path / name)


def test_a_formula_whose_value_the_workbook_lacks_waits_for_a_person(tmp_path: Path) -> None:
    book = Workbook()
    page = book.active
    assert page is not None
    page.append(["学号", "3-9:v_E", "3-9:omega_3"])
    page.append([NUMBERS[0], "=0.1+0.07", "2 顺"])
    book.save(tmp_path / "a.xlsx")
    (mine, *_) = graded(tmp_path / "out", tmp_path / "a.xlsx").results
    assert mine.marks["3-9"]["v_E"].outcome.value == "unreadable"
    queue = (tmp_path / "out" / "queue.csv").read_text("utf-8-sig")
    assert "这是公式" in queue


def test_a_number_of_full_width_digits_is_the_students_own(tmp_path: Path) -> None:
    wide_number = NUMBERS[0].translate({ord("0") + n: ord("０") + n for n in range(10)})
    done = graded(tmp_path / "out", wide(tmp_path / "a.csv", {wide_number: answers(NUMBERS[0])}))
    assert not done.faults and done.results[0].total == 20
    page = json.dumps({"student": wide_number, "answers": {"3-9": answers(NUMBERS[0])}}, ensure_ascii=False)
    (tmp_path / "one.json").write_text(page, encoding="utf-8")
    done = graded(tmp_path / "again", tmp_path / "one.json")
    assert not done.faults and done.results[0].total == 20


def test_the_columns_of_a_problem_come_to_its_total_and_the_page_of_points_to_what_can_be_had(tmp_path: Path) -> None:
    key = register().sheets[0].parts[0].key
    ticks = {row.key: "".join("✓" if known else "?" for known in row.known) for row in key.equations}
    rows = {number: answers(number) | ticks for number in NUMBERS}
    graded(tmp_path / "out", wide(tmp_path / "a.csv", rows))
    for row in csv.DictReader((tmp_path / "out" / "grades.csv").read_text("utf-8-sig").splitlines()):
        parts = [float(text) for head, text in row.items() if head.startswith("3-9:")]
        assert sum(parts) == pytest.approx(float(row["3-9"]), abs=0.02)
    page = load_workbook(tmp_path / "out" / "grades.xlsx")["分值"]
    (whole,) = (row[6] for row in page.iter_rows(values_only=True) if row[2] == "满分")
    assert whole == pytest.approx(key.worth) == 20


def test_what_all_rows_would_say_stands_once_below_the_table_and_no_column_is_empty(tmp_path: Path) -> None:
    """'Too many significant digits (6); 3 suit a drawing' stood in every row of who copies a calculator."""
    mine = {
        key: re.sub(r"^(-?[\d.]+)", lambda m: f"{float(m[1]):.7f}", text) for key, text in answers(NUMBERS[0]).items()
    }
    graded(tmp_path / "out", wide(tmp_path / "a.csv", {NUMBERS[0]: mine}), feedback=True, lang="en")
    with pdfplumber.open(next((tmp_path / "out" / "feedback").iterdir())) as book:
        told = "\n".join(page.extract_text() for page in book.pages)
    assert told.count("Too many significant digits") == 1 and told.count("digits†") > 2


def test_a_table_in_which_all_is_right_has_no_column_for_reasons() -> None:
    heads = ("Equation", "Written", "Verdict", "Points", "of", "Why")
    rows = [("eq. 1", "✓?", "right", "1", "1", "")]
    assert "Why" not in _table(heads, rows, "en").header
    assert "Why" in _table(heads, [(*rows[0][:-1], "because")], "en").header
