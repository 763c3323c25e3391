"""A matplotlib figure drawn into a scene: matplotlib decides where axes,
ticks and curves stand, our backends draw them."""

from __future__ import annotations

from functools import lru_cache
from typing import Any

import matplotlib
import numpy as np
from matplotlib.backend_bases import RendererBase
from matplotlib.path import Path
from numpy.typing import NDArray
from shapely import LineString, clip_by_rect, get_coordinates, get_parts

from ..drawing.scene import Fill, Item, Layer, Rect, Scene, Stroke, TextBox
from ..drawing.style import Dash, Hue
from ..figures.kind import hues
from ..typeset import Box, layout_words

MM = 72 / 25.4  # points in a millimetre
DPI = 25.4  # of the figures: a pixel is a millimetre


def record(figure: Any) -> Scene:
    """The scene of a figure of DPI dots per inch, with the figure's size as its extents."""
    width, height = (DPI * side for side in figure.get_size_inches())
    pen = Recorder(width, height)
    with matplotlib.rc_context({"path.simplify": True, "path.simplify_threshold": 0.004}):
        figure.draw(pen)
    return Scene(tuple(pen.items), Rect(0.0, 0.0, width, height))


class Recorder(RendererBase):
    """What matplotlib draws, collected as items in mm."""

    def __init__(self, width: float, height: float) -> None:
        super().__init__()
        self.width, self.height = width, height
        self.items: list[Item] = []

    def draw_path(self, gc: Any, path: Any, transform: Any, rgbFace: Any = None) -> None:
        """Lines, clipped to the axes; a closed path with a face is filled, over all lines."""
        layer = Layer.LINE
        if rgbFace is not None and len(rgbFace) and (len(rgbFace) < 4 or rgbFace[3] > 0):
            layer = Layer.JOINT
            for polygon in path.to_polygons(transform):
                self.items.append(Fill(points=tuple(_places(polygon)), hue=_hue(rgbFace), layer=layer))
        width = gc.get_linewidth() / MM
        if width <= 0 or (gc.get_rgb()[3] if len(gc.get_rgb()) > 3 else 1.0) == 0:
            return
        for points, closed in _lines(path, transform, gc.get_clip_rectangle()):
            self.items.append(
                Stroke(points=points, width=width, dash=_dash(gc), hue=_hue(gc.get_rgb()), closed=closed, layer=layer)
            )

    def draw_text(
        self, gc: Any, x: float, y: float, s: str, prop: Any, angle: float, ismath: Any = False, mtext: Any = None
    ) -> None:
        """Lettering on its baseline; text in a plot of the house never stands upright."""
        self.items.append(TextBox(box=_set(s, prop), x=float(x), y=float(y), hue=_hue(gc.get_rgb())))

    def draw_image(self, gc: Any, x: float, y: float, im: Any, transform: Any = None) -> None:
        """There are none."""

    def get_text_width_height_descent(self, s: str, prop: Any, ismath: Any) -> tuple[float, float, float]:
        """Extents of set type; all lines of a size are equally high, so that labels of a row share a baseline."""
        box, em = _set(s, prop), prop.get_size_in_points() / MM
        return box.width, 1.0 * em, 0.25 * em

    def get_canvas_width_height(self) -> tuple[float, float]:
        """mm."""
        return self.width, self.height

    def flipy(self) -> bool:
        """y upwards."""
        return False

    def points_to_pixels(self, points: Any) -> Any:
        """Points to mm."""
        return points / MM


def _set(text: str, prop: Any) -> Box:
    return layout_words(text, prop.get_size_in_points() / MM)


def _lines(path: Any, transform: Any, clip: Any) -> list[tuple[tuple[complex, ...], bool]]:
    """The polylines of a path with more than one point, and whether they are closed."""
    window = None if clip is None else (clip.x0, clip.y0, clip.x1, clip.y1)
    clean = path.cleaned(transform, remove_nans=True, clip=window, simplify=len(path.vertices) > 4000, curves=False)
    found: list[tuple[tuple[complex, ...], bool]] = []
    points: list[complex] = []
    for at, code in zip(_places(clean.vertices), clean.codes.tolist(), strict=True):
        if code == Path.LINETO:
            points.append(at)
            continue
        found += [(tuple(points), code == Path.CLOSEPOLY)] if len(points) > 1 else []
        points = [at] if code == Path.MOVETO else []
    found += [(tuple(points), False)] if len(points) > 1 else []
    return found if window is None else [one for line in found for one in _within(line, window)]


def _within(
    line: tuple[tuple[complex, ...], bool], window: tuple[float, ...]
) -> list[tuple[tuple[complex, ...], bool]]:
    """What of an open line lies in a window: Matplotlib leaves a pixel beyond its edge."""
    points, closed = line
    if closed:
        return [line]
    parts = get_parts(clip_by_rect(LineString([(at.real, at.imag) for at in points]), *window))
    return [(tuple(_places(get_coordinates(part))), False) for part in parts if part.length > 0]


def _places(xy: NDArray[np.float64]) -> list[complex]:
    """Pairs of coordinates as complex numbers."""
    found: list[complex] = np.ascontiguousarray(xy, dtype=np.float64).view(np.complex128).ravel().tolist()
    return found


def _hue(rgb: Any) -> Hue:
    """The nearest ink of the house."""
    return _nearest(*(float(part) for part in rgb[:3]))


@lru_cache(maxsize=256)
def _nearest(red: float, green: float, blue: float) -> Hue:
    wanted = np.array((red, green, blue))
    return min(hues(), key=lambda hue: float(np.abs(np.array(hue.value) - wanted).sum()))


def _dash(gc: Any) -> Dash:
    """The nearest pattern of the house, by its first stroke."""
    _, pattern = gc.get_dashes()
    if not pattern:
        return Dash.FULL
    return min(
        (dash for dash in Dash if dash.pattern),
        key=lambda dash: abs(dash.pattern[0] - pattern[0] / MM) + abs(len(dash.pattern) - len(pattern)),
    )
