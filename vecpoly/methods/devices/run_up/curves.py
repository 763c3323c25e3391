"""The figures of the integrals of a run: 1/ΔM over ω, ω over t."""

from __future__ import annotations

import itertools
from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import numpy as np

from ....algebra.columns import column, decimals, significant
from ....algebra.quantity import Quantity
from ....algebra.rounding import to_places
from ....board.construction import Listing, Pane
from ....board.paper.marks import Dot, Role
from ....devices.dynamics.run_up import RunUp
from ....errors import NotAskedError
from ....plane import Points, Reals, nominal
from ....words import Words
from ...diagrams.axes import Axes, draw_axes
from ...diagrams.lobes import middle_of
from ...diagrams.strip import Strip, root, running, summed
from ..bench import Bench
from .course import Course
from .places import laid, pane, ticks
from .scales import CHARACTERISTIC, INVERSE, SPEED
from .words import DRIVING, HEAD, INVERSES, INVERSES_AGAIN, SPEEDS, SPEEDS_AGAIN, head, then

ROWS, ON_AXIS = 9, 1e-9  # rows of the table; mm


@dataclass(frozen=True, slots=True, kw_only=True)
class Timed:
    """An area under a curve: where it stands, what was read, what it truly is by every hand (mm²); its strips, and
    the heights (mm) at their places."""

    place: Pane
    area: Quantity
    true: Reals
    strips: tuple[tuple[Strip, tuple[Reals, ...]], ...] = ()


def inverse_curve(bench: Bench, device: RunUp, course: Course, shift: Reals) -> Timed:
    """1/ΔM over the speeds of the run, and the area below; shift: by how much the goal of every hand is beside it."""
    board = bench.board
    place = pane(bench, device, course, INVERSE)
    board.step(INVERSES, place, again=INVERSES_AGAIN)
    _tabulate(bench, device, course)
    scale, mu = board.scale_of(place), board.scale_of(pane(bench, device, course, CHARACTERISTIC))
    cut, across = course.cut(), scale.right.value
    strips = tuple((one, tuple(_height(bench, place, course, w, mu.value) for w in one.places)) for one in cut)
    edges = [_edge(bench, place, course, w) for w in course.stops]
    runs = []
    for (low, first), (high, last) in itertools.pairwise(zip(course.stops, edges, strict=True)):
        within = [(w, y) for one, ys in strips if low <= one.start < high for w, y in zip(one.places, ys, strict=True)]
        runs.append([first, *(w / across + 1j * y for w, y in within), last])
    tops = [edges[0], *(point for run in runs for point in run[1:])]
    outline = (tops[0].real + 0j, tops[-1].real + 0j, *reversed(tops))
    axes = Axes(wide=course.last / across, low=0.0, high=_highest(outline), across="ω", up="y")
    draw_axes(board, place, axes, ticks(course.last, across))
    for run in runs:
        board.curve(place, run, Role.RESULT)
    for foot, top in ((outline[0], tops[0]), (outline[1], tops[-1])):  # both speeds close the area
        if abs(complex(nominal(foot))) > ON_AXIS:
            board.join(place, foot, top, Role.CONSTRUCTION)
    board.hatch(place, outline, rising=True)
    board.plot(place, middle_of(outline), "A_y", Dot.NONE)
    if course.name == "run":
        board.plot(place, outline[1], "ω_1", Dot.NONE)
    parts = [summed(one.weights, ys) / across for one, ys in strips]
    true = summed([1.0] * len(parts), parts) + shift * tops[-1].imag / across
    _refuse_no_area(course, float(nominal(shift)), float(nominal(true)))
    area = board.area(place, outline, "A_y", curved=true)
    return Timed(place=place, area=area, true=true, strips=strips)


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
    place = pane(bench, device, course, SPEED)
    board.step(SPEEDS, place, again=SPEEDS_AGAIN)
    scale = board.scale_of(place)
    share = time.value / timed.true / board.scale_of(timed.place).right.value  # s: of a mm · rad/s of the other figure
    points = [_point(place, bench, share * one, omega) for omega, one in _until(course, timed)]
    under = [summed(_times(one.places, one.weights), heights) for one, heights in timed.strips]
    whole = summed([1.0] * len(under), under) * share / (scale.value * scale.right.value)
    outline = (0j, points[-1].real + 0j, *reversed(points))
    wide = float(nominal(points[-1].real))
    draw_axes(
        board,
        place,
        Axes(wide=wide, low=0.0, high=course.high / scale.value, across="t", up="ω"),
        ticks(wide * scale.right.value, scale.right.value),
    )
    board.curve(place, points, Role.RESULT)
    board.join(place, outline[1], points[-1], Role.CONSTRUCTION)  # the time of the run closes the area
    board.hatch(place, outline, rising=True)
    board.plot(place, middle_of(outline), "A_φ", Dot.NONE)
    area = board.area(place, outline, "A_φ", curved=whole)
    at_a_time = None if device.at is None else _then(bench, place, device, course, time, device.at.si)
    return at_a_time, Timed(place=place, area=area, true=whole)


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
    assert device.at is not None
    board.remark(then(device.at.text))
    return board.measure(foot, point, "H P")


def _until(course: Course, timed: Timed) -> Iterator[tuple[float, Reals]]:
    """Every speed at which the curve was set out, as it is reached; the area below up to there (mm · rad/s)."""
    down = course.goal < course.start
    yield course.start, 0.0
    reached: Reals = 0.0
    for strip, heights in reversed(timed.strips) if down else timed.strips:
        part = summed(strip.weights, heights)
        passed = list(zip(strip.places, running(strip, heights), strict=True))
        for omega, area in reversed(passed) if down else passed:
            yield omega, reached + (part - area if down else area)
        reached = reached + part
        yield (strip.start if down else strip.end), reached


def _times(places: Sequence[float], weights: Sequence[float]) -> list[float]:
    return [place * weight for place, weight in zip(places, weights, strict=True)]


def _height(bench: Bench, place: Pane, course: Course, omega: float, mu: float) -> Reals:
    """y on paper: from ΔM as it lies between the curves, carried by the dividers."""
    board, at = bench.board, np.array([omega])
    gap = board.hand.carry(float(abs(course.driving(at)[0] - course.resisting(at)[0])) / mu)
    return board.hand.carry(1 / (gap * mu) / board.scale_of(place).value)


def _edge(bench: Bench, place: Pane, course: Course, omega: float) -> Points:
    height = float(course.inverse(np.array([omega]))[0])
    return laid(bench, place, omega, height)


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
    bench.board.tabulate(Listing(head=tuple(head(course)[k] for k in kept), rows=rows, blocks=1))
