"""From the characteristics to the time of a run: t = J ∫ dω/ΔM is J times the area under 1/ΔM."""

from __future__ import annotations

from math import pi

import numpy as np

from ....algebra.formula import Txt
from ....algebra.quantity import Quantity, magnitude
from ....board.construction import Pane
from ....board.paper.marks import Dot, Role
from ....devices.dynamics.run_up import CONSTANT, START, STEADY, THEN, TIME, TIME_BRAKED, TURNS, TURNS_BRAKED, RunUp
from ....plane import Points, Reals
from ....words import Words
from ..bench import Bench
from ..registry import device_method
from .characteristics import characteristics
from .course import Course, courses
from .curves import inverse_curve, speed_curve
from .scales import run_scales
from .words import SECTIONS, goal, steady

TWO_PI = Quantity(Txt("2π"), 2 * pi, "")


@device_method(
    RunUp,
    title=Words("机械的起动、停车与自调性", "Run-up, run-down and braking"),
    source="机械原理, 机械的运转: characteristics, self-regulation, t = J ∫ dω/ΔM by the area under 1/ΔM",
    example="motor-run-up",
    scales=run_scales,
)
def draw_run_up(bench: Bench, device: RunUp) -> None:
    """Every run: its characteristics, 1/ΔM, the speed over time."""
    for course in courses(device):
        board = bench.board
        board.section(SECTIONS[course.name])
        place = characteristics(bench, device, course)
        reached = _steady(bench, device, course, place) if device.motor is not None else None
        timed = inverse_curve(bench, device, course, _shift(device, course, reached))
        named = (TIME_BRAKED, TURNS_BRAKED) if course.name == "braked" else (TIME, TURNS)
        inertia = magnitude("J", device.J.si, "kg·m^2")
        mu = board.mu(timed.place), board.mu_across(timed.place)
        time = bench.worked(named[0], inertia * mu[0] * mu[1] * timed.area)
        then, area = speed_curve(bench, device, course, timed, time)
        mu = board.mu(area.place), board.mu_across(area.place)
        bench.worked(named[1], mu[0] * mu[1] * area.area / TWO_PI)
        if then is not None:
            bench.worked(THEN, board.mu(area.place) * then)


def _steady(bench: Bench, device: RunUp, course: Course, place: Pane) -> Reals | None:
    """M at rest; the crossing, and whether the motion is stable there; the time constant of a straight ΔM."""
    board = bench.board
    at = _ordinate(bench, place, course, 0.0)
    bench.worked(START, board.mu(place) * board.measure(0j, at, "O A"))
    board.plot(place, at, "A", Dot.POINT)
    if course.steady is None:
        return None
    crossing = _ordinate(bench, place, course, course.steady)
    board.plot(place, crossing, "S", Dot.POINT)
    foot = crossing.real + 0j
    board.join(place, foot, crossing, Role.CONSTRUCTION)
    board.step(steady(), place)
    speed = bench.worked(STEADY, board.mu_across(place) * board.measure(0j, foot, "O S′"))
    board.plot(place, 0j, "O", Dot.NONE)
    board.plot(place, foot, "S′", Dot.NONE)
    board.remark(goal(device, course))
    if device.linear:
        _constant(bench, device, course, place, speed)
    return speed.value


def _constant(bench: Bench, device: RunUp, course: Course, place: Pane, speed: Quantity) -> None:
    """T = J ω_s / ΔM_0: of a straight ΔM, which is 0 at ω_s."""
    board = bench.board
    load = board.lay_off(0j, 1j, board.to_paper(place, float(course.resisting(np.zeros(1))[0])))
    motor = _ordinate(bench, place, course, 0.0)
    read = board.measure(load, motor, "B A")
    board.plot(place, load, "B", Dot.POINT)
    board.step(Words("$ΔM$ 为直线，机电时间常数：", "Since $ΔM$ is a straight line, the time constant is:"))
    first = board.compute("ΔM_0", board.mu(place) * read, "N·m")
    bench.worked(CONSTANT, magnitude("J", device.J.si, "kg·m^2") * speed / first)


def _ordinate(bench: Bench, place: Pane, course: Course, omega: float) -> Points:
    """The point of the motor's characteristic."""
    board = bench.board
    foot = board.lay_off(0j, 1 + 0j, board.to_paper_across(place, omega))
    return board.lay_off(foot, 1j, board.to_paper(place, float(course.driving(np.array([omega]))[0])))


def _shift(device: RunUp, course: Course, reached: Reals | None) -> Reals:
    """By how much every hand's goal, a share of the steady speed that it read, is beside the course's (rad/s)."""
    if reached is None or course.steady is None:
        return 0.0
    return reached * (course.goal / course.steady) - course.goal
