"""Claims about the doors to methods: what is handed in has the type that a method is written for."""

from __future__ import annotations

import pytest

from vecpoly.methods.balance import doors as balance
from vecpoly.methods.centres import doors as centres
from vecpoly.methods.curvature import doors as curvature
from vecpoly.methods.devices.registry import device_methods
from vecpoly.methods.forces import doors as forces
from vecpoly.methods.kinematics import doors as kinematics
from vecpoly.methods.machine import doors as machine
from vecpoly.methods.pressure import doors as pressure
from vecpoly.methods.registry import Door, Stage, _signature, methods

ROOMS = (balance, centres, curvature, forces, kinematics, machine, pressure)
DOORS = tuple(door for where in ROOMS for door in vars(where).values() if isinstance(door, Door))


def test_every_method_fits_one_door_and_every_door_has_methods() -> None:
    signatures = [_signature(door.like) for door in DOORS]
    assert len(DOORS) == 19 == len(set(signatures)) and {method.signature for method in methods()} == set(signatures)


@pytest.mark.parametrize("stage", [Stage.POSITION, Stage.VELOCITY, Stage.ACCELERATION])
def test_a_method_is_not_called_for_a_piece_of_another_type(stage: Stage) -> None:
    assert kinematics.DYADS.find(stage, "RRR").group == "RRR"
    with pytest.raises(TypeError, match=r"draws Desk → Dyad → None; here Desk → Drive → None is needed"):
        kinematics.DRIVES.find(stage, "RRR")


def test_a_construction_of_a_device_is_written_for_that_device() -> None:
    for one in device_methods():
        assert list(one.draw.__annotations__.values()) == ["Bench", one.device.__name__, "None"]
