"""The facts of a cycle in words."""

from __future__ import annotations

from collections.abc import Iterator
from math import degrees

from ...mechanism.rams import driver_words
from ...words import Words
from ..cycle import Cycle
from ..extremes import Extremes, Spot, extremes
from .changing import figure_words
from .found import Facts, Peak
from .held import held
from .shown import number, shown, where
from .stroke_words import stroke_words
from .transmission_range import Transmission


def sentences(cycle: Cycle, found: Facts) -> tuple[Words, ...]:
    """Each fact as a sentence: how the links move, limits, quick return, transmission angles, dead points, peaks."""
    return (
        *_range(cycle, found),
        *held(cycle),
        *_turns(cycle, found),
        *_laps(cycle, found),
        *_changes(cycle, found),
        *(stroke_words(cycle, s) for s in found.strokes),
        *_swings(cycle, found),
        *(_transmission(cycle, t) for t in found.transmissions),
        *(_arm(cycle, a) for a in found.arms),
        *(_peak(cycle, p) for p in found.peaks),
    )


def _driver(cycle: Cycle) -> Words:
    """原动件 1 / The driving link 1; 油缸 2-3 / The cylinder 2-3."""
    if not cycle.mech.drive.between:
        return Words(f"原动件 {cycle.mech.drive.link} ", f"The driving link {cycle.mech.drive.link}")
    return Words((words := driver_words(cycle.mech)).zh, words.en[0].upper() + words.en[1:])


def _range(cycle: Cycle, found: Facts) -> Iterator[Words]:
    link, symbol = _driver(cycle), cycle.drive.symbol
    if found.whole:
        yield Words(
            f"{link.zh}可整周转动，机构在全部位置均可装配。",
            f"{link.en} can turn right round; the mechanism can be assembled in every position.",
        )
        return
    low, high = ends = [shown(cycle, cycle.drive.key, q, 6) for q in (cycle.low, cycle.high)]
    if all(found.unlimited):
        yield Words(
            f"{link.zh}的行程不受限制；这里取 ${symbol}$ 由 {low} 至 {high}。",
            f"{link.en} can move on without limit; ${symbol}$ is taken here from {low} to {high}.",
        )
        return
    bound = "的行程有限" if cycle.mech.drive.slide else "不能整周运动"
    zh = f"{link.zh}{bound}：${symbol}$ 只能在 {low} 至 {high} 之间。"
    en = f"{link.en} cannot move on for ever: ${symbol}$ is limited to {low} … {high}."
    if any(found.unlimited):
        free = ends[found.unlimited.index(True)]
        zh = f"{link.zh}的行程一端受限：这里 ${symbol}$ 在 {low} 至 {high} 之间，其中 {free} 只是计算所取的界限。"
        en += f" The end {free} is no limit, only as far as was looked."
    yield Words(zh, en)
    if found.dead:
        yield _dead(cycle, found.dead)


def _dead(cycle: Cycle, dead: tuple[Spot, ...]) -> Words:
    """The dead points of the input link: the ends of its range."""
    at = Words("在这两个极限位置", "At these two limits")
    if len(dead) != 2:
        here = where(cycle, dead[0])
        at = Words(f"在极限位置 {here}", f"At the limit {here}")
    return Words(
        f"{at.zh}，原动件为从动杆组所限，速度无定值（死点）。",
        f"{at.en} the dyad that it drives is stretched or folded, or its guides are parallel, and velocities have no "
        "single value (dead points).",
    )


