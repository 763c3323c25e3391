"""Values that are no columns of a cycle, over the drive's position: an energy, the speed of a true motion."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike

from ..cycle import Cycle
from ..drawing.style import Dash, Hue
from ..words import Lang, Words
from . import style
from .over import drive_label
from .peaks import label_peaks
from .plot import Plot


def given_values(
    cycle: Cycle,
    degrees: ArrayLike,
    values: ArrayLike,
    label: tuple[str, str],
    title: Words,
    lang: Lang = "zh",
    *,
    marks: tuple[tuple[float, float], ...] = (),
    level: float | None = None,
    width: float = style.WIDTH,
    panel: float = style.PANEL,
) -> Plot:
    """One line over the drive's angle in degrees. label: symbol and unit. level: a dashed line across.

    marks: of these the greatest and the least have a dot and their number.
    """
    x, y = np.asarray(degrees, np.float64), np.asarray(values, np.float64)
    margin = (0.15 if marks else 0.08) * (float(np.ptp(y)) or 1.0)
    limit = (float(y.min()) - margin, float(y.max()) + margin)
    figure = style.sheet(width, panel)
    left = style.left_edge([limit])
    room, foot = panel - style.FOOT - style.TOP, style.FOOT
    at = style.axes(figure, left, foot, width - left - style.RIGHT, room)
    at.set_xlim(0.0, float(np.degrees(cycle.period)))
    at.set_ylim(*limit)
    style.degrees_ticks(at, 0.0, float(np.degrees(cycle.period)))
    lines = [x + 1j * y]
    if level is not None:
        style.line(at, at.get_xlim(), [level] * 2, style.Pen(Dash.DASHED, Hue.GREY, 0.3))
        lines.append(np.array([complex(spot, level) for spot in at.get_xlim()]))
    style.zero_line(at, limit)
    style.line(at, x, y, style.PENS[0])
    label_peaks(at, lines, [marks], [style.PENS[0].hue], cycle.drive)
    style.text(at, 1.0, foot + room + 2.2, style.axis_label(*label))
    middle = left + (width - left - style.RIGHT) / 2
    style.text(at, middle, foot - style.FOOT + style.UNDER, drive_label(cycle.drive, lang), ha="center")
    return Plot(figure, title, lang)
