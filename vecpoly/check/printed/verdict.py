"""Printed answers weighed against exact ones: the verdict, and the usual slip that reproduces a wrong one.

reproduced: a calculated value within half a unit of its last printed digit, or of the last figure that the book
carried through its working, a value read off a drawing within 3 %.
rounding: off by one unit of the last digit, or by two and no more than 10 %. outlier: 3 to 10 %, a drawing slip; not of
a synthesis, where a mechanism built with such a length fails its task. wrong: anything else.
"""

from __future__ import annotations

import re
from dataclasses import dataclass
from enum import StrEnum
from math import floor, isclose, log10, pi

from ...names import Kind, Rel
from ...problem.problem import Printed
from ...words import Words

GRAPHICAL = 0.03  # relative deviation that a careful drawing may have
DEGREE = 1.0  # that of an angle, which is no share of it, whatever line it is counted from
MOST_DEGREES = 3.0  # beyond it, no drawing slip explains an angle
ZERO = 1e-9  # of the printed value: rounding of an exact zero
SLIP = 0.10  # beyond it, no drawing slip explains the number
_NUMBER = re.compile(r"[-+−]?(\d+)(?:\.(\d+))?(?:[eE]([-+]?\d+))?")


class Verdict(StrEnum):
    """How a printed answer fares."""

    REPRODUCED = "reproduced"
    ROUNDING = "rounding"
    OUTLIER = "outlier"
    WRONG = "wrong"

    @property
    def words(self) -> Words:
        """The verdict in words."""
        return {
            Verdict.REPRODUCED: Words("正确", "agrees"),
            Verdict.ROUNDING: Words("末位舍入", "rounding"),
            Verdict.OUTLIER: Words("作图误差偏大", "drafting error"),
            Verdict.WRONG: Words("错误", "wrong"),
        }[self]


@dataclass(frozen=True, slots=True, kw_only=True)
class Checked:
    """A printed answer with its exact value, relative deviation, verdict and, where one fits, the slip behind it."""

    printed: Printed
    exact: float
    deviation: float
    verdict: Verdict
    slip: Words | None = None


def check_printed(printed: Printed, exact: float, slip: float = SLIP) -> Checked:
    """Weigh one printed value; signs count only for scalars such as ω, α and moments, and only where the print has one.

    slip: relative deviation up to which a drawing slip explains a value read off a drawing.
    """
    scalar = printed.rel is not None and not printed.rel.is_vector
    value = printed.value if scalar else abs(printed.value)
    truth = exact if scalar and (value < 0 or _signed(printed)) else abs(exact)
    truth = 0.0 if abs(truth) < ZERO * abs(value) else truth
    deviation = (value - truth) / truth if truth else (0.0 if value == 0 else float("inf"))
    verdict = _verdict(printed, value, truth, deviation, slip)
    behind = _slip(printed, value, truth) if verdict is Verdict.WRONG else None
    return Checked(printed=printed, exact=truth, deviation=deviation, verdict=verdict, slip=behind)


def _signed(printed: Printed) -> bool:
    return bool(re.match(r"\s*[+\-−]", printed.text)) or any(w in printed.text for w in ("cw", "ccw", "顺", "逆"))


def _verdict(printed: Printed, value: float, truth: float, deviation: float, slip: float) -> Verdict:
    unit = max(last_digit(printed.text, value), _carried(printed, value))
    if printed.kind == "graphical" and is_angle(printed):
        gap = abs(value - truth)
        if gap <= max(DEGREE, unit / 2):
            return Verdict.REPRODUCED
        return Verdict.OUTLIER if gap <= (MOST_DEGREES if slip > GRAPHICAL else DEGREE) else Verdict.WRONG
    if printed.kind == "graphical":
        if abs(deviation) <= GRAPHICAL or abs(value - truth) <= unit / 2:
            return Verdict.REPRODUCED
        return Verdict.OUTLIER if abs(deviation) <= slip else Verdict.WRONG
    if abs(value - truth) <= unit / 2 * (1 + 1e-9) or isclose(value, truth, rel_tol=1e-9, abs_tol=1e-12):
        return Verdict.REPRODUCED
    units = abs(value - truth) / unit if unit else float("inf")
    return Verdict.ROUNDING if units <= 1 or (units <= 2 and abs(deviation) <= SLIP) else Verdict.WRONG


