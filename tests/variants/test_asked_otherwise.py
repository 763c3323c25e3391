"""A text that asks for what is asked no more is told to the lecturer before a class has it on its sheets."""

from __future__ import annotations

from pathlib import Path

import pytest
from typer.testing import CliRunner

from vecpoly import load, loads
from vecpoly.cli.app import app
from vecpoly.variants.told import asks_otherwise, said_already

ENTRY = "title: t\nproblems:\n  - problem: 3-9\n    find: [v_E]\n{more}    vary: {{phi: 40 deg .. 50 deg by 5 deg}}\n"

BOTH = "    statement: {zh: 求 $v_E$。, en: Find $v_E$.}\n"


@pytest.mark.parametrize(("more", "told"), [("", True), ("    statement: Find $v_E$.\n", False), (BOTH, False)])
def test_an_entry_that_asks_something_else_needs_its_own_text(tmp_path: Path, more: str, told: bool) -> None:
    (tmp_path / "hw.yaml").write_text(ENTRY.format(more=more), encoding="utf-8")
    shown = CliRunner().invoke(app, ["variants", str(tmp_path / "hw.yaml"), "-n", "0", "--lang", "en"]).stdout
    assert ("the statement is that of 3-9.yaml, but here v_E are asked" in shown) is told
    assert "of the draws pass" in shown


def test_a_problem_by_itself_asks_as_its_text_does() -> None:
    assert not list(asks_otherwise(load("3-9")))
    other = loads("extends: 3-9\nid: mine\ninput: {phi: 50 deg}")
    assert not list(asks_otherwise(other))
    (said,) = asks_otherwise(loads("extends: 3-9\nid: mine\nfind: [v_E, omega_3]"))
    assert "v_E, omega_3" in said.en and "v_E, omega_3" in said.zh


def test_a_value_that_the_text_tells_in_another_spelling_is_told_all_the_same() -> None:
    """3-2 says φ = 165°; the file of the problem 165 deg."""
    (said,) = said_already(loads("extends: 3-2\nid: mine\nvary: {phi: 100 deg .. 170 deg by 5 deg}"))
    assert "phi = 165 deg" in said.en and "phi = 165 deg" in said.zh
    assert not list(said_already(loads("extends: 3-2\nid: mine\nvary: {AB: 50 mm .. 70 mm by 2 mm}")))