def _turns(cycle: Cycle, found: Facts) -> Iterator[Words]:
    driven = {name: count for name, count in (found.turns or {}).items() if name != cycle.mech.drive.link}
    rocking = [name for name, count in driven.items() if count == 0]
    turning = {name: count for name, count in driven.items() if count}
    if turning:
        zh = "，".join(f"构件 {name} 转 {number(count)} 周" for name, count in turning.items())
        en = ", ".join(
            f"link {name} {number(count)} {'turn' if abs(count) == 1 else 'turns'}" for name, count in turning.items()
        )
        yield Words(
            f"原动件每转一周：{zh}（逆时针为正）。",
            f"In one turn of the input link: {en} (counter-clockwise positive).",
        )
    if rocking:
        yield Words(
            f"构件 {'、'.join(rocking)} 不作整周转动。",
            f"{'Link' if len(rocking) == 1 else 'Links'} {', '.join(rocking)} "
            f"{'does' if len(rocking) == 1 else 'do'} not turn round.",
        )


def _laps(cycle: Cycle, found: Facts) -> Iterator[Words]:
    """A mechanism that is elsewhere after one turn: what is told then is the first turn."""
    if not found.whole or found.laps == 1:
        return
    first = f"{shown(cycle, cycle.drive.key, cycle.low)} … {shown(cycle, cycle.drive.key, cycle.high)}"
    after = (
        Words(f"，转 {found.laps} 周后才复原", f"; it is so after {found.laps} turns") if found.laps else Words("", "")
    )
    yield Words(
        f"原动件转一周后，机构并未回到原来的位置{after.zh}；以下只是其中一周（${cycle.drive.symbol}$ 由 "
        f"{first}）的情况。",
        f"After one turn of the input link the mechanism is not back where it began{after.en}. What "
        f"follows is told of one turn only (${cycle.drive.symbol}$ = {first}).",
    )


def _changes(cycle: Cycle, found: Facts) -> Iterator[Words]:
    """Change points: the columns go smoothly through, as a real linkage does that is carried through by its inertia."""
    for key, spots in found.changes:
        links, places = key.removeprefix("gamma_"), ", ".join(shown(cycle, cycle.drive.key, s.phi, 5) for s in spots)
        yield Words(
            f"${cycle.drive.symbol}$ = {places} 处杆组 {links} 的各杆共线，两种装配在此重合（变点）。"
            f"以下按机构靠惯性平稳通过变点计算{figure_words(cycle, links).zh}。",
            f"At ${cycle.drive.symbol}$ = {places} dyad {links} lies in one line and its two "
            "assemblies meet (change points). What follows goes smoothly through them, as inertia "
            f"carries a real linkage{figure_words(cycle, links).en}.",
        )


def _swings(cycle: Cycle, found: Facts) -> Iterator[Words]:
    told = {stroke.key for stroke in found.strokes}
    for swing in (s for s in found.swings if s.key not in told and s.highest and s.lowest):
        assert swing.highest and swing.lowest
        info, times = cycle.info(swing.key), len(swing.maxima)
        span = Words("在一个循环内", "a cycle") if cycle.whole else Words("在这一范围内", "in this range")
        low, high = shown(cycle, swing.key, swing.lowest.value), shown(cycle, swing.key, swing.highest.value)
        yield Words(
            f"${info.symbol}$ {span.zh}往复 {times} 次，介于 {low}（{where(cycle, swing.lowest)}）"
            f"和 {high}（{where(cycle, swing.highest)}）之间。",
            f"${info.symbol}$ oscillates {times} {'time' if times == 1 else 'times'} "
            f"{span.en}, between {low} ({where(cycle, swing.lowest)}) and {high} "
            f"({where(cycle, swing.highest)}).",
        )


