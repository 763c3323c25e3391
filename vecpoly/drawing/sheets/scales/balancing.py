"""Scales of a mechanism and its polygons of motion balanced against each other on their sheet: the mechanism over more
than half of the width, no figure small beside another."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import product
from math import log
from operator import itemgetter

from ....board.construction import View
from ....board.paper.scales import coarser, finer
from ....board.place import Place
from .composition import LOST, Composing, Scales, by_place

WIDE, LOW = 105.0, 75.0  # mm: of a mechanism, more than half of the frame; of a polygon
EVEN = 1.5  # times as large as the mechanism a polygon is at most, or as small
SHORT = 8.0  # mm: a shorter vector is hard to read
MOTION = frozenset((View.MECHANISM, View.VELOCITY, View.ACCELERATION))
GAIN = 0.1  # for which scales are changed at all
GROWS = 1.1  # times as large the mechanism is then, or the smallest figure: none is made smaller for nothing
_SMALL, _LOW, _SHORT, _LARGE = 2.0, 0.6, 0.6, -0.2  # what weighs a mechanism too small, a low polygon, a short vector
_STEPS = {True: (4, 1), False: (2, 4)}  # finer and coarser: of the mechanism, of a polygon

Trial = tuple[Place, float, float, float]  # a kind at a scale, how large it is (mm), what of it is bad by itself


def balanced(pages: Sequence[Composing], best: Scales) -> Scales:
    """The scales, for one sheet as before, at which the figures are most even; as they are where a mechanism has no
    polygons of motion alone beside it, or where little would be gained."""
    page = pages[0]
    if not MOTION >= page.kinds > {View.MECHANISM} or min(one.needed(best) for one in pages) > 1:
        return best
    share, room = min(LOST, *(one.share(best) for one in pages)), min(1.0, page.roomy(best))
    for trial in _better(page, best):
        if page.roomy(trial) >= room and any(one.needed(trial) == 1 and one.share(trial) >= share for one in pages):
            return trial
    return best


def _better(page: Composing, best: Scales) -> Iterator[Scales]:
    """Scales that are more even, the most even first."""
    kinds = sorted(page.kinds, key=by_place)
    steps = [[_trial(page, kind, scale) for scale in _near(best[kind], kind)] for kind in kinds]
    now = [some[0] for some in steps]
    worst = _uneven(now) - GAIN
    made = [(bad, trial) for trial in product(*steps) if (bad := _uneven(trial)) < worst and _grows(trial, now)]
    for _, trial in sorted(made, key=itemgetter(0)):
        yield best | {kind: scale for kind, scale, _, _ in trial}


def _near(scale: float, kind: Place) -> Iterator[float]:
    """A scale, then those a few steps finer and coarser."""
    yield scale
    for way, count in zip((finer, coarser), _STEPS[kind is View.MECHANISM], strict=True):
        at = scale
        for _ in range(count):
            yield (at := way(at))


def _trial(page: Composing, kind: Place, scale: float) -> Trial:
    size = page.size(kind, {kind: scale})
    if kind is View.MECHANISM:
        return kind, scale, size, _SMALL * _lacks(size, WIDE) + _LARGE * log(size)
    vectors = (one.scale / scale * one.short for one in page.figures if one.of == kind and one.short)
    bad = _LOW * _lacks(size, LOW) + _SHORT * _lacks(min(vectors, default=SHORT), SHORT)
    return kind, scale, size, bad + _LARGE * log(size)


def _lacks(size: float, enough: float) -> float:
    return max(0.0, log(enough / size))


def _uneven(trial: Sequence[Trial]) -> float:
    """The less, the more even figures are: what is bad of each, and how unlike the mechanism the polygons are."""
    mechanism = next(size for kind, _, size, _ in trial if kind is View.MECHANISM)
    unlike = sum(max(0.0, abs(log(size / mechanism)) - log(EVEN)) for _, _, size, _ in trial)
    return unlike + sum(bad for _, _, _, bad in trial)


def _grows(trial: Sequence[Trial], now: Sequence[Trial]) -> bool:
    """Whether the mechanism is larger, or the smallest figure of all."""
    grown = next(new[2] / old[2] for new, old in zip(trial, now, strict=True) if new[0] is View.MECHANISM)
    return grown > GROWS or min(one[2] for one in trial) > GROWS * min(one[2] for one in now)
