"""What labels cost each other while they look for their places."""

from __future__ import annotations

import numpy as np
import pytest

from vecpoly.drawing.labels.want import Thing
from vecpoly.drawing.standing import NOWHERE, Meeting, Standing, Trial

COUNT, PLACES = 7, 12  # labels, and places of each
HALF = complex(3.0, 1.8)


def places_of(seed: int, *, led: bool) -> tuple[np.ndarray, np.ndarray]:
    """Middles of the places of a label, some far from the others, and the feet of their leaders."""
    rng = np.random.default_rng(seed)
    middles = rng.uniform(0.0, 30.0, PLACES) + 1j * rng.uniform(0.0, 30.0, PLACES)
    middles[::4] += 200.0
    return middles, middles + 6.0 if led else np.full(PLACES, NOWHERE)


@pytest.mark.parametrize("led", [False, True])
def test_a_label_that_came_back_costs_what_it_would_if_it_had_never_moved(led: bool) -> None:
    rng = np.random.default_rng(5)
    centre, foot = places_of(0, led=led)
    trial = Trial(centre, HALF, foot if led else None, Thing.POINT)
    standing, followed = Standing.nowhere([Thing.POINT, Thing.LINK] * 3 + [Thing.OTHER]), Meeting(trial, 0, COUNT)
    for _ in range(120):
        i, place = int(rng.integers(0, COUNT)), int(rng.integers(0, PLACES))
        middles, feet = places_of(i, led=bool(i % 2))
        standing.put(i, place, complex(middles[place]), HALF, complex(feet[place]))
        if rng.random() < 0.5:
            continue  # not looked at after every move
        followed.look(standing)
        anew, again = Meeting(trial, 0, COUNT), followed.again()
        anew.look(standing)
        again.look(standing)
        assert followed.cost.tolist() == anew.cost.tolist() == again.cost.tolist()
        assert [followed.whom(k) for k in range(PLACES)] == [anew.whom(k) for k in range(PLACES)]


def test_a_label_is_no_neighbour_of_itself_nor_of_one_that_stands_far_off() -> None:
    trial = Trial(np.array([0j, 5 + 0j]), HALF, None)
    standing, meeting = Standing.nowhere([Thing.OTHER] * 2), Meeting(trial, 0, 2)
    standing.put(0, 0, 0j, HALF, NOWHERE)
    standing.put(1, 0, 100 + 0j, HALF, NOWHERE)
    meeting.look(standing)
    assert not meeting.cost.any()
    standing.put(1, 1, 1 + 0j, HALF, NOWHERE)
    meeting.look(standing)
    assert meeting.cost.all()
    assert meeting.whom(0) == [1]
