"""Forces as they stand on the paper: polygons that close with the sizes and senses of the readings, and the reactions
that the diagram names."""

from __future__ import annotations

import cmath
import re

import pytest

from tests.drawn_forces import IDS, NEAR, NONE, arrows, by_symbol, size_of
from tests.drawn_library import drawn, ids
from tests.each import Later, each
from vecpoly.algebra.formula import plain
from vecpoly.board.construction import EquationTable, Figure, Reading, Step, View
from vecpoly.board.paper.marks import Point, Role, Segment
from vecpoly.mechanism.loads import Force

DEVICES = Later(lambda: ids(mechanisms=False, view=View.FORCE))
Side = tuple[complex, complex]


def readings(name: str) -> list[Reading]:
    """All forces that were read, those of a device too."""
    made = drawn(name).construction
    return [*made.readings.values(), *made.forces.values()]


def balances(name: str) -> list[tuple[Step, EquationTable, Figure]]:
    """Every equation of equilibrium with the polygon in which its step drew it."""
    return [
        (step, step.equation, figure)
        for step in drawn(name).construction.steps
        for figure in drawn(name).figures(View.FORCE)
        if step.equation is not None and any(mark.step == step.number for mark in figure.marks)
    ]


def sides(table: EquationTable, figure: Figure) -> list[tuple[str, Side | None]]:
    """The forces of an equation as they stand on its polygon: tail and head; a neighbour's reaction turned round."""
    there: dict[str, list[Side]] = {}
    for mark in arrows(figure):
        there.setdefault(mark.label, []).append((mark.a, mark.b))
    for label, (a, b) in ((mark.label, (mark.a, mark.b)) for mark in arrows(figure)):
        there.setdefault(opposite(label), [(b, a)])
    symbols = [symbol for symbol in table.symbols if symbol not in ("0", "")]
    return [(symbol, there[symbol].pop(0) if there.get(symbol) else None) for symbol in symbols]


def opposite(label: str) -> str:
    """The reaction to a reaction."""
    return re.sub(r"^(R\'?_\{)(\w)(\w)", r"\1\3\2", label)


# -- polygons -------------------------------------------------------------------------------------------------------


@each(Later(lambda: [*IDS, *DEVICES, "incline-at-its-limit"]))
def test_the_forces_of_an_equation_are_drawn_head_to_tail_and_close(name: str) -> None:
    read = {one.symbol: one for one in readings(name)}
    assert balances(name)
    for step, table, figure in balances(name):
        drawn_up = sides(table, figure)
        assert all(side is not None or abs(read[symbol].scalar) < NONE for symbol, side in drawn_up), step.number
        forces = [(symbol, side) for symbol, side in drawn_up if side is not None]
        assert abs(sum(b - a for _, (a, b) in forces)) < NEAR and len(forces) != 1, step.number
        tails, heads = ([side[end] for _, side in forces] for end in (0, 1))
        for n, head in enumerate(heads):
            assert any(abs(head - tail) < NEAR for tail in (*tails[:n], *tails[n + 1 :])), (step.number, forces[n])


def reactions(figure: Figure) -> dict[str, complex]:
    """The reactions on a figure as their arrows tell them (mm), those that are split put together again."""
    stand = {mark.label: mark.b - mark.a for mark in arrows(figure) if mark.label.startswith("R")}
    whole = {label: vector for label, vector in stand.items() if "^" not in label}
    for label in (label for label in stand if "^" in label):
        of = re.sub(r"\^[nt]", "", label)
        whole.setdefault(of, sum(stand.get(re.sub("_", f"^{part}_", of, count=1), 0j) for part in "nt"))
    return {label: vector for label, vector in whole.items() if not re.search("[A-Z]", label[1:])}  # not of a pin


