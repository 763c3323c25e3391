"""The figures of a run: both characteristics, 1/ΔM over ω, ω over t."""

from __future__ import annotations

import itertools
from dataclasses import dataclass

import numpy as np

from ....algebra.columns import column, decimals, significant
from ....algebra.quantity import Quantity
from ....algebra.rounding import to_places
from ....board.construction import Listing, Pane, View
from ....board.paper.marks import Dot, Role
from ....devices.dynamics.run_up import RunUp
from ....errors import NotAskedError
from ....plane import Points, Reals, nominal
from ....words import Words
from ...diagrams.axes import Axes, draw_axes
from ...diagrams.lobes import middle_of
from ...diagrams.strip import root, summed
from ..bench import Bench
from .course import Course
from .scales import CHARACTERISTIC, INVERSE, SPEED, scales_of
from .words import DRIVING, HEAD, INVERSES, INVERSES_AGAIN, SPEEDS, SPEEDS_AGAIN, drawn, titles

STATIONS, TICKS = 25, 6  # points through which a characteristic is led; ticks of an axis
ROWS = 9  # of the table


@dataclass(frozen=True, slots=True, kw_only=True)
class Timed:
    """An area under a curve: where it stands, what was read, what it truly is by every hand (mm²); parts of it."""

    place: Pane
    area: Quantity
    true: Reals
    parts: tuple[Reals, ...] = ()


def characteristics(bench: Bench, device: RunUp, course: Course) -> Pane:
    """Both curves over the speed."""
    board = bench.board
    place = _pane(bench, device, course, CHARACTERISTIC)
    board.step(drawn(course), place)
    scale = board.scale_of(place)
    speeds = np.union1d(np.linspace(0.0, course.last, STATIONS), [w for w in course.corners if w < course.last])
    curves = {"M_d": course.driving(speeds), "M_r": course.resisting(speeds)}
    if device.motor is None:
        del curves["M_d"]
    sizes = np.concatenate([*curves.values(), [0.0]])
    low, high = float(np.min(sizes)) / scale.value, float(np.max(sizes)) / scale.value
    wide = course.last / scale.right.value
    axes = Axes(wide=wide, low=low, high=high, across="ω", up="M")
    draw_axes(board, place, axes, _ticks(course.last, scale.right.value))
    for symbol, moments in curves.items():
        points = [_laid(bench, place, float(w), float(m)) for w, m in zip(speeds, moments, strict=True)]
        if course.corners:
            for a, b in itertools.pairwise(points):
                board.join(place, a, b, Role.RESULT)
        else:
            board.curve(place, points, Role.RESULT)
        board.plot(place, points[-3 if symbol == "M_r" else 2], symbol, Dot.NONE)
    return place


def inverse_curve(bench: Bench, device: RunUp, course: Course, shift: Reals) -> Timed:
    """1/ΔM over the speeds of the run, and the area below; shift: by how much the goal of every hand is beside it."""
    board = bench.board
    place = _pane(bench, device, course, INVERSE)
    board.step(INVERSES, place, again=INVERSES_AGAIN)
    _tabulate(bench, device, course)
    scale, mu = board.scale_of(place), board.scale_of(_pane(bench, device, course, CHARACTERISTIC))
    strips = course.cut()
    parts, tops, first = [], [], _edge(bench, place, course, course.low)
    for strip in strips:
        heights = [_height(bench, place, course, w, mu.value) for w in strip.places]
        feet = [w / scale.right.value for w in strip.places]
        tops += [foot + 1j * height for foot, height in zip(feet, heights, strict=True)]
        parts.append(summed([w / scale.right.value for w in strip.weights], heights))
    last = _edge(bench, place, course, course.high)
    outline = (first.real + 0j, last.real + 0j, last, *reversed(tops), first)
    axes = Axes(wide=course.last / scale.right.value, low=0.0, high=_highest(outline), across="ω", up="y")
    draw_axes(board, place, axes, _ticks(course.last, scale.right.value))
    board.curve(place, [first, *tops, last], Role.RESULT)
    board.join(place, outline[1], last, Role.CONSTRUCTION)  # the speed at the end closes the area
    board.hatch(place, outline, rising=True)
    board.plot(place, middle_of(outline), "A_y", Dot.NONE)
    true = summed([1.0] * len(parts), parts) + shift * last.imag / scale.right.value
    _refuse_no_area(course, float(nominal(shift)), float(nominal(true)))
    area = board.area(place, outline, "A_y", curved=true)
    return Timed(place=place, area=area, true=true, parts=tuple(parts))


def _refuse_no_area(course: Course, shift: float, area: float) -> None:
    """NotAskedError where the speed that was read ends the run so early that nothing is left of the area."""
    if area > 0.0:
        return
    goal = course.goal + shift
    raise NotAskedError(
        Words(
            f"按读得的稳定转速，起动至 {goal:.4g} rad/s 为止，而曲线画至 {course.goal:.4g} rad/s：相差过大，"
            f"$1/ΔM$ 曲线下余下的面积为 {area:.4g} mm²，求不出时间；请重读 $OS′$",
            f"by the steady speed that was read the run ends at {goal:.4g} rad/s, and the curve of 1/ΔM is drawn to "
            f"{course.goal:.4g} rad/s: so far beside it {area:.4g} mm² are left of the area below, and no time "
            "follows; read O S′ again",
        ),
        code="no-area",
        numbers={"goal": goal, "drawn": course.goal, "area": area},
    )


