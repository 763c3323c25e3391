"""The figures of the construction for the page:
of each, one group of lines for every step and layer, in both languages at once."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from itertools import groupby
from typing import Any

from ..board.construction import Construction, Figure, Place, View
from ..drawing.figure import caption_items, drawing
from ..drawing.order import reading_order
from ..drawing.scene import Item, Rect, Scene
from ..foundation.slotted import replace
from ..names import written_unit
from ..words import Lang, Words
from .setting.ink import UNIT, Ink
from .setting.type import html

LANGS: tuple[Lang, ...] = ("zh", "en")
MARGIN = 2.0  # mm round each figure


@dataclass(frozen=True, slots=True)
class Shown:
    """A figure on the page: its key, name, title as HTML, box in units (x, y, width, height), markup, the steps that
    draw in it, and what a millimetre stands for: 0.006 m/s."""

    key: str
    name: Words
    title: Words
    box: tuple[int, int, int, int]
    svg: str
    steps: tuple[int, ...]
    mu: str = ""


def key_of(one: Figure | Place) -> str:
    """The name of a figure, or of that at a place: velocity, force:3."""
    name = "" if isinstance(one, View) else one.name
    view = one if isinstance(one, View) else one.view
    return f"{view.name}:{name}" if name else view.name


def shown_figures(construction: Construction, ink: Ink) -> tuple[Shown, ...]:
    """All figures in reading order."""
    return tuple(_shown(figure, ink) for figure in reading_order(construction.figures))


def _shown(figure: Figure, ink: Ink) -> Shown:
    first = min((mark.step for mark in figure.marks if mark.step), default=1)
    scenes = {lang: drawing(figure, lang=lang).scene for lang in LANGS}
    items = {lang: tuple(one if one.step else replace(one, step=first) for one in scenes[lang].items) for lang in LANGS}
    both = set(items["zh"]) & set(items["en"])
    parts = [
        ("", [one for one in items["zh"] if one in both]),
        *((lang, [one for one in items[lang] if one not in both]) for lang in LANGS),
    ]
    extents = scenes["zh"].extents | scenes["en"].extents
    steps = tuple(sorted({one.step for one in (*items["zh"], *items["en"])}))
    mu = f"{figure.scale.value:g} {written_unit(figure.scale.unit)}" if figure.scale.symbol else ""
    frame, svg = box(extents.grown(MARGIN)), "".join(_groups(parts, ink))
    return Shown(key_of(figure), figure.title.plain, html(figure.title, ink.faces), frame, svg, steps, mu)


def box(rect: Rect) -> tuple[int, int, int, int]:
    """A rectangle in units of the page, y downwards."""
    return round(UNIT * rect.x0), round(-UNIT * rect.y1), round(UNIT * rect.width), round(UNIT * rect.height)


def _groups(parts: Sequence[tuple[str, list[Any]]], ink: Ink) -> Iterable[str]:
    """Layer by layer, and in each step by step;
    what differs between the languages stands in a group of its language."""
    tagged = sorted(
        ((item.layer, item.step, n, lang, item) for n, (lang, items) in enumerate(parts) for item in items),
        key=lambda t: t[:3],
    )
    for (layer, step), inside in groupby(tagged, key=lambda t: (t[0], t[1])):
        body = ""
        for lang, ones in groupby(inside, key=lambda t: t[3]):
            drawn = ink.svg(tuple(one[4] for one in ones))
            body += f'<g class="{lang}">{drawn}</g>' if lang else drawn
        yield f'<g data-step="{step}" data-layer="{layer.name.lower()}">{body}</g>'


def caption(figure: Figure, ink: Ink, over: Rect, size: float) -> tuple[str, Rect]:
    """Title and scale in both languages under a figure of these extents, in letters so much larger;
    and the extents with them."""
    body, low, middle = "", over.y0, over.centre.real
    for lang in LANGS:
        items: tuple[Item, ...] = caption_items(figure, over, lang)
        body += f'<g class="{lang}">{ink.svg(items[:1])}<g class="mu">{ink.svg(items[1:])}</g></g>'
        low = min(low, over.y0 - size * (over.y0 - Scene.of(items).extents.y0))
    shift = f"{round(UNIT * (1 - size) * middle)} {round(-UNIT * (1 - size) * over.y0)}"
    return f'<g transform="matrix({size:.3g} 0 0 {size:.3g} {shift})">{body}</g>', over | Rect(
        over.x0, low, over.x1, over.y1
    )
