"""A solved problem: the construction, the oracle's answers beside it, and what the hand may be off by."""

from __future__ import annotations

import cmath
from collections.abc import Mapping
from dataclasses import dataclass
from math import degrees, inf, isfinite, nan
from pathlib import Path
from typing import Any

import numpy as np

from .board.construction import Construction, Reading, View
from .board.hand import Hand, hand
from .check.exact import exact_values
from .devices.base import Device
from .drawing.space import slots
from .methods.devices.plan import construct_device
from .methods.plan import construct, stages
from .problem.problem import Problem
from .words import Lang

REPEATS = 200  # repeated hands behind every expected drawing error


@dataclass(frozen=True, slots=True, kw_only=True)
class Answer:
    """One asked quantity: as drawn, exact, and the expected drawing error (3σ of repeated hands), all SI.

    drawn, exact: signed value of ω, α; magnitude of a vector. drawn_vector, exact_vector: the vectors themselves.
    """

    key: str
    reading: Reading
    drawn: float
    exact: float
    expected_error: float
    drawn_vector: complex | None = None
    exact_vector: complex | None = None

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
        """ccw or cw for ω and α; none where it is zero."""
        if self.drawn_vector is not None or self.drawn == 0:
            return None
        return "ccw" if self.drawn > 0 else "cw"

    def as_json(self) -> dict[str, Any]:
        """The answer as plain data, in the shape that `vecpoly solve --json` prints."""
        data: dict[str, Any] = {"unit": self.reading.unit, "drawn": self.drawn, "exact": self.exact}
        if self.key.startswith("p_") and self.drawn_vector is not None and self.exact_vector is not None:
            data |= {"drawn_xy": [self.drawn_vector.real, self.drawn_vector.imag],
                     "exact_xy": [self.exact_vector.real, self.exact_vector.imag]}
        elif self.drawn_vector is not None:
            data["direction_deg"] = self.direction
            exact = self.exact_vector or 0j
            data["exact_direction_deg"] = degrees(cmath.phase(exact)) if abs(exact) > 1e-9 * max(1.0, self.expected_error) else None
        else:
            data["sense"] = self.sense
        if self.reading.mm is not None:
            data["reading_mm"] = self.reading.mm
        return data | {"expected_error": self.expected_error if isfinite(self.expected_error) else None}


@dataclass(frozen=True)
class Solution:
    """What `solve` gives: the problem, its construction and its answers."""

    problem: Problem
    construction: Construction
    answers: Mapping[str, Answer]

    def as_json(self) -> dict[str, Any]:
        """Everything asked, as plain data."""
        return {"id": self.problem.id, "hand": self.construction.hand,
                "answers": {key: answer.as_json() for key, answer in self.answers.items()}}

    def report(self, path: str | Path, *, lang: Lang = "zh", style: str = "solution") -> Path:
        """Write the report of this problem as a PDF."""
        from .report.document import write_report

        return write_report([self], path, lang=lang, style=style)

    def _repr_svg_(self) -> str:
        """The first sheet as a picture, in Jupyter."""
        from .drawing.sheet import sheets
        from .drawing.svg import to_svg

        return to_svg(sheets(self.construction)[0].scene, self.problem.title.zh)


def solve(problem: Problem, *, by: str = "drafting", seed: int = 0, repeats: int = REPEATS) -> Solution:
    """Draw the solution of a problem with this hand and set the oracle's answers beside it.

    Raises AssemblyError, DeadPointError, MobilityError, NoMethodError.
    """
    exact = exact_values(problem)  # first: its refusals know the range of the input that does assemble
    construction, spread = _constructed(problem, hand(by, seed=seed, repeats=repeats))
    answers = {key: _answer(reading, exact[key], spread[key]) for key, reading in construction.readings.items()}
    return Solution(problem, construction, answers)


def _constructed(problem: Problem, by: Hand) -> tuple[Construction, Mapping[str, Any]]:
    """The construction of a mechanism or a device, each figure as large as its place on the sheet allows."""
    if isinstance(problem.subject, Device):
        return construct_device(problem, by, {})
    drawn = [view for view in View if view.value in {stage.value for stage in stages(problem)} or view is View.MECHANISM]
    return construct(problem, by, dict(zip(drawn, slots(len(drawn)), strict=False)))


def _answer(reading: Reading, exact: complex | float, scalars: Any) -> Answer:
    vector = isinstance(exact, complex)
    repeated = np.asarray(scalars)
    found = repeated[1:][np.isfinite(repeated[1:])] if repeated.ndim else repeated[None]
    error = 3.0 * float(np.std(found)) if found.size else inf  # no repeated hand closes the polygon: nothing can be promised
    return Answer(
        key=reading.key, reading=reading, drawn=reading.scalar, exact=abs(exact) if vector else float(np.real(exact)),
        expected_error=error, drawn_vector=reading.vector, exact_vector=exact if isinstance(exact, complex) else None,
    )
