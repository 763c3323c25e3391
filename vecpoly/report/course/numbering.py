"""Numbers of figures, tables and equations, and the captions with them."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field

from ...drawing.pdf import draw_pdf
from ...drawing.scene import Scene
from ...typeset.box import MM
from ...words import Lang, Words
from ..content import Objects
from ..flow.blocks import Drawing, spoken
from ..flow.style import CELL, Style
from ..flow.table import DataTable

_FIGURE, _TABLE = Words("图", "Figure"), Words("表", "Table")
SMALL = Style(size=8.3, leading=10.0, after=0.0, align="left")

TINY = Style(size=7.5, leading=9.6, after=0.0, align="left")


@dataclass(slots=True)
class Press:
    """Makes numbered figures and tables and keeps them for the template. chapter: the number of the chapter being made."""

    lang: Lang
    objects: Objects
    chapter: str = "1"
    _counts: dict[tuple[str, str], int] = field(default_factory=dict)

    def number(self, kind: str) -> str:
        """The next number of a kind in this chapter: 3-2."""
        key = (self.chapter, kind)
        self._counts[key] = self._counts.get(key, 0) + 1
        return f"{self.chapter}-{self._counts[key]}"

    def figure(self, scene: Scene, title: Words) -> str:
        """A numbered figure; its name for the template."""
        return self.objects.add("fig", drawn(scene, self._caption(_FIGURE, "figure", title)))

    def table(self, title: Words, header: Sequence[str], rows: Sequence[tuple[str, ...]], align: str, *, style: Style = CELL) -> str:
        """A numbered table; its name for the template."""
        caption = self._caption(_TABLE, "table", title)
        made = DataTable(header, rows, None, align, lang=self.lang, caption=caption, style=style)
        return self.objects.add("tab", made)

    def _caption(self, what: Words, kind: str, title: Words) -> str:
        gap = "　" if self.lang == "zh" else "  "
        return f"{what.of(self.lang)} {self.number(kind)}{gap}{title.of(self.lang)}"


def drawn(scene: Scene, caption: str) -> Drawing:
    """A scene as a captioned block of the text."""
    e = scene.extents
    return Drawing(e.width, e.height, lambda canvas, x, y: draw_pdf(scene, canvas, x - e.x0 * MM, y - e.y0 * MM), spoken(caption), caption)
