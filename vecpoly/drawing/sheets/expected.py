"""How many sheets figures take with their details, expected before they are lettered for them: placing letters is
dear, and of all arrangements that are thought of one alone is drawn. Details are small, and are lettered at once."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from ...board.construction import Figure
from ...foundation.slotted import dataclass, replace
from ...foundation.stock import Paper
from ...words import Lang
from ..details.apart import is_detail
from ..details.knots import MOST
from ..figure import Bare, caption_items
from ..scene import Rect, Scene
from .detailing import Whole, arrangements, loose
from .lettering import labelled, lettered
from .pages import Page, fullness
from .paging import Drawn, best_paged, paged
from .space import SPARSE

WORTH = SPARSE  # of a page that figures take at least for which another sheet is begun
NEARLY = 0.05  # of a page: what is expected to take so much less may yet take enough
SLACK = 4.0  # mm on each side that a figure may be smaller with some of its letters in details
MANY = 100  # letters of a drawing: to place fewer takes no longer than to find out whether it is worth it


@dataclass(frozen=True, slots=True)
class Expected:
    """Figures with their details as far as they are known: each as it is drawn without them, or with no letters yet."""

    figures: Sequence[Figure]
    lang: Lang
    on: Paper
    mains: Whole

    @classmethod
    def unlettered(cls, figures: Sequence[Figure], lang: Lang, on: Paper) -> Expected:
        """Before any letter has its place, by what letters take as a rule."""
        return cls(figures, lang, on, tuple(_unlettered(figure, lang) for figure in figures))

    @classmethod
    def plain(cls, figures: Sequence[Figure], lang: Lang, on: Paper, alone: Whole) -> Expected:
        """From figures drawn without details, whose letters may stand out farther than those beside details."""
        inner = (Scene(one.scene.items, one.scene.extents.grown(-SLACK)) for one in alone)
        return cls(figures, lang, on, tuple(replace(one, scene=scene) for one, scene in zip(alone, inner, strict=True)))

    def lettered(self, most: int = MOST) -> list[Page[Drawn]] | None:
        """These with so many details each, drawn for it."""
        return best_paged(arrangements(self.figures, self.lang, most), self.on)

    def fits(self, sheets: int, most: int = MOST) -> bool:
        """Whether these with so many details each may stand on so many sheets."""
        return _within(self._pages(most), sheets)

    def fits_loose(self, sheets: int) -> bool:
        """The same where each detail has a place of its own."""
        return _within(paged(loose(self.figures, self.lang, self.mains), self.on), sheets)

    def fills(self, share: float, sheets: int) -> bool:
        """Whether these with all their details may take so much of each of so many sheets."""
        pages = self._pages(MOST)
        return _within(pages, sheets) and fullness(pages or ()) >= share

    def _pages(self, most: int) -> list[Page[Drawn]] | None:
        return best_paged(arrangements(self.figures, self.lang, most, self.mains), self.on)


def dear(figures: Sequence[Figure]) -> bool:
    """Whether these have so many letters that it takes long to place them."""
    return sum(bool(getattr(mark, "label", "")) for figure in figures for mark in figure.marks) > MANY


def trials(
    expected: Expected, detailed: list[Page[Drawn]] | None, room: int, most: int, boxed: bool
) -> Iterator[list[Page[Drawn]] | None]:
    """With all details, these apart from their figures, and with fewer; what is not expected to fit on so many sheets
    is left out where letters are dear. detailed: with all, where that is known; where letters are not dear it is."""
    cheap = not dear(expected.figures)
    yield expected.lettered() if detailed is None and not cheap and expected.fits(room) else detailed
    if not boxed and (cheap or expected.fits_loose(room)):  # a red box may part a full page
        yield from _loose(expected)
    yield from (expected.lettered(some) for some in range(most - 1, 0, -1) if cheap or expected.fits(room, some))


def further(expected: Expected, detailed: list[Page[Drawn]] | None, plain: list[Page[Drawn]]) -> list[Page[Drawn]]:
    """One sheet more, where the details find no room else and leave no sheet with little on it."""
    if detailed is None and dear(expected.figures) and expected.fills(WORTH - NEARLY, len(plain) + 1):
        detailed = expected.lettered()
    if detailed is None or len(detailed) > len(plain) + 1 or fullness(detailed) < WORTH:
        return plain
    return detailed


def _loose(expected: Expected) -> Iterator[list[Page[Drawn]] | None]:
    """With details that need not form a rectangle with their figure, if each is on its page."""
    figures = expected.figures
    pages = paged(loose(figures, expected.lang), expected.on)
    firsts = [group[0].name for group, _ in pages or ()]
    if not any(is_detail(name, figure) for name in firsts for figure in figures):
        yield pages


def _within(pages: Sequence[Page[Drawn]] | None, sheets: int) -> bool:
    return pages is not None and len(pages) <= sheets


def _unlettered(figure: Figure, lang: Lang) -> Drawn:
    """The lines of a figure, its title and its scale, with the room that its letters will take about."""
    lines = Scene.of(Bare.of(figure, lang).items)
    caption = Scene.of(caption_items(figure, lines.extents, lang))
    scene, (_, up) = lines + caption, lettered(figure)
    across = max(labelled(figure)[0], caption.extents.width)  # its title is known, in this language
    at = scene.extents.centre - complex(across, up) / 2
    room = Rect(at.real, at.imag, at.real + across, at.imag + up)
    return Drawn(figure.view, figure.name, replace(scene, extents=room), figure=figure)
