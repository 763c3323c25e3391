"""A load that acts on one stroke only, such as a cutting force: where over the cycle it acts."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..cycle import Cycle, cycle
from ..errors import FaultError, UnknownNameError
from ..foundation.slotted import replace
from ..mechanism.loads import Force, Loads
from ..words import Words

Reals = NDArray[np.float64]
_STILL = 1e-9  # of the greatest speed: below, it stands


@dataclass(frozen=True, slots=True, kw_only=True)
class Works:
    """The load that acts on one stroke only, from one share of that stroke to another."""

    load: str
    begins: float = 0.0
    ends: float = 1.0


@dataclass(frozen=True, eq=False, kw_only=True)
class Working:
    """The cycle with all its loads and without the one that works on one stroke only; acts: where it does."""

    loaded: Cycle
    idle: Cycle
    acts: NDArray[np.bool_]
    force: Force | None = None

    def real(self, key: str) -> Reals:
        """A column: as loaded where the load acts, else as idle."""
        return np.where(self.acts, self.loaded.real(key), self.idle.real(key))

    def merged(self, keys: Sequence[str]) -> Cycle:
        """The cycle with these columns, and the parts of vectors, as they are while the load comes and goes: for tables
        and curves."""
        kept = {key: self._where(key) for one in keys for key in self._parts(one)}
        return replace(self.loaded, _kept=kept, _solved={})

    def _where(self, key: str) -> Any:
        return np.where(self.acts, self.loaded.column(key), self.idle.column(key))

    def _parts(self, key: str) -> tuple[str, ...]:
        vector = self.loaded.info(key).is_vector
        return (key, f"{key}.x", f"{key}.y", f"{key}.abs") if vector else (key,)

    @property
    def stretches(self) -> tuple[tuple[float, float], ...]:
        """The ranges of the drive (rad) in which the load acts, to the step of the grid."""
        edges = np.flatnonzero(np.diff(np.concatenate([[False], self.acts, [False]]).astype(np.int8)))
        phi = self.loaded.phi
        return tuple((float(phi[a]), float(phi[b - 1])) for a, b in zip(edges[::2], edges[1::2], strict=True))

    def at(self, phi: float) -> bool:
        """Whether the load acts at this position of the drive (rad): as at the nearest one of the grid."""
        turned = np.exp(1j * (self.loaded.phi - phi))
        return bool(self.acts[int(np.argmax(turned.real))])


def working(turn: Cycle, works: Works | None) -> Working:
    """Where such a load acts: where it resists, and between those shares of the stroke.

    Raises UnknownNameError where no force is called so, FaultError where it never resists.
    """
    if works is None or turn.loads is None:
        return Working(loaded=turn, idle=turn, acts=np.full(turn.phi.shape, True))
    force = _force(turn.loads, works.load)
    way = np.exp(1j * force.direction) * np.sign(force.size or 1.0)
    place, speed = ((turn.column(f"{stem}_{force.point}") * np.conj(way)).real for stem in "pv")
    done = (place.max() - place) / (np.ptp(place) or 1.0)  # it moves against the force
    acts = (speed < -_STILL * np.abs(speed).max()) & (done >= works.begins) & (done <= works.ends)
    if not acts.any() or np.ptp(place) < _STILL * turn.mech.scale:
        raise FaultError(
            Words(
                f"载荷 {works.load} 在整个循环内都不是阻力，或作用的范围太窄；请检查其方向和 from、to",
                f"load {works.load} resists nowhere over the cycle, or for too short a stretch; check its direction, "
                "and from and to",
            ),
            code="contradiction",
        )
    return Working(loaded=turn, idle=_without(turn, force), acts=acts, force=force)


def without(loads: Loads, force: Force) -> Loads:
    """The loads where this one does not act."""
    return replace(loads, forces=tuple(one for one in loads.forces if one != force))


def _without(turn: Cycle, force: Force) -> Cycle:
    assert turn.loads is not None
    return cycle(turn.mech, len(turn.phi), without(turn.loads, force))


def _force(loads: Loads, name: str) -> Force:
    told = [one for one in loads.forces if one.size is not None and one.along is None]
    found = next((one for one in told if one.name == name), None)
    if found is None:
        known = ", ".join(one.name for one in told) or "–"
        raise UnknownNameError(
            Words(
                f"没有已知大小的力“{name}”；已有：{known}", f"no force of known size is called '{name}'; known: {known}"
            ),
            code="unknown-name",
        )
    return found
