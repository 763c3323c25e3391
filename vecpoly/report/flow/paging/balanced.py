"""Pages that hold little are evened out: the text is set a little tighter or opener, its sheets stand elsewhere, as far
as it needs no page more."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import Any

from ..base import Tightness
from ..blocks import SheetPage
from ..doc import ReportDoc
from .loose import OPENEST, grown
from .sectioned import HALF, heads, settled
from .setting import tightened

ENOUGH, LAST = 0.88, 0.8  # of a page of text, and of the last one: what is filled so far looks full
LEAST = 0.3  # of the last page, which may be shorter than a page behind which the text goes on
_OPENER = tuple(grown(OPENEST * n / 5) for n in range(8))  # a page that would be half empty is worth a wider setting
_CLOSER = (Tightness(white=0.8), Tightness(white=0.6), Tightness(white=0.5, lines=0.97, figures=0.85))
_Score = tuple[int, int, int, int, int, float]


def balanced(doc: ReportDoc, plain: Sequence[Any]) -> ReportDoc:
    """The document, laid out; or the plain story, of which nothing is set otherwise yet, in the first way that fills
    its pages, or else in the best, where it needs no page more."""
    best, found = _score(doc), doc
    if len(doc.filled) < 2:
        return doc
    ways = (tried for placed in _placed(plain) for tried in _laid(placed, doc))
    while any(best[-2:]) and (tried := next(ways, None)) is not None:
        score = _score(tried)
        if score < best:
            best, found = score, tried
    return found


def emptiness(filled: Sequence[float]) -> float:
    """What pages lack that hold too little, the emptier the more."""
    *others, last = filled
    return sum(max(0.0, ENOUGH - full) ** 2 for full in others) + max(0.0, LAST - last) ** 2


def _score(doc: ReportDoc) -> _Score:
    *others, last = doc.filled
    thin = sum(full < HALF for full in others) + (last < LEAST)
    return int(doc.page), len(doc.widows), doc.parted, thin, doc.gaps, round(emptiness(doc.filled), 4)


def _placed(plain: Sequence[Any]) -> Iterator[Sequence[Any]]:
    """The story, its sheets behind its text, then before each of its sections."""
    count = next((n for n, item in enumerate(reversed(plain)) if not isinstance(item, SheetPage)), 0)
    text, sheets = plain[: len(plain) - count], plain[len(plain) - count :]
    for at in (len(text), *(heads(text) if sheets else ())):
        yield [*text[:at], *map(settled, sheets), *text[at:]]


def _laid(story: Sequence[Any], doc: ReportDoc) -> Iterator[ReportDoc]:
    """The story laid out opener and opener, as long as it needs no page more than the document, then closer."""
    for degrees in (_OPENER, _CLOSER):
        for degree in degrees:
            tried = ReportDoc(tightened(story, degree), doc.metadata)
            tried.counted()
            yield tried
            if degrees is _OPENER and tried.page > doc.page:
                break
