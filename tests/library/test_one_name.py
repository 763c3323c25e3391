"""One name for one thing in a report: two letters are one side of the polygons, a length has one symbol, an angle of
the data its own on the figure; and what was computed is not read back from the paper."""

from __future__ import annotations

import re
from dataclasses import fields, is_dataclass
from itertools import combinations

import pytest

from tests.drawn_library import IDS, drawn, given, hanging
from tests.each import Later, each
from vecpoly.algebra.formula import Over, Row, Sym, plain
from vecpoly.board.construction import Figure, View
from vecpoly.board.paper.marks import AngleMark, Point
from vecpoly.board.place import view_named
from vecpoly.designs.base import Design
from vecpoly.devices.structure import Structure
from vecpoly.mechanism.model import Mechanism
from vecpoly.problem.library import library
from vecpoly.problem.load import load
from vecpoly.report.answers.box import answer_box
from vecpoly.solution import solve
from vecpoly.words import bare

CORNER = re.compile(r"[a-z](_\d+)?")  # of a polygon; the pole O is the same in each
LENGTH = re.compile(r"\bl_\{?(\w+)\}?")
DESIGNS = Later(lambda: (name for name in IDS if isinstance(given(name).subject, Design)))


def corners(figure: Figure) -> set[str]:
    return {mark.label for mark in figure.marks if isinstance(mark, Point) and CORNER.fullmatch(mark.label)}


def lines(name: str) -> list[str]:
    return [plain(line).replace("\u2009", " ") for step in drawn(name).construction.steps for line in step.formulas]


@each(IDS)
def test_no_two_polygons_of_forces_or_of_products_share_a_letter(name: str) -> None:
    of_links = (View.FORCE,) if drawn(name).desk is not None else ()  # those of wedges have the side ab in common
    for view in (*of_links, *map(view_named, ("unbalances", "products"))):
        for one, other in combinations(drawn(name).figures(view), 2):
            assert not corners(one) & corners(other), (one.title, other.title)


@pytest.mark.parametrize(("name", "view"), [("4-3a", View.FORCE), ("6-7", view_named("products"))])
def test_corners_of_polygons_are_found_to_be_compared(name: str, view: View) -> None:
    figures = solve(load(name), by="exact", repeats=0, precise=False).construction.figures
    assert sum(bool(corners(figure)) for figure in figures if figure.view is view) > 1


def gone_on_with(node: object) -> set[str]:
    """The symbols in a part of a line, but those of lengths on paper."""
    if isinstance(node, Over):
        return set()
    if isinstance(node, Sym):
        return {plain(node)}
    parts = node if isinstance(node, tuple) else parts_of(node)
    return {symbol for part in parts for symbol in gone_on_with(part)}


def parts_of(node: object) -> tuple[object, ...]:
    return tuple(getattr(node, field.name) for field in fields(node)) if is_dataclass(node) else ()


@each(IDS)
def test_no_line_goes_on_with_what_has_the_letter_of_its_own_length_on_paper(name: str) -> None:
    every = [line for step in drawn(name).construction.steps for line in step.formulas]
    used = {symbol for line in every if isinstance(line, Row) for symbol in gone_on_with(line.items[1:])}
    for line in every:
        symbol = plain(line).partition(" = ")[0]
        behind = line.items[1:] if isinstance(line, Row) else ()
        same = [one for one in hanging(behind, Over) if plain(one.body) == symbol]
        assert not same or symbol not in used, f"{plain(line)}: one letter for two lengths, and both are gone on with"


@each(IDS)
def test_a_length_in_an_equation_is_called_there_as_in_the_lines_and_the_data(name: str) -> None:
    problem = drawn(name).problem
    told = " ".join([*lines(name), *(bare(datum.of("en")) for datum in problem.given.data)])
    known = set(LENGTH.findall(told))
    for step in drawn(name).construction.steps:
        for size in step.equation.magnitudes if step.equation is not None else ():
            assert set(LENGTH.findall(bare(size))) <= known, f"{bare(size)} of {step.equation}"


@each(IDS)
def test_an_angular_velocity_goes_on_with_the_velocity_that_was_computed_and_laid_off(name: str) -> None:
    laid: set[str] = set()
    for step in drawn(name).construction.steps:
        for line in step.formulas:
            parts = plain(line).replace("\u2009", " ").split(" = ")
            over = {plain(one) for one in hanging(line, Over)}
            if parts[0].startswith("ω_"):
                assert not over & laid, f"{' = '.join(parts)}: was laid off as computed"
            laid |= (
                over
                if isinstance(line, Row) and any(parts[0] == plain(one) for one in hanging(line.items[0], Over))
                else set()
            )


def test_a_planet_has_the_round_speed_that_its_round_numbers_give() -> None:
    solution = solve(load("hypocycloid-drive"), repeats=0, precise=False)
    assert solution.answers["omega_2"].drawn == pytest.approx(-10.0, abs=1e-9)
    rack = solve(load("pinion-drives-rack"), repeats=0, precise=False)
    assert rack.answers["v_P"].drawn == rack.answers["v_P"].exact == pytest.approx(0.3)


@each(DESIGNS)
def test_an_angle_on_the_figure_of_a_design_has_a_name_that_is_told(name: str) -> None:
    problem, construction = given(name), drawn(name).construction
    said = [bare(step.words.zh) for step in construction.steps]
    data = [bare(datum.of("zh")) for datum in problem.given.data]
    told = " ".join([*said, *data, *lines(name), bare(problem.statement.zh)])
    for figure in construction.figures:
        for mark in figure.marks:
            if isinstance(mark, AngleMark):
                symbol = bare(mark.label.partition(" = ")[0]).translate(dict.fromkeys(map(ord, "{}")))
                of_several = re.sub(r"(?<=[A-Z]{2})\d$", "", symbol)  # φ_AB1 of the directions φ_AB
                assert symbol in told or of_several in told, f"{symbol} is on the figure alone"


@each(Later(lambda: (*DESIGNS, "8-15", "best-gamma")))
def test_an_answer_bears_the_number_of_its_solution_where_its_line_does(name: str) -> None:
    solution = drawn(name).solution
    for line in answer_box(solution, "zh").lines:
        way = solution.answers[line.key].reading.formula
        number = re.search(r"\^\(\d+\)", "" if way is None else plain(way).partition(" = ")[0])
        head = plain(line.node).partition(" = ")[0]
        assert number is None or number[0] in head, f"{line.key} is answered as {head}"


def test_no_joint_of_the_library_is_called_by_the_letter_that_is_printed_as_a_roman_number() -> None:
    """Its own claim, and no other's: any letter may be chosen in a file."""
    called = {entry.id: letters_of(entry.id) for entry in library()}
    assert not [name for name, letters in called.items() if {"I"} & {one.rstrip("'′") for one in letters}]


def letters_of(name: str) -> set[str]:
    """The letters of its joints and points."""
    subject = given(name).subject
    if isinstance(subject, Mechanism):
        return {*subject.frame, *(point for link in subject.links for point in link.points)}
    return {*subject.joints} if isinstance(subject, Structure) else set()
