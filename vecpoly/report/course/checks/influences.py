"""What a given dimension does to the output when it is a little larger than given, and how far it may go."""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache
from math import radians

import numpy as np
from numpy.typing import NDArray

from ....cycle.pose import placed
from ....cycle.sample import sample
from ....errors import VecpolyError
from ....findings.given_lengths import Dimension, given_dimensions
from ....findings.output_links import ends, motions
from ....findings.study.from_pivots import from_pivots
from ....findings.study.study import Study
from ....mechanism.model import Mechanism

CHANGE = (1e-4, radians(0.1))  # m, rad: of a length, of an angle
KEPT = 4  # studies met last, each told in two languages and of several chapters
REACH = 20  # changes within which the mechanism is tried
_SOUGHT, _COARSE, _HALVINGS, _FINE, NOTHING = 1440, 180, 8, 40, 1e-9
Reals = NDArray[np.float64]
Span = tuple[float, float]  # of the input link


@dataclass(frozen=True, slots=True)
class Influence:
    """What a dimension larger by CHANGE does to each quantity of the output (SI,
    at most over the cycle), unless positions are lost.

    least, most: changes (m, rad) at which the cycle can no longer be run through, and where on it;
    None where REACH changes do no harm. fitted: the least change either way loses every position, for other dimensions
    fix this one: a rack lies where its gear is.
    """

    dimension: Dimension
    gaps: tuple[float, ...]
    lost: Span | None
    least: tuple[float, float] | None
    most: tuple[float, float] | None
    fitted: bool = False

    @property
    def matters(self) -> bool:
        """Whether the output depends on it at all."""
        return bool(self.lost or self.least or self.most) or max(self.gaps) > NOTHING


def targets(study: Study) -> tuple[str, ...]:
    """Keys of the output: place, speed and acceleration of the last output link;
    of a mechanism without one, of its last point."""
    for link in reversed(ends(study)):
        if keys := motions(study, link):
            pair = keys[0].partition("_")[2]
            return (f"phi_{link}" if keys[0].startswith(("omega", "alpha")) else f"s_{pair}", *keys)
    letter = study.points[-1]
    axis = max("xy", key=lambda part: float(np.ptp(np.nan_to_num(study.turn.real(f"p_{letter}.{part}")))))
    return tuple(f"{stem}_{letter}.{axis}" for stem in "pva")


@lru_cache(maxsize=KEPT)
def influences(study: Study) -> tuple[Influence, ...]:
    """Every given dimension changed alone, in the order of the problem."""
    keys = targets(study)
    written = frozenset(d.symbol for d in study.problem.given.lengths)
    found = []
    standing = placed(study.problem.mechanism)  # of what is a rhombus no more both assemblies may fit
    for one in given_dimensions(standing, written):
        unit = CHANGE[one.is_angle]
        lost = lost_range(study, one, unit)
        if lost == whole(study) == lost_range(study, one, -unit):
            found.append(Influence(one, (), lost, None, None, fitted=True))
            continue
        found.append(
            Influence(
                one,
                () if lost else _greatest(study, from_pivots(one.enlarged(unit)), keys),
                lost,
                _limit(study, one, -unit),
                _limit(study, one, unit),
            )
        )
    return tuple(found)


def _greatest(study: Study, changed: Mechanism, keys: tuple[str, ...]) -> tuple[float, ...]:
    """The largest |changed − given| of each quantity over the cycle:
    the largest on the grid, sought more closely between its neighbours."""
    phi = study.turn.phi
    after = sample(changed, None, phi)
    tops = [int(np.nanargmax(np.abs(_gap(key, study.turn.real(key), np.asarray(after.value(key)))))) for key in keys]
    near = np.concatenate(
        [np.linspace(phi[max(top - 1, 0)], phi[min(top + 1, len(phi) - 1)], _FINE + 1) for top in tops]
    )
    one, two = sample(study.mech, None, near), sample(changed, None, near)
    cuts = [slice(i * (_FINE + 1), (i + 1) * (_FINE + 1)) for i in range(len(keys))]
    return tuple(
        float(np.nanmax(np.abs(_gap(key, np.asarray(one.value(key)), np.asarray(two.value(key)))[cut])))
        for key, cut in zip(keys, cuts, strict=True)
    )


def _gap(key: str, before: Reals, after: Reals) -> Reals:
    return np.asarray(np.angle(np.exp(1j * (after - before))) if key.startswith("phi") else after - before)


def whole(study: Study) -> Span:
    """All positions of the input link."""
    if study.whole.whole:
        return study.whole.low, study.whole.high
    return float(study.turn.phi[0]), float(study.turn.phi[-1])


def lost_range(study: Study, one: Dimension, change: float) -> Span | None:
    """Where in the cycle the mechanism cannot be assembled with a dimension changed by so much (m, rad): the widest
    range; None where it can everywhere."""
    phi = np.linspace(*whole(study), (_SOUGHT if study.model.closed else _COARSE) + 1)
    try:
        changed = one.enlarged(change)
        good = _stands(changed, phi)
    except (VecpolyError, ValueError):  # no triangle, no position at all
        good = np.zeros(phi.shape, bool)
    if good.all() or not good.any():
        return None if good.all() else whole(study)
    turn = phi[-1] - phi[0] if study.whole.whole else 0.0
    if turn:  # begin where it stands, so that no range lies across the ends
        first = int(np.argmax(good))
        phi, good = (
            np.concatenate([phi[first:-1], phi[: first + 1] + turn]),
            np.concatenate([good[first:-1], good[: first + 1]]),
        )
    step = np.diff(np.concatenate([[False], ~good, [False]]).astype(int))
    starts, stops = np.flatnonzero(step == 1), np.flatnonzero(step == -1)
    k = int(np.argmax(stops - starts))
    return _edge(changed, phi, starts[k] - 1, starts[k]), _edge(changed, phi, stops[k], stops[k] - 1)


def _stands(mech: Mechanism, phi: Reals) -> NDArray[np.bool_]:
    motion = sample(mech, None, phi, order=0).motion
    return np.asarray(np.logical_and.reduce([np.isfinite(motion.angle(name)) for name in mech.bodies]))


def _edge(mech: Mechanism, phi: Reals, inside: int, outside: int) -> float:
    """The end of a range that can be assembled, between two positions of the grid;
    the grid's own end where there is none."""
    if not 0 <= inside < len(phi):
        return float(phi[outside])
    low, high = float(phi[inside]), float(phi[outside])
    for _ in range(_HALVINGS):
        middle = (low + high) / 2
        low, high = (middle, high) if _stands(mech, np.array([middle]))[0] else (low, middle)
    return low


def _limit(study: Study, one: Dimension, unit: float) -> tuple[float, float] | None:
    """The least change of this sign at which positions are lost, by halving,
    and the position first lost; None within REACH changes."""
    # loops solved by Newton's method: too slow to try
    high, low, where = (REACH * unit, 0.0, lost_range(study, one, REACH * unit) if study.model.closed else None)
    if where is None:
        return None
    for _ in range(_HALVINGS):
        middle = (low + high) / 2
        span = lost_range(study, one, middle)
        low, high, where = (middle, high, where) if span is None else (low, middle, span)
    return high, sum(where) / 2
