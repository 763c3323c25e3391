"""The path of a point in words."""

from __future__ import annotations

from collections.abc import Iterator
from math import isfinite, tau

from ...names import subscripted
from ...words import Words
from ..cycle import Cycle
from ..extremes import Spot
from .path import Crossing, Path, Shape
from .shown import number, shown, where

_SHAPES = {
    Shape.STILL: Words("静止不动", "stands still"),
    Shape.CIRCLE: Words("为整圆", "moves on a circle"),
    Shape.LINE: Words("为一段直线", "moves on a straight line"),
    Shape.ARC: Words("为一段圆弧", "moves on a circular arc"),
    Shape.CURVE: Words("为连杆曲线", "traces a coupler curve"),
}


_TIMES = {1: "once", 2: "twice"}
_ENDLESS = Words("，在原动件行程的端部伸向无穷远。", ", and runs off to infinity towards an end of the input's range.")


def path_sentences(cycle: Cycle, found: Path) -> tuple[Words, ...]:
    """The shape of a path in words."""
    if found.shape is Shape.CIRCLE:
        return (_circle(cycle, found),)
    if found.shape is Shape.CURVE and isfinite(found.length):
        return (_shape(cycle, found), *_curve(cycle, found))
    return (_shape(cycle, found),)


def _shape(cycle: Cycle, found: Path) -> Words:
    """What kind of line it is, and how long."""
    point, kind = f"${subscripted(found.point)}$", _SHAPES[found.shape]
    start = Words(
        f"点 {point} 的轨迹{kind.zh}" if found.shape is not Shape.STILL else f"点 {point} {kind.zh}",
        f"Point {point} {kind.en}",
    )
    if not isfinite(found.length):
        return start + _ENDLESS
    if not found.length:
        return start + Words("。", ".")
    if found.once is None:
        return start + Words(f"，长 {_mm(found.length)} mm。", f", {_mm(found.length)} mm long.")
    return _swept(cycle, found, start)


def _swept(cycle: Cycle, found: Path, start: Words) -> Words:
    """How long an arc or a straight piece is itself, and how often it is run along: 2 × 104 mm there and back."""
    assert found.once is not None
    start += Words(f"，长 {_mm(found.once)} mm", f" {_mm(found.once)} mm long")
    if found.passes == 1:
        return start + Words("。", ".")
    whole, all_ = cycle.whole, _mm(found.length)
    turn = whole and cycle.once is not cycle  # the cycle of a machine is several turns
    span = Words("原动件每转一周" if turn else "每循环", "per turn of the input link" if turn else "per cycle")
    span = span if whole else Words("在这一范围内", "in this range")
    if not found.passes:
        return start + Words(
            f"，点在其上往复，{span.zh}走过的总路程为 {all_} mm。",
            f", on which it reverses; the distance travelled {span.en} is {all_} mm.",
        )
    return start + Words(
        f"，{span.zh}沿此线走过 {found.passes} 次，总路程为 {all_} mm。",
        f" and passes it {_TIMES.get(found.passes, f'{found.passes} times')} {span.en}: the distance travelled is "
        f"{all_} mm.",
    )


def _curve(cycle: Cycle, found: Path) -> Iterator[Words]:
    """Whether a coupler curve is closed, where it crosses itself, its cusps, how it bends."""
    yield Words("曲线封闭。", "The curve is closed.") if found.closed else Words("曲线不封闭。", "The curve is open.")
    for cross in found.crossings:
        yield _crossing(cycle, cross)
    for at, q in found.cusps:
        yield Words(
            f"它在 {_point(at)} 有尖点（{where(cycle, Spot(q, 0.0))}）。",
            f"It has a cusp at {_point(at)} ({where(cycle, Spot(q, 0.0))}).",
        )
    if found.turning is not None:
        yield _turning(found.turning, len(found.crossings))
        yield from _bends(cycle, found)


