"""Sheets that stand behind some pages of a text that goes on behind them, as plates are bound into a book."""

from __future__ import annotations

from collections.abc import Sequence
from copy import copy
from typing import Any

from reportlab.platypus.doctemplate import ActionFlowable, BaseDocTemplate, NextPageTemplate
from reportlab.platypus.flowables import PageBreak

from ..blocks import Callout, SheetPage


class Floating(BaseDocTemplate):  # type: ignore[misc]
    """A document whose text may turn its pages round a sheet: `SheetPage.behind` pages after where it was met."""

    _ahead: list[Any]  # what is still to be set
    _waiting: list[tuple[SheetPage, int]]
    filled: list[float]  # how full each page of text is
    heads: dict[int, Any]  # what each page opens with

    @property
    def widows(self) -> list[int]:
        """The pages behind the first that a box opens."""
        return [page for page, head in self.heads.items() if isinstance(head, Callout) and page > 1]

    def float(self, story: list[Any]) -> list[Any]:
        """The story, at the end of which no sheet is left waiting."""
        self._ahead, self._waiting, self.filled, self.heads = [], [], [], {}
        return [*story, _Rest()] if any(isinstance(item, SheetPage) and item.behind for item in story) else story

    def handle_flowable(self, flowables: list[Any]) -> None:
        """Put a sheet that floats aside."""
        if flowables is not self._hanging:
            self._ahead = flowables
        first = flowables[0]
        if isinstance(first, SheetPage) and first.behind:
            own = copy(flowables.pop(0))
            own.behind = 0
            self._waiting.append((own, first.behind))
        else:
            super().handle_flowable(flowables)
            if self._curPageFlowableCount:
                self.heads.setdefault(self.page, first)

    def handle_pageEnd(self) -> None:
        """After a page of text, the sheets that stand behind it."""
        if self.pageTemplate.id == "text":
            self.filled.append(1 - (self.frame._y - self.frame._y1p) / self.frame._aH)
        if self.pageTemplate.id == "text" and self._waiting:
            self._waiting = [(sheet, pages - 1) for sheet, pages in self._waiting]
            due = [sheet for sheet, pages in self._waiting if pages <= 0]
            self._waiting = [(sheet, pages) for sheet, pages in self._waiting if pages > 0]
            if due:
                NextPageTemplate(template_of(due[0])).apply(self)
                self._ahead[:0] = _between(due)[2:]
        super().handle_pageEnd()

    def rest(self) -> None:
        """All sheets that are still waiting, here."""
        due, self._waiting = [sheet for sheet, _ in self._waiting], []
        self._ahead[:0] = _between(due)[:-2]


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
