"""Links that go to and fro: limits with their cause, quick return, every stroke where there are several a cycle."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import pairwise
from math import degrees

from ..algebra.rounding import to_places
from ..cycle import Column, Extremes, Spot
from ..cycle.facts.found import Stroke
from ..words import Words
from .limits import limit
from .output_links import ends
from .shown import shown
from .study.study import Study

_STILL = 0.03  # of the whole swing: a stroke so short is nearly a dwell
_OF_K, _FINEST = 3, 6  # decimals of K; of its angles, at most
_EVEN = 1.0005  # K below: no quick return worth a word


def limits_and_ratio(study: Study, stroke: Stroke) -> Words:
    """The limits of a link, why they are where they are, and K."""
    info = study.whole.info(stroke.key)
    low, high = (_placed(study, stroke.key, spot) for spot in (stroke.lower, stroke.upper))
    swing, forth, back = shown(study, stroke.key, stroke.swing), degrees(stroke.forth), degrees(stroke.back)
    what = Words("摆角" if info.unit == "rad" else "行程", "angle of swing" if info.unit == "rad" else "stroke")
    link = stroke.key.removeprefix("phi_")
    inner = (
        Words(f"中间构件 {study.name(link)}：", f"Intermediate link {study.name(link)}: ")
        if link in study.mech.bodies and link not in ends(study)
        else Words.same("")
    )
    quantity = "the angle" if info.unit == "rad" else "the travel"
    quantity = quantity if inner.en else quantity.capitalize()
    zh = f"{inner.zh}${info.symbol}$ 的两极限位置为 {low.zh}和 {high.zh}，{what.zh} {swing}；"
    en = f"{inner.en}{quantity} ${info.symbol}$ has the limits {low.en} and {high.en}, the {what.en} being {swing}; "
    if stroke.ratio < _EVEN:
        return Words(
            zh + "往返所用原动件转角相等，$K$ = 1，无急回特性。",
            en + "both strokes take the same angle of the input link, so $K$ = 1 and there is no quick return.",
        )
    up = Words("增大", "forward") if forth > back else Words("减小", "backward")
    slow, quick, ratio = _angles(max(forth, back), min(forth, back))
    theta = f"{degrees(stroke.theta):.{len(slow.partition('.')[2])}f}°"  # slow − 180°
    weak = Words("，急回不明显" if stroke.ratio < 1.05 else "", ", a weak quick return" if stroke.ratio < 1.05 else "")
    return Words(
        zh + f"${info.symbol}$ {up.zh}的慢行程对应原动件转角 {slow}°，回程 {quick}°，行程速比系数 $K$ = "
        f"{slow}°/{quick}° = {ratio}，极位夹角 $θ$ = {theta}{weak.zh}。",
        en + f"the slow {up.en} stroke takes {slow}° of the input link, the return {quick}°: $K$ = "
        f"{slow}°/{quick}° = {ratio} and $θ$ = {theta}{weak.en}.",
    )


def _angles(slow: float, quick: float) -> tuple[str, str, str]:
    """The angles of both strokes to a tenth of a degree, finer where their ratio K would not be that of the figures."""
    ratio = to_places(slow / quick, _OF_K)
    figures = ((f"{to_places(slow, n):.{n}f}", f"{to_places(quick, n):.{n}f}") for n in range(1, _FINEST + 1))
    fit = ((a, b) for a, b in figures if abs(float(a) / float(b) - ratio) <= 0.5 * 10**-_OF_K)
    one, other = next(fit, (f"{slow:.1f}", f"{quick:.1f}"))
    return one, other, f"{ratio:.{_OF_K}f}"


def _placed(study: Study, key: str, spot: Spot) -> Words:
    """A limit, where it is, and what stands in one line or at right angles there."""
    value, at, why = shown(study, key, spot.value), study.where(spot.phi), limit(study, key, spot.phi)
    return Words(
        f"{value}（{at}{f'，{why.words.zh}' if why else ''}）", f"{value} ({at}{f', {why.words.en}' if why else ''})"
    )


def repeated_strokes(study: Study) -> Iterator[Words]:
    """Links that go to and fro more than once a cycle:
    all their limits, how far each stroke goes and what it takes of the input link."""
    for swing in (s for s in study.facts.swings if is_repeated(study, s)):
        assert swing.highest is not None and swing.lowest is not None
        info, drive, count = study.whole.info(swing.key), study.whole.drive, len(swing.maxima)
        spots = sorted((*swing.maxima, *swing.minima), key=lambda s: s.phi)
        factor, unit = info.factor, _unit(info)
        sizes, at = (
            [round(factor * s.value, 2) for s in spots],
            [round(drive.told(study.reduced(s.phi)), 2) for s in spots],
        )
        limits = [
            f"{size:.2f}{unit} ({q:.2f}{_unit(drive)})".replace("-", "−") for size, q in zip(sizes, at, strict=True)
        ]
        total = shown(study, swing.key, swing.highest.value - swing.lowest.value)
        reasons = {why.words.zh: why.words.en for s in spots if (why := limit(study, swing.key, s.phi)) is not None}
        cause = Words(
            f"，各处均有 {'；'.join(reasons)}" if len(reasons) == 1 else "",
            f"; at each of them {' '.join(reasons.values())}" if len(reasons) == 1 else "",
        )
        moves = Words(f"在一个循环内往复 {count} 次", f"oscillates {count} times a cycle")
        if not study.whole.whole:
            moves = Words(f"在工作区间内换向 {len(spots)} 次", f"reverses {len(spots)} times in the working range")
        told = Words(
            f"${info.symbol}$ {moves.zh}，各极限位置（括号内为 ${drive.symbol}$）"
            f"依次为 {'、'.join(limits)}{cause.zh}；总{'摆角' if info.unit == 'rad' else '行程'} {total}。",
            f"${info.symbol}$ {moves.en}; its limits (${drive.symbol}$ "
            f"in brackets) are {', '.join(limits)} in turn{cause.en}; its range is {total}.",
        )
        if study.whole.whole and len(spots) == 2 * count:
            told += _taken(sizes, at, unit) + _dwell(study, swing, spots)
        yield told


def _taken(sizes: list[float], at: list[float], unit: str) -> Words:
    """How far each stroke goes, and the angle of the input link (deg) that it takes."""
    gaps = [(two - one) % 360 for one, two in pairwise((*at, at[0]))]
    told = [
        f"{abs(two - one):.2f}{unit} / {g:.2f}°"
        for (one, two), g in zip(pairwise((*sizes, sizes[0])), gaps, strict=True)
    ]
    return Words(
        f"依次各行程的大小和所用的原动件转角为 {'、'.join(told)}，各行程长短不一，故不以单一的 $K$ 表示急回。",
        f" The strokes, and the angles of the input link that they take, are {', '.join(told)}: no single "
        "$K$ describes them.",
    )


def _unit(column: Column) -> str:
    return "°" if column.shown_unit == "°" else f" {column.shown_unit}"


def _dwell(study: Study, swing: Extremes, spots: list[Spot]) -> Words:
    """Limits in succession between which the link hardly moves."""
    assert swing.highest is not None and swing.lowest is not None
    total, info = swing.highest.value - swing.lowest.value, study.whole.info(swing.key)
    runs: list[list[Spot]] = []
    for one, two in pairwise((*spots, *spots)):
        small = abs(two.value - one.value) < _STILL * total
        if small and runs and runs[-1][-1] is one:
            runs[-1].append(two)
        elif small:
            runs.append([one, two])
    run = max(runs, key=len, default=[])
    if len(run) < 2 or len(run) > len(spots):
        return Words.same("")
    drift = shown(study, swing.key, max(s.value for s in run) - min(s.value for s in run), 2)
    start, stop = (study.where(run[i].phi).split(" = ")[1] for i in (0, -1))
    return Words(
        f"其中 ${study.whole.drive.symbol}$ 由 {start} 至 {stop} 时 ${info.symbol}$ 只变化约 {drift}，近似停歇。",
        f" From {start} to {stop} of the input link ${info.symbol}$ changes by about {drift} only: nearly a dwell.",
    )


def is_repeated(study: Study, swing: Extremes) -> bool:
    """Whether a link goes to and fro more than once a cycle."""
    told = {stroke.key for stroke in study.facts.strokes}
    return swing.key not in told and swing.highest is not None and swing.lowest is not None and len(swing.maxima) > 1
