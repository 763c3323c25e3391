"""Figures whose given scale leaves them too small to be read, or larger than any sheet."""

from __future__ import annotations

from collections.abc import Iterable

from ...algebra.quantity import number
from ...limits import SHEET, SMALL
from ...words import Words
from ..construction import Figure
from ..place import View
from .extent import extent, figured


def unfit(figures: Iterable[Figure], given: Iterable[View]) -> tuple[Words, ...]:
    """A remark on each kind of figure whose scale is given and which is under 20 mm, or over an A4 sheet, in size."""
    views = set(given)
    sizes: dict[View, tuple[float, float, Figure]] = {}
    for figure in figures:
        if figure.view in views:
            wide, high = extent(figured(figure.marks))
            sizes[figure.view] = max(
                sizes.get(figure.view, (-1.0, -1.0, figure)), (wide, high, figure), key=lambda size: max(size[:2])
            )
    idle = [_unused(view) for view in sorted(views - set(sizes), key=str)]
    return (*(said for size in sizes.values() for said in _said(*size)), *idle)


def _unused(view: View) -> Words:
    key = view.mu.key
    return Words(
        f"题中给出 {key}，但本题不作这种图，该比例尺没有用到",
        f"{key} is given, but no such figure is drawn here: the scale is not used",
    )


def _said(wide: float, high: float, figure: Figure) -> Iterable[Words]:
    scale, measures = figure.scale, f"{number(wide)} × {number(high)} mm"
    title = figure.title.en[:1].lower() + figure.title.en[1:]  # its symbols as they are
    symbol = f"${scale.symbol}$ = {number(scale.told.value)} {scale.told.per_mm}"
    if max(wide, high) < SMALL:
        yield Words(
            f"{symbol}：{figure.title.zh}只有 {measures}，读数不可靠；请取较小的比例尺或 auto",
            f"{symbol}: the {title} measures only {measures}, too small to be read; choose a smaller scale, or auto",
        )
    if max(wide, high) > max(SHEET) or min(wide, high) > min(SHEET):
        yield Words(
            f"{symbol}：{figure.title.zh}为 {measures}，A4 图纸容不下；请取较大的比例尺或 auto",
            f"{symbol}: the {title} measures {measures}, more than an A4 sheet holds; choose a larger scale, or auto",
        )
