"""Which figures share a page: as few pages as will do, all turned one way, a free body with its polygon,
no small drawing alone on one of several."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from functools import reduce
from itertools import pairwise, product
from operator import or_

from ...board.construction import Figure, View
from ...foundation.slotted import dataclass, replace
from ...foundation.stock import ANY_A4, Paper
from ..figure import title_line
from ..order import reading_order as reading_order
from ..scene import Rect, Scene
from .boxes.redbox import BAND
from .mounting.evening import evened
from .mounting.spreading import sunk
from .packing import TIGHT, Layout, pack
from .pages import CROWDED, NOTHING, Cost, F, Page, Paging, Sized, covered, fullness, pairs_of
from .slicing import Size
from .space import STRIP, is_across, is_page, rooms

UPRIGHT = 0.04  # of a page's area by which figures must spread wider over one that lies across
NESTED, TIGHTLY = 0.1, 0.07  # the same, over one that is plainer by a cut within cuts; for each mm of white it lacks
TABLE = 0.1  # the same that a table of rows with as many figures each may lack
WELL = 0.65  # of a page that figures fill as a rule: titles on one line are worth no less


@dataclass(frozen=True, slots=True)
class Drawn:
    """A figure drawn, before it has a place: its view, its name, its scene. details: they stand beside it already, each
    moved by `by`. figure: as it is drawn."""

    view: View
    name: str
    scene: Scene
    by: complex = 0j
    figure: Figure | None = None
    details: tuple[Drawn, ...] = ()

    @property
    def extents(self) -> Rect:
        """The rectangle that it needs with lettering, title and details."""
        return reduce(or_, (one.scene.extents for one in self.details), self.scene.extents)

    @property
    def size(self) -> Size:
        """Width and height of that, mm."""
        return self.extents.width, self.extents.height

    @property
    def line(self) -> float:
        """How high its title stands over the lowest of all that, mm."""
        return 0.0 if self.figure is None else title_line(self.scene, self.figure) - self.extents.y0


def paged(drawn: Sequence[F], on: Paper = ANY_A4) -> list[Page[F]] | None:
    """The figures in order on the best pages, all of them turned alike, this way where one is wished;
    None where one fits no page."""
    return best_paged((drawn,), on)


def best_paged(variants: Iterable[Sequence[F]], on: Paper = ANY_A4) -> list[Page[F]] | None:
    """The same of figures that may be arranged with their details in several ways."""
    trials = (Paging(drawn, page).best() for drawn in variants for page in rooms(on))
    return min((found for found in trials if found is not None), key=_rank, default=(NOTHING, None))[1]


def _rank(found: tuple[Cost, list[Page[F]]]) -> tuple[Cost, float]:
    """The dearer, the later; of equal costs the one over whose pages the figures spread widest, in plain rows or
    columns, best those of a table, with white between them."""
    cost, pages = found
    across = any(is_across(layout.page) for _, layout in pages)
    nested = max((layout.nested for _, layout in pages), default=0)
    lacking = max((CROWDED - layout.white for _, layout in pages), default=0.0)
    bad = (UPRIGHT if across else 0.0) + NESTED * nested + TIGHTLY * max(lacking, 0.0)
    return cost, bad - fullness(pages) - (TABLE if all(layout.table for _, layout in pages) else 0.0)


def lined(figures: Sequence[Drawn], layout: Layout, still: Sequence[Rect] = ()) -> Layout:
    """With the titles of figures side by side on one line, unless the figures would be lost on the page then;
    still: what else stands there."""
    boxes, lines = standing(figures, layout)
    falls = sunk(boxes, lines, still, min(TIGHT, max(layout.white, 0.0)))
    made = replace(layout, corners=tuple(at - 1j * by for at, by in zip(layout.corners, falls, strict=True)))
    return made if covered(figures, made) >= min(WELL, covered(figures, layout)) else layout


def even(figures: Sequence[Drawn], layout: Layout, still: Sequence[Rect] = ()) -> Layout:
    """With as much white to the frame as between the figures, where they can be drawn together."""
    moves = evened(*standing(figures, layout), layout.page, still)
    return replace(layout, corners=tuple(at + by for at, by in zip(layout.corners, moves, strict=True)))


def read_on(figures: Sequence[Drawn], layout: Layout) -> bool:
    """Whether no figure stands over the one before it."""
    boxes, _ = standing(figures, layout)
    return all(other.y0 < one.y1 for one, other in pairwise(boxes))


def standing(figures: Sequence[Drawn], layout: Layout) -> tuple[list[Rect], list[float]]:
    """The rectangle that each figure takes on its page, and on which height its title stands."""
    boxes = [
        Rect(at.real, at.imag, at.real + one.size[0], at.imag + one.size[1])
        for at, one in zip(layout.corners, figures, strict=True)
    ]
    return boxes, [box.y0 + one.line for box, one in zip(boxes, figures, strict=True)]


def under_box(figures: tuple[F, ...], layout: Layout) -> list[Page[F]]:
    """The figures of a page closer together, so that the red box over them covers none, on two pages where one is full;
    on pages turned the other way where a figure alone leaves no room for the box; as they are where it leaves none so,
    and on a plate, which is made higher."""
    if not is_page(layout.page):
        return [(figures, layout)]
    (wide, high), pairs = layout.page, pairs_of(figures)
    ends = sorted(range(len(figures), 0, -1), key=lambda end: (end < len(figures), (end - 1, end) in pairs))
    for page, end in product((layout.page, (high + STRIP, wide - STRIP)), ends):
        parts = [part for part in (figures[:end], figures[end:]) if part]
        lower = page[0], page[1] - BAND
        made = [pack([one.size for one in part], lower, tuple(pairs_of(part))) for part in parts]
        if all(made):
            return [(part, found) for part, found in zip(parts, made, strict=True) if found is not None]
    return [(figures, layout)]


def arranged(drawn: Sequence[Sized], on: Paper = ANY_A4) -> Layout | None:
    """All figures on one page, upright or across, as wished or whichever they spread over more widely."""
    sizes, pairs = [one.size for one in drawn], pairs_of(drawn)
    made = [layout for page in rooms(on) if (layout := pack(sizes, page, tuple(pairs))) is not None]
    return max(made, key=lambda one: (one.together, covered(drawn, one)), default=None)
