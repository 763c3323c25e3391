"""The kinds of figure on a sheet, one small file each: adding a file adds a kind."""

from __future__ import annotations

from . import (
    acceleration,
    balancing,
    body,
    characteristic,
    displacement,
    energy,
    force,
    mechanism,
    torque,
    velocity,
    wheels,
)
from .kind import View, register, scales, view_named, views
from .mu import Mu

__all__ = [
    "Mu",
    "View",
    "acceleration",
    "balancing",
    "body",
    "characteristic",
    "displacement",
    "energy",
    "force",
    "mechanism",
    "register",
    "scales",
    "torque",
    "velocity",
    "view_named",
    "views",
    "wheels",
]
