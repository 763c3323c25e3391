"""The alarm: a drawn value that the exact one contradicts, or that is not finite, never passes as an answer.

Every answer is weighed here by its numbers alone, whatever method drew it. Two hands are asked: the one that drew the
sheet, which may be off by its expected error, and an ideal one, which must agree with the oracle but for rounding.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from enum import StrEnum
from math import inf, isfinite, isnan, nan
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..foundation.slotted import dataclass
from ..names import Rel
from ..words import Words
from .truth import Truth

NEAR = 1e-5  # of that size: beyond it what was found on the way is wrong, however much rounding was magnified there
AGREE = 1e-7  # of the size of such quantities: what an ideal hand may be off by rounding alone
VAGUE, LEGIBLE = 0.5, 0.1  # of its own measure: an expected error with which a value so far off tells nothing
MOST = 6  # symbols in a warning
ENOUGH, FEWEST = 200, 15  # hands from which σ is known; fewer tell nothing: all may round to the same tenth
RARE = 3.09  # σ of the normal distribution beyond which, on one side, lies 0.1 %
Number = complex | float


def alarm_at(expected_error: float, scalars: Any, *, scatters: bool) -> float:
    """How far from the exact value a drawn one may lie before it is suspect.

    The expected error, 3σ; or, where the repeated hands have long tails, the farthest of them from their median. A hand
    that scatters itself exceeds 3σ once in 370 readings and is allowed 5σ, once in two million. σ from few hands may
    come out too small.
    """
    repeated = np.asarray(scalars)[1:] if np.ndim(scalars) else np.empty(0)
    found = repeated[np.isfinite(repeated)]
    tail = float(np.max(np.abs(found - _median(found)))) if found.size else 0.0
    return max(expected_error * (5 / 3 if scatters else 1.0) * _unsure(repeated.size), tail)


def _unsure(hands: int) -> float:
    """How much larger than found σ may be (once in 1000 drawings it is), from so few hands; 1 from as many as usual.

    (n−1) s²/σ² has the distribution χ², whose quantile is ν (1 − 2/9ν + z √(2/9ν))³ (Wilson and Hilferty, 1931).
    """
    if hands >= ENOUGH or not hands:
        return 1.0
    return _quantile(ENOUGH) / _quantile(hands) if hands >= FEWEST else inf


def _quantile(hands: int) -> float:
    """√(χ²/ν) at 0.1 %."""
    part = 2.0 / (9.0 * (hands - 1))
    return float((1.0 - part - RARE * part**0.5) ** 1.5)


def _median(found: NDArray[np.float64]) -> float:
    """The middle value; numpy's own would import its masked arrays, which take longer than the rest of a solution."""
    low, high = np.sort(found)[[(found.size - 1) // 2, found.size // 2]]
    return float((low + high) / 2)


class Cause(StrEnum):
    """Why a value is suspect."""

    NOT_FINITE = "not finite"
    APART = "drawing and analysis disagree"
    BEYOND = "beyond the expected drawing error"
    VAGUE = "drawn too badly to be read"


@dataclass(frozen=True, slots=True, kw_only=True)
class Weighed:
    """A value as drawn, as an ideal hand would draw it, and exact (SI), with what each may be off.

    drawn, exact: compared by size. ideal, true: compared as vectors, where they are. reach: expected error of the drawn
    value beyond which it is suspect, NaN where none is known. noise: what the exact value itself may be off by. size:
    of such quantities here. steady: whether the hand that drew the sheet does not scatter itself.
    expected: the expected error that is told, NaN likewise. own: what the value itself is measured by, whatever else is
    asked: its size, or what can just be read where that is less.
    """

    drawn: float
    exact: float
    ideal: Number
    true: Number
    reach: float
    noise: float
    size: float
    own: float
    expected: float = nan
    steady: bool = True

    @property
    def cause(self) -> Cause | None:
        """Why the value is suspect; None where it is not, nor where both hands and the oracle find that it has none:
        0/0."""
        if isnan(self.drawn) and isnan(self.exact) and isnan(abs(self.ideal)):
            return None
        if not (isfinite(self.drawn) and isfinite(self.exact) and isfinite(abs(self.ideal))):
            return Cause.NOT_FINITE
        if abs(self.ideal - self.true) > AGREE * self.size + self.noise:
            return Cause.APART
        if abs(self.drawn - self.exact) > self.reach + AGREE * self.size + self.noise:
            return Cause.BEYOND
        return Cause.VAGUE if self._tells_nothing else None

    @property
    def _tells_nothing(self) -> bool:
        """Whether the expected error is larger than the value, or nearly so and the value not near the exact one.

        Not of a hand that scatters: it shows what comes of such data.
        """
        off = abs(self.drawn - self.exact)
        nearly = self.reach > VAGUE * self.own and off > LEGIBLE * self.own + self.noise
        return self.steady and (self.expected > self.own or nearly)


def contradicted(truth: Truth, motion: Mapping[Rel, Number]) -> list[Rel]:
    """Of what an ideal hand found on its way, asked for or not, all that the oracle contradicts."""
    known = {rel: value for rel in motion if (value := truth.known(rel)) is not None}
    likely = truth.likely if known else {}
    size: dict[str, float] = {}
    for rel, value in known.items():
        size[rel.unit] = max(abs(value), size.get(rel.unit) or likely.get(rel.unit) or 1.0)
    return [rel for rel, value in known.items() if not abs(motion[rel] - value) <= NEAR * size[rel.unit]]


_SAID = {
    Cause.NOT_FINITE: Words("不是有限值", "not finite"),
    Cause.APART: Words("作图与解析结果不符", "drawing and analysis disagree"),
    Cause.VAGUE: Words(
        "作图条件不良，预期作图误差与该量本身相当，读数不能采用",
        "so badly conditioned that the drawing error is as large as the quantity",
    ),
    Cause.BEYOND: Words("与精确值之差超出预期作图误差", "farther from the exact value than the expected drawing error"),
}


def warning(found: Iterable[tuple[str, Cause]]) -> Words | None:
    """The warning over a solution with suspect answers (symbol and cause of each); None where none is suspect."""
    causes: dict[Cause, list[str]] = {}
    for symbol, cause in found:
        causes.setdefault(cause, []).append(f"${symbol}$")
    if not causes:
        return None
    zh = "；".join(
        f"{'、'.join(symbols[:MOST])}{' 等' * (len(symbols) > MOST)} {_SAID[cause].zh}"
        for cause, symbols in causes.items()
    )
    en = "; ".join(
        f"{', '.join(symbols[:MOST])}{' …' * (len(symbols) > MOST)}: {_SAID[cause].en}"
        for cause, symbols in causes.items()
    )
    return Words(f"结果存疑，不得作为答案：{zh}。", f"Suspect, not to be taken as an answer: {en}.")
