"""A4 sheets: the figures of a construction placed true to scale, 1 mm of a figure being 1 mm of paper."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import chain

from ...board.acts.inkless import is_reading
from ...board.construction import Construction, Figure, View
from ...errors import VecpolyError
from ...foundation.slotted import dataclass, replace
from ...foundation.stock import A4, ANY_A4, Format, Paper
from ...words import Lang, Words
from ..details.apart import is_detail
from ..details.knots import knots
from ..scene import Item, Rect, Scene
from .boxes.redbox import BAND, red_box
from .boxes.titleblock import Strip, furniture
from .detailing import arrangements, drawn
from .expected import Expected, dear, further, trials
from .mounting.lifting import lifted
from .packing import Layout
from .pages import Page, fullness
from .paging import Drawn, arranged, best_paged, lined, paged, under_box
from .plating import on_plates
from .readied import readied
from .scales.enlarging import enlarged
from .settling.settled import settled
from .space import FRAME, SPARSE, STRIP, is_across, is_page, room_inside, usable

NO_TITLE = Words.same("")


@dataclass(frozen=True, slots=True)
class Placed:
    """A figure on a sheet as it is drawn: where its origin and its extents lie, mm from the lower left of the page."""

    view: View
    origin: complex
    extents: Rect
    name: str = ""
    count: int = 0  # of the items of the sheet, so many are its own
    figure: Figure | None = None


@dataclass(frozen=True, slots=True)
class Sheet:
    """A page of drawings in mm, its origin at the lower left corner of the paper, and what its title strip says."""

    drawn: tuple[Item, ...]
    figures: tuple[Placed, ...]
    room: tuple[float, float]  # inside the frame, over the strip
    strip: Strip
    lang: Lang
    warning: Words | None = None
    results: tuple[Item, ...] = ()  # what came out, and the legend, where the sheet has room

    @property
    def landscape(self) -> bool:
        """Whether it is a whole sheet that lies across."""
        return is_across(self.room)

    @property
    def plate(self) -> bool:
        """Whether it is lower than a page, to stand in the text."""
        return not is_page(self.room)

    @property
    def size(self) -> tuple[float, float]:
        """Width and height of the paper, mm."""
        return self.room[0] + 2 * FRAME, self.room[1] + 2 * FRAME + STRIP

    @property
    def scene(self) -> Scene:
        """Frame, title strip, figures and results; a warning in red over all."""
        return Scene((*self.furniture.items, *self.drawn, *self.results, *self.alarm.items), self._page)

    @property
    def _page(self) -> Rect:
        return Rect(0.0, 0.0, *self.size)

    @property
    def furniture(self) -> Scene:
        """Frame and title strip."""
        return Scene(tuple(furniture(self._page, self.strip, self.lang, blanks=not self.plate)), self._page)

    @property
    def alarm(self) -> Scene:
        """A warning in red."""
        return Scene(() if self.warning is None else red_box(self._page, self.warning.of(self.lang)), self._page)

    @property
    def parts(self) -> Iterator[tuple[Placed, Scene]]:
        """Every figure with what is drawn of it."""
        start = 0
        for one in self.figures:
            yield one, Scene(self.drawn[start : start + one.count], one.extents)
            start += one.count

    @property
    def groups(self) -> tuple[Drawn, ...]:
        """The figures as they are drawn on it, each with its details."""
        made: list[Drawn] = []
        for one, scene in self.parts:
            part = Drawn(one.view, one.name, scene, one.origin, one.figure)
            if made and _shows(part, made[-1]):
                made[-1] = replace(made[-1], details=(*made[-1].details, part))
            else:
                made.append(part)
        return tuple(made)


@dataclass(frozen=True, slots=True)
class Hung:
    """A page whose figures have their places: the middle of the upper edge of each, mm inside the sheet's frame."""

    landscape: bool
    tops: tuple[complex, ...]


def sheets(
    construction: Construction,
    *,
    lang: Lang = "zh",
    title: Words = NO_TITLE,
    on: Paper = ANY_A4,
    plates: bool = False,
    bands: bool = True,
) -> tuple[Sheet, ...]:
    """The figures of a construction on as few sheets as hold them, the mechanism first, each force polygon beside
    its free body; on: sheets of this paper. plates: figures that would be lost on a page stand on a plate of their
    height; bands: of the others some may stay white, as where results are written on them, else free bodies and parts
    of a mechanism drawn apart are larger.

    Crowded places are drawn apart, enlarged, beside their figures, where that asks for no further sheet, or for one
    that is well filled. Raises VecpolyError where a figure is larger than a sheet.
    """
    pages = _pages(readied(construction.figures), lang, on, construction.warning is not None)
    if plates and on.way is None:
        pages = [*on_plates(pages, bands)]
    if plates and not bands and construction.warning is None:
        pages = [*enlarged(pages, lang, construction)]
    laid = ((group, settled(group, layout)) for group, layout in pages)
    return _numbered([(lifted(*page), page[1]) for page in laid], construction, lang, title)


