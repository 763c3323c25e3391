"""A text that leaves a good part of its pages empty is set more openly, as far as it needs no page more."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from ..base import Tightness
from ..doc import ReportDoc
from .setting import faults_of, tightened

ENOUGH = 0.9  # of its pages: what is filled so far looks full
OPENEST = 0.25  # by which share a text may grow: white and figures by so much
TRIED = (0.85, 0.45)  # of the room that is left: no page fills to its last line


def loosened(story: Sequence[Any], doc: ReportDoc) -> ReportDoc:
    """The story as open as its pages allow, laid out; doc: it, as it was."""
    filled = sum(doc.filled)
    if not filled or min(doc.filled) >= ENOUGH:
        return doc
    for share in TRIED:
        opener = tightened(story, grown(min(OPENEST, share * (len(doc.filled) / filled - 1))))
        tried = ReportDoc(opener, doc.metadata)
        if tried.counted() <= doc.page and faults_of(tried) <= faults_of(doc):
            return tried
    return doc


def grown(share: float) -> Tightness:
    """So open that a text of the common kind takes up to this share more of room: white and figures grow alike, and
    with what is added at the foot of a page (`justified`) white is opened by 30 % at most."""
    return Tightness(white=1 + share, lines=1 + 0.3 * share, figures=1 + share)
