"""Instant centres where they are hard to find: class III groups, dead positions, centres a little off the paper."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from tests.label_faults import faults
from tests.laws import few, often
from tests.texts import CLASS_III
from vecpoly import load, loads, oracle
from vecpoly.board.paper.marks import Point, Role, Segment
from vecpoly.cycle.pose import posed
from vecpoly.drawing.figure import drawing
from vecpoly.errors import AssemblyError, NotAskedError
from vecpoly.mechanism.asked.centres import link_pairs
from vecpoly.mechanism.model import FRAME
from vecpoly.methods.centres.state import BEYOND
from vecpoly.methods.registry import Stage, find
from vecpoly.names import At, ascii_key, omega
from vecpoly.oracle.centres import Centres
from vecpoly.oracle.iterated.watch import PATIENCE, Watch
from vecpoly.report.statement.structure import structure
from vecpoly.solution import Solution

C3 = load("class-iii")
# blocks on blocks, of which several translate
ALL_BUT_ALIKE = """
id: x
title: blocks that translate alike
frame: {B: [-35.3100558 mm, -173.311347 mm]}
links:
  1: {block: A, D: {AD: 154.000617 mm, angle: -3.8016629 deg from line}, I: {AI: 32.9 mm, angle: 9.1189 deg from line}}
  2: {block: C, E: {CE: 114.098275 mm, angle: 0 deg from line}}
  3: {block: C, F: {along: line, at: 70.8509245 mm, left: 37.5112297 mm}}
  4: {block: G}
  5: {block: G, H: {along: G, at: 152.581554 mm}}
  6: {HJ: 368.713027 mm, K: {along: JH, at: 143.343988 mm}}
  7: {JI: 196.260553 mm, L: {JL: 25.7162972 mm, angle: 180 deg from JI}}
joints:
  - 1 slides on line through B at -43.3508784 deg with A 17.6629512 mm left
  - 2 slides on AD of 1 with C 5.19233854 mm left
  - 3 slides on x = -144.919819 mm with C 28.8007414 mm right turned 98.4232441 deg
  - 5 slides on CF of 3 with G 52.8968969 mm right
  - 4 slides on DA of 1 with G 84.6130425 mm right
input: {link: 1, s: -60.4212733 mm, v: 0.5 m/s, a: 0 m/s^2}
branch: [J left of HA]
method: centres
find: [omega_1, omega_2, omega_3, omega_4, omega_5, omega_6, omega_7]
"""


def at(problem: str, phi: float, find: str = "centres", **more: str) -> Solution:
    lines = [f"{key}: {value}" for key, value in more.items()]
    return loads(
        "\n".join(
            [
                f"id: x\nextends: {problem}\nprinted: []\nmethod: centres\nscales: {{}}\nfind: [{find}]\n"
                f"input: {{phi: {phi} deg, omega: 3 rad/s ccw}}",
                *lines,
            ]
        )
    ).solve(by="exact")


def agrees(solution: Solution, accuracy: float = 1e-7) -> None:
    """Every answer is the oracle's: places to the square of their distance, as a far meeting is uncertain."""
    size = solution.problem.mechanism.scale
    for key, answer in solution.answers.items():
        if answer.drawn_vector is not None and answer.exact_vector is not None:
            away = max(1.0, abs(answer.exact_vector) / size) ** 2 if key.startswith("P_") else 1.0
            assert abs(answer.drawn_vector - answer.exact_vector) < accuracy * away * (
                size if key.startswith("P_") else 1.0
            ), key
        elif answer.reading.unit == "deg":
            assert abs((answer.drawn - answer.exact + 90) % 180 - 90) < 1e-5, key
        else:
            assert abs(answer.drawn - answer.exact) < accuracy * max(1.0, abs(answer.exact)), key


# -- class III ------------------------------------------------------------------------------------------------------


def test_a_class_iii_group_needs_one_trial_triangle_and_then_all_centres_follow() -> None:
    solution = C3.solve(by="exact")
    agrees(solution)
    assert sum(key.startswith("P_") for key in solution.answers) == 28 == len(link_pairs(C3.mechanism))
    trials = [step for step in solution.construction.steps if "用试作法" in step.words.zh]
    assert len(trials) == 1 and "Try any point $x$" in trials[0].words.en
    assert find(Stage.CENTRES, "trial").draw.__name__ == "find_by_trial"
    assert all(len(directions) >= 3 for directions in through_corners(solution, trials[0].number))


