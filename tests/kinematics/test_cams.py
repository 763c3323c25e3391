"""Cams, eccentric discs and their followers: the higher pair replaced,
by drawing and by the oracle, against closed formulas."""

from __future__ import annotations

from cmath import exp, phase
from dataclasses import replace
from math import cos, degrees, radians, sin, sqrt

import numpy as np
import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from tests.at_once import scaled
from tests.each import each
from tests.laws import often
from vecpoly import Problem, load, loads, oracle
from vecpoly.board.board import Board
from vecpoly.board.construction import Scale, View
from vecpoly.board.hand import hand
from vecpoly.board.paper.marks import Arc, Disc, FixedGuide, Point, Role, Segment
from vecpoly.errors import AssemblyError, DeadPointError, ProblemFileError
from vecpoly.mechanism.groups.assur import decompose
from vecpoly.mechanism.groups.mobility import mobility
from vecpoly.methods.desk import Desk
from vecpoly.methods.draw import draw
from vecpoly.methods.plan import construct
from vecpoly.names import parse_rel
from vecpoly.oracle.closed.contact import touching
from vecpoly.problem.asked.asks import AskRel

LEVER = """
id: lever
title: disc and lever
frame: {{A: [0 mm, 0 mm], C: [{x} mm, {y} mm]}}
links:
  1: {{AO: {e} mm, disc: O, radius: {R} mm}}
  2: {{CE: {l} mm, disc: E, radius: {r} mm}}
joints: [1 touches 2{inside} at K]
input: {{link: 1, phi: {phi} deg, omega: 6 rad/s cw, alpha: 20 rad/s^2 ccw}}
branch: [E {side} of OC]
"""
TRANSLATING = """
id: tappet
title: disc and translating follower
frame: {{A: [0 mm, 0 mm]}}
links:
  1: {{AO: 30 mm, disc: O, radius: 50 mm}}
  2: {follower}
joints: [1 touches 2 at K{side}, 2 slides on x = 15 mm]
input: {{link: 1, phi: {phi} deg, omega: 4 rad/s ccw}}
{branch}
"""
SLIDES = {
    "v": Scale(symbol="μ_v", value=1e-3, unit="m/s"),
    "a": Scale(symbol="μ_a", value=1e-2, unit="m/s^2"),
    "l": Scale(symbol="μ_l", value=1e-3, unit="m"),
}


def lever(**data: object) -> Problem:
    return loads(
        LEVER.format(
            **({"x": 118, "y": 26, "e": 22, "R": 48, "l": 108, "r": 11, "phi": 28, "side": "left", "inside": ""} | data)
        )
    )


def face(phi: float = 33.0, left: float = 9.0, side: str = "right") -> Problem:
    text = LEVER.format(x=-126, y=8, e=20, R=46, l=0, r=0, phi=phi, side="", inside="")
    head, _, tail = text.partition("  2: ")
    tail = (
        tail.partition("joints:")[2]
        .replace("1 touches 2 at K", f"1 touches 2 at K {side} of the face")
        .partition("branch")[0]
    )
    return loads(f"{head}  2: {{face: {{through: C, left: {left} mm}}, G: {{along: C, at: 190 mm}}}}\njoints:{tail}")


def round_tappet(phi: float = 50.0) -> Problem:
    return loads(
        TRANSLATING.format(
            follower="{block: E, disc: E, radius: 12 mm}", side="", phi=phi, branch="branch: [E above O]"
        )
    )


def flat_tappet(phi: float = 50.0, turn: float = -90.0) -> Problem:
    follower = f"{{block: F, face: {{through: F, angle: {turn} deg from line}}}}"
    return loads(TRANSLATING.format(follower=follower, side=" right of the face", phi=phi, branch=""))


def asking(problem: Problem, keys: str) -> Problem:
    return replace(problem, loads=None, asks=tuple(AskRel(rel=parse_rel(key)) for key in keys.split()))


def drawn(problem: Problem, keys: str) -> dict[str, complex]:
    readings = construct(scaled(asking(problem, keys)), hand("exact"))[0].readings
    return {key: r.scalar if r.vector is None else r.vector for key, r in readings.items()}


def desk_of(problem: Problem) -> Desk:
    scales = {View.MECHANISM: SLIDES["l"], View.VELOCITY: SLIDES["v"], View.ACCELERATION: SLIDES["a"]}
    return draw(asking(problem, "omega_2"), Board(hand("exact"), scales))


