"""The report document: A4, header, page n / N, bookmarks, embedded fonts only, the same bytes every time."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from io import BytesIO
from pathlib import Path
from typing import Any

from reportlab.platypus.doctemplate import NextPageTemplate, PageTemplate
from reportlab.platypus.flowables import PageBreak
from reportlab.platypus.frames import Frame

from ...foundation.files import write_whole
from ...foundation.slotted import dataclass
from ...tagging.canvas import TaggedCanvas
from ...tagging.metadata import Metadata as Metadata
from ...tagging.tree import FOOTER, artifact, tree_of
from ...typeset.box import MM
from ...typeset.canvas import Ink, lost
from ...typeset.fonts import Face, load
from ...typeset.words import layout_words
from ...words import bare
from .base import Block
from .contents import page_form, tell_contents
from .furniture import COLUMN, FOOT, MARGIN, SHEET_FOOT, SMALL, TOTAL, TextFrame, beside, foot, head
from .paging.floating import Floating, template_of
from .paging.together import HOLE, HeldTogether, led
from .style import BODY, GREY

LEFTOVER = 0.45  # of a page of text: less is what was left over, and may be saved
Stamp = Callable[[Any, bool], None]  # draws on the canvas of every page; whether that is a sheet


@dataclass(frozen=True, slots=True)
class Written:
    """A written document: where, how many pages, and the characters that no face had."""

    path: Path
    pages: int
    missing: tuple[str, ...]


class _Canvas(TaggedCanvas):
    """In our own face; the number of pages is a form filled in at the end."""

    def __init__(self, filename: str, **options: Any) -> None:
        load(Face.SONG)
        super().__init__(filename, font=Face.SONG.value, **options)

    def save(self) -> None:
        """Fill in the number of pages and those of the headings, then write."""
        for key, page in self.__dict__.get("_vecpoly_pages", {}).items():
            self._number(page_form(key), page)
        if self._doc.pageCounter > 1:
            ink = Ink(self)
            self.beginForm(TOTAL)
            ink.box(layout_words(str(self.getPageNumber() - 1), SMALL), 0.0, 0.0)
            self.setFillColorRGB(*GREY)
            ink.flush()
            self.endForm()
        super().save()

    def _number(self, form: str, page: int) -> None:
        """A form with a page number that ends at its origin."""
        ink, box = Ink(self), layout_words(str(page), BODY.em)
        self.beginForm(form, -60, -10, 1, 20)
        ink.box(box, -box.width * MM, 0.0)
        ink.flush()
        self.endForm()


class ReportDoc(Floating):
    """A report built from flowables; `write` makes the file in one move, or not at all."""

    def __init__(self, story: Sequence[Any], metadata: Metadata, stamp: Stamp | None = None) -> None:
        self.story, self.metadata, self._stamp = led(story), metadata, stamp
        self._level = -1
        self._pages, self._filled = 0, list[tuple[int, float]]()  # of each part: its pages, how full the last one is
        self._turned = self._counts = False  # whether the story asks for this turn; whether pages are only counted
        tell_contents(self.story)
        lang = "zh-CN" if metadata.lang == "zh" else "en-GB"
        super().__init__(
            "", pagesize=self._size(), leftMargin=MARGIN, rightMargin=MARGIN, topMargin=MARGIN, bottomMargin=MARGIN,
            title=bare(metadata.title), author=metadata.author, subject=bare(metadata.subject or metadata.title),
            creator=metadata.creator, producer="vecpoly", keywords=list(metadata.words), lang=lang,
            invariant=1, pageCompression=1, keepTogetherClass=HeldTogether,
            displayDocTitle=True, pageTemplates=self._templates(),
        )  # fmt: skip

    def _size(self, *, across: bool = False) -> tuple[float, float]:
        """Width and height of a page, in points."""
        width, height = self.metadata.format.turned(across)
        return width * MM, height * MM

    def _templates(self) -> list[PageTemplate]:
        upright, across = self._size(), self._size(across=True)
        width, height = upright
        text = TextFrame(beside(width), MARGIN, COLUMN, height - 2 * MARGIN, 0, 0, 0, 0, id="text")
        zero = {"leftPadding": 0, "rightPadding": 0, "topPadding": 0, "bottomPadding": 0}
        sheets = [
            PageTemplate(
                name, [Frame(0, 0, *size, **zero)], onPage=self._foot, onPageEnd=self._stamp_sheet, pagesize=size
            )
            for name, size in (("portrait", upright), ("landscape", across))
        ]
        sheets.append(
            PageTemplate("cover", [Frame(0, 0, *upright, **zero)], onPage=self._cover, onPageEnd=self._stamp_sheet)
        )
        words = PageTemplate("text", [text], onPage=self._furniture, onPageEnd=self._stamp_text, pagesize=upright)
        return [words, *sheets]

    def _furniture(self, canvas: Any, _: Any) -> None:
        """Running header and footer; the first page has the title itself."""
        if not self._counts:
            head(canvas, self.metadata.title if canvas.getPageNumber() > 1 else "")
            foot(canvas, FOOT, self.metadata.identity)

    def _foot(self, canvas: Any, _: Any) -> None:
        """What stands under the frame of a sheet."""
        if not self._counts:
            foot(canvas, SHEET_FOOT, self.metadata.identity)

    def _cover(self, canvas: Any, _: Any) -> None:
        """A page without a number."""
        if not self._counts:
            foot(canvas, FOOT, self.metadata.identity, numbered=False)

    def _stamp_text(self, canvas: Any, _: Any) -> None:
        """Over all else of a page of text."""
        self._pages += 1
        if self._turned:
            self._filled.append((self._pages, 1 - (self.frame._y - self.frame._y1p) / self.frame._aH))
            self._pages = 0
        self._stamped(canvas, False)

    def _stamp_sheet(self, canvas: Any, _: Any) -> None:
        """Over all else of a drawing sheet."""
        self._stamped(canvas, True)

    def _stamped(self, canvas: Any, sheet: bool) -> None:
        if self._stamp is not None:
            with artifact(canvas, FOOTER):
                self._stamp(canvas, sheet)

    def beforeDocument(self) -> None:
        """The canvas learns which places there are."""
        goals = (getattr(item, "goal", "") for item in self.story)
        tree_of(self.canv).goals = frozenset(goal for goal in goals if goal)

    def afterFlowable(self, flowable: Any) -> None:
        """Bookmark headings and sheets."""
        outline = getattr(flowable, "outline", "")
        if not outline:
            return
        key = flowable.bookmark
        level = min(flowable.level - 1, self._level + 1)
        self._level = level
        self.canv.bookmarkPage(key)
        self.canv.__dict__.setdefault("_vecpoly_pages", {})[key] = self.canv.getPageNumber()
        self.canv.addOutlineEntry(outline, key, level, closed=0)

    def write(self, path: str | Path) -> Written:
        """Write the document, whole or not at all."""
        data, pages, lost_characters = self.made()
        return Written(write_whole(Path(path), data), pages, lost_characters)

    def handle_pageBreak(self, slow: Any = None) -> None:
        """Here, and at the end, the story asks for the turn; elsewhere a page is full."""
        self._turned = True
        super().handle_pageBreak(slow)
        self._turned = False

    @property
    def leftover(self) -> dict[int, int]:
        """The parts whose last page was turned for a few lines, or a table, and how many pages they have."""
        return {part: pages for part, (pages, full) in enumerate(self._filled) if pages > 1 and full < LEFTOVER}

    @property
    def ends(self) -> tuple[tuple[int, float], ...]:
        """Of each part: its pages of text, and how full the last one is."""
        return tuple(self._filled)

    @property
    def gaps(self) -> int:
        """How many pages of text end early, for a block that goes to the next one as a whole."""
        return sum(full < 1 - HOLE for full in self.filled) - sum(full < 1 - HOLE for _, full in self.ends)

    def made(self) -> tuple[bytes, int, tuple[str, ...]]:
        """The document as bytes, how many pages it has, and the characters that no font has."""
        self.drawn()
        return self.finished(), self.page, tuple(lost(self.canv))

    def drawn(self) -> None:
        """Every page is drawn, and not yet written: it may be that others are written in their place."""
        self._set(_expanded(self.story))

    def finished(self) -> bytes:
        """What was drawn, as the bytes of a file."""
        self.canv.save()
        return bytes(self.canv._filename.getvalue())

    def counted(self) -> int:
        """How many pages it has: every block finds its place, and none is drawn."""
        story = [item.undrawn() if isinstance(item, Block) else item for item in _expanded(self.story)]
        self._counts = True
        self._set(story)
        self._counts = False
        return int(self.page)

    def _set(self, story: list[Any]) -> None:
        self._level, self._pages, self._filled = -1, 0, []
        self._firstPageTemplateIndex = _first(self.story)
        self._doSave = 0
        self.build(self.float(story), filename=BytesIO(), canvasmaker=_Canvas)


def _expanded(story: Sequence[Any]) -> list[Any]:
    """The story with page turns around its sheets, none doubled, none at either end."""
    out: list[Any] = []
    template = "text"
    for item in story:
        if isinstance(item, PageBreak):
            _turn(out, template)
            continue
        wanted = template_of(item)
        if wanted != "text" or wanted != template:
            _turn(out, wanted)
        template = wanted
        out.append(item)
    while out and isinstance(out[-1], (PageBreak, NextPageTemplate)):
        out.pop()
    return out


def _first(story: Sequence[Any]) -> int:
    """The template of the first page: text, or that of the sheet that stands there."""
    return ("text", "portrait", "landscape", "cover").index(template_of(next(iter(story), None)))


def _turn(out: list[Any], template: str) -> None:
    if out and isinstance(out[-1], PageBreak):
        out.pop()
        out.append(NextPageTemplate(template))
    elif not out:
        out.append(NextPageTemplate(template))
        return
    else:
        out.append(NextPageTemplate(template))
    out.append(PageBreak())