def _transmission(cycle: Cycle, t: Transmission) -> Words:
    info, least, most = cycle.info(t.key), degrees(t.least.value), degrees(t.greatest.value)
    if most - least < 1e-6:
        return Words(
            f"{info.words.zh} ${info.symbol}$ 恒为 {least:.4f}°。",
            f"The {info.words.en}, ${info.symbol}$, is {least:.4f}° throughout.",
        )
    zh, en = (
        f"{info.words.zh} ${info.symbol}$ 最小 {least:.4f}°（{where(cycle, t.least)}）",
        f"The {info.words.en}, ${info.symbol}$, is {least:.4f}° at least ({where(cycle, t.least)})",
    )
    if t.is_folded:
        zh, en = (
            zh + "，杆组接近折叠（拉直）位置，速度和加速度对尺寸误差十分敏感",
            en + ", where the dyad is nearly folded or stretched and its rates depend strongly on every length",
        )
    elif t.is_poor:
        zh, en = zh + "，小于 40°，传力性能较差", en + ", below 40°, where force is transmitted poorly"
    top = (
        Words("；并经过 90°", "; it passes through 90°")
        if most > 90 - 1e-9
        else Words(
            f"；最大 {most:.4f}°（{where(cycle, t.greatest)}）",
            f"; it is {most:.4f}° at most ({where(cycle, t.greatest)})",
        )
    )
    return Words(f"{zh}{top.zh}。", f"{en}{top.en}.")


def _arm(cycle: Cycle, arm: Extremes) -> Words:
    if arm.lowest is None or arm.highest is None:
        return Words.same("")
    info = cycle.info(arm.key)
    low, high = shown(cycle, arm.key, arm.lowest.value), shown(cycle, arm.key, arm.highest.value)
    if arm.lowest.value < 1e-6 * cycle.mech.scale:
        return Words(
            f"{info.words.zh} ${info.symbol}$ 在 {where(cycle, arm.lowest)} 处为零：两销重合（变点），"
            "该位置本身不能确定导杆方向；以下按机构靠惯性平稳通过计算。",
            f"The {info.words.en}, ${info.symbol}$, is zero at {where(cycle, arm.lowest)}: the "
            "pins meet (a change point), and the position alone does not determine the direction "
            "of the guide. What follows goes smoothly through, as inertia carries a real linkage.",
        )
    return Words(
        f"{info.words.zh} ${info.symbol}$ 在 {low}（{where(cycle, arm.lowest)}）"
        f"至 {high}（{where(cycle, arm.highest)}）之间。",
        f"The {info.words.en}, ${info.symbol}$, is between {low} ({where(cycle, arm.lowest)}) and "
        f"{high} ({where(cycle, arm.highest)}).",
    )


def _peak(cycle: Cycle, peak: Peak) -> Words:
    info = cycle.info(peak.key)
    value, rms = shown(cycle, peak.key, peak.spot.value), shown(cycle, peak.key, peak.rms, 3)
    zh, en = (
        f"${info.symbol}$ 在 {where(cycle, peak.spot)} 处出现尖峰 {value}（均方根值 {rms}）",
        f"${info.symbol}$ has a peak of {value} at {where(cycle, peak.spot)} (its rms is {rms})",
    )
    if peak.at is None:
        return Words(zh + "。", en + ".")
    beside = cycle.info(peak.beside)
    least = shown(cycle, peak.beside, peak.at.value, 4)
    return Words(
        zh + f"，邻近 ${beside.symbol}$ 的最小值 {least}（{where(cycle, peak.at)}）。",
        en + f", near the least ${beside.symbol}$, {least} ({where(cycle, peak.at)}).",
    )


def extreme_words(cycle: Cycle, key: str) -> Words:
    """Greatest and least value of a column, and where."""
    found, info = extremes(cycle, key), cycle.info(key)
    if found.highest is None or found.lowest is None:
        return Words(f"${info.symbol}$ 无值。", f"${info.symbol}$ has no value.")
    if found.is_constant:
        value = shown(cycle, key, found.highest.value)
        return Words(f"${info.symbol}$ = {value}，保持不变。", f"${info.symbol}$ = {value} throughout.")
    high, low = shown(cycle, key, found.highest.value), shown(cycle, key, found.lowest.value)
    return Words(
        f"${info.symbol}$ 最大 {high}（{where(cycle, found.highest)}），最小 {low}（{where(cycle, found.lowest)}）。",
        f"${info.symbol}$ is {high} at most ({where(cycle, found.highest)}) and {low} at least "
        f"({where(cycle, found.lowest)}).",
    )
