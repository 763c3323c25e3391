"""What is said in a step of lines that hardly cross: one sentence, however many such meetings it has."""

from __future__ import annotations

from collections.abc import Sequence

from ...words import Words


def grazing(angles: Sequence[float]) -> Words:
    """That the meetings at these angles (deg) are uncertain; two that read alike are told by one number."""
    told = list(dict.fromkeys(f"{angle:.0f}°" for angle in angles))
    if len(told) == 1:
        return Words(
            f"（两方向线交角仅 {told[0]}，交点不易准确，宜用计算复核。）",
            f" (The two lines meet at only {told[0]}: a poorly defined intersection, to be checked by computation.)",
        )
    return Words(
        f"（几处两方向线交角仅 {'、'.join(told)}，交点均不易准确，宜用计算复核。）",
        f" (Lines meet at only {', '.join(told[:-1])} and {told[-1]}: poorly defined intersections, to be checked "
        "by computation.)",
    )
