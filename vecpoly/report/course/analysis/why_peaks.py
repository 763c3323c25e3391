"""Chapter 8.2, why the peaks of the rates stand where they stand:
numerator and determinant of the formula by which each was computed."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from math import isfinite, log

import numpy as np
from numpy.typing import NDArray

from ....algebra.columns import significant
from ....cycle import Extremes, Spot
from ....findings.conditioning import Conditioning, determinant
from ....findings.output_links import ends, motions
from ....findings.shown import shown
from ....findings.study.study import Study
from ....words import Words
from ..numbering import SMALL, Press

_SECOND = 0.4  # of the maximum value: another peak worth a line
_PEAK = 1.8  # times the rms: a sine has √2, and less than this is no peak
_FURTHER = 1.5  # times the rms: of a quantity that has a peak, another one
_ROWS, _DIGITS = 16, 4
_ALIKE = 1e-6  # of the maximum value
_MAIN = 2.0  # times the other's logarithm: so much alone is the cause
_HEADER = {
    "zh": ["量", "单位", "峰值", "位置", "分母 $D$", "$N/N_m$", "$D/D_m$", "商", "成因"],
    "en": ["Quantity", "Unit", "Peak", "At", "Divisor $D$", "$N/N_m$", "$D/D_m$", "Quotient", "Cause"],
}
_PLACE = 3  # the column that is headed by the drive's own symbol
GREW, SHRANK = Words("分子增大引起", "numerator large"), Words("分母减小引起", "divisor small")
_BOTH = Words("两者兼有", "both")
_WHY = {  # by the words of the table
    GREW.zh: Words("峰值由分子增大引起", "the peak comes from a large numerator, not from a small divisor"),
    SHRANK.zh: Words("峰值由分母减小引起", "the peak comes from a small divisor, not from a large numerator"),
    _BOTH.zh: Words("分子增大和分母减小都是成因", "both a large numerator and a small divisor make the peak"),
}


@dataclass(frozen=True, slots=True)
class Cause:
    """A peak of a rate, the determinant in its formula, and determinant and numerator there,
    each over its own rms in the cycle."""

    key: str
    spot: Spot
    by: Conditioning
    down: float
    up: float

    @property
    def times(self) -> float:
        """How many times what usual numerator and determinant give, of both as they are printed."""
        return round(self.up, 2) / max(round(self.down, 2), 1e-9)

    @property
    def words(self) -> Words:
        """Which of the two makes the peak: the product of up and 1/down."""
        numerator, divisor = log(max(round(self.up, 2), 1e-9)), -log(max(round(self.down, 2), 1e-9))  # as printed
        if divisor <= 0 or numerator >= _MAIN * divisor:
            return GREW
        if numerator <= 0 or divisor >= _MAIN * numerator:
            return SHRANK
        return _BOTH


def causes(study: Study, groups: list[Conditioning]) -> list[Cause]:
    """The peaks of the rates: all of the output links', of the others asked for the greatest;
    in the order of solution."""
    found = []
    for key, by, is_own in _told(study, groups):
        spots, usual = tops(study, study.extremes(key)), rms(study, study.turn.real(key))
        top = max((abs(s.value) for s in spots), default=0.0)
        if top >= _PEAK * usual > 0:
            found += [
                _cause(study, key, s, by)
                for s in spots
                if abs(s.value) >= (_FURTHER * usual if is_own else (1 - _ALIKE) * top)
            ]
    known = [one for one in found if isfinite(one.down + one.up)]  # at a change point both vanish
    return known[-_ROWS:]


def _told(study: Study, groups: list[Conditioning]) -> Iterator[tuple[str, Conditioning, bool]]:
    """Keys with the group by whose determinant each is divided, those of the output links last;
    whether it is one of these."""
    asked = [key for key in study.outputs if key.startswith(("omega_", "alpha_"))] or [
        f"{stem}_{link}" for link in study.links for stem in ("omega", "alpha") if study.varies(f"{stem}_{link}")
    ]
    own = {key: link for link in ends(study) for key in motions(study, link)}
    for key, link in {**{key: key.partition("_")[2] for key in asked if key not in own}, **own}.items():
        by = next((g for g in groups if any(link in (one, study.name(one)) for one in g.group.links)), None)
        if by is not None:
            yield key, by, key in own


def flat(study: Study, groups: list[Conditioning]) -> Iterator[Words]:
    """That nothing has a peak, in numbers; of a drive that turns right round."""
    ratios = [
        top / usual
        for key, *_ in _told(study, groups)
        if (usual := rms(study, study.turn.real(key)))
        and (top := max((abs(s.value) for s in tops(study, study.extremes(key))), default=0.0))
    ]
    if ratios and study.whole.whole and max(ratios) < _PEAK:
        low, high = f"{min(ratios):.2f}", f"{max(ratios):.2f}"
        span, span_en = (high, high) if low == high else (f"{low}～{high}", f"{low} to {high}")
        yield Words(
            f"各构件的速度、加速度没有突出的峰值：最大绝对值与均方根值之比为 {span}（按正弦规律变化时为 √2 = 1.41）。",
            f"Velocities and accelerations have no pronounced peaks: the largest absolute value is {span_en} times the "
            "rms (√2 = 1.41 for a sine).",
        )


def tops(study: Study, found: Extremes) -> list[Spot]:
    """The greatest absolute value, and other peaks of nearly half of it, of either sign;
    in order of the input link's position."""
    every = [
        s
        for s in (*(s for s in found.maxima if s.value > 0), *(s for s in found.minima if s.value < 0))
        if np.isfinite(s.value)
    ]
    if found.is_constant or not every:
        return []
    top = max(abs(s.value) for s in every)
    return sorted((s for s in every if abs(s.value) > _SECOND * top), key=lambda s: s.phi)