@each(IDS)
def test_every_reaction_of_a_polygon_has_the_size_and_the_sense_that_was_read(name: str) -> None:
    read = by_symbol(name)
    for figure in drawn(name).figures(View.FORCE):
        for label, vector in reactions(figure).items():
            force = read[label].vector
            assert force and abs(vector * figure.scale.value - force) < 1e-9 * abs(force), label


def test_many_reactions_stand_in_the_polygons() -> None:
    assert sum(len(reactions(figure)) for name in IDS for figure in drawn(name).figures(View.FORCE)) >= 40


@each(IDS)
def test_every_given_load_of_a_polygon_has_its_size_and_direction(name: str) -> None:
    loads = drawn(name).problem.loads
    given = {load.name: load for load in loads.all if isinstance(load, Force) and load.size} if loads else {}
    for figure in drawn(name).figures(View.FORCE):
        for mark in arrows(figure):
            load = given.get(re.sub("[{}]", "", mark.label))
            if load is not None and load.size is not None:
                size = size_of(name, load)
                assert (mark.b - mark.a) * figure.scale.value == pytest.approx(
                    cmath.rect(size, load.direction), rel=1e-9
                )


def test_given_loads_stand_in_the_polygons() -> None:
    labels = {mark.label for name in IDS for figure in drawn(name).figures(View.FORCE) for mark in arrows(figure)}
    assert {"F", "Q", "F_{r}", "F_{i1}"} <= labels


@each(Later(lambda: [*IDS, *DEVICES]))
def test_the_forces_that_a_step_measures_are_written_in_the_order_in_which_they_are_named(name: str) -> None:
    for step in drawn(name).construction.steps:
        if found := re.search(r"由图量得 ([^。；]*)。", step.words.zh):
            named = [re.sub("[{}$ ]", "", symbol) for symbol in found[1].split("、")]
            written = [
                plain(node).split(" = ")[0].replace("{", "").replace("}", "").replace(" ", "") for node in step.formulas
            ]
            assert named == [symbol for symbol in written if symbol in named], step.number


def test_forces_are_measured_in_many_steps() -> None:
    steps = [step for name in IDS for step in drawn(name).construction.steps if "由图量得" in step.words.zh]
    assert len(steps) >= 20 and all("easure" in step.words.en for step in steps)


# -- the diagram -------------------------------------------------------------------------------------------------------


@each(IDS)
def test_a_reaction_named_on_the_diagram_stands_on_a_line_that_is_its_line_of_action(name: str) -> None:
    read = by_symbol(name)
    (diagram,) = (f for f in drawn(name).figures(View.MECHANISM) if not f.name)
    opposite = {symbol: f"R_{{{symbol[4]}{symbol[3]}{symbol[5:]}" for symbol in read if re.match(r"R_\{\d\d", symbol)}
    ruled = [m for m in diagram.marks if isinstance(m, Segment)]
    for mark in (m for m in diagram.marks if isinstance(m, Point) and m.label in opposite):
        role = Role.IDEAL if mark.label.endswith(",0}") else Role.DIRECTION  # dashed without friction
        force = read[mark.label]
        assert force.acts is not None
        acts = force.acts.point / diagram.scale.value
        on = [
            (line.b - line.a) / abs(line.b - line.a)
            for line in ruled
            if line.role is role and min(abs(mark.at - line.a), abs(mark.at - line.b)) < NEAR
        ]  # along the lines that end at the name: one that was ruled before the force was found to be zero stays
        ways = [force.vector / abs(force.vector)] if force.vector else on
        assert any(
            abs(((mark.at - acts) / way).imag) < NEAR and any(abs((way / line).imag) < 1e-6 for line in on)
            for way in ways
        ), mark.label


def test_reactions_are_named_on_the_diagrams() -> None:
    named = [
        m.label
        for name in IDS
        for f in drawn(name).figures(View.MECHANISM)
        for m in f.marks
        if isinstance(m, Point) and m.label.startswith("R_")
    ]
    assert len(named) >= 20
