"""What the table of peaks shows: unlike causes of one quantity, peaks that stand together, a swift reversal of α."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import pairwise

import numpy as np

from ....algebra.quantity import number
from ....analytic.expr import Var
from ....findings.conditioning import determinant
from ....findings.shown import shown
from ....findings.study.study import Study
from ....words import Words
from .why_peaks import GREW, SHRANK, Cause

_NEAR = 20.0  # degrees of the input link from the least determinant
_SWIFT = 60.0  # degrees of the input link within which α goes from one peak to the opposite one


def remarks(study: Study, told: list[Cause]) -> Iterator[Words]:
    """What the table shows: different causes of one quantity's peaks,
    a swift reversal of α, and that no jump occurs."""
    for key in dict.fromkeys(one.key for one in told if one.key.startswith("omega_")):
        own = [one for one in told if one.key == key]
        if {GREW, SHRANK} <= {one.words for one in own}:
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
            f"The peaks of {en} lie within {widest} of the position where {what} is least ({at}){more.en}.",
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
