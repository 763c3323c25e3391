"""Claims about wedges, inclined planes, wedge clamps and ring springs:
the cases, the drawing against the oracle, laws, refusals."""

from __future__ import annotations

import cmath
import json
from collections.abc import Callable, Mapping
from functools import partial
from math import atan, cos, degrees, isclose, radians, sin, tan
from pathlib import Path
from typing import Any

import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st
from pydantic import ValidationError

from tests.laws import often
from vecpoly import Problem, load, loads
from vecpoly.board.construction import Construction, Reading, View
from vecpoly.board.hand import hand
from vecpoly.board.paper.marks import Vector
from vecpoly.check.printed.answers import check_problem
from vecpoly.check.printed.verdict import Verdict
from vecpoly.devices.base import Device
from vecpoly.devices.incline import Incline
from vecpoly.devices.ring_spring import RingSpring
from vecpoly.devices.wedge_clamp import WedgeClamp
from vecpoly.devices.wedges import Wedges
from vecpoly.drawing.sheets.paper import DrawingPaper
from vecpoly.errors import LockedError, ProblemFileError
from vecpoly.methods.devices.plan import construct_device
from vecpoly.oracle.devices.registry import device_answers
from vecpoly.problem.asked.asks import AskNamed
from vecpoly.problem.problem import Scales
from vecpoly.words import Words

CASES = json.loads((Path(__file__).resolve().parents[1] / "data" / "ch5-wedges.json").read_text(encoding="utf-8"))
few = settings(max_examples=often(5))


def deg(value: float) -> str:
    return f"{value!r} deg"


def newton(value: float) -> str:
    return f"{value!r} N"


def draw(device: Device, by: str = "exact", mu: float | None = None) -> Construction:
    problem = Problem(
        id="t",
        title=Words.same("t"),
        subject=device,
        asks=tuple(AskNamed(rel=named) for named in device.quantities()),
        scales=Scales({"mu_F": mu} if mu else {}),
    )
    return construct_device(problem, hand(by), DrawingPaper())[0]


def read(device: Device, **how: Any) -> dict[str, complex | float]:
    return {key: value_of(reading) for key, reading in draw(device, **how).readings.items()}


def value_of(reading: Reading) -> complex | float:
    return reading.scalar if reading.vector is None else reading.vector


def near(one: complex, other: complex, size: float) -> bool:
    return abs(one - other) <= 1e-9 * max(abs(other), size)


def wedges(alpha: float, beta: float, f: float, load: float = 1000.0) -> Wedges:
    return Wedges.model_validate({"alpha": deg(alpha), "beta": deg(beta), "Q": newton(load), "f": f})


def incline(alpha: float | None, beta: float, f: float) -> Incline:
    slope = {} if alpha is None else {"alpha": deg(alpha)}
    return Incline.model_validate({**slope, "beta": deg(beta), "Q": "1000 N", "f": f})


def clamp(alpha: float, f: float) -> WedgeClamp:
    return WedgeClamp.model_validate({"alpha": deg(alpha), "f": f, "R": "1000 N"})


def ring(alpha: float, f: float) -> RingSpring:
    return RingSpring.model_validate({"alpha": deg(alpha), "f": f, "Q": "600 N"})


frictions = st.floats(0.0, 0.6)


@st.composite
def devices(draw: st.DrawFn) -> Device:
    """Any of the four, that moves when it is driven."""
    f = draw(frictions)
    phi = degrees(atan(f))
    kind = draw(st.sampled_from(("wedges", "incline", "clamp", "ring")))
    if kind == "wedges":
        beta = draw(st.floats(2 * phi + 2, 88)) if phi < 43 else 0.0
        return wedges(draw(st.floats(3, 176 - beta)), beta, f)
    if kind == "incline":
        alpha = draw(st.floats(1, 60))
        return incline(alpha, draw(st.floats(alpha + phi - 85, min(84.0, alpha + 85 - phi))), f)
    return clamp(draw(st.floats(1, 88)), f) if kind == "clamp" else ring(draw(st.floats(phi + 1, 88)), f)


