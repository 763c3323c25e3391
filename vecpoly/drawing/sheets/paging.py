"""Which figures share a page: as few pages as will do, a free body with its polygon,
no small drawing alone on one of several."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Literal

from ...board.construction import Figure, View
from ..scene import Scene
from .packing import Layout, pack
from .space import room_inside

SPARSE = 0.25  # share of a page below which figures look lost on it
UPRIGHT = 4.0  # mm of white by which a landscape page must be better than a portrait one
CROWDED = 6.5  # mm of white below which a page is full to the brim
LONGEST = 12  # figures on a page


@dataclass(frozen=True, slots=True)
class Drawn:
    """A figure drawn, before it has a place: its view, its name, its scene."""

    view: View
    name: str
    scene: Scene

    @property
    def size(self) -> tuple[float, float]:
        """Width and height with lettering and title, mm."""
        return self.scene.extents.width, self.scene.extents.height


Way = Literal["portrait", "landscape"] | None
Page = tuple[tuple[Drawn, ...], Layout]
Cost = tuple[int, int, int, int, int]


def reading_order(figures: Sequence[Figure]) -> tuple[Figure, ...]:
    """The figures as they come, a force polygon after the free body of its name, to which it belongs."""
    first = {(f.view, f.name) for f in figures}
    ordered: list[Figure] = []
    for figure in figures:
        if (figure.view.beside, figure.name) not in first:
            ordered += [figure, *(f for f in figures if f.view.beside is figure.view and f.name == figure.name)]
    return tuple(ordered)


def paged(drawn: tuple[Drawn, ...], way: Way = None) -> list[Page] | None:
    """The figures in order on the best pages, all of them turned this way where one is wished;
    None where one fits no page."""
    best: list[tuple[Cost, list[Page]] | None] = [((0, 0, 0, 0, 0), [])]
    for end in range(1, len(drawn) + 1):
        options: list[tuple[Cost, list[Page]]] = []
        for start in range(max(0, end - LONGEST), end):
            before = best[start]
            layout = arranged(drawn[start:end], way) if before is not None else None
            if before is not None and layout is not None:
                cost = tuple(a + b for a, b in zip(before[0], _cost(drawn, start, end, layout), strict=True))
                options.append((cost, [*before[1], (drawn[start:end], layout)]))  # type: ignore[arg-type]
        # of equal costs the fullest first pages
        best.append(min(options, key=lambda o: (o[0], [-len(page) for page, _ in o[1]]), default=None))
    last = best[-1]
    return last[1] if last is not None else None


def arranged(drawn: tuple[Drawn, ...], way: Way = None) -> Layout | None:
    """Portrait or landscape, as wished or whichever leaves the more even white; portrait where they are alike."""
    sizes, pairs = (
        [one.size for one in drawn],
        [(i, i + 1) for i in range(len(drawn) - 1) if _paired(drawn[i], drawn[i + 1])],
    )
    upright, wide = (
        None if way and landscape != (way == "landscape") else pack(sizes, room_inside(landscape), pairs)
        for landscape in (False, True)
    )
    if upright is None or wide is None:
        return upright or wide
    return wide if (wide.together, wide.white) > (upright.together, upright.white + UPRIGHT) else upright


def _paired(a: Drawn, b: Drawn) -> bool:
    return b.view.beside is a.view and a.name == b.name


def _cost(drawn: tuple[Drawn, ...], start: int, end: int, layout: Layout) -> Cost:
    """Of a page: itself with each pair that is torn, those pairs,
    sparse among several, an unnatural break before it, and crowding."""
    pairs = sum(_paired(drawn[i - 1], drawn[i]) for i in range(max(start, 1), end))
    torn = pairs - layout.together
    area = sum(w * h for w, h in (one.size for one in drawn[start:end]))
    sparse = (start > 0 or end < len(drawn)) and area < SPARSE * layout.page[0] * layout.page[1]
    natural = start == 0 or (drawn[start].view.paired and not drawn[start - 1].view.paired)
    return 1 + torn, torn, int(sparse), int(not natural), int(layout.white < CROWDED)
