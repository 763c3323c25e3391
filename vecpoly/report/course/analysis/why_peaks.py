"""Chapter 8.2, why the peaks of the rates stand where they stand: numerator and determinant of the formula by which
each was computed."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from itertools import pairwise
from math import log

import numpy as np
from numpy.typing import NDArray

from ....algebra.quantity import number
from ....analytic.expr import Var
from ....cycle import Extremes, Spot
from ....findings.conditioning import Conditioning, determinant
from ....findings.output_links import ends, motions
from ....findings.shown import shown
from ....findings.study.study import Study
from ....words import Words
from ..numbering import SMALL, Press

_SECOND = 0.4  # of the greatest value: another peak worth a line
_PEAK = 1.8  # times the rms: a sine has √2, and less than this is no peak
_FURTHER = 1.5  # times the rms: of a quantity that has a peak, another one
_ROWS = 16
_NEAR = 20.0  # degrees of the drive from the least determinant
_ALIKE = 1e-6  # of the greatest value
_MAIN = 2.0  # times the other's logarithm: so much alone is the cause
_SWIFT = 60.0  # degrees of the drive within which α goes from one peak to the opposite one
_HEADER = {
    "zh": ["量", "峰值", "原动件位置", "峰值/均方根", "分母", "分母/均方根", "分子/均方根", "成因"],
    "en": ["Quantity", "Peak", "Drive at", "Peak/rms", "Divided by", "Divisor/rms", "Numerator/rms", "Cause"],
}


@dataclass(frozen=True, slots=True)
class Cause:
    """A peak of a rate, the determinant in its formula, and determinant and numerator there, each over its own rms in
    the cycle."""

    key: str
    spot: Spot
    by: Conditioning
    down: float
    up: float

    @property
    def words(self) -> Words:
        """Which of the two makes the peak: the product of up and 1/down."""
        numerator, divisor = log(max(round(self.up, 2), 1e-9)), -log(max(round(self.down, 2), 1e-9))  # as printed
        if divisor <= 0 or numerator >= _MAIN * divisor:
            return Words("分子大", "large numerator")
        if numerator <= 0 or divisor >= _MAIN * numerator:
            return Words("分母小", "small divisor")
        return Words("两者兼有", "both")


def causes(study: Study, groups: list[Conditioning]) -> list[Cause]:
    """The peaks of the rates: all of the output links', of the others asked for the greatest; in the order of
    solution."""
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
    return found[-_ROWS:]


def _told(study: Study, groups: list[Conditioning]) -> Iterator[tuple[str, Conditioning, bool]]:
    """Keys with the group by whose determinant each is divided, those of the output links last; whether it is one of
    these."""
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
            f"各构件的速度、加速度没有突出的峰值：最大绝对值与循环内均方根值之比为 {span}（按正弦规律变化时为 "
            "√2 = 1.41）。",
            f"The rates have no pronounced peaks: the largest absolute value is {span_en} times the "
            "rms of the cycle (√2 = 1.41 for a sine).",
        )


def tops(study: Study, found: Extremes) -> list[Spot]:
    """The greatest absolute value, and other peaks of nearly half of it, of either sign; in order of the drive's
    position."""
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
    """The peaks with their causes."""
    rows = []
    for one in told:
        info, usual = study.whole.info(one.key), rms(study, study.turn.real(one.key))
        rows.append(
            (
                f"${info.symbol}$",
                shown(study, one.key, one.spot.value),
                study.where(one.spot.phi).split(" = ")[1],
                f"{abs(one.spot.value) / usual:.2f}" if usual else "—",
                f"${one.by.symbol}$",
                f"{one.down:.2f}",
                f"{one.up:.2f}",
                one.words.of(press.lang),
            )
        )
    return (
        press.table(
            Words("各量的峰值及其成因", "The peaks and their causes"),
            _HEADER[press.lang],
            rows,
            "lrrrcrrl",
            style=SMALL,
        )
        if rows
        else ""
    )


def remarks(study: Study, told: list[Cause]) -> Iterator[Words]:
    """What the table shows: different causes of one quantity's peaks, a swift reversal of α, and that no jump
    occurs."""
    for key in dict.fromkeys(one.key for one in told if one.key.startswith("omega_")):
        own = [one for one in told if one.key == key]
        if {"large numerator", "small divisor"} <= {one.words.en for one in own}:
            yield _contrast(study, own)
    yield from _gathered(study, told)
    yield from _reversal(study, told)
    if told and not study.mech.contacts and study.whole.whole and not study.facts.changes and not study.forces:
        yield Words(
            "加速度曲线连续，没有突变，既无刚性冲击也无柔性冲击。",
            "The accelerations are continuous: neither an infinite nor a finite jump of the acceleration occurs.",
        )


def _contrast(study: Study, own: list[Cause]) -> Words:
    """Peaks of one ω with unlike causes, in numbers: determinant and numerator there."""
    info, unit = (
        study.whole.info(own[0].key),
        (1e3, "mm") if own[0].by.group.determinant.__class__ is Var else (1e6, "mm²"),
    )
    parts, parts_en = [], []
    for one in own:
        here = float(determinant(study, one.by.group, np.array([one.spot.phi]))[0])
        size, top = (
            f"{number(unit[0] * here, 4)} {unit[1]}",
            f"{number(abs(one.spot.value) * here, 4)} {'m/s' if unit[1] == 'mm' else 'm²/s'}",
        )
        at = study.where(one.spot.phi)
        parts.append(f"{at} 处 |分子| = {top}、$|{one.by.symbol}|$ = {size}，{one.words.zh}")
        parts_en.append(f"at {at} the numerator is {top}, $|{one.by.symbol}|$ = {size}: {one.words.en}")
    return Words(
        f"${info.symbol}$ 的几个峰值成因不同：{'；'.join(parts)}。",
        f"The peaks of ${info.symbol}$ have different causes: {'; '.join(parts_en)}.",
    )


def _gathered(study: Study, told: list[Cause]) -> Iterator[Words]:
    """The peaks of a poorly conditioned group that stand about its least determinant."""
    drive = study.whole.drive
    if drive.shown_unit != "°" or not study.whole.whole:
        return
    for by in dict.fromkeys(one.by for one in told if one.by.is_poor):
        near = [
            (one, gap)
            for one in told
            if one.by is by and (gap := abs((drive.factor * (one.spot.phi - by.phi) + 180.0) % 360.0 - 180.0)) < _NEAR
        ]
        if len(near) < 2:
            continue
        named: dict[str, list[str]] = {}
        for one, _ in near:
            named.setdefault(study.whole.info(one.key).symbol, []).append(study.where(one.spot.phi).split(" = ")[1])
        widest, at = f"{np.ceil(10 * max(gap for _, gap in near)) / 10:.1f}°", study.where(by.phi)
        what = f"${study.whole.info(by.gamma.key).symbol}$" if by.gamma is not None else f"$|{by.symbol}|$"
        zh, en = (
            "、".join(f"${symbol}$（{'、'.join(places)}）" for symbol, places in named.items()),
            ", ".join(f"${symbol}$ ({', '.join(places)})" for symbol, places in named.items()),
        )
        more = Words(
            "：除以 $sin γ$ 使 $ω$ 增大，而 $α$ 的分子又含 $ω^2$ 项，故 $α$ 增大得更多",
            ": division by $sin γ$ raises $ω$, and the numerators of $α$ hold $ω^2$, so that $α$ rises still more",
        )
        more = (
            more
            if by.gamma is not None
            and by.is_ill
            and {"omega", "alpha"} <= {one.key.partition("_")[0] for one, _ in near}
            else Words.same("")
        )
        yield Words(
            f"{zh}的峰值在 {what} 最小处（{at}）前后 {widest} 以内{more.zh}。",
            f"The peaks of {en} lie within {widest} of the place where {what} is least ({at}){more.en}.",
        )


def _reversal(study: Study, told: list[Cause]) -> Iterator[Words]:
    """The α with the swiftest change of sign that takes little of the turn: all of its swift changes."""
    drive = study.whole.drive
    swift = [
        (one, two)
        for one, two in pairwise(told)
        if one.key == two.key
        and one.key.startswith("alpha_")
        and one.spot.value * two.spot.value < 0
        and drive.shown_unit == "°"
        and drive.factor * (two.spot.phi - one.spot.phi) < _SWIFT
    ]
    if not swift:
        return
    key = max(
        swift,
        key=lambda pair: (
            abs(pair[0].spot.value - pair[1].spot.value) / max(abs(pair[1].spot.phi - pair[0].spot.phi), 1e-9)
        ),
    )[0].key
    info, peak = study.whole.info(key), study.whole.info(key.replace("alpha", "omega")).symbol
    zh, en = [], []
    for one, two in (pair for pair in swift if pair[0].key == key):
        start, stop = (study.where(cause.spot.phi).split(" = ")[1] for cause in (one, two))
        low, high, gap = (
            shown(study, key, one.spot.value),
            shown(study, key, two.spot.value),
            f"{drive.factor * (two.spot.phi - one.spot.phi):.1f}°",
        )
        zh.append(f"${drive.symbol}$ 由 {start} 转到 {stop}（转过 {gap}）时 ${info.symbol}$ 由 {low} 变到 {high}")
        en.append(
            f"while ${drive.symbol}$ goes from {start} to {stop} ({gap}), ${info.symbol}$ goes from {low} to {high}"
        )
    yield Words(
        f"{'；'.join(zh)}。其间 ${info.symbol}$ 过零处即 ${peak}$ 的极值，惯性力矩随之迅速反向。",
        f"W{'; '.join(en)[1:]}. In between ${info.symbol}$ is zero, where ${peak}$ has its extreme, "
        "and the inertia moment reverses quickly.",
    )
