"""Two solutions that crowd each other in one figure are drawn in a figure each, on what both have in common."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import pairwise
from math import inf

from ..board.construction import Figure
from ..board.paper.extent import extent
from ..board.paper.marks import Dot, Mark, Point, Role, Segment
from ..foundation.slotted import replace
from ..words import Words

NEAR, FEW = 0.12, 2  # of the figure's size: so near, letters of two solutions crowd; so many pairs may
OF = "solution {}"  # the name of the figure of a further solution


def parted(figures: Sequence[Figure]) -> tuple[Figure, ...]:
    """The figures, each of whose solutions crowd as one figure for each of them, before whatever is drawn of it."""
    made = list(figures)
    for figure in figures:
        if len(figure.parts) > 1 and _crowds(figure):
            first, *others = _each(figure)
            made[made.index(figure)] = first
            for (step, _), one in zip(figure.parts[1:], others, strict=True):
                made.insert(_before(made, step), one)
    return tuple(made)


def _each(figure: Figure) -> Iterator[Figure]:
    for (step, n), marks in zip(figure.parts, _alone(figure), strict=True):
        title, first = figure.title + Words(f"（解 {n}）", f" (solution {n})"), step == figure.parts[0][0]
        yield replace(figure, title=title, marks=marks, name=figure.name if first else OF.format(n), parts=())


def _alone(figure: Figure) -> list[tuple[Mark, ...]]:
    """What stands in the figure of each solution; the links of each are thick in its own."""
    common = [mark for mark in figure.marks if mark.step < figure.parts[0][0]]
    return [(*common, *map(_thick, own)) for own in _own(figure)]


def _own(figure: Figure) -> list[list[Mark]]:
    """What is drawn of each solution alone."""
    ends = (*(step for step, _ in figure.parts), inf)
    return [[mark for mark in figure.marks if start <= mark.step < end] for start, end in pairwise(ends)]


def _thick(mark: Mark) -> Mark:
    return replace(mark, role=Role.LINK) if isinstance(mark, Segment) and mark.role is Role.SECOND else mark


def _crowds(figure: Figure) -> bool:
    """Whether letters of two solutions stand close together."""
    near = NEAR * max(extent(figure.marks))
    spots = [[mark.at for mark in own if isinstance(mark, Point) and mark.dot is not Dot.NONE] for own in _own(figure)]
    pairs = ((a, b) for n, some in enumerate(spots) for others in spots[n + 1 :] for a in some for b in others)
    return sum(abs(a - b) < near for a, b in pairs) > FEW


def _before(figures: Sequence[Figure], step: int) -> int:
    """Where what begins with a step stands: before the first figure that was begun after that."""
    later = (n for n, other in enumerate(figures) if min(mark.step for mark in other.marks) >= step)
    return next(later, len(figures))