def agree(problem: Problem, keys: str) -> None:
    """The exact hand and the oracle agree within 1e-9 of the largest quantity of the kind."""
    found, motion = drawn(problem, keys), oracle.solve(problem.mechanism)
    truth = {key: complex(motion.value(parse_rel(key))) for key in keys.split()}
    for key, value in truth.items():
        size = max(abs(v) for k, v in truth.items() if k[0] == key[0])
        assert found[key] == pytest.approx(value, rel=1e-9, abs=1e-9 * size), key


# -- the exercises ----------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("name", "letter", "facts"),
    [
        (
            "4-4",
            "K",
            {
                "O": 19.424847042896396 + 10.328374381289597j,
                "E": 19.07202928910772 + 69.32731945349077j,
                "K": 19.13780887032256 + 58.327516134944794j,
                "G": -19.399959320683706 + 86.17683257429273j,
                "normal": 90.34262862224305,
                "omega": -0.19749502920488626,
            },
        ),
        (
            "4-7",
            "C",
            {
                "O": 7.814622569785474 + 18.410097069048806j,
                "E": 60.68431056230856 + 22.12440609944192j,
                "C": 51.706439016408424 + 21.493674377299694j,
                "G": 67.3948053852855 + 55.455611586654655j,
                "normal": 4.018656974170614,
                "omega": -0.17111914849172666,
            },
        ),
    ],
)
def test_the_exercises_give_the_printed_places_normal_and_ratio(
    name: str, letter: str, facts: dict[str, complex]
) -> None:
    problem = load(name)
    mech, motion, desk = problem.mechanism, oracle.solve(problem.mechanism), desk_of(problem)
    for point in ("O", "E", "G", letter):
        assert 1e3 * motion.position(point) == pytest.approx(facts[point], rel=1e-9), point
        assert desk.at[point] == pytest.approx(facts[point], rel=1e-9), point
    place, pressed = touching(mech, motion.bodies, mech.contacts[0])
    assert 1e3 * place[0] == pytest.approx(facts[letter], rel=1e-9)
    assert degrees(phase(-pressed[0])) == pytest.approx(facts["normal"], rel=1e-9)
    assert degrees(phase(desk.normal_of(mech.contacts[0]))) == pytest.approx(facts["normal"], rel=1e-9)
    assert motion.omega("2") / mech.drive.rate == pytest.approx(facts["omega"], rel=1e-9)
    assert drawn(problem, "omega_2")["omega_2"].real / mech.drive.rate == pytest.approx(facts["omega"], rel=1e-9)


def test_the_flat_lever_carries_its_load_where_the_exercise_says() -> None:
    problem = load("4-5")
    assert 1e3 * oracle.solve(problem.mechanism).position("G") == pytest.approx(
        56.4767684597407 + 60.936083841649896j, rel=1e-9
    )
    assert desk_of(problem).at["G"] == pytest.approx(56.4767684597407 + 60.936083841649896j, rel=1e-9)
    assert load("4-5-circles").mechanism.links == problem.mechanism.links


# -- the replaced mechanism is counted as the real one ------------------------------------------------------------


@pytest.mark.parametrize("problem", [lever(), face(), round_tappet(), flat_tappet()])
def test_a_contact_is_one_higher_pair_and_its_substitute_is_no_link(problem: Problem) -> None:
    count = mobility(problem.mechanism)
    assert (count.links, count.lower, count.higher, count.freedom) == (2, 2, 1, 1)
    assert problem.mechanism.bodies == ("1", "2") and problem.mechanism.frame_number == "3"


@pytest.mark.parametrize(
    ("problem", "kind"), [(lever(), "RRR"), (face(), "RPR"), (round_tappet(), "RRP"), (flat_tappet(), "RPP")]
)
def test_the_replaced_mechanism_is_made_of_the_textbooks_groups(problem: Problem, kind: str) -> None:
    assert [group.kind for group in decompose(problem.mechanism)] == [kind]
    steps = construct(asking(problem, "a_O1 alpha_2" if kind == "RPR" else "alpha_2"), hand("exact"))[0].steps
    told = [step for step in steps if "高副低代" in step.words.zh and kind in step.words.zh and kind in step.words.en]
    assert [step.section.en.split()[0] for step in told] == ["Position", "Acceleration"], (
        "said where it is made, and where it is no matter of course"
    )


# -- followers against closed formulas ----------------------------------------------------------------------------


