"""Figures on pages turned one way, as far as their sizes tell: the pages of least cost, and how full they are."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import Generic, Protocol, TypeVar

from ...board.construction import View
from .packing import Layout, flat, packed, slicings
from .slicing import Pair, Size
from .space import CLEAR, HIGHEST, LARGEST, LEGEND, PLATE, SPARSE

CROWDED = 6.5  # mm of white below which a page is full to the brim
LONGEST = 12  # figures on a page
INKED = 0.6  # of a page that figures take themselves, without what is white between them
BANDS, FULLER = 0.7, 0.12  # of a page that figures take that leave bands of it white; so much more they take of a plate


class Sized(Protocol):
    """A figure, as far as its place on a page goes."""

    @property
    def view(self) -> View: ...

    @property
    def name(self) -> str: ...

    @property
    def size(self) -> Size: ...


F = TypeVar("F", bound=Sized)


Page = tuple[tuple[F, ...], Layout]
Cost = tuple[int, int, int, int, int]
NOTHING: Cost = (0, 0, 0, 0, 0)


def fullness(pages: Sequence[Page[F]]) -> float:
    """What the figures of the emptiest page take of it."""
    return min((covered(figures, layout) for figures, layout in pages), default=0.0)


def covered(figures: Sequence[Sized], layout: Layout) -> float:
    """What the box about all figures takes of the page's area."""
    return layout.share([one.size for one in figures])


def inked(figures: Sequence[Sized], layout: Layout) -> float:
    """What the rectangles of the figures take of it together: the less, the broader the bands between them."""
    return sum(wide * high for wide, high in (one.size for one in figures)) / (layout.page[0] * layout.page[1])


def trimmed(figures: Sequence[Sized], layout: Layout) -> Layout:
    """The figures on a plate no higher than they need, where they would be lost on the page."""
    return _on_plate(figures, layout, (PLATE, HIGHEST)) if covered(figures, layout) < SPARSE else layout


def plated(figures: Sequence[Sized], layout: Layout) -> Layout:
    """The same where they leave bands of the page white, about them or between them, on a plate that may be nearly as
    large as a page, if it is filled so much better."""
    share, own = covered(figures, layout), inked(figures, layout)
    most = PLATE, LARGEST
    if share < BANDS and covered(figures, made := _on_plate(figures, layout, most)) > share + FULLER:
        return made
    if own < INKED and inked(figures, made := _on_plate(figures, layout, most, in_rows=True)) > own + FULLER:
        return made
    return trimmed(figures, layout) if share < BANDS else layout


def _on_plate(figures: Sequence[Sized], layout: Layout, most: Size, *, in_rows: bool = False) -> Layout:
    plate = flat([one.size for one in figures], pairs_of(figures), most, in_rows=in_rows)
    return plate if plate is not None and covered(figures, plate) > covered(figures, layout) else layout


class Paging(Generic[F]):
    """The figures on pages turned one way; `tied` pairs stand together wherever they fit so."""

    def __init__(self, drawn: Sequence[F], page: Size) -> None:
        self.drawn, self.page = tuple(drawn), page
        self.sizes = [one.size for one in self.drawn]
        self.pairs = pairs_of(self.drawn)
        self._slicings = slicings(self.sizes, self.page, self.pairs)
        self._over_legend = slicings(self.sizes, (page[0], page[1] - LEGEND - CLEAR), self.pairs)

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
        unnatural = int(not self._natural(start) or self._crammed(start, end))
        return 1 + torn, torn, round(100 * lacking), unnatural, int(layout.white < CROWDED)

    def _natural(self, start: int) -> bool:
        """Whether a page may well begin so: with the first free body, or with one after a polygon that belongs to none,
        as that without friction, which has room beside the mechanism."""
        if start == 0:
            return True
        before = self.drawn[start - 1].view
        return self.drawn[start].view.paired and (not before.paired or self._is_lone(start - 1))

    def _is_lone(self, n: int) -> bool:
        """Whether this is the polygon of no free body."""
        return self.drawn[n].view.beside is not None and (n - 1, n) not in self.pairs

    def _crammed(self, start: int, end: int) -> bool:
        """Whether a page ends with such a polygon at the cost of the room for its legend."""
        if end == len(self.drawn) or not self._is_lone(end - 1) or end - start == 1:
            return False
        lower = self.page[0], self.page[1] - LEGEND - CLEAR
        return all(packed(one, start, end, self.sizes, lower) is None for one in self._over_legend)


def pairs_of(drawn: Sequence[Sized]) -> frozenset[Pair]:
    """Neighbours of which the second is the polygon of the first."""
    return frozenset((i, i + 1) for i in range(len(drawn) - 1) if paired(drawn[i], drawn[i + 1]))


def paired(a: Sized, b: Sized) -> bool:
    """Whether the second is the polygon of the first."""
    return b.view.beside is a.view and a.name == b.name
