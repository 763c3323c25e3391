"""A mechanism over its whole cycle: one column of numbers for every quantity."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from .. import oracle
from ..foundation.slotted import replace
from ..mechanism.loads import Loads
from ..mechanism.model import Mechanism
from .column import Column
from .columns import catalogue, column_of, drive_column
from .follow import follow
from .frame import frame
from .grid import places
from .sample import Sample, reader, sample

Points = NDArray[np.complex128]
Reals = NDArray[np.float64]
BLOCK = 4096
FEW = 256  # positions, and solved samples, that are kept
FINE = 720  # steps a turn within which no link turns half round between two of them


@dataclass(frozen=True, eq=False)
class Cycle:
    """A mechanism at n positions of its drive.

    phi: the drive's position: rad over one revolution (both ends, 0 and 2π, are there; over two where the loads of a
    four-stroke engine need them) or over the range in which a rocking input can move; m for a sliding input. whole:
    whether the drive can turn right round. low, high: the ends of its range.
    """

    name: str
    mech: Mechanism
    loads: Loads | None
    phi: Reals
    low: float
    high: float
    whole: bool
    points: tuple[str, ...] | None = None
    machine: Loads | None = None  # what acts where nothing balances it: on a machine, or under counterweights
    _kept: dict[str, Points | Reals] = field(default_factory=dict, repr=False)
    _solved: dict[tuple[tuple[int, ...], bytes], Sample] = field(default_factory=dict, repr=False)
    _infos: dict[str, Column] = field(default_factory=dict, repr=False)

    @cached_property
    def columns(self) -> tuple[Column, ...]:
        """What a whole-cycle table holds: links, points, slides, transmission angles,
        with loads what balances and what presses."""
        return catalogue(self.mech, self.acting, self.points)

    @property
    def acting(self) -> Loads | None:
        """What acts, balanced or not."""
        return self.machine if self.loads is None else self.loads

    def under(self, acting: Loads) -> Cycle:
        """The same turn under other loads, balanced or not as its own are; nothing that was found is kept."""
        loads, machine = (None, acting) if self.loads is None else (acting, self.machine)
        return replace(self, loads=loads, machine=machine, _kept={}, _solved={}, _infos={})

    @cached_property
    def samples(self) -> tuple[Sample, ...]:
        """All solved positions, in blocks that fit into the processor's cache; kept, for columns to come."""
        return tuple(self._blocks())

    def _blocks(self) -> Iterator[Sample]:
        for i in range(0, len(self.phi), BLOCK):
            yield sample(self.mech, self.acting, self.phi[i : i + BLOCK])

    def solved(self, key: str) -> Points | Reals:
        """The quantity at every position as the solver gives it: angles within -π..π."""
        read = reader(self.mech, self.acting, key)
        parts = [read(block) for block in self.samples]
        whole: Points = np.concatenate(parts) if len(parts) > 1 else parts[0]  # type: ignore[assignment]
        return whole

    def read(self, *keys: str) -> tuple[Points | Reals, ...]:
        """Several columns in one pass that keeps no solved position but these columns:
        for tens of thousands of positions."""
        missing = [key for key in dict.fromkeys(keys) if key not in self._kept and key != self.drive.key]
        if len(self.phi) > BLOCK and missing:
            readers = [reader(self.mech, self.acting, key) for key in missing]
            parts = [[read(block) for read in readers] for block in self._blocks()]
            for key, pieces in zip(missing, zip(*parts, strict=True), strict=True):
                whole = np.concatenate(pieces)
                self._kept[key] = follow(whole.real) if self.info(key).turns else whole
        return tuple(self.column(key) for key in keys)

    @cached_property
    def ranges(self) -> tuple[str, ...]:
        """Where the drive can stand, as text: 0..360 deg."""
        return oracle.feasible(self.mech)

    @property
    def drive(self) -> Column:
        """The drive's position: φ_1, s_1 of a sliding input, s_23 of a cylinder."""
        return drive_column(self.mech)

    @property
    def assembled(self) -> NDArray[np.bool_]:
        """Which positions can be assembled and have velocities."""
        sound: NDArray[np.bool_] = np.logical_and.reduce(
            [np.isfinite(self.column(f"omega_{name}")) for name in self.mech.numbered]
        )
        return sound

    def info(self, key: str) -> Column:
        """Symbol, unit and words of a column; UnknownNameError where there is none."""
        if key not in self._infos:
            self._infos[key] = self.drive if key == self.drive.key else column_of(self.mech, self.acting, key)
        return self._infos[key]

    def column(self, key: str) -> Points | Reals:
        """The quantity at every position: complex for a vector, SI;
        angles without jumps of 360°; NaN where it does not exist.

        Raises UnknownNameError for a key that this mechanism does not have, EquilibriumError for a force without loads.
        """
        if key == self.drive.key:
            return self.phi
        if key not in self._kept:
            self._kept[key] = self._followed(key) if self.info(key).turns else self.solved(key)
        return self._kept[key]

    def arrays(self, *keys: str) -> dict[str, NDArray[Any]]:
        """The drive's position and these columns (all where none is named) as numpy arrays, SI; vectors are complex."""
        names = keys or tuple(column.key for column in self.columns)
        return {key: np.asarray(self.column(key)) for key in dict.fromkeys((self.drive.key, *names))}

    def to_frame(self, *keys: str) -> Any:
        """The same as a pandas DataFrame over the drive's position; a vector is two columns, v_C.x and v_C.y."""
        return frame(self.arrays(*keys))

    def real(self, key: str) -> Reals:
        """The column as real numbers: a vector's magnitude."""
        values = self.column(key)
        return np.abs(values) if np.iscomplexobj(values) else np.asarray(values, np.float64)

    def at(self, key: str, phi: ArrayLike) -> Points | Reals:
        """The quantity at any positions of the drive, solved there; an angle lies on the same turn as the column."""
        places = np.asarray(phi, dtype=np.float64)
        return places if key == self.drive.key else self._on_turn(key, places, self._sampled(places).value(key))

    def _sampled(self, places: Reals) -> Sample:
        """The mechanism solved at these positions; with loads, or where it is iterated, the last few are kept, for all
        columns break off at the same ones."""
        if places.size > FEW or (self.acting is None and not oracle.is_iterated(self.mech)):
            return sample(self.mech, self.acting, places)
        mark = (places.shape, places.tobytes())  # one place, and an array of one place, are two
        if mark not in self._solved:
            if len(self._solved) >= FEW:
                self._solved.pop(next(iter(self._solved)))
            self._solved[mark] = sample(self.mech, self.acting, places)
        return self._solved[mark]

    @cached_property
    def _grid(self) -> Sample:
        """Solved all round, as closely as its motion needs."""
        return sample(self.mech, self.acting, places(self.mech, self.low, self.high, self.whole))

    def on_grid(self, key: str) -> tuple[Reals, Points | Reals]:
        """Positions on which turning points are sought (none of them on a round degree), and the quantity there."""
        phi = self._grid.phi
        return phi, phi if key == self.drive.key else self._on_turn(key, phi, self._grid.value(key))

    def _on_turn(self, key: str, places: Reals, values: Points | Reals) -> Points | Reals:
        """An angle on the turn on which its column is; anything else as it is."""
        if not self.info(key).turns:
            return values
        phi, angle = (self.phi, self.real(key)) if self._parts == 1 else self._trace(key)
        known = np.isfinite(angle)
        if not known.any():
            return values
        near = np.interp(places, phi[known], angle[known])
        return np.asarray(values + 2 * np.pi * np.round((near - values) / (2 * np.pi)), np.float64)

    def rows(self, step: float) -> NDArray[np.intp]:
        """Indices of the positions at whole multiples of a step (rad, or m),
        as far as the grid has them: for a table every 10°."""
        turns = (self.phi - self.phi[0]) / step
        return np.flatnonzero(np.abs(turns - np.round(turns)) * step < 1e-3 * (self.phi[1] - self.phi[0]))

    @property
    def period(self) -> float:
        """After which all is as it was (rad): a whole turn, or as many as the loads need; 0 of a mere range."""
        return self.high - self.low if self.whole else 0.0

    @cached_property
    def once(self) -> Cycle:
        """One turn of the drive, for what the links do, which need no more; the cycle itself where it is one."""
        if self.period <= 2 * np.pi * 1.5:
            return self
        high = self.low + 2 * np.pi
        own = self.phi[self.phi <= high + 1e-9]
        return replace(self, phi=own, high=high, _kept={}, _solved={}, _infos={})

    @cached_property
    def steady(self) -> Cycle:
        """The same cycle with a drive that moves evenly: of unit rate where it rests.
        For what depends on the shape of motion alone."""
        drive = self.mech.drive
        if drive.rate != 0.0 and drive.accel == 0.0:
            return self
        even = replace(self.mech, drives=(replace(drive, rate=drive.rate or 1.0, accel=0.0), *self.mech.drives[1:]))
        return replace(self, mech=even, loads=None, machine=None, _kept={}, _solved={}, _infos={})

    @property
    def _parts(self) -> int:
        """Into how many parts a step is cut, that no link turns half round in one of them."""
        span = abs(self.phi[-1] - self.phi[0]) / (
            2 * np.pi if not self.mech.drive.slide else self.high - self.low or 1.0
        )
        return max(1, int(np.ceil(FINE * max(span, 1.0) / max(len(self.phi) - 1, 1))))

    def _followed(self, key: str) -> Reals:
        """The angle without jumps at every position."""
        return (
            follow(np.asarray(self.solved(key), np.float64))
            if self._parts == 1
            else self._trace(key)[1][:: self._parts]
        )

    def _trace(self, key: str) -> tuple[Reals, Reals]:
        """Positions as fine as need be, and the angle without jumps at each."""
        index = np.arange((len(self.phi) - 1) * self._parts + 1) / self._parts
        between = np.interp(index, np.arange(len(self.phi)), self.phi)
        trace = f"{key} between"
        if trace not in self._kept:
            self._kept[trace] = follow(np.asarray(sample(self.mech, self.acting, between).value(key), np.float64))
        return between, np.asarray(self._kept[trace], np.float64)
