"""Screw jack, guides, clamps and trains of machines: drawn, exact, printed; and the tangents of friction circles."""

from __future__ import annotations

import cmath
import json
import math
from collections.abc import Mapping
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st

import vecpoly
from tests.laws import often
from vecpoly.board.board import Board
from vecpoly.board.construction import Construction, View
from vecpoly.board.hand import hand
from vecpoly.board.paper.marks import Cell, Disc, Outline, TurnArrow, Vector
from vecpoly.check.printed.answers import check_problem
from vecpoly.check.printed.verdict import Verdict
from vecpoly.devices.base import Device, kind_of
from vecpoly.drawing.sheets.paper import DrawingPaper
from vecpoly.errors import EquilibriumError, LockedError, ProblemFileError
from vecpoly.methods.devices.plan import construct_device
from vecpoly.oracle.devices.registry import device_answers
from vecpoly.plane import cross, dot
from vecpoly.problem.asked.asks import AskNamed
from vecpoly.problem.problem import Problem
from vecpoly.words import Words

CASES: dict[str, Any] = json.loads(
    (Path(__file__).resolve().parents[1] / "data" / "ch5-machines.json").read_text(encoding="utf-8")
)
NUMBERS = ("4-1", "5-3", "5-5", "5-6", "5-7")

SPAN = st.floats(-200, 200)
POINT = st.builds(complex, SPAN, SPAN)
SENSE = st.sampled_from([-1.0, 1.0])


def board() -> Board:
    return Board(hand("exact"), {})


TURN = st.floats(-math.pi, math.pi)


@given(
    centre=POINT,
    away=st.floats(2, 300),
    bearing=TURN,
    share=st.floats(0, 0.98),
    moment=SENSE,
    ahead=SENSE,
    aside=st.floats(-0.15, 0.15),
)
def test_a_tangent_from_a_point_has_the_arm_and_the_sense_asked_for(
    centre: complex, away: float, bearing: float, share: float, moment: float, ahead: float, aside: float
) -> None:
    x, radius, ray = centre + cmath.rect(away, bearing), share * away, cmath.rect(1, bearing)
    towards = ahead * ray * cmath.rect(1, aside)
    u = board().tangent_from(x, centre, radius, moment, towards)
    assert abs(u) == pytest.approx(1)
    assert cross(x - centre, u) == pytest.approx(moment * radius, abs=1e-9)
    foot = centre - 1j * u * moment * radius
    assert cross(x - foot, u) == pytest.approx(0, abs=1e-9)
    assert ahead * dot(u, ray) > 0


@given(
    p=POINT,
    span=st.floats(2, 300),
    bearing=TURN,
    shares=st.tuples(st.floats(0, 0.49), st.floats(0, 0.49)),
    moments=st.tuples(SENSE, SENSE),
    sense=SENSE,
)
def test_a_tangent_to_two_circles_turns_each_pin_as_asked(
    p: complex, span: float, bearing: float, shares: tuple[float, float], moments: tuple[float, float], sense: float
) -> None:
    q, radii = p + cmath.rect(span, bearing), (span * shares[0], span * shares[1])
    line = board().tangent_to_both(p, radii[0], moments[0], q, radii[1], moments[1], sense)
    u = line.along
    assert cross(line.at - p, u) == pytest.approx(moments[0] * radii[0], abs=1e-9)
    assert cross(line.at - q, -u) == pytest.approx(moments[1] * radii[1], abs=1e-9)
    assert sense * dot(u, q - p) > 0


def test_a_point_inside_the_friction_circle_has_no_tangent() -> None:
    with pytest.raises(EquilibriumError, match="inside it"):
        board().tangent_from(1 + 0j, 0j, 5.0, 1.0, 1 + 0j)
    with pytest.raises(EquilibriumError, match="no common tangent"):
        board().tangent_to_both(0j, 6.0, 1.0, 10 + 0j, 5.0, 1.0, 1.0)


