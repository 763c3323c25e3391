"""A solved problem: the construction, the oracle's answers beside it, and what the hand may be off by."""

from __future__ import annotations

import cmath
from collections.abc import Mapping
from dataclasses import dataclass, replace
from functools import partial
from math import degrees, inf, isfinite, nan
from pathlib import Path
from typing import Any

import numpy as np

from .arguments import of_kind
from .board.construction import Construction, LineOfAction, Reading, View
from .board.hand import Hand, hand
from .board.sizes import unfit
from .check.exact import Exact
from .check.idle import idle
from .devices.base import Device
from .drawing.packing import fits_sheet
from .drawing.space import room, slots
from .frozen import FrozenMap
from .methods.centres.compare import comparable
from .methods.devices.plan import construct_device
from .methods.passes import needs_centres, stages
from .methods.plan import construct
from .problem.problem import Problem
from .words import Lang, Words

REPEATS = 200  # repeated hands behind every expected drawing error
POLYGON = (105.0, 70.0)  # mm that a force polygon should fill
YES_NO = "yes/no"  # unit of an answer that is 1 or 0
_TURNING = ("rad/s", "rad/s^2", "N·m")  # units whose sign is a sense of turning


@dataclass(frozen=True, slots=True, kw_only=True)
class Answer:
    """One asked quantity: as drawn, exact, and the expected drawing error (3σ of repeated hands), all SI.

    drawn, exact: signed value of ω, α, a moment, a force along a given line; magnitude of a vector. drawn_vector, exact_vector:
    the vectors themselves. exact_acts: where a reaction acts. turns: whether the sign is a sense of turning.
    """

    key: str
    reading: Reading
    drawn: float
    exact: float
    expected_error: float
    drawn_vector: complex | None = None
    exact_vector: complex | None = None
    exact_acts: LineOfAction | None = None
    turns: bool = False

    @property
    def computed(self) -> bool:
        """Whether the value was found by formula alone: no repeated hand gives another, and it is the exact one."""
        size = abs(self.exact)
        return self.expected_error <= 1e-9 * size and abs(self.deviation) <= 1e-9 * size

    @property
    def deviation(self) -> float:
        """drawn − exact."""
        return self.drawn - self.exact

    @property
    def relative_deviation(self) -> float:
        """(drawn − exact) / exact; where the exact value vanishes there is none, and this is NaN."""
        return self.deviation / self.exact if self.exact else nan

    @property
    def direction(self) -> float | None:
        """Direction of the drawn vector in degrees from +x; None for ω, α and for a vector that vanishes."""
        if self.drawn_vector is None or self.drawn_vector == 0:
            return None
        return degrees(cmath.phase(self.drawn_vector))

    @property
    def sense(self) -> str | None:
        """ccw or cw for ω, α and the moments of a mechanism; none where it is zero."""
        if not self.turns or self.drawn == 0:
            return None
        return "ccw" if self.drawn > 0 else "cw"

    def as_json(self) -> dict[str, Any]:
        """The answer as plain data, in the shape that `vecpoly solve --json` prints."""
        data: dict[str, Any] = {"unit": self.reading.unit, "drawn": self.drawn, "exact": self.exact}
        if self.reading.unit == YES_NO:
            return data | {"drawn": bool(self.drawn), "exact": bool(self.exact)}
        if self.key.startswith(("p_", "P_")) and self.drawn_vector is not None and self.exact_vector is not None:
            data |= {"drawn_xy": _xy(self.drawn_vector), "exact_xy": _xy(self.exact_vector)}
        elif self.key.startswith("P_") and self.key[2:3].isdigit():  # a centre P_13; P_out is a power
            data["at_infinity"] = True
        elif self.drawn_vector is not None:
            exact = self.exact_vector or 0j
            towards = degrees(cmath.phase(exact)) if abs(exact) > 1e-9 * max(1.0, self.expected_error) else None
            data |= {"direction_deg": self.direction, "exact_direction_deg": towards} | _line("", self.reading.acts) | _line("exact_", self.exact_acts)
        elif self.turns:
            data["sense"] = self.sense
        if self.reading.mm is not None:
            data["reading_mm"] = self.reading.mm
        return data | {"expected_error": self.expected_error if isfinite(self.expected_error) else None}


def _xy(at: complex) -> list[float]:
    return [at.real, at.imag]


def _line(which: str, acts: LineOfAction | None) -> dict[str, Any]:
    """A point (m) of the line of action, and the sense of its moment about the pin where it touches a friction circle."""
    return {} if acts is None else {f"{which}point": _xy(acts.point), f"{which}tangent": acts.tangent or None}


