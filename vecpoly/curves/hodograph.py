"""The hodograph: all velocities (or accelerations) of a point from one pole."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..cycle import Cycle
from ..drawing.style import Dash, Hue
from ..errors import NotAskedError
from ..figures import View
from ..words import Lang, Words
from . import style
from .flat import mark_stations, plane
from .place import Placer
from .plot import Plot
from .record import MM


def hodograph(
    cycle: Cycle, key: str, lang: Lang = "zh", *, width: float = 90.0, height: float = 90.0, ink: Hue | None = None
) -> Plot:
    """The end of the vector v_E or a_E, laid off from the pole p, over the cycle; dots every 30° of the drive.

    ink: of the vector, where it has one wherever it appears; else that of its kind.

    Raises NotAskedError for a quantity that is no vector, UnknownNameError.
    """
    info = cycle.info(key)
    if not info.is_vector:
        raise NotAskedError(
            Words(
                f"{key} 不是矢量，不能作矢端图；请用 v_E 或 a_E 之类的量",
                f"{key} is no vector: a hodograph needs one, such as v_E or a_E",
            )
        )
    values = info.factor * np.asarray(cycle.column(key), np.complex128)
    known = values[np.isfinite(values)]
    if not known.size:
        raise NotAskedError(Words(f"{key} 在任何位置都无值", f"{key} has no value in any position"))
    low = complex(min(known.real.min(), 0.0), min(known.imag.min(), 0.0))
    high = complex(max(known.real.max(), 0.0), max(known.imag.max(), 0.0))
    labels = tuple(style.axis_label(cycle.info(f"{key}.{part}").symbol, info.shown_unit) for part in "xy")
    figure, at = plane(low, high, width, height, (labels[0], labels[1]))
    for draw in (at.axhline, at.axvline):
        draw(0.0, color=Hue.GREY.value, linewidth=style.thickness() * MM, zorder=1)
    hue = ink or _kind(key)
    style.line(at, values.real, values.imag, style.Pen(Dash.FULL, hue, 0.5))
    mark_stations(cycle, at, _placer(at, values), key, info.factor, hue)
    style.dots(at, [0.0], [0.0], Hue.BLACK, 1.4, hollow=True)
    return Plot(figure, Words(f"${info.symbol}$ 的矢端曲线", f"Hodograph of ${info.symbol}$"), lang)


def _kind(key: str) -> Hue:
    """The ink of velocities, of accelerations, of forces."""
    return View.VELOCITY.ink if key[0] == "v" else View.ACCELERATION.ink if key[0] == "a" else View.FORCE.ink


def _placer(at: Any, values: NDArray[np.complex128]) -> Placer:
    """The curve, the axes through the pole and the pole itself are in the way of lettering."""
    (x0, x1), (y0, y1) = at.get_xlim(), at.get_ylim()
    made = Placer(at, [values, np.array([x0, x1], np.complex128), 1j * np.array([y0, y1])])
    made.keep_clear(np.zeros(1, np.complex128), 0.8)
    return made
