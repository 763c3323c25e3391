"""Which figures share a page: as few pages as will do, all turned one way, a free body with its polygon,
no small drawing alone on one of several."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from functools import reduce
from operator import or_
from typing import Generic, Protocol, TypeVar

from ...board.construction import Figure, View
from ...foundation.slotted import dataclass, replace
from ...foundation.stock import ANY_A4, Paper
from ..figure import title_line
from ..order import reading_order as reading_order
from ..scene import Rect, Scene
from .evening import evened
from .packing import TIGHT, Layout, flat, pack, packed, slicings
from .redbox import BAND
from .slicing import Pair, Size
from .space import SPARSE, is_across, is_page, rooms
from .spreading import sunk

UPRIGHT = 0.04  # of a page's area by which figures must spread wider over one that lies across
CROWDED = 6.5  # mm of white below which a page is full to the brim
LONGEST = 12  # figures on a page
WELL = 0.65  # of a page that figures fill as a rule: titles on one line are worth no less


class Sized(Protocol):
    """A figure, as far as its place on a page goes."""

    @property
    def view(self) -> View: ...

    @property
    def name(self) -> str: ...

    @property
    def size(self) -> Size: ...


F = TypeVar("F", bound=Sized)


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


Page = tuple[tuple[F, ...], Layout]
Cost = tuple[int, int, int, int, int]
NOTHING: Cost = (0, 0, 0, 0, 0)


def paged(drawn: Sequence[F], on: Paper = ANY_A4) -> list[Page[F]] | None:
    """The figures in order on the best pages, all of them turned alike, this way where one is wished;
    None where one fits no page."""
    return best_paged((drawn,), on)


def best_paged(variants: Iterable[Sequence[F]], on: Paper = ANY_A4) -> list[Page[F]] | None:
    """The same of figures that may be arranged with their details in several ways."""
    trials = (Paging(drawn, page).best() for drawn in variants for page in rooms(on))
    return min((found for found in trials if found is not None), key=_rank, default=(NOTHING, None))[1]


def _rank(found: tuple[Cost, list[Page[F]]]) -> tuple[Cost, float]:
    """The dearer, the later; of equal costs the one over whose pages the figures spread widest."""
    cost, pages = found
    across = any(is_across(layout.page) for _, layout in pages)
    return cost, (UPRIGHT if across else 0.0) - fullness(pages)


def fullness(pages: Sequence[Page[F]]) -> float:
    """What the figures of the emptiest page take of it."""
    return min((covered(figures, layout) for figures, layout in pages), default=0.0)


def covered(figures: Sequence[Sized], layout: Layout) -> float:
    """What the box about all figures takes of the page's area."""
    return layout.share([one.size for one in figures])


def trimmed(figures: Sequence[Sized], layout: Layout) -> Layout:
    """The figures on a plate no higher than they need, where they would be lost on the page."""
    if covered(figures, layout) >= SPARSE:
        return layout
    plate = flat([one.size for one in figures], pairs_of(figures))
    return plate if plate is not None and covered(figures, plate) > covered(figures, layout) else layout


def lined(figures: Sequence[Drawn], layout: Layout, still: Sequence[Rect] = ()) -> Layout:
    """With the titles of figures side by side on one line, unless the figures would be lost on the page then;
    still: what else stands there."""
    boxes, lines = _standing(figures, layout)
    falls = sunk(boxes, lines, still, min(TIGHT, max(layout.white, 0.0)))
    made = replace(layout, corners=tuple(at - 1j * by for at, by in zip(layout.corners, falls, strict=True)))
    return made if covered(figures, made) >= min(WELL, covered(figures, layout)) else layout


def even(figures: Sequence[Drawn], layout: Layout, still: Sequence[Rect] = ()) -> Layout:
    """With as much white to the frame as between the figures, where they can be drawn together."""
    moves = evened(*_standing(figures, layout), layout.page, still)
    return replace(layout, corners=tuple(at + by for at, by in zip(layout.corners, moves, strict=True)))


def _standing(figures: Sequence[Drawn], layout: Layout) -> tuple[list[Rect], list[float]]:
    """The rectangle that each figure takes on its page, and on which height its title stands."""
    boxes = [
        Rect(at.real, at.imag, at.real + one.size[0], at.imag + one.size[1])
        for at, one in zip(layout.corners, figures, strict=True)
    ]
    return boxes, [box.y0 + one.line for box, one in zip(boxes, figures, strict=True)]