# -- the cases ------------------------------------------------------------------------------------------------------

EXERCISES = {"4-2": wedges(60, 60, 0.15), "5-1": incline(None, 45, 0.2), "5-2": clamp(21, 0.13), "5-4": ring(38, 0.12)}


@pytest.mark.parametrize("name", EXERCISES)
@pytest.mark.parametrize("way", [read, device_answers], ids=["drawing", "oracle"])
def test_drawing_and_oracle_give_the_numbers_of_the_cases(
    name: str, way: Callable[[Device], Mapping[str, complex | float]]
) -> None:
    found, case = way(EXERCISES[name]), CASES[name]
    for key, value in case["values"].items():
        assert found[key] == pytest.approx(value, rel=1e-9), key
    for key, vector in case.get("vectors", {}).items():
        assert abs(found[key] - cmath.rect(vector["size"], radians(vector["direction_deg"]))) < 1e-9 * vector["size"], (
            key
        )
    for key, value in case.get("bisected", {}).items():
        assert found[key] == pytest.approx(value, rel=1e-8), key


@pytest.mark.parametrize("way", [read, device_answers], ids=["drawing", "oracle"])
def test_the_plane_of_24_degrees_gives_its_forces(way: Callable[[Device], Mapping[str, complex | float]]) -> None:
    found = way(incline(24, 45, 0.2))
    for key, value in CASES["5-1"]["at_24_deg"].items():
        assert found[key] == pytest.approx(value * (1000.0 if key.startswith("F") else 1.0), rel=1e-9), key


def test_at_the_limit_the_efficiency_of_the_plane_is_17_to_30_and_nothing_holds_it() -> None:
    found = read(EXERCISES["5-1"])
    assert found["eta"] == pytest.approx(17 / 30, rel=1e-9)
    assert abs(found["F_r"]) < 1e-9 * 1000


@pytest.mark.parametrize("name", ["4-2", "5-1"])
def test_the_printed_answers_are_right(name: str) -> None:
    answers = check_problem(load(name)).answers
    assert len(answers) == 2
    assert {answer.verdict for answer in answers} <= {Verdict.REPRODUCED, Verdict.ROUNDING}


@pytest.mark.parametrize("name", EXERCISES)
def test_the_library_draws_its_figures_and_says_which_body_comes_first(name: str) -> None:
    solution = load(name).solve(by="drafting")
    views = [figure.view for figure in solution.construction.figures]
    assert {View.MECHANISM, View.BODY, View.FORCE} == set(views)
    for answer in solution.answers.values():
        assert abs(answer.deviation) <= max(answer.expected_error, 1e-9 * abs(answer.exact)), answer.key
    first = next(
        step.words.en
        for step in solution.construction.steps
        if "Take" in step.words.en or "Let the wedge" in step.words.en
    )
    assert "unknown" in first or "known" in first


# -- drawing and oracle, laws ---------------------------------------------------------------------------------------


@few
@given(devices())
def test_the_exact_hand_agrees_with_the_oracle(device: Device) -> None:
    found, exact = read(device), device_answers(device)
    assert set(found) == set(exact) == {named.key for named in device.quantities()}
    for key, value in exact.items():
        assert near(found[key], value, 1e-3 * device.force if key[0] in "FR" else 1e-3), key


@few
@given(st.floats(5, 120), st.floats(10, 85), st.tuples(frictions, frictions, frictions))
def test_wedges_with_three_frictions_agree_with_the_oracle(
    alpha: float, beta: float, f: tuple[float, float, float]
) -> None:
    assume(alpha + beta < 175 and degrees(atan(f[0]) + atan(f[2])) < beta - 1)
    device = Wedges.model_validate(
        {"alpha": deg(alpha), "beta": deg(beta), "Q": "1000 N", "f12": f[0], "f13": f[1], "f23": f[2]}
    )
    found, exact = read(device), device_answers(device)
    assert all(near(found[key], value, 1.0 if key[0] in "FR" else 1e-3) for key, value in exact.items())