@given(phi=st.floats(0.0, 360.0))
@settings(max_examples=often(12))
def test_the_round_tappet_follows_the_closed_formula(phi: float) -> None:
    e, x, reach, t, w = 0.03, 0.015, 0.062, radians(phi), 4.0
    u, s = e * cos(t) - x, e * sin(t)
    d = sqrt(reach**2 - u**2)
    truth = {
        "p_E": complex(x, s + d),
        "v_E": 1j * w * (e * cos(t) + u * s / d),
        "a_E": 1j * w**2 * (-s + (u * e * cos(t) - s * s) / d - (u * s) ** 2 / d**3),
    }
    problem = round_tappet(phi)
    found, motion = drawn(problem, "p_E v_E a_E omega_2"), oracle.solve(problem.mechanism)
    for key, value in truth.items():
        assert complex(motion.value(parse_rel(key))) == pytest.approx(value, rel=1e-9, abs=1e-12), key
        assert found[key] == pytest.approx(value, rel=1e-9, abs=1e-11), key
    assert found["omega_2"] == 0


@given(phi=st.floats(0.0, 360.0), turn=st.floats(-120.0, -60.0))
@settings(max_examples=often(12))
def test_the_flat_tappet_follows_the_closed_formula(phi: float, turn: float) -> None:
    e, x, radius, t, w = 0.03, 0.015, 0.05, radians(phi), 4.0
    n = exp(1j * radians(90.0 + turn)) * 1j  # square to the face, away from the disc
    o = e * exp(1j * t)

    def along(z: complex) -> float:
        return (n.conjugate() * z).real / n.imag

    truth = {
        "p_F": complex(x, along(o - x) + radius / n.imag),
        "v_F2": 1j * along(1j * w * o),
        "a_F2": 1j * along(-w * w * o),
        "p_K": o + radius * n,
    }
    problem = flat_tappet(phi, turn)
    found, motion = drawn(problem, " ".join(truth)), oracle.solve(problem.mechanism)
    for key, value in truth.items():
        assert complex(motion.value(parse_rel(key))) == pytest.approx(value, rel=1e-9, abs=1e-12), key
        assert found[key] == pytest.approx(value, rel=1e-9, abs=1e-11), key


# -- laws of contact ------------------------------------------------------------------------------------------------

discs = {
    "e": st.floats(2.0, 30.0),
    "R": st.floats(35.0, 60.0),
    "r": st.floats(3.0, 25.0),
    "phi": st.floats(0.0, 360.0),
    "l": st.floats(90.0, 130.0),
    "x": st.floats(90.0, 140.0),
    "y": st.floats(-20.0, 40.0),
    "side": st.sampled_from(["left", "right"]),
}


@given(data=st.fixed_dictionaries(discs))
@settings(max_examples=often(15))
def test_discs_touch_in_one_point_and_slide_along_the_common_tangent(data: dict[str, object]) -> None:
    problem = lever(**data)
    mech = problem.mechanism
    try:
        motion = oracle.solve(mech)
    except (AssemblyError, DeadPointError):
        assume(False)
    k, n = (values[0] for values in touching(mech, motion.bodies, mech.contacts[0]))
    assert abs(k - motion.position("O")) == pytest.approx(mech.contacts[0].disc.radius, rel=1e-12)
    assert abs(k - motion.position("E")) == pytest.approx(mech.contacts[0].on.radius, rel=1e-12)  # type: ignore[union-attr]
    slip = complex(motion.value(parse_rel("v_K2K1")))
    assert abs((n.conjugate() * slip).real) <= 1e-9 * abs(slip) + 1e-12
    assume(abs((n.conjugate() * (motion.position("E") - motion.position("C"))).imag) > 0.01)  # well off the dead point
    agree(problem, "p_O p_E p_K v_E v_EO v_K1 v_K2 v_K2K1 omega_2 omega_OE a_E an_EO at_EO alpha_2 alpha_OE")


@given(phi=st.floats(0.0, 360.0), left=st.floats(-20.0, 30.0), side=st.sampled_from(["left", "right"]))
@settings(max_examples=often(15))
def test_a_face_touches_its_disc_and_slides_along_itself(phi: float, left: float, side: str) -> None:
    problem = face(phi, left, side)
    mech, motion = problem.mechanism, oracle.solve(problem.mechanism)
    k, n = (values[0] for values in touching(mech, motion.bodies, mech.contacts[0]))
    along = exp(1j * float(motion.angle("2")))
    assert (along.conjugate() * (k - motion.position("C"))).imag == pytest.approx(left * 1e-3, abs=1e-12)
    assert (along.conjugate() * (k - motion.position("C"))).real > 0, "the contact lies ahead of the pivot"
    assert (along.conjugate() * n).imag == pytest.approx(1.0 if side == "left" else -1.0)
    slip = complex(motion.value(parse_rel("v_K2K1")))
    assert abs((n.conjugate() * slip).real) <= 1e-9
    agree(problem, "p_K v_O1 v_O2 v_O2O1 v_K1 v_K2 v_K2K1 omega_2 a_O1 a_O2 ak_O2O1 ar_O2O1 a_G alpha_2")


