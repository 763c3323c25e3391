"""The scale of a figure: which may be tried, what the known vectors have it to be, how well the figure fits at it."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from ..expected import Shape
from ..segment import Segment

LIKE, SLACK = 0.07, 0.5  # of a vector's length, and mm: what counts as the same vector while a scale is sought
CLOSE, BETTER = 0.003, 0.3  # of a length: nearly exact; of a figure: how much more of it is so at another scale
NEARLY = 1.0  # mm: off by so much a vector is half as good as one that is exact
PARALLEL = 0.05  # rad
LONG = 15.0  # mm: by a shorter vector no scale is told
RATIOS = 40
SAME_SCALE = 0.005

Vectors = NDArray[np.complex128]


def ratios(own: Vectors, should: Vectors) -> list[float]:
    """1, and the ratios of lines that are parallel to a vector, the commonest first."""
    turn = np.abs(np.angle((own[:, None] / should[None, :]) ** 2)) / 2
    ratios = (np.abs(own)[:, None] / np.abs(should)[None, :])[turn < PARALLEL]
    if not ratios.size:
        return [1.0]
    alike = np.sum(np.abs(np.log(ratios[:, None] / ratios[None, :])) < LIKE, axis=1)
    kept = [1.0]
    for n in np.argsort(-alike, kind="stable"):
        if all(abs(np.log(ratios[n] / one)) > LIKE / 2 for one in kept) and len(kept) < RATIOS:
            kept.append(float(ratios[n]))
    return kept


def nearer(scale: float, other: float) -> bool:
    return bool(abs(np.log(scale)) < abs(np.log(other)))


def known(shape: Shape) -> list[complex]:
    """The vector that is laid off first, for what is laid off later may rest on what was drawn: the first long one,
    else the longest. None, where all are found by drawing."""
    given = [edge.along for edge in sorted(shape.edges, key=lambda edge: edge.act) if edge.given]
    first = next((one for one in given if abs(one) >= LONG), None) or max(given, key=abs, default=None)
    return [] if first is None else [first]


def refined(lines: Sequence[Segment], shapes: Sequence[Shape], scale: float) -> float:
    """The scale by the vector that is known; of a diagram by what most of its lines agree in."""
    own = np.array([one.along for one in lines])
    given = known(shapes[0]) or [edge.along for edge in shapes[0].edges]
    ratios = []
    for along in given:
        off = np.minimum(np.abs(own / scale - along), np.abs(own / scale + along))
        n = int(np.argmin(off))
        if off[n] <= LIKE * abs(along) + SLACK:
            ratios.append((abs(own[n]) / abs(along), abs(along)))
    if not shapes[0].diagram:
        return float(max(ratios, key=lambda pair: pair[1])[0]) if ratios else scale
    agree = [sum(size for other, size in ratios if abs(other / one - 1) < SAME_SCALE) for one, _ in ratios]
    return float(ratios[int(np.argmax(agree))][0]) if ratios else scale


def chosen(lines: Sequence[Segment], shape: Shape, found: float, measured: float) -> float:
    """The scale that is not stated: the problem's own, unless the figure is clearly better at what was measured."""
    if abs(measured - 1.0) < SAME_SCALE:
        return 1.0
    closely = {scale: _closely(lines, shape, scale) for scale in (1.0, measured)}
    return measured if found != 1.0 or closely[measured] > closely[1.0] + BETTER else 1.0


def _closely(lines: Sequence[Segment], shape: Shape, scale: float) -> float:
    """How much of the figure is drawn nearly exactly at this scale."""
    own, should = np.array([one.along for one in lines]) / scale, np.array([edge.along for edge in shape.edges])
    off = np.minimum(np.abs(own[:, None] - should), np.abs(own[:, None] + should)).min(axis=0)
    size = np.abs(should)
    return float(np.sum(size[off <= CLOSE * size + SLACK / 2]) / np.sum(size))


def nearly(lines: Sequence[Segment], shape: Shape, scale: float) -> float:
    """How well a figure is drawn at this scale, 0 to 1: what tells a figure from another that is nearly the same, or
    is the same but for the senses of its vectors.
    """
    own, should = np.array([one.along for one in lines]) / scale, np.array([edge.along for edge in shape.edges])
    against = np.array([NEARLY if one.headed and not shape.diagram else 0.0 for one in lines])[:, None]
    off = np.minimum(np.abs(own[:, None] - should), np.abs(own[:, None] + should) + against).min(axis=0)
    size = np.abs(should)
    return float(np.sum(size / (1 + (off / NEARLY) ** 2)) / np.sum(size))