@few
@given(st.floats(5, 120), st.floats(10, 85), frictions)
def test_the_reactions_on_each_wedge_sum_to_zero(alpha: float, beta: float, f: float) -> None:
    assume(alpha + beta < 175 and 2 * degrees(atan(f)) < beta - 1)
    found = read(wedges(alpha, beta, f))
    push = found["F"] * cmath.rect(1, radians(90 - alpha))
    assert abs(found["R_12"] + found["R_32"] - 1000j) < 1e-8 * abs(found["R_12"])
    assert abs(-found["R_12"] + found["R_31"] + push) < 1e-8 * abs(found["R_12"])


@few
@given(st.floats(5, 120), st.floats(10, 85), frictions)
def test_power_goes_into_the_load_and_into_friction_on_every_face(alpha: float, beta: float, f: float) -> None:
    assume(alpha + beta < 175 and 2 * degrees(atan(f)) < beta - 1)
    found = device_answers(wedges(alpha, beta, f))
    v1, v2 = cmath.rect(1, radians(90 - alpha)), 1j * sin(radians(alpha + beta)) / sin(radians(beta))
    lost = [-(found[key] * slip.conjugate()).real for key, slip in (("R_12", v2 - v1), ("R_32", v2), ("R_31", v1))]
    assert min(lost) >= -1e-9 * abs(found["F"])
    assert found["F"].real == pytest.approx(1000 * abs(v2) + sum(lost), rel=1e-9)


@few
@given(devices())
def test_efficiencies_lie_between_zero_and_one_and_those_of_the_way_back_never_above_one(device: Device) -> None:
    found = device_answers(device)
    driven = [key for key in ("eta",) if key in found and not isinstance(device, WedgeClamp)]
    assert all(0 < found[key].real <= 1 + 1e-12 for key in driven)
    assert all(found[key].real <= 1 + 1e-12 for key in ("eta", "eta_r") if key in found)


@few
@given(st.floats(5, 80), st.floats(10, 80), st.floats(-60, 80), frictions, st.floats(1.01, 2.0))
def test_more_friction_never_raises_an_efficiency(
    alpha: float, beta: float, tilt: float, f: float, more: float
) -> None:
    makers: tuple[Callable[[float], Device], ...] = (
        lambda f: wedges(alpha, beta, f),
        lambda f: incline(alpha, tilt, f),
        lambda f: clamp(alpha, f),
        lambda f: ring(alpha, f),
    )
    for make in makers:
        smoother, rougher = unlocked(make(f)), unlocked(make(f * more))
        if smoother is None or rougher is None:
            continue
        keys = ["eta", "eta_r"] if alpha + beta >= 90 or "lock_direct" not in smoother else ["eta"]
        assert all(rougher[key].real <= smoother[key].real + 1e-9 for key in keys if key in smoother)


def test_held_down_from_above_a_wedge_may_come_back_more_easily_with_more_friction() -> None:
    """Q then leans less on the wall: the law has this exception, and the solver of equilibrium finds it too."""
    found = [device_answers(wedges(3, 56, tan(radians(phi))))["eta_r"].real for phi in (0.0, 17.0, 26.0)]
    assert found[1] < found[2] < found[0] == pytest.approx(1)


def unlocked(device: Device) -> Mapping[str, complex | float] | None:
    try:
        return device_answers(device)
    except LockedError:
        return None


MAKERS: dict[str, Callable[[float], Device]] = {
    "wedges": lambda f: wedges(50, 55, f),
    "incline": lambda f: incline(24, 30, f),
    "clamp": lambda f: clamp(25, f),
    "ring": lambda f: ring(40, f),
}


@pytest.mark.parametrize("kind", MAKERS)
def test_without_friction_both_ways_have_the_frictionless_force_and_efficiency_one(kind: str) -> None:
    make = MAKERS[kind]
    smooth, nearly = read(make(0.0)), read(make(1e-7))
    assert all(abs(smooth[key] - 1) < 1e-12 for key in ("eta", "eta_r") if key in smooth)
    assert all(
        abs(smooth[key] - smooth["F_0"]) < 1e-9 * abs(smooth["F_0"]) for key in ("F", "F_sine", "F_r") if key in smooth
    )
    assert all(abs(nearly[key] - value) < 1e-5 * max(abs(value), 10) for key, value in smooth.items())


