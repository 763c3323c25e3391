"""Polygons that are right but for how they lie: turned as a whole, in a mirror, or at another scale than was told."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping, Sequence
from dataclasses import dataclass

import numpy as np
from scipy.optimize import linear_sum_assignment

from ....foundation.slotted import replace
from ..expected import Shape
from ..segment import Segment
from .fit import Fit, fit_of
from .held import UPRIGHT, Held, one_turn
from .scale import LIKE, SAME_SCALE, SLACK, Vectors
from .tidy import Strokes

WHOLE, MOST, SEVERAL = 0.9, 0.6, 3  # of a polygon that must be found: nearly all, or most of it and several vectors
SEEDS = 3  # the longest vectors, one of which is surely found in a polygon that is right
MANY, FEW = 60, 30  # lines that hang together: more are no polygon, or none for which every mistake is tried
OF_MIRROR, OF_SCALE = 0.04, 0.02  # a turned polygon is preferred to a mirrored one, the told scale to another
FINELY, NEARLY = 0.3, 0.01  # of ways to hold it the finest; of a vector, at which half of that is lost


@dataclass(frozen=True, slots=True, kw_only=True)
class Lie:
    """How a part of the sheet is held to be this polygon, right or mistaken, and at which scale; share: of the polygon
    that is found; liked: how well it is found beside other ways."""

    share: float
    held: Held
    scale: float
    liked: float
    shape: Shape | None = None


def laid_askew(
    figures: Sequence[Sequence[Shape]],
    strokes: Strokes,
    found: Sequence[Fit],
    scales: Mapping[str, float],
    sheet: Held,
    doubtful: Collection[str],
) -> tuple[Fit, ...]:
    """Those of the doubtful figures that are right, or mistaken in a known way, once they are turned, mirrored, scaled.

    figures: of each what it should be, then as somebody draws it who makes a mistake. sheet: how the whole is held
    already; scales: as declared, mm of the sheet for a mm of the reference.
    """
    lines = [sheet.seen(one) for one in strokes.lines]
    sure = {n for fit in found if fit.shape.name not in doubtful for n in fit.numbers}
    members = [[n for n, part in enumerate(strokes.parts) if part == p] for p in sorted(set(strokes.parts))]
    heads = any(one.headed for one in lines)
    vectors = [part for part in members if not heads or any(lines[n].headed for n in part)]
    parts = [part for part in vectors if not sure.intersection(part)]
    wanted = [one for one in figures if one[0].name in doubtful and len(one[0].edges) > 1]
    if not parts or not wanted:
        return ()
    lies = [[_best([lines[n] for n in part], one, scales.get(one[0].name)) for one in wanted] for part in parts]
    liked = np.array([[lie.liked if lie is not None else 0.0 for lie in row] for row in lies])
    pairs = zip(*linear_sum_assignment(-liked), strict=True)
    return tuple(_fit(lines, parts[i], wanted[j][0], lie, scales) for i, j in pairs if (lie := lies[i][j]) is not None)


def taken_so(found: Sequence[Fit], laid: Sequence[Fit]) -> tuple[Fit, ...]:
    """The figures with some of them taken otherwise."""
    names, used = {fit.shape.name for fit in laid}, {n for fit in laid for n in fit.numbers}
    kept = (fit for fit in found if fit.shape.name not in names and not used.intersection(fit.numbers))
    return (*kept, *laid)


def _best(lines: Sequence[Segment], shapes: Sequence[Shape], told: float | None) -> Lie | None:
    """How these lines are the figure as it should be, or else as a mistake makes it."""
    right = lie_of(lines, shapes[0], told)
    if right is not None or len(lines) > FEW:
        return right
    mistaken = (lie_of(lines, shape, told, WHOLE) for shape in shapes[1:])
    return max((lie for lie in mistaken if lie is not None), key=lambda lie: lie.liked, default=None)


def lie_of(lines: Sequence[Segment], shape: Shape, told: float | None, least: float = MOST) -> Lie | None:
    """How these lines are the figure; None where too little of it is found however they are held."""
    ways = [lie for lie in _lies(lines, shape, told) if lie.share >= least] if len(lines) <= MANY else []
    best = max(ways, key=lambda lie: lie.liked, default=None)
    if best is None or (best.share < WHOLE and len(shape.edges) <= SEVERAL):
        return None
    return replace(best, shape=shape)


def _lies(lines: Sequence[Segment], shape: Shape, told: float | None) -> Iterator[Lie]:
    """By every line that may be one of the longest vectors, upright or in a mirror."""
    should = np.array([edge.along for edge in shape.edges])
    own = np.array([one.along for one in lines])
    either = np.array([not (one.headed and not shape.diagram) for one in lines])
    both = np.concatenate([own, -own[either]])
    longest = np.argsort(-np.abs(should), kind="stable")[:SEEDS]
    for mirror in (False, True):
        seen = -both.conj() if mirror else both
        for ratio in (seen[:, None] / should[longest][None, :]).ravel():
            for scale in (told or 1.0, None):
                if scale is None or abs(abs(ratio) / scale - 1) <= LIKE:
                    yield _lie(seen, should, complex(ratio), scale or float(abs(ratio)), mirror, told or 1.0)


def _lie(seen: Vectors, should: Vectors, ratio: complex, scale: float, mirror: bool, told: float) -> Lie:
    """What is found of the figure when the lines are turned back by this, and by what their turns have in common."""
    turn, size = ratio / abs(ratio), np.abs(should)
    nearest, there = _nearest(seen / turn / scale, should)
    if not there.any():
        return Lie(share=0.0, held=UPRIGHT, scale=scale, liked=0.0)
    back = seen[nearest[there]] / should[there] / turn / scale
    common = _middle(np.angle(back), size[there])
    off = np.abs(back * np.exp(-1j * common) - 1)
    share, finely = (float(much.sum() / size.sum()) for much in (size[there], size[there] / (1 + off / NEARLY)))
    other = OF_SCALE * (abs(scale / told - 1) > SAME_SCALE) + OF_MIRROR * mirror
    held = Held(turn=complex(np.exp(-1j * common)) / turn, mirror=mirror)
    return Lie(share=share, held=held, scale=scale, liked=share + FINELY * finely - other)


def _nearest(seen: Vectors, should: Vectors) -> tuple[np.ndarray, np.ndarray]:
    """Of each vector the line that is nearest to it, and whether it is the vector."""
    off = np.abs(seen[:, None] - should[None, :])
    nearest = off.argmin(axis=0)
    return nearest, off[nearest, np.arange(len(should))] <= LIKE * np.abs(should) + SLACK


def _middle(turns: np.ndarray, size: np.ndarray) -> float:
    """The median of the turns, by the lengths of the vectors: one that is drawn wrongly turns none of the others."""
    order = np.argsort(turns, kind="stable")
    reached = np.cumsum(size[order])
    return float(turns[order][np.searchsorted(reached, reached[-1] / 2)])


def _fit(lines: Sequence[Segment], part: Sequence[int], shape: Shape, lie: Lie, scales: Mapping[str, float]) -> Fit:
    """The polygon, as it is seen when it is held so."""
    told = scales.get(shape.name)
    upright = one_turn(lie.held, UPRIGHT)
    seen = list(lines) if upright else [lie.held.seen(one) for one in lines]
    as_told = told is not None and abs(lie.scale / told - 1) <= SAME_SCALE
    shapes = (shape,) if lie.shape in (None, shape) else (shape, lie.shape)
    fit = fit_of(seen, part, (), shapes, told if as_told and told else lie.scale, as_told)
    return replace(fit, held=UPRIGHT if upright else lie.held, told=None if as_told else told)
