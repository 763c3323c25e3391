"""A solved problem: the construction, the oracle's answers beside it, and what the hand may be off by."""

from __future__ import annotations

import cmath
from collections.abc import Mapping
from dataclasses import dataclass, replace
from math import degrees, inf, isfinite, nan
from pathlib import Path
from typing import Any, cast

import numpy as np

from .board.construction import Construction, LineOfAction, Reading, View
from .board.hand import Hand, hand
from .check.alarm import Cause, Weighed, alarm_at, warning
from .check.exact import Exact
from .check.precision import PLENTY, digits, noise, sizes
from .devices.base import Device
from .drawing.packing import fits_sheet
from .drawing.space import room, slots
from .methods.centres.compare import comparable
from .methods.devices.plan import construct_device
from .methods.drawn import Drawn
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
    the vectors themselves. exact_acts: where a reaction acts. turns: whether the sign is a sense of turning. weighed: what the
    alarm goes by.
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
    weighed: Weighed

    @property
    def suspect(self) -> Cause | None:
        """Why the value must not be taken for an answer; None where it may."""
        return self.weighed.cause

    @property
    def digits(self) -> int:
        """How many digits the exact value keeps where rounding is magnified, near a dead point; 15 at most."""
        return digits(self.weighed.noise, self.weighed.size)

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
        if self.digits < PLENTY:
            data["exact_digits"] = self.digits
        return data | {"expected_error": self.expected_error if isfinite(self.expected_error) else None, "suspect": self.suspect is not None}


def plain(data: Any) -> Any:
    """The data with null for what is not finite: JSON knows neither NaN nor infinity."""
    match data:
        case dict():
            return {key: plain(value) for key, value in data.items()}
        case list():
            return [plain(value) for value in data]
        case float() if not isfinite(data):
            return None
    return data


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

    @property
    def suspect(self) -> bool:
        """Whether any answer must not be taken for one."""
        return any(answer.suspect for answer in self.answers.values())

    def as_json(self) -> dict[str, Any]:
        """Everything asked, as plain data; of a force analysis also everything else that was drawn, under `forces`."""
        data: dict[str, Any] = {"id": self.problem.id, "hand": self.construction.hand,
                                "suspect": self.suspect, "answers": {key: answer.as_json() for key, answer in self.answers.items()}}
        forces = {key: _drawn(reading) for key, reading in self.construction.forces.items()}
        return cast("dict[str, Any]", plain(data | ({"forces": forces} if forces else {})))

    def report(self, path: str | Path, *, lang: Lang = "zh", style: str = "solution") -> Path:
        """Write the report of this problem as a PDF."""
        from .report.document import write_report

        return write_report([self], path, lang=lang, style=style)

    def _repr_svg_(self) -> str:
        """The first sheet as a picture, in Jupyter."""
        from .drawing.sheet import sheets
        from .drawing.svg import to_svg

        return to_svg(sheets(self.construction)[0].scene, self.problem.title.zh)


def solve(problem: Problem, *, by: str = "drafting", seed: int = 0, repeats: int = REPEATS, precise: bool = True) -> Solution:
    """Draw the solution of a problem with this hand and set the oracle's answers beside it.

    precise: also find how many digits the exact values keep; else that is done only where something is suspect.
    Raises AssemblyError, DeadPointError, MobilityError, NoMethodError.
    """
    truth = Exact(problem)
    values = truth.values  # first: its refusals know the range of the input that does assemble
    size = sizes(problem, values)
    off = noise(problem, truth, size) if precise else dict.fromkeys(values, 0.0)
    drawn = _constructed(problem, hand(by, seed=seed, repeats=repeats))
    readings, exact, spread = comparable(drawn.construction.readings, values, drawn.repeats)
    ideal, true, _ = comparable(drawn.ideal, values, {})
    reached = {key: _expected(spread[key]) for key in readings}
    limit = {key: alarm_at(reached[key], spread[key], scatters=by == "pencil") for key in readings}
    turning = _TURNING[:2] if isinstance(problem.subject, Device) else _TURNING
    answers = {key: _answer(reading, exact[key], reached[key], truth.lines.get(key), reading.unit in turning,
                            _weighed(reading, exact[key], ideal[key], true[key], limit[key] if repeats else nan, off[key], size[key]))
               for key, reading in readings.items()}
    if not precise and any(answer.suspect for answer in answers.values()):
        return solve(problem, by=by, seed=seed, repeats=repeats)
    said = warning((one.reading.symbol, one.suspect) for one in answers.values() if one.suspect)
    return Solution(problem, replace(drawn.construction, readings=readings, warning=said), answers)


def fewer_digits(solution: Solution) -> Words | None:
    """What is to be said where exact values have lost digits near a dead point or change point."""
    short = [(answer.reading.symbol, answer.digits) for answer in solution.answers.values() if answer.digits < PLENTY]
    if not short:
        return None
    zh, en = "、".join(f"${symbol}$ 剩 {left} 位" for symbol, left in short), ", ".join(f"${symbol}$ {left}" for symbol, left in short)
    return Words(f"机构离死点（变点）很近，精确值的有效数字减少：{zh}。",
                 f"So near to a dead point (change point) the exact values keep only a few digits: {en}.")


def _constructed(problem: Problem, by: Hand) -> Drawn:
    """The construction of a mechanism or a device, each figure as large as its place on the sheet allows."""
    if isinstance(problem.subject, Device):
        return construct_device(problem, by, {})
    if problem.loads is not None:
        return construct(problem, by, {view: POLYGON if view is View.FORCE else room(view, 3) for view in View})
    drawn = [view for view in View if view.value in {stage.value for stage in stages(problem)} or view is View.MECHANISM]
    return construct(problem, by, dict(zip(drawn, slots(len(drawn) + needs_centres(problem)), strict=False)), fits_sheet)


def _expected(scalars: Any) -> float:
    """3σ of the repeated hands; of none 0."""
    repeated = np.asarray(scalars)
    found = repeated[1:][np.isfinite(repeated[1:])] if repeated.ndim else repeated[None]
    return 3.0 * float(np.std(found)) if found.size else inf  # no repeated hand closes the polygon: nothing can be promised


def _answer(reading: Reading, exact: complex | float, error: float, line: tuple[complex, str] | None, turns: bool, weighed: Weighed) -> Answer:
    return Answer(
        key=reading.key, reading=reading, drawn=reading.scalar, exact=_size(exact), expected_error=error, drawn_vector=reading.vector,
        exact_vector=exact if isinstance(exact, complex) else None,
        exact_acts=None if line is None else LineOfAction(point=line[0], tangent=line[1]), turns=turns, weighed=weighed,
    )


def _weighed(reading: Reading, exact: complex | float, ideal: Reading, true: complex | float, reach: float, off: float, size: float) -> Weighed:
    as_vector = ideal.vector is not None and isinstance(true, complex)
    return Weighed(drawn=reading.scalar, exact=_size(exact), ideal=ideal.vector if as_vector and ideal.vector is not None else ideal.scalar,
                   true=true if as_vector else _size(true), reach=reach, noise=off, size=size)


def _size(value: complex | float) -> float:
    """The magnitude of a vector, the signed value of a scalar."""
    return abs(value) if isinstance(value, complex) else float(value)
