"""Letters and angles on the sheet of a synthesis are those of its steps."""

from __future__ import annotations

import re

import pytest

from tests.drawn_library import LIBRARY, drawn
from tests.each import Later, each
from tests.laws import few
from vecpoly import load
from vecpoly.algebra.formula import named as named_
from vecpoly.algebra.formula import plain
from vecpoly.board.acts import Angle, Plot
from vecpoly.board.construction import Construction
from vecpoly.designs.base import Design
from vecpoly.report.statement.conventions import conventions
from vecpoly.words import Words

_POINT, _FORMULA = re.compile(r"[A-Z]['′]*\d*"), re.compile(r"\$([^$]+)\$")
DESIGNS = Later(lambda: few([name for name in LIBRARY if isinstance(load(name).subject, Design)], 3))


def named(said: Words) -> set[str]:
    """The points that a step names."""
    return {point for formula in _FORMULA.findall(said.zh) for point in _POINT.findall(bared(formula))}


def bared(label: str) -> str:
    """B′_1 as it is read: B′1."""
    return re.sub(r"[_{}]", "", label)


def lettered(construction: Construction) -> dict[int, set[str]]:
    """The letters that each step leaves on the paper."""
    found: dict[int, set[str]] = {n: set() for n in range(1, len(construction.steps) + 1)}
    for act in construction.acts:
        if isinstance(act, Plot) and act.label:
            found[act.head.step].add(bared(act.label))
    return found


@each(DESIGNS)
def test_a_point_with_a_prime_on_the_sheet_is_named_with_it_in_its_step(name: str) -> None:
    """The second D of 8-5 was D′ on the sheet and D in its step, the positions of γ_min were lettered nowhere else."""
    construction = drawn(name).construction
    for n, letters in lettered(construction).items():
        said = named(construction.steps[n - 1].words)
        wrong = [one for one in letters if "′" in one and one not in said and one.replace("′", "") in said]
        assert not wrong, (n, wrong, construction.steps[n - 1].words.zh)


@each(DESIGNS)
def test_an_angle_beside_its_arc_has_the_digits_of_its_line(name: str) -> None:
    """θ = 40° stood beside the arc, θ = 40.0° in the step; φ_DC = −67° beside φ_AB = −88.4°."""
    construction = drawn(name).construction
    lines = [plain(line) for step in construction.steps for line in step.formulas]
    for act in construction.acts:
        if isinstance(act, Angle) and "=" in act.label:
            symbol, value = act.label.rsplit(" = ", 1)
            symbol = plain(named_(symbol))
            told = {line.rsplit(" = ", 1)[1] for line in lines if line.startswith(f"{symbol} = ")}
            assert not told or value in told, (act.label, told)


@pytest.mark.parametrize(("name", "told"), [("K-slider-crank-BC", "连 $C_{2}S$，"), ("K-slider-crank-AB", "延长线")])
def test_a_lies_between_c_and_s_where_the_coupler_is_given_and_beyond_s_where_the_crank_is(
    name: str, told: str
) -> None:
    construction = drawn(name).construction
    places = {act.label: act.at for act in construction.acts if isinstance(act, Plot)}
    c, s, a = (places[letter] for letter in ("C_2", "S", "A"))
    assert (abs(a - c) < abs(s - c)) is (told != "延长线")
    assert any(told in step.words.zh for step in construction.steps)


@pytest.mark.parametrize(
    ("name", "several"), [("four-positions", False), ("K-crank-rocker-gamma", True), ("8-5", False)]
)
def test_a_number_above_a_symbol_is_that_of_a_solution_only_where_there_are_several(name: str, several: bool) -> None:
    """M^(1) is the first centre point, of whatever solution."""
    assert bool(conventions(drawn(name).solution)["superscripts"]) is several
