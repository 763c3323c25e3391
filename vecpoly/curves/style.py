"""How a plot looks: pens that differ in black and white, thin axes, a light grid, lettering of the house."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from matplotlib.figure import Figure
from matplotlib.patches import Polygon, Rectangle
from matplotlib.ticker import FixedLocator, FuncFormatter, MaxNLocator

from ..drawing.style import GIVEN, THIN, Dash, Hue
from ..figures import View
from ..typeset import layout_words
from .record import DPI, MM

WIDTH, PANEL = 150.0, 62.0  # mm
TICK, LABEL = 2.9, 3.15  # em of the lettering, mm: titles of axes as large as captions
_TICK_ROOM = 7.5  # mm from one number of an axis to the next, at the least
EDGE = 0.25  # mm: what stays of the ground inside the frame
RIGHT, TOP, FOOT = 7.0, 9.0, 10.2  # margins, mm
UNDER = 1.8  # mm from the lower edge to the title of the x axis, which stands close under its numbers
BLOCK = complex(5.6, 3.4)  # mm
LEFT = 16.0  # mm: what all numbers of a y axis have, so that graphs under each other have one left edge


@dataclass(frozen=True, slots=True)
class Pen:
    """A curve's line: mm."""

    dash: Dash
    hue: Hue
    width: float


PENS = (
    Pen(Dash.FULL, Hue.BLACK, 0.5),
    Pen(Dash.DASHED, View.VELOCITY.ink, 0.5),
    Pen(Dash.DASH_DOT, View.ACCELERATION.ink, 0.5),
    Pen(Dash.SHORT, View.FORCE.ink, 0.5),
    Pen(Dash.FULL, Hue.GREY, 0.3),
    Pen(Dash.DASHED, Hue.GREY, 0.3),
)


def sheet(width: float, height: float) -> Figure:
    """An empty figure of this size in mm, with no background."""
    figure = Figure(figsize=(width / 25.4, height / 25.4), dpi=DPI)
    figure.patch.set_visible(False)
    return figure


def axes(figure: Figure, x: float, y: float, width: float, height: float) -> Any:
    """Axes at a place in mm: thin frame, light grid, ticks inwards."""
    w, h = (DPI * side for side in figure.get_size_inches())
    made = figure.add_axes((x / w, y / h, width / w, height / h))
    made.patch.set_visible(False)
    made.grid(True, color=Hue.GHOST.value, linewidth=0.13 * MM, linestyle="-")
    made.set_axisbelow(True)
    made.tick_params(direction="in", length=1.2 * MM, width=THIN * MM, labelsize=TICK * MM, pad=1.2 * MM)
    for spine in made.spines.values():
        spine.set_linewidth(0.25 * MM)
    for axis in (made.xaxis, made.yaxis):
        axis.set_major_formatter(FuncFormatter(lambda value, _: number(value)))
        axis.set_major_locator(_round_steps())
        axis.set_label_coords(0.5, 0.5)  # it has none: no place is looked for beside the numbers
    return made


def _round_steps() -> MaxNLocator:
    return MaxNLocator(nbins=6, steps=[1, 2, 2.5, 5, 10])


def number(value: float, places: int | None = None) -> str:
    """A round number with a real minus, or a number to so many places."""
    text = f"{value:.8g}" if places is None else f"{value:.{places}f}"
    return ("0" if abs(value) < 1e-12 else text).replace("-", "−")


def line(at: Any, x: Any, y: Any, pen: Pen, label: str = "_") -> None:
    """A curve; where it has no value it is interrupted."""
    (drawn,) = at.plot(
        x,
        y,
        color=pen.hue.value,
        linewidth=pen.width * MM,
        label=label,
        solid_capstyle="round",
        solid_joinstyle="round",
    )
    if pen.dash.pattern:  # matplotlib counts dashes in line widths
        drawn.set_linestyle((0, tuple(part / pen.width for part in pen.dash.pattern)))


def zero_line(at: Any, limit: tuple[float, float]) -> None:
    """The level of zero in grey, where the axes hold it."""
    if limit[0] < 0 < limit[1]:
        at.axhline(0.0, color=Hue.GREY.value, linewidth=thickness() * MM, zorder=1)


