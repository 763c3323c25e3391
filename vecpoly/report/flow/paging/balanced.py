"""Pages that hold little are evened out: sheets and plates stand elsewhere, the text is set a little tighter or opener,
as far as it needs no page more."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import Any

from ..base import Tightness
from ..blocks import Drawing, SheetPage
from ..doc import ReportDoc
from .loose import OPENEST, grown
from .placing import advanced, amid, placed, torn
from .setting import tightened

ENOUGH, LAST = 0.88, 0.8  # of a page of text, and of the last one of a report: what is filled so far lacks nothing
LEAST = 0.6  # of the last one: what is filled so far does
_INNER = 25  # times as much as the foot of the last page counts that of another
_OPENER = tuple(grown(OPENEST * n / 5) for n in range(1, 8))  # a page half empty is worth a wider setting
_CLOSER = (Tightness(white=0.8), Tightness(white=0.6), Tightness(white=0.5, lines=0.97, figures=0.85))
_SKETCHES = 1.25, 1.5  # times as large as it is the sketch beside the statement may be, where that fills a page
_BEST = 3  # places of sheets and plates that are tried with other settings too
_TORN = 0.03  # of the same: what a sheet counts that parts a step
_MUCH = 0.06  # of that: a larger sketch may help
_Story = Sequence[Any]
_Score = tuple[int, int, float, int, int]


def balanced(doc: ReportDoc, plain: _Story) -> ReportDoc:
    """The document, laid out; or the plain story, of which nothing is set otherwise yet, in the way that fills its
    pages best, where it needs no page more: its sheets and plates elsewhere, then set otherwise, then with a larger
    sketch."""
    if len(doc.filled) < 2 or _looks_full(doc):
        return doc
    stories = [*placed(plain, doc), *advanced(plain)]
    ways = sorted(((_score(laid), laid, story) for story, laid in _each(stories, doc)), key=lambda way: way[0])
    best = [story for _, _, story in ways[:_BEST]]
    found = _best(ways[0][1] if ways and ways[0][0] < _score(doc) else doc, _otherwise(best, doc, _OPENER, _CLOSER))
    sketched = _otherwise([larger for story in best for larger in _sketched(story)], doc, _OPENER[1::2])
    return _best(found, sketched) if emptiness(_filled(found)) > _MUCH else found


def _each(stories: Sequence[_Story], doc: ReportDoc) -> Iterator[tuple[_Story, ReportDoc]]:
    """Each of them laid out as it is."""
    for story in stories:
        laid = ReportDoc(tightened(story, Tightness()), doc.metadata)
        laid.counted()
        yield story, laid


def _best(doc: ReportDoc, ways: Iterator[ReportDoc]) -> ReportDoc:
    """The document, or the first of these that fills its pages, or else the best of all."""
    best, found = _score(doc), doc
    while not _looks_full(found) and (tried := next(ways, None)) is not None:
        score = _score(tried)
        if score < best:
            best, found = score, tried
    return found


def emptiness(filled: Sequence[float]) -> float:
    """What pages lack that hold too little, the emptier the more."""
    *others, last = filled
    return _INNER * sum(max(0.0, ENOUGH - full) ** 2 for full in others) + max(0.0, LAST - last) ** 2


def _filled(doc: ReportDoc) -> Sequence[float]:
    """How full its pages of text are: the last of them is none that ends a report where a sheet stands behind it."""
    return [*doc.filled, 1.0] if isinstance(doc.heads.get(doc.page), SheetPage) else doc.filled


def _looks_full(doc: ReportDoc) -> bool:
    *others, last = _filled(doc)
    return min(others) >= ENOUGH and last >= LEAST and not torn(doc)


def _score(doc: ReportDoc) -> _Score:
    empty = emptiness(_filled(doc)) + _TORN * torn(doc)
    return int(doc.page), len(doc.widows), round(empty, 3), doc.parted, amid(doc)


def _otherwise(stories: Sequence[_Story], doc: ReportDoc, *ways: Sequence[Tightness]) -> Iterator[ReportDoc]:
    """The stories laid out in these ways, each more and more so; nothing is set opener still once that needs a page
    more than the document has."""
    for story in stories:
        for degrees in ways:
            for degree in degrees:
                tried = ReportDoc(tightened(story, degree), doc.metadata)
                tried.counted()
                yield tried
                if degrees is not _CLOSER and tried.page > doc.page:
                    break


def _sketched(plain: _Story) -> Iterator[_Story]:
    """The story with a larger sketch beside its statement."""
    for times in _SKETCHES:
        larger = [_larger(item, times) for item in plain]
        if any(new is not old for new, old in zip(larger, plain, strict=True)):
            yield larger


def _larger(item: Any, times: float) -> Any:
    """A sketch so many times as large as it is, or as far as its column allows; anything else as it is."""
    made = item.ampler(times) if isinstance(item, Drawing) and item.ampler is not None else None
    return item if made is None else made
