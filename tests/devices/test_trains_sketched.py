"""What the sketch of a train shows beside its pitch circles: teeth, senses, moments, what is lifted, what is held."""

from __future__ import annotations

from typing import Any

import pytest
from hypothesis import given, settings

from tests.cam_cases import device, drawn
from tests.devices.test_reduced_trains import chains, hoist, train
from tests.devices.test_trains_and_gears import trains
from tests.laws import often
from vecpoly.board.construction import View
from vecpoly.board.paper.marks import (
    Disc,
    FixedGuide,
    GearMark,
    Mark,
    Note,
    Outline,
    Point,
    Role,
    Segment,
    TurnArrow,
    Vector,
)
from vecpoly.devices.base import Device
from vecpoly.errors import NotAskedError
from vecpoly.oracle.devices.registry import device_answers


def marks(shown: Device) -> tuple[Mark, ...]:
    figure = drawn(shown).figure(View.MECHANISM)
    assert figure is not None
    return figure.marks


def arrows(found: tuple[Mark, ...]) -> dict[str, bool]:
    return {mark.label: mark.ccw for mark in found if isinstance(mark, TurnArrow)}


@given(chains())
@settings(max_examples=often(8))
def test_two_gears_in_mesh_turn_against_each_other_and_moments_drive_with_them_or_resist(data: dict[str, Any]) -> None:
    shown = train(**data)
    found = marks(shown)
    turns = {label[3:-1]: ccw for label, ccw in arrows(found).items() if label.startswith("ω")}
    assert set(turns) == set(shown.shafts) and turns[data["to"]]  # type: ignore[attr-defined]
    for pair in shown.pairs:  # type: ignore[attr-defined]
        assert turns[pair.first] != turns[pair.second]
    for label, ccw in arrows(found).items():
        if label.startswith("M"):
            assert (ccw == turns[label[4:-1]]) == label.startswith("M_{d")


@given(chains())
@settings(max_examples=often(8))
def test_every_wheel_has_the_symbol_of_its_teeth_beside_it_which_are_among_the_data(data: dict[str, Any]) -> None:
    """A letter as large as all others: a number in small type did not go with ω beside it."""
    shown = train(**data)
    found = marks(shown)
    told = [mark.label for mark in found if isinstance(mark, Point) and mark.label.startswith("z")]
    assert len(told) == len(set(told)) == sum(isinstance(mark, GearMark) for mark in found)
    assert set(told) <= dict(shown.given()).keys()
    assert not any(isinstance(mark, Note) for mark in found)


def test_the_drum_of_a_hoist_has_one_name() -> None:
    """It was D on the sketch and D_3 among the data."""
    labels = {mark.label for mark in marks(hoist()) if isinstance(mark, Point)}
    assert "D_{3}" in labels and "D" not in labels and "D_{3}" in dict(hoist().given())


@pytest.mark.parametrize("to", ["1", "2", "3"])
def test_the_rope_of_a_hoist_leaves_the_drum_where_its_rim_rises(to: str) -> None:
    lifting = hoist().model_copy(update={"to": to})
    found = marks(lifting)
    drum = next(mark for mark in found if isinstance(mark, Disc))
    rope = next(mark for mark in found if isinstance(mark, Segment) and mark.role is Role.GIVEN)
    assert abs(abs(rope.a - drum.centre) - drum.radius) < 1e-9 and rope.a.imag == drum.centre.imag
    assert (rope.a.real > drum.centre.real) == arrows(found)["ω_{3}"]
    load = next(mark for mark in found if isinstance(mark, Outline))
    assert rope.b.real == rope.a.real and rope.b.imag == max(z.imag for z in load.points)
    pulls = {mark.label: mark.b - mark.a for mark in found if isinstance(mark, Vector)}
    assert pulls["mg"].imag < 0 < pulls["v"].imag


@given(trains())
@settings(max_examples=often(8))
def test_an_epicyclic_train_shows_what_is_held_and_which_way_the_others_turn(data: dict[str, Any]) -> None:
    shown = device("epicyclic", **data)
    exact = device_answers(shown)
    try:
        found = marks(shown)
    except (ValueError, NotAskedError):  # a ratio too large to be read
        return
    turns = arrows(found)
    for key in ("1", "2", "3", "H"):
        omega = complex(exact[f"omega_{key}"]).real
        assert turns.get(f"ω_{key}", omega > 0) == (omega > 0) if abs(omega) > 1e-6 else f"ω_{key}" not in turns
    given_zero = [key for key in ("1", "3") if data.get(f"omega_{key}") == "0 rad/s"]
    assert any(isinstance(mark, FixedGuide) for mark in found) == bool(given_zero)
