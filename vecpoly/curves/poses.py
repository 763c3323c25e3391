"""The mechanism in four positions, each thin in an ink of its own, and thick in the problem's position."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..cycle import Cycle
from ..drawing.style import GIVEN, THIN, Dash, Hue
from ..figures.hue import TONES
from ..mechanism.model import Revolute
from ..names import subscripted
from ..words import Lang, Words
from . import style
from .flat import plane, told_station
from .place import Placer, Points
from .plot import Plot
from .skeleton import blocks, skeleton

COUNT = 4  # positions: more lie over each other
_OWN = style.Pen(Dash.FULL, Hue.BLACK, 1.4 * GIVEN)
_ANGLE = 3.0  # em of the lettering, mm


def poses(cycle: Cycle, letter: str, lang: Lang = "zh", *, width: float = 150.0, height: float = 105.0) -> Plot:
    """Every 90° of the drive (or at fifths of its range) the links as thin lines, in mm, with the drive's position at
    the pin of its crank (else at the letter); the problem's own position thick. Raises UnknownNameError."""
    phi = _quarters(cycle)
    lines, own = skeleton(cycle, phi), [line[:, 0] for line in skeleton(cycle, np.array([cycle.mech.drive.position]))]
    low, high = _corners([*lines, *own, 1e3 * np.array(list(cycle.mech.frame.values()), np.complex128)])
    figure, at = plane(low, high, width, height, (style.axis_label("x", "mm"), style.axis_label("y", "mm")))
    for k, hue in enumerate(TONES[:COUNT]):
        for line in lines:
            style.line(at, line[:, k].real, line[:, k].imag, style.Pen(Dash.FULL, hue, 1.3 * THIN))
    for line in own:
        style.line(at, line.real, line.imag, _OWN)
    slid = [*blocks(cycle, cycle.mech.drive.position)]
    style.blocks(at, slid, _OWN)
    placer = Placer(at, [*own, *(line[:, k] for line in lines for k in range(line.shape[1]))])
    placer.keep_clear(np.array([one.at for one in slid]), style.BLOCK.real / 2)
    _letters(cycle, at, letter, placer, (low + high) / 2)
    pin = _turned(cycle) or letter
    _angles(cycle, at, pin, phi, placer)
    where = subscripted(pin)
    return Plot(
        figure,
        Words(
            f"机构的几个位置（${where}$ 处为 ${cycle.drive.symbol}$）",
            f"Positions of the mechanism (${cycle.drive.symbol}$ at ${where}$)",
        ),
        lang,
    )


def _quarters(cycle: Cycle) -> NDArray[np.float64]:
    """The drive's positions that are drawn."""
    if cycle.mech.drive.slide or not cycle.whole:
        return np.linspace(cycle.low, cycle.high, COUNT + 2)[1:-1]
    return np.linspace(0.0, 2 * np.pi, COUNT, endpoint=False) + cycle.drive.zero


def _turned(cycle: Cycle) -> str:
    """The pin of the crank that drives, whose places lie all round its pivot; none of a drive that slides."""
    mech = cycle.mech
    pins = {joint.point for joint in mech.joints if isinstance(joint, Revolute)}
    moved = [one for one in mech.link(mech.drive.link).points if one in pins and one not in mech.frame]
    return moved[0] if moved and not mech.drive.slide else ""


def _corners(lines: Iterable[Points]) -> tuple[complex, complex]:
    """The lower left and the upper right corner of all these."""
    every = np.concatenate([line.ravel() for line in lines])
    every = every[np.isfinite(every)]
    return complex(every.real.min(), every.imag.min()), complex(every.real.max(), every.imag.max())


def _angles(cycle: Cycle, at: Any, letter: str, phi: NDArray[np.float64], placer: Placer) -> None:
    """The drive's position beside the letter's place in each, in the ink of its links."""
    spots = 1e3 * np.asarray(cycle.at(f"p_{letter}", phi), np.complex128)
    middle = complex(np.nanmean(spots))
    for q, z, hue in zip(phi, spots, TONES, strict=False):
        if np.isfinite(z):
            style.dots(at, [z.real], [z.imag], hue, 1.0)
            placer.put(complex(z), told_station(cycle, float(q)), complex(z) - middle, _ANGLE, hue=hue)


def _letters(cycle: Cycle, at: Any, letter: str, placer: Placer, middle: complex) -> None:
    """Open circles and letters at the fixed points and at the hinges of the position drawn thick."""
    mech = cycle.mech
    names = dict.fromkeys([*mech.frame, *(joint.point for joint in mech.joints if isinstance(joint, Revolute)), letter])
    places = {name: 1e3 * complex(np.asarray(cycle.at(f"p_{name}", [mech.drive.position]))[0]) for name in names}
    placer.keep_clear(np.array(list(places.values())), 0.9)
    for name, z in places.items():
        style.dots(at, [z.real], [z.imag], Hue.BLACK, 1.8 if name in mech.frame else 1.3, hollow=True)
        placer.put(z, f"${subscripted(name)}$", z - middle, style.LABEL)
