"""vecpoly grade on the command line: the folder of a class in, a folder of marks out."""

from __future__ import annotations

import json
from pathlib import Path

import pytest
from typer.testing import CliRunner

from tests.marked.classes import NUMBERS, answers, register, wide
from vecpoly.batch.register import NAME
from vecpoly.cli.app import app
from vecpoly.errors import VecpolyError
from vecpoly.foundation.slotted import replace
from vecpoly.marked.out.record import differences, read_record
from vecpoly.words import many


def run(folder: Path, *arguments: str) -> tuple[int, str]:
    (folder / "hw").mkdir(exist_ok=True)
    (folder / "hw" / NAME).write_bytes(register().as_bytes())
    wide(folder / "a.csv", {number: answers(number) for number in NUMBERS[:2]})
    words = ["grade", str(folder / "hw"), str(folder / "a.csv"), "-o", str(folder / "out"), "-j", "1", *arguments]
    done = CliRunner().invoke(app, words)
    return done.exit_code, done.stderr


def test_the_marks_of_a_class_are_written_and_told(tmp_path: Path) -> None:
    code, said = run(tmp_path, "--no-feedback")
    assert code == 0 and "3 students, 1 returned nothing, 0 answers or rows wait for a person" in said
    assert {path.name for path in (tmp_path / "out").iterdir()} == {
        "grades.csv",
        "grades.xlsx",
        "queue.csv",
        "marks.json",
    }
    flat = "".join(said.split())  # a terminal breaks its lines
    assert all(f"wrote{path}" in flat for path in (tmp_path / "out").iterdir())
    again, said = run(tmp_path, "--no-feedback", "--diff", str(tmp_path / "out"))
    assert again == 0 and "0 answers are marked otherwise" in said


def test_what_cannot_be_graded_is_refused_in_a_sentence(tmp_path: Path) -> None:
    for words, why in ((("--rules", "none.yaml"), "none.yaml"), (("--diff", str(tmp_path)), "marks.json")):
        code, said = run(tmp_path, "--no-feedback", *words)
        assert code == 2 and why in said and "Traceback" not in said


def test_a_stranger_in_the_answers_is_told_and_the_rest_is_marked(tmp_path: Path) -> None:
    run(tmp_path)
    wide(tmp_path / "b.csv", {"2099999": answers(NUMBERS[0])})
    words = [
        "grade",
        str(tmp_path / "hw"),
        str(tmp_path / "a.csv"),
        str(tmp_path / "b.csv"),
        "-o",
        str(tmp_path / "two"),
        "--no-feedback",
    ]
    done = CliRunner().invoke(app, words)
    assert done.exit_code == 2 and "2099999" in done.stderr and (tmp_path / "two" / "grades.csv").exists()


def test_the_key_of_a_class_is_not_taken_for_its_answers(tmp_path: Path) -> None:
    """Everybody would have all points."""
    run(tmp_path, "--no-feedback")
    key = wide(tmp_path / "hw" / "key.xlsx", {NUMBERS[0]: answers(NUMBERS[0])})
    words = ["grade", str(tmp_path / "hw"), str(key), "-o", str(tmp_path / "out2"), "--lang", "en"]
    done = CliRunner().invoke(app, words)
    assert done.exit_code == 2 and "is the key of this class" in " ".join(done.stderr.split())
    assert not (tmp_path / "out2").exists()


def test_one_answer_that_is_marked_otherwise_is_one(tmp_path: Path) -> None:
    run(tmp_path, "--no-feedback")
    rows = {number: answers(number) for number in NUMBERS[:2]}
    rows[NUMBERS[0]]["v_E"] = "0.9"
    wide(tmp_path / "b.csv", rows)
    words = ["grade", str(tmp_path / "hw"), str(tmp_path / "b.csv"), "-o", str(tmp_path / "two"), "--no-feedback"]
    done = CliRunner().invoke(app, [*words, "--diff", str(tmp_path / "out"), "--lang", "en"])
    assert done.exit_code == 0 and "1 answer is marked otherwise" in done.stderr


