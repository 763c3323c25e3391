"""The facts of a cycle in words."""

from __future__ import annotations

from collections.abc import Iterator
from math import degrees

from ..words import Words
from .cycle import Cycle
from .extremes import Extremes, Spot, extremes
from .facts import Facts, Peak, Stroke, Transmission
from .path import Path, Shape


def sentences(cycle: Cycle, found: Facts) -> tuple[Words, ...]:
    """Each fact as a sentence: how the links move, limits, quick return, transmission angles, dead points, peaks."""
    parts = [*_range(cycle, found), *_turns(found), *(_stroke(cycle, s) for s in found.strokes), *_swings(cycle, found),
             *(_transmission(cycle, t) for t in found.transmissions), *(_arm(cycle, a) for a in found.arms), *(_peak(cycle, p) for p in found.peaks)]
    return tuple(parts)


def number(value: float, digits: int = 6) -> str:
    """A number for reading, with a real minus."""
    text = f"{round(value, 9):.{digits}g}"
    return (f"{float(text):.0f}" if "e+" in text and abs(value) < 1e9 else text).replace("-", "−")


def shown(cycle: Cycle, key: str, value: float, digits: int = 6) -> str:
    """A value of a column with its shown unit."""
    info = cycle.info(key)
    unit = info.shown_unit
    return number(info.factor * value, digits) + (unit if unit == "°" else f" {unit}" if unit else "")


def where(cycle: Cycle, spot: Spot) -> str:
    """$φ_1$ = 37.5°."""
    return f"${cycle.drive.symbol}$ = {shown(cycle, cycle.drive.key, spot.phi, 5)}"


def _range(cycle: Cycle, found: Facts) -> Iterator[Words]:
    link, symbol = cycle.mech.drive.link, cycle.drive.symbol
    if found.whole:
        yield Words(f"主动件 {link} 可整周转动，机构在全部位置均可装配。", f"The driving link {link} can turn right round; the mechanism can be assembled in every position.")
        return
    ends = [shown(cycle, cycle.drive.key, q, 6) for q in (cycle.low, cycle.high)]
    yield Words(f"主动件 {link} 不能整周运动：${symbol}$ 只能在 {ends[0]} 至 {ends[1]} 之间。",
                f"The driving link {link} cannot move on for ever: ${symbol}$ is limited to {ends[0]} … {ends[1]}.")
    if found.dead:
        yield Words("在这两个极限位置，主动件为从动杆组所限，速度无定值（死点）。",
                    "At these two limits the dyad that it drives is stretched or folded and velocities have no single value (dead points).")


def _turns(found: Facts) -> Iterator[Words]:
    if found.turns is None:
        return
    rocking = [name for name, count in found.turns.items() if count == 0]
    turning = {name: count for name, count in found.turns.items() if count}
    if turning:
        zh = "，".join(f"构件 {name} 转 {number(count)} 周" for name, count in turning.items())
        en = ", ".join(f"link {name} {number(count)} {'turn' if abs(count) == 1 else 'turns'}" for name, count in turning.items())
        yield Words(f"主动件每转一周：{zh}（逆时针为正）。", f"In one turn of the drive: {en} (counter-clockwise positive).")
    if rocking:
        yield Words(f"构件 {'、'.join(rocking)} 不作整周转动。", f"{'Link' if len(rocking) == 1 else 'Links'} {', '.join(rocking)} {'does' if len(rocking) == 1 else 'do'} not turn round.")