def _crossing(cycle: Cycle, cross: Crossing) -> Words:
    place, symbol = _point(cross.at), cycle.drive.symbol
    first, second = (_place(cycle, q) for q in (cross.first, cross.second))
    pivot = _pivot(cycle, cross.at, 1e-9)
    return Words(
        f"它在 {place}{f'（恰为固定铰链 {pivot}）' if pivot else ''} 自交（${symbol}$ = {first} 和 {second}）。",
        f"It crosses itself at {place}{f', the fixed pivot {pivot}' if pivot else ''} "
        f"(${symbol}$ = {first} and {second}).",
    )


def _pivot(cycle: Cycle, at: complex, within: float) -> str:
    """The fixed pivot at this place, if there is one; within: a share of the mechanism's size."""
    letters = (letter for letter, z in cycle.mech.frame.items() if abs(z - at) < within * cycle.mech.scale)
    return next((f"${subscripted(letter)}$" for letter in letters), "")


def _circle(cycle: Cycle, found: Path) -> Words:
    """Its centre and radius."""
    middle, radius = (found.low + found.high) / 2, (found.high - found.low).real / 2
    pivot, times = _pivot(cycle, middle, 1e-5) or _point(middle), found.passes or 1
    way = _mm(tau * radius)
    laps = (
        Words(f"，走过 {times} 周", f", run round {_TIMES.get(times, f'{times} times')}")
        if times > 1
        else Words("", "")
    )
    name = subscripted(found.point)
    return Words(
        f"点 ${name}$ 的轨迹为以 {pivot} 为圆心、半径 {_mm(radius)} mm 的整圆，长 {way} mm{laps.zh}。",
        f"Point ${name}$ moves on a circle of radius {_mm(radius)} mm about {pivot}, {way} mm long{laps.en}.",
    )


def _place(cycle: Cycle, position: float) -> str:
    """A position of the input link: degrees to one decimal."""
    info = cycle.drive
    return (
        f"{info.told(position):.1f}°".replace("-", "−")
        if info.shown_unit == "°"
        else shown(cycle, info.key, position, 4)
    )


def _point(at: complex) -> str:
    return f"({_mm(at.real)}, {_mm(at.imag)}) mm"


def _mm(value: float) -> str:
    return number(round(1e3 * value, 9), 4)


def _turning(turning: int, crosses: int) -> Words:
    """How often the tangent turns round in a cycle, and what that makes of the curve."""
    if turning == 0:
        start = Words("沿曲线一周，切线转过的净角度为 0°", "Per revolution its tangent turns through 0° in all")
    else:
        sense = Words("逆时针" if turning > 0 else "顺时针", "counter-clockwise" if turning > 0 else "clockwise")
        times = _TIMES.get(abs(turning), f"{abs(turning)} times")
        start = Words(
            f"沿曲线一周，切线{sense.zh}转过 {360 * abs(turning)}°",
            f"Per revolution its tangent turns {times} {sense.en}",
        )
    if turning == 0 and crosses == 1:
        return start + Words("，曲线呈 8 字形。", ": a figure of eight.")
    if abs(turning) == 2 and crosses == 1:
        return start + Words("，曲线带一个内环。", ": the curve has an inner loop.")
    if abs(turning) == 1 and not crosses:
        return start + Words("，曲线不自交。", ", and it does not cross itself.")
    return start + Words("。", ".")


def _bends(cycle: Cycle, found: Path) -> list[Words]:
    """Convex everywhere, or bent the other way between points of inflection."""
    if not found.inflections:
        return (
            [Words("曲线处处外凸，呈卵形。", "It is a simple closed convex curve.")]
            if abs(found.turning or 0) == 1 and not found.crossings
            else []
        )
    at = [_place(cycle, q) for q in found.inflections]
    count = len(at)
    return [
        Words(
            f"曲线有 {count} 个拐点（${cycle.drive.symbol}$ = {'、'.join(at)}），在拐点处凹凸方向改变。",
            f"It has {count} {'point' if count == 1 else 'points'} of inflection "
            f"(${cycle.drive.symbol}$ = {', '.join(at)}), where it bends the other way.",
        )
    ]