def test_an_unsteady_hand_tilts_the_tangent_and_nothing_else() -> None:
    shaky = Board(hand("drafting", repeats=50), {})
    u = np.asarray(shaky.tangent_from(100 + 0j, 0j, 5.0, 1.0, 1 + 0j))
    turned = [abs(cmath.phase(v / u[0])) for v in u]
    assert u.shape == (51,)
    assert 0 < max(turned) < math.radians(0.5)


# -- the exercises
# ------------------------------------------------------------------------------------------------------


def expected(case: str) -> dict[str, complex | float]:
    return {key: complex(*value) if isinstance(value, list) else value for key, value in CASES[case].items()}


@pytest.mark.parametrize("case", NUMBERS)
def test_the_drawing_by_the_exact_hand_agrees_with_the_worked_exercise(case: str) -> None:
    problem = vecpoly.load(case)
    construction, *_ = construct_device(asking_all(problem.device), hand("exact"), DrawingPaper())
    for key, value in expected(case).items():
        reading = construction.readings[key]
        assert (reading.scalar if reading.vector is None else reading.vector) == pytest.approx(value, rel=1e-9), key


@pytest.mark.parametrize("case", NUMBERS)
def test_the_oracle_agrees_with_the_worked_exercise(case: str) -> None:
    exact = device_answers(vecpoly.load(case).device)
    for key, value in expected(case).items():
        assert exact[key] == pytest.approx(value, rel=1e-9), key


@pytest.mark.parametrize("case", NUMBERS)
def test_every_quantity_is_drawn_and_known_to_the_oracle(case: str) -> None:
    agree(vecpoly.load(case).device)


@pytest.mark.parametrize("case", NUMBERS)
def test_a_careful_hand_is_off_by_no_more_than_its_drawing_error(case: str) -> None:
    for answer in vecpoly.load(case).solve().answers.values():
        assert abs(answer.deviation) <= answer.expected_error + 1e-9 * abs(answer.exact), answer.key


@pytest.mark.parametrize("case", NUMBERS)
def test_every_step_speaks_both_languages(case: str) -> None:
    for step in drawn(vecpoly.load(case).device).steps:
        assert step.words.zh.strip() and step.words.en.strip() and step.words.zh != step.words.en


def test_printed_answers_are_reproduced_but_for_one_misprint() -> None:
    wrong = [
        (case, checked.printed.symbol, checked.printed.text)
        for case in NUMBERS
        for checked in check_problem(vecpoly.load(case)).answers
        if checked.verdict in (Verdict.WRONG, Verdict.OUTLIER)
    ]
    assert wrong == [("5-7", "eta_prime", "0.7057")]


def test_the_printed_factor_of_the_collar_would_double_its_moment() -> None:
    exact = device_answers(vecpoly.load("5-5").device)
    printed_formula = 0.1 * 2 / 3 * (30**3 - 15**3) / (30**2 - 15**2)
    assert printed_formula == pytest.approx(2 * float(exact["M1_over_Q"].real))


# -- making devices
# -----------------------------------------------------------------------------------------------------


def device(kind: str, data: Mapping[str, Any]) -> Device:
    return kind_of(kind).model_validate(dict(data))


def asking_all(subject: Device) -> Problem:
    return Problem(
        id="x",
        title=Words.same("x"),
        subject=subject,
        asks=tuple(AskNamed(rel=named) for named in subject.quantities()),
    )


def drawn(subject: Device) -> Construction:
    return construct_device(asking_all(subject), hand("exact"), DrawingPaper())[0]


def agree(subject: Device) -> Construction:
    """Everything that may be asked, by the exact hand and by the oracle."""
    construction, exact = drawn(subject), device_answers(subject)
    size = max(abs(value) for value in exact.values())
    for named in subject.quantities():
        reading = construction.readings[named.key]
        found = reading.scalar if reading.vector is None else reading.vector
        assert found == pytest.approx(exact[named.key], rel=1e-8, abs=1e-10 * size), named.key
    return construction


def value(subject: Device, key: str) -> float:
    return float(complex(device_answers(subject)[key]).real)


# -- trains of machines
# ---------------------------------------------------------------------------------------------------

