"""Figures drawn for their sheets, with their details beside them or without."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from ...board.construction import Figure
from ...foundation.slotted import replace
from ...words import Lang
from ..details.apart import all_detailed, shown
from ..details.knots import MOST
from ..details.room import Grow
from ..figure import draw_figure
from .nested import nested
from .paging import Drawn

Whole = tuple[Drawn, ...]


def drawn(figures: Sequence[Figure], lang: Lang) -> Whole:
    """The figures alone."""
    return tuple(Drawn(f.view, f.name, draw_figure(f, lang=lang), figure=f) for f in figures)


def arrangements(
    figures: Sequence[Figure], lang: Lang, most: int = MOST, mains: Whole | None = None
) -> Iterator[Whole]:
    """The figures with so many details each at most, arranged so that each grows little, or rather in width, or in
    height; as they are, once, where they have none. mains: what the figures themselves are taken for."""
    apart = _apart(figures, lang, most, mains)
    if all(len(one) == 1 for one in apart):
        yield tuple(one for (one,) in apart)
        return
    placed = [_beside(made, figure) for made, figure in zip(apart, figures, strict=True)]
    for grow in Grow:
        yield tuple(one[grow] for one in placed)


def loose(figures: Sequence[Figure], lang: Lang, mains: Whole | None = None) -> Whole:
    """The figures with all their details, each of which has a place of its own after its figure."""
    return tuple(one for made in _apart(figures, lang, MOST, mains) for one in made)


def _apart(figures: Sequence[Figure], lang: Lang, most: int, mains: Whole | None) -> list[Whole]:
    """Each figure with its details; not drawn itself where it is taken for another."""
    apart = all_detailed(figures, most)
    if mains is None:
        return [drawn(one, lang) for one in apart]
    return [(main, *drawn(one[1:], lang)) for main, one in zip(mains, apart, strict=True)]


def _beside(made: Whole, figure: Figure) -> dict[Grow, Drawn]:
    """A figure and its details in their places, in whichever direction it may grow."""
    main, *details = made
    if not details:
        return dict.fromkeys(Grow, main)
    pairs = [(one.scene, knot.centre) for one, knot in zip(details, shown(figure, len(details)), strict=True)]
    return {grow: replace(main, details=_moved(details, ways)) for grow, ways in nested(main.scene, pairs).items()}


def _moved(details: Sequence[Drawn], ways: Sequence[complex]) -> Whole:
    return tuple(replace(one, scene=one.scene.moved(by), by=by) for one, by in zip(details, ways, strict=True))
