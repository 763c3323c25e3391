"""The numbers of chapters 4 and 7 of a course report hold:
every printed substitution, every change of a given dimension."""

from __future__ import annotations

import re
from dataclasses import replace
from functools import cache
from math import atan, copysign, cos, degrees, floor, log10, radians, sin, sqrt
from typing import Any, cast

import numpy as np
import pytest

from tests.laws import few
from tests.studies import studied
from vecpoly import oracle
from vecpoly.algebra.formula import Frac, Node, Power, Root, Row, Txt, plain
from vecpoly.algebra.quantity import number
from vecpoly.analytic.equations import Equation
from vecpoly.analytic.expr import Num, Sum, Var
from vecpoly.analytic.keyed import FIGURES
from vecpoly.analytic.numbers import worked
from vecpoly.cycle import cycle
from vecpoly.findings.given_lengths import Dimension, given_dimensions
from vecpoly.findings.study.study import Study, study
from vecpoly.problem.load import load
from vecpoly.report.answers.tables import readings_tables
from vecpoly.report.content import Objects
from vecpoly.report.course.analysis import stated
from vecpoly.report.course.checks import book, comparison
from vecpoly.report.course.checks.influences import CHANGE, influences, lost_range, targets
from vecpoly.report.course.checks.tolerances import judged, largest, section
from vecpoly.report.course.modelling import order
from vecpoly.report.course.modelling.example import as_told_by_group, by_group, told
from vecpoly.report.course.numbering import Press
from vecpoly.solution import solve

_NUMBER = re.compile(r"(\d+(?:\.\d+)?)(?:×10\^\{(−?\d+)\})?(°?)")
_CALCULATOR: dict[str, Any] = {
    "cos": cos,
    "sin": sin,
    "sqrt": sqrt,
    "radians": radians,
    "angle": lambda y, x: degrees(atan(y / x)) if x else copysign(90.0, y),
}


@cache
def named(name: str, symbol: str) -> Dimension:
    it = studied(name)
    return next(
        d
        for d in given_dimensions(it.problem.mechanism, frozenset(d.symbol for d in it.problem.given.lengths))
        if d.name.en == f"${symbol}$"
    )


class Recorder(Press):
    """A press that keeps the lines of its tables."""

    def __init__(self, lang: str = "en") -> None:
        super().__init__(lang, Objects(), "7")  # type: ignore[arg-type]
        self.lines: list[tuple[str, ...]] = []

    def table(self, title: Any, header: Any, rows: Any, align: str, **style: Any) -> str:
        self.lines += rows
        return str(title.en)


def keyed(node: Node) -> str:
    """A printed formula as it is keyed into a pocket calculator."""
    match node:
        case Txt(text):
            figures = _NUMBER.sub(lambda m: f"{m[1]}e{(m[2] or '0').replace('−', '-')}", text)
            return str(figures).replace(" × ", "*").replace("−", "-")
        case Row((Txt("arctan\u2009"), Frac(num, den))):
            return f"angle({keyed(num)},{keyed(den)})"
        case Row((Txt(name), Txt() as turn)) if name.rstrip("\u2009") in ("cos", "sin"):
            return f"{name.rstrip()}(radians({keyed(turn)}))"
        case Row(items):
            return "".join(keyed(item) for item in items)
        case Power(body, exponent):
            return f"{keyed(body)}**{exponent}"
        case Root(body):
            return f"sqrt({keyed(body)})"
        case Frac(num, den):
            return f"(({keyed(num)})/({keyed(den)}))"
    raise AssertionError(f"{node} in a substitution")


def half_unit(value: float, turns: bool) -> float:
    """Half a unit of the last digit printed: five figures, angles to 0.001°."""
    return 0.0005 if turns else 0.5 * 10.0 ** (floor(log10(abs(value))) - 4) if value else 1e-13


def reckoned(node: Node) -> float:
    """What the calculator shows with the numbers as they are printed."""
    return float(eval(keyed(node), dict(_CALCULATOR)))


def largest_in(node: Node) -> float:
    """The largest number printed: what rounding leaves of zero is measured by it."""
    return max(float(m[1]) for m in _NUMBER.finditer(plain(node)))


