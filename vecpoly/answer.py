"""One asked quantity: as drawn, exact, what the hand may be off by, and whether it may be taken for an answer."""

from __future__ import annotations

import cmath
from collections.abc import Iterable
from math import degrees, isfinite, isnan, nan
from typing import Any

from .board.construction import LineOfAction, Reading
from .board.said.short import TOO_SHORT, about, is_short
from .check.alarm import Cause, Weighed
from .check.precision import NOTHING, PLENTY, digits, settled
from .foundation.slotted import dataclass
from .names import Key, Named, is_place
from .words import Lang, Words, bare

_HEAD = {"zh": ("量", "图解", "精确", "单位", "预期误差"), "en": ("symbol", "drawn", "exact", "unit", "expected")}
_NOTHING = 1e-14  # of what it is told beside: the rounding of a float, not a value
YES_NO = "yes/no"  # unit of an answer that is 1 or 0


@dataclass(frozen=True, slots=True, kw_only=True)
class Answer:
    """One asked quantity: as drawn, exact, and the expected drawing error (3σ of repeated hands), all SI.

    drawn, exact: signed value of ω, α, a moment, a force along a given line; magnitude of a vector. drawn_vector,
    exact_vector: the vectors themselves. exact_acts: where a reaction acts. turns: whether the sign is a sense of
    turning. least: so many decimals, if its reading has them, for the sake of others beside it. finer: so many
    decimals more than that, where it lies midway between two numbers of fewer. weighed: what the
    alarm goes by.
    """

    rel: Key
    reading: Reading
    drawn: float
    exact: float
    expected_error: float
    drawn_vector: complex | None = None
    exact_vector: complex | None = None
    exact_acts: LineOfAction | None = None
    turns: bool = False
    least: int = 0
    finer: int = 0
    weighed: Weighed

    @property
    def key(self) -> str:
        """ASCII symbol."""
        return self.rel.key

    @property
    def is_place(self) -> bool:
        """Whether it is the place of a point or of an instant centre; one at infinity is told by its direction."""
        return is_place(self.rel)

    @property
    def suspect(self) -> Cause | None:
        """Why the value must not be taken for an answer; None where it may."""
        return self.weighed.cause

    @property
    def short(self) -> bool:
        """Whether it was read off a length that is too short on paper to be measured."""
        return is_short(self.reading)

    @property
    def digits(self) -> int:
        """How many digits the exact value keeps where rounding is magnified, near a dead point; 15 at most."""
        return digits(self.weighed.noise, self.weighed.size)

    @property
    def computed(self) -> bool:
        """Whether the value was found by formula alone: no repeated hand gives another, and it is the exact one."""
        size = abs(self.exact)
        return self.undefined or (self.expected_error <= 1e-9 * size and abs(self.deviation) <= 1e-9 * size)

    @property
    def undefined(self) -> bool:
        """Whether the quantity has no value here, by the drawing and by the oracle alike: an efficiency of 0/0."""
        return isnan(self.drawn) and isnan(self.exact)

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
        return bearing(self.drawn_vector)

    @property
    def sense(self) -> str | None:
        """ccw or cw for ω, α and the moments of a mechanism; none where it is zero."""
        if not self.turns or self.drawn == 0:
            return None
        return "ccw" if self.drawn > 0 else "cw"

    @property
    def along(self) -> Words | None:
        """Which way an equivalent force acts on its slider, beside which it is printed as a size; None of all else."""
        equivalent = isinstance(self.rel, Named) and self.rel.is_reduced and self.rel.unit == "N"
        if not equivalent or self.drawn == 0:
            return None
        return Words("与运动同向", "along the motion") if self.drawn > 0 else Words("与运动反向", "against the motion")

    @property
    def nothing(self) -> float:
        """What is rounding beside the size that the answer is measured by, however slow or small the mechanism."""
        return NOTHING * (self.weighed.own if isfinite(self.weighed.own) else 1.0)

    @property
    def counted(self) -> float:
        """+1, or −1 of what turns clockwise or acts against the motion: beside these words its size is printed."""
        return -1.0 if self.sense == "cw" or (self.along is not None and self.drawn < 0) else 1.0

    def as_json(self) -> dict[str, Any]:
        """The answer as plain data, in the shape that `vecpoly solve --json` prints."""
        said = self.reading.remark
        return self._as_json() | ({} if said is None else {"remark": {"zh": bare(said.zh), "en": bare(said.en)}})

    def _as_json(self) -> dict[str, Any]:
        exact = settled(self.exact, self.weighed.noise, self.weighed.size)
        data: dict[str, Any] = {"unit": self.reading.unit, "drawn": self.drawn, "exact": exact}
        if self.undefined:
            return data | {"drawn": None, "exact": None, "undefined": True, "suspect": self.suspect is not None}
        if self.reading.unit == YES_NO:
            return data | {"drawn": bool(self.drawn), "exact": bool(self.exact), "suspect": self.suspect is not None}
        if self.is_place and self.drawn_vector is not None and self.exact_vector is not None:
            data |= {"drawn_xy": place_of(self.drawn_vector), "exact_xy": place_of(self.exact_vector)}
        elif self.is_place:
            data["at_infinity"] = True
        elif self.drawn_vector is not None:
            true = self.exact_vector or 0j
            towards = bearing(true) if abs(true) > self.nothing else None
            data |= (
                {"direction_deg": self.direction, "exact_direction_deg": towards}
                | line_of("", self.reading.acts)
                | line_of("exact_", self.exact_acts)
            )
        elif self.turns:
            data["sense"] = self.sense
        if self.reading.mm is not None:
            data["reading_mm"] = self.reading.mm
        if self.digits < PLENTY:
            data["exact_digits"] = self.digits
        return data | {
            "expected_error": self.expected_error if isfinite(self.expected_error) else None,
            "suspect": self.suspect is not None,
        }


