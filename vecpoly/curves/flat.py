"""Plots in a plane with one measure in both directions: hodographs and paths."""

from __future__ import annotations

from typing import Any

import numpy as np
from matplotlib.figure import Figure
from matplotlib.ticker import MultipleLocator
from numpy.typing import NDArray

from ..cycle import Cycle
from ..typeset import layout_words
from . import style
from .place import Placer

Points = NDArray[np.complex128]


def plane(low: complex, high: complex, width: float, height: float, labels: tuple[str, str]) -> tuple[Figure, Any]:
    """Axes of equal measure that hold this box (in shown units) within width × height mm; the sheet is cut to them."""
    span = high - low
    margin = 0.09 * max(span.real, span.imag)
    low, high = low - complex(margin, margin), high + complex(margin, margin)
    span = high - low
    left = max(layout_words(style.number(float(round(v, 0))), style.TICK).width for v in (low.imag, high.imag)) + 6.0
    scale = min((width - left - style.RIGHT) / span.real, (height - style.FOOT - style.TOP) / span.imag)
    wide, tall = span.real * scale, span.imag * scale
    full = max(left + wide + style.RIGHT, 60.0)
    figure = style.sheet(full, tall + style.FOOT + style.TOP)
    at = style.axes(figure, left, style.FOOT, wide, tall)
    at.set_xlim(low.real, high.real)
    at.set_ylim(low.imag, high.imag)
    step = _step(10.0 / scale)
    for axis in (at.xaxis, at.yaxis):
        axis.set_major_locator(MultipleLocator(step))
    style.text(at, 1.0, style.FOOT + tall + 2.2, labels[1])
    style.text(at, left + wide / 2, style.UNDER, labels[0], ha="center")
    return figure, at


def _step(least: float) -> float:
    """The smallest of 1, 2, 5 × 10ⁿ that is not below this."""
    power = 10.0 ** np.floor(np.log10(least))
    return float(next(k * power for k in (1, 2, 5, 10) if k * power >= least * (1 - 1e-9)))


def stations(cycle: Cycle, key: str) -> tuple[NDArray[np.float64], Points]:
    """The drive's positions every 30° (or twelfths of its range), and the vector there."""
    if cycle.mech.drive.slide or not cycle.whole:
        phi = np.linspace(cycle.low, cycle.high, 13)[1:-1]
    else:
        phi = np.radians(np.arange(0.0, 360.0, 30.0))
    return phi, np.asarray(cycle.at(key, phi), np.complex128)


def mark_stations(cycle: Cycle, at: Any, placer: Placer, key: str, factor: float, hue: Any, every: int = 2) -> None:
    """Dots at the stations; every second one with its angle, on the outer side of the curve if there is room."""
    phi, places = stations(cycle, key)
    places = factor * places
    style.dots(at, places.real, places.imag, hue, 0.9)
    placer.keep_clear(places[np.isfinite(places)], 0.5)
    tangent = np.asarray(cycle.at(key, phi + 1e-4)) - np.asarray(cycle.at(key, phi - 1e-4))
    middle = complex(np.nanmean(places.real), np.nanmean(places.imag))
    for q, z, d in list(zip(phi, places, tangent, strict=True))[::every]:
        if not np.isfinite(z):
            continue
        normal = 1j * d
        outward = -normal if (np.conj(normal) * (z - middle)).real < 0 else normal
        placer.put(z, told_station(cycle, float(q)), outward, 2.8)


def told_station(cycle: Cycle, phi: float) -> str:
    """A position of the drive, to a tenth."""
    return style.number(round(cycle.drive.told(phi), 1)) + ("°" if cycle.drive.unit == "rad" else "")
