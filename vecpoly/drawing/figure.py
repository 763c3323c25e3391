"""A figure of the construction drawn in mm: its marks, its lettering in place, its title with the scale under it."""

from __future__ import annotations

from functools import lru_cache

from ..algebra.formula import Node, Power, Row, Txt, row
from ..algebra.quantity import number
from ..board.construction import Figure, Scale, View
from ..board.paper.marks import Ground
from ..foundation.patterns import pattern
from ..foundation.slotted import dataclass, replace
from ..typeset import Box, layout
from ..words import Lang, Words
from .beside import beside
from .cleared import cleared
from .labels.actions import is_line_of_action
from .labels.ground import broken
from .labels.kept import Lettering, places_forgotten
from .labels.notes import LEADING, folded, lines
from .labels.want import Line, Spot, Want
from .labels.wants import grounds, heads, unnamed, wants
from .ringed import is_astray
from .scene import Fill, Item, Rect, Scene, Stroke, TextBox
from .style import NOTE, TITLE
from .symbols.around import Surroundings
from .symbols.marks import draw
from .weighing.placed import BAD, Placed
from .widened import Widths, widened, widths

TITLE_GAP, LINE = 6.0, 6.0  # mm: lowest ink to the title's capitals; title to scale
DETAIL = 1.15 * NOTE  # em of the title of a detail, which is a part of its figure: that of a scale
PART = pattern(r"(^| )detail \d+$")  # the name of a detail (`details/apart.py`)
_FIGURES = 6  # of a scale
KEPT = 64  # drawings
WITH_LINES = Words("与力的作用线", " with lines of action")
TITLE_WIDTH = 70.0  # a title wider than this and than its figure takes two lines


@dataclass(frozen=True, slots=True)
class Drawing:
    """A drawn figure with what its lettering stands among: the hatching is broken off about it."""

    scene: Scene
    labels: tuple[Placed, ...]
    obstacles: tuple[Item, ...]
    drawn: Rect  # the extents of lines and lettering without the title
    widths: Widths = ()  # the angles that are marked with other radii than in the figure

    @property
    def label_boxes(self) -> tuple[Rect, ...]:
        """The rectangles that the labels cover."""
        return tuple(label.rect for label in self.labels)


@dataclass(frozen=True, slots=True)
class Bare:
    """A figure without its lettering: its items, what is to be lettered, and the points without a letter."""

    items: tuple[Item, ...]
    wanted: tuple[Want, ...]
    unnamed: tuple[Spot, ...]
    grounds: tuple[Line, ...]
    polygon: bool

    @classmethod
    def of(cls, figure: Figure, lang: Lang, held: tuple[Ground, ...] = ()) -> Bare:
        """Of a figure, with vectors on one line side by side, and supports and arcs where they cross nothing.

        held: the supports as they stand in another position, to stay so.
        """
        marks = cleared(figure.view, beside(figure.view, figure.marks), held)
        around = Surroundings.of(figure.view, marks, lang, figure.tones)
        items = unique(tuple(item for mark in marks for item in draw(mark, around)))
        wanted = wants(figure.view, marks, lang, figure.tones)
        return cls(items, wanted, (*unnamed(marks), *heads(marks)), grounds(marks), figure.view.is_polygon)

    @property
    def extents(self) -> Rect:
        """The rectangle that the items cover."""
        return Scene.of(self.items).extents

    def lettering(self, frame: Rect | None) -> Lettering:
        """Its labels among its lines."""
        return Lettering(self.wanted, self.items, self.extents, frame, self.unnamed, self.grounds, self.polygon)


def draw_figure(
    figure: Figure,
    *,
    lang: Lang = "zh",
    upto_step: int | None = None,
    highlight: int | None = None,
    caption: bool = True,
    frame: Rect | None = None,
) -> Scene:
    """The scene of a figure; `upto_step` shows the board after that step, `highlight` fades all other steps."""
    scene = drawing(figure, lang=lang, caption=caption, frame=frame).scene
    if upto_step is not None:
        scene = scene.upto(upto_step)
    return scene if highlight is None else scene.highlighted(highlight)


@lru_cache(maxsize=KEPT)
def drawing(figure: Figure, *, lang: Lang = "zh", caption: bool = True, frame: Rect | None = None) -> Drawing:
    """The figure drawn, with its labels and obstacles; letters stay within `frame` where one is given.

    What was drawn last is kept: question, solution, course report and player of one problem draw a figure once.
    """
    made = _drawn(figure, lang, caption, frame)
    by = widths(figure, made.labels, made.obstacles)
    tried = (by, *((one,) for one in by)) if len(by) > 1 else (by,) if by else ()
    wider = (replace(_drawn(widened(figure, some), lang, caption, frame), widths=some) for some in tried)
    return min((made, *wider), key=_led)


