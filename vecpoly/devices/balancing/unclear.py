"""What is refused of readings on a running rotor: no effect, or runs that contradict each other."""

from __future__ import annotations

from ...errors import NotAskedError
from ...words import Words
from .field import FieldBalancing


def check_effect(device: FieldBalancing, effect: float) -> None:
    """NotAskedError where the trial weight changes no more than the last digits of the readings."""
    if effect > device.unclear * (1 + 1e-9):
        return
    unit, least = device.unit, device.unclear
    raise NotAskedError(
        Words(
            f"试重引起的变化只有 {effect:.3g} {unit}，不大于两次读数末位的误差 {least:.3g} {unit}，不能据以校正；"
            "请加大试重或改变其方位",
            f"the trial weight changes the vibration by {effect:.3g} {unit}, no more than the last digits of two "
            f"readings leave open, {least:.3g} {unit}: take a larger trial weight, or another place",
        ),
        code="unreadable",
        numbers={"effect": effect, "error": least},
    )


def no_meeting(one: int, other: int, gap: float, unit: str) -> NotAskedError:
    """Two arcs that do not meet; gap: how far they stay apart."""
    return NotAskedError(
        Words(
            f"第 {one} 次与第 {other} 次试重的读数互相矛盾：两弧相距 {gap:.3g} {unit}，不相交，没有一个不平衡量能给出"
            "这些读数；"
            "请重测，并检查转速是否相同",
            f"runs {one} and {other} contradict each other: their arcs stay {gap:.3g} {unit} apart, no unbalance gives "
            "such readings; measure again, and check that the speed was the same",
        ),
        code="contradiction",
        numbers={"gap": gap, "run": one, "other": other},
    )


def check_spread(device: FieldBalancing, spread: float, effect: float) -> None:
    """NotAskedError where the triangle of three arcs is as large as what it is to tell."""
    if spread < effect:
        return
    unit = device.unit
    raise NotAskedError(
        Words(
            f"三弧围成的三角形边长 {spread:.3g} {unit}，不小于试重的效应 {effect:.3g} {unit}：读数互相矛盾，请重测",
            f"the triangle of the three arcs has a side of {spread:.3g} {unit}, no less than the effect of the trial "
            f"weight, {effect:.3g} {unit}: the readings contradict each other, measure again",
        ),
        code="contradiction",
        numbers={"spread": spread, "effect": effect},
    )
