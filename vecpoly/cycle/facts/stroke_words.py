"""A stroke in words: limit positions, quick return; of what rests there the stretches, and how long it moves."""

from __future__ import annotations

from math import degrees

from ...words import Words
from ..cycle import Cycle
from ..extremes import Spot
from .found import Stroke
from .shown import shown, where


def stroke_words(cycle: Cycle, stroke: Stroke) -> Words:
    """The two limit positions and the way between them."""
    info = cycle.info(stroke.key)
    low, high, swing = (shown(cycle, stroke.key, v) for v in (stroke.lower.value, stroke.upper.value, stroke.swing))
    at = tuple(_stood(cycle, spot, rest) for spot, rest in zip((stroke.lower, stroke.upper), stroke.rests, strict=True))
    if any(stroke.rests):
        up, down = (f"{degrees(a):.1f}°" for a in (stroke.forth, stroke.back))
        return Words(
            f"${info.symbol}$ 介于 {low}（{at[0]}）和 {high}（{at[1]}）之间，行程 {swing}；"
            f"推程历 {up}，回程历 {down}。",
            f"${info.symbol}$ goes between {low} ({at[0]}) and {high} ({at[1]}), stroke {swing}: "
            f"up in {up}, back in {down}.",
        )
    slow, quick = (f"{degrees(a):.4f}°" for a in (max(stroke.forth, stroke.back), min(stroke.forth, stroke.back)))
    zh = f"${info.symbol}$ 的两极限位置：{low}（{at[0]}）和 {high}（{at[1]}），行程 {swing}；"
    en = f"Limit positions of ${info.symbol}$: {low} ({at[0]}) and {high} ({at[1]}), stroke {swing}; "
    if stroke.theta < 1e-6:
        return Words(zh + "$K$ = 1，无急回特性。", en + "$K$ = 1, no quick return.")
    ratio = f"$K$ = {slow}/{quick} = {stroke.ratio:.5f}"
    return Words(
        zh + f"{ratio}，极位夹角 $θ$ = {degrees(stroke.theta):.4f}°。",
        en + f"{ratio}, $θ$ = {degrees(stroke.theta):.4f}°.",
    )


def _stood(cycle: Cycle, spot: Spot, rest: tuple[float, float] | None) -> str:
    """Where the drive stands at a limit position, or the stretch in which the output rests there."""
    if rest is None:
        return where(cycle, spot)
    begin, end = (f"{cycle.drive.told(a):.1f}" for a in rest)
    return f"${cycle.drive.symbol}$ = {begin}° … {end}°".replace("-", "−")
