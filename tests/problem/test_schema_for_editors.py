"""Claims about the JSON Schema: it takes every file of the library and of the manual,
refuses what is wrong, and tells every key in two languages."""

from __future__ import annotations

import json
import re
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
from ruamel.yaml import YAML
from typer.testing import CliRunner

from tests.laws import few
from tests.schema_check import errors
from vecpoly.cli import app
from vecpoly.editors import file_schema
from vecpoly.foundation.data import data_dir
from vecpoly.problem.editors import ID, json_schema
from vecpoly.units.patterns import pattern
from vecpoly.units.reading import Dim, read

ROOT = data_dir("problems")
SCHEMA, WHOLE = json_schema(), file_schema()
FILES = sorted(ROOT.rglob("*.yaml"))
DOCS = Path(__file__).resolve().parents[2] / "docs"
FOUR_BAR = """id: a
title: b
frame: {A: [0 mm, 0 mm], D: [120 mm, 0 mm]}
links: {1: {AB: 40 mm}, 2: {BC: 100 mm, E: {along: BC, at: 60 mm}}, 3: {CD: 80 mm}, 4: {block: C}}
joints: [4 slides on y = 0 mm]
input: {link: 1, phi: 60 deg, omega: 10 rad/s ccw}
branch: [C above AD]
loads: {F: {on: 3, at: C, size: 10 N, direction: 0 deg}, M_1: {on: 1, size: "?"}}
friction: {A: {f: 0.1, r: 20 mm}, 3-4: {phi: 8 deg}}
masses: {2: {mass: 3 kg, inertia: 0.02 kg*m^2, centre: E}}
scales: {mu_v: 0.006 (m/s)/mm}
find: [v_C]
"""


def plain(data: Any) -> Any:
    """As an editor sees the file: keys are texts."""
    if isinstance(data, dict):
        return {str(key): plain(value) for key, value in data.items()}
    return [plain(value) for value in data] if isinstance(data, list) else data


def wrong(text: str) -> list[str]:
    return list(errors(WHOLE, WHOLE, plain(YAML(typ="safe", pure=True).load(text))))


@pytest.mark.parametrize("path", few(FILES, 3), ids=lambda path: path.stem)
def test_the_schema_takes_every_file_of_the_library(path: Path) -> None:
    assert wrong(path.read_text(encoding="utf-8")) == []


def test_the_schema_takes_the_whole_files_of_the_manual_and_of_vecpoly_new() -> None:
    blocks = [
        block
        for block in re.findall(r"```yaml\n(.*?)```", (DOCS / "problem-file.md").read_text(encoding="utf-8"), re.S)
        if "title:" in block
    ]
    assert len(blocks) >= 3
    for text in (*blocks, FOUR_BAR):
        assert wrong(text) == []


@pytest.mark.parametrize(
    ("old", "new"),
    [
        ("40 mm", "40 kg"),
        ("40 mm", "40"),
        ("40 mm", "forty mm"),
        ("60 deg", "60 mm"),
        ("10 rad/s ccw", "10 m/s"),
        ("10 rad/s ccw", "10 rad/s round"),
        ("4 slides on y = 0 mm", "4 glides on y = 0 mm"),
        ("4 slides on y = 0 mm", "4 slides"),
        ("C above AD", "C near AD"),
        ("[v_C]", "[5]"),
        ("[v_C]", "[vC²]"),
        ("10 N,", "10 mm,"),
        ('"?"', '"!"'),
        ("3 kg", "3 N"),
        ("0.02 kg*m^2", "0.02 kg"),
        ("0.006 (m/s)/mm", "0.006 m/s"),
        ("f: 0.1", "f: 0.1 mm"),
        ("phi: 8 deg", "phi: 8 mm"),
        ("input:", "inputs:"),
        ("block: C", "blok: C"),
        ("at: 60 mm", "by: 60 mm"),
        ("id: a\n", ""),
        ("frame: {A: [0 mm, 0 mm]", "frame: {A: [0 mm]"),
    ],
)
def test_the_schema_refuses_wrong_units_sentences_symbols_and_keys(old: str, new: str) -> None:
    assert old in FOUR_BAR and wrong(FOUR_BAR) == []
    assert wrong(FOUR_BAR.replace(old, new, 1))