def test_every_centre_of_a_class_iii_linkage_bears_its_letter_also_the_one_found_by_trial() -> None:
    solution = C3.solve(by="exact")
    (figure,) = (one for one in solution.construction.figures if one.name == "centres")
    letters = {ascii_key(mark.label) for mark in figure.marks if isinstance(mark, Point)}
    assert {key for key in solution.answers if key.startswith("P_")} <= letters


def through_corners(solution: Solution, step: int) -> list[set[float]]:
    """The directions of the lines that this step rules through each corner x, y, z of its triangle."""
    figure = next(
        f for f in solution.construction.figures if any(isinstance(m, Point) and m.label == "x" for m in f.marks)
    )
    lines = [m for m in figure.marks if isinstance(m, Segment) and m.role is Role.DIRECTION and m.step == step]
    corners = [m.at for m in figure.marks if isinstance(m, Point) and m.label in ("x", "y", "z")]
    assert corners
    return [
        {
            round((m.b - m.a).imag / (m.b - m.a).real, 6)
            for m in lines
            if abs(((m.b - m.a).conjugate() * (at - m.a)).imag) < 1e-6 * abs(m.b - m.a)
        }
        for at in corners
    ]


def test_velocities_of_a_class_iii_linkage_follow_from_its_centres() -> None:
    rates = [f"omega_{link}" for link in C3.mechanism.bodies]
    solution = at("class-iii", 105, ", ".join([*rates, "v_G", "v_H", "v_L"]))
    motion = oracle.solve(solution.problem.mechanism)
    for link in C3.mechanism.bodies:
        assert solution.answers[omega(link).key].drawn == pytest.approx(float(motion.omega(link)), abs=1e-8)
    agrees(solution)


@settings(max_examples=often(2))
@given(phi=st.integers(20, 150), gh=st.integers(60, 80), ki=st.integers(105, 115))
def test_random_class_iii_groups_agree_with_the_oracle_in_any_position(phi: int, gh: int, ki: int) -> None:
    links = f"{{4: {{GH: {gh} mm, L: {{GL: 60 mm, HL: 50 mm, side: left of GH}}}}, 7: {{KL: {ki} mm}}}}"
    try:
        solution = at("class-iii", phi, links=links)
    except (AssemblyError, NotAskedError):
        return
    if max(abs(a.exact_vector or 0) for a in solution.answers.values()) < 30 * C3.mechanism.scale:
        agrees(solution, 1e-6)


def test_the_drafting_hand_stays_within_the_expected_error_of_a_class_iii_group() -> None:
    for key, answer in C3.solve().answers.items():
        off = (
            abs(answer.drawn_vector - answer.exact_vector)
            if answer.drawn_vector is not None and answer.exact_vector is not None
            else abs(answer.deviation)
        )
        assert off <= max(1.5 * answer.expected_error, 3e-4), key


def test_of_several_assemblies_drawing_and_oracle_take_the_one_nearest_to_the_guesses() -> None:
    text = CLASS_III.replace("find: [v_C, omega_3]", "method: centres\nfind: [centres, omega_3]")
    places = []
    own = "{C: [80 mm, 120 mm], E: [160 mm, 110 mm], F: [120 mm, 180 mm]}"
    for guesses in (own, "{C: [144 mm, 55 mm], E: [203 mm, 110 mm], F: [126 mm, 133 mm]}"):
        solution = loads(text.replace(own, guesses)).solve(by="exact")
        agrees(solution)
        places.append(solution.answers["P_23"].exact_vector)
    assert places[0] == pytest.approx(0.08327 + 0.14841j, abs=1e-3) and places[1] == pytest.approx(
        0.14443 + 0.055004j, abs=1e-4
    )


def test_a_class_iii_group_without_guesses_is_refused_with_the_letters_to_guess() -> None:
    with pytest.raises(AssemblyError, match="guesses"):
        at("class-iii", 90, guesses="null")


def test_the_class_of_the_mechanism_is_that_of_its_highest_group() -> None:
    assert "属 Ⅲ 级机构" in structure(C3).zh and "a class III mechanism" in structure(C3).en
    assert "属 Ⅱ 级机构" in structure(load("3-2")).zh and "gear" not in structure(load("3-1f")).zh