def _pages(figures: Sequence[Figure], lang: Lang, on: Paper, boxed: bool) -> list[Page[Drawn]]:
    """The figures with as many details as need no further sheet, and leave none with little on it if others do not."""
    most, detailed = max((len(knots(figure)) for figure in figures), default=0), None
    if most and dear(figures):
        made = (one for one in trials(Expected.unlettered(figures, lang, on), None, 1, most, boxed) if one is not None)
        if (single := next((one for one in made if len(one) == 1), None)) is not None:
            return single
    else:
        detailed = best_paged(arrangements(figures, lang), on)
        if detailed is not None and (len(detailed) == 1 or not most):
            return detailed
    alone = drawn(figures, lang)
    plain = paged(alone, on)
    if plain is None:
        return _each_turned(alone, on)
    expected = Expected.plain(figures, lang, on, alone)
    some = trials(expected, detailed, len(plain), most, boxed)
    made = (one for one in some if one is not None and len(one) <= len(plain))
    first = next(made, plain)
    if first is plain and not boxed:
        return further(expected, detailed, plain)
    enough = min(SPARSE, fullness(plain))
    return next((one for one in chain((first,), made) if fullness(one) >= enough), first)


def _each_turned(alone: Sequence[Drawn], on: Paper) -> list[Page[Drawn]]:
    """Each figure on a page of its own, turned as it needs. Raises VecpolyError where a figure is larger than that."""
    made: list[Page[Drawn]] = []
    for one in alone:
        if (layout := arranged((one,), on)) is None:
            raise _too_large(one, on.format)
        made.append(((one,), layout))
    return made


def hung(
    construction: Construction, pages: Sequence[Hung], *, of: Format = A4, lang: Lang = "zh", title: Words = NO_TITLE
) -> tuple[Sheet, ...]:
    """The figures of a construction on sheets of this format, in order, each hung up where it is said."""
    waiting, made = drawn(construction.figures, lang), list[Page[Drawn]]()
    for page in pages:
        group, waiting = waiting[: len(page.tops)], waiting[len(page.tops) :]
        corners = tuple(top - complex(one.size[0] / 2, one.size[1]) for top, one in zip(page.tops, group, strict=True))
        made.append((group, Layout(room_inside(page.landscape, of), corners, 0.0)))
    return _numbered(made, construction, lang, title)


def _numbered(pages: Sequence[Page[Drawn]], construction: Construction, lang: Lang, title: Words) -> tuple[Sheet, ...]:
    warning, read = construction.warning, not construction.acts or any(map(is_reading, construction.acts))
    if warning is not None:
        pages = [(group, lined(group, layout)) for page in pages for group, layout in under_box(*page)]
    return tuple(
        placed(
            group,
            layout,
            Strip(
                problem=construction.problem, title=title, hand=construction.hand, number=n, total=len(pages), read=read
            ),
            lang,
            warning,
        )
        for n, (group, layout) in enumerate(pages, start=1)
    )


def bound(loose: Sequence[Sheet], names: Sequence[Words]) -> tuple[Sheet, ...]:
    """Sheets of several drawings as they are bound together: numbered through, each with its name (Figure 6-1)."""
    return tuple(
        replace(sheet, strip=replace(sheet.strip, number=n, total=len(loose), name=name))
        for n, (sheet, name) in enumerate(zip(loose, names, strict=True), start=1)
    )


def _shows(one: Drawn, other: Drawn) -> bool:
    """Whether one is a detail of the other."""
    return one.view is other.view and other.figure is not None and is_detail(one.name, other.figure)


def _too_large(one: Drawn, of: Format) -> VecpolyError:
    size, room, broad = one.scene.extents, usable(of=of), usable(True, of)
    name = f"{one.view.name} {one.name}".rstrip()
    return VecpolyError(
        Words(
            f"图 {name} 连同文字为 {size.width:.0f} × {size.height:.0f} mm，而 {of.name} 图纸可用 {room[0]:.0f} × "
            f"{room[1]:.0f} mm（横放 {broad[0]:.0f} × {broad[1]:.0f} mm）；请加大 μ",
            f"the {one.view.name} figure{f' {one.name}' if one.name else ''} measures {size.width:.0f} × "
            f"{size.height:.0f} mm with its lettering; a sheet ({of.name}) holds {room[0]:.0f} × {room[1]:.0f} mm (or "
            f"{broad[0]:.0f} × {broad[1]:.0f} mm across): choose a larger μ",
        )
    )


def placed(group: Sequence[Drawn], layout: Layout, strip: Strip, lang: Lang, warning: Words | None) -> Sheet:
    """These figures on a sheet."""
    items: list[Item] = []
    there: list[Placed] = []
    for one, corner in zip(group, layout.corners, strict=True):
        by = corner + complex(FRAME, FRAME + STRIP) - complex(one.extents.x0, one.extents.y0)
        for part in (one, *one.details):
            shifted = part.scene.moved(by)
            items.extend(shifted.items)
            there.append(Placed(part.view, by + part.by, shifted.extents, part.name, len(shifted.items), part.figure))
    sheet = Sheet(tuple(items), tuple(there), layout.page, strip, lang, warning)
    return replace(sheet, room=(sheet.room[0], sheet.room[1] + BAND)) if sheet.plate and warning is not None else sheet
