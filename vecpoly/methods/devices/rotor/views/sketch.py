"""The rotor as it is drawn: along its axis, with planes and masses, and from its end, with r and θ."""

from __future__ import annotations

from math import degrees, radians, tau

import numpy as np

from .....devices.balancing.plane import RotorPlane
from .....devices.balancing.rotor import Rotor
from .....plane import nominal
from .....words import Words
from ...bench import Bench
from ..polygon import Polygon
from .along import added_beside, along
from .ends import added_seen, from_its_end


def sketch(bench: Bench, rotor: Rotor) -> None:
    """Both views; the one along the axis only where there is a length."""
    bench.board.section(Words("转子简图", "The rotor"))
    if rotor.length > 0:
        along(bench, rotor)
    from_its_end(bench, rotor)


def added(bench: Bench, rotor: Rotor, end: str, polygon: Polygon, plane: RotorPlane) -> None:
    """What balances the plane, drawn into the views: a weight, or the hole opposite to it."""
    if abs(complex(nominal(polygon.tip))) < 1e-6:
        return
    way = float(np.angle(nominal(-polygon.tip)))
    turns = [way] if plane.hole is None else [way + tau / 2 + side for side in _sides(plane)]
    two = [f"m{prime}_{{h{end}}}" for prime in ("′", "′′")]
    _drawn_in(bench, rotor, end, plane, turns, [f"m_{{b{end}}}"] if len(turns) == 1 else two)


def _sides(plane: RotorPlane) -> tuple[float, ...]:
    return (0.0,) if plane.spread is None else (plane.spread.si, -plane.spread.si)


def placed(bench: Bench, rotor: Rotor, end: str, at: tuple[float, float], plane: RotorPlane) -> None:
    """The weights at fixed places (deg), drawn into the views."""
    labels = [f"m_{{b{end},{which}}}" for which in (1, 2)]
    _drawn_in(bench, rotor, end, plane, [radians(turn) for turn in at], labels)


def _drawn_in(bench: Bench, rotor: Rotor, end: str, plane: RotorPlane, turns: list[float], labels: list[str]) -> None:
    added_seen(bench, rotor, end, plane, [degrees(turn) for turn in turns], labels)
    added_beside(bench, rotor, plane, turns, labels)
