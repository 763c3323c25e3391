"""Where each figure stands on a sheet, at which scale: every connected part of the drawing against every figure."""

from __future__ import annotations

from collections.abc import Collection, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from scipy.optimize import linear_sum_assignment

from ....foundation.slotted import replace
from ..expected import Shape
from ..segment import Segment
from .held import UPRIGHT, Held
from .naming import fits
from .scale import LIKE, SAME_SCALE, SLACK, Vectors, chosen, known, nearer, nearly, ratios, refined
from .tidy import Strokes

LEAST = 0.25  # of a figure's lines that must be found in a part
NAMED = 2.0
STRAYS, BESIDE = 1, 10.0  # lines that hang together, and mm from a figure, to which they may belong
FREE = 0.7  # of a score is for free vectors, the rest for those that lie where they should
OWN_SCALE = 0.03  # the scale of the problem is preferred to one's own
KNOWN = 0.5  # much more so where the known vector is drawn to it
BOTH = 0.1  # a mistake at one's own scale is told from what is right at another only by this
FINELY = 0.05  # of two figures that are nearly the same the one that is drawn more exactly
MISTAKEN = 0.05  # what is right is preferred to what a mistake makes of it


@dataclass(frozen=True, slots=True, kw_only=True)
class Fit:
    """A figure on the sheet: its lines in reference mm, about the figure's origin where that could be told.

    scale: mm of the sheet for a mm of the reference, as it is taken; measured: as the known vectors have it. share: of
    the figure's lines that were found as they should be. held: how this figure alone, beside the sheet, was held; told:
    the scale that was stated for it, where it is drawn at another.
    """

    shape: Shape
    lines: tuple[Segment, ...]
    numbers: tuple[int, ...]
    scale: float
    measured: float
    share: float
    origin: complex | None
    held: Held = UPRIGHT
    told: float | None = None


@dataclass(frozen=True, slots=True, kw_only=True)
class _Try:
    """One part at one scale as one figure."""

    score: float
    scale: float


def fitted(
    strokes: Strokes, figures: Sequence[Sequence[Shape]], scales: Mapping[str, float], *, held: Held = UPRIGHT
) -> list[Fit]:
    """The figures that are found, each with the lines that belong to it.

    figures: of each figure what it should be, first as it is right, then as somebody draws it who makes a mistake.
    scales: mm of the sheet for a mm of the reference, of the figures (by name) whose scale is declared.
    """
    lines = [held.seen(one) for one in strokes.lines]
    parts = [
        [n for n, part in enumerate(strokes.parts) if part == p] for p in range(max(strokes.parts, default=-1) + 1)
    ]
    if not parts or not figures:
        return []
    heads = any(one.headed for one in lines)
    tries = [
        [_best([lines[n] for n in part], shapes, scales.get(shapes[0].name), heads) for shapes in figures]
        for part in parts
    ]
    scores = np.array([[one.score for one in row] for row in tries])
    rows, columns = linear_sum_assignment(-np.where(scores >= LEAST, scores, 0.0))
    pairs = [(r, c) for r, c in zip(rows, columns, strict=True) if scores[r, c] >= LEAST]
    taken = {n for r, _ in pairs for n in parts[r]}
    loose = _strays(lines, strokes.parts, taken, [parts[r] for r, _ in pairs])
    return [
        fit_of(
            lines,
            parts[r],
            [n for n, home in loose.items() if home == m],
            figures[c],
            tries[r][c].scale,
            figures[c][0].name in scales,
        )
        for m, (r, c) in sorted(enumerate(pairs), key=lambda one: one[1][1])
    ]


def _strays(
    lines: Sequence[Segment], parts: Sequence[int], taken: Collection[int], homes: Sequence[Sequence[int]]
) -> dict[int, int]:
    """Single lines that hang on nothing: each with the number of the figure beside which it lies."""
    found = {}
    for n, one in enumerate(lines):
        if n not in taken and sum(part == parts[n] for part in parts) <= STRAYS and homes:
            gaps = [min(_gap(one, lines[m]) for m in home) for home in homes]
            if min(gaps) < BESIDE:
                found[n] = gaps.index(min(gaps))
    return found


def _gap(one: Segment, other: Segment) -> float:
    return min(abs(a - b) for a in (one.start, one.end) for b in (other.start, other.end))


