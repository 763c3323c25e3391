"""What is told and seldom read: notes on stderr, exit codes, names of values, symbols, constants, doubts."""

from __future__ import annotations

import re
from pathlib import Path

import numpy as np
import pytest
from typer.testing import CliRunner, Result

from tests.studies import studied
from tests.texts import CRANK
from vecpoly.check.printed.follow import _as_printed
from vecpoly.check.printed.verdict import check_printed
from vecpoly.cli import app
from vecpoly.cli.terminal import warn
from vecpoly.cycle import cycle
from vecpoly.cycle.table import csv_bytes, table
from vecpoly.errors import VecpolyError
from vecpoly.findings.conditioning import conditioning
from vecpoly.findings.motion import _range
from vecpoly.findings.study.study import Study
from vecpoly.problem.editors.patterns import omega
from vecpoly.problem.load import load, loads
from vecpoly.problem.problem import Printed
from vecpoly.report.content import Objects
from vecpoly.report.course import symbols
from vecpoly.report.course.modelling.formulas import _constants
from vecpoly.report.course.numbering import Press
from vecpoly.report.flow.table import DataTable
from vecpoly.report.values import called
from vecpoly.words import Lang, Words

COURSES = ("3-9", "A-27", "A-26", "3-12", "D-1")


# -- the command line
# ---------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("lang", "said"), [("zh", "vecpoly: 注意 3-9：角度偏大"), ("en", "vecpoly: note on 3-9: a large angle")]
)
def test_a_note_on_a_problem_speaks_the_language_that_was_asked_for(
    lang: Lang, said: str, capsys: pytest.CaptureFixture[str]
) -> None:
    warn("3-9", [Words("角度偏大", "a large angle")], lang)
    told = capsys.readouterr()
    assert told.err.strip() == said and told.out == ""


def checked(path: Path, *options: str) -> Result:
    return CliRunner().invoke(app, ["check", "3-9", "--table", str(path), *options], prog_name="vecpoly")


def test_a_table_that_agrees_ends_in_zero_and_one_that_does_not_in_another_code(tmp_path: Path) -> None:
    right = csv_bytes(table(cycle(load("3-9"), n=5))).decode("utf-8-sig")
    head, units, *rows = right.splitlines()
    wrong = "\n".join(
        [
            head,
            units,
            *(
                ",".join([row.split(",")[0], *(f"{1.3 * float(cell):.4f}" for cell in row.split(",")[1:])])
                for row in rows
                if row
            ),
        ]
    )
    (tmp_path / "right.csv").write_text(right, encoding="utf-8")
    (tmp_path / "wrong.csv").write_text(wrong, encoding="utf-8")
    good, bad = checked(tmp_path / "right.csv"), checked(tmp_path / "wrong.csv")
    assert good.exit_code == 0, good.output
    assert bad.exit_code not in (0, 2), bad.output


# -- names and numbers
# --------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("key", "zh", "en"),
    [
        ("M_1_lever", "$M_1$（速度多边形杠杆法）", "$M_1$ (Zhukovsky lever)"),
        ("M_1_power", "$M_1$（虚功率法）", "$M_1$ (virtual power)"),
        ("M_1_0", "$M_1$（不计摩擦）", "$M_1$ (no friction)"),
        ("M_1", "$M_1$", "$M_1$"),
        ("R_12_0", "$M_1$", "$M_1$"),
        ("self_locking", "自锁（$M_1$）", "self-locking ($M_1$)"),
        ("determined", "运动是否确定", "the motion is determined"),
    ],
)
def test_a_value_is_called_by_its_symbol_and_the_way_it_was_found(key: str, zh: str, en: str) -> None:
    assert (called("M_1", key, "zh"), called("M_1", key, "en")) == (zh, en)


@pytest.mark.parametrize(
    ("kind", "on_paper", "doubt"),
    [("calculated", None, 0.005 / 2.5), ("graphical", None, 0.03), ("graphical", 25.0, 0.005 / 2.5)],
)
def test_a_printed_value_is_as_sure_as_its_last_digit_unless_it_was_drawn_and_no_length_is_given(
    kind: str, on_paper: float | None, doubt: float
) -> None:
    printed = Printed(symbol="v_B", rel=None, value=2.5, text="2.50 m/s", kind=kind, paper_mm=on_paper)  # type: ignore[arg-type]
    known = _as_printed(check_printed(printed, 2.5))
    assert known.value == 2.5 and known.doubt == pytest.approx(doubt)


@pytest.mark.parametrize("written", ["10 rad/s", "10 rad/s ccw", "-3.5 rad/s", "60 r/min cw", "ccw", "cw", "逆时针"])
def test_an_editor_takes_an_angular_velocity_or_its_sense_alone(written: str) -> None:
    texts = next(form["pattern"] for form in omega()["anyOf"] if "pattern" in form)
    assert re.search(texts, written) and not re.search(texts, "10 mm") and not re.search(texts, "about")