@pytest.mark.parametrize("inside", [(48.0, 80.0), (80.0, 48.0)])
def test_a_disc_runs_inside_a_ring_whichever_of_the_links_carries_the_ring(inside: tuple[float, float]) -> None:
    problem = lever(R=inside[0], r=inside[1], inside=" inside", x=100, y=20)
    mech, motion, desk = problem.mechanism, oracle.solve(problem.mechanism), desk_of(problem)
    contact = mech.contacts[0]
    assert contact.disc.radius == 0.048, "the disc is the smaller one, which presses outwards"
    assert abs(motion.position("O") - motion.position("E")) == pytest.approx(0.032)
    k, n = (values[0] for values in touching(mech, motion.bodies, contact))
    for centre, radius in ((contact.disc.centre, 0.048), ("E" if contact.disc.centre == "O" else "O", 0.080)):
        assert k - motion.position(centre) == pytest.approx(-n * radius)
    assert desk.at["K"] == pytest.approx(1e3 * k) and desk.normal_of(contact) == pytest.approx(-n)
    agree(problem, "p_K v_E omega_2 a_E alpha_2 v_K2K1")


@pytest.mark.parametrize("problem", [lever(), face(), round_tappet(), flat_tappet(turn=-75.0)])
def test_rates_are_the_differences_of_the_oracles_positions(problem: Problem) -> None:
    """Of uniform input: v = ω dp/dφ, a = ω² d²p/dφ²."""
    mech = replace(problem.mechanism, drives=(replace(problem.mechanism.drive, accel=0.0),))
    step, w, at = 1e-4, mech.drive.rate, mech.drive.position
    near = oracle.solve(mech, at + step * np.array([-1.0, 0.0, 1.0]))
    for point in [p for p in (*mech.link("2").points, "O") if p not in mech.frame] + ["K"]:
        p = near.position(point)
        if point != "K":  # K is a point of no link: it has a place, and each link its own velocity under it
            assert near.velocity(point)[1] == pytest.approx(w * (p[2] - p[0]) / (2 * step), rel=1e-6, abs=1e-7)
            assert near.acceleration(point)[1] == pytest.approx(
                w**2 * (p[2] - 2 * p[1] + p[0]) / step**2, rel=1e-5, abs=1e-5
            )
    angle = np.unwrap(near.angle("2"))
    assert near.omega("2")[1] == pytest.approx(w * (angle[2] - angle[0]) / (2 * step), rel=1e-6, abs=1e-7)
    assert near.alpha("2")[1] == pytest.approx(
        w**2 * (angle[2] - 2 * angle[1] + angle[0]) / step**2, rel=1e-5, abs=1e-5
    )


def test_a_driving_face_moves_a_round_lever() -> None:
    """The face may be on the driver: the substitute block then slides on a moving guide."""
    problem = loads("""
id: driver
title: face drives a lever
frame: {A: [0 mm, 0 mm], C: [150 mm, 10 mm]}
links:
  1: {face: {through: A, left: 12 mm}, B: {along: A, at: 120 mm}}
  2: {CE: 80 mm, disc: E, radius: 15 mm}
joints: ["2 touches 1 at K, left of the face"]
input: {link: 1, phi: 10 deg, omega: 2 rad/s ccw, alpha: 3 rad/s^2 cw}
branch: [E left of C]
""")
    agree(problem, "p_K p_E v_E omega_2 v_K2K1 a_E alpha_2")


# -- what is drawn ---------------------------------------------------------------------------------------------------


def test_the_diagram_of_a_cam_shows_profile_base_circle_normal_and_the_dashed_substitute() -> None:
    figure = construct(asking(load("4-4"), "omega_2"), hand("exact"))[0].figures[0]
    mm = 1 / figure.scale.value
    assert sorted(m.radius for m in figure.marks if isinstance(m, Disc)) == pytest.approx([0.011 * mm, 0.048 * mm])
    rings = [m.radius for m in figure.marks if isinstance(m, Arc) and m.role is Role.CENTRE]
    assert rings == pytest.approx([(0.048 - 0.022) * mm])
    (thought,) = [m for m in figure.marks if isinstance(m, Segment) and m.role is Role.HIDDEN]
    assert abs(thought.b - thought.a) == pytest.approx(0.059 * mm)
    labels = [m.label for m in figure.marks if isinstance(m, Point)]
    assert labels.count("n") == 2 and labels.count("K") == 1
    bars = [m for m in figure.marks if isinstance(m, Segment) and m.role is Role.LINK]
    assert [abs(m.b - m.a) for m in bars] == pytest.approx([0.150 * mm]), "the lever alone is a bar"


