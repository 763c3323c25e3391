"""From where the angle of a drive counts."""

from __future__ import annotations

from ..mechanism.model import Mechanism
from ..words import Words


def counted_from(mech: Mechanism) -> Words:
    """From where the drive's angle counts, and to which ray, where it is told so."""
    drive = mech.drive
    if drive.ray is None:
        return Words.same("")
    line = Words.same(f"${drive.ray.line}$") if drive.ray.line else Words("$x$ 轴", "the $x$ axis")
    pivot = next((letter for letter in mech.link(drive.link).points if letter in mech.frame), "")
    if not drive.ray.to or not pivot:
        return Words(f"（由 {line.zh} 量起）", f" (from {line.en})")
    ray = f"${pivot}{drive.ray.to}$"
    return Words(f"（由 {line.zh} 至 {ray}）", f" (from {line.en} to {ray})")