@pytest.mark.parametrize(("kind", "keys"), [(WHOLE["then"], 8), (WHOLE["else"]["then"], 4)])
def test_projects_and_searches_tell_every_key_in_both_languages(kind: dict[str, Any], keys: int) -> None:
    told = [spec.get("description", "") for spec in kind["properties"].values()]
    assert len(told) >= keys and all(" / " in words and re.search("[一-龥]", words) for words in told)


@pytest.mark.parametrize(
    "text", ["title: t\nstatement: s\nparts: {a: {of: 3}, b: [1]}", "title: t\nsearch: gears\ndata: {}"]
)
def test_projects_and_searches_are_checked_too(text: str) -> None:
    assert wrong(text)


def test_numbers_null_and_assignments_are_known() -> None:
    assert wrong("id: x\ntitle: t\nextends: 3-9\nloads: null\nlinks: {4: null}\ninput: {alpha: null, phi: 0}\n") == []
    assert (
        wrong(
            "id: x\ntitle: t\ndevice: structure\ndata: {joints: {A: 'R(0, 1) at (0, 0)'}, drivers: [1, 1+3], "
            "frame: 5}\n"
        )
        == []
    )
    assert wrong("title: t\nproblems: [3-8, {problem: 3-9, input: {omega: 10 rad/s ccw}}]\n") == []
    assert wrong("title: t\nproblems: [{id: 3-9}]\n") and wrong("title: t\nproblems: [3-8]\nlinks: {}\n")


def keys(schema: Any) -> Iterator[tuple[str, dict[str, Any]]]:
    """Every key that the schema describes, but those of conditions."""
    if isinstance(schema, dict):
        yield from schema.get("properties", {}).items()
        for name, inner in schema.items():
            if name not in ("if", "else", "not", "required"):
                yield from keys(inner)
    elif isinstance(schema, list):
        for inner in schema:
            yield from keys(inner)


def test_every_key_is_described_in_chinese_and_english() -> None:
    found = [(name, value) for name, value in keys(SCHEMA) if not (name == "data" and "description" not in value)]
    assert len(found) > 150
    for name, value in found:
        zh, _, en = value.get("description", "").partition(" / ")
        assert re.search("[\u4e00-\u9fff]", zh) and en and not re.search("[\u4e00-\u9fff]", en), name


def test_the_schema_says_what_it_is() -> None:
    assert (
        SCHEMA["$schema"] == "https://json-schema.org/draft/2020-12/schema" and SCHEMA["$id"] == ID and SCHEMA["title"]
    )


@pytest.mark.parametrize("dim", list(Dim))
def test_what_the_pattern_takes_is_read(dim: Dim) -> None:
    assert re.search(pattern(dim), dim.example) and re.search(pattern(dim), "0")
    assert read(dim.example, dim).si
    others = [other.example for other in Dim if other.dimension != dim.dimension and other not in (Dim.MU_L, Dim.MU_F)]
    assert [text for text in others if re.search(pattern(dim), text)] == []


def test_a_new_file_names_its_schema_and_the_schema_lies_beside_it(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    for words in (("new", "mine"), ("new", "other", "--like", "3-9")):
        assert CliRunner().invoke(app, list(words)).exit_code == 0
        text = Path(f"{words[1]}.yaml").read_text(encoding="utf-8")
        assert (
            text.startswith("# yaml-language-server: $schema=vecpoly.schema.json\n")
            and f"id: {words[1]}" in text
            and wrong(text) == []
        )
    assert json.loads(Path("vecpoly.schema.json").read_text(encoding="utf-8")) == json.loads(json.dumps(WHOLE))