@pytest.mark.parametrize("name", ["A-26", "B-24", "3-5", "A-30", "A-27", "3-9"])
def test_every_printed_substitution_gives_its_printed_result(name: str) -> None:
    """The figures printed give the result to half a unit of its last place."""
    it, lines = studied(name), 0
    for group, env in zip(it.model.groups, as_told_by_group(it), strict=True):
        for equation in told(group):
            node = worked(equation, env)
            assert isinstance(node, Row)
            if len(node.items) < 4:
                continue
            _, _, body, end = node.items
            m = _NUMBER.search(plain(end))
            assert m is not None
            result = float(f"{m[1]}e{(m[2] or '0').replace('−', '-')}") * (-1 if "−" in plain(end)[:4] else 1)
            value = reckoned(body)
            gap = (value - result + 180) % 360 - 180 if m[3] else value - result
            assert abs(gap) <= half_unit(result or largest_in(body), bool(m[3])) * (1.0 + 1e-6), plain(node)
            lines += 1
    assert lines >= 12


def test_a_number_that_a_substitution_goes_on_with_is_the_one_that_was_printed() -> None:
    it = studied("A-27")
    ends = {number(one.size, FIGURES) for group in it.model.groups for one in group.constants}
    for group, env in zip(it.model.groups, as_told_by_group(it), strict=True):
        for equation in told(group):
            *_, body, end = cast("Row", worked(equation, env)).items
            long = (one for one in _NUMBER.finditer(plain(body)) if len(one[1].replace(".", "").lstrip("0")) == FIGURES)
            later = {one[0] for one in long}
            assert later <= ends, later - ends
            ends |= {one[0] for one in _NUMBER.finditer(plain(end))}
    assert len(ends) > 40


def test_auxiliary_names_belong_to_their_group() -> None:
    _, first, second = by_group(studied("A-26"))
    assert first["A_0"] == pytest.approx(-0.092925, rel=1e-4) and second["A_0"] == pytest.approx(-0.21214, rel=1e-4)


def test_a_dimension_with_which_positions_are_lost_says_which() -> None:
    """B-24 with x_G 1 % larger: rod and crank 4, 5 no longer reach E about 344.5°."""
    span = lost_range(studied("B-24"), named("B-24", "x_{G}"), 0.01 * 0.1535)
    assert span is not None
    assert np.degrees(span) % 360 == pytest.approx([344.1, 345.1], abs=0.2)
    assert lost_range(studied("B-24"), named("B-24", "x_{G}"), 1e-4) is None


def test_the_limit_of_a_dimension_is_where_the_cycle_breaks() -> None:
    it = studied("B-24")
    for one in influences(it):
        for limit in (one.least, one.most):
            if limit is not None:
                assert not cycle_of(it, one.dimension, limit[0]) and cycle_of(it, one.dimension, 0.97 * limit[0])
    assert any(one.most for one in influences(it)) and any(
        "1.13 mm" in w.en for w in judged(it, targets(it), influences(it))
    )


def cycle_of(it: Study, one: Dimension, change: float) -> bool:
    return cycle(one.enlarged(change), n=2).whole


@pytest.mark.parametrize("name", few(["B-24", "A-26", "3-5"], 3))
def test_changes_are_those_of_half_the_step_as_printed(name: str) -> None:
    it = studied(name)
    fine = replace(
        it.turn, phi=np.linspace(it.turn.phi[0], it.turn.phi[-1], 2 * len(it.turn.phi) - 1), _kept={}, _solved={}
    )
    halved = study(it.given)
    halved.__dict__["turn"] = fine
    one, two = Recorder(), Recorder()
    section(it, one)
    section(halved, two)
    assert one.lines == two.lines and len(one.lines) >= 8


def test_shares_are_of_the_extremes_told_elsewhere() -> None:
    it = studied("B-24")
    found = it.extremes("alpha_5")
    assert found.highest is not None and found.lowest is not None
    assert largest(it, "alpha_5") == max(found.highest.value, -found.lowest.value) > 0


