"""The kinds of figure on a sheet, one small file each: adding a file adds a kind."""

from __future__ import annotations

from . import acceleration, balancing, body, displacement, force, mechanism, velocity, wheels
from .kind import View, register, scales, view_named, views
from .mu import Mu

__all__ = [
    "Mu",
    "View",
    "acceleration",
    "balancing",
    "body",
    "displacement",
    "force",
    "mechanism",
    "register",
    "scales",
    "velocity",
    "view_named",
    "views",
    "wheels",
]