def dots(at: Any, x: Any, y: Any, hue: Hue, size: float = 1.0, hollow: bool = False) -> None:
    """Small round marks, size in mm across; beyond the axes, where the curve is cut too, there are none."""
    across, up = np.asarray(x, dtype=float), np.asarray(y, dtype=float)
    inside = _within(across, *at.get_xlim()) & _within(up, *at.get_ylim())
    at.plot(
        across[inside],
        up[inside],
        linestyle="none",
        marker="o",
        markersize=size * MM,
        markerfacecolor=(Hue.WHITE if hollow else hue).value,
        markeredgecolor=hue.value,
        markeredgewidth=0.2 * MM,
        clip_on=False,
        zorder=2.6,
    )


def blocks(at: Any, places: Iterable[tuple[complex, complex]], pen: Pen) -> None:
    """The blocks of sliding joints: white, each of one size on paper; the middle (data) and which way it slides."""
    a, b = (complex(*at.transData.transform(spot)) for spot in ((0.0, 0.0), (1.0, 0.0)))
    for middle, along in places:
        half = along / abs(b - a)
        ends = [
            middle + half * complex(x * BLOCK.real, y * BLOCK.imag) / 2 for x, y in ((-1, -1), (1, -1), (1, 1), (-1, 1))
        ]
        at.add_patch(
            Polygon(
                [(z.real, z.imag) for z in ends],
                facecolor=Hue.WHITE.value,
                edgecolor=pen.hue.value,
                linewidth=pen.width * MM,
                zorder=2.5,
            )
        )


def _within(values: Any, low: float, high: float) -> Any:
    """Which values are not beyond an axis, or by a rounding only."""
    rim = 1e-6 * (high - low)
    return (low - rim <= values) & (values <= high + rim)


def text(
    at: Any,
    x: float,
    y: float,
    words: str,
    ha: str = "left",
    va: str = "baseline",
    size: float = LABEL,
    data: bool = False,
    hue: Hue = Hue.BLACK,
) -> None:
    """Lettering at a place in mm of the figure, or of the axes' data."""
    where = {"transform": at.transData} if data else {"transform": None}
    at.text(x, y, words, ha=ha, va=va, fontsize=size * MM, parse_math=False, clip_on=False, color=hue.value, **where)


def clear(at: Any, x: float, y: float, width: float, height: float) -> None:
    """White behind lettering (mm): grid and curves stop at it, the frame does not."""
    frame = at.bbox
    left, low = max(x, frame.x0 + EDGE), max(y, frame.y0 + EDGE)
    right, high = min(x + width, frame.x1 - EDGE), min(y + height, frame.y1 - EDGE)
    at.add_patch(
        Rectangle((left, low), right - left, high - low, transform=None, facecolor=Hue.WHITE.value, edgecolor="none")
    )


def axis_label(symbol: str, unit: str) -> str:
    """$ω$ / (rad/s), or the symbol alone of a pure number."""
    return f"${symbol}$" + (
        f" / ({unit})" if "/" in unit or "·" in unit or unit == "°" else f" / {unit}" if unit else ""
    )


def degrees_ticks(at: Any, low: float, high: float) -> None:
    """Round steps of degrees: thirds of right angles over a whole turn, or two thirds where these would crowd."""
    span, most = high - low, min(12.5, at.bbox.width / _TICK_ROOM)
    step = next(s for s in (1, 2, 5, 10, 15, 30, 60, 90, 180, 360, 720) if span / s <= most)
    at.xaxis.set_major_locator(
        FixedLocator(list(step * np.arange(np.ceil(low / step - 1e-9), np.floor(high / step + 1e-9) + 1)))
    )


def gutter(values: Sequence[float]) -> float:
    """Width in mm that the tick labels of a y axis with these limits take."""
    ticks = [t for t in _round_steps().tick_values(*values) if values[0] - 1e-9 <= t <= values[1] + 1e-9]
    return max((layout_words(number(t), TICK).width for t in ticks), default=0.0) + 3.0


def left_edge(limits: Iterable[tuple[float, float]]) -> float:
    """How far from the left a frame begins (mm): as far as all others, unless its numbers need more."""
    return max(LEFT, *(gutter(limit) + 1.0 for limit in limits))


def thickness() -> float:
    """Width of the zero line, mm."""
    return GIVEN / 2
