"""In the lines of a problem one symbol stands for one quantity: wherever it is evaluated it has one value."""

from __future__ import annotations

import re

from tests.drawn_library import IDS, drawn
from tests.each import each
from tests.found import FOUND
from tests.pocket import sums
from vecpoly.algebra.formula import plain
from vecpoly.algebra.rounding import read_back

SAME = 0.02  # share by which a value found in two ways may differ, by drawing and by formula


@each([*IDS, *FOUND])
def test_a_symbol_has_one_value_wherever_it_is_evaluated(name: str) -> None:
    found: dict[tuple[str, str], tuple[float, str]] = {}
    for step in drawn(name).construction.steps:
        for line in map(plain, step.formulas):
            symbol, end = line.split(" = ")[0], re.split(" = | ≈ ", line)[-1]
            number, _, unit = end.partition(" ")
            if not unit or not list(sums(line)):
                continue
            size = abs(read_back(number)[0])
            before, text = found.setdefault((symbol, unit), (size, line))
            assert abs(before - size) <= SAME * max(before, size), f"{text}; {line}"


@each([*IDS, *FOUND])
def test_an_angle_that_is_read_has_a_symbol_of_its_own_in_each_solution(name: str) -> None:
    found: dict[str, str] = {}
    for step in drawn(name).construction.steps:
        for line in map(plain, step.formulas):
            symbol, end = line.split(" = ")[0], line.rsplit(" = ", 1)[-1]
            if end.endswith("°"):
                assert "{" not in symbol, f"{symbol} is no symbol"
                assert found.setdefault(symbol, end) == end, f"{line}; before: {found[symbol]}"


LAID_OFF = re.compile(r"\S+ = \((.+?)\)/\(μ_[va]\)")
READ = re.compile(r"(.+?) = (?:.+ = )?μ_[va]\u2009")


@each([*IDS, *FOUND])
def test_a_vector_that_was_computed_or_given_and_then_laid_off_is_not_read_off_the_paper(name: str) -> None:
    lines = [plain(line) for step in drawn(name).construction.steps for line in step.formulas]
    laid = {found[1] for line in lines if (found := LAID_OFF.match(line))}
    for line in lines:
        read = READ.match(line)
        assert read is None or read[1] not in laid, line
