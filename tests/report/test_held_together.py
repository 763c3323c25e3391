"""What is never parted at the end of a line, and small type: exponents, primes, the dot of a unit."""

from __future__ import annotations

from itertools import pairwise

import pytest

from vecpoly.algebra.formula import sym
from vecpoly.report.flow.cells import Kind, cells, gap
from vecpoly.typeset import layout
from vecpoly.typeset.box import MM

EM = 10.5 / MM


@pytest.mark.parametrize(
    ("text", "held"),
    [
        ("ρ = 5 mm", [True, True, True]),
        ("$φ_1$ = 128°", [True, True]),
        ("$ω_1$ = 10 rad/s, so", [True, True, True, False]),
        ("at 30 (m/s)/mm", [False, True]),
        ("link 3 turns", [True, False]),
        ("5 pins", [False]),
    ],
)
def test_a_number_keeps_its_unit_and_a_symbol_its_value(text: str, held: list[bool]) -> None:
    found = cells(text.replace("ρ", "$ρ$"), EM, False)
    assert [not gap(a, b, EM).breakable for a, b in pairwise(found)] == held


def test_a_short_formula_is_not_broken() -> None:
    assert [cell.kind for cell in cells("$φ_1 = 128°$", EM, True)] == [Kind.FORMULA]


def test_the_dot_of_a_unit_is_narrow_in_chinese_too() -> None:
    assert [cell.text for cell in cells("N·m", EM, True)] == ["N·m"]
    assert Kind.CLOSE in [cell.kind for cell in cells("甲·乙", EM, True)]


def test_an_exponent_looks_alike_however_it_was_written() -> None:
    (raised,), (written,) = cells("10⁻¹⁴", EM, False), cells("10^{−14}", EM, False)
    assert raised.box == written.box


def test_the_index_stands_under_the_prime() -> None:
    stacked, prime = layout(sym("R′_{21}"), EM), layout(sym("R_{21}"), EM)
    assert stacked.width < prime.width + 0.1 * EM
