"""Loads that depend on how fast the machine runs: a motor by its characteristic, a damper.

Where only the mean speed over a period is known, the work of such loads is not: it changes with the motion.
"""

from __future__ import annotations

from ...errors import EquilibriumError
from ...words import Words
from ..loads import Loads
from .sizes import Motor


def rated(loads: Loads) -> tuple[str, ...]:
    """Names of the loads whose size depends on a speed."""
    motors = (
        one.name
        for one in loads.all
        if one.law is not None and isinstance(one.law.size, Motor) and one.law.size.slope != 0
    )
    return (*motors, *(one.name for one in loads.springs if one.damping))


def refuse_rated(loads: Loads) -> None:
    """EquilibriumError where the surplus of work over a period depends on the speed."""
    if names := rated(loads):
        raise EquilibriumError(
            Words(
                f"{names[0]} 随速度变化，盈亏功也就与速度有关；请用 machine: {{start: ..., until: steady}} 求真实运动"
                "（vecpoly exact）",
                f"{names[0]} depends on the speed, and so does the surplus of work; ask for the true motion with "
                "machine: {start: ..., until: steady} (vecpoly exact)",
            ),
            code="speed",
        )
