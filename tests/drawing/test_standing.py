"""What labels cost each other while they look for their places."""

from __future__ import annotations

import numpy as np
import pytest

from vecpoly.drawing.labels.want import Thing
from vecpoly.drawing.weighing.clashes import Others, Trial, clashes
from vecpoly.drawing.weighing.standing import Meeting, Standing
from vecpoly.drawing.weighing.stood import LEADERS_CROSS, Stood

COUNT, PLACES = 7, 12  # labels, and places of each
HALF = complex(3.0, 1.8)
THINGS = [Thing.POINT, Thing.LINK] * 3 + [Thing.OTHER]
NUMBERS = list(range(PLACES))


def places_of(seed: int, *, led: bool) -> tuple[np.ndarray, np.ndarray | None]:
    """Middles of the places of a label, some far from the others, and the feet of their leaders, all about it."""
    rng = np.random.default_rng(seed)
    middles = rng.uniform(0.0, 30.0, PLACES) + 1j * rng.uniform(0.0, 30.0, PLACES)
    middles[::4] += 200.0
    return middles, middles + 9.0 * np.exp(2j * np.pi * rng.random(PLACES)) if led else None


def trial_of(i: int, *, led: bool) -> Trial:
    """Some places of label i."""
    return Trial(*(places_of(i, led=led)[0], HALF, places_of(i, led=led)[1], THINGS[i]))


@pytest.mark.parametrize("led", [False, True])
def test_a_label_that_came_back_costs_what_it_would_if_it_had_never_moved(led: bool) -> None:
    rng = np.random.default_rng(5)
    trial = trial_of(0, led=led)
    standing, followed = Standing.nowhere(COUNT), Meeting(trial, NUMBERS, 0, COUNT)
    for _ in range(120):
        i, place = int(rng.integers(0, COUNT)), int(rng.integers(0, PLACES))
        standing.put(i, place, trial_of(i, led=bool(i % 2)).one(place))
        if rng.random() < 0.5:
            continue  # not looked at after every move
        followed.look(standing)
        anew, again = (Meeting(trial, NUMBERS, 0, COUNT, {}, known) for known in ({}, followed.known))
        anew.look(standing)
        again.look(standing)
        assert [followed.whom(k, standing) for k in range(PLACES)] == [anew.whom(k, standing) for k in range(PLACES)]
        singly = [anew.at(k, standing) for k in range(PLACES)]
        assert (
            followed.cost(standing).tolist() == anew.cost(standing).tolist() == again.cost(standing).tolist() == singly
        )


@pytest.mark.parametrize("led", [False, True])
def test_two_labels_cost_each_other_the_same_whether_they_are_weighed_alone_or_among_many(led: bool) -> None:
    for i in range(1, COUNT):
        trial, other = trial_of(i, led=led), trial_of(0, led=bool(i % 2))
        stood = [other.one(k) for k in range(PLACES)]
        many = clashes(trial, Others.of(stood))
        assert many.tolist() == [[trial.one(k).meets(one) for one in stood] for k in range(PLACES)]
        assert many.T.tolist() == clashes(other, Others.of([trial.one(k) for k in range(PLACES)])).tolist()
        assert many.any()


def test_leaders_that_cross_are_dear_from_whichever_side_one_comes() -> None:
    for turn in np.exp(2j * np.pi * np.arange(12) / 12):
        one, other = (
            Stood.at(centre * turn, HALF, foot * turn, Thing.OTHER)
            for centre, foot in ((20 + 0j, -20 + 0j), (20j, -20j))
        )
        beside = Stood.at(30j * turn, HALF, 12j * turn, Thing.OTHER)
        assert one.meets(other) == other.meets(one) == LEADERS_CROSS and not one.meets(beside)


@pytest.mark.parametrize("below", [np.inf, 140.0, 20.0])
def test_the_cheapest_place_is_found_whether_or_not_all_are_weighed(below: float) -> None:
    rng = np.random.default_rng(3)
    trial, standing = trial_of(0, led=True), Standing.nowhere(COUNT)
    meeting = Meeting(trial, NUMBERS, 0, COUNT)
    for n in range(200):
        i, place = n % (COUNT - 1) + 1, int(rng.integers(0, PLACES))
        standing.put(i, place, trial_of(i, led=bool(i % 2)).one(place))
        meeting.look(standing)
        total = np.sort(rng.uniform(0.0, 60.0, PLACES).round(-1))
        anew = Meeting(trial, NUMBERS, 0, COUNT)
        anew.look(standing)
        cost = (total + anew.cost(standing)).tolist()
        best = min((below, -1), min(zip(cost, NUMBERS, strict=True)))
        assert meeting.cheapest(total, (below, -1), standing) == best


def test_a_label_is_no_neighbour_of_itself_nor_of_one_that_stands_far_off() -> None:
    trial = Trial(np.array([0j, 5 + 0j]), HALF, None)
    standing, meeting = Standing.nowhere(2), Meeting(trial, [0, 1], 0, 2)
    standing.put(0, 0, trial.one(0))
    standing.put(1, 0, Stood.at(100 + 0j, HALF, None, Thing.OTHER))
    meeting.look(standing)
    assert not meeting.cost(standing).any()
    standing.put(1, 1, Stood.at(1 + 0j, HALF, None, Thing.OTHER))
    meeting.look(standing)
    assert meeting.cost(standing).all()
    assert meeting.whom(0, standing) == [1]
