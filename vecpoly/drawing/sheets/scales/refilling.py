"""Scales made finer once more where the sheets, details and legend laid, still have room: each figure takes the largest
scale of the series that its sheet holds."""

from __future__ import annotations

from collections.abc import Sequence
from math import inf

from ....board.construction import View
from ....board.paper.scales import finer
from ....board.place import Place
from ..space import LARGEST, PLATE
from .composition import Composing, Scales, by_place
from .growing import MOST

KEEPING = 1.25  # times as large as the smallest other figure one may grow


def refilled(pages: Sequence[tuple[Composing, Composing]], scales: Scales, kinds: set[Place]) -> Scales:
    """These scales of some kinds, as much finer as the sheets hold, the smallest kind first.

    pages: all figures on sheets that lie either way, as large as they turn out on the whole, with room for a legend;
    and as large as they are planned. Figures that are to stand on a plate in the text keep theirs.
    """
    sheets = min(max(one.needed(scales) for one in pair) for pair in pages)
    page, whole = next(pair for pair in pages if max(one.needed(scales) for one in pair) == sheets)
    plate = Composing(page.figures, page.kinds, (PLATE, LARGEST), page.clear)
    if plate.low(scales, LARGEST):
        return scales
    made, growing = dict(scales), set(kinds)
    while growing:
        kind = min(sorted(growing, key=by_place), key=lambda one: page.legible(one, made))
        trial = made | {kind: finer(made[kind])}
        if _in_keeping(page, kind, trial) and max(page.needed(trial), whole.needed(trial)) <= sheets:
            made = trial
        else:
            growing.remove(kind)
    return made


def _in_keeping(page: Composing, kind: Place, trial: Scales) -> bool:
    """Whether a kind is no larger than a hand would draw it, and makes no other look small beside it: a polygon may be
    as large as the mechanism, whatever the others are."""
    others = min((page.size(one, trial) for one in page.kinds if one != kind), default=inf)
    first = page.size(View.MECHANISM, trial) if View.MECHANISM in page.kinds - {kind} else 0.0
    return page.size(kind, trial) <= min(MOST * page.wanted(kind), max(KEEPING * others, first))