@pytest.mark.parametrize(
    ("count", "what", "said"),
    [
        (1, "students", "1 student"),
        (2, "students", "2 students"),
        (0, "students", "0 students"),
        (1, "answers or rows", "1 answer or row"),
    ],
)
def test_one_is_told_in_the_singular(count: int, what: str, said: str) -> None:
    assert many(count, what) == said


@pytest.mark.parametrize(
    ("lang", "extra", "head"),
    [("en", (), "number,name"), ("zh", (), "学号,姓名"), ("en", ("--lang", "zh"), "学号,姓名")],
)
def test_marks_are_told_in_the_language_of_the_class_where_nothing_is_said(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, lang: str, extra: tuple[str, ...], head: str
) -> None:
    """An English class had Chinese feedback."""
    monkeypatch.delenv("VECPOLY_LANG", raising=False)
    run(tmp_path)
    (tmp_path / "hw" / NAME).write_bytes(replace(register(), lang=lang).as_bytes())
    words = ["grade", str(tmp_path / "hw"), str(tmp_path / "a.csv"), "-o", str(tmp_path / "two"), "--no-feedback"]
    for _ in range(2):
        again = ["--diff", str(tmp_path / "two")] if (tmp_path / "two").exists() else []
        assert CliRunner().invoke(app, [*words, *extra, *again]).exit_code == 0
    assert (tmp_path / "two" / "grades.csv").read_text("utf-8-sig").startswith(head)
    assert (tmp_path / "two" / "changes.csv").read_text("utf-8-sig").startswith(head.split(",")[0])


def test_changes_are_told_in_the_words_of_the_class(tmp_path: Path) -> None:
    """Verdicts were those of the record, in English."""
    before, after = (
        {
            "students": [
                {
                    "number": "1",
                    "problems": {
                        "3-9": {
                            "answers": [{"key": "v_E", "outcome": outcome, "points": points, "written": "0.5"}],
                            "lines": [{"key": "v_E", "verdict": verdict, "points": points}],
                            "stated": {"mu_v": 1.0},
                            "lost": lost,
                        }
                    },
                }
            ]
        }
        for outcome, verdict, points, lost in (("right", "right", 2.0, 0.0), ("sense", "missing", 0.0, 0.5))
    )
    assert differences(before, after, "zh") == [
        ["1", "3-9", "v_E", 2.0, "正确", "0.5", 0.0, "转向或符号错", "0.5"],
        ["1", "3-9", "v_E（线）", 2.0, "正确", "", 0.0, "漏画", ""],
        ["1", "3-9", "单位", "", "", "", -0.5, "", ""],  # a total changed, and nothing was told
    ]
    assert [row[4::3] for row in differences(before, after, "en")] == [
        ["right", "wrong sense"],
        ["right", "missing"],
        ["", ""],
    ]


PROBLEMS: tuple[object, ...] = (
    [],
    {"3-9": 1},
    {"3-9": {"answers": [{"key": "v", "outcome": "fair", "points": 1, "written": ""}]}},
    {"3-9": {"answers": [{"key": "v", "outcome": "right", "points": "x", "written": ""}]}},
)
DAMAGED = (
    "",
    "[]",
    '{"version": 1}',
    '{"version": 1, "students": [{}]}',
    '{"version": 1, "students": 3}',
    *(json.dumps({"version": 1, "students": [{"number": "1", "problems": one}]}) for one in PROBLEMS),
)


@pytest.mark.parametrize("text", DAMAGED)
def test_a_damaged_record_of_marks_is_no_record(tmp_path: Path, text: str) -> None:
    (tmp_path / "marks.json").write_text(text, encoding="utf-8")
    with pytest.raises(VecpolyError, match="no marks"):
        read_record(tmp_path)
