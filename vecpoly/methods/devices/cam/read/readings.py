"""Lengths and angles of a cam as they are read: millimetres of the cam, degrees."""

from __future__ import annotations

import numpy as np

from .....algebra.quantity import Quantity, magnitude
from .....algebra.worked import stated
from .....board.construction import Place, Reading
from .....devices.cams.asked import least_polar
from .....devices.cams.cam import Cam
from .....names import Named
from .....plane import Points, Reals, nominal
from ...bench import Bench, with_sign


def length(bench: Bench, named: Named, place: Place, a: Points, b: Points, letters: str, sign: int = 1) -> Quantity:
    """Read a length off the paper, times μ_l: written into the step, in mm."""
    board, scale = bench.board, bench.board.scale_of(place)
    on_paper = board.measure(a, b, letters)
    mu = magnitude(scale.symbol, 1e3 * scale.value, "mm/mm")
    found = bench.worked(named, with_sign(mu * on_paper, sign))
    bench.read_off(named, place, on_paper, letters)
    return found


def noted(
    bench: Bench, named: Named, value: Reals, mm: Reals | None = None, line: str = "", scale: str = ""
) -> Quantity:
    """Keep a value read at a station, of which there are many: they are written in rows."""
    found = magnitude(named.symbol, value, named.unit)
    reading = Reading(
        key=named.key,
        symbol=named.symbol,
        unit=named.unit,
        scalar=float(nominal(value)),
        mm=None if mm is None else float(nominal(mm)),
        line=line,
        scale=scale,
        formula=stated(found),
    )
    bench.board.keep(reading, value)
    return found


def acute(bench: Bench, one: Points, other: Points) -> Reals:
    """The acute angle between two lines, read off the protractor (deg)."""
    read = np.degrees(np.abs(bench.board.gauge(0j, other / one)))
    return 90.0 - np.abs(90.0 - read)


def turned(bench: Bench, cam: Cam, phi: float, first: Points, point: Points) -> Reals:
    """From the ray to the profile's first point round to that of a station, counter-clockwise (deg)."""
    least = least_polar(phi, cam.sense)
    return np.mod(np.degrees(bench.board.gauge(0j, point / first)) - least, 360.0) + least