def speed_curve(
    bench: Bench, device: RunUp, course: Course, timed: Timed, time: Quantity
) -> tuple[Quantity | None, Timed]:
    """ω over t: the areas up to each speed are the times. The speed at a time; the area below."""
    board = bench.board
    place = _pane(bench, device, course, SPEED)
    board.step(SPEEDS, place, again=SPEEDS_AGAIN)
    scale, strips = board.scale_of(place), course.cut()
    share = time.value / timed.true  # of a square millimetre of the other figure (s)
    reached: Reals = 0.0
    steps = list(zip(strips, timed.parts, strict=True))
    down = course.goal < course.start
    points = [_point(place, bench, 0.0, course.start)]
    for strip, part in reversed(steps) if down else steps:
        reached = reached + part * share
        points.append(_point(place, bench, reached, strip.start if down else strip.end))
    under = [summed(strip.weights, _weighed(bench, timed, course, device, strip.places)) for strip in strips]
    whole = summed([1.0] * len(under), under) * share / (scale.value * scale.right.value)
    outline = (0j, points[-1].real + 0j, *reversed(points))
    wide = float(nominal(points[-1].real))
    draw_axes(
        board,
        place,
        Axes(wide=wide, low=0.0, high=course.high / scale.value, across="t", up="ω"),
        _ticks(wide * scale.right.value, scale.right.value),
    )
    board.curve(place, points, Role.RESULT)
    board.join(place, outline[1], points[-1], Role.CONSTRUCTION)  # the time of the run closes the area
    board.hatch(place, outline, rising=True)
    board.plot(place, middle_of(outline), "A_φ", Dot.NONE)
    area = board.area(place, outline, "A_φ", curved=whole)
    then = None if device.at is None else _then(bench, place, device, course, time, device.at.si)
    return then, Timed(place=place, area=area, true=whole)


def _then(bench: Bench, place: Pane, device: RunUp, course: Course, time: Quantity, at: float) -> Quantity:
    """The ordinate of the curve at a time: found by trial, moved with what the hand was off."""
    board, inertia = bench.board, device.J.si
    ends = (course.start, course.steady * (1 - 1e-12) if course.steady else 2 * course.goal)
    omega = root(lambda w: inertia * course.total(w) - at, ends[0] + 1e-9 * ends[1], ends[1])
    slope = 1 / (inertia * float(course.inverse(np.array([omega]))[0]))
    off = (1 - time.value / (inertia * course.total(course.goal))) * at * slope
    foot = board.lay_off(0j, 1 + 0j, board.to_paper_across(place, at))
    point = board.lay_off(foot, 1j, board.to_paper(place, omega + off))
    board.join(place, foot, point, Role.CONSTRUCTION)
    board.plot(place, foot, "H", Dot.NONE)
    board.plot(place, point, "P", Dot.POINT)
    return board.measure(foot, point, "H P")


def _weighed(bench: Bench, timed: Timed, course: Course, device: RunUp, speeds: tuple[float, ...]) -> list[Reals]:
    """ω y of the other figure (mm · rad/s, over the mm of a rad/s)."""
    scale = bench.board.scale_of(timed.place)
    heights = course.inverse(np.array(speeds)) / scale.value
    return [w * float(y) / scale.right.value for w, y in zip(speeds, heights, strict=True)]


def _height(bench: Bench, place: Pane, course: Course, omega: float, mu: float) -> Reals:
    """y on paper: from ΔM as it lies between the curves, carried by the dividers."""
    board, at = bench.board, np.array([omega])
    gap = board.hand.carry(float(abs(course.driving(at)[0] - course.resisting(at)[0])) / mu)
    return board.hand.carry(1 / (gap * mu) / board.scale_of(place).value)


def _edge(bench: Bench, place: Pane, course: Course, omega: float) -> Points:
    height = float(course.inverse(np.array([omega]))[0])
    return _laid(bench, place, omega, height)


def _laid(bench: Bench, place: Pane, across: float, up: float) -> Points:
    board = bench.board
    foot = board.lay_off(0j, 1 + 0j, board.to_paper_across(place, across))
    return board.lay_off(foot, 1j, board.to_paper(place, up))


def _point(place: Pane, bench: Bench, time: Reals, omega: float) -> Points:
    scale = bench.board.scale_of(place)
    return time / scale.right.value + 1j * (omega / scale.value)


def _highest(outline: tuple[Points, ...]) -> float:
    return max(complex(nominal(corner)).imag for corner in outline)


def _tabulate(bench: Bench, device: RunUp, course: Course) -> None:
    """ΔM is the difference of the moments as they are printed; a machine without a motor has no column of it."""
    omega = np.linspace(course.low, course.high, ROWS)
    moments = np.array([course.driving(omega), course.resisting(omega)])
    count = decimals(moments.ravel().tolist())
    driving, resisting = ([to_places(value, count) for value in row] for row in moments.tolist())
    gaps = [d - r for d, r in zip(driving, resisting, strict=True)]
    columns = [column(omega.tolist()), *(column(one, count) for one in (driving, resisting, gaps))]
    columns.append(tuple(significant(value) for value in course.inverse(omega).tolist()))
    kept = [k for k in range(len(HEAD)) if device.motor is not None or k != DRIVING]
    rows = tuple(zip(*(columns[k] for k in kept), strict=True))
    bench.board.tabulate(Listing(head=tuple(HEAD[k] for k in kept), rows=rows, blocks=1))


def _ticks(most: float, mu: float) -> list[tuple[float, str]]:
    """Round values along an axis."""
    power = 10.0 ** np.floor(np.log10(most / TICKS))
    step = next(power * one for one in (1, 2, 5, 10) if power * one >= most / TICKS * 0.999)
    return [(step * n / mu, f"{step * n:.6g}") for n in range(1, int(most / step + 1e-9) + 1)]


def _pane(bench: Bench, device: RunUp, course: Course, view: View) -> Pane:
    scale = None if course.name in ("run", "free") else scales_of(course, device)[view]
    return bench.board.open_pane(view, course.name, titles(view, course.name), scale)
