"""Which places of the drive may be worth drawing: by the vectors of the polygons, and by nothing else that is asked."""

from __future__ import annotations

from dataclasses import replace

from tests.variants.block import block
from vecpoly.problem.problem import Problem
from vecpoly.variants.conditions import Condition
from vecpoly.variants.sweep import Swept, drive_range, sweep

VECTORS = ("v_C2B", "v_E", "at_C2B", "a_E")


def swept(problem: Problem, *keys: str) -> Swept:
    """The range of the drive where this is asked, of whatever sense."""
    asked = tuple(ask for ask in problem.asks if ask.rel.key in keys)
    assert len(asked) == len(keys)
    return sweep(replace(problem, asks=asked), drive_range(problem), {}, frozenset(keys))


def test_angular_velocities_and_accelerations_are_no_vectors_that_fill_a_frame() -> None:
    problem = block()
    bare, more = swept(problem, *VECTORS), swept(problem, *VECTORS, "omega_3", "alpha_3")
    assert bare.failed[Condition.SHORT] and more.failed == bare.failed
    assert (more.passed, more.short) == (bare.passed, bare.short)
