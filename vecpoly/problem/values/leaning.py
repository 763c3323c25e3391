"""How a line lies by another in words: the size of the angle and the side, for a sign alone tells a reader nothing."""

from __future__ import annotations

from math import degrees, isclose

from ...words import Words

X_AXIS = Words(" $x$ 轴", "the $x$ axis")
NO_SIDE = Words("", "")


def side_of(turn: float, other: Words, *none: float) -> Words:
    """Which way an angle (degrees, −180 to 180) counts from another line; of none, and of those that have no side,
    nothing."""
    if any(isclose(abs(turn), one, abs_tol=1e-9) for one in (0.0, *none)):
        return NO_SIDE
    zh, en = ("顺", "clockwise") if turn < 0 else ("逆", "counter-clockwise")
    return Words(f"（自{other.zh}{zh}时针量）", f", {en} from the latter")


def at_angle(text: str, turn: float, other: Words) -> Words:
    """An angle as it is written, of this size (rad), to another line: 与 x 轴成 40°（自 x 轴顺时针量）."""
    shown, way = text.strip().lstrip("-−"), side_of(degrees(turn), other, 180.0)
    if way is NO_SIDE:
        return _along(other, opposite=abs(turn) > 1.0)
    return Words(f"与{other.zh}成 {shown}{way.zh}", f"at {shown} to {other.en}{way.en}")


def _along(other: Words, *, opposite: bool) -> Words:
    """A ray that points as the other line counts, or the other way."""
    zh, en = ("反向", "opposite to") if opposite else ("同向", "in the direction of")
    return Words(f"与{other.zh}{zh}", f"{en} {other.en}")
