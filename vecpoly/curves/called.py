"""What a plot shows, in words: 构件 2 的角速度 ω_2 随 φ_1 的变化曲线."""

from __future__ import annotations

from collections.abc import Sequence

from ..cycle import Column
from ..names import subscripted
from ..words import Words

_SEVERAL = {
    "phi": Words("构件的转角", "angles of the links"),
    "omega": Words("构件的角速度", "angular velocities of the links"),
    "alpha": Words("构件的角加速度", "angular accelerations of the links"),
    "p": Words("坐标", "coordinates"),
    "v": Words("速度及其分量", "velocity and components"),
    "a": Words("加速度及其分量", "acceleration and components"),
    "s": Words("滑块的位移", "travels of the blocks"),
    "gamma": Words("传动角", "transmission angles"),
    "R": Words("运动副反力的大小", "magnitudes of the reactions"),
}


def title_of(drive: Column, groups: Sequence[Sequence[Column]]) -> Words:
    """What the curves of all panels are, over what."""
    named = [_named(group) for group in groups]
    zh, en = "；".join(one.zh for one in named), "; ".join(one.en for one in named)
    return Words(f"{zh}随 ${drive.symbol}$ 的变化曲线", f"{en[:1].upper()}{en[1:]} versus ${drive.symbol}$")


def _named(group: Sequence[Column]) -> Words:
    symbols = [f"${column.symbol}$" for column in group]
    what = group[0].words if len(group) == 1 else _several(group)
    zh, en = "、".join(symbols), ", ".join(symbols)
    if not what.en or f"${group[0].symbol}$" in what.en:  # a load's words have its symbol
        told = what.zh or zh
        return Words(told + " " * told.endswith("$"), what.en or en)
    return Words(f"{what.zh} {zh} ", f"{what.en} ({en})")


def _several(group: Sequence[Column]) -> Words:
    """What all of them are; nothing where they are of different kinds."""
    bases = {column.key.partition(".")[0] for column in group}
    stems = {base.partition("_")[0] for base in bases}
    stem = stems.pop() if len(stems) == 1 else ""
    if stem in ("v", "a", "p"):
        if len(bases) > 1:
            return Words.same("")
        letter = next(iter(bases)).partition("_")[2]
        what = _SEVERAL[stem]
        return Words(f"${subscripted(letter)}$ 点的{what.zh}", f"{what.en} of ${subscripted(letter)}$")
    return _SEVERAL.get(stem, Words.same(""))