def _stroke(cycle: Cycle, stroke: Stroke) -> Words:
    info = cycle.info(stroke.key)
    low, high, swing = (shown(cycle, stroke.key, v) for v in (stroke.lower.value, stroke.upper.value, stroke.swing))
    at = where(cycle, stroke.lower), where(cycle, stroke.upper)
    slow, quick = (f"{degrees(a):.4f}°" for a in (max(stroke.forth, stroke.back), min(stroke.forth, stroke.back)))
    zh = f"${info.symbol}$ 的两极限位置：{low}（{at[0]}）和 {high}（{at[1]}），行程 {swing}；"
    en = f"Limit positions of ${info.symbol}$: {low} ({at[0]}) and {high} ({at[1]}), stroke {swing}; "
    if stroke.theta < 1e-9:
        return Words(zh + "$K$ = 1，无急回特性。", en + "$K$ = 1, no quick return.")
    ratio = f"$K$ = {slow}/{quick} = {stroke.ratio:.5f}"
    return Words(zh + f"{ratio}，极位夹角 $θ$ = {degrees(stroke.theta):.4f}°。", en + f"{ratio}, $θ$ = {degrees(stroke.theta):.4f}°.")


def _swings(cycle: Cycle, found: Facts) -> Iterator[Words]:
    told = {stroke.key for stroke in found.strokes}
    for swing in (s for s in found.swings if s.key not in told and s.highest and s.lowest):
        assert swing.highest and swing.lowest
        info, times = cycle.info(swing.key), len(swing.maxima)
        low, high = shown(cycle, swing.key, swing.lowest.value), shown(cycle, swing.key, swing.highest.value)
        yield Words(f"${info.symbol}$ 在一个循环内往复 {times} 次，介于 {low}（{where(cycle, swing.lowest)}）和 {high}（{where(cycle, swing.highest)}）之间。",
                    f"${info.symbol}$ goes to and fro {times} {'time' if times == 1 else 'times'} a cycle, between {low} ({where(cycle, swing.lowest)}) and {high} ({where(cycle, swing.highest)}).")


def _transmission(cycle: Cycle, t: Transmission) -> Words:
    info, least, most = cycle.info(t.key), degrees(t.least.value), degrees(t.greatest.value)
    zh = f"{info.words.zh} ${info.symbol}$ 最小 {least:.4f}°（{where(cycle, t.least)}），最大 {most:.4f}°"
    en = f"The {info.words.en}, ${info.symbol}$, is {least:.4f}° at least ({where(cycle, t.least)}) and {most:.4f}° at most"
    if most - least < 1e-6:
        return Words(f"{info.words.zh} ${info.symbol}$ 恒为 {least:.4f}°。", f"The {info.words.en}, ${info.symbol}$, is {least:.4f}° throughout.")
    if t.is_folded:
        return Words(zh + "；杆组接近折叠（拉直）位置，速度和加速度对尺寸误差十分敏感。", en + "; there the dyad is nearly folded or stretched, and its rates depend strongly on every length.")
    return Words(zh + ("，小于 40°，传力性能差。" if t.is_poor else "。"), en + ("; below 40° force is transmitted poorly." if t.is_poor else "."))


def _arm(cycle: Cycle, arm: Extremes) -> Words:
    if arm.lowest is None or arm.highest is None:
        return Words.same("")
    info = cycle.info(arm.key)
    low, high = shown(cycle, arm.key, arm.lowest.value), shown(cycle, arm.key, arm.highest.value)
    return Words(f"{info.words.zh} ${info.symbol}$ 在 {low}（{where(cycle, arm.lowest)}）至 {high}（{where(cycle, arm.highest)}）之间。",
                 f"The {info.words.en}, ${info.symbol}$, is between {low} ({where(cycle, arm.lowest)}) and {high} ({where(cycle, arm.highest)}).")


def _peak(cycle: Cycle, peak: Peak) -> Words:
    info = cycle.info(peak.key)
    value, rms = shown(cycle, peak.key, peak.spot.value), shown(cycle, peak.key, peak.rms, 3)
    zh, en = f"${info.symbol}$ 在 {where(cycle, peak.spot)} 处出现尖峰 {value}（均方根值 {rms}）", f"${info.symbol}$ has a peak of {value} at {where(cycle, peak.spot)} (its rms is {rms})"
    if peak.at is None:
        return Words(zh + "。", en + ".")
    beside = cycle.info(peak.beside)
    least = shown(cycle, peak.beside, peak.at.value, 4)
    return Words(zh + f"，邻近 ${beside.symbol}$ 的最小值 {least}（{where(cycle, peak.at)}）。",
                 en + f", near the least ${beside.symbol}$, {least} ({where(cycle, peak.at)}).")


