"""Claims about CONTRIBUTING.md and the notebook: what they say to do works as it is written."""

from __future__ import annotations

import ast
import doctest
import json
import re
import signal
import sys
import tomllib
from pathlib import Path
from typing import Any

import pytest

from vecpoly.__main__ import main

ROOT = Path(__file__).resolve().parents[2]
PAGE = (ROOT / "CONTRIBUTING.md").read_text(encoding="utf-8")
NOTEBOOK = ROOT / "docs" / "notebook.ipynb"


def commands() -> list[list[str]]:
    return [line.split() for text in re.findall(r"```sh\n(.*?)```", PAGE, re.S) for line in text.splitlines()]


def test_its_commands_do_what_they_say(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr(signal, "signal", lambda *_: None)  # Ctrl-C is to end the tests as ever
    done = [words for words in commands() if words[0] == "vecpoly"]
    for words in done:
        monkeypatch.setattr(sys, "argv", words)
        with pytest.raises(SystemExit) as left:
            main()
        assert left.value.code in (0, 1 if words[1] == "check" else 0), " ".join(
            words
        )  # what is wrong in print is no failure of ours
        assert "-o" not in words or Path(words[-1]).stat().st_size > 0
    assert len(done) > 6 and "vecpoly:" not in capsys.readouterr().err


def test_the_tests_that_it_runs_are_there() -> None:
    *whole, (_, file, *words) = [words for words in commands() if words[0] == "pytest"]
    assert [(ROOT / path).is_file() for _, path in whole] == [True]
    assert words[0] == "-k" and re.search(rf"^def test_\w*{words[1]}", (ROOT / file).read_text("utf-8"), re.M)


def test_make_knows_what_it_is_told_to_make() -> None:
    targets = re.findall(r"^(\w+):", (ROOT / "Makefile").read_text(encoding="utf-8"), re.M)
    told = [words[1] for words in commands() if words[0] == "make"]
    assert told and set(told) <= set(targets)


def test_its_python_session_goes_as_it_is_written() -> None:
    (session,) = re.findall(r"```pycon\n(.*?)```", PAGE, re.S)
    test = doctest.DocTestParser().get_doctest(session, {}, "session", "CONTRIBUTING.md", 0)
    said: list[str] = []
    assert doctest.DocTestRunner().run(test, out=said.append) == doctest.TestResults(0, len(test.examples)), "".join(
        said
    )


def test_every_file_that_it_names_is_there() -> None:
    named = set(re.findall(r"`((?:vecpoly|docs|tests|problems)/[\w./*]+)`|\]\(([\w./]+)\)", PAGE))
    paths = {one or other for one, other in named}
    assert len(paths) > 10
    for path in paths:
        assert list(ROOT.glob(path.rstrip("/"))), path


def test_its_entry_points_are_the_groups_that_are_asked() -> None:
    from vecpoly.foundation.plugins import DEVICES, METHODS

    (text,) = re.findall(r"```toml\n(.*?)```", PAGE, re.S)
    assert set(tomllib.loads(text)["project"]["entry-points"]) == {DEVICES, METHODS}


@pytest.mark.parametrize("name", ["README.md", "README.zh.md"])
def test_the_readme_leads_there(name: str) -> None:
    text = (ROOT / name).read_text(encoding="utf-8")
    assert "(CONTRIBUTING.md)" in text and "(docs/notebook.ipynb)" in text


def shown(source: str, names: dict[str, Any]) -> Any:
    """Run a cell; what its last line gives, if it is an expression."""
    body = ast.parse(source).body
    last = body.pop() if isinstance(body[-1], ast.Expr) else None
    exec(compile(ast.Module(body, []), "cell", "exec"), names)
    return eval(compile(ast.Expression(last.value), "cell", "eval"), names) if isinstance(last, ast.Expr) else None


def test_the_notebook_runs_from_top_to_bottom(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.chdir(tmp_path)
    book = json.loads(NOTEBOOK.read_text(encoding="utf-8"))
    assert book["nbformat"] == 4
    names: dict[str, Any] = {}
    pictures = 0
    for cell in book["cells"]:
        if cell["cell_type"] == "code":
            assert not cell["outputs"] and cell["execution_count"] is None  # kept without what it printed once
            value = shown("".join(cell["source"]), names)
            pictures += "<svg" in value._repr_html_() if hasattr(value, "_repr_html_") else 0
    assert pictures == 5
    assert (tmp_path / "four-bar.pdf").read_bytes().startswith(b"%PDF")
    assert "omega_2" in capsys.readouterr().out