ETA = st.floats(0.3, 1.0).map(lambda x: round(x, 3))
KIND = st.sampled_from(["belt", "gear", "worm", "chain", "machine"])
PART = st.builds(lambda kind, eta: {kind: str(eta)}, KIND, ETA)
LOAD = st.builds(lambda kind, eta, p: {kind: str(eta), "P": f"{p:.3f} kW"}, KIND, ETA, st.floats(0.1, 50))
LINE = st.builds(lambda parts, end: [*parts, end], st.lists(PART, max_size=3), LOAD)
TRAIN = st.recursive(
    LINE,
    lambda inner: st.builds(
        lambda parts, branches: [*parts, {"parallel": branches}],
        st.lists(PART, max_size=2),
        st.lists(inner, min_size=2, max_size=3),
    ),
    max_leaves=6,
)


def efficiencies(train: list[dict[str, Any]]) -> list[float]:
    own = [float(v) for part in train for k, v in part.items() if k not in ("parallel", "P")]
    return own + [eta for part in train for branch in part.get("parallel", []) for eta in efficiencies(branch)]


@settings(max_examples=often(6))
@given(train=TRAIN)
def test_any_nesting_of_trains_is_drawn_as_the_oracle_computes_it(train: list[dict[str, Any]]) -> None:
    agree(device("power-train", {"train": train}))


@given(train=TRAIN)
def test_an_efficiency_lies_between_nothing_and_all(train: list[dict[str, Any]]) -> None:
    assert 0 < value(device("power-train", {"train": train}), "eta") <= 1 + 1e-12


@given(line=LINE)
def test_machines_in_series_never_exceed_the_worst_of_them(line: list[dict[str, Any]]) -> None:
    assert value(device("power-train", {"train": line}), "eta") <= min(efficiencies(line)) + 1e-12


@given(branches=st.lists(LINE, min_size=2, max_size=4))
def test_parallel_branches_lie_between_the_worst_and_the_best(branches: list[list[dict[str, Any]]]) -> None:
    alone = [value(device("power-train", {"train": branch}), "eta") for branch in branches]
    together = value(device("power-train", {"train": [{"parallel": branches}]}), "eta_prime")
    assert min(alone) - 1e-12 <= together <= max(alone) + 1e-12


@given(train=TRAIN)
def test_the_shares_of_the_ends_add_up_to_the_power_of_the_motor(train: list[dict[str, Any]]) -> None:
    subject = device("power-train", {"train": train})
    exact = device_answers(subject)
    shares = [exact[named.key] for named in subject.quantities() if named.key.endswith("_in")]
    assert not shares or sum(shares) == pytest.approx(exact["P"])


def test_the_block_diagram_has_a_box_for_the_motor_and_for_every_machine() -> None:
    figure = drawn(vecpoly.load("5-7").device).figures[0]
    assert len([mark for mark in figure.marks if isinstance(mark, Cell)]) == 7


# -- screw jack
# -------------------------------------------------------------------------------------------------------------

JACK = {"d": "24 mm", "d1": "20 mm", "p": "4 mm", "D": "30 mm", "d0": "15 mm", "l": "300 mm", "f": "0.1", "F": "100 N"}


def jack(**changes: Any) -> Device:
    return device("screw-jack", {key: v for key, v in (JACK | changes).items() if v is not None})


@settings(max_examples=often(6))
@given(
    root=st.floats(8, 60),
    depth=st.floats(1, 8),
    pitch=st.floats(1, 12),
    starts=st.integers(1, 3),
    f=st.floats(0, 0.4),
    beta=st.sampled_from([None, "15 deg", "30 deg"]),
)
def test_a_jack_is_drawn_as_the_oracle_computes_it(
    root: float, depth: float, pitch: float, starts: int, f: float, beta: str | None
) -> None:
    construction = agree(
        jack(
            d=f"{root + depth} mm",
            d1=f"{root} mm",
            p=f"{pitch} mm",
            starts=starts,
            f=str(f),
            beta=beta,
            F=None,
            Q="5 kN",
        )
    )
    assert 0 < construction.readings["eta"].scalar <= 1 + 1e-9


