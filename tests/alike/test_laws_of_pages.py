"""Pages of a problem that is told otherwise say the same; and a law that does not hold is found not to."""

from __future__ import annotations

import json

import numpy as np
import pytest

from tests.alike.law import Law, mirrored, unnumbered, whole
from tests.alike.laws import LAWS
from tests.alike.said import Line
from tests.generators.family import families, member
from tests.generators.library import Data, data_of

SEED = 6
FAMILIES = ("four-bar", "linkage-rpr", "linkage-rrp", "gears-pivots", "forces-masses", "class-iii-hinged")


def original(family: str) -> Data:
    """A member of a family."""
    (kind,) = (one for one in families() if one.name == family)
    return data_of(member(kind, SEED, 0))


@pytest.mark.parametrize("family", FAMILIES)
def test_a_problem_told_otherwise_has_the_same_pages(family: str) -> None:
    data = original(family)
    broken = {law.name: law.broken(np.random.default_rng(SEED), data) for law in LAWS}
    assert not {name: told for name, told in broken.items() if told}


def test_every_law_speaks_of_some_of_these_problems() -> None:
    every = [original(family) for family in FAMILIES]
    for law in LAWS:
        told = [law.retold(np.random.default_rng(SEED), data) for data in every]
        assert any(
            other is not None and json.dumps(other) != json.dumps(data) for other, data in zip(told, every, strict=True)
        )


def faster(rng: np.random.Generator, data: Data) -> Data:
    """ω alone half as large again."""
    return data | {"input": data["input"] | {"omega": "15 rad/s"}}


def test_a_law_that_does_not_hold_is_found_not_to() -> None:
    data = original("four-bar")
    for seen in (whole, unnumbered):
        assert Law(name="faster", retold=faster, before=seen, after=seen).broken(np.random.default_rng(SEED), data)


def test_what_is_hidden_are_numbers_that_are_no_lengths_on_paper_and_letters() -> None:
    line = Line("pb = (v_B)/(μ_v) = (0.300)/(0.006) = 50.0 mm", formula=True)
    assert unnumbered(line) == "pb = (v_B)/(μ_v) = (#)/(#) = 50.0 mm"
    assert Line("Point $C_2$ belongs to links 2 and 3.").letterless == "Point $_2$ belongs to links 2 and 3."
    assert mirrored("C to the left, counter-clockwise") == "C to the right, clockwise"
