"""Sheets that stand behind some pages of a text that goes on behind them, as plates are bound into a book; figures that
open the next page where the text has no room for them."""

from __future__ import annotations

from collections.abc import Sequence
from copy import copy
from typing import Any

from reportlab.platypus.doctemplate import ActionFlowable, BaseDocTemplate, NextPageTemplate
from reportlab.platypus.flowables import PageBreak

from ..blocks import Callout, Divider, Drawing, Plate, SheetPage
from ..listing import Listing
from .justified import stretches
from .together import first_of

_ENDS = (NextPageTemplate, PageBreak, Divider)  # behind these no figure of what was before them stands


class Floating(BaseDocTemplate):  # type: ignore[misc]
    """A document whose text may turn its pages round a sheet, `SheetPage.behind` pages after where it was met; it runs
    on where a figure that floats has no room, which opens the next page."""

    _ahead: list[Any]  # what is still to be set
    _waiting: list[tuple[SheetPage, int]]
    _figures: list[Drawing]  # that the next page opens with
    filled: list[float]  # how full each page of text is
    white: list[float]  # what each has of white between its blocks, in points
    stretched: tuple[float, ...] = ()  # by how much it is opened on each
    heads: dict[int, Any]  # what each page opens with
    parted: int  # steps that a page break parts

    @property
    def column(self) -> float:
        """The height of the text of a page, in points."""
        return float(next(template.frames[0] for template in self.pageTemplates if template.id == "text")._aH)

    @property
    def widows(self) -> list[int]:
        """The pages behind the first that a box opens."""
        return [page for page, head in self.heads.items() if isinstance(head, Callout) and page > 1]

    def float(self, story: list[Any]) -> list[Any]:
        """The story, at the end of which nothing is left waiting."""
        self._ahead, self._waiting, self._figures, self.filled, self.heads = [], [], [], [], {}
        self.parted, self.white = 0, []
        return [*story, _Rest()] if any(_floats(item) for item in story) else story

    def handle_flowable(self, flowables: list[Any]) -> None:
        """Put what floats aside."""
        if flowables is self._hanging:
            super().handle_flowable(flowables)
            return
        self._ahead = flowables
        self._set_figures(flowables)
        first = flowables[0]
        if isinstance(first, SheetPage) and first.behind:
            own = copy(flowables.pop(0))
            own.behind = 0
            self._waiting.append((own, first.behind))
        elif isinstance(first, Drawing) and first.floats and self._waits(flowables, first):
            self._figures.append(flowables.pop(0))
        elif isinstance(first, Divider) and self._opens:
            del flowables[0]
        else:
            if self._curPageFlowableCount:  # put off already, it may be so again by a figure that opened this page
                first.__dict__.pop("_postponed", None)
            super().handle_flowable(flowables)
            if self._curPageFlowableCount:
                self.heads.setdefault(self.page, first_of(first))

    @property
    def _opens(self) -> bool:
        """Whether nothing stands on this page of text."""
        return bool(self.pageTemplate.id == "text" and self._curPageFlowableCount == 0)

    def _set_figures(self, flowables: list[Any]) -> None:
        """The figures that wait, at the head of a page and before what must not overtake them."""
        ends = isinstance(flowables[0], _ENDS) and self.pageTemplate.id == "text"
        if self._figures and (self._opens or ends):
            due, self._figures = self._figures, []
            flowables[:0] = [_settled(one) for one in due] if ends else due

    def _waits(self, flowables: list[Any], figure: Drawing) -> bool:
        """Whether the page has no room for it, nor would have if it were a little smaller."""
        if self._opens:
            return False
        found = figure.fitted(self.frame._y - self.frame._y1p - figure.getSpaceBefore())
        if found is None or self._figures:
            return True
        flowables[0] = found
        return False

    def handle_pageBegin(self) -> None:
        """A page of text, with its white."""
        super().handle_pageBegin()
        if self.pageTemplate.id == "text":
            page = len(self.filled)
            self.frame.stretch = self.stretched[page] if page < len(self.stretched) else 1.0
            self.frame.white = 0.0

    def justify(self) -> None:
        """Open the white of the pages that were counted as far as their feet."""
        self.stretched = stretches(self.filled, self.white, self.column)

    def handle_pageEnd(self) -> None:
        """After a page of text, the sheets that stand behind it."""
        if self.pageTemplate.id == "text":
            self.filled.append(1 - (self.frame._y - self.frame._y1p) / self.frame._aH)
            # a listing that goes on would be parted one line earlier, for it keeps the white before it free twice
            listed = bool(self._ahead) and isinstance(self._ahead[0], Listing)
            self.white.append(0.0 if listed else self.frame.white)
        if self.pageTemplate.id == "text" and self._waiting:
            self._waiting = [(sheet, pages - 1) for sheet, pages in self._waiting]
            due = [sheet for sheet, pages in self._waiting if pages <= 0 and not self._precedes(sheet)]
            self._waiting = [(sheet, pages) for sheet, pages in self._waiting if sheet not in due]
            if due:
                NextPageTemplate(template_of(due[0])).apply(self)
                self._ahead[:0] = _between(due)[2:]
        super().handle_pageEnd()

    def _precedes(self, sheet: SheetPage) -> bool:
        """Whether a plate is still to come that has a smaller number than this sheet."""
        return not sheet.led and any(isinstance(item, Plate) for item in (*self._figures, *self._ahead))

    def rest(self) -> None:
        """All figures and sheets that are still waiting, here."""
        figures, self._figures = self._figures, []
        due, self._waiting = [sheet for sheet, _ in self._waiting], []
        self._ahead[:0] = [*map(_settled, figures), *_between(due)[:-2]]


def _floats(item: Any) -> bool:
    return (isinstance(item, SheetPage) and item.behind > 0) or (isinstance(item, Drawing) and item.floats)


def _settled(figure: Drawing) -> Drawing:
    """The figure in its place."""
    own = copy(figure)
    own.floats = False
    return own


class _Rest(ActionFlowable):  # type: ignore[misc]
    """The end of the text."""

    def __init__(self) -> None:
        super().__init__(())

    def apply(self, doc: Floating) -> None:
        """Let no sheet wait longer."""
        doc.rest()


def _between(sheets: Sequence[SheetPage]) -> list[Any]:
    """Sheets with the turns of the page round them, text before and behind."""
    turned = [item for one in sheets for item in (NextPageTemplate(template_of(one)), PageBreak(), one)]
    return [*turned, NextPageTemplate("text"), PageBreak()] if sheets else []


def template_of(item: Any) -> str:
    """The page on which something of the story stands."""
    if not isinstance(item, SheetPage) or item.behind:
        return "text"
    if not item.numbered:
        return "cover"
    return "landscape" if item.wide else "portrait"
