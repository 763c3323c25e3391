"""Numbers of figures, tables and equations, and the captions with them."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field

from ...drawing.backends.pdf import draw_pdf
from ...drawing.scene import Item, Scene, TextBox
from ...tagging.speech import words_said
from ...typeset import layout_words
from ...typeset.box import MM
from ...words import Lang, Words
from ..content import Objects
from ..flow.blocks import Drawing
from ..flow.results.blocked import BlockTable
from ..flow.results.halved import even
from ..flow.style import CAPTION, CELL, Style
from ..flow.table import DataTable
from ..heads import united

_NOTHING = ("—", "")
_FIGURE, _TABLE = Words("图", "Figure"), Words("表", "Table")
SMALL = Style(size=8.8, leading=10.6, after=0.0, align="left")

_BOTH = Words("数值列于{}，曲线见{}。", "The values are listed in {}, and the curves are drawn in {}.")
_LISTED, _DRAWN = (
    Words("数值列于{}。", "The values are listed in {}."),
    Words("曲线见{}。", "The curves are drawn in {}."),
)
_GAP, _ROOM = 4.0, 170.0  # mm between two figures beside each other, and for both
_WHOLE, _WHITE = 20, 88.0  # rows of a table that rather leaves so much white (pt) than is parted
TINY = Style(size=8.5, leading=9.0, after=0.0, align="left")


@dataclass(frozen=True, slots=True)
class _Caption:
    """What stands with a figure or a table: Table 5-2. Extremes; called: Table 5-2."""

    called: str
    text: str


@dataclass(slots=True)
class Press:
    """Makes numbered figures and tables and keeps them for the template.
    chapter: the number of the chapter being made."""

    lang: Lang
    objects: Objects
    chapter: str = "1"
    _called: dict[str, tuple[str, ...]] = field(default_factory=dict)  # by the name for the template
    _counts: dict[tuple[str, str], int] = field(default_factory=dict)

    @property
    def called(self) -> dict[str, str]:
        """What each figure and table is called, by its name for the template: Table 5-2, Figures 5-1 and 5-2."""
        return {name: self.through(some) for name, some in self._called.items()}

    def number(self, kind: str) -> str:
        """The next number of a kind in this chapter: 3-2."""
        key = (self.chapter, kind)
        self._counts[key] = self._counts.get(key, 0) + 1
        return f"{self.chapter}-{self._counts[key]}"

    def figure(self, scene: Scene, title: Words) -> str:
        """A numbered figure; its name for the template."""
        caption = self._caption(_FIGURE, "figure", title)
        return self._kept("fig", drawn(scene, caption.text, sketch=True), caption)

    def figures(self, plots: Sequence[tuple[Scene, Words]]) -> list[str]:
        """Numbered figures, two beside each other where they are narrow enough; their names for the template. Where a
        page has no room for them the text runs on."""
        rows: list[list[tuple[Scene, _Caption]]] = []
        for scene, title in plots:
            caption = self._caption(_FIGURE, "figure", title)
            fits = rows and len(rows[-1]) == 1 and _wide(*rows[-1][0]) + _GAP + _wide(scene, caption) <= _ROOM
            rows[-1].append((scene, caption)) if fits else rows.append([(scene, caption)])
        made = [drawn(row[0][0], row[0][1].text) if len(row) == 1 else _paired(*row) for row in rows]
        for one in made:
            one.floats = True
        return [self._kept("fig", one, *(caption for _, caption in row)) for one, row in zip(made, rows, strict=True)]

    def sheet(self) -> Words:
        """The number of a sheet, which is a figure that fills its page: Figure 6-1."""
        number = Words.same(f" {self.number('figure')}")
        return _FIGURE + number

    def table(
        self, title: Words, header: Sequence[str], rows: Sequence[tuple[str, ...]], align: str, *, style: Style = CELL,
        blocks: int = 1,
    ) -> str:  # fmt: skip
        """A numbered table without columns of dashes, in so many blocks of all columns beside each other; its name for
        the template."""
        kept = told_columns(header, rows) if blocks == 1 else range(len(header))
        header, rows = united([header[i] for i in kept], [tuple(row[i] for i in kept) for row in rows])
        align = "".join(align[i] for i in kept)
        caption = self._caption(_TABLE, "table", title)
        made = even(BlockTable.of(header, rows, blocks, align, self.lang, caption=caption.text, style=style))
        made.undivided = _WHITE if len(made.rows) <= _WHOLE else 0.0
        return self._kept("tab", made, caption)

    def _kept(self, prefix: str, thing: object, *captions: _Caption) -> str:
        """Keep a thing with these captions; its name for the template."""
        name = self.objects.add(prefix, thing)
        self._called[name] = tuple(caption.called for caption in captions)
        return name

    def through(self, called: Sequence[str]) -> str:
        """What is numbered through: Figure 5-1, Figures 5-1 and 5-2, Figures 5-1 to 5-3."""
        first, last, two = called[0], called[-1], len(called) == 2
        if first == last:
            return first
        if self.lang == "zh":
            return f"{first}{'、' if two else '至'}{last}"
        kind, _, number = first.partition(" ")
        return f"{kind}s {number} {'and' if two else 'to'} {last.partition(' ')[2]}"

    def through_all(self, names: Sequence[str]) -> str:
        """What the things of these names are called together."""
        return self.through([one for name in names for one in self._called[name]])

    def shown(self, tables: Sequence[str], figures: Sequence[str]) -> str:
        """A sentence that says where values and curves of a section are found: in Table 5-2, in Figure 5-3."""
        listed = [self.through_all(some) if some else "" for some in (tables, figures)]
        told = _BOTH if all(listed) else _LISTED if listed[0] else _DRAWN
        return told.of(self.lang).format(*filter(None, listed)) if any(listed) else ""

    def tabled(self, title: Words, made: Sequence[DataTable], style: Style = CELL) -> list[str]:
        """The same of tables that are made already, if any; where there are two, the second is one of places."""
        titles = (title, title + Words("：点的位置", ": positions of points"))[: len(made)]
        return [
            self.table(one, each.header, each.rows, each.align, style=style)
            for one, each in zip(titles, made, strict=True)
        ]

    def _caption(self, what: Words, kind: str, title: Words) -> _Caption:
        called, gap = f"{what.of(self.lang)} {self.number(kind)}", "　" if self.lang == "zh" else ". "
        return _Caption(called, f"{called}{gap}{title.of(self.lang)}")


def told_columns(header: Sequence[str], rows: Sequence[Sequence[str]]) -> list[int]:
    """The columns in which something stands; of a table in two halves, parted by a blank one, all."""
    every = range(len(header))
    return [i for i in every if "" in header or not rows or any(row[i] not in _NOTHING for row in rows)]


def _wide(scene: Scene, caption: _Caption) -> float:
    """What a figure and its caption take."""
    return max(scene.extents.width, layout_words(caption.text, CAPTION.em).width)


def _paired(left: tuple[Scene, _Caption], right: tuple[Scene, _Caption]) -> Drawing:
    """Two captioned scenes beside each other, their captions in one line."""
    items: list[Item] = []
    x, foot = 0.0, -max(scene.extents.height for scene, _ in (left, right)) - 4.5
    for scene, caption in (left, right):
        e, box = scene.extents, layout_words(caption.text, CAPTION.em)
        room = _wide(scene, caption)
        items += scene.moved(complex(x + (room - e.width) / 2 - e.x0, -e.y1)).items
        items.append(TextBox(box=box, x=x + (room - box.width) / 2, y=foot))
        x += room + _GAP
    return drawn(Scene.of(tuple(items)), "", f"{left[1].text}; {right[1].text}")


def drawn(scene: Scene, caption: str, alt: str = "", *, sketch: bool = False) -> Drawing:
    """A scene as a captioned block of the text; sketch: one that may be a little smaller, or open the next page."""
    e = scene.extents
    return Drawing(
        e.width,
        e.height,
        lambda canvas, x, y: draw_pdf(scene, canvas, x - e.x0 * MM, y - e.y0 * MM),
        words_said(alt or caption, "zh" if any(char >= "\u2e80" for char in alt or caption) else "en"),
        caption,
        sketch=sketch,
    )
