"""The two ends of a point's stroke, found by drawing the mechanism in many places of its drive on scratch paper."""

from __future__ import annotations

from collections.abc import Callable
from functools import lru_cache
from itertools import pairwise

import numpy as np

from ....board.construction import View
from ....errors import EquilibriumError, VecpolyError
from ....mechanism.laws.told import no_stroke
from ....mechanism.model import Mechanism
from ....names import At
from ....plane import dot, nominal
from ...kinematics.doors import draw_drives, draw_group
from ...kinematics.image import found_tip
from ...positions.following import Follower, follower
from ...positions.laps import MOST, laps
from ...registry import Stage
from ...roots import halved

TRIALS = 72  # places of the drive
HALVINGS = 48


def stroke(mech: Mechanism, link: str, point: str, direction: float) -> tuple[float, float]:
    """Least and greatest coordinate of a point along a direction (m); EquilibriumError where it has no stroke."""
    low, high = _stroke(follower(mech), link, point, direction)
    if (why := no_stroke(link, point, direction, high - low, mech.scale)) is not None:
        raise EquilibriumError(why, code="contradiction")
    return low, high


@lru_cache(maxsize=128)
def _stroke(way: Follower, link: str, point: str, direction: float) -> tuple[float, float]:
    """Both ends: at the dead centres, where the velocity turns round, or where the drive comes to its own end."""
    drive = way.mech.drive
    own, step = drive.position, (way.mech.scale / 18 if drive.slide else 2 * np.pi / TRIALS)
    seen: dict[float, tuple[float, float] | None] = {}

    def seen_at(at: float) -> tuple[float, float] | None:
        if at not in seen:
            seen[at] = _seen(way, at, link, point, direction)
        return seen[at]

    ahead, behind = ([own + sense * step * k for k in range(1, TRIALS * MOST + 1)] for sense in (1, -1))
    if seen_at(own) is None:
        return 0.0, 0.0
    if not drive.slide and all(seen_at(at) is not None for at in ahead[:TRIALS]):
        return _ends([own, *ahead[: TRIALS * laps(way.mech)]], seen_at)
    reach = [*_reached(behind, seen_at)[::-1], own, *_reached(ahead, seen_at)]
    return _ends(sorted([*reach, *_edges(reach, step, seen_at)]), seen_at)


Drawn = Callable[[float], tuple[float, float] | None]


def _seen(way: Follower, at: float, link: str, point: str, direction: float) -> tuple[float, float] | None:
    """Coordinate (m) and velocity of the point along the direction in this place of the drive; None where there is
    none."""
    try:
        desk, groups = way.drawn(at)
        draw_drives(desk, Stage.VELOCITY)
        for group in groups:
            draw_group(desk, Stage.VELOCITY, group)
        along = complex(np.exp(1j * direction))
        place = float(nominal(dot(along, desk.where(At(point, link))))) / desk.mm(1.0)
        return place, float(nominal(dot(along, found_tip(desk, View.VELOCITY, At(point, link)))))
    except VecpolyError:
        return None


def _reached(places: list[float], drawn: Drawn) -> list[float]:
    """As far as the mechanism can be drawn."""
    found: list[float] = []
    for at in places:
        if drawn(at) is None:
            break
        found.append(at)
    return found


def _edges(reach: list[float], step: float, drawn: Drawn) -> list[float]:
    """The last places at both ends of a range, where the links only just meet."""
    found = []
    for inside, way in ((reach[0], -1), (reach[-1], 1)):
        outside = inside + way * step
        for _ in range(HALVINGS):
            middle = (inside + outside) / 2
            inside, outside = (inside, middle) if drawn(middle) is None else (middle, outside)
        found.append(inside)
    return found


def _ends(places: list[float], drawn: Drawn) -> tuple[float, float]:
    """The least and the greatest coordinate, between trials at the place where the velocity turns round."""
    found = [one[0] for at in places if (one := drawn(at)) is not None]
    for low, high in pairwise(places):
        a, b = drawn(low), drawn(high)
        if a is not None and b is not None and a[1] * b[1] < 0:
            turn = drawn(halved(lambda at: (drawn(at) or (0.0, 0.0))[1], low, high, HALVINGS))
            found += [] if turn is None else [turn[0]]
    return min(found), max(found)