def is_angle(printed: Printed) -> bool:
    """Whether it is told in degrees."""
    return printed.rel is not None and printed.rel.unit == "deg"


def last_digit(text: str, value: float) -> float:
    """One unit of the last printed digit, in SI: from the number as written."""
    m = _NUMBER.search(text)
    return 0.0 if m is None else _power(m, int(m[3] or 0) - len(m[2] or ""), value)


def _carried(printed: Printed, value: float) -> float:
    """One unit of the last figure that was carried through the book's working, in SI; 0 where it is not said."""
    m = _NUMBER.search(printed.text)
    if printed.figures is None or m is None or not value:
        return 0.0
    return _power(m, floor(log10(abs(_written(m)))) + 1 - printed.figures, value)


def _power(m: re.Match[str], power: int, value: float) -> float:
    """So large a power of ten of the number as written, in SI."""
    written, unit = _written(m), 10.0**power
    return unit * abs(value / written) if written else unit


def _written(m: re.Match[str]) -> float:
    return float(m[0].replace("−", "-"))


UNITS: tuple[tuple[float, Words], ...] = (  # one number alone may bear these out
    (2 * pi / 60, Words("把 r/min 当作 rad/s（或相反）", "r/min taken for rad/s")),
    (60 / (2 * pi), Words("把 rad/s 当作 r/min（或相反）", "rad/s taken for r/min")),
    (1 / (2 * pi), Words("少乘 2π（把 r/s 当作 rad/s）", "2π left out (rev/s taken for rad/s)")),
    (1 / (4 * pi * pi), Words("少乘 (2π)²（把 r/s 当作 rad/s）", "(2π)² left out (rev/s taken for rad/s)")),
)
# 2: only many numbers together
FACTORS = (*UNITS, (2.0, Words("多乘 2", "a factor 2 too many")), (0.5, Words("少乘 2", "a factor 2 left out")))


def _slip(printed: Printed, value: float, truth: float) -> Words | None:
    """The usual slip that reproduces a wrong value:
    sign, power of ten, r/min, 2π, the 2 of the Coriolis term; or why it must be 0."""
    if not truth:
        return _why_zero(printed)
    if not value:
        return None
    ratio = value / truth
    if isclose(ratio, -1.0, rel_tol=GRAPHICAL):
        return Words("符号（转向）相反", "opposite sign (sense)")
    power = log10(abs(ratio))
    if round(power) and abs(power - round(power)) < 0.005:
        times = f"{10.0 ** round(power):g}"
        told = Words(f"有效数字相同，但为精确值的 {times} 倍", f"digits right, but {times} times the exact value")
        known = printed.note is not None  # why
        return told + (Words.same("") if known else Words("：检查单位或比例尺", ": check the units or the scale"))
    near = GRAPHICAL if printed.kind == "graphical" else 0.01
    if isinstance(printed.rel, Rel) and printed.rel.kind is Kind.AK and isclose(abs(ratio), 0.5, rel_tol=near):
        return Words("$a^k = 2 ω v_r$ 漏乘 2", "the 2 of $a^k = 2 ω v_r$ left out")
    return next((words for factor, words in UNITS if isclose(abs(ratio), factor, rel_tol=near)), None)


def _why_zero(printed: Printed) -> Words:
    """Why the exact value is 0, for which there is no relative deviation."""
    if isinstance(printed.rel, Rel) and printed.rel.kind in (Kind.OMEGA, Kind.ALPHA):
        rate = "ω" if printed.rel.kind is Kind.OMEGA else "α"
        return Words(
            f"构件 {printed.rel.to.link} 此时不转动（平动或瞬时平动），${rate}$ = 0"
            if rate == "ω"
            else f"构件 {printed.rel.to.link} 的 $α$ = 0",
            f"link {printed.rel.to.link} does not turn here, it translates: ${rate}$ = 0"
            if rate == "ω"
            else f"$α$ of link {printed.rel.to.link} is 0",
        )
    return Words("精确值为零", "the exact value is zero")
