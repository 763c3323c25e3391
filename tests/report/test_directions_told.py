"""What is read off a polygon has its direction by the letters of the polygon."""

from __future__ import annotations

from cmath import phase

import pytest

from tests.drawn_library import IDS, drawn
from tests.each import each
from vecpoly.algebra.formula import Node, Row, plain
from vecpoly.board.construction import Figure
from vecpoly.board.paper.marks import Point
from vecpoly.problem.load import load
from vecpoly.report.content import Objects
from vecpoly.report.steps.pointing import ends_of, pointed
from vecpoly.report.steps.sections import sections
from vecpoly.solution import solve
from vecpoly.words import Lang

_NEAR = 0.02  # rad


@each(IDS)
def test_the_letters_of_a_line_are_those_from_the_tail_to_the_tip_of_its_vector(name: str) -> None:
    solution = drawn(name).solution
    for answer in solution.answers.values():
        line, vector = answer.reading.formula, answer.drawn_vector
        ends = ends_of(line) if line is not None else None
        if ends is None or not vector:
            continue
        ways = [way for figure in solution.construction.figures if (way := _way(figure, ends))]
        assert ways, f"{plain(line)}: no figure has both letters" if line is not None else ""
        assert any(abs(phase(way / vector)) < _NEAR for way in ways), answer.key


def _way(figure: Figure, ends: tuple[Node, Node]) -> complex | None:
    """From one letter to the other on a figure."""
    marks = [mark for mark in figure.marks if isinstance(mark, Point)]
    at = {_bare(label): complex(mark.at) for mark in marks for label in mark.label.split(", ")}
    tail, tip = (at.get(_bare(plain(end))) for end in ends)
    return None if tail is None or tip is None else tip - tail


def _bare(label: str) -> str:
    """A letter with its index and its primes, in whatever order these are written: n_2′, n^′_2."""
    return "".join(sorted(set(label) - set("^_{}"))) + str(label.count("′"))


@pytest.mark.parametrize(("lang", "told"), [("zh", "= 0.226 m/s（方向 p → d）"), ("en", "= 0.226 m/s (from p to d)")])
def test_a_velocity_that_is_read_off_is_told_with_its_direction(lang: Lang, told: str) -> None:
    objects = Objects()
    steps = [step for part in sections(solve(load("3-9")), lang, objects) for step in part["steps"]]
    found = [objects.named[ref] for step in steps for ref in step["formulas"]]
    lines = [plain(one) for one in found if isinstance(one, Row)]
    assert any(line.startswith("v_D = ") and line.endswith(told) for line in lines)


def test_a_length_and_an_angular_velocity_have_none() -> None:
    lines = [line for step in solve(load("3-9")).construction.steps for line in step.formulas]
    for symbol in ("l_BC", "ω_2", "a_B"):
        (line,) = (one for one in lines if plain(one).startswith(f"{symbol} = "))
        assert pointed(line, "en") is line
