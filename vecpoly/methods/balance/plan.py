"""The stage of the balance: link by link masses are passed on to the frame, with counterweights where they are hung."""

from __future__ import annotations

from ...algebra.quantity import Sum, magnitude
from ...board.place import view_named
from ...mechanism.asked.counterweights import ADDED, SHARE
from ...mechanism.counterweights import Passing, translating
from ...problem.problem import Problem
from ...words import Words
from ..desk import Desk
from ..registry import Stage
from .doors import PASSINGS
from .standing import weighing_of


def balance_pass(desk: Desk, problem: Problem) -> None:
    """Draw all counterweights; the readings are on the board."""
    asked = problem.counterweights
    assert asked is not None
    here = weighing_of(desk, asked, problem.scales.wished(view_named("products").mu))
    for one in asked.order:
        PASSINGS.find(Stage.BALANCE, _group(desk, one)).draw(here, one)
    desk.board.step(
        Words(
            "各构件的质径积都已平衡，机构总质心静止，任何位置、任何转速下惯性力的合力为零（惯性力矩未平衡）。"
            "所加质量及其与机构原有质量之比：",
            "The products of every link are balanced now: the common centre of mass stands still, and the inertia "
            "forces sum to zero at any position and speed (their moment is not balanced). The mass added "
            "and its ratio to the mass of the linkage are:",
        )
    )
    weights = tuple(here.hung)
    added = here.bench.worked(ADDED, Sum(weights, (1,) * len(weights)))
    here.bench.worked(SHARE, added / magnitude("Σm", asked.own, "kg"))


def _group(desk: Desk, one: Passing) -> str:
    """Which method passes the masses of this link on."""
    if one.r is not None:
        return "counterweight"
    return "sliding link" if one.link in translating(desk.mech) else "link between hinges"