@pytest.mark.parametrize(("name", "fine"), [("B", True), ("", True), ("AB", False), ("b", False), ("3", False)])
def test_a_branch_of_a_train_is_named_by_one_capital(name: str, fine: bool) -> None:
    from pydantic import ValidationError

    from vecpoly.devices.train import Part

    if fine:
        assert Part.model_validate({"gear": "0.97", "name": name}).name == name
    else:
        with pytest.raises(ValidationError, match="name"):
            Part.model_validate({"gear": "0.97", "name": name})


QUOTED = CRANK.replace("title: test\n", 'title: t\nstatement: "%s"\n')


@pytest.mark.parametrize(
    ("written", "read"),
    [
        (r"ends in a backslash \\", "ends in a backslash \\"),
        (r"says \"no\" twice", 'says "no" twice'),
        ("first\n  second，line", "first second，line"),
        (r"both \\\" here", 'both \\" here'),
        ("（full-width：stays）", "（full-width：stays）"),
    ],
)
def test_a_quoted_text_ends_at_its_own_quote_and_keeps_its_signs(written: str, read: str) -> None:
    assert load_said(QUOTED % written) == read


def load_said(text: str) -> str:
    try:
        statement = loads(text).statement
    except VecpolyError as error:
        pytest.fail(str(error))
    assert statement is not None
    return statement.en


# -- course reports
# -----------------------------------------------------------------------------------------------------


def families_of(it: Study) -> set[str]:
    """The kinds of symbols in the printed formulas: x, y of points, their rates, s, φ."""
    found = set()
    for symbol in it.env:
        stem, _, index = symbol.partition("_")
        index = index.strip("{}")
        found.add(f"{stem}..{index[-1]}" if stem in "va" and index[-1:] in ("x", "y") and index[0].isupper() else stem)
    return {
        one
        for one in found
        if not one.endswith("..y") and one not in ("A", "B", "C", "G", "Δ", "ψ", "f", "b", "c", "y")
    }


@pytest.mark.parametrize("name", COURSES)
def test_every_kind_of_symbol_in_the_formulas_stands_in_the_list_of_symbols(name: str) -> None:
    it, press = studied(name), Press("en", Objects())
    symbols.symbols(it, press)
    told = {
        cell
        for made in press.objects.named.values()
        if isinstance(made, DataTable)
        for row in made.rows
        for cell in (row[0], row[4])
    }
    listed = {symbol for cell in told for symbol in re.findall(r"\$([^$]*)\$", cell)}
    kinds = {
        f"{s.partition('_')[0]}..x" if re.fullmatch(r"[va]_\{[A-Z]\w*x\}", s) else s.partition("_")[0] for s in listed
    }
    assert families_of(it) - kinds == set()


@pytest.mark.parametrize("name", COURSES)
def test_every_length_and_angle_of_a_group_s_formulas_is_printed_with_its_size(name: str) -> None:
    for group in studied(name).model.groups:
        lines = (line.split(" = ", 1) for line in _constants(group, arcs=True))
        told = {one[0]: one[1] for one in lines}
        sizes = {
            f"${c.symbol}$": (1e3 * c.size, " mm") if c.unit == "m" else (float(np.degrees(c.size)), "°")
            for c in group.constants
            if c.unit in ("m", "rad") and c.symbol != "π"
        }
        assert told.keys() == sizes.keys()
        for symbol, (size, unit) in sizes.items():
            assert told[symbol].endswith(unit)
            assert float(told[symbol].removesuffix(unit).replace("−", "-")) == pytest.approx(
                size, rel=1e-4, abs=1e-4
            ), symbol


@pytest.mark.parametrize("name", COURSES)
def test_the_words_over_formulas_name_the_same_in_both_languages_and_one_point_or_several(name: str) -> None:
    for group in studied(name).model.groups:
        for said in (part.said for stage in group.stages for part in stage.parts):
            zh, en = (re.findall(r"\$[^$]*\$", text) for text in (said.zh, said.en))
            assert set(en) <= set(zh), said
            if said.en.startswith("Point"):
                assert said.en.startswith("Points ") == (len(en) > 1) and set(zh) == set(en), said


@pytest.mark.parametrize("told", [True, False])
def test_a_calculation_agrees_only_where_something_was_told_before(told: bool) -> None:
    said = list(_range(studied("A-26"), told, conditioning(studied("A-26"))))
    for words in said:
        assert ("与此一致" in words.zh) == ("agrees" in words.en) and ("表明" in words.zh) == ("shows" in words.en)
    assert ("agrees" in said[0].en) == told


def test_the_constant_of_a_rolling_pair_which_stands_in_arcs_is_in_radians() -> None:
    (rack,) = (group for group in studied("rack-lift").model.groups if any("θ" in c.symbol for c in group.constants))
    assert "$θ_{H}$ = −1.3528 rad" in [*_constants(rack, arcs=True)] and "rad" not in "".join(
        _constants(rack, arcs=False)
    )
    assert "$θ_{H}$" in rack.opening.en and "radians" in rack.opening.en and "弧度" in rack.opening.zh
