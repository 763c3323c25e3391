"""A product is printed numbers first, then letters, brackets, and functions last: 2 ω v sin φ; so are its numbers."""

from __future__ import annotations

from collections.abc import Iterator

from tests.course.test_course_models_hold import modelled
from tests.each import each
from tests.laws import few
from vecpoly.algebra.formula import plain
from vecpoly.analytic.equations import Equation
from vecpoly.analytic.expr import Const, Expr, Product, Var
from vecpoly.analytic.functions import Wave, sin
from vecpoly.analytic.numbers import numbers
from vecpoly.errors import NoMethodError
from vecpoly.findings.study.from_pivots import from_pivots
from vecpoly.mechanism.model import Mechanism
from vecpoly.problem.library import library
from vecpoly.problem.load import load

IDS = few([entry.id for entry in library()], 5)


def products(expr: Expr) -> Iterator[Product]:
    """All products in it."""
    if isinstance(expr, Product):
        yield expr
    for part in expr.parts():
        yield from products(part)


def equations(name: str) -> Iterator[Equation]:
    """Every equation of a mechanism's model."""
    mech = load(name).subject
    if not isinstance(mech, Mechanism):
        return
    try:
        found = modelled(from_pivots(mech))
    except NoMethodError:
        return
    yield from (
        one for group in found.groups for stage in group.stages for part in stage.parts for one in part.equations
    )


@each(IDS)
def test_no_factor_stands_behind_a_function_but_another_one(name: str) -> None:
    for equation in equations(name):
        for side in (equation.left, equation.right):
            for one in products(side):
                kinds = [isinstance(factor, Wave) for factor in one.printed]
                assert kinds == sorted(kinds), plain(one.node)


def test_the_order_of_print_is_not_that_of_reckoning() -> None:
    speed, rate, turn = Var("v_{32}"), Var("ω_2"), Var("φ_2")
    one = sin(turn) * rate * speed
    assert isinstance(one, Product) and one.factors == (sin(turn), rate, speed)
    assert plain(one.node).replace("\u2009", " ") == "ω_2 v_32 sin φ_2"
    told = plain(numbers(one * Const("l", 2.0), {"v_{32}": 3.0, "ω_2": 4.0, "φ_2": 0.5}))
    assert told.endswith("sin\u200928.648°") and told.startswith("4 × 3 × 2")
