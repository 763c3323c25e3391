"""A page of text that would hold only a leftover is saved: its part of the story is set a little tighter.

A part is what stands between two turns of the page that the story itself asks for. Where the last page of the only one
holds little, it is tried with less white, then with closer lines and smaller sketches, as one sets it by hand; what
saves no page is left as it was.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from itertools import pairwise
from typing import Any

from reportlab.platypus.flowables import PageBreak

from ....foundation.slotted import replace
from ..base import Tightness
from ..blocks import Divider, SheetPage
from ..contents import Contents
from ..doc import LEFTOVER, Metadata, ReportDoc
from .ample import ample
from .balanced import balanced
from .loose import loosened
from .running import run_on, split
from .sectioned import sectioned
from .setting import faults_of, reset, tightened

DEGREES = (
    Tightness(white=0.85, figures=0.92),
    Tightness(white=0.7, figures=0.85),
    Tightness(white=0.6, figures=0.75),
    Tightness(white=0.55, lines=0.96, figures=0.72),
    Tightness(white=0.45, lines=0.93, figures=0.7),
)
SHARES = (1 / 3, 2 / 3)  # of the way from one degree to the next, the looser first
LARGE = 0.9  # of the size of a sketch, at least, where a long text is closed up: its letters shrink with it
FRONT = 2  # pages of contents and symbols, one of which may be saved
SHORT = 3  # pages of a part of which the lines are set closer too; in a longer one this would catch the eye


def saved(story: Sequence[Any], meta: Metadata) -> bytes:
    """The document, each part of it on as few pages as a tighter setting gives it, none of which holds little where
    something else can be set on it, and all that are nearly full end at their foot."""
    doc = settled(story, meta)
    doc.justify()
    return doc.made()[0]


def settled(story: Sequence[Any], meta: Metadata) -> ReportDoc:
    """The story as `saved` sets it, laid out; of one of many parts, which run on, none is set more tightly than
    another."""
    story = given = _set(story, {})
    plain = ReportDoc(story, meta)
    plain.counted()
    if len(plain.ends) > 1:
        return _closed_up(*run_on(*_fronted(story, plain)))
    tried = {part: _degree(story, part, pages, meta) for part, pages in plain.leftover.items()}
    chosen = {part: degree for part, degree in tried.items() if degree is not None}
    if chosen:
        story = _set(story, chosen)
        plain = ReportDoc(story, meta)
        plain.counted()
    return ample(balanced(loosened(*_mended(*sectioned(*run_on(story, plain)))), given))


def _fronted(story: list[Any], doc: ReportDoc) -> tuple[list[Any], ReportDoc]:
    """The story with its list of contents set closer, where what stands behind that goes overleaf for a few lines; and
    it laid out. doc: it, as it was."""
    first = next((text for text, _ in split(story) if text), [])
    pages = doc.leftover.get(0, 0)
    if pages != FRONT or not any(isinstance(item, Contents) for item in first):
        return story, doc
    for degree in DEGREES:
        found = _set(story, {0: degree})
        closer = ReportDoc(found, doc.metadata)
        closer.counted()
        if closer.ends[0][0] < pages:
            return found, closer
    return story, doc


def _closed_up(story: Sequence[Any], doc: ReportDoc) -> ReportDoc:
    """The story laid out with its last part set closer, where a few rows stand alone on its last page and that saves
    it; doc: it, as it was."""
    pages, full = doc.ends[-1]
    if full >= LEFTOVER or pages < 2:
        return doc
    start = (
        max((at for at, item in enumerate(story) if isinstance(item, PageBreak | SheetPage | Divider)), default=-1) + 1
    )
    for degree in (replace(one, figures=max(one.figures, LARGE)) for one in DEGREES):
        tried = ReportDoc([*story[:start], *tightened(story[start:], degree)], doc.metadata)
        if tried.counted() < doc.page:
            return tried
    return doc


def _mended(story: list[Any], doc: ReportDoc) -> tuple[Sequence[Any], ReportDoc]:
    """The story, tightened as little as will do where a box opens one of its pages or a step leaves a hole; and it
    laid out. doc: it, as it was."""
    faults, found, best = faults_of(doc), story, doc
    for degree in DEGREES:
        if not any(faults):
            break
        closer = tightened(story, degree)
        tried = ReportDoc(closer, doc.metadata)
        tried.counted()
        if faults_of(tried) < faults:
            faults, found, best = faults_of(tried), closer, tried
    return found, best


def _degree(story: Sequence[Any], part: int, pages: int, meta: Metadata) -> Tightness | None:
    """The least tightness with which a part of so many pages needs fewer."""
    items = [text for text, _ in split(story) if text][part]
    degrees = [Tightness(), *(one for one in DEGREES if pages <= SHORT or one.lines == 1.0)]

    def saves(one: Tightness) -> bool:
        return ReportDoc(tightened(items, one), meta).counted() < pages

    for looser, tighter in pairwise(degrees):
        if saves(tighter):
            return next((one for one in (looser.towards(tighter, share) for share in SHARES) if saves(one)), tighter)
    return None


def _set(story: Sequence[Any], chosen: Mapping[int, Tightness]) -> list[Any]:
    """The whole story, these parts of it tightened."""
    found, part = list[Any](), 0
    for text, behind in split(story):
        found += [*(reset(item, chosen.get(part)) for item in text), *behind]
        part += bool(text)
    return found