@given(f=st.floats(0, 0.5), more=st.floats(0, 0.3))
def test_more_friction_never_raises_the_efficiency_of_a_jack(f: float, more: float) -> None:
    assert value(jack(f=str(f + more)), "eta") <= value(jack(f=str(f)), "eta") + 1e-12


def test_a_jack_without_friction_loses_nothing() -> None:
    assert value(jack(f="0"), "eta") == pytest.approx(1.0)
    assert value(jack(f="1e-7"), "eta") == pytest.approx(1.0, abs=1e-4)


@given(lead=st.floats(1, 20))
def test_a_thread_locks_itself_exactly_where_its_lead_angle_is_within_the_friction_angle(lead: float) -> None:
    subject = jack(p=f"{lead} mm")
    assume(abs(value(subject, "alpha") - value(subject, "phi")) > 1e-6)
    assert value(subject, "self_locking") == float(value(subject, "alpha") < value(subject, "phi"))


def test_force_and_load_of_a_jack_are_each_others_inverse() -> None:
    load = value(jack(), "Q")
    assert value(jack(F=None, Q=f"{load!r} N"), "F") == pytest.approx(100.0)


# -- guides
# -----------------------------------------------------------------------------------------------------------------


@settings(max_examples=often(6))
@given(f=st.floats(0.01, 0.5), l1=st.floats(20, 400), l2=st.floats(20, 400), theta=st.floats(10, 80))
def test_a_guide_is_drawn_as_the_oracle_computes_it(f: float, l1: float, l2: float, theta: float) -> None:
    subject = device(
        "vee-guide", {"f": str(f), "G": "1500 N", "l1": f"{l1} mm", "l2": f"{l2} mm", "theta": f"{theta} deg"}
    )
    readings = agree(subject).readings
    wedge = math.sin(math.radians(theta))
    assert readings["f_V"].scalar == pytest.approx(f * (l2 / ((l1 + l2) * wedge) + l1 / (l1 + l2)))
    assert f <= readings["f_V"].scalar <= readings["f_vee"].scalar


def test_the_normal_of_the_right_flank_pushes_the_vee_to_the_left_and_is_told_so() -> None:
    data = {"f": "0.1", "G": "1500 N", "l1": "120 mm", "l2": "180 mm", "theta": "40 deg"}
    construction = agree(device("vee-guide", data))
    [table] = [step.equation for step in construction.steps if step.equation is not None]
    flanks = [(told.zh, told.en) for told in table.directions if "flank" in told.en]
    drawn = {
        mark.key: mark.b - mark.a for one in construction.figures for mark in one.marks if isinstance(mark, Vector)
    }
    assert flanks == [("⊥右侧面", "⊥ right flank"), ("⊥左侧面", "⊥ left flank")]
    assert drawn["N_right"].real < 0 < drawn["N_left"].real


# -- eccentric clamp
# ----------------------------------------------------------------------------------------------------------

CLAMP = {
    "e": "12 mm",
    "theta": "204 deg",
    "R": "55 mm",
    "l": "260 mm",
    "handle": "28 deg",
    "F": "118 deg",
    "closing": "ccw",
    "f": "0.15",
    "rho": "5 mm",
    "Q": "400 N",
}


def clamp(**changes: Any) -> Device:
    return device("eccentric-clamp", {key: v for key, v in (CLAMP | changes).items() if v is not None})


@settings(max_examples=often(6))
@given(
    e=st.floats(2, 30),
    theta=st.floats(150, 250),
    lever=st.floats(120, 400),
    handle=st.floats(-30, 80),
    off=st.floats(40, 140),
    f=st.floats(0, 0.4),
    rho=st.floats(0.1, 10),
)
def test_a_clamp_is_drawn_as_the_oracle_computes_it(
    e: float, theta: float, lever: float, handle: float, off: float, f: float, rho: float
) -> None:
    push = handle + off
    lean = math.degrees(math.atan(f))
    assume(abs(math.sin(math.radians(push - 90 - lean))) > 0.05 and abs(math.sin(math.radians(push - 90))) > 0.05)
    assume(abs(math.cos(math.radians(theta + lean))) > 0.05)
    agree(
        clamp(
            e=f"{e} mm",
            theta=f"{theta} deg",
            l=f"{lever} mm",
            handle=f"{handle} deg",
            F=f"{push} deg",
            f=str(f),
            rho=f"{rho} mm",
        )
    )