def under_box(figures: tuple[F, ...], layout: Layout) -> list[Page[F]]:
    """The figures of a page closer together, so that the red box over them covers none, on two pages where one is full;
    as they are on a plate, which is made higher, and where a figure alone leaves no room for the box."""
    if not is_page(layout.page):
        return [(figures, layout)]
    lower, pairs = (layout.page[0], layout.page[1] - BAND), pairs_of(figures)
    ends = sorted(range(len(figures), 0, -1), key=lambda end: (end < len(figures), (end - 1, end) in pairs))
    for end in ends:
        parts = [part for part in (figures[:end], figures[end:]) if part]
        made = [pack([one.size for one in part], lower, tuple(pairs_of(part))) for part in parts]
        if all(made):
            return [(part, found) for part, found in zip(parts, made, strict=True) if found is not None]
    return [(figures, layout)]


class Paging(Generic[F]):
    """The figures on pages turned one way; `tied` pairs stand together wherever they fit so."""

    def __init__(self, drawn: Sequence[F], page: Size) -> None:
        self.drawn, self.page = tuple(drawn), page
        self.sizes = [one.size for one in self.drawn]
        self.pairs = pairs_of(self.drawn)
        self._slicings = slicings(self.sizes, self.page, self.pairs)

    def best(self) -> tuple[Cost, list[Page[F]]] | None:
        """The pages of least cost, of equal costs the fullest first; None where a figure fits no page."""
        best: list[tuple[Cost, list[Page[F]]] | None] = [(NOTHING, [])]
        for end in range(1, len(self.drawn) + 1):
            options = self._options(best, end)
            best.append(min(options, key=lambda o: (o[0], [-len(page) for page, _ in o[1]]), default=None))
        return best[-1]

    def _options(
        self, best: Sequence[tuple[Cost, list[Page[F]]] | None], end: int
    ) -> Iterator[tuple[Cost, list[Page[F]]]]:
        for start in range(max(0, end - LONGEST), end):
            if (before := best[start]) is None or (layout := self.arranged(start, end)) is None:
                continue
            cost = tuple(a + b for a, b in zip(before[0], self._cost(start, end, layout), strict=True))
            yield cost, [*before[1], (self.drawn[start:end], layout)]  # type: ignore[misc]

    def arranged(self, start: int, end: int) -> Layout | None:
        """These figures on one page."""
        if sum(w * h for w, h in self.sizes[start:end]) > self.page[0] * self.page[1]:
            return None
        made = (packed(slicing, start, end, self.sizes, self.page) for slicing in self._slicings)
        return next((layout for layout in made if layout is not None), None)

    def _cost(self, start: int, end: int, layout: Layout) -> Cost:
        """Of a page: itself with each pair that is torn, those pairs,
        what it lacks of being filled among several (in hundredths), an unnatural break before it, and crowding."""
        torn = sum(start <= j < end for _, j in self.pairs) - layout.together
        lacking = max(0.0, SPARSE - covered(self.drawn[start:end], layout)) if end - start < len(self.drawn) else 0.0
        natural = start == 0 or (self.drawn[start].view.paired and not self.drawn[start - 1].view.paired)
        return 1 + torn, torn, round(100 * lacking), int(not natural), int(layout.white < CROWDED)


def arranged(drawn: Sequence[Sized], on: Paper = ANY_A4) -> Layout | None:
    """All figures on one page, upright or across, as wished or whichever they spread over more widely."""
    sizes, pairs = [one.size for one in drawn], pairs_of(drawn)
    made = [layout for page in rooms(on) if (layout := pack(sizes, page, tuple(pairs))) is not None]
    return max(made, key=lambda one: (one.together, covered(drawn, one)), default=None)


def pairs_of(drawn: Sequence[Sized]) -> frozenset[Pair]:
    """Neighbours of which the second is the polygon of the first."""
    return frozenset((i, i + 1) for i in range(len(drawn) - 1) if paired(drawn[i], drawn[i + 1]))


def paired(a: Sized, b: Sized) -> bool:
    """Whether the second is the polygon of the first."""
    return b.view.beside is a.view and a.name == b.name
