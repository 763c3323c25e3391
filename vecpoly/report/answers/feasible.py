"""Whether a rotor can be balanced in the planes that are left, said in words, and how it is unbalanced."""

from __future__ import annotations

from collections.abc import Iterator

from ...devices.balancing.asked import CLOSES, DYNAMIC, correction, weighing
from ...devices.balancing.rotor import Rotor
from ...solution import Solution
from ...words import Words, joined

ASKING = "能否实现"
_BALANCED = Words("转子已动平衡。", "The rotor is in dynamic balance.")
_UNBALANCED = Words("转子动不平衡。", "The rotor is not in dynamic balance.")


def feasible(solution: Solution, rotor: Rotor) -> Iterator[Words]:
    """Two planes balance every rotor; DYNAMIC where it is asked for has a line and a remark of its own."""
    products = [mass.product for mass in rotor.masses.values() if not mass.unknown]
    unit = weighing(products)
    found = [solution.answers.get(correction(plane, unit).key) for plane in rotor.correct]
    sizes = [one.drawn for one in found if one is not None]
    if ASKING not in solution.problem.statement.zh or len(sizes) < 2:
        return
    planes = joined([Words(f" ${plane}$ ", f"${plane}$") for plane in rotor.correct])
    yield Words(
        f"能实现：在平面{planes.zh}内各加一个质径积。",
        f"It can be carried out, with one mass–radius product in each of the planes {planes.en}.",
    )
    if DYNAMIC.key not in solution.answers:
        yield _UNBALANCED if max(sizes) > CLOSES * sum(products) * unit.products else _BALANCED
