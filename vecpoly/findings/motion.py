"""Chapter 8.1, how the mechanism moves: full rotation, turns, limit positions with their cause, quick return, evenness
of the output."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import pairwise
from math import degrees

import numpy as np

from ..algebra.quantity import number
from ..cycle import Column, Extremes, Spot
from ..cycle.facts.found import Stroke
from ..mechanism.groups.assur import decompose
from ..mechanism.rams import driver_words
from ..words import Words
from .conditioning import Conditioning
from .grashof import full_rotation
from .guide_bars import winding
from .limits import limit
from .output_links import ends, on_frame
from .study.study import Study
from .symmetry import symmetry

_STILL = 0.03  # of the whole swing: a stroke so short is nearly a dwell
_ALIKE = 1e-6  # of the greatest value: two extremes are one
_EVEN = 1.0005  # K below: no quick return worth a word


def motion(study: Study, groups: list[Conditioning]) -> Iterator[Words]:
    """The facts of the cycle in order."""
    loops = tuple(full_rotation(study))
    yield from loops
    yield from _range(study, bool(loops), _singular(study, groups))
    yield from _turns(study)
    for stroke in study.facts.strokes:
        yield _stroke(study, stroke)
    yield from _swings(study)
    yield from symmetry(study)
    for link in study.facts.turns or {}:
        yield from evenness(study, link)


def shown(study: Study, key: str, value: float, digits: int = 4) -> str:
    """A value of a column with its unit, for prose."""
    info = study.whole.info(key)
    unit = info.shown_unit.replace("^2", "²")
    if not np.isfinite(value):
        return "∞" if value > 0 else "−∞"
    text = f"{info.factor * value:.1f}".replace("-", "−") if unit == "°" else number(info.factor * value, digits)
    return text + (unit if unit == "°" else f" {unit}" if unit else "")


def places(study: Study, found: Extremes, spot: Spot) -> Words:
    """All the positions of the drive in which a turning point is as high (or low) as this one."""
    near = _ALIKE * max(
        abs(s.value) for s in (found.highest, found.lowest, spot) if s is not None and np.isfinite(s.value)
    )
    spots = [s for s in (*found.maxima, *found.minima) if abs(s.value - spot.value) <= near] or [spot]
    every = list(dict.fromkeys(study.where(s.phi) for s in sorted(spots, key=lambda s: study.reduced(s.phi))))
    told = [every[0], *(place.split(" = ")[1] for place in every[1:])]
    return Words("、".join(told), " and ".join(told))


def _driver(study: Study) -> Words:
    """原动件 1 / the driving link 1; 油缸 2-3 / the cylinder 2-3."""
    if study.mech.drive.between:
        return driver_words(study.mech)
    return Words(f"原动件 {study.mech.drive.link} ", f"the driving link {study.mech.drive.link}")


def _range(study: Study, told: bool, dead: Words) -> Iterator[Words]:
    driver, whole, free = _driver(study), study.entire, study.facts.unlimited
    if whole.whole:
        yield Words(
            f"计算结果{'与此一致' if told else '表明'}：{driver.zh}整周转动时，机构在全部位置均可装配，无死点。",
            f"The calculation {'agrees' if told else 'shows'}: the mechanism can be assembled in "
            f"every position of {driver.en}, and there is no dead point.",
        )
        return
    drive = whole.drive
    unit = "°" if drive.shown_unit == "°" else f" {drive.shown_unit}"
    low, high = (f"{drive.factor * q:.2f}{unit}".replace("-", "−") for q in (whole.low, whole.high))
    if all(free):
        yield Words(
            f"{driver.zh}的行程不受杆组限制；计算取 ${drive.symbol}$ 由 {low} 至 {high}。",
            f"Nothing limits the stroke of {driver.en}; ${drive.symbol}$ is taken from {low} to {high}.",
        )
        return
    if any(free):
        end, taken = (high, low) if free[0] else (low, high)
        yield Words(
            f"{driver.zh}的行程一端受限：${drive.symbol}$ = {end} 处，{dead.zh}，为死点；另一端不受限制，"
            f"计算取至 {taken}。",
            f"The stroke of {driver.en} is limited at one end: at ${drive.symbol}$ = {end} "
            f"{dead.en}, a dead point; the other end is free, and {taken} is only as far as is "
            "computed.",
        )
        return
    bound = (
        Words("的行程有限", "has a limited stroke")
        if study.mech.drive.slide
        else Words("不能整周运动", "cannot make full revolutions")
    )
    yield Words(
        f"{driver.zh}{bound.zh}，${drive.symbol}$ 只能在 {low} 至 {high} 之间"
        + (f"；在两极限位置，{dead.zh}，为以{driver.zh}驱动时的死点，速度无确定值。" if study.facts.dead else "。"),
        f"{driver.en[0].upper()}{driver.en[1:]} {bound.en}: ${drive.symbol}$ is limited to {low} … "
        f"{high}"
        + (f". At these limits {dead.en}: dead points, with no definite velocities." if study.facts.dead else "."),
    )


def _singular(study: Study, groups: list[Conditioning]) -> Words:
    """What stands so at a dead point that the drive goes no further: the group whose determinant vanishes."""
    worst = min(groups, key=lambda one: one.ratio, default=None)
    kind = next((g.kind for g in decompose(study.mech) if worst is not None and g.links == worst.group.links), "")
    if worst is not None and kind == "RRR":
        return Words(f"{worst.group.title.zh}的两杆共线", f"both bars of the {worst.group.title.en} are in one line")
    if worst is not None and kind == "RRP":
        return Words(
            f"{worst.group.title.zh}的连杆垂直于导路",
            f"the coupler of the {worst.group.title.en} is at right angles to the guide",
        )
    if worst is not None and kind in ("PRP", "RPP"):
        return Words(f"{worst.group.title.zh}的两导路平行", f"both guides of the {worst.group.title.en} are parallel")
    return Words(
        "从动杆组处于奇异位置（速度方程组的行列式为零）",
        "the driven group is singular (the determinant of its velocity equations is zero)",
    )


def _turns(study: Study) -> Iterator[Words]:
    """Which driven links turn round, and how often."""
    turns = {name: count for name, count in (study.facts.turns or {}).items() if name != study.mech.drive.link}
    counts = dict.fromkeys(count for count in turns.values() if count)
    alike = [([study.name(n) for n, c in turns.items() if c == count], count) for count in counts]
    rocking = [study.name(n) for n, c in turns.items() if not c]
    if alike:
        zh = "，".join(f"构件 {'、'.join(names)} {'同' if c > 0 else '反'}向转 {abs(c)} 周" for names, c in alike)
        en = "; ".join(
            f"{_links_en(names)} {'makes' if len(names) == 1 else 'make'} {abs(c)} "
            f"{'turn' if abs(c) == 1 else 'turns'} in {'the same' if c > 0 else 'the opposite'} sense"
            for names, c in alike
        )
        yield Words(
            f"原动件每转一周：{zh}" + (f"；构件 {'、'.join(rocking)} 不作整周转动。" if rocking else "。"),
            f"In one turn of the drive {en}"
            + (f"; {_links_en(rocking)} {'does' if len(rocking) == 1 else 'do'} not turn round." if rocking else "."),
        )


def _links_en(names: list[str]) -> str:
    return f"link {names[0]}" if len(names) == 1 else f"links {', '.join(names[:-1])} and {names[-1]}"


def _stroke(study: Study, stroke: Stroke) -> Words:
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
    zh = f"{inner.zh}${info.symbol}$ 的两极限位置为 {low.zh}和 {high.zh}，{what.zh} {swing}；"
    en = f"{inner.en}${info.symbol}$ has the limits {low.en} and {high.en}, the {what.en} being {swing}; "
    if stroke.ratio < _EVEN:
        return Words(
            zh + "往返所用原动件转角相等，$K$ = 1，无急回特性。",
            en + "both strokes take the same angle of the drive, $K$ = 1: no quick return.",
        )
    up = Words("增大", "forward") if forth > back else Words("减小", "backward")
    slow, quick = max(forth, back), min(forth, back)
    weak = Words("，急回不明显" if stroke.ratio < 1.05 else "", ", a weak quick return" if stroke.ratio < 1.05 else "")
    return Words(
        zh + f"${info.symbol}$ {up.zh}的慢行程对应原动件转角 {slow:.1f}°，回程 {quick:.1f}°，行程速比系数 $K$ = "
        f"{slow:.1f}°/{quick:.1f}° = {stroke.ratio:.3f}，极位夹角 $θ$ = {degrees(stroke.theta):.2f}°{weak.zh}。",
        en + f"the slow {up.en} stroke takes {slow:.1f}° of the drive, the return {quick:.1f}°: $K$ = "
        f"{slow:.1f}°/{quick:.1f}° = {stroke.ratio:.3f}, $θ$ = "
        f"{degrees(stroke.theta):.2f}°{weak.en}.",
    )


def _placed(study: Study, key: str, spot: Spot) -> Words:
    """A limit, where it is, and what stands in one line or at right angles there."""
    value, at, why = shown(study, key, spot.value), study.where(spot.phi), limit(study, key, spot.phi)
    return Words(
        f"{value}（{at}{f'，{why.words.zh}' if why else ''}）", f"{value} ({at}{f', {why.words.en}' if why else ''})"
    )


def _swings(study: Study) -> Iterator[Words]:
    """Links that go to and fro more than once a cycle: all their limits, how far each stroke goes and what it takes of
    the drive."""
    for swing in (s for s in study.facts.swings if is_repeated(study, s)):
        assert swing.highest is not None and swing.lowest is not None
        info, drive, count = study.whole.info(swing.key), study.whole.drive, len(swing.maxima)
        spots = sorted((*swing.maxima, *swing.minima), key=lambda s: s.phi)
        factor, unit = info.factor, _unit(info)
        sizes, at = (
            [round(factor * s.value, 2) for s in spots],
            [round(drive.factor * study.reduced(s.phi), 2) for s in spots],
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
        taken, taken_en = "", ""
        if study.whole.whole and len(spots) == 2 * count:
            gaps = [(two - one) % 360 for one, two in pairwise((*at, at[0]))]
            told = [
                f"{abs(two - one):.2f}{unit} / {g:.2f}°"
                for (one, two), g in zip(pairwise((*sizes, sizes[0])), gaps, strict=True)
            ]
            dwell = _dwell(study, swing, spots)
            taken = (
                f"依次各行程的大小和所用的原动件转角为 {'、'.join(told)}，各行程长短不一，故不以单一的 $K$ "
                f"表示急回。{dwell.zh}"
            )
            taken_en = (
                f" The strokes, and the angles of the drive that they take, are {', '.join(told)}: no single "
                f"$K$ describes them.{dwell.en}"
            )
        yield Words(
            f"${info.symbol}$ 在一个循环内往复 {count} 次，各极限位置（括号内为 ${drive.symbol}$）"
            f"依次为 {'、'.join(limits)}{cause.zh}；总{'摆角' if info.unit == 'rad' else '行程'} {total}。"
            f"{taken}",
            f"${info.symbol}$ goes to and fro {count} times a cycle; its limits (${drive.symbol}$ "
            f"in brackets) are {', '.join(limits)} in turn{cause.en}; it covers {total} in "
            f"all.{taken_en}",
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
        f" From {start} to {stop} of the drive ${info.symbol}$ changes by about {drift} only: nearly a dwell.",
    )


def is_repeated(study: Study, swing: Extremes) -> bool:
    """Whether a link goes to and fro more than once a cycle."""
    told = {stroke.key for stroke in study.facts.strokes}
    return swing.key not in told and swing.highest is not None and swing.lowest is not None and len(swing.maxima) > 1


def evenness(study: Study, link: str) -> Iterator[Words]:
    """Of a driven link on the frame that turns round: its coefficient of non-uniformity; of another nothing."""
    key, count = f"omega_{link}", (study.facts.turns or {}).get(link, 0)
    if link == study.mech.drive.link or not count or link not in on_frame(study) or not study.varies(key):
        return
    found, mean = study.extremes(key), abs(count * study.mech.drive.rate)
    if found.highest is None or found.lowest is None or not mean:
        return
    one = found.highest.value * found.lowest.value > 0
    low, high = (shown(study, key, v) for v in (found.lowest.value, found.highest.value))
    average, delta = shown(study, key, count * study.mech.drive.rate), (found.highest.value - found.lowest.value) / mean
    turns = "1 turn" if abs(count) == 1 else f"{abs(count)} turns"
    round_ = winding(study, link, count)
    kind = Words("输出构件", "output") if link in ends(study) else Words("中间构件", "intermediate")
    yield Words(
        f"{kind.zh} {link} 整周转动{round_.zh}，$ω_{link}$ 在 {low} 至 {high} 之间，"
        f"{'转向不变，没有极限位置，不存在急回' if one else '中途反转'}；其平均值为 {average}（每循环 "
        f"{abs(count)} 周），速度不均匀系数 $δ$ = $(ω_{{max}} − ω_{{min}}) / |ω_m|$ = {delta:.2f}。",
        f"The {kind.en} link {link} makes full revolutions{round_.en}, with $ω_{link}$ between {low} and "
        f"{high}: "
        f"{'it does not reverse, so there are no limit positions and there is no quick return' if one else 'it reverses on the way'}. "
        f"Its mean is {average} ({turns} a cycle), the coefficient of non-uniformity $δ$ = $(ω_{{max}} − "
        f"ω_{{min}}) / |ω_m|$ = {delta:.2f}.",
    )
