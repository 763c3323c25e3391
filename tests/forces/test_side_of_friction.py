"""φ on the wrong side of a normal is a mistake of the catalogue, of slides and of contacts."""

from __future__ import annotations

import pytest

from tests.grading.cases import key_of, marked, mutants_of
from vecpoly import Mistake, Slip, load, slips
from vecpoly.grading.key import Kind
from vecpoly.solution import solve


@pytest.mark.parametrize(("name", "reaction"), [("4-3a", "R_43"), ("cam-roller-load", "R_23")])
def test_a_reaction_that_leans_by_friction_may_lean_the_other_way(name: str, reaction: str) -> None:
    made = [slip for slip in slips(load(name)) if slip.mistake is Mistake.OTHER_SIDE]
    assert made and all(slip.key.startswith("R_") for slip in made)
    assert not [slip for slip in slips(load(name)) if slip.mistake is Mistake.COMPLEMENT]


def test_it_turns_the_reaction_of_a_slide_by_twice_the_angle_of_friction() -> None:
    slip = Slip(Mistake.OTHER_SIDE, "R_43")
    right, wrong = (solve(load("4-3a"), by="exact", repeats=0, precise=False, slip=s).answers for s in (None, slip))
    there, here = right["R_43"].direction, wrong["R_43"].direction
    assert there is not None and here is not None and abs(there - here) == pytest.approx(16.0)  # φ = 8°
    assert there + here == pytest.approx(180.0)  # about the normal, which stands upright


def test_without_friction_nobody_can_make_it() -> None:
    assert not [slip for slip in slips(load("6-1")) if slip.mistake is Mistake.OTHER_SIDE]


def test_marking_names_it() -> None:
    key, slip = key_of("4-3a"), Slip(Mistake.OTHER_SIDE, "R_43")
    mutant = next(one for one in mutants_of("4-3a") if slip in (one.slip, *one.also))
    cells = {}
    for one in key.quantities:
        value = mutant.value_of(one)
        sense = "" if one.kind is not Kind.SIGNED else " ccw" if value.value > 0 else " cw"
        way = f" ∠ {value.degrees:.1f}°" if one.kind is Kind.VECTOR and value.degrees is not None else ""
        cells[one.key] = f"{abs(value.value):.4g}{sense}{way}"
    found = marked("4-3a", cells)
    (root,) = found.slips
    assert found.slips[root] == slip
    assert any("the angle on the other side" in said.words.en for said in found[root].messages)
