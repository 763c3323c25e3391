"""Pages that hold little are evened out: the text is set a little tighter or opener, its sheets stand elsewhere, as far
as it needs no page more."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import Any

from ..base import Tightness
from ..blocks import Drawing, SheetPage
from ..doc import ReportDoc
from .loose import OPENEST, grown
from .sectioned import HALF, heads, settled
from .setting import tightened

ENOUGH, LAST = 0.88, 0.8  # of a page of text, and of the last one: what is filled so far looks full
LEAST = HALF  # of the last page too: one that holds less looks left over
_OPENER = tuple(grown(OPENEST * n / 5) for n in range(8))  # a page that would be half empty is worth a wider setting
_CLOSER = (Tightness(white=0.8), Tightness(white=0.6), Tightness(white=0.5, lines=0.97, figures=0.85))
_SKETCHES = 1.25, 1.5  # times as large as it is the sketch beside the statement may be, where that fills a page
_THIN = 3  # where in a score those pages stand that hold too little
_Score = tuple[int, int, int, int, float, int]


def balanced(doc: ReportDoc, plain: Sequence[Any]) -> ReportDoc:
    """The document, laid out; or the plain story, of which nothing is set otherwise yet, in the first way that fills
    its pages, or else in the best, where it needs no page more."""
    if len(doc.filled) < 2:
        return doc
    found = _best(doc, (tried for placed in _placed(plain) for tried in _laid(placed, doc, _OPENER, _CLOSER)))
    sketched = (tried for larger in _sketched(plain) for tried in _laid(larger, doc, _OPENER[::2]))
    return _best(found, sketched) if _score(found)[_THIN] else found


def _best(doc: ReportDoc, ways: Iterator[ReportDoc]) -> ReportDoc:
    """The document, or the first of these that fills its pages, or else the best of all."""
    best, found = _score(doc), doc
    while any(best[_THIN:]) and (tried := next(ways, None)) is not None:
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
    return int(doc.page), len(doc.widows), doc.parted, thin, round(emptiness(doc.filled), 4), doc.gaps


def _laid(story: Sequence[Any], doc: ReportDoc, *ways: Sequence[Tightness]) -> Iterator[ReportDoc]:
    """The story laid out in these ways, each more and more so; nothing is set opener still once that needs a page more
    than the document has."""
    for degrees in ways:
        for degree in degrees:
            tried = ReportDoc(tightened(story, degree), doc.metadata)
            tried.counted()
            yield tried
            if degrees is not _CLOSER and tried.page > doc.page:
                break


def _placed(plain: Sequence[Any]) -> Iterator[Sequence[Any]]:
    """The story, its sheets behind its text, then before each of its sections."""
    count = next((n for n, item in enumerate(reversed(plain)) if not isinstance(item, SheetPage)), 0)
    text, sheets = plain[: len(plain) - count], plain[len(plain) - count :]
    for at in (len(text), *(heads(text) if sheets else ())):
        yield [*text[:at], *map(settled, sheets), *text[at:]]


def _sketched(plain: Sequence[Any]) -> Iterator[Sequence[Any]]:
    """The story with a larger sketch beside its statement."""
    for times in _SKETCHES:
        larger = [_larger(item, times) for item in plain]
        if any(new is not old for new, old in zip(larger, plain, strict=True)):
            yield larger


def _larger(item: Any, times: float) -> Any:
    """A sketch so many times as large as it is, or as far as its column allows; anything else as it is."""
    made = item.ampler(times) if isinstance(item, Drawing) and item.ampler is not None else None
    return item if made is None else made