def test_frictionless_forces_follow_from_virtual_work() -> None:
    alpha, beta = radians(50), radians(55)
    assert read(wedges(50, 55, 0.0))["F"] == pytest.approx(1000 * sin(alpha + beta) / sin(beta), rel=1e-9)
    assert read(incline(24, 30, 0.0))["F"] == pytest.approx(1000 * sin(radians(24)) / cos(radians(6)), rel=1e-9)
    assert read(ring(40, 0.0))["F"] == pytest.approx(600 / tan(radians(40)), rel=1e-9)


@few
@given(devices(), st.floats(0.5, 50))
def test_the_force_scale_changes_no_answer(device: Device, mu: float) -> None:
    one, other = read(device), read(device, mu=mu)
    assert all(near(one[key], value, 1e-2 * device.force if key[0] in "FR" else 1e-3) for key, value in other.items())


@few
@given(devices())
def test_measured_polygon_and_sine_rule_agree(device: Device) -> None:
    found = read(device)
    for key in ("F", "F_r"):
        if f"{key}_sine" in found:
            assert near(found[key], found[f"{key}_sine"], 1e-3 * device.force)


@few
@given(devices())
def test_every_force_polygon_closes_corner_to_corner(device: Device) -> None:
    for figure in draw(device).figures:
        if figure.view is View.FORCE:
            sides = [mark for mark in figure.marks if isinstance(mark, Vector)]
            scale = max(abs(side.b - side.a) for side in sides)
            starts, ends = ([getattr(side, name) for side in sides] for name in ("a", "b"))
            assert all(min(abs(end - start) for start in starts) < 1e-9 * scale for end in ends)


# -- self-locking ---------------------------------------------------------------------------------------------------


@few
@given(st.floats(5, 120), st.floats(10, 80), st.floats(0.02, 0.5))
def test_wedges_lock_just_beyond_the_limit_that_they_tell(alpha: float, beta: float, step: float) -> None:
    assume(alpha + beta < 170)
    found = device_answers(wedges(alpha, beta, 0.0))
    direct, reverse = found["lock_direct"].real, found["lock_reverse"].real
    assert direct == pytest.approx(beta / 2, rel=1e-9)
    assert reverse == pytest.approx((180 - alpha - beta) / 2, rel=1e-9)
    assert device_answers(wedges(alpha, beta, tan(radians(direct - step))))["F"].real > 0
    with pytest.raises(LockedError):
        device_answers(wedges(alpha, beta, tan(radians(direct + step))))
    for phi in (reverse - step, reverse + step):
        if phi < direct:
            assert (device_answers(wedges(alpha, beta, tan(radians(phi))))["F_r"].real > 0) == (phi < reverse)


@few
@given(st.floats(2, 60), st.floats(0.02, 0.8))
def test_plane_clamp_and_ring_lock_where_their_limits_say(alpha: float, f: float) -> None:
    phi = degrees(atan(f))
    assume(min(abs(alpha - phi), abs(alpha - 2 * phi), abs(alpha + phi - 90)) > 0.01)
    plane = device_answers(incline(alpha, 0, f)) if alpha + phi < 89 else None
    if plane is not None:
        assert (
            (plane["F_r"].real <= 0)
            == (plane["eta_r"].real <= 0)
            == (alpha <= plane["alpha_limit"].real)
            == (alpha <= phi)
        )
    wedge = device_answers(clamp(alpha, f))
    assert (
        (wedge["F"].real <= 0) == (wedge["eta"].real <= 0) == (alpha <= wedge["alpha_limit"].real) == (alpha <= 2 * phi)
    )
    if alpha > phi:
        buffer = device_answers(ring(alpha, f))
        assert (buffer["F_r"].real <= 0) == (alpha >= buffer["alpha_max"].real)
        assert isclose(buffer["alpha_min"].real, phi, rel_tol=1e-9)