def told_short(answer: Answer) -> Words:
    """How long it is on paper, and that this is too short: of an answer that is `short`."""
    length = about(abs(answer.reading.mm or 0.0))
    return Words(f"图上 {length}，", f"{length} on paper: ") + TOO_SHORT


def bearing(vector: complex) -> float:
    """The direction of a vector in degrees, from 0 and below 360: east is 0 however it was rounded."""
    turn = degrees(cmath.phase(vector)) % 360.0
    return 0.0 if turn > 360.0 - 1e-9 else turn


def place_of(at: complex) -> list[float]:
    """Its coordinates; 0 for one that is nothing but the rounding of the other."""
    return [0.0 if abs(part) <= _NOTHING * abs(at) else part for part in (at.real, at.imag)]


def line_of(which: str, acts: LineOfAction | None) -> dict[str, Any]:
    """A point (m) of the line of action,
    the sense of its moment about the pin where it touches a friction circle, a slide's couple (N·m)."""
    if acts is None:
        return {}
    couple = {} if acts.couple is None else {f"{which}couple": acts.couple}
    return {f"{which}point": place_of(acts.point), f"{which}tangent": acts.tangent or None} | couple


def reading_json(reading: Reading) -> dict[str, Any]:
    """What was drawn of one quantity of a force analysis: unit, value, direction, line of action, tangent side."""
    data: dict[str, Any] = {"unit": reading.unit, "drawn": None if isnan(reading.scalar) else reading.scalar}
    if reading.vector is not None:
        data["direction_deg"] = bearing(reading.vector) if reading.vector else None
    return data | line_of("", reading.acts)


def plain(data: Any) -> Any:
    """The data for JSON: null for what is not finite, and twelve digits,
    behind which a float holds only its own rounding."""
    match data:
        case dict():
            return {key: plain(value) for key, value in data.items()}
        case list():
            return [plain(value) for value in data]
        case float():
            return float(f"{data:.12g}") + 0.0 if isfinite(data) else None  # + 0.0: no −0
    return data


def small_table(answers: Iterable[Answer], lang: Lang) -> str:
    """Symbol, drawn and exact value, unit and expected drawing error of each answer, in columns."""
    rows = [_HEAD[lang], *(_row(answer) for answer in answers)]
    wide = [max(len(row[i]) for row in rows) for i in range(len(rows[0]))]
    return "\n".join(
        "  ".join(cell.ljust(width) for cell, width in zip(row, wide, strict=True)).rstrip() for row in rows
    )


def _row(answer: Answer) -> tuple[str, str, str, str, str]:
    flag = " !" if answer.suspect else ""
    return (
        answer.key,
        f"{answer.drawn:.5g}{flag}",
        f"{answer.exact:.5g}",
        answer.reading.unit,
        f"±{answer.expected_error:.2g}",
    )
