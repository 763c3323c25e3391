"""What a file may say of how a machine runs: the models behind `machine`."""

from __future__ import annotations

from pydantic import BaseModel, ConfigDict, Field

from .fields import Number


class _Said(BaseModel):
    model_config = ConfigDict(extra="forbid", frozen=True, defer_build=True)


class StartSpec(_Said):
    """The state from which a machine moves."""

    phi: Number
    omega: Number


class MachineSpec(_Said):
    """How a machine runs: at a mean speed, as evenly as is allowed or as its flywheel makes it; or from a state."""

    n: Number | None = Field(None, description="mean speed, 60 r/min")
    delta: Number | None = Field(None, description="allowed coefficient of speed fluctuation, 0.05")
    J_F: Number | None = Field(None, description="the flywheel that is there, 6 kg*m^2")
    start: StartSpec | None = Field(None, description="{phi: 30 deg, omega: 0 rad/s}")
    until: Number | None = Field(None, description="how far the driving link is followed, 360 deg; or: steady")
    at: list[Number] = Field([], description="how far from the start its speed is asked for, [90 deg, 180 deg]")


class CounterweightSpec(_Said):
    """A counterweight on a link: how far it sits from the link's pivot."""

    r: Number = Field(description="distance from the pivot by which the link hangs on the frame, 60 mm")