LOCKED = [
    (wedges(60, 20, 0.4), r"beta = 20 deg .* phi_12 \+ phi_23 = 43.6"),
    (ring(5, 0.12), r"alpha = 5 deg must be greater than the friction angle phi = 6.843 deg"),
    (incline(60, 0, 0.7), r"beta = 0 deg .* phi − 90 = -55.01 deg .* alpha = 60 deg"),
    (incline(5, 80, 0.4), r"no force along beta = 80 deg .* 90 − phi = 68.2 deg"),
]


@pytest.mark.parametrize(("device", "words"), LOCKED)
@pytest.mark.parametrize("way", [read, device_answers], ids=["drawing", "oracle"])
def test_a_locked_device_is_refused_with_angle_and_limit(
    device: Device, words: str, way: Callable[[Device], object]
) -> None:
    with pytest.raises(LockedError, match=words):
        way(device)


def test_wedges_exactly_at_the_limit_are_locked() -> None:
    for way in (device_answers, partial(read, by="drafting")):
        with pytest.raises(LockedError):
            way(wedges(60, 40, tan(radians(20.0)) * (1 + 1e-12)))


def test_a_self_locking_way_back_has_a_negative_force_and_says_so() -> None:
    construction = draw(wedges(100, 60, 0.3))
    assert construction.readings["F_r"].scalar < 0
    assert construction.readings["eta_r"].scalar < 0
    assert any("self-locking" in step.words.en and "自锁" in step.words.zh for step in construction.steps)


# -- what is refused ------------------------------------------------------------------------------------------------

FILE = "id: x\ntitle: t\ndevice: {kind}\ndata: {{{data}}}\n"


@pytest.mark.parametrize(
    ("kind", "data", "words"),
    [
        ("wedges", "alpha: 60 deg, beta: 95 deg, Q: 1000 N, f: 0.15", "beta = 95 deg"),
        ("wedges", "alpha: 120 deg, beta: 60 deg, Q: 1000 N, f: 0.15", "alpha \\+ beta below 180 deg"),
        ("wedges", "alpha: 60 deg, beta: 60 deg, Q: 1000 N", "f12, f13 and f23"),
        ("wedges", "alpha: 60 deg, beta: 60 deg, Q: 1000 N, f12: 0.1, f13: 0.1", "f12, f13 and f23"),
        ("wedges", "alpha: 60 deg, beta: 60 deg, Q: 0 N, f: 0.1", "greater than zero"),
        ("incline", "alpha: 95 deg, beta: 45 deg, Q: 10 N, f: 0.1", "alpha = 95 deg"),
        ("incline", "beta: 95 deg, Q: 10 N, f: 0.1", "beta = 95 deg"),
        ("incline", "beta: 45 deg, Q: 10 N, f: 0", "without friction there is no limit"),
        ("wedge-clamp", "alpha: 90 deg, R: 10 N, f: 0.1", "alpha = 90 deg"),
        ("ring-spring", "alpha: 0 deg, Q: 10 N, f: 0.1", "alpha = 0 deg"),
        ("ring-spring", "alpha: 30 deg, Q: 10 N, f: -0.1", "negative"),
    ],
)
def test_impossible_data_are_refused_in_one_sentence(kind: str, data: str, words: str) -> None:
    with pytest.raises(ProblemFileError, match=words):
        loads(FILE.format(kind=kind, data=data))


def test_a_device_made_in_python_checks_itself_too() -> None:
    with pytest.raises(ValidationError, match="beta = 95"):
        wedges(60, 95, 0.15)


@pytest.mark.parametrize(("more", "noted"), [("", True), ("find: [alpha_limit, eta]", False), ("find: [eta]", True)])
def test_a_slope_that_nobody_gave_is_told(more: str, noted: bool) -> None:
    text = f"id: i\ntitle: i\ndevice: incline\ndata: {{f: 0.3, beta: 12 deg, Q: 800 N}}\n{more}\n"
    warnings = " ".join(words.en for words in loads(text).warnings)
    assert ("limit of self-locking, α = φ = 16.7°" in warnings) is noted
