"""Every printed line reproduces: a reader with a pocket calculator who keys in the figures printed gets the result."""

from __future__ import annotations

import re
from collections.abc import Iterator
from functools import cache
from typing import get_args

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from tests.drawn_library import DRAFTED, drafted, hanging
from tests.each import each
from tests.found import APART
from tests.laws import often
from tests.pocket import Sum, sums
from vecpoly.algebra.formula import Node, Sym, plain
from vecpoly.algebra.quantity import Expr, Of, Rooted, magnitude
from vecpoly.algebra.worked import worked
from vecpoly.solution import Solution
from vecpoly.words import Words

NEGATIVE_SCALE = re.compile(r"= −?μ\S*[^=]* = −?\(−")
PRINTED: tuple[type[Words | Node], ...] = (Words, *get_args(Node))


def printed(value: object) -> Iterator[str]:
    """All that is printed of a value: formulas and sentences."""
    for one in hanging(value, PRINTED):
        yield from (one.zh, one.en) if isinstance(one, Words) else (plain(one),)


@cache
def solved(name: str) -> Solution:
    """As it is drawn for other claims too."""
    solution = drafted(name)
    assert solution is not None
    return solution


@cache
def texts(name: str) -> tuple[str, ...]:
    """All that is printed of its construction."""
    return tuple(printed(solved(name).construction))


@cache
def told(name: str) -> tuple[Sum, ...]:
    """Every sum in the steps, read once for all claims."""
    read = {text: tuple(sums(text)) for text in dict.fromkeys(texts(name))}
    return tuple(one for text in texts(name) for one in read[text])


@each((*DRAFTED, *APART))
def test_every_line_of_the_steps_gives_its_printed_result(name: str) -> None:
    for one in told(name):
        assert one.holds, f"{one.text}: {one.reckoned:.7g}"


@each(DRAFTED)
def test_a_scale_in_a_line_is_positive_whatever_way_the_length_lies(name: str) -> None:
    for text in texts(name):
        assert not NEGATIVE_SCALE.search(text), text


def test_a_negative_scale_would_be_seen() -> None:
    mu, length = magnitude("μ_v", -0.01, "(m/s)/mm"), magnitude("Cc", 54.0, "mm")
    assert NEGATIVE_SCALE.search(plain(worked(Sym("v", "C"), mu * length, "m/s")))


def test_thousands_of_sums_are_read() -> None:
    assert sum(len(told(name)) for name in DRAFTED) > 10 * len(DRAFTED)


SIZES = st.floats(1e-3, 9e4)


@settings(max_examples=often(8))
@given(SIZES, SIZES, SIZES)
def test_any_sum_is_printed_so_that_it_reproduces(a: float, b: float, c: float) -> None:
    one, two, three = (magnitude(name, size, "") for name, size in (("a", a), ("b", b), ("c", c)))
    lines: tuple[Expr, ...] = (one * two, one / two, one * two / three.squared(), one - two + three * one)
    for expr in (*lines, Rooted(one / two), Of("arctan", one)):
        read = list(sums(plain(worked(Sym("d"), expr, "deg" if isinstance(expr, Of) else ""))))
        assert len(read) == 1 and read[0].holds


def test_a_difference_that_four_figures_lose_gets_more_and_what_has_no_value_is_left() -> None:
    one, two = magnitude("a", 12.34567, ""), magnitude("b", 12.34566, "")
    (read,) = sums(plain(worked(Sym("d"), two / (one - two), "")))
    assert read.holds
    nothing = magnitude("c", np.float64(0.0), "")
    with np.errstate(divide="ignore"):
        assert plain(worked(Sym("d"), one / nothing, "m")).endswith("= ∞ m")


def test_guard_figures_are_written_only_where_they_are_needed() -> None:
    arm = magnitude("h", 0.076, "m")
    assert plain(worked(Sym("M"), magnitude("R", 1063.58, "N") * arm, "N·m")).endswith("1063.6 × 0.076 = 80.83 N·m")
    assert plain(worked(Sym("M"), magnitude("R", 1064.01, "N") * arm, "N·m")).endswith("1064 × 0.076 = 80.86 N·m")


@pytest.mark.parametrize(
    ("line", "holds"),
    [
        ("M = R h = 1064 × 0.076 = 80.86 N·m", True),
        ("M = R h = 1064 × 0.076 = 80.83 N·m", False),
        ("J = (89.1)/(64.93^2 × 0.01) = 2.113 kg·m^2", True),
        ("J = (89.1)/(64.93^2 × 0.01) = 2.117 kg·m^2", False),
        ("$ω_{21}$ = $ω_2$ − $ω_1$ = −0.1922 − (−1) = 0.8078 rad/s, counter-clockwise", True),
        ("φ = arctan f = arctan 0.13 = 7.407°", True),
        ("φ = arctan f = arctan 0.13 = 7.41°", True),
        ("φ = arctan f = arctan 0.13 = 7.40°", False),
        ("F = Q tan (α + φ) = 2×10^{3} × tan (10° + 5.71°) = 562.6 N", True),
        ("h = √((0.07854)/(1.5)) = 0.2288 m = 228.8 mm", True),
        ("h = √((0.07854)/(1.5)) = 0.2298 m = 229.8 mm", False),
        ("ρ = 0.0015 × 18.4 = 0.0276 m = 27.5 mm", False),
        ("l = (1.1)/(0.08) = 13.7 mm", False),
        ("l = (1.1)/(0.08) = 13.8 mm", True),
    ],
)
def test_the_calculator_tells_right_lines_from_wrong_ones(line: str, holds: bool) -> None:
    read = list(sums(line))
    assert read and all(one.holds for one in read) is holds


def test_a_symbol_s_number_is_no_factor() -> None:
    assert not list(sums("F_21 = F_12 = 3 N")) and not list(sums("links 1 and 2: $l_{AB}$ = 30 mm"))
