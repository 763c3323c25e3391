"""Numbers that stand in several lines: alike in all; one count of decimals where they are read to one scale."""

from __future__ import annotations

import re

import pytest

from tests.drawn_library import DRAFTED, drafted
from tests.each import each
from vecpoly.algebra.formula import Row, plain
from vecpoly.printed.digits import decimals
from vecpoly.printed.lengths import is_length
from vecpoly.problem.load import load, loads
from vecpoly.solution import Solution, solve

WORKED = 4  # parts of a line symbol = formula = numbers = result


def lines_of(solution: Solution) -> list[list[str]]:
    """The parts of every line of the steps that is worked out; of 1.968 m = 1968 mm what goes on, in mm."""
    every = (
        re.sub(r" = \S+ m(?= = \S+ mm$)", "", plain(one)).replace("\u2009", " ")
        for step in solution.construction.steps
        for one in step.formulas
    )
    return [parts for parts in (line.split(" = ") for line in every) if len(parts) == WORKED]


@each((*DRAFTED, "8-18", "function-log", "8-15"))
def test_what_is_read_to_one_scale_has_one_count_of_decimals(name: str) -> None:
    solution = drafted(name)
    found: dict[tuple[str, str], set[int | None]] = {}  # by unit and what a millimetre is worth
    for answer in solution.answers.values() if solution is not None else ():
        line = answer.reading.formula
        if isinstance(line, Row) and is_length(line) and answer.reading.mm and not answer.is_place:
            worth = f"{abs(answer.drawn) / answer.reading.mm:.6g}"
            found.setdefault((answer.reading.unit, worth), set()).add(decimals(answer))
    assert all(len(counts) == 1 for counts in found.values()), found


@pytest.mark.parametrize(
    ("name", "scale", "symbol", "end"),
    [("3-10", "0.0015 m/mm", "l_CB", "0.11205 m"), ("A-27", "", "ω_2", "14.49 rad/s")],
)
def test_a_number_that_is_not_asked_has_the_figures_that_later_lines_need_up_to_five(
    name: str, scale: str, symbol: str, end: str
) -> None:
    text = load(name).text
    problem = loads(f"{text}\nscales: {{mu_l: {scale}}}\n") if scale else load(name)
    ends = [parts[-1] for parts in lines_of(solve(problem)) if parts[0] == symbol]
    assert ends == [end]


@pytest.mark.parametrize(
    ("name", "line"),
    [
        ("A-26", "a^n_CB = ω_2^2 l_BC = 2.812^2 × 0.2 = 1.58 m/s^2"),
        ("watt-line", "a^n_CB = ω_2^2 l_BC = 1.147^2 × 0.06 = 0.0789 m/s^2"),
    ],
)
def test_an_answer_has_one_number_and_what_goes_on_with_it_fewer_figures(name: str, line: str) -> None:
    assert line in [" = ".join(parts) for parts in lines_of(solve(load(name)))]


@each(DRAFTED)
def test_what_is_laid_off_is_divided_as_it_is_printed(name: str) -> None:
    solution = drafted(name)
    if solution is None:
        return
    ends = {parts[0]: parts[-1].split(" ")[0] for parts in lines_of(solution)}
    for parts in lines_of(solution):
        of, scale = parts[1].strip("()").split(")/(") if parts[1].count(")/(") == 1 else ("", "")
        if (
            scale.startswith("μ_")
            and of in ends
            and of not in {one.reading.symbol for one in solution.answers.values()}
        ):
            assert parts[2].startswith(f"({ends[of]})"), f"{of} = {ends[of]}: {' = '.join(parts)}"