def extreme_words(cycle: Cycle, key: str) -> Words:
    """Greatest and least value of a column, and where."""
    found, info = extremes(cycle, key), cycle.info(key)
    if found.highest is None or found.lowest is None:
        return Words(f"${info.symbol}$ 无值。", f"${info.symbol}$ has no value.")
    if found.is_constant:
        value = shown(cycle, key, found.highest.value)
        return Words(f"${info.symbol}$ = {value}，保持不变。", f"${info.symbol}$ = {value} throughout.")
    high, low = shown(cycle, key, found.highest.value), shown(cycle, key, found.lowest.value)
    return Words(f"${info.symbol}$ 最大 {high}（{where(cycle, found.highest)}），最小 {low}（{where(cycle, found.lowest)}）。",
                 f"${info.symbol}$ is {high} at most ({where(cycle, found.highest)}) and {low} at least ({where(cycle, found.lowest)}).")


_SHAPES = {
    Shape.STILL: Words("静止不动", "stands still"), Shape.CIRCLE: Words("为整圆", "moves on a circle"), Shape.LINE: Words("为一段直线（往复）", "moves to and fro on a straight line"),
    Shape.ARC: Words("为一段圆弧（往复）", "moves to and fro on a circular arc"), Shape.CURVE: Words("为连杆曲线", "traces a coupler curve"),
}


def path_sentences(cycle: Cycle, found: Path) -> tuple[Words, ...]:
    """The shape of a path in words."""
    point, kind = f"${found.point}$", _SHAPES[found.shape]
    text = [Words(f"点 {point} 的轨迹{kind.zh}" if found.shape is not Shape.STILL else f"点 {point} {kind.zh}", f"Point {point} {kind.en}")
            + (Words(f"，长 {number(1e3 * found.length)} mm。", f", {number(1e3 * found.length)} mm long.") if found.length else Words("。", "."))]
    if found.shape is Shape.CURVE:
        text.append(Words("曲线封闭。", "The curve is closed.") if found.closed else Words("曲线不封闭。", "The curve is open."))
        for cross in found.crossings:
            place = f"({number(1e3 * cross.at.real)}, {number(1e3 * cross.at.imag)}) mm"
            at = [shown(cycle, cycle.drive.key, q, 5) for q in (cross.first, cross.second)]
            text.append(Words(f"它在 {place} 自交（${cycle.drive.symbol}$ = {at[0]} 和 {at[1]}）。", f"It crosses itself at {place} (${cycle.drive.symbol}$ = {at[0]} and {at[1]})."))
        for place_, q in found.cusps:
            place = f"({number(1e3 * place_.real)}, {number(1e3 * place_.imag)}) mm"
            text.append(Words(f"它在 {place} 有尖点（{where(cycle, Spot(q, 0.0))}）。", f"It has a cusp at {place} ({where(cycle, Spot(q, 0.0))})."))
        if found.turning is not None:
            text.append(_turning(found.turning, len(found.crossings)))
    return tuple(text)


def _turning(turning: int, crosses: int) -> Words:
    count = number(turning)
    zh, en = f"切线共转 {count} 周", f"Its tangent turns {count} {'time' if abs(turning) == 1 else 'times'} round"
    if turning == 0 and crosses == 1:
        return Words(zh + "，曲线呈 8 字形。", en + ": a figure of eight.")
    if abs(turning) == 2 and crosses == 1:
        return Words(zh + "，曲线带一个内环。", en + ": a loop within a loop.")
    if abs(turning) == 1 and not crosses:
        return Words(zh + "，曲线为简单卵形。", en + ": a simple oval.")
    return Words(zh + "。", en + ".")
