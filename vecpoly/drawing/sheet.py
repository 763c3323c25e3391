"""A4 sheets: the figures of a construction placed true to scale, 1 mm of a figure being 1 mm of paper."""

from __future__ import annotations

from dataclasses import dataclass

from ..board.construction import Construction, View
from ..errors import VecpolyError
from ..words import Lang, Words
from .figure import draw_figure
from .packing import Layout, pack
from .scene import Rect, Scene
from .space import A4, FRAME, STRIP, usable
from .titleblock import Strip, furniture

NO_TITLE = Words.same("")


@dataclass(frozen=True, slots=True)
class Placed:
    """A figure on a sheet: its view, and where on the page its origin and its extents lie, mm from the lower left."""

    view: View
    origin: complex
    extents: Rect


@dataclass(frozen=True, slots=True)
class Sheet:
    """A page of drawings in mm, its origin at the lower left corner of the paper."""

    scene: Scene
    figures: tuple[Placed, ...]
    landscape: bool

    @property
    def size(self) -> tuple[float, float]:
        """Width and height of the paper, mm."""
        return self.scene.extents.width, self.scene.extents.height


def sheets(construction: Construction, *, lang: Lang = "zh", title: Words = NO_TITLE) -> tuple[Sheet, ...]:
    """The figures of a construction on as few A4 sheets as hold them, the mechanism first.

    Raises VecpolyError where a figure is larger than a sheet.
    """
    drawn = tuple((figure.view, draw_figure(figure, lang=lang)) for figure in construction.figures)
    pages = _pages(drawn)
    return tuple(
        _sheet(group, layout, Strip(problem=construction.problem, title=title, hand=construction.hand, number=n, total=len(pages)), lang)
        for n, (group, layout) in enumerate(pages, start=1)
    )


Drawn = tuple[View, Scene]


def _pages(drawn: tuple[Drawn, ...]) -> list[tuple[tuple[Drawn, ...], Layout]]:
    """The figures in order, each page taking as many as it can."""
    pages: list[tuple[tuple[Drawn, ...], Layout]] = []
    rest = drawn
    while rest:
        for count in range(len(rest), 0, -1):
            layout = _best(rest[:count])
            if layout is not None:
                break
        else:
            raise _too_large(*rest[0])
        pages.append((rest[:count], layout))
        rest = rest[count:]
    return pages


def _best(drawn: tuple[Drawn, ...]) -> Layout | None:
    """Portrait or landscape, whichever leaves the more even white; portrait where they are alike."""
    sizes = [(scene.extents.width, scene.extents.height) for _, scene in drawn]
    upright, wide = (pack(sizes, _room(landscape)) for landscape in (False, True))
    if upright is None or wide is None:
        return upright or wide
    return wide if wide.white > upright.white + 4.0 else upright


def _room(landscape: bool) -> tuple[float, float]:
    """Width and height inside the frame, over the strip."""
    width, height = reversed(A4) if landscape else A4
    return width - 2 * FRAME, height - 2 * FRAME - STRIP


def _too_large(view: View, scene: Scene) -> VecpolyError:
    size, room = scene.extents, usable()
    return VecpolyError(
        f"the {view.value} figure measures {size.width:.0f} × {size.height:.0f} mm with its lettering; an A4 sheet holds "
        f"{room[0]:.0f} × {room[1]:.0f} mm (or {usable(True)[0]:.0f} × {usable(True)[1]:.0f} mm across): choose a larger μ"
    )


def _sheet(drawn: tuple[Drawn, ...], layout: Layout, strip: Strip, lang: Lang) -> Sheet:
    landscape = layout.page == _room(True)
    width, height = reversed(A4) if landscape else A4
    page = Rect(0.0, 0.0, width, height)
    items = list(furniture(page, strip, lang))
    placed: list[Placed] = []
    for (view, scene), corner in zip(drawn, layout.corners, strict=True):
        by = corner + complex(FRAME, FRAME + STRIP) - complex(scene.extents.x0, scene.extents.y0)
        shifted = scene.moved(by)
        items.extend(shifted.items)
        placed.append(Placed(view, by, shifted.extents))
    return Sheet(Scene(tuple(items), page), tuple(placed), landscape)
