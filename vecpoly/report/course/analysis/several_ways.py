"""One quantity that is found by several ways, told once with what each of them gives, and by how much they differ."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from ....algebra.rounding import to_places
from ....solution import Answer
from ....words import Words
from ...values import way_of

_POLYGON = Words("力多边形法", "force polygons")  # of what is told without a way
_FEW = 2


def alike(keys: Sequence[str], answers: Mapping[str, Answer]) -> list[list[str]]:
    """The keys, those together that are asked by the same symbol and found by several ways."""
    found: list[list[str]] = []
    for key in keys:
        one = answers.get(key)
        same = next((some for some in found if one is not None and _same(one, answers.get(some[0]))), None)
        found.append([key]) if same is None else same.append(key)
    return found


def _same(one: Answer, other: Answer | None) -> bool:
    told = other is not None and one.reading.symbol == other.reading.symbol
    return told and not one.is_place and any(way_of(each.key) for each in (one, other) if each is not None)


def by_ways(some: Sequence[Answer], numbers: Sequence[str], sense: Words) -> Words:
    """$M_1$ = 798 N·m (force polygons), 799 N·m (Zhukovsky lever), clockwise: they differ by 0.1 %."""
    ways = [way_of(one.key) or _POLYGON for one in some]
    symbol, sizes = f"${some[0].reading.symbol}$", [abs(one.drawn) for one in some]
    most = to_places(100 * (max(sizes) - min(sizes)) / (max(sizes) or 1.0), 1)
    gap = f"{most:.1f}"
    zh = "、".join(f"{number}（{way.zh}）" for way, number in zip(ways, numbers, strict=True))
    en = ", ".join(f"{number} ({way.en})" for way, number in zip(ways, numbers, strict=True))
    two = len(some) == _FEW
    near = (
        Words(f"相差{'' if two else '不超过'} {gap} %", f"they differ by {'' if two else 'at most '}{gap} %")
        if most
        else Words("结果一致", "in agreement")
    )
    return Words(f"{symbol} = {zh}{sense.zh}，{near.zh}", f"{symbol} = {en}{sense.en}: {near.en}")