@pytest.mark.parametrize("closing", ["ccw", "cw"])
def test_a_curved_arrow_at_the_pin_shows_which_way_the_clamp_closes(closing: str) -> None:
    mirrored = {"theta": "-24 deg", "handle": "152 deg", "F": "62 deg", "closing": "cw"}
    figure = agree(clamp(**(mirrored if closing == "cw" else {}))).figure(View.MECHANISM)
    assert figure is not None
    [arrow] = [mark for mark in figure.marks if isinstance(mark, TurnArrow)]
    assert arrow.ccw is (closing == "ccw") and arrow.at == 0


def test_a_clamp_seen_in_a_mirror_takes_the_same_force() -> None:
    mirrored = clamp(theta="-24 deg", handle="152 deg", F="62 deg", closing="cw")
    here, there = device_answers(clamp()), device_answers(mirrored)
    for key in ("F", "F_0", "h", "e_limit", "self_locking"):
        assert there[key] == pytest.approx(here[key]), key
    assert there["R_31"] == pytest.approx(-complex(here["R_31"]).conjugate())
    assert agree(mirrored).readings["R_31"].acts.tangent == "ccw"  # type: ignore[union-attr]


def test_the_drawn_reactions_of_the_clamp_are_in_equilibrium() -> None:
    """A third party's sum: forces, and moments about a point that has nothing to do with the drawing."""
    readings = drawn(clamp()).readings
    push = readings["F"].scalar * cmath.rect(1, math.radians(118))
    forces = [(push, 0.26 * cmath.rect(1, math.radians(28)))]
    for key in ("R_21", "R_31"):
        acts, vector = readings[key].acts, readings[key].vector
        assert acts is not None and vector is not None
        forces.append((vector, acts.point))
    assert abs(sum(vector for vector, _ in forces)) < 1e-9 * 400
    assert np.abs(sum(cross(at - (0.3 + 0.7j), vector) for vector, at in forces)) < 1e-9 * 400


def test_the_reaction_of_the_pin_touches_the_friction_circle_on_the_side_that_resists() -> None:
    reading = drawn(clamp()).readings["R_31"]
    assert reading.acts is not None and reading.vector is not None
    assert reading.acts.tangent == "cw"
    assert reading.acts.point == pytest.approx(complex(*CASES["touch_of_R31"]), rel=1e-9)
    assert cross(reading.acts.point, reading.vector) == pytest.approx(-0.005 * abs(reading.vector))


@given(f=st.floats(0, 0.4), rho=st.floats(0.1, 10), more=st.floats(0, 0.2))
def test_more_friction_never_lowers_the_force_on_the_handle(f: float, rho: float, more: float) -> None:
    force = value(clamp(f=str(f), rho=f"{rho} mm"), "F")
    assert force <= value(clamp(f=str(f + more), rho=f"{rho} mm"), "F") * (1 + 1e-12)
    assert force <= value(clamp(f=str(f), rho=f"{rho + 10 * more} mm"), "F") * (1 + 1e-12)
    assert force >= value(clamp(f="0", rho=None), "F") * (1 - 1e-12)


def test_a_clamp_without_friction_needs_the_ideal_force_and_does_not_lock() -> None:
    exact = device_answers(clamp(f="0", rho=None))
    assert exact["F"] == pytest.approx(exact["F_0"]) and exact["eta"] == pytest.approx(1)
    assert not exact["self_locking"]


