"""Claims about the language of the terminal: refusals, help, completion; and lists in which one file is bad."""

from __future__ import annotations

import json
import os
import re
import subprocess
import sys
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import pytest
from typer.main import get_command
from typer.testing import CliRunner, Result

from vecpoly.cli import app
from vecpoly.cli.chinese import HELP
from vecpoly.cli.completion import ids
from vecpoly.cli.help import english_of

Run = Callable[..., Result]
BAD = 'id: bad\ntitle: "x\n'
SHEET = "title: {zh: 作业}\nproblems: [3-9, 3-12]\n"


@pytest.fixture
def run(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Run:
    monkeypatch.chdir(tmp_path)
    monkeypatch.delenv("VECPOLY_LANG", raising=False)
    monkeypatch.setenv("TERMINAL_WIDTH", "100")
    Path("bad.yaml").write_text(BAD, encoding="utf-8")
    Path("sheet.yaml").write_text(SHEET, encoding="utf-8")
    return lambda *args, **env: CliRunner().invoke(app, list(args), env=env)


def commands() -> Iterator[tuple[str, Any]]:
    root = get_command(app)
    yield "", root
    yield from root.commands.items()  # type: ignore[attr-defined]


def test_every_help_text_has_its_chinese_and_no_chinese_is_left_over() -> None:
    asked = {"Show this message and exit."}
    for _, command in commands():
        asked |= {english_of(command), *(param.help for param in command.params)}
    assert asked - HELP.keys() == set() and HELP.keys() - asked == set()
    assert all(re.search("[\u4e00-\u9fff]", zh) for zh in HELP.values())


@pytest.mark.parametrize("name", [name for name, _ in commands()])
def test_help_is_chinese_where_it_is_said(run: Run, name: str) -> None:
    words = [name] if name else []
    for result in (
        run("--lang", "zh", *words, "--help"),
        run(*words, "-h", VECPOLY_LANG="zh"),
        run("--lang=zh", *words, "-h"),
    ):
        assert result.exit_code == 0 and "用法：" in result.stdout and "选项：" in result.stdout
        assert not re.search(r"\b[a-z]{3,} [a-z]{3,} [a-z]{3,} [a-z]{3,}\b", result.stdout)
    assert "Usage:" in run(*words, "--help").stdout


@pytest.mark.parametrize(
    ("args", "zh"),
    [
        (("solve", "--foo"), "没有选项 --foo"),
        (("foo",), "没有命令“foo”"),
        (("solve",), "缺少参数"),
        (("cycle", "A-27", "-n", "1"), "不得小于 2"),
        (("solve", "3-9", "--hand", "x"), "应为 'exact', 'drafting', 'pencil' 之一"),
        (("solve", "nix"), "没有题目“nix”"),
        (("solve", "bad.yaml"), "bad.yaml 第 2 行第 8 列"),
        (("report", "3-9", "-o", "base.docx"), "写出的是 .pdf 文件"),
        (("play", "3-9", "-o", "a.pdf"), "写出的是 .html 或 .htm 文件"),
        (("draw", "3-9", "-o", "a.gif"), "写出的是 .svg、.png、.pdf 或 .dxf 文件"),
        (("new", "bad.yaml"), "已存在"),
    ],
)
def test_what_is_refused_is_told_in_the_language_that_is_said(run: Run, args: tuple[str, ...], zh: str) -> None:
    said = run(*args, VECPOLY_LANG="zh")
    assert said.exit_code == 2 and zh in said.stderr
    assert "查看用法" in said.stderr or not re.search(r"\b[a-z]{4,} [a-z]{4,} [a-z]{4,}\b", said.stderr)
    assert not re.search("[\u4e00-\u9fff]", run(*args).stderr)


def test_a_report_in_chinese_without_a_word_about_the_language_is_still_told_about_in_english(run: Run) -> None:
    assert (
        "the quote" in run("report", "bad.yaml").stderr and "引号" in run("report", "bad.yaml", "--lang", "zh").stderr
    )


def test_refusals_as_json_are_one_line_each_with_place_and_remedy(run: Run) -> None:
    result = run("--errors", "json", "solve", "bad.yaml", "3-99")
    one, two = (json.loads(line) for line in result.stderr.splitlines())
    assert one["error"] == "ProblemFileError" and one["faults"][0]["line"] == 2 and one["faults"][0]["column"] == 8
    assert two["faults"][0]["code"] == "unknown-name" and "did you mean '3-9'" in two["faults"][0]["en"]


def test_one_bad_file_does_not_stop_the_reports_of_the_others(run: Run) -> None:
    result = run("report", "bad.yaml", "3-12", "--style", "question")
    assert result.exit_code == 2 and Path("3-12.question.zh.pdf").is_file() and "bad.yaml" in result.stderr
    assert not Path("base.docx").exists()


@pytest.mark.parametrize(
    "args",
    [("solve", "sheet.yaml"), ("exact", "sheet.yaml"), ("check", "sheet.yaml"), ("cycle", "sheet.yaml", "-n", "12")],
)
def test_an_assignment_stands_wherever_a_problem_does(run: Run, args: tuple[str, ...]) -> None:
    result = run(*args)
    assert result.exit_code == 0 and "3-9  " in result.stdout and "3-12  " in result.stdout


def test_an_assignment_gives_a_player_and_a_drawing_a_problem(run: Run) -> None:
    assert (
        run("play", "sheet.yaml", "--places", "0").exit_code == 0
        and run("draw", "sheet.yaml", "--figure", "velocity", "-o", "v.svg").exit_code == 0
    )
    assert {path.name for path in Path().glob("*.html")} == {"3-9.html", "3-12.html"}
    assert {path.name for path in Path().glob("*.svg")} == {"v-3-9.svg", "v-3-12.svg"}


def test_answers_beside_a_problem_are_checked_with_a_reason(run: Run) -> None:
    right, wrong = run("check", "3-12", "v_D=0.49"), run("check", "3-12", "v_D=0.49", "ω5=4.72", "α3=12 rad/s² 顺")
    assert right.exit_code == 0 and "right" in right.stdout and wrong.exit_code == 1
    assert (
        "Link 3 does not turn here" in wrong.stdout
        and "构件 3 平动" in run("check", "3-12", "α3=12", "--lang", "zh").stdout
    )
    assert "of which problem" in run("check", "v_D=0.49").stderr
    assert "'kg' is no unit of this quantity (it should be m/s)" in run("check", "3-12", "v_D=1 kg").stdout


@pytest.mark.parametrize("words", [("v_D 0.49",), ("v_D", "0.49"), ("v_D  0.49 m/s",), ("v_D", "0.49 m/s")])
def test_an_answer_without_its_equals_sign_is_understood(run: Run, words: tuple[str, ...]) -> None:
    shown = run("check", "3-12", *words)
    assert shown.exit_code == 0 and "v_D" in shown.stdout and "right" in shown.stdout


def test_a_number_of_nothing_is_asked_back_and_an_unknown_problem_is_one(run: Run) -> None:
    assert "write v_E=0.173" in run("check", "3-9", "0.173").stderr
    assert "no problem '3-99'" in run("check", "3-99").stderr
    assert "no problem 'hello world'" in run("check", "3-9", "hello world").stderr


def test_checked_answers_go_to_programs_too(run: Run) -> None:
    found = json.loads(run("check", "3-12", "v_D=490 m/s", "--json", "-").stdout)
    assert not found["right"] and [one["id"] for one in found["answers"][0]["messages"]] == ["pow10"]
    assert run("check", "3-12", "v_Q=1").exit_code == 2 and run("check", "3-7", "v_D=1").exit_code == 2


def test_ids_are_completed_with_their_titles() -> None:
    assert ("3-12", "Slider-crank with a slotted rocker") in ids("3-1") and ids("zzz") == []


def test_the_shell_is_given_completions() -> None:
    done = subprocess.run(
        [sys.executable, "-m", "vecpoly"],
        capture_output=True,
        text=True,
        check=False,
        timeout=60,
        env={**os.environ, "_VECPOLY_COMPLETE": "complete_bash", "COMP_WORDS": "vecpoly play 3-1", "COMP_CWORD": "2"},
    )
    assert "3-12" in done.stdout.split() and "3-9" not in done.stdout.split()


def test_json_has_no_rounding_noise_and_one_west(run: Run) -> None:
    for command in ("solve", "exact"):
        data = json.loads(run(command, "3-5", "3-12", "--json", "-").stdout)
        floats = re.findall(r"-?\d+\.\d+(?:e-?\d+)?", json.dumps(data))
        assert (
            len(floats) > 20 and max(len(one.partition("e")[0].strip("-0.").replace(".", "")) for one in floats) <= 12
        )
        assert "-180.0" not in floats


def test_directions_go_from_0_to_below_360_degrees_however_they_were_rounded() -> None:
    from vecpoly.answer import bearing

    assert bearing(complex(-1, -1e-17)) == bearing(complex(-1, 1e-17)) == pytest.approx(180.0)
    assert all(bearing(complex(1, off)) == pytest.approx(0.0, abs=1e-9) for off in (-1e-17, 0.0, 1e-17))
    assert bearing(complex(-1, -1e-3)) > 180 and bearing(complex(1, -1e-3)) < 360


def test_characters_that_no_face_has_are_named_before_they_are_printed(run: Run) -> None:
    from vecpoly import load

    Path("rare.yaml").write_text(
        load("3-12").text.replace("id: 3-12", "id: rare").replace("曲柄滑块机构", "曲柄㛃块机构"), encoding="utf-8"
    )
    result = run("report", "rare.yaml", "3-12", "--style", "question", "--lang", "zh")
    assert (
        result.exit_code == 0
        and "rare：字体中没有“㛃”，将印作 [U+36C3]" in result.stderr
        and result.stderr.count("字体") == 1
    )
    assert "no face has '㛃'" in run("draw", "rare.yaml", "--figure", "velocity", "-o", "v.svg").stderr


@pytest.mark.parametrize(
    ("words", "said"),
    [
        (["solve", "3-9", "--hand", "foo"], "'foo' is not one of 'exact', 'drafting', 'pencil'"),
        (["solve", "3-9", "--seed", "x"], "'--seed': a whole number is expected"),
        (["solve", "3-9", "--seed", "-1"], "'--seed': it must not be below 0"),
        (["draw", "3-9", "--dpi", "x"], "'--dpi': a number is expected"),
        (["draw", "3-9", "--dpi", "9999"], "'--dpi': it must not be above 1200"),
    ],
)
def test_a_bad_value_of_an_option_is_told_in_plain_english(run: Run, words: list[str], said: str) -> None:
    result = run(*words)
    assert result.exit_code == 2 and said in " ".join(result.stderr.split())
    assert "Value error" not in result.stderr and "Input should" not in result.stderr