@each(("4-5", "3-1c", "D-3"))
def test_no_sentence_and_no_letter_names_the_block_that_is_only_thought(name: str) -> None:
    there = load(name).solve(by="exact")
    thought = [link for link in there.problem.mechanism.substitutes if link.startswith("pin")]
    labels = [getattr(mark, "label", "") for figure in there.construction.figures for mark in figure.marks]
    told = " ".join((*(step.words.zh + step.words.en for step in there.construction.steps), *labels))
    assert thought and not [link for link in thought if link.lower() in told.lower()]


@pytest.mark.parametrize("problem", [round_tappet(), flat_tappet()])
def test_a_translating_follower_has_a_stem_between_two_fixed_guides(problem: Problem) -> None:
    marks = construct(asking(problem, "omega_2"), hand("exact"))[0].figures[0].marks
    left, right = (m for m in marks if isinstance(m, FixedGuide))
    scale = 0.015 / construct(asking(problem, "omega_2"), hand("exact"))[0].figures[0].scale.value
    assert (left.a + right.b).real / 2 == pytest.approx(scale)
    assert min(left.a.imag, left.b.imag) > max(m.centre.imag + m.radius for m in marks if isinstance(m, Disc)) - 1e-9


def test_every_hand_draws_the_contact_near_its_place() -> None:
    problem = load("4-4")
    for who in ("drafting", "pencil"):
        reading = construct(asking(problem, "p_K omega_2"), hand(who))[0].readings["p_K"]
        assert (
            reading.vector is not None and abs(reading.vector - (0.01913780887032256 + 0.058327516134944794j)) < 0.003
        )


# -- files -----------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("old", "new", "said"),
    [
        ("1 touches 2 at K", "1 touches 2 at C", "letter C already is a point"),
        ("1 touches 2 at K", "1 touches 1 at K", "cannot touch itself"),
        ("1 touches 2 at K", "1 touches 7 at K", "link '7' does not exist"),
        ("1 touches 2 at K", "1 touches 2", "is no contact; write '1 touches 2 at K'"),
        ("1 touches 2 at K", "1 touches 2 at K left of the face", "touch with their discs"),
        ("1 touches 2 at K", "1 touches 2 at K, left of the face", "'left of the face' is no contact"),
        (", disc: E, radius: 11 mm", "", "neither disc nor face"),
        (", disc: E, radius: 11 mm", ", face: C", "on which side of the face of link 2"),
        (", disc: E, radius: 11 mm", ", disc: E", "a disc needs its radius"),
        (", disc: E, radius: 11 mm", ", disc: F, radius: 11 mm", "the centre 'F' is not on link 2"),
        ("radius: 11 mm", "radius: -11 mm", "must be greater than zero"),
        ("radius: 11 mm", "radius: 11 mm, gear: E", "a gear and a disc at once"),
        ("radius: 11 mm", "radius: 11 mm, face: {throgh: C}", "throgh"),
        ("1 touches 2 at K", "1 touches 2 inside at K", ""),
    ],
)
def test_a_wrong_contact_is_told_where_it_stands(old: str, new: str, said: str) -> None:
    text = LEVER.format(x=118, y=26, e=22, R=48 if said else 11, l=108, r=11, phi=28, side="left", inside="")
    assert text.count(old) >= 1
    with pytest.raises(ProblemFileError) as caught:
        loads(text.replace(old, new, 1))
    assert said in str(caught.value) and "line" in str(caught.value)


def test_a_disc_too_far_from_its_follower_does_not_assemble() -> None:
    with pytest.raises(AssemblyError):
        oracle.solve(lever(x=400).mechanism)


def test_a_face_too_near_its_own_pivot_has_no_direction() -> None:
    problem = loads("""
id: near
title: pivot inside the disc
frame: {A: [0 mm, 0 mm], C: [-30 mm, 0 mm]}
links: {1: {AO: 10 mm, disc: O, radius: 60 mm}, 2: {face: C}}
joints: [1 touches 2 at K right of the face]
input: {link: 1, phi: 33 deg, omega: 1 rad/s ccw}
find: [omega_2]
""")
    with pytest.raises(AssemblyError):
        problem.solve(by="exact")
