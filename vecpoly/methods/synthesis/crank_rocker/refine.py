"""Trial upon trial: where the lesser transmission angle is as given, or greatest, ever nearer."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping
from itertools import pairwise
from typing import Any

import numpy as np
import numpy.typing as npt

from ...roots import halved, top
from .track import Track

Curve = Callable[[Any], Any]  # of one place, or of an array of them

PLACES = 1440  # of A on its locus, tried in turn
REFINED = 100  # halvings, or golden sections
EQUAL = 1e-6  # rad: two angles at the best place


def meetings(track: Track, wanted: float) -> Iterator[float]:
    """Every place where the lesser angle is as wanted."""

    def off(t: Any) -> Any:
        return track.least(t) - wanted

    places = np.array([0.0, *_places()])
    tried = dict(zip(places.tolist(), off(places).tolist(), strict=True))
    for t in (*_edges(off, tried), *_turns(off, tried)):
        tried[t] = float(off(t))
    for low, high in pairwise(sorted(tried)):
        if tried[low] * tried[high] < 0:
            yield halved(off, low, high, REFINED)


def _edges(off: Curve, tried: Mapping[float, float]) -> list[float]:
    """How far towards a trial of no use, from its neighbour that is of use, A may go."""
    found = []
    for low, high in pairwise(tried):
        if np.isfinite(tried[low]) != np.isfinite(tried[high]):
            inside, outside = (low, high) if np.isfinite(tried[low]) else (high, low)
            for _ in range(REFINED):
                t = (inside + outside) / 2
                inside, outside = (t, outside) if np.isfinite(off(t)) else (inside, t)
            found.append(inside)
    return found


def _turns(off: Curve, tried: Mapping[float, float]) -> list[float]:
    """Where the curve turns back between its trials, which may be beyond the wanted angle."""
    tops, bottoms = (
        [(low, high) for low, t, high in _threes(tried) if way * tried[low] <= way * tried[t] >= way * tried[high]]
        for way in (1, -1)
    )
    return [top(off, *ends, REFINED) for ends in tops] + [top(lambda t: -off(t), *ends, REFINED) for ends in bottoms]


def _threes(places: Iterable[float]) -> Iterator[tuple[float, float, float]]:
    all_ = list(places)
    return zip(all_, all_[1:], all_[2:], strict=False)


def summit(track: Track) -> Iterator[float]:
    """The place where the lesser angle is greatest; none where it grows as far as the end of the locus.

    Either both angles are equal there, or the lesser one does not change from one trial to the next.
    """
    places = _places()
    tried = track.least(places)
    i = 0 if np.isnan(tried).all() else int(np.nanargmax(tried))
    if not 0 < i < len(places) - 1:
        return
    low, high = float(places[i - 1]), float(places[i + 1])
    t = top(track.least, low, high, REFINED)
    first, second = track.angles(t)
    if abs(first - second) < EQUAL:
        yield halved(lambda x: np.subtract(*track.angles(x)), low, high, REFINED)
        return
    lesser, step = (0 if first < second else 1), (high - low) / 10
    yield halved(lambda x: _change(lambda y: track.angles(y)[lesser], x, step), t - step, t + step, REFINED)


def _places() -> npt.NDArray[np.float64]:
    return np.linspace(0.0, 1.0, PLACES + 2)[1:-1]


def _change(of: Curve, at: float, step: float) -> float:
    """How the angle changes there, from two places on either side (fourth order)."""
    ahead, behind, far_ahead, far_behind = of(np.array([at + step, at - step, at + 2 * step, at - 2 * step]))
    return float(8 * (ahead - behind) - (far_ahead - far_behind))
