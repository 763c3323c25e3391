"""The sketch beside a statement is drawn larger where its page would end early: what stands behind it is held together,
or a sheet, and cannot be pulled up."""

from __future__ import annotations

from ..blocks import Drawing, SheetPage
from ..doc import ReportDoc
from .setting import faults_of, reset

ROOM = 0.1  # of the first page: less white at its foot is no reason
_SHARES = (0.8, 0.5)  # of that white which the sketch takes
LARGEST, _LEAST = 1.5, 1.08  # times as large as it is, at most; less is not seen
_SAME = 0.005  # of a page: by so much the others may be filled otherwise


def ample(doc: ReportDoc) -> ReportDoc:
    """The document laid out with a larger sketch, where its first page leaves room and no other page changes; doc: it,
    as it was."""
    white = 1 - doc.filled[0] if doc.filled else 0.0
    at = next((n for n, item in enumerate(doc.story) if _opens(item)), None)
    if at is None or white < ROOM or not isinstance(old := doc.story[at], Drawing) or old.ampler is None:
        return doc
    for share in _SHARES:
        times = min(LARGEST, 1 + share * white * doc.column / old.wrap(0.0, 0.0)[1])
        larger = old.ampler(times) if times > _LEAST else None
        if larger is None or larger.size[1] < _LEAST * old.size[1]:
            continue
        tried = ReportDoc([*doc.story[:at], reset(larger, None), *doc.story[at + 1 :]], doc.metadata)
        if tried.counted() <= doc.page and faults_of(tried) <= faults_of(doc) and _alike(tried, doc):
            return tried
    return doc


def _opens(item: object) -> bool:
    """The first figure, or a sheet before it."""
    return isinstance(item, Drawing | SheetPage)


def _alike(one: ReportDoc, other: ReportDoc) -> bool:
    """Whether all pages but the first are filled as they were, and that one better."""
    pairs = list(zip(one.filled, other.filled, strict=False))
    rest = all(abs(new - old) < _SAME for new, old in pairs[1:])
    return len(one.filled) == len(other.filled) and rest and one.filled[0] > other.filled[0]