def _cause(study: Study, key: str, spot: Spot, by: Conditioning) -> Cause:
    here = float(determinant(study, by.group, np.array([spot.phi]))[0])
    sizes = determinant(study, by.group, study.turn.phi)
    down, up = rms(study, sizes), rms(study, study.turn.real(key) * sizes)
    return Cause(key, spot, by, here / down if down else 0.0, abs(spot.value) * here / up if up else 0.0)


def rms(study: Study, values: NDArray[np.float64]) -> float:
    """Root mean square of the values there are on the fine grid, of which both ends of a whole turn are one place."""
    known = values[:-1] if study.whole.whole else values
    known = known[np.isfinite(known)]
    return float(np.sqrt(np.mean(known**2))) if known.size else 0.0


def table(study: Study, press: Press, told: list[Cause]) -> str:
    """The peaks with their causes; of a single one nothing, for a sentence tells it."""
    rows = [_row(study, one, press) for one in told]
    title = Words("各量的峰值及其成因", "The peaks and their causes")
    heads = [f"${study.turn.drive.symbol}$" if n == _PLACE else head for n, head in enumerate(_HEADER[press.lang])]
    return press.table(title, heads, rows, "lcddcdddl", style=SMALL) if len(rows) > 1 else ""


def _row(study: Study, one: Cause, press: Press) -> tuple[str, ...]:
    info = study.whole.info(one.key)
    return (
        f"${info.symbol}$",
        info.shown_unit.replace("^2", "²") or "—",
        significant(info.factor * one.spot.value, _DIGITS),
        study.where(one.spot.phi).split(" = ")[1],
        f"${one.by.symbol}$",
        f"{one.up:.2f}",
        f"{one.down:.2f}",
        f"{one.times:.2f}",
        one.words.of(press.lang),
    )


def alone(study: Study, one: Cause) -> Words:
    """The only peak, and why it is there, in sentences."""
    symbol, value = f"${study.whole.info(one.key).symbol}$", shown(study, one.key, one.spot.value)
    at, by, up, down = study.where(one.spot.phi), f"${one.by.symbol}$", f"{one.up:.2f}", f"{one.down:.2f}"
    why = _WHY[one.words.zh]
    return Words(
        f"突出的峰值只有一个：{symbol} = {value}（{at}）。该处分子为其均方根值的 {up} 倍，分母 {by} 为其均方根值的 "
        f"{down} 倍，峰值是两均方根值之商的 {up}/{down} = {one.times:.2f} 倍，所以{why.zh}。",
        f"There is one pronounced peak: {symbol} = {value} at {at}. There the numerator is {up} times its own root "
        f"mean square (rms), the divisor {by} {down} times: the peak is {up}/{down} = {one.times:.2f} times what these "
        f"two give, and {why.en}.",
    )
