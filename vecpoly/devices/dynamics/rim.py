"""The rim of a flywheel: rim: {D: 900 mm, b/h: 1.5, density: 7300 kg/m^3, v_max: 36 m/s}."""

from __future__ import annotations

from pydantic import BaseModel, ConfigDict, Field

from ..base import Density, Length, Positive, Speed


class Rim(BaseModel):
    """D: its mean diameter; b/h: its width over its height; v_max: at which it may not burst."""

    model_config = ConfigDict(extra="forbid", frozen=True, defer_build=True, populate_by_name=True)
    D: Length
    ratio: Positive = Field(alias="b/h")
    density: Density
    v_max: Speed | None = None
