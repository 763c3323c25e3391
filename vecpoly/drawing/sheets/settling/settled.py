"""The figures of a page where they cost a reader least, of all ways in which they can stand on it."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from operator import itemgetter

from ..packing import Layout, layouts
from ..pages import covered, pairs_of
from ..paging import WELL, Drawn, even, lined, standing
from .cost import APART, standing_cost
from .white import inked, white

WORTH = 0.024  # of a page, by which another arrangement must be better
WHITE = 0.7  # what a page counts that is white in one piece
GOOD = 0.12  # cost at which no other is looked for
MANY = 10  # figures, of which there are too many ways


def settled(group: Sequence[Drawn], layout: Layout) -> Layout:
    """The layout with titles side by side on one line and even margins; or another of the same page that is better."""
    as_it_is = even(group, lined(group, layout))
    if not 1 < len(group) <= MANY:
        return as_it_is
    ink = [inked((one.scene for one in (main, *main.details)), main.extents) for main in group]

    def whole(looks: float, made: Layout) -> float:
        return looks + WHITE * white([some + at for some, at in zip(ink, made.corners, strict=True)], made.page)

    best, least = as_it_is, whole(_looks(group, as_it_is), as_it_is) - WORTH
    if least + WORTH < GOOD - APART * len(pairs_of(group)):
        return as_it_is
    for looks, made in sorted(((_looks(group, made), made) for made in _ways(group, layout)), key=itemgetter(0)):
        if looks >= least:
            break
        if (cost := whole(looks, made)) < least:
            best, least = made, cost
    return best


def _looks(group: Sequence[Drawn], layout: Layout) -> float:
    return standing_cost(*standing(group, layout), layout)


def _ways(group: Sequence[Drawn], layout: Layout) -> Iterator[Layout]:
    """Every arrangement, with titles on one line or with each figure in the middle of its place; none that is lost on
    the page."""
    enough = min(WELL, covered(group, layout))
    for made in layouts([one.size for one in group], layout.page, pairs_of(group)):
        for placed in dict.fromkeys((lined(group, made), made)):
            if covered(group, found := even(group, placed)) >= enough:
                yield found
