"""Claims about small doors: texts and yes-or-no of a problem file,
files that a command may write to, JSON that is none."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import pytest
from pydantic import TypeAdapter, ValidationError

from vecpoly.cli.commands.exact import _plain
from vecpoly.cli.errors import Tally
from vecpoly.cli.files import put, spared, write_json
from vecpoly.cli.jobs import Job, each, jobs
from vecpoly.errors import VecpolyError
from vecpoly.names import parse_rel
from vecpoly.problem.schema.fields import Text, YesNo
from vecpoly.words import Words

TEXT, YES = TypeAdapter(Text), TypeAdapter(YesNo)


@pytest.mark.parametrize(
    ("value", "zh", "en"),
    [
        ("a", "a", "a"),
        ({"zh": " 甲 ", "en": " a "}, "甲", "a"),
        ({"zh": " 甲 "}, "甲", "甲"),
        ({"en": " a "}, "a", "a"),
        (Words("甲", "a"), "甲", "a"),
    ],
)
def test_a_text_may_be_written_in_one_language_or_in_two(value: Any, zh: str, en: str) -> None:
    assert TEXT.validate_python(value) == Words(zh, en)


@pytest.mark.parametrize(
    "value",
    [
        3,
        [],
        {},
        {"zh": "甲", "de": "a"},
        {"zh": "甲", "en": "a", "de": "a"},
        {"en": "a", "de": "b"},
        {"zh": 3},
        {"de": "a"},
    ],
)
def test_what_is_no_text_is_refused_in_both_languages(value: Any) -> None:
    with pytest.raises((ValidationError, VecpolyError)) as caught:
        TEXT.validate_python(value)
    assert "write a text" in str(caught.value)


@pytest.mark.parametrize(
    ("value", "meant"),
    [
        ("yes", True),
        ("Yes", True),
        ("true", True),
        ("是", True),
        (True, True),
        ("no", False),
        ("NO", False),
        ("false", False),
        ("否", False),
        (False, False),
    ],
)
def test_yes_and_no_are_known_in_both_languages(value: Any, meant: bool) -> None:
    assert YES.validate_python(value) is meant


@pytest.mark.parametrize("value", ["maybe", "1", 1, "", None])
def test_what_is_neither_yes_nor_no_is_refused(value: Any) -> None:
    with pytest.raises((ValidationError, VecpolyError), match="neither yes nor no"):
        YES.validate_python(value)


def problem_of(*files: Path) -> Any:
    return SimpleNamespace(files=files)


def test_a_target_with_a_known_ending_that_nobody_reads_is_spared(tmp_path: Path) -> None:
    read, target = tmp_path / "a.yaml", tmp_path / "b.PDF"
    read.write_text("x")
    assert (
        spared(target, [".pdf"], [problem_of(read)]) == target
        and spared(None, [".pdf"]) is None
        and spared(Path("-"), [".pdf"]) == Path("-")
    )
    assert spared(tmp_path, [".pdf"]) == tmp_path, "a folder has no ending"
    assert spared(Path("/dev/null"), [".pdf"]) == Path("/dev/null")


@pytest.mark.parametrize(
    ("endings", "zh", "en"),
    [([".pdf"], ".pdf", ".pdf"), ([".svg", ".png", ".pdf"], ".svg、.png 或 .pdf", ".svg, .png or .pdf")],
)
def test_another_ending_is_refused_with_those_that_are_known(
    tmp_path: Path, endings: list[str], zh: str, en: str
) -> None:
    with pytest.raises(VecpolyError) as caught:
        spared(tmp_path / "a.docx", endings)
    assert f"what is written here is {en};" in str(caught.value) and zh in caught.value.words.zh


def test_a_file_that_is_read_is_never_written_over_whatever_it_is_called(tmp_path: Path) -> None:
    read, table, link = tmp_path / "a.json", tmp_path / "t.json", tmp_path / "l.json"
    read.write_text("x")
    table.write_text("x")
    link.symlink_to(read)
    for target in (read, link, table):
        with pytest.raises(VecpolyError, match="writing would destroy it"):
            spared(target, [".json"], [problem_of(read)], [table])
    assert (
        spared(tmp_path / "new.json", [".json"], [problem_of(read)], [table])
        and spared(read, [".json"], [problem_of(table)]) == read
    )


@pytest.mark.parametrize(
    ("data", "place"),
    [
        ({"a": [1.0, {"b": float("nan")}]}, "a[1].b"),
        ([0.0, float("inf")], "[1]"),
        ({"a": {"b": (1, -float("inf"))}}, "a.b[1]"),
    ],
)
def test_what_json_cannot_say_is_refused_at_its_place_and_nothing_is_written(
    tmp_path: Path, data: Any, place: str
) -> None:
    with pytest.raises(VecpolyError) as caught:
        write_json(data, tmp_path / "a.json")
    assert str(caught.value).startswith(f"{place} is not finite") and not list(tmp_path.iterdir())


def test_json_is_written_with_its_letters_as_they_are(tmp_path: Path) -> None:
    write_json({"甲": [1, 2.5, None, True, "b"]}, tmp_path / "a.json")
    assert (tmp_path / "a.json").read_text(
        encoding="utf-8"
    ) == '{\n  "甲": [\n    1,\n    2.5,\n    null,\n    true,\n    "b"\n  ]\n}\n'


def test_what_is_put_on_standard_output_is_there_to_the_byte_and_files_are_told(
    tmp_path: Path, capfdbinary: Any
) -> None:
    put(Path("-"), b"\xff\x00x")
    assert capfdbinary.readouterr().out == b"\xff\x00x"
    put(tmp_path / "a.bin", b"\xff\x00x")
    assert (tmp_path / "a.bin").read_bytes() == b"\xff\x00x" and b"a.bin" in capfdbinary.readouterr().err


def test_each_of_several_problems_has_its_own_file() -> None:
    assert each(Path("d/table.csv"), "3-9", 1) == Path("d/table.csv") and each(Path("d/table.csv"), "3-9", 2) == Path(
        "d/table-3-9.csv"
    )


def test_a_name_stands_once_and_an_exercise_for_all_its_parts() -> None:
    assert [job.name for job in jobs(["3-9", "3-9", "3-7"], _Tally())] == [
        "3-9",
        "3-7a",
        "3-7b",
        "3-7c",
        "3-7d",
        "3-7e",
    ]


def test_the_files_of_a_job_are_its_own_and_those_of_its_problems() -> None:
    assert Job(name="a", problems=(problem_of(Path("x"), Path("y")),), path=Path("s")).files == (
        Path("s"),
        Path("x"),
        Path("y"),
    )
    assert Job(name="a", problems=(problem_of(Path("x")),)).files == (Path("x"),)


class _Tally(Tally):
    """Stands for the tally of a command: every job goes well."""

    @contextmanager
    def job(self) -> Iterator[None]:
        yield

    def settle(self) -> None: ...


@pytest.mark.parametrize(
    ("key", "value", "plain"),
    [
        ("omega_3", 2.5, {"unit": "rad/s", "exact": 2.5}),
        ("v_C", 3 + 4j, {"unit": "m/s", "exact": 5.0, "direction_deg": pytest.approx(53.130102)}),
        ("v_C", 0j, {"unit": "m/s", "exact": 0.0, "direction_deg": None}),
        ("p_C", 3 + 4j, {"unit": "m", "exact_xy": [3.0, 4.0]}),
        ("omega_3", float("nan"), {"unit": "rad/s", "exact": None, "undefined": True}),
    ],
)
def test_an_exact_answer_is_told_by_its_kind(key: str, value: complex | float, plain: dict[str, Any]) -> None:
    assert _plain(parse_rel(key), value) == plain
