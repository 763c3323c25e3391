"""What a statement and the first steps say of sides, of the driving link and of powers is so on the drawing."""

from __future__ import annotations

import cmath
import math
import re

import pytest

from tests.drawn_library import IDS, LIBRARY, desk_of, drawn, given
from tests.each import Later, each
from tests.found import FOUND
from vecpoly.check.truth import exact_values
from vecpoly.mechanism.model import Mechanism
from vecpoly.plane import nominal
from vecpoly.report.statement.driver import driving_elsewhere, loads_of
from vecpoly.report.statement.meant import meant_by
from vecpoly.report.statement.structure import structure

SIDE = re.compile(r"\$([A-Z])\$ 在 \$([A-Z])([A-Z])\$ (左|右)侧")
MECHANISMS = Later(lambda: [name for name in LIBRARY if isinstance(given(name).subject, Mechanism)])
SIDED = Later(lambda: [name for name in MECHANISMS if "侧" in _statement(name)])
CRANKS = Later(lambda: [name for name in ("A-30", *IDS, *FOUND) if _is_mechanism(name) and _stepped(name)])
SET_BY = Later(lambda: [name for name in (*IDS, *FOUND) if _is_mechanism(name) and "，以定构件" in _at_phi(name)])
NEAR = 1e-9


def _statement(name: str) -> str:
    text = given(name).statement
    return text.zh if text is not None else ""


def _is_mechanism(name: str) -> bool:
    return isinstance(given(name).subject, Mechanism)


def _at_phi(name: str) -> str:
    """The step in which the driving crank is set out at φ."""
    told = (step.words.zh for step in drawn(name).construction.steps)
    return next((zh for zh in told if re.search(r"过固定铰链.*作与 \$x\$ 轴成", zh)), "")


def _stepped(name: str) -> list[tuple[str, str]]:
    """The pivot of a driving crank and the point that is stepped off from it."""
    return re.findall(r"截取 \$([A-Z]'?)([A-Z]'?) =", _at_phi(name))


def _off_line(name: str) -> dict[str, float]:
    """Points of the driving crank: the angle between φ and the line from the pivot to each."""
    desk = desk_of(name)
    drive = desk.mech.drive
    pivot, others = desk.crank(drive.link)
    arms = {point: complex(nominal(desk.at[point])) - complex(nominal(desk.at[pivot])) for point in others}
    return {point: cmath.phase(arm * cmath.rect(1.0, -drive.position)) for point, arm in arms.items()}


@each(SIDED)
def test_a_side_that_a_statement_tells_is_that_of_the_drawing_and_no_fixed_point_has_one(name: str) -> None:
    """A-30 let K, a pivot with given coordinates, lie 'on the side on which the linkage can be assembled'."""
    text, at = _statement(name), {letter: complex(nominal(place)) for letter, place in desk_of(name).at.items()}
    for point, start, end, side in SIDE.findall(text):
        turn = ((at[end] - at[start]).conjugate() * (at[point] - at[start])).imag
        assert (turn > 0) == (side == "左"), (point, start, end, side)
    for clause in re.split("[，。；]", text):
        if clause.endswith("一侧"):
            assert not set(re.findall(r"\$([A-Z])\$", clause)) & set(given(name).mechanism.frame), clause


@each(CRANKS)
def test_a_crank_is_stepped_off_to_the_side_that_its_step_says(name: str) -> None:
    """φ of BA points from B to A: B lies on the line at φ, beyond A."""
    ((_, point),) = _stepped(name)
    back = "的另一侧反向截取" in _at_phi(name)
    assert abs(_off_line(name)[point]) == pytest.approx(math.pi if back else 0.0, abs=NEAR), _at_phi(name)


@each(CRANKS)
def test_a_point_that_is_stepped_off_is_not_set_out_once_more(name: str) -> None:
    ((_, point),) = _stepped(name)
    assert f"${point}$" not in _at_phi(name).partition("按已知尺寸定出")[2]


@each(SET_BY)
def test_a_link_that_is_only_set_by_a_line_has_no_point_on_it(name: str) -> None:
    assert _off_line(name) and all(abs(math.sin(angle)) > NEAR for angle in _off_line(name).values())
    assert all(f"${point}$" in _at_phi(name).partition("按已知尺寸定出")[2] for point in _off_line(name))


@each(MECHANISMS)
def test_no_link_that_is_only_resisted_is_said_to_drive(name: str) -> None:
    """4-3: the force drives slider 3, and link 1, by which the position is given, carries the resisting moment."""
    problem, told = given(name), structure(given(name))
    elsewhere = driving_elsewhere(problem.mechanism, loads_of(problem))
    assert bool(elsewhere) == ("取其为原动件拆分杆组" in told.zh) == ("taken as the input link, though" in told.en)
    acting, here = loads_of(problem), problem.mechanism.drive.link
    roles = {load.role for load in acting.all if load.link == here} if acting is not None else set()
    if "resisting" in roles and "driving" not in roles:
        assert elsewhere and f"构件 {here} 为原动件" not in told.zh


def test_what_the_motor_supplies_to_each_machine_makes_up_its_power_and_is_called_a_share_of_it() -> None:
    """It is no power of a branch, which is smaller by what is lost before the train parts."""
    answers = exact_values(given("5-7"))
    assert answers["P_A_in"] + answers["P_B_in"] == pytest.approx(answers["P"], rel=1e-9)
    for key in ("P_A_in", "P_B_in"):
        words = meant_by(given("5-7").subject, key, "P")
        assert words is not None and "电动机供给" in words.zh and "share of the motor power" in words.en


@each(LIBRARY)
def test_what_the_data_call_sought_is_asked(name: str) -> None:
    """The constant moment of engine-card, of which nothing is asked in the position, was "sought"."""
    problem = given(name)
    asked = {getattr(getattr(ask, "rel", None), "key", "") for ask in problem.asks}
    for zh, en in ((one.of("zh"), one.of("en")) for one in problem.given.data):
        if "待求" in zh or "sought" in en:
            assert any(re.sub(r"[{}]", "", symbol) in asked for symbol in re.findall(r"\$([^$]+)\$", zh)), en