def test_wherever_its_drive_is_put_a_class_iii_group_is_assembled_as_on_the_way_there() -> None:
    for there in posed(C3, np.radians([30.0, 45.0, 75.0, 120.0, 150.0, 171.0])):
        assert there is not None
        way, own = oracle.solve(C3.mechanism, there.mechanism.drive.position), oracle.solve(there.mechanism)
        for letter in "CEFGHL":
            assert abs(complex(own.position(At(letter))) - complex(way.position(At(letter)))) < 1e-9


def test_positions_solved_together_or_one_by_one_are_the_same_and_hang_together() -> None:
    mech, q = C3.mechanism, np.radians(np.linspace(29.5, 171.5, 72))
    together = oracle.solve(mech, q).position(At("L"))
    alone = [complex(oracle.solve(mech, here).position(At("L"))) for here in q]
    assert np.abs(together - alone).max() < 1e-12
    steps = np.abs(np.diff(oracle.solve(mech, np.radians(np.linspace(30.0, 171.0, 1411))).position(At("L"))))
    assert steps.max() < 0.01 * mech.scale


def test_an_iteration_ends_where_it_arrives_and_where_it_gets_no_nearer() -> None:
    watch, every = Watch(2, 1.0), np.arange(2)
    for tried in range(PATIENCE + 1):
        more = watch.goes_on(every, np.array([10.0 ** -(2**tried), 0.5]), np.array([10.0 ** -(2**tried), 0.5]))
        assert more.tolist() == [tried < 4, tried < PATIENCE]
    assert watch.lost.tolist() == [False, True]


# -- crowded figures --------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(("name", "phi"), few([("class-iii", 90), ("class-iii", 60), ("A-30", 150)], 3))
def test_of_many_centres_lines_only_the_pieces_are_drawn_where_they_cut(name: str, phi: float) -> None:
    built = at(name, phi).construction
    figure = next(f for f in built.figures if f.title.en == "Instant centres")
    trials = {step.number for step in built.steps if "Try any point" in step.words.en}
    pieces = [m for m in figure.marks if isinstance(m, Segment) and m.role is Role.DIRECTION and m.step not in trials]
    assert pieces and all(abs(m.b - m.a) == pytest.approx(2 * BEYOND) for m in pieces)
    assert faults(drawing(figure)) == []


def test_of_few_centres_every_line_is_drawn_whole() -> None:
    figure = next(f for f in load("3-1d").solve().construction.figures if f.title.en == "Instant centres")
    assert max(abs(m.b - m.a) for m in figure.marks if isinstance(m, Segment) and m.role is Role.DIRECTION) > 4 * BEYOND


# -- dead positions ---------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("name", ["3-1a", "3-7d", "3-12", "ex10", "D-3", "D-3-knife", "3-1c"])
@pytest.mark.parametrize("phi", few([0, 90, 180, 270], 2))
def test_links_at_rest_relative_to_each_other_keep_their_centre(name: str, phi: int) -> None:
    agrees(at(name, phi))


def test_the_centre_of_links_at_rest_relative_to_each_other_is_where_it_comes_from() -> None:
    """Slider at its dead point: rod and crank in line;
    centres a moment before and after lie on both sides, one millionth away."""
    here, soon = (at("D-2", phi, "centres").problem.mechanism for phi in (0.0, 0.001))
    for pair in link_pairs(here):
        now, then = Centres(here).place(*pair), Centres(soon).place(*pair)
        if isinstance(now, complex) and isinstance(then, complex) and FRAME not in pair:
            assert abs(now - then) < 1e-4 * here.scale


# -- off the paper ----------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("phi", few([270, 271, 89], 3))
def test_a_centre_just_beyond_the_edge_is_not_measured_from_beyond_it(phi: int) -> None:
    solution = at("A-30", phi, "P_79, P_17, P_26")
    for answer in solution.answers.values():
        assert answer.drawn_vector is not None and answer.exact_vector is not None
        assert abs(answer.drawn_vector - answer.exact_vector) < 1e-6


def test_coordinates_that_vanish_are_told_as_zero() -> None:
    place = Centres(load("3-1e").mechanism).place("2", "3")
    assert isinstance(place, complex) and place.real == 0.0
    assert np.isfinite(place.imag)


def test_links_that_translate_and_have_a_common_centre_in_reach_have_one_velocity() -> None:
    solution = loads(ALL_BUT_ALIKE).solve(by="exact")
    said = " ".join(step.words.en for step in solution.construction.steps)
    assert "both translate and have one velocity" in said
    assert not solution.suspect
    assert all(abs(one.deviation) < 1e-9 for one in solution.answers.values())
