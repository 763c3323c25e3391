"""Scales made finer, of the smallest kind of figure first, as far as the sheets hold all."""

from __future__ import annotations

from ....board.paper.scales import coarser, finer
from ....board.place import Place
from .composition import Composing, Scales, by_place, usual

MOST = 1.5  # of the usual size: larger no figure is drawn to fill a sheet
ALONE = 1.6  # the same where sheets are one more, which hold fewer figures each


def grown(page: Composing, start: Scales, most: int = 0) -> Scales | None:
    """Finer scales, as far as they ask for no further sheet, or for no more than so many; None where a figure fits
    none. Where the smallest kind finds no room, larger ones give way to it."""
    scales, sheets = dict(start), max(most, page.needed(start))
    if sheets > max(most, len(page.figures)):
        return None
    growing, waiting = set(page.kinds), set[Place]()
    while growing:
        kind = min(sorted(growing, key=by_place), key=lambda one: page.legible(one, scales))
        if (trial := _larger(page, kind, scales, start, (sheets, most > 0 and page.moving))) is not None:
            scales, growing, waiting = trial, growing | waiting, set()
        else:
            growing.remove(kind)
            waiting.add(kind)  # it may find room once another has grown and stands elsewhere
    return scales


def _larger(page: Composing, kind: Place, scales: Scales, start: Scales, room: tuple[int, bool]) -> Scales | None:
    """With this kind one step larger, and others smaller for it if the smallest of all gain by that.

    room: how many sheets there are, and whether they are more than would do.
    """
    trial, (sheets, more) = scales | {kind: finer(scales[kind])}, room
    if page.size(kind, trial) > (ALONE * usual(kind) if more else MOST * page.wanted(kind)):
        return None
    if page.needed(trial) <= sheets:
        return trial
    before = page.legibles(scales)
    while page.needed(trial) > sheets:
        others = [one for one in page.kinds - {kind} if coarser(trial[one]) <= start[one] * (1 + 1e-9)]
        if not others:
            return None
        gives = max(sorted(others, key=by_place), key=lambda one: page.legible(one, trial))
        trial |= {gives: coarser(trial[gives])}
        if page.legibles(trial) <= before:
            return None
    return trial
