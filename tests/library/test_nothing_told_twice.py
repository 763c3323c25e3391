"""Nothing is told twice: a line that is worked out, a zero, what was measured of a candidate that is rejected, a term
that vanishes; and what all but vanishes is told."""

from __future__ import annotations

import re
from itertools import pairwise

import pytest

from tests.drawn_library import IDS, drawn
from tests.each import each
from tests.found import FOUND
from tests.framed_answers import rows_in
from vecpoly.algebra.formula import plain
from vecpoly.board.construction import Step, View
from vecpoly.board.said.short import too_short
from vecpoly.problem.load import load
from vecpoly.report.answers.box import answer_box
from vecpoly.report.steps.lines import displayed, with_results
from vecpoly.solution import Solution, solve
from vecpoly.words import bare

WORKED = 3  # signs of equality of a line symbol = formula = numbers = result
SAID_ZERO = re.compile(r"((?:[A-Za-zα-ωΑ-Ω][\w,^{}′]* = )+)0(?![.\d])")
NORMAL = re.compile(r"^The reaction \S+ is normal to the guide of links \S+ and \S+\.$")


def shown(name: str) -> list[tuple[Step, list[str]]]:
    solution = drawn(name).solution
    return [(step, [plain(line) for line in displayed(step, solution)]) for step in solution.construction.steps]


@each(IDS)
def test_a_line_is_worked_out_in_one_step(name: str) -> None:
    found: set[str] = set()
    for step, lines in shown(name):
        worked = [line for line in lines if line.count(" = ") == WORKED]
        again = [line for line in worked if line in found]
        assert not again or again == lines, f"step {step.number}: {again}"
        assert len(set(worked)) == len(worked), f"step {step.number}: {worked}"
        found.update(worked)


@each(IDS)
def test_a_zero_that_a_sentence_tells_has_no_line(name: str) -> None:
    zeros: set[str] = set()
    for step, lines in shown(name):
        for symbols in SAID_ZERO.findall(bare(step.words.zh)):
            zeros.update(symbol for symbol in symbols.split(" = ") if symbol)
        ends = [line for line in lines if re.search(r" = 0( \S+)?$", line)]
        assert not [line for line in ends if line.partition(" = ")[0] in zeros], f"step {step.number}: {ends}"
        text = with_results(step.words.zh, step, drawn(name).solution, "zh").removeprefix(step.words.zh)
        assert not [symbol for symbol in zeros if re.search(rf"{re.escape(symbol)} = 0 ", bare(text))], text


@each(IDS)
def test_no_lengths_of_a_rejected_candidate_stand_beside_those_of_the_solutions(name: str) -> None:
    candidates = drawn(name).construction.candidates
    lost = [f"^({one.number})" for one in candidates if one.reason is not None]
    for step, lines in shown(name) if any(one.reason is None for one in candidates) else ():
        heads = [line.partition(" = ")[0] for line in lines]
        assert not [head for head in heads if any(number in head for number in lost)], f"step {step.number}: {heads}"


@each(IDS)
def test_nothing_is_divided_by_one_nor_are_freedoms_of_nothing_subtracted(name: str) -> None:
    for step, lines in shown(name):
        for line in lines:
            assert not re.search(r"\)/\(1\) = |= \((\S+)\)/\(\1\) = ", line), f"step {step.number}: {line}"
            assert not (line.startswith("F = 3n") and re.search(r"[−+] 0 [−+] 0 |\+ 0 = ", line)), line


@each((*IDS, *FOUND, "guided-couple", "plate-two-slides"))
def test_the_normals_of_the_slides_of_a_group_are_told_in_one_step(name: str) -> None:
    for one, other in pairwise(drawn(name).construction.steps):
        assert not (NORMAL.match(bare(one.words.en)) and NORMAL.match(bare(other.words.en))), other.words.en


@each(IDS)
def test_a_relative_velocity_too_short_to_be_read_is_said_to_be_small(name: str) -> None:
    construction = drawn(name).construction
    desk = drawn(name).desk
    if desk is None:
        return
    told = {step.number: bare(step.words.zh) for step in construction.steps}
    for step in construction.steps:
        if step.equation is None or step.view is not View.VELOCITY:
            continue
        for symbol, size in zip(step.equation.symbols, step.equation.magnitudes, strict=True):
            stood = desk.board.ledger.vector(View.VELOCITY, re.sub(r"[{}]", "", symbol))
            if "+" in symbol:  # two vectors along one line, drawn as one: neither of them is known by it
                continue
            if size == "?" and stood is not None and len(re.sub(r"\d", "", symbol)) > len("v_{CB}") - 1:
                near = too_short(abs(complex(stood.end) - complex(stood.start)))
                assert near == ("很小" in told[step.number]) or not near, symbol


@pytest.mark.parametrize("name", ["A-27-b", "A-27-c"])
def test_two_letters_that_lie_close_together_are_said_to(name: str) -> None:
    solution: Solution = solve(load(name), repeats=0, precise=False)
    told = [step.words for step in solution.construction.steps if "很小" in step.words.zh]
    (words,) = told
    assert bare(words.en).endswith("lie close together: v_F5F4 is too small to be read well.")


@pytest.mark.parametrize("name", ["8-2a", "8-2f"])
def test_of_the_pressure_and_the_transmission_angle_one_is_read(name: str) -> None:
    lines = [plain(line) for step in solve(load(name)).construction.steps for line in step.formulas]
    (alpha,), (gamma,) = ([line for line in lines if line.startswith(f"{symbol} = ")] for symbol in "αγ")
    assert alpha.count(" = ") == 1 and gamma.startswith("γ = 90° − α = 90° − ")


@each((*IDS, "3-9", "ex10"))
def test_links_that_turn_alike_have_one_row_in_the_answer(name: str) -> None:
    solution = drawn(name).solution
    box = answer_box(solution, "en")
    rows = [*(row.keys for row in rows_in(box)), *((line.key, *line.also) for line in box.lines)]
    for key, answer in solution.answers.items():
        told = "" if answer.reading.formula is None else plain(answer.reading.formula)
        if alike := re.match(r"([ωα])_(\w+) = \1_(\w+) = ", told):
            both = {key, f"{'omega' if alike[1] == 'ω' else 'alpha'}_{alike[3]}"}
            assert sum(bool(both & set(keys)) for keys in rows) <= 1, f"{told}: {rows}"
