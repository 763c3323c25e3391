"""Free bodies, and parts of a mechanism drawn apart, larger where their page has white or their letters crowd."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Iterator, Sequence

from ....board.acts.inkless import is_reading
from ....board.apart import named_apart
from ....board.construction import Construction, Figure, Scale
from ....board.paper.scales import finer
from ....foundation.slotted import replace
from ....words import Lang
from ...details.larger import larger, may_be_larger
from ...figure import draw_figure, drawing
from ..packing import Layout, pack
from ..pages import CROWDED, Page, inked, pairs_of
from ..paging import Drawn
from ..space import is_page

MOST = 2.0  # times as large a figure is at most
SPARSE = 0.55  # of a page that the rectangles of its figures take, below which it has white to spare
ABOUT, MANY = 12.0, 5  # mm about a letter in which so many, itself included, are a crowd
SKETCHED = (2.0, 1.75, 1.5, 1.25)  # times that a sketch without a scale may be larger
GAIN = 1.2  # times as large at least, or it is left as it is


def enlarged(pages: Sequence[Page[Drawn]], lang: Lang, construction: Construction) -> Iterator[Page[Drawn]]:
    """The pages with the figures that may be larger, all of a page by one factor, as much larger as it holds them no
    worse; where it does not, or has no white to spare, with those alone whose letters crowd."""
    scales = [figure.scale for figure in construction.figures]
    read = {act.figure for act in construction.acts if is_reading(act)}
    for group, layout in pages:
        free = [n for n, one in enumerate(group) if is_page(layout.page) and _may_grow(one, read)]
        every = free if inked(group, layout) < SPARSE else []
        knotted = [n for n in free if _crowds(group[n], lang)]
        made = next(_grown((group, layout), (every, knotted), lang, scales), (group, layout))
        scales += [one.figure.scale for one in made[0] if one.figure is not None]
        yield made


def _may_grow(one: Drawn, read: Collection[str]) -> bool:
    figure = one.figure
    if figure is None or one.details:
        return False
    return may_be_larger(figure) and f"{one.view.name} {one.name}".strip() not in read


def _crowds(one: Drawn, lang: Lang) -> bool:
    """Whether so many letters stand about one of them."""
    assert one.figure is not None
    at = [label.centre for label in drawing(one.figure, lang=lang).labels]
    return any(sum(abs(z - w) <= ABOUT for w in at) >= MANY for z in at)


def _grown(
    page: Page[Drawn], some: Iterable[Sequence[int]], lang: Lang, scales: Collection[Scale]
) -> Iterator[Page[Drawn]]:
    """The page with these figures, or these, as much larger as it holds them."""
    group, layout = page
    for free in some:
        for made in _larger(group, free, lang, scales):
            found = pack([one.size for one in made], layout.page, tuple(pairs_of(made)))
            if found is not None and _as_well(found, layout):
                yield made, found


def _as_well(found: Layout, layout: Layout) -> bool:
    """Whether a layout is no worse than it was."""
    apart = found.together < layout.together or found.nested > layout.nested
    return not apart and found.white >= min(layout.white, CROWDED)


def _larger(
    group: tuple[Drawn, ...], free: Sequence[int], lang: Lang, scales: Collection[Scale]
) -> Iterator[tuple[Drawn, ...]]:
    """With these figures larger by one factor, the largest first."""
    first = group[free[0]].figure if free else None
    for factor in _factors(first) if first is not None else ():
        yield tuple(_drawn(one, factor, lang, scales) if n in free else one for n, one in enumerate(group))


def _factors(figure: Figure) -> Sequence[float]:
    """The factors to round scales, the largest first."""
    if not figure.scale.symbol:
        return SKETCHED
    found, scale = list[float](), finer(figure.scale.value)
    while figure.scale.value / scale <= MOST * (1 + 1e-9):
        found.append(figure.scale.value / scale)
        scale = finer(scale)
    return [factor for factor in reversed(found) if factor >= GAIN * (1 - 1e-9)]


def _drawn(one: Drawn, factor: float, lang: Lang, scales: Collection[Scale]) -> Drawn:
    """A figure so many times larger, by a scale that is named apart from others."""
    assert one.figure is not None
    made = larger(one.figure, factor)
    if made.scale.symbol:
        made = replace(made, scale=named_apart(made.scale, scales))
    return replace(one, scene=draw_figure(made, lang=lang), figure=made)
