"""No English in what is told in Chinese:
every Words made while good and damaged files are read and solved is walked."""

from __future__ import annotations

import re
from pathlib import Path

import numpy as np
import pytest
import typer
from typer.testing import CliRunner

from tests.fuzz.files import damaged_files
from tests.laws import few, often
from vecpoly import load, solve
from vecpoly.cli.app import app
from vecpoly.errors import VecpolyError
from vecpoly.words import Words

QUOTED = re.compile(
    r"“[^”]*”|'[^']*'|\"[^\"]*\"|\{[^{}]*\}|\[[^\]]*\]|\$[^$]*\$|请写如? [^；，]*"
    r"|(?:^|列：)[a-z_.]+：|(?:已有|现有)：.*|R\(1, 2\) at .*|\S*/\S+|U\+[0-9A-F]+（[^）]*）|\S+：(?=未知的键)"
)  # what people wrote, or are to write
SPOKEN = re.compile(r"\b(?:the|of|and|or|is|are|has|have|not|with|where|which|must|cannot|but|it)\b")
CHINESE = re.compile(r"[\u4e00-\u9fff]")


def english_in(words: Words) -> list[str]:
    """English function words outside of quotes and brackets, in a text that is Chinese."""
    return SPOKEN.findall(QUOTED.sub("", words.zh)) if CHINESE.search(words.zh) and words.zh != words.en else []


@pytest.fixture
def made(monkeypatch: pytest.MonkeyPatch) -> list[Words]:
    """All Words that are made from now on."""
    found: list[Words] = []
    plain = Words.__init__

    def kept(self: Words, zh: str, en: str) -> None:
        plain(self, zh, en)
        found.append(self)

    monkeypatch.setattr(Words, "__init__", kept)
    return found


def test_an_english_phrase_in_a_chinese_text_is_seen() -> None:
    assert english_in(
        Words("构件 2、3 在 the loops of the class III group 2, 3 处不能装配", "links 2 and 3 cannot be joined")
    )
    assert not english_in(
        Words("“the loops”不是运动副；请写 4 slides in 5", "'the loops' is no joint; write 4 slides in 5")
    )


def test_what_is_told_of_damaged_files_in_chinese_holds_no_english(made: list[Words], tmp_path: Path) -> None:
    refused, count = 0, often(20)
    for _ in damaged_files(np.random.default_rng(11), count, tmp_path / "p.yaml"):
        try:
            solve(load(tmp_path / "p.yaml"), repeats=0)
        except VecpolyError:
            refused += 1
    wrong = {words.zh: english_in(words) for words in made if english_in(words)}
    assert refused > count / 4 and len(made) > 1000 and not wrong


@pytest.mark.parametrize("name", few(["three-legged-plate", "scissor-lift", "3-5", "4-3a", "geared-five-bar"], 2))
def test_refusals_of_positions_out_of_reach_hold_no_english(made: list[Words], name: str) -> None:
    from dataclasses import replace

    problem = load(name)
    for by in few((0.3, 1.0, 2.0, 4.0), 2):
        drive = problem.mechanism.drive
        moved = replace(
            problem.mechanism, drives=(replace(drive, position=drive.position + by), *problem.mechanism.drives[1:])
        )
        try:
            solve(replace(problem, subject=moved), repeats=0)
        except VecpolyError:
            continue
    assert made and not {words.zh for words in made if english_in(words)}


COMMANDS = sorted(
    command.name or (command.callback.__name__ if command.callback else "") for command in app.registered_commands
)


@pytest.mark.parametrize("command", ["", *COMMANDS])
def test_chinese_help_names_values_in_chinese(command: str) -> None:
    page = CliRunner().invoke(app, [*([command] if command else []), "--help"], env={"VECPOLY_LANG": "zh"}).stdout
    if "用法" not in page:
        pytest.fail(page)
    assert not re.findall(r"<[A-Za-z]+(?:\[\w+\]| \w+)?>", page)  # <list[str]>, <int range>; choices <zh|en> stay
    assert not re.findall(
        r"(?<![\w.])(?!VECPOLY_)[A-Z]{2,}_\w+|\b(?:FILE|PATH|NAME|KEYS?|LETTERS|OPTIONS|ARGS)\b", page
    )


def test_every_command_is_a_typer_command() -> None:
    assert isinstance(app, typer.Typer) and len(COMMANDS) >= 10