def test_the_given_dimensions_are_those_of_the_problem_file() -> None:
    """l_CE and the angle at C, not the l_BE and β that the formulas use;
    pivots by both coordinates, but for the drive's."""
    symbols = [d.name.en for d in given_dimensions(studied("B-24").problem.mechanism)]
    assert symbols == [
        "$l_{AB}$",
        "$l_{BC}$",
        "$l_{CE}$",
        "$∠BCE$",
        "$l_{DC}$",
        "$l_{EF}$",
        "$l_{GF}$",
        "$x_{D}$",
        "$y_{D}$",
        "$x_{G}$",
        "$y_{G}$",
    ]


def test_a_longer_bar_keeps_the_other_given_dimensions() -> None:
    changed = named("B-24", "l_{BC}").enlarged(1e-3).link("2").points
    assert abs(changed["C"] - changed["B"]) == pytest.approx(0.1066) and abs(
        changed["E"] - changed["C"]
    ) == pytest.approx(0.065)
    assert np.degrees(np.angle((changed["E"] - changed["C"]) / (changed["B"] - changed["C"]))) == pytest.approx(120.0)


@pytest.mark.parametrize(
    "name", few(["A-26", "A-27", "A-30", "3-5", "3-10", "3-11", "4-4", "D-3", "six-bar-dynamic", "class-iii"], 5)
)
def test_no_change_of_a_dimension_is_no_change(name: str) -> None:
    mech = load(name).mechanism
    at = oracle.solve(mech)
    for d in given_dimensions(mech):
        same = oracle.solve(d.enlarged(0.0))
        assert all(
            np.allclose(same.position(letter), at.position(letter), atol=1e-12)
            for link in mech.links
            for letter in link.points
        )
        assert d.enlarged(CHANGE[d.is_angle]) != mech


def test_the_table_of_the_order_names_what_is_found() -> None:
    press = Recorder()
    order.order(studied("3-5"), press)
    assert press.lines[-1][-1] == "$s_{56}$, $φ_{4}$, $F$"
    press = Recorder()
    order.order(studied("A-27"), press)
    assert "$s_{45}$" in press.lines[-1][-1]


def test_the_printed_answers_of_the_book_are_compared() -> None:
    press = Recorder()
    found = book.chapter(studied("3-5"), press)
    assert any(line[:2] == ("$ω_{2}$", "rad/s") and "1.26" in line[2] for line in press.lines) and "400 mm" in " ".join(
        text for _, text in found["verdicts"]
    )
    nothing = book.chapter(studied("A-27"), Recorder())
    assert not any(nothing.values()) and {"table", "verdicts"} <= nothing.keys()


def test_the_hand_s_expected_error_stands_beside_the_deviations() -> None:
    it = study(solve(load("3-9"), repeats=40))
    press = Recorder()
    comparison.chapter(it, press, comparison.compared(it))
    assert press.lines and all(float(line[3]) < float(line[-1]) < 5 for line in press.lines)


def test_a_rate_that_vanishes_has_no_sense_and_no_deviation_in_per_cent() -> None:
    it = solve(load("3-9"), repeats=0)
    answers = {"alpha_3": replace(it.answers["alpha_3"], exact=1e-15, expected_error=0.1)}
    (table,) = readings_tables(replace(it, answers=answers), "en")
    assert table.header[-1] == "Expected error /(rad/s^2)" and "Deviation /%" not in table.header
    assert not any("cw" in cell for cell in table.rows[0]) and table.rows[0][-2] == "0"


@pytest.mark.parametrize("name", ["A-27", "3-5"])
def test_the_conclusion_tells_what_was_drawn_with_the_digits_of_the_table(name: str) -> None:
    it = studied(name)
    (said,) = stated.stated(it)
    rows = {re.sub("[{}]", "", row[0]): row for table in readings_tables(it.given, "en") for row in table.rows}
    found = re.findall(r"(\$[vaωα][^$]*\$)[^=;$]* = −?([\d.]+) ", re.sub("[{}]", "", said.en))
    assert found and all(drawn in rows[symbol] for symbol, drawn in found), found


def test_a_line_whose_numbers_are_its_value_says_it_once() -> None:
    once = worked(Equation(Var("G_1"), Sum(((Num(1.0), -1),))), {"G_1": -1.0})
    assert plain(once) == "G_1 = −1"
    both = worked(Equation(Var("G_1"), Sum(((Num(1.0), -1), (Num(2.0), -1)))), {"G_1": -3.0})
    assert plain(both) == "G_1 = −1 − 2 = −3"
