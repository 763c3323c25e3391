"""Claims about the command line: what it prints, what it writes, how it refuses."""

from __future__ import annotations

import json
import re
from collections.abc import Callable
from pathlib import Path
from typing import get_args

import pytest
from typer.testing import CliRunner, Result

from tests.texts import CLASS_IV
from vecpoly.board.hand import HandName
from vecpoly.cli import app
from vecpoly.cli.options import Hand, Lang, Style
from vecpoly.report.document import STYLES
from vecpoly.words import Lang as ReportLang

Run = Callable[..., Result]


@pytest.fixture
def run(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Run:
    monkeypatch.chdir(tmp_path)
    return lambda *words: CliRunner().invoke(app, [str(word) for word in words], prog_name="vecpoly")


def pdf_text(path: Path) -> str:
    import pypdf

    return "".join(page.extract_text() for page in pypdf.PdfReader(path).pages)


def test_the_choices_offered_are_those_of_the_program() -> None:
    assert get_args(Hand) == get_args(HandName)
    assert get_args(Lang) == get_args(ReportLang)
    assert get_args(Style) == STYLES


# -- solve ------------------------------------------------------------------------------------------------------


def test_solve_json_has_the_promised_shape(run: Run) -> None:
    data = json.loads(run("solve", "3-9", "--hand", "exact", "--json", "-").stdout)
    assert (data["id"], data["hand"]) == ("3-9", "exact")
    speed, turn = data["answers"]["v_E"], data["answers"]["omega_3"]
    assert speed["unit"] == "m/s" and speed["drawn"] == pytest.approx(0.172678, rel=1e-5)
    assert speed["direction_deg"] == pytest.approx(312.3473, rel=1e-5)
    assert speed["reading_mm"] == pytest.approx(28.7796, rel=1e-5)
    assert turn["exact"] == pytest.approx(-1.99524, rel=1e-5) and turn["sense"] == "cw"
    assert speed["expected_error"] > 0 and "direction_deg" not in turn


def test_several_problems_make_a_list_and_one_makes_none(run: Run) -> None:
    assert [one["id"] for one in json.loads(run("solve", "3-9", "3-14", "--json", "-").stdout)] == ["3-9", "3-14"]
    assert isinstance(json.loads(run("solve", "3-9", "--json", "-").stdout), dict)


def test_json_to_a_file_leaves_the_table_in_the_terminal(run: Run, tmp_path: Path) -> None:
    result = run("solve", "3-9", "--json", "new/folder/a.json")
    assert "ω_3" in result.stdout and json.loads((tmp_path / "new/folder/a.json").read_text("utf-8"))["id"] == "3-9"
    assert [p.name for p in (tmp_path / "new/folder").iterdir()] == ["a.json"]


def test_the_table_has_a_line_for_every_question(run: Run) -> None:
    shown = run("solve", "3-9").stdout
    for symbol in ("v_E", "a_E", "ω_3", "α_3", "a^k_C2C3"):
        assert len(re.findall(rf"^ {re.escape(symbol)} ", shown, re.M)) == 1
    assert "28.80" in shown and "↻ cw" in shown


def test_the_table_speaks_chinese(run: Run) -> None:
    shown = run("solve", "3-9", "--lang", "zh").stdout
    assert "摇块机构的速度与加速度" in shown and "预期误差" in shown and "顺时针" in shown


def test_a_seed_repeats_the_same_unsteady_hand(run: Run) -> None:
    first, again, other = (run("solve", "3-9", "--hand", "pencil", "--seed", seed).stdout for seed in (4, 4, 5))
    assert first == again != other


def test_bad_problems_do_not_stop_the_good_ones_and_the_exit_code_tells(run: Run) -> None:
    result = run("solve", "3-9", "3-99", "nowhere.yaml", "--json", "a.json")
    assert result.exit_code == 2 and "v_C2B" in result.stdout
    assert [one["id"] for one in json.loads(Path("a.json").read_text())] == ["3-9"]
    assert result.stderr.count("vecpoly: ") == 2 and "did you mean '3-9'?" in result.stderr


# -- check ------------------------------------------------------------------------------------------------------


def test_check_tells_ten_times_too_large(run: Run) -> None:
    shown = run("check", "3-14").stdout
    assert "wrong" in shown and "10 times the exact value" in shown


def test_check_tells_an_impossible_solution(run: Run) -> None:
    assert "impossible" in run("check", "3-5").stdout
    assert json.loads(run("check", "3-5", "--json", "-").stdout)["possible"] is False


def test_check_tells_a_drawing_slip_of_4_7_per_cent(run: Run) -> None:
    line = next(row for row in run("check", "3-9").stdout.splitlines() if "α_2" in row)
    assert "−4.74 %" in line and "drafting error" in line


def test_check_json_gives_every_verdict(run: Run) -> None:
    data = json.loads(run("check", "3-9", "--json", "-").stdout)
    verdicts = {line["symbol"]: line["verdict"] for line in data["answers"]}
    assert verdicts["v_E"] == "reproduced" and verdicts["alpha_2"] == "outlier" and data["possible"] is True


def test_check_says_where_there_is_nothing_to_check(run: Run) -> None:
    assert "no printed answers" in run("check", "A-27").stdout


# -- report, draw, demo -------------------------------------------------------------------------------------------


def test_report_writes_one_pdf_in_the_language_asked(run: Run, tmp_path: Path) -> None:
    assert run("report", "3-9", "--lang", "en", "-o", "x.pdf").exit_code == 0
    assert "Oscillating-block linkage" in pdf_text(tmp_path / "x.pdf")
    assert run("report", "3-9", "--style", "question", "-o", "q.pdf").exit_code == 0
    assert "摇块机构" in pdf_text(tmp_path / "q.pdf")


def test_many_reports_go_to_a_folder_or_into_one_file(run: Run, tmp_path: Path) -> None:
    assert run("report", "2-9", "5-1", "-o", "sheets").exit_code == 0
    assert sorted(p.name for p in (tmp_path / "sheets").iterdir()) == ["2-9.zh.pdf", "5-1.zh.pdf"]
    assert run("report", "2-9", "5-1", "-o", "both.pdf", "--lang", "en").exit_code == 0
    text = pdf_text(tmp_path / "both.pdf")
    assert "Problem 2-9" in text and "Problem 5-1" in text


def test_an_assignment_is_one_pdf_with_its_title_block(run: Run, tmp_path: Path) -> None:
    sheet = "title: {zh: 作业三, en: Homework 3}\ntitle_block: {class: ME-21, teacher: Li}\nproblems: [3-9, 3-14]\n"
    (tmp_path / "week3.yaml").write_text(sheet, encoding="utf-8")
    assert run("report", "week3.yaml", "--lang", "en").exit_code == 0
    text = pdf_text(tmp_path / "week3.en.pdf")
    assert "Homework 3" in text and "ME-21" in text and "Li" in text


def test_two_documents_never_share_a_file(run: Run, tmp_path: Path) -> None:
    run("new", "a/same.yaml")
    run("new", "b/same.yaml")
    result = run("report", "a/same.yaml", "b/same.yaml", "-o", "out")
    assert result.exit_code == 2 and "two of the documents" in result.stderr and not (tmp_path / "out").exists()


@pytest.mark.parametrize(("ending", "magic"), [("svg", b"<svg"), ("png", b"\x89PNG"), ("pdf", b"%PDF")])
def test_draw_knows_three_formats(run: Run, tmp_path: Path, ending: str, magic: bytes) -> None:
    for figure in ("velocity", "sheet"):
        assert run("draw", "3-9", "--figure", figure, "-o", f"x.{ending}").exit_code == 0
        assert (tmp_path / f"x.{ending}").read_bytes().startswith(magic)


def test_a_sheet_in_svg_is_an_a4_page(run: Run, tmp_path: Path) -> None:
    sizes = ('width="210.000mm" height="297.000mm"', 'width="297.000mm" height="210.000mm"')
    for name, size in zip(("3-5", "3-9"), sizes, strict=True):
        run("draw", name, "-o", "x.svg")
        assert size in (tmp_path / "x.svg").read_text("utf-8")


def test_draw_refuses_other_formats_and_figures_that_do_not_exist(run: Run) -> None:
    other, missing = run("draw", "3-9", "-o", "x.gif"), run("draw", "3-4a", "--figure", "acceleration", "-o", "x.svg")
    assert (other.exit_code, missing.exit_code) == (2, 2)
    assert ".svg, .png, .pdf or .dxf" in other.stderr and "mechanism, velocity" in missing.stderr


# -- list, new, schema ----------------------------------------------------------------------------------------------


def test_list_shows_problems_and_methods(run: Run) -> None:
    shown = run("list").stdout
    assert all(name in shown for name in ("3-4a", "3-14", "A-27", "C-conveyor")) and "$" not in shown
    assert "Velocity of an RRR group" in run("list", "methods").stdout


def test_new_writes_a_file_that_solves_and_never_overwrites(run: Run, tmp_path: Path) -> None:
    assert run("new", "press").exit_code == 0
    assert json.loads(run("solve", "press.yaml", "--json", "-").stdout)["id"] == "press"
    (tmp_path / "press.yaml").write_text("mine", encoding="utf-8")
    again = run("new", "press.yaml")
    assert again.exit_code == 2 and "exists already" in again.stderr
    assert (tmp_path / "press.yaml").read_text("utf-8") == "mine"


def test_schema_is_a_json_schema(run: Run, tmp_path: Path) -> None:
    assert json.loads(run("schema").stdout)["else"]["else"]["properties"]["frame"]
    assert run("schema", "-o", "vecpoly.schema.json").stdout == ""
    assert json.loads((tmp_path / "vecpoly.schema.json").read_text("utf-8"))["title"] == "vecpoly problem file"


# -- refusals ---------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    "words",
    [
        ("solve", "3-9", "--json", "file/x.json"),
        ("report", "3-9", "-o", "file/x.pdf"),
        ("draw", "3-9", "-o", "file/x.svg"),
        ("new", "file/x.yaml"),
        ("schema", "-o", "file/x.json"),
        ("solve", "3-9", "--json", "folder"),
    ],
)
def test_a_place_that_cannot_be_written_is_named_in_one_line(run: Run, tmp_path: Path, words: tuple[str, ...]) -> None:
    (tmp_path / "file").write_text("in the way", encoding="utf-8")
    (tmp_path / "folder").mkdir()
    result = run(*words)
    assert result.exit_code == 2 and re.fullmatch(r"vecpoly: (file|folder)\b.*\n", result.stderr)
    assert ".tmp" not in result.stderr