def _drawn(figure: Figure, lang: Lang, caption: bool, frame: Rect | None) -> Drawing:
    bare = Bare.of(figure, lang)
    placed = tuple(label for label in bare.lettering(frame).placed if not is_astray(figure, label))
    items = broken(bare.items, [label.rect for label in placed])
    lettered = Scene.of(items + tuple(item for label in placed for item in label.items()))
    scene = lettered + Scene.of(caption_items(figure, lettered.extents, lang)) if caption else lettered
    return Drawing(scene, placed, items, lettered.extents)


def _led(one: Drawing) -> tuple[int, int]:
    """How many labels stand on something, and on leaders."""
    return sum(label.cost > BAD for label in one.labels), sum(label.foot is not None for label in one.labels)


def drawn_anew() -> None:
    """From here on every figure is drawn again: for measuring."""
    drawing.cache_clear()
    places_forgotten()


def unique(items: tuple[Item, ...]) -> tuple[Item, ...]:
    """Without what would be drawn twice at the same place; the earliest step keeps it. Dashes of a line that is drawn
    from either end would fill each other's gaps."""
    seen: dict[object, Item] = {}
    for item in items:
        match item:
            case Stroke(points=points, width=width, dash=dash, hue=hue):
                line = frozenset(points) if len(points) == 2 else points
                seen.setdefault((line, width, dash, hue), item)
            case Fill(points=points, hue=hue):
                seen.setdefault((points, hue), item)
            case TextBox():
                seen.setdefault(item, item)
    return tuple(seen.values())


def titled(figure: Figure) -> Words:
    """The title of a figure; where lines stand for forces on a diagram, which show no sense, it says what they are."""
    plain = figure.title == figure.view.title and figure.view is View.MECHANISM
    return figure.title + WITH_LINES if plain and any(map(is_line_of_action, figure.marks)) else figure.title


def caption_items(figure: Figure, over: Rect, lang: Lang) -> tuple[Item, ...]:
    """The title and the scale, centred under a figure; a sketch without a scale has none printed."""
    em = DETAIL if is_part(figure) else TITLE
    text = folded(titled(figure).of(lang), em, max(over.width, TITLE_WIDTH))
    title, middle = lines(text, em), over.centre.real
    y = over.y0 - TITLE_GAP - title.ascent / 2
    under = TextBox(box=title, x=middle - title.width / 2, y=y)
    if not figure.scale.symbol or not figure.scale.value:
        return (under,)
    scale = scale_box(figure.scale)
    below = LINE + text.count("\n") * LEADING * TITLE
    return (under, TextBox(box=scale, x=middle - scale.width / 2, y=y - below))


def is_part(figure: Figure) -> bool:
    """Whether it is a detail of another."""
    return PART.search(figure.name) is not None


def title_line(scene: Scene, figure: Figure) -> float:
    """On which height the title of a drawn figure stands."""
    title = scene.items[-2 if figure.scale.symbol and figure.scale.value else -1]
    return title.y if isinstance(title, TextBox) else scene.extents.y0


@lru_cache(maxsize=256)
def scale_box(scale: Scale) -> Box:
    """A scale in type: ``μ_v = 0.006 (m/s)/mm``; after it that to the right, where it is another."""
    right = () if scale.across is None else (Txt(",  "), *_scale_items(scale.across))
    return layout(Row((*_scale_items(scale), *right)), DETAIL)


def _scale_items(scale: Scale) -> tuple[Node, ...]:
    name, told = row(f"{scale.symbol} = "), scale.told
    return (*name.items, Txt(f"{number(told.value, _FIGURES)} "), *unit_per_mm(told.unit))


def unit_per_mm(unit: str) -> tuple[Txt | Power, ...]:
    """A unit over the millimetre: m/mm, (m/s)/mm, (m/s²)/mm."""
    if "/" not in unit:
        return (Txt(f"{unit}/mm"),)
    body, _, exponent = unit.partition("^")
    if not exponent:
        return (Txt(f"({unit})/mm"),)
    return (Txt(f"({body.replace('²', '')}"[:-1]), Power(Txt(body[-1]), exponent), Txt(")/mm"))
