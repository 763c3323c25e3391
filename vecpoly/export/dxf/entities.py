"""Marks and items of a scene as DXF entities: a vector is a line from its tail to its tip, and a head."""

from __future__ import annotations

from math import degrees, pi
from typing import TYPE_CHECKING, Any

from ...board.paper.marks import Arc, Disc, Dot, FrictionCircle, GearMark, Mark, Point, Segment, Vector
from ...drawing.scene import Fill, Item, Stroke, TextBox
from ...drawing.style import Hue
from ...drawing.symbols.around import Surroundings
from ...drawing.symbols.marks import draw
from ...typeset import Box, Glyphs, Rule
from ...typeset.box import MM
from ...typeset.fonts import MISSING, Face, missing_text
from .layers import SHEET, TEXT, layer_of, pattern_of, weight

if TYPE_CHECKING:
    from ezdxf.layouts.layout import Modelspace

CAPITAL = 0.66  # of the em: how high a capital is, by which DXF measures type
_STYLES = {
    Face.ITALIC: ("VECPOLY_ITALIC", "timesi.ttf"),
    Face.BOLD_ITALIC: ("VECPOLY_ITALIC", "timesi.ttf"),
    Face.SONG: ("VECPOLY_SONG", "simsun.ttc"),
    Face.SONG_EXT: ("VECPOLY_SONG", "simsun.ttc"),
    Face.HEI: ("VECPOLY_HEI", "simhei.ttf"),
    Face.HEI_BOLD: ("VECPOLY_HEI", "simhei.ttf"),
}
_UPRIGHT = ("VECPOLY_ROMAN", "times.ttf")
STYLES = dict((*_STYLES.values(), _UPRIGHT))


class Paper:
    """The model space of a drawing: 1 unit is 1 mm of paper."""

    def __init__(self, space: Modelspace) -> None:
        self.space = space

    def mark(self, mark: Mark, around: Surroundings, by: complex) -> None:
        """A mark of a figure whose origin lies at `by`."""
        items, layer = draw(mark, around), layer_of(mark)
        match mark:
            case Segment(a=a, b=b):
                self._line(a + by, b + by, layer, items[0])
            case Vector(a=a, b=b) if items:
                self._line(a + by, b + by, layer, items[0])
                self._items(items[1:], layer, by)
            case Arc() | GearMark() | Disc() | FrictionCircle() if isinstance(
                ring := next((i for i in items if isinstance(i, Stroke)), None), Stroke
            ):
                self._round(mark, layer, ring, by)
                self._items([one for one in items if one is not ring], layer, by)
            case Point(at=at, dot=Dot.JOINT | Dot.MULTIPLE | Dot.POLE) if isinstance(outline := items[-1], Stroke):
                self._items(items[:-1], layer, by)
                self.space.add_circle(_xy(at + by), abs(outline.points[0] - at), self._look(layer, outline))
            case _:
                self._items(items, layer, by)

    def item(self, item: Item, layer: str, by: complex = 0j) -> None:
        """An item of a scene."""
        match item:
            case Stroke(points=points) if len(points) == 2 and not item.closed:
                self._line(points[0] + by, points[1] + by, layer, item)
            case Stroke(points=points):
                self.space.add_lwpolyline(
                    [_xy(z + by) for z in points], close=item.closed, dxfattribs=self._look(layer, item)
                )
            case Fill(points=points, hue=Hue.WHITE):
                self.space.add_wipeout([_xy(z + by) for z in points]).dxf.layer = layer
            case Fill(points=points, hue=hue):
                self._area([_xy(z + by) for z in points], layer, hue)
            case TextBox(box=box, x=x, y=y, hue=hue):
                self._type(box, complex(x, y) + by, hue, SHEET if layer == SHEET else TEXT)

    def _items(self, items: Any, layer: str, by: complex) -> None:
        for one in items:
            self.item(one, layer, by)

    def _line(self, a: complex, b: complex, layer: str, like: Item) -> None:
        self.space.add_line(_xy(a), _xy(b), self._look(layer, like))

    def _round(self, mark: Arc | GearMark | Disc | FrictionCircle, layer: str, ring: Stroke, by: complex) -> None:
        """A whole circle, or an arc counter-clockwise."""
        look, centre = self._look(layer, ring), _xy(mark.centre + by)
        if not isinstance(mark, Arc) or abs(abs(mark.sweep) - 2 * pi) < 1e-9:
            self.space.add_circle(centre, abs(ring.points[0] - mark.centre), look)
            return
        first, last = sorted((degrees(mark.start), degrees(mark.start + mark.sweep)))
        self.space.add_arc(centre, mark.radius, first, last, dxfattribs=look)

    def _area(self, corners: list[tuple[float, float]], layer: str, hue: Hue) -> None:
        if len(corners) == 3:
            self.space.add_solid(corners, {"layer": layer, "true_color": _true(hue)})
            return
        area = self.space.add_hatch(dxfattribs={"layer": layer, "true_color": _true(hue)})
        area.paths.add_polyline_path(corners, is_closed=True)

    def _type(self, box: Box, at: complex, hue: Hue, layer: str) -> None:
        """Every run of letters at its own place."""
        for run in box.items:
            match run:
                case Rule(x=x, y=y, width=w, height=h):
                    low = at + complex(x, y)
                    self._area([_xy(low), _xy(low + w), _xy(low + complex(w, h)), _xy(low + complex(0, h))], layer, hue)
                case Glyphs(text=text) if text.strip():
                    self._run(run, at, hue, layer)

    def _run(self, run: Glyphs, at: complex, hue: Hue, layer: str) -> None:
        missing = run.font == MISSING
        text = "".join(map(missing_text, run.text)) if missing else run.text
        style = _UPRIGHT if missing else _STYLES.get(Face(run.font), _UPRIGHT)
        self.space.add_text(
            text,
            height=CAPITAL * run.size / MM,
            dxfattribs={
                "layer": layer,
                "style": style[0],
                "true_color": _true(hue),
                "insert": _xy(at + complex(run.x, run.y)),
            },
        )

    def _look(self, layer: str, like: Item) -> dict[str, Any]:
        """Layer, ink, width and pattern of a line."""
        if not isinstance(like, Stroke):
            return {"layer": layer}
        return {
            "layer": layer,
            "true_color": _true(like.hue),
            "lineweight": weight(like.width),
            "linetype": pattern_of(like.dash),
        }


def _true(hue: Hue) -> int:
    return int(hue.hex[1:], 16)


def _xy(at: complex) -> tuple[float, float]:
    return at.real, at.imag
