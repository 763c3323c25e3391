"""The section on the work over the period: the constant moment, surplus and deficit, ΔW_max."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from ....algebra.quantity import number
from ....algebra.rounding import places_of, read_back, rounds_to, to_places
from ....findings.machine.running import Running
from ....findings.study.study import Study
from ....mechanism.asked.forces import load_symbol
from ....words import Words
from ..numbering import Press
from ..results.plots import Plotted, given
from ..results.tabled import decimal

_HEADER = {
    "zh": ["区间", "性质", "$ΔW$ /J", "终点处 $E$ /J"],
    "en": ["From–to", "Work is", "$ΔW$ /J", "$E$ at its end /J"],
}
_Reals = NDArray[np.float64]
_KINDS = (Words("亏功", "lost"), Words("盈功", "gained"))
_LITTLE = 1e-9  # of the maximum surplus: no piece of its own
POINTS = 9  # of a piece of the period
_GUARD = 3  # decimals beyond those of a difference that its terms may have


def work(study: Study, press: Press, run: Running) -> dict[str, Any]:
    """Words, the table of surplus and deficit, the curve of the energy."""
    return {
        "title": Words("一个周期内的功、最大盈亏功", "Work over the period").of(press.lang),
        "words": [_told(study, run).of(press.lang)],
        "tables": [_table(study, press, run)],
        "figures": press.figures([energy(study, press.lang, run)]),
    }


def _told(study: Study, run: Running) -> Words:
    high, low = (where(study, run, top.psi) for top in (run.high, run.low))
    surplus = number(run.surplus, 5)
    top, least = _terms(run, surplus)
    told = f"$ΔW_{{max}}$ = {top} − {f'({least})' if least.startswith('−') else least} = {surplus} J"
    return _moment(run) + Words(
        f"动能 $E$ = ∫$M$ d$φ$ 在 {high} 处最大、{low} 处最小，最大盈亏功 {told}（自 {zero(study, run)} 起算）。",
        f"The energy $E$ = ∫$M$ d$φ$, counted from {zero(study, run)} on, is greatest at {high} and least at {low}: "
        f"{told}.",
    )


def _terms(run: Running, surplus: str) -> tuple[str, str]:
    """The two energies with the decimals of their difference as it is printed, or with so many more that they give it:
    2.3 − (−1011.4) = 1013.7."""
    size, half = read_back(surplus)
    both = [_plain(run, spot.value) for spot in (run.high, run.low)]
    for places in range(places_of(surplus), places_of(surplus) + _GUARD):
        top, least = (to_places(value, places) for value in both)
        if rounds_to(top - least, size, half):
            break
    return decimal(top, places), decimal(least, places)


def _moment(run: Running) -> Words:
    """The constant moment, and where it comes from."""
    if not run.name:
        return Words("各载荷在一个周期内所作的功之和为零。", "Over the period the works of the loads add up to zero. ")
    size, symbol = number(abs(run.constant), 5), f"${load_symbol(run.name)}$"
    sense = Words("逆时针", "counter-clockwise") if run.constant > 0 else Words("顺时针", "clockwise")
    drives = run.of.constant > 0
    role = Words("驱动力矩", "driving") if drives else Words("阻力矩", "resisting")
    opening = (
        Words(
            f"题目没有给出使功平衡的常力矩；设等效构件上另有常值的{role.zh} {symbol}。",
            f"The problem has no constant moment of its own: a {role.en} one, {symbol}, is thought on the link. ",
        )
        if run.thought
        else Words.same("")
    )
    return opening + Words(
        f"一个周期内驱动功等于阻力功，常值的{role.zh} {symbol} = {size} N·m（{sense.zh}）。",
        f"Over the period the work given equals the work taken, so that the constant {role.en} moment is {symbol} = "
        f"{size} N·m ({sense.en}). ",
    )


def where(study: Study, run: Running, psi: float) -> str:
    """$φ_1$ = 60° of a place of the period."""
    return f"${study.turn.drive.symbol}$ = {number(round(run.of.degrees(psi), 2) % np.degrees(run.of.period), 5)}°"


def zero(study: Study, run: Running) -> str:
    """Where the energy is counted from."""
    return where(study, run, float(run.of.cuts[0]))


def _table(study: Study, press: Press, run: Running) -> str:
    """From one place where the resultant moment changes its sign to the next."""
    rows, places = [], places_of(number(run.surplus, 5))
    for a, b, gain, end in pieces(run):
        span = f"{_angle(run, a)}–{_angle(run, b)}"
        both = (decimal(value, places) for value in (gain, _plain(run, end)))
        rows.append((span, _KINDS[gain > 0].of(press.lang), *both))
    return press.table(Words("盈功和亏功", "Surplus and deficit of work"), _HEADER[press.lang], rows, "lcrr")


def _angle(run: Running, psi: float) -> str:
    """In degrees, the period's own end not called 0°."""
    return f"{np.degrees(run.of.sense * psi) % (np.degrees(run.of.period) + 1e-7):.1f}°"


def _plain(run: Running, energy: float) -> float:
    """An energy (J): nothing for what rounding leaves beside the maximum surplus."""
    return 0.0 if abs(energy) < _LITTLE * run.surplus else energy


def pieces(run: Running) -> list[tuple[float, float, float, float]]:
    """From, to (ψ), work (J), energy at the end (J) of each stretch of one sign of the resultant moment."""
    of = run.of
    places, at = of.sampled(POINTS)
    moments = of.of_pieces(of.moments, at)
    energies = of.of_pieces(of.works, at)
    psi, energy, sign = places.ravel(), energies.ravel(), np.sign(moments.ravel())
    turns = [i for i in range(1, len(psi)) if sign[i] and sign[i - 1] and sign[i] != sign[i - 1]]
    ends = [_crossing(run, float(psi[i - 1]), float(psi[i])) for i in turns]
    marks = [float(psi[0]), *ends, float(psi[-1])]
    heights = [float(energy[0]), *(float(of.at(of.works, np.array([q]))[0]) for q in ends), float(energy[-1])]
    return [
        (a, b, high - low, high)
        for a, b, low, high in zip(marks, marks[1:], heights, heights[1:], strict=False)
        if abs(high - low) > _LITTLE * run.surplus
    ]


def _crossing(run: Running, low: float, high: float) -> float:
    """Where the moment is nothing between two places; the place itself where it jumps."""
    of = run.of

    def moment(psi: float) -> float:
        return float(of.at(of.moments, np.array([psi]))[0])

    if high - low < 1e-12:
        return high
    first = moment(low) > 0
    for _ in range(60):
        middle = (low + high) / 2
        low, high = (middle, high) if (moment(middle) > 0) == first else (low, middle)
    return (low + high) / 2


def energy(study: Study, lang: str, run: Running) -> Plotted:
    of = run.of
    angle, at = of_period(run)
    height = of.of_pieces(of.works, at).ravel()
    marks = tuple((of.degrees(top.psi), _plain(run, top.value)) for top in (run.high, run.low))
    symbol = study.turn.drive.symbol
    title = Words(f"盈亏功累计值 $E$ 随 ${symbol}$ 的变化", f"$E$ over ${symbol}$; dots: maximum, minimum")
    return given(study, lang, (angle, height), ("E", "J"), title, marks=marks)


def of_period(run: Running) -> tuple[_Reals, _Reals]:
    """The drive's angles (degrees) from the period's beginning to its end, and where they lie in their pieces."""
    places, at = run.of.sampled(POINTS)
    angle, span = np.degrees(run.of.sense * places.ravel()), float(np.degrees(run.of.period))
    return angle - span * np.floor(angle.min() / span + 1e-9), at
