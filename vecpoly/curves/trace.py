"""Paths of points, with the frame's points and the mechanism at its own position."""

from __future__ import annotations

from typing import Any

import numpy as np

from ..cycle import Cycle, Shape
from ..cycle.facts.path import shape_of
from ..drawing.style import THIN, Dash, Hue
from ..errors import NotAskedError
from ..mechanism.model import Revolute
from ..names import subscripted
from ..words import Lang, Words
from . import style
from .flat import mark_stations, plane
from .place import Placer
from .plot import Plot
from .skeleton import blocks, skeleton

LINKS = style.Pen(Dash.FULL, Hue.GREY, THIN)


def trace(
    cycle: Cycle, points: tuple[str, ...], lang: Lang = "zh", *, width: float = 120.0, height: float = 110.0
) -> Plot:
    """The paths of these letters, in mm; dots every 30° of the drive on the first, the mechanism in thin lines.

    Raises NotAskedError for no letter or more than six, UnknownNameError.
    """
    if not 0 < len(points) <= len(style.PENS):
        raise NotAskedError(
            Words(
                f"{len(points)} 条轨迹；请指定 1 至 {len(style.PENS)} 个点",
                f"{len(points)} paths: name one to {len(style.PENS)} points",
            )
        )
    paths = [1e3 * np.asarray(cycle.column(f"p_{letter}"), np.complex128) for letter in points]
    lines = [line[:, 0] for line in skeleton(cycle, np.array([cycle.mech.drive.position]))]
    every = np.concatenate([*paths, *lines, 1e3 * np.array(list(cycle.mech.frame.values()))])
    every = every[np.isfinite(every)]
    low, high = complex(every.real.min(), every.imag.min()), complex(every.real.max(), every.imag.max())
    figure, at = plane(low, high, width, height, (style.axis_label("x", "mm"), style.axis_label("y", "mm")))
    for line in lines:
        style.line(at, line.real, line.imag, LINKS)
    slid = [*blocks(cycle, cycle.mech.drive.position)]
    style.blocks(at, slid, LINKS)
    for path, pen in zip(paths, style.PENS, strict=False):
        once = _once(path) if _swept_twice(path) else path
        style.line(at, once.real, once.imag, pen)
    placer = Placer(at, [*paths, *lines])
    letters = _joints(cycle, at, points)
    placer.keep_clear(np.array(list(letters.values())), 0.9)
    placer.keep_clear(np.array([one.at for one in slid]), style.BLOCK.real / 2)
    for letter, place in letters.items():
        placer.put(place, f"${subscripted(letter)}$", place - (low + high) / 2, style.LABEL)
    mark_stations(cycle, at, placer, f"p_{points[0]}", 1e3, style.PENS[0].hue)
    names = "、".join(f"${subscripted(letter)}$" for letter in points)
    return Plot(figure, Words(f"点 {names} 的轨迹", f"Path of {names.replace('、', ', ')}"), lang)


def _swept_twice(path: Any) -> bool:
    """Whether the path is a line or an arc that the point runs to and fro."""
    known = path[np.isfinite(path)]
    size = float(np.abs(known - known.mean()).max())
    if not size:
        return False
    found = shape_of(known, np.gradient(known), size)
    return found in (Shape.LINE, Shape.ARC) or (found is Shape.CIRCLE and abs(known[-1] - known[0]) > 1e-9 * size)


def _once(path: Any) -> Any:
    """A path swept to and fro, drawn once: its points in order of their signed way along it."""
    known = path[np.isfinite(path)]
    step = np.diff(known)
    back = np.append(1.0, np.where((np.conj(step[:-1]) * step[1:]).real < 0, -1.0, 1.0))
    way = np.append(0.0, np.cumsum(np.cumprod(back) * np.abs(step)))
    return known[np.argsort(way)]


def _joints(cycle: Cycle, at: Any, points: tuple[str, ...]) -> dict[str, complex]:
    """Open circles at the frame's points, the hinges and the traced points of the mechanism as it stands;
    their places (mm)."""
    mech = cycle.mech
    letters = dict.fromkeys(
        [*mech.frame, *(joint.point for joint in mech.joints if isinstance(joint, Revolute)), *points]
    )
    found = {letter: 1e3 * complex(np.asarray(cycle.at(f"p_{letter}", [mech.drive.position]))[0]) for letter in letters}
    for letter, z in found.items():
        style.dots(at, [z.real], [z.imag], Hue.BLACK, 1.8 if letter in mech.frame else 1.3, hollow=True)
    return found