@given(share=st.floats(0.05, 2.0))
def test_a_clamp_holds_up_to_the_limit_of_its_eccentricity_and_not_beyond(share: float) -> None:
    assume(abs(share - 1) > 1e-6)
    limit = value(clamp(), "e_limit")
    assert value(clamp(e=f"{1e3 * limit * share} mm"), "self_locking") == float(share < 1)


def test_a_handle_too_short_for_the_friction_is_locked() -> None:
    stubborn = clamp(l="8 mm", rho="20 mm")
    with pytest.raises(LockedError, match="lengthen the handle"):
        device_answers(stubborn)
    with pytest.raises(EquilibriumError):
        drawn(stubborn)


# -- bad data
# -----------------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("kind", "data", "says"),
    [
        ("screw-jack", JACK | {"d1": "24 mm"}, "d = 24 mm is the outer diameter of the thread"),
        ("screw-jack", JACK | {"D": "15 mm"}, "D = 15 mm is the outer diameter of the collar"),
        ("screw-jack", JACK | {"f": "-0.1"}, "must not be negative"),
        ("screw-jack", JACK | {"Q": "5 kN"}, "not both"),
        ("screw-jack", JACK | {"f_thread": "0.1"}, "both f_thread and f_collar"),
        ("screw-jack", JACK | {"p": "300 mm", "f": "0.5"}, "no moment turns this screw"),
        ("screw-jack", JACK | {"beta": "75 deg"}, "half the flank angle"),
        (
            "vee-guide",
            {"f": "0.1", "G": "1 N", "l1": "1 mm", "l2": "1 mm", "theta": "100 deg"},
            "half the angle of the V",
        ),
        ("eccentric-clamp", CLAMP | {"e": "52 mm"}, "must lie inside the disc"),
        ("eccentric-clamp", CLAMP | {"closing": "cw"}, "does not close"),
        ("eccentric-clamp", CLAMP | {"F": "-62 deg"}, "does not turn it ccw"),
        ("power-train", {"train": [{"gear": "1.2", "P": "5 kW"}]}, "is no efficiency"),
        ("power-train", {"train": [{"gear": "0.9"}]}, "nothing says what the last part of a train delivers"),
        ("power-train", {"train": []}, "a train without parts"),
        (
            "power-train",
            {"train": [{"gear": "0.9", "P": "1 kW"}, {"belt": "0.9", "P": "1 kW"}]},
            "delivered by the last part",
        ),
        ("power-train", {"train": [{"gear": "0.9", "belt": "0.9", "P": "1 kW"}]}, "gear|belt"),
        ("power-train", {"train": [{"gear": "0.9", "F": "1 N"}]}, "both F and v"),
        ("power-train", {"train": [{"parallel": [[{"gear": "0.9", "P": "1 kW"}]]}]}, "two branches or more"),
        (
            "power-train",
            {
                "train": [
                    {
                        "parallel": [
                            [{"gear": "0.9", "P": "1 kW", "name": "A"}],
                            [{"gear": "0.9", "P": "1 kW", "name": "A"}],
                        ]
                    }
                ]
            },
            "two ends",
        ),
    ],
)
def test_bad_data_is_refused_in_one_clear_sentence(kind: str, data: dict[str, Any], says: str) -> None:
    with pytest.raises(ValueError, match=says):
        device(kind, data)


def test_a_fault_in_a_problem_file_is_told_at_its_line(tmp_path: Path) -> None:
    text = (vecpoly.load("5-5").text).replace("D: 30 mm", "D: 10 mm")
    path = tmp_path / "jack.yaml"
    path.write_text(text, encoding="utf-8")
    with pytest.raises(ProblemFileError, match="D = 10 mm is the outer diameter"):
        vecpoly.load(path)


def test_the_workpiece_under_a_clamp_stands_and_the_disc_does_not() -> None:
    figure = drawn(clamp()).figure(View.MECHANISM)
    assert figure is not None
    bodies = {mark.owner: mark for mark in figure.marks if isinstance(mark, Outline | Disc)}
    work = bodies["link 2"]
    assert isinstance(work, Outline) and work.fixed
    assert all(not body.fixed for owner, body in bodies.items() if owner != "link 2" and isinstance(body, Outline))
