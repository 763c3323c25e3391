"""A4 sheets: the figures of a construction placed true to scale, 1 mm of a figure being 1 mm of paper."""

from __future__ import annotations

from dataclasses import dataclass

from ..board.construction import Construction, View
from ..errors import VecpolyError
from ..words import Lang, Words
from .figure import draw_figure
from .packing import Layout
from .paging import Drawn, arranged, paged, reading_order
from .scene import Rect, Scene
from .space import A4, FRAME, STRIP, room_inside, usable
from .titleblock import Strip, furniture

NO_TITLE = Words.same("")


@dataclass(frozen=True, slots=True)
class Placed:
    """A figure on a sheet: its view and name, and where on the page its origin and its extents lie, mm from the lower left."""

    view: View
    origin: complex
    extents: Rect
    name: str = ""


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
    """The figures of a construction on as few A4 sheets as hold them, the mechanism first, each force polygon beside its free body.

    Raises VecpolyError where a figure is larger than a sheet.
    """
    drawn = tuple(Drawn(f.view, f.name, draw_figure(f, lang=lang)) for f in reading_order(construction.figures))
    pages = paged(drawn)
    if pages is None:
        raise _too_large(next(one for one in drawn if arranged((one,)) is None))
    return tuple(
        _sheet(group, layout, Strip(problem=construction.problem, title=title, hand=construction.hand, number=n, total=len(pages)), lang)
        for n, (group, layout) in enumerate(pages, start=1)
    )


def _too_large(one: Drawn) -> VecpolyError:
    size, room = one.scene.extents, usable()
    name = f"{one.view.value} figure {one.name}".rstrip()
    return VecpolyError(
        f"the {name} measures {size.width:.0f} × {size.height:.0f} mm with its lettering; an A4 sheet holds "
        f"{room[0]:.0f} × {room[1]:.0f} mm (or {usable(True)[0]:.0f} × {usable(True)[1]:.0f} mm across): choose a larger μ"
    )


def _sheet(drawn: tuple[Drawn, ...], layout: Layout, strip: Strip, lang: Lang) -> Sheet:
    landscape = layout.page == room_inside(True)
    width, height = reversed(A4) if landscape else A4
    page = Rect(0.0, 0.0, width, height)
    items = list(furniture(page, strip, lang))
    placed: list[Placed] = []
    for one, corner in zip(drawn, layout.corners, strict=True):
        by = corner + complex(FRAME, FRAME + STRIP) - complex(one.scene.extents.x0, one.scene.extents.y0)
        shifted = one.scene.moved(by)
        items.extend(shifted.items)
        placed.append(Placed(one.view, by, shifted.extents, one.name))
    return Sheet(Scene(tuple(items), page), tuple(placed), landscape)
