"""Which circle of a crowd is drawn apart: the best of all that hold the nearest few about a place, found among many."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
import shapely
from hypothesis import given, settings
from hypothesis import strategies as st

from tests.laws import often
from vecpoly.drawing.details.knot import FACTORS, SEEN, Knot, Trouble, finds_room, largest, ring
from vecpoly.drawing.details.knots import CROWDED, Crowd
from vecpoly.drawing.details.nest import WHOLE, Nest

PLACES = st.integers(0, 12).flatmap(lambda x: st.integers(0, 12).map(lambda y: complex(1.7 * x, 1.7 * y)))


def one_by_one(troubles: list[Trouble], across: float) -> tuple[int, float] | None:
    """What the best circle about the nearest few of any place is worth, and how large its detail: each is drawn."""
    places = list(dict.fromkeys(end for one in troubles for end in (one.a, one.b)))
    tried = []
    for at in places:
        order = sorted(places, key=lambda z: abs(z - at))
        for n in range(2, len(order) + 1):
            inside = [one for one in troubles if {one.a, one.b} <= set(order[:n])]
            circle = shapely.minimum_bounding_circle(shapely.multipoints([(z.real, z.imag) for z in order[:n]]))
            bare = float(shapely.minimum_bounding_radius(circle))
            made = [factor for factor in FACTORS if finds_room(bare, factor, largest(across))]
            if not inside or not made:
                continue
            well = (one for one in made if all(each.solved(one, well=True) for each in inside))
            shown = {one: sum(each.worth for each in inside if each.solved(one)) for one in made}
            factor = next(well, max(made, key=lambda one: (shown[one], -one)))
            if WHOLE * ring(bare, factor) <= across:
                tried.append((sum(one.worth for one in inside if one.solved(factor)), -ring(bare, factor) * factor))
    best = max(tried, default=(0, 0.0))
    return best if best[0] >= SEEN else None


def worth(knot: Knot, troubles: list[Trouble]) -> int:
    """What of all that lies in a knot is solved by its factor, and how much that is worth."""
    inside = [one for one in troubles if knot.holds(one.a) and knot.holds(one.b)]
    return sum(one.worth for one in inside if one.solved(knot.factor))


@given(st.lists(PLACES, min_size=3, max_size=14, unique=True), st.floats(20.0, 200.0))
@settings(max_examples=often(20))
def test_no_other_circle_shows_more_than_the_best_and_none_as_much_in_a_smaller_detail(
    places: list[complex], across: float
) -> None:
    near = [(a, b) for n, a in enumerate(places) for b in places[:n] if abs(a - b) <= CROWDED]
    troubles = [Trouble(a, b, n % 5 == 0) for n, (a, b) in enumerate(near)]
    found = Nest.of(troubles).best(across, []) if troubles else None
    expected = one_by_one(troubles, across)
    assert (found is None) == (expected is None)
    if found is not None and expected is not None:
        assert -found.radius * found.factor == pytest.approx(expected[1], rel=1e-12)
        assert worth(found, troubles) >= expected[0]


def test_of_two_hundred_letters_in_one_crowd_few_circles_are_drawn(monkeypatch: pytest.MonkeyPatch) -> None:
    dice, drawn = np.random.default_rng(1), list[int]()
    letters = tuple(complex(*dice.normal(0.0, 6.0, 2)) for _ in range(200))
    least = shapely.minimum_bounding_circle

    def counted(places: Any) -> Any:
        drawn.append(1)
        return least(places)

    monkeypatch.setattr(shapely, "minimum_bounding_circle", counted)
    assert Crowd(letters, (), 150.0).knots
    assert len(drawn) < 2 * len(letters)  # of 40,000 sets of the nearest few, for each knot that is found