def test_a_file_where_a_folder_should_be_is_named_as_what_is_in_the_way(run: Run, tmp_path: Path) -> None:
    (tmp_path / "file").write_text("in the way", encoding="utf-8")
    assert run("report", "3-9", "-o", "file").stderr == "vecpoly: file: is a file, not a folder; choose another place\n"


def test_every_fault_of_a_file_gets_its_line(run: Run, tmp_path: Path) -> None:
    run("new", "x.yaml")
    text = (tmp_path / "x.yaml").read_text("utf-8").replace("AB: 40 mm", "AB: 40 kg").replace("omega: 10", "omegaa: 10")
    (tmp_path / "x.yaml").write_text(text, encoding="utf-8")
    result = run("solve", "x.yaml")
    assert result.exit_code == 2 and "Traceback" not in result.stderr
    assert all(line.startswith("vecpoly: x.yaml, line ") for line in result.stderr.splitlines())


def test_a_refusal_to_solve_names_the_file_the_line_and_what_it_is_about(run: Run, tmp_path: Path) -> None:
    run("new", "loose.yaml")
    text = (tmp_path / "loose.yaml").read_text("utf-8").replace("CD: 80 mm", "CD: 2 mm")
    (tmp_path / "loose.yaml").write_text(text, encoding="utf-8")
    for words in (("solve",), ("draw",), ("report", "-o", "x.pdf")):
        result = run(words[0], "loose.yaml", *words[1:])
        assert result.exit_code == 2
        assert re.fullmatch(r"vecpoly: loose.yaml, line 1\d, column 1: input: .*\n", result.stderr)
    (fault,) = json.loads(run("--errors", "json", "solve", "loose.yaml").stderr)["faults"]
    assert (fault["file"], fault["path"]) == ("loose.yaml", "input") and fault["line"] > 10
    assert fault["numbers"]["joint"] == "C" and fault["numbers"]["missing"] > 0
    assert sorted(p.name for p in tmp_path.iterdir()) == ["loose.yaml", "vecpoly.schema.json"]


