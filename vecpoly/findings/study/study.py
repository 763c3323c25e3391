"""What a course report is about: the problem, its drawing at the given position, and the exact cycle with its facts."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from functools import cached_property
from math import floor, log10

import numpy as np
from numpy.typing import NDArray

from ...analytic.build import model
from ...analytic.equations import Model, Values
from ...cycle import Cycle, Extremes, Facts, Path, cycle, extremes, facts, path
from ...cycle.sample import Sample, sample
from ...errors import NotAskedError
from ...foundation.slotted import replace
from ...mechanism.model import Mechanism
from ...names import At, Kind, Rel
from ...problem.asked.asks import AskPoint
from ...problem.problem import Problem
from ...problem.without_cycle import no_cycle
from ...solution import Solution
from ...words import Words
from .also_asked import widened
from .from_pivots import by_x_axis, from_pivots
from .one_drive import follows_one_drive
from .place_told import place_told
from .reactions import reactions, without_twins
from .told import STILL, links_told, points_told
from .working_range import working_range

TABLE_STEP = 10.0  # degrees between the rows of the table
PARTS = 20  # positions of the curves between two rows


@dataclass(frozen=True, eq=False)
class Study:
    """The subject of one course report; everything computed once, when first used."""

    solution: Solution
    given: Solution  # as the problem asks for it
    _extremes: dict[str, Extremes] = field(default_factory=dict, repr=False)
    _paths: dict[str, Path] = field(default_factory=dict, repr=False)

    @property
    def problem(self) -> Problem:
        return self.solution.problem

    @cached_property
    def mech(self) -> Mechanism:
        """The mechanism, its links told from their fixed pivots, its drive by its x axis."""
        return by_x_axis(from_pivots(self.problem.mechanism))

    @property
    def drawn(self) -> bool:
        """Whether there are drawings: there is no method on file for groups of class III."""
        return bool(self.solution.answers)

    @property
    def sense_only(self) -> bool:
        """Whether of the input link's speed only the sense is given: 1 rad/s is taken."""
        start = f"$ω_{self.mech.drive.link}$"
        return not self.mech.drive.slide and any(
            d.words is not None and d.words.zh.startswith(start) for d in self.problem.given.motion
        )

    @cached_property
    def turn(self) -> Cycle:
        """The cycle on a fine grid that holds the rows of the table; no dead point at its ends."""
        return replace(self.whole, phi=self._grid(self.step / PARTS), _kept={}) if not self.whole.whole else self.whole

    @cached_property
    def whole(self) -> Cycle:
        """The cycle that is told: all of it, or the working range of a drive that makes no whole turn."""
        return working_range(self.entire, self.model)

    @cached_property
    def entire(self) -> Cycle:
        """The cycle from end to end, 20 positions to every row; a range is told on the turn of the given position."""
        found = cycle(replace(self.problem, subject=self.mech), n=36 * PARTS + 1)
        if found.whole or self.mech.drive.slide:
            return found
        turns = 2 * np.pi * np.floor((self.mech.drive.position - found.low) / (2 * np.pi) + 1e-9)
        return replace(found, phi=found.phi + turns, low=found.low + turns, high=found.high + turns, _kept={})

    @cached_property
    def step(self) -> float:
        """Step of the table (rad or m): 10°, a round part of the range where the drive cannot turn right round."""
        if self.whole.whole:
            return float(np.radians(TABLE_STEP))
        factor = self.whole.drive.factor
        raw = (self.whole.high - self.whole.low) * factor / 36
        power = 10.0 ** floor(log10(raw))
        return next(m * power for m in (1, 2, 5, 10) if m * power >= raw) / factor

    def _grid(self, step: float) -> NDArray[np.float64]:
        zero = self.mech.drive.lead
        low, high = self.whole.low - zero, self.whole.high - zero
        edge = 1e-3 * (high - low)
        return zero + step * np.arange(np.ceil((low + edge) / step), np.floor((high - edge) / step) + 1)

    @cached_property
    def rows(self) -> NDArray[np.intp]:
        """Indices of the table's rows."""
        turns = (self.turn.phi - self.mech.drive.lead) / self.step
        return np.flatnonzero(np.abs(turns - np.round(turns)) < 1e-6)

    @cached_property
    def facts(self) -> Facts:
        """The facts of the cycle; of links that turn together one only."""
        found = facts(self.entire)
        shown = {f"alpha_{name}" for name in self.links}
        return replace(found, peaks=tuple(peak for peak in found.peaks if peak.key in shown))

    @property
    def dense(self) -> bool:
        """Whether there is so much to tell that curves stand beside each other and short equations in one line."""
        return len(self.model.groups) - 1 + 2 * (self.problem.acting is not None) >= 3

    @cached_property
    def here(self) -> Sample:
        """The given position, exactly."""
        return sample(self.mech, None, self.mech.drive.position)

    @cached_property
    def at(self) -> Mapping[str, complex]:
        """Places of all letters at the given position (m)."""
        letters = {letter for link in self.mech.links for letter in link.points}
        return {letter: complex(self.here.motion.position(At(letter))) for letter in sorted(letters)} | dict(
            self.mech.frame
        )

    @cached_property
    def turned(self) -> Mapping[str, float]:
        """Angles of all links at the given position (rad)."""
        return {link.name: float(self.here.motion.angle(link.name)) for link in self.mech.links}

    @cached_property
    def model(self) -> Model:
        return model(self.mech, self.at, self.turned, frozenset(d.symbol for d in self.problem.given.lengths))

    @cached_property
    def env(self) -> Values:
        """Every variable of the model on the fine grid."""
        return self.model.values(self.turn.phi)

    @cached_property
    def links(self) -> tuple[str, ...]:
        """The links whose rotation is worth telling, in the order of their numbers."""
        return links_told(self.problem, self.turn)

    @cached_property
    def points(self) -> tuple[str, ...]:
        """The letters whose motion is worth telling, two at most."""
        return points_told(self.problem, self.whole)

    @cached_property
    def outputs(self) -> tuple[str, ...]:
        """Keys of the velocities and accelerations asked for, of the links and points shown."""
        names = {*self.links, *self.points}
        keys = [
            ask.rel.key
            for ask in self.problem.asks
            if isinstance(ask.rel, Rel)
            and not isinstance(ask, AskPoint)
            and ask.rel.kind in (Kind.V, Kind.A, Kind.OMEGA, Kind.ALPHA)
        ]
        return tuple(key for key in dict.fromkeys(keys) if key.partition("_")[2] in names and self.varies(key))

    @property
    def main(self) -> tuple[str, ...]:
        """Of the outputs the last velocity, acceleration, ω and α:
        those of the output link and point; and the balancing load."""
        last = {key.partition("_")[0]: key for key in self.outputs}
        return (*last.values(), *self.forces[:1])

    def extremes(self, key: str) -> Extremes:
        """The extreme values of a column over the whole cycle."""
        if key not in self._extremes:
            self._extremes[key] = extremes(self.whole, key)
        return self._extremes[key]

    def path(self, letter: str) -> Path:
        """The facts of a point's path over the whole cycle."""
        if letter not in self._paths:
            self._paths[letter] = path(self.whole, letter)
        return self._paths[letter]

    def varies(self, key: str) -> bool:
        """Whether the column has values, and not the same everywhere."""
        values = self.turn.real(key)
        known = values[np.isfinite(values)]
        return bool(known.size) and float(np.ptp(known)) > STILL * max(1.0, float(np.abs(known).max()))

    @cached_property
    def forces(self) -> tuple[str, ...]:
        """Keys of the balancing load, the efficiency and the reactions, where there are loads."""
        if self.problem.loads is None:
            return ()
        asked = {ask.rel.key for ask in self.problem.asks}
        wanted = [key for key in asked if key.startswith("R_")] or reactions(self.whole)
        keys = [c.key for c in self.whole.columns if c.key in (self.problem.loads.unknown.name, "eta", *wanted)]
        return without_twins(self.turn, keys)

    def model_name(self, link: str) -> str:
        """A link's subscript in the formulas."""
        return next((c.point for c in self.mech.contacts if c.substitute == link), link)

    def name(self, link: str) -> str:
        """A link as printed: its number, the frame's included;
        the letter of a contact, or of a pin in a slot, for what stands there instead."""
        pin = self.mech.slot_pins.get(link)
        return next(
            (c.point for c in self.mech.contacts if c.substitute == link),
            self.mech.number(link) if pin is None else pin.point,
        )

    def shown(self, key: str) -> NDArray[np.float64]:
        """A column in the unit in which it is shown, on the fine grid; of a vector its magnitude."""
        return self.turn.info(key).factor * self.turn.real(key)

    def where(self, phi: float) -> str:
        """$φ_1$ = 37.5°, within a turn."""
        drive = self.turn.drive
        text = self.place(self.reduced(phi) if drive.shown_unit == "°" else phi)
        text = "0°" if self.whole.whole and text in ("360°", "360.0°") else text
        return f"${drive.symbol}$ = {text}"

    def place(self, phi: float) -> str:
        """37.5°; 1714.9 mm."""
        return place_told(self.turn.drive, phi)

    def reduced(self, phi: float) -> float:
        """The position within 0 … 360° where the drive turns right round, 0 … 720° where a period takes two turns."""
        turn, zero = self.whole.period, self.mech.drive.lead
        return float(phi - turn * np.floor((phi - zero) / turn + 1e-9)) if self.whole.whole else phi


def study(solution: Solution) -> Study:
    """The study of a solved problem. Raises NotAskedError for a device."""
    if not isinstance(solution.problem.subject, Mechanism):
        raise NotAskedError(
            Words("课程报告需要运动循环：", "a course report needs a cycle: ")
            + no_cycle(solution.problem)
            + Words("；或改写解答报告（--style solution）", "; or write its solution report (--style solution)")
        )
    follows_one_drive(solution.problem)
    return Study(widened(solution), solution)
