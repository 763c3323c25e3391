"""What a figure shows, for whoever cannot see it: its title and scale, and what stands on it, as it is read out."""

from __future__ import annotations

from collections.abc import Iterable

from ...algebra.quantity import number
from ...board.construction import Construction, Figure
from ...board.paper.marks import Cell, Dot, LinkNumber, Mark, Point, TurnArrow, Vector
from ...drawing.details.apart import is_detail
from ...drawing.figure import titled
from ...drawing.sheets.sheet import Placed
from ...errors import UnknownNameError
from ...names import parse_rel
from ...tagging.speech import spoken, words_said
from ...words import Lang, Words

_MOST = 40  # things of a kind that are named
_KINDS = (
    (Words("构件", "links"), LinkNumber),
    (Words("矢量", "vectors"), Vector),
    (Words("点", "points"), Point),
    (Words("转向", "turning arrows"), TurnArrow),
    (Words("方框", "boxes"), Cell),
)
_SCALE = Words("比例尺", "scale")
_PART = Words("；所属图形：", "; part of: ")


def shown(figure: Figure, lang: Lang, *, scaled: bool = True) -> str:
    """The figure in words; scaled: lengths mean something on it."""
    parts = [words_said(titled(figure).of(lang), lang)]
    if scaled and figure.scale.symbol and figure.scale.value:
        scale = f"{figure.scale.symbol} = {number(figure.scale.told.value)} {figure.scale.told.per_mm}"
        parts.append(f"{_SCALE.of(lang)} {spoken(scale, lang)}")
    for kind, mark in _KINDS:
        named = dict.fromkeys(_named((one for one in figure.marks if isinstance(one, mark)), lang, scaled))
        if named:
            parts.append(f"{kind.of(lang)}{'：' if lang == 'zh' else ': '}{_listed(list(named), lang)}")
    return ("；" if lang == "zh" else "; ").join(parts)


def placed(one: Placed, construction: Construction, lang: Lang) -> str:
    """What a figure of a sheet shows, in words; of a detail also which figure it is a part of."""
    for figure in construction.figures:
        if (figure.view, figure.name) == (one.view, one.name):
            own = one.figure
            return shown(figure if own is None or own.scale == figure.scale else own, lang)
        if one.figure is not None and figure.view is one.view and is_detail(one.name, figure):
            return f"{shown(one.figure, lang)}{_PART.of(lang)}{words_said(figure.title.of(lang), lang)}"
    return words_said(one.view.title.of(lang), lang) if one.figure is None else shown(one.figure, lang)


def _listed(names: list[str], lang: Lang) -> str:
    rest = ("……" if lang == "zh" else ", …") if len(names) > _MOST else ""
    return ("、" if lang == "zh" else ", ").join(names[:_MOST]) + rest


def _named(marks: Iterable[Mark], lang: Lang, scaled: bool) -> Iterable[str]:
    """The names of these marks, of vectors with their length on paper."""
    for mark in marks:
        match mark:
            case LinkNumber(number=name):
                yield name
            case Vector(a=a, b=b) if symbol := mark.label or _symbol(mark.key):
                yield spoken(f"{symbol} {abs(b - a):.1f} mm" if scaled else symbol, lang)
            case Point(label=label, dot=dot) if label and dot is not Dot.NONE:
                yield spoken(label, lang)
            case TurnArrow(label=label) if label:
                yield spoken(label, lang)
            case Cell(words=words):
                yield words_said(words.of(lang), lang)
            case _:
                pass


def _symbol(key: str) -> str:
    """The symbol of a quantity: v_{C2B}."""
    try:
        return parse_rel(key).symbol
    except UnknownNameError:
        return key
