"""The mechanism in several positions, thin, with the path of a point, and thick in its own position."""

from __future__ import annotations

from typing import Any

import numpy as np

from ..cycle import Cycle
from ..drawing.style import GIVEN, THIN, Dash, Hue
from ..figures import View
from ..mechanism.model import Revolute
from ..names import subscripted
from ..words import Lang, Words
from . import style
from .flat import plane, stations
from .place import Placer
from .plot import Plot
from .skeleton import skeleton

_GHOST = style.Pen(Dash.FULL, Hue.GREY, 0.6 * THIN)
_OWN = style.Pen(Dash.FULL, Hue.BLACK, GIVEN)
_PATH = style.Pen(Dash.DASHED, View.ACCELERATION.ink, 0.4)


def poses(cycle: Cycle, letter: str, lang: Lang = "zh", *, width: float = 150.0, height: float = 105.0) -> Plot:
    """Every 30° of the drive (or at twelfths of its range) the links as thin lines, in mm; the path of the letter
    dashed, the problem's own position thick. Raises UnknownNameError."""
    phi, spots = stations(cycle, f"p_{letter}")
    lines, own = skeleton(cycle, phi), [line[:, 0] for line in skeleton(cycle, np.array([cycle.mech.drive.position]))]
    path = 1e3 * np.asarray(cycle.column(f"p_{letter}"), np.complex128)
    every = np.concatenate(
        [path, *(line.ravel() for line in (*lines, *own)), 1e3 * np.array(list(cycle.mech.frame.values()))]
    )
    every = every[np.isfinite(every)]
    low, high = complex(every.real.min(), every.imag.min()), complex(every.real.max(), every.imag.max())
    figure, at = plane(low, high, width, height, (style.axis_label("x", "mm"), style.axis_label("y", "mm")))
    for line in lines:
        for k in range(line.shape[1]):
            style.line(at, line[:, k].real, line[:, k].imag, _GHOST)
    style.line(at, path.real, path.imag, _PATH)
    for line in own:
        style.line(at, line.real, line.imag, _OWN)
    style.dots(at, 1e3 * spots.real, 1e3 * spots.imag, _PATH.hue, 0.9)
    placer = Placer(at, [path, *own, *(line[:, k] for line in lines for k in range(line.shape[1]))])
    _letters(cycle, at, letter, placer, (low + high) / 2)
    return Plot(
        figure,
        Words(
            f"机构的 {len(phi)} 个位置和 ${subscripted(letter)}$ 点的轨迹",
            f"{len(phi)} positions of the mechanism, and the path of ${subscripted(letter)}$",
        ),
        lang,
    )


def _letters(cycle: Cycle, at: Any, letter: str, placer: Placer, middle: complex) -> None:
    """Open circles and letters at the fixed points and at the hinges of the position drawn thick."""
    mech = cycle.mech
    names = dict.fromkeys([*mech.frame, *(joint.point for joint in mech.joints if isinstance(joint, Revolute)), letter])
    places = {name: 1e3 * complex(np.asarray(cycle.at(f"p_{name}", [mech.drive.position]))[0]) for name in names}
    placer.keep_clear(np.array(list(places.values())), 0.9)
    for name, z in places.items():
        style.dots(at, [z.real], [z.imag], Hue.BLACK, 1.8 if name in mech.frame else 1.3, hollow=True)
        placer.put(z, f"${subscripted(name)}$", z - middle, style.LABEL)