def _drawn(reading: Reading) -> dict[str, Any]:
    """What was drawn of one quantity of a force analysis: unit, value, direction, line of action, tangent side."""
    data: dict[str, Any] = {"unit": reading.unit, "drawn": reading.scalar}
    if reading.vector is not None:
        data["direction_deg"] = degrees(cmath.phase(reading.vector)) if reading.vector else None
    return data | _line("", reading.acts)


@dataclass(frozen=True)
class Solution:
    """What `solve` gives: the problem, its construction and its answers."""

    problem: Problem
    construction: Construction
    answers: Mapping[str, Answer]
    warnings: tuple[Words, ...] = ()  # what is accepted but hardly meant, in the file and of the scales

    def __post_init__(self) -> None:
        object.__setattr__(self, "answers", FrozenMap(self.answers))

    def as_json(self) -> dict[str, Any]:
        """Everything asked, as plain data; of a force analysis also everything else that was drawn, under `forces`."""
        data: dict[str, Any] = {"id": self.problem.id, "hand": self.construction.hand,
                                "answers": {key: answer.as_json() for key, answer in self.answers.items()}}
        if self.warnings:
            data["warnings"] = [{"zh": words.zh, "en": words.en} for words in self.warnings]
        forces = {key: _drawn(reading) for key, reading in self.construction.forces.items()}
        return data | ({"forces": forces} if forces else {})

    def report(self, path: str | Path, *, lang: Lang = "zh", style: str = "solution") -> Path:
        """Write the report of this problem as a PDF."""
        from .report.document import write_report

        return write_report([self], path, lang=lang, style=style)

    def _repr_svg_(self) -> str:
        """The first sheet as a picture, in Jupyter."""
        from .drawing.sheet import sheets
        from .drawing.svg import to_svg

        return to_svg(sheets(self.construction, way=self.problem.orientation)[0].scene, self.problem.title.zh)


def solve(problem: Problem, *, by: str = "drafting", seed: int = 0, repeats: int = REPEATS) -> Solution:
    """Draw the solution of a problem with this hand and set the oracle's answers beside it.

    Raises AssemblyError, DeadPointError, MobilityError, NoMethodError.
    """
    of_kind(problem, Problem, Words("题目（load 或 loads 的结果）", "a problem, as load and loads give it,"))
    truth = Exact(problem)
    exact = truth.values  # first: its refusals know the range of the input that does assemble
    construction, spread = _constructed(problem, hand(by, seed=seed, repeats=repeats))
    readings, exact, spread = comparable(construction.readings, exact, spread)
    construction = replace(construction, readings=readings)
    turning = _TURNING[:2] if isinstance(problem.subject, Device) else _TURNING
    answers = {key: _answer(reading, exact[key], spread[key], truth.lines.get(key), reading.unit in turning) for key, reading in construction.readings.items()}
    return Solution(problem, construction, answers, (*problem.warnings, *idle(problem), *unfit(construction.figures, _given(problem))))


def _given(problem: Problem) -> tuple[View, ...]:
    """The kinds of figure whose scale the problem gives."""
    scales = problem.scales
    values = {View.MECHANISM: scales.mu_l, View.VELOCITY: scales.mu_v, View.ACCELERATION: scales.mu_a, View.FORCE: scales.mu_f}
    return tuple(view for view, value in values.items() if value is not None)


def _constructed(problem: Problem, by: Hand) -> tuple[Construction, Mapping[str, Any]]:
    """The construction of a mechanism or a device, each figure as large as its place on the sheet allows."""
    if isinstance(problem.subject, Device):
        return construct_device(problem, by, {})
    if problem.loads is not None:
        return construct(problem, by, {view: POLYGON if view is View.FORCE else room(view, 3) for view in View})
    drawn = [view for view in View if view.value in {stage.value for stage in stages(problem)} or view is View.MECHANISM]
    return construct(problem, by, dict(zip(drawn, slots(len(drawn) + needs_centres(problem)), strict=False)), partial(fits_sheet, landscape=problem.orientation == "landscape"))


def _answer(reading: Reading, exact: complex | float, scalars: Any, line: tuple[complex, str] | None, turns: bool) -> Answer:
    vector = isinstance(exact, complex)
    repeated = np.asarray(scalars)
    found = repeated[1:][np.isfinite(repeated[1:])] if repeated.ndim else repeated[None]
    error = 3.0 * float(np.std(found)) if found.size else inf  # no repeated hand closes the polygon: nothing can be promised
    return Answer(
        key=reading.key, reading=reading, drawn=reading.scalar, exact=abs(exact) if vector else float(np.real(exact)),
        expected_error=error, drawn_vector=reading.vector, exact_vector=exact if isinstance(exact, complex) else None,
        exact_acts=None if line is None else LineOfAction(point=line[0], tangent=line[1]), turns=turns,
    )