def test_one_problem_that_fails_does_not_stop_the_others(run: Run, tmp_path: Path) -> None:
    run("new", "loose.yaml")
    text = (tmp_path / "loose.yaml").read_text("utf-8").replace("CD: 80 mm", "CD: 2 mm")
    (tmp_path / "loose.yaml").write_text(text, encoding="utf-8")
    result = run("report", "loose.yaml", "3-9", "-o", "out")
    assert result.exit_code == 2 and [p.name for p in (tmp_path / "out").iterdir()] == ["3-9.zh.pdf"]


def test_an_exercise_with_parts_stands_for_all_of_them() -> None:
    from vecpoly.problem.library import family

    assert family("3-7") == ("3-7a", "3-7b", "3-7c", "3-7d", "3-7e")
    assert family("3-4") == ("3-4a", "3-4a-straight", "3-4b")
    assert family("3-9") == ()


def test_answers_of_one_linkage_of_several_say_so(run: Run, tmp_path: Path) -> None:
    file, asked = tmp_path / "k.yaml", "find: [AB, BC, gamma_min]\n"
    data = "data: {K: 1.2, CD: 60 mm, swing: 45 deg, AD: 70 mm}\n"
    file.write_text(f"id: k\ntitle: k\nsynthesis: crank-rocker\n{data}{asked}", encoding="utf-8")
    for command in ("exact", "solve"):
        told = run(command, str(file)).stderr
        assert re.search(r"there are 2 solutions, and these answers are of the first; .*_2, or write take: 2", told)
    file.write_text(file.read_text(encoding="utf-8").replace("AB,", "AB, AB_2,"), encoding="utf-8")
    assert "solutions" not in run("exact", str(file)).stderr


def test_exact_answers_a_class_iv_linkage_that_cannot_be_drawn(run: Run, tmp_path: Path) -> None:
    file = tmp_path / "c4.yaml"
    file.write_text(CLASS_IV, encoding="utf-8")
    drawn = run("solve", str(file))
    assert drawn.exit_code == 2 and "vecpoly exact" in drawn.stderr
    answers = json.loads(run("exact", str(file), "--json", "-").stdout)["answers"]
    assert set(answers) == {"v_C", "omega_3"} and answers["v_C"]["exact"] > 0