def _best(lines: Sequence[Segment], shapes: Sequence[Shape], declared: float | None, heads: bool) -> _Try:
    """The best scale of this part as this figure, right or mistaken; heads: the drawing has some."""
    own = np.array([one.along for one in lines])
    bonus = _told(lines, shapes[0]) - (NAMED if heads and not _may_be(lines, shapes[0]) else 0.0)
    found = _Try(score=0.0, scale=declared or 1.0)
    own_scale = KNOWN if _is_drawn(own, known(shapes[0])) else OWN_SCALE
    for n, shape in enumerate(shapes):
        should = np.array([edge.along for edge in shape.edges])
        for scale in [declared] if declared else ratios(own, should):
            score = _share(lines, shape, own, should, scale, found.score)
            other = not declared and abs(scale - 1) > SAME_SCALE
            score -= MISTAKEN * bool(n) + (own_scale + BOTH * bool(n)) * other
            if score > found.score + 1e-6 or (score > found.score - 1e-6 and nearer(scale, found.scale)):
                found = _Try(score=score, scale=scale)
    if found.score:
        bonus += FINELY * nearly(lines, shapes[0], declared or refined(lines, shapes, found.scale))
    return _Try(score=found.score + bonus, scale=found.scale)


def _is_drawn(own: Vectors, known: Sequence[complex]) -> bool:
    """Whether the vector that is known before the polygon is drawn as the scale of the problem has it."""
    return any(np.min(np.abs(own - one)) <= LIKE * abs(one) for one in known)


def _may_be(lines: Sequence[Segment], shape: Shape) -> bool:
    """Whether lines may be this figure, by their heads: a diagram has none, a polygon of vectors some."""
    return shape.diagram or any(one.headed for one in lines)


def _told(lines: Sequence[Segment], shape: Shape) -> float:
    """What names and layers say for or against this figure."""
    names = [one.name.partition(":")[0] for one in lines if one.name]
    for_it = sum(name == shape.name for name in names) - sum(name != shape.name for name in names)
    layers = [fits(one.layer, shape.view) for one in lines]
    return NAMED * float(np.sign(for_it)) - (0.0 if all(layers) else NAMED)


def _share(lines: Sequence[Segment], shape: Shape, own: Vectors, should: Vectors, scale: float, least: float) -> float:
    """How much of the figure is found, as free vectors and where it belongs; 0 where it cannot be `least`."""
    size = np.abs(should)
    off = np.minimum(np.abs(own[:, None] / scale - should), np.abs(own[:, None] / scale + should))
    same = off <= LIKE * size + SLACK
    free = float(np.sum(size[same.any(axis=0)]) / np.sum(size))
    if free < max(least, LEAST):
        return 0.0  # what is placed is found first
    return FREE * free + (1 - FREE) * _placed(lines, shape, same, scale)[1] / float(np.sum(size))


def _placed(lines: Sequence[Segment], shape: Shape, same: Any, scale: float) -> tuple[complex | None, float]:
    """The origin for which most of the figure lies where it belongs, and how much (mm)."""
    a, b = (np.array([getattr(edge, end) for edge in shape.edges]) for end in "ab")
    votes = []
    for i, j in np.argwhere(same):
        start, end = lines[i].start / scale, lines[i].end / scale
        forth, back = abs((end - start) - (b[j] - a[j])), abs((end - start) + (b[j] - a[j]))
        votes.append(((start + end - a[j] - b[j]) / 2, abs(b[j] - a[j]), j, forth <= back))
    if not votes:
        return None, 0.0
    at, size, edge = (np.array([vote[n] for vote in votes]) for n in range(3))
    near = np.abs(at[:, None] - at[None, :]) < 1.0
    weights = [sum({int(j): w for j, w in zip(edge[row], size[row], strict=True)}.values()) for row in near]
    best = int(np.argmax(weights))
    return complex(np.average(at[near[best]], weights=size[near[best]])), float(weights[best])


def fit_of(
    lines: Sequence[Segment],
    part: Sequence[int],
    loose: Sequence[int],
    shapes: Sequence[Shape],
    found: float,
    declared: bool,
) -> Fit:
    """The figure in its own scale, with stray lines that may belong to it; found: the scale, about."""
    shape, inside = shapes[0], [lines[n] for n in part]
    measured = refined(inside, shapes, found)
    scale = found if declared else chosen(inside, shape, found, measured)
    own = np.array([one.along for one in inside])
    origin, share = None, 0.0
    for one in shapes:
        should = np.array([edge.along for edge in one.edges])
        off = np.minimum(np.abs(own[:, None] / scale - should), np.abs(own[:, None] / scale + should))
        place, much = _placed(inside, one, off <= LIKE * np.abs(should) + SLACK, scale)
        if much / np.sum(np.abs(should)) > share + 1e-6:
            origin, share = place, float(much / np.sum(np.abs(should)))
    own_too = [n for n in loose if fits(lines[n].layer, shape.view)]
    numbers = (*part, *own_too)
    shift = origin or 0j
    moved = tuple(_moved(lines[n], scale, shift) for n in numbers)
    return Fit(shape=shape, lines=moved, numbers=numbers, scale=scale, measured=measured, share=share, origin=origin)


def _moved(one: Segment, scale: float, shift: complex) -> Segment:
    return replace(one, start=one.start / scale - shift, end=one.end / scale - shift, sigma=one.sigma / scale)
