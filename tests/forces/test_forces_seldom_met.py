"""Loads that few problems have: parallel to the force that a block or a contact passes on, a force that balances on a
crank, couples, forces on the crank itself."""

from __future__ import annotations

import cmath
from math import degrees, radians

import pytest

from tests.at_once import exactly
from tests.laws import few
from vecpoly.errors import VecpolyError
from vecpoly.problem.load import loads
from vecpoly.solution import Solution

ROCKER = """
id: r
title: r
frame: {A: [0 mm, 0 mm], D: [0 mm, -200 mm]}
links: {1: {AB: 50 mm}, 2: {block: B}, 3: {slot: D, G: {along: D, at: 260 mm}}}
joints: [2 slides in 3]
input: {link: 1, phi: 90 deg, omega: ccw}
loads: {F: {on: 3, at: G, size: 300 N, direction: 180 deg}, %(sought)s}
%(more)s
find: [%(find)s]
"""
FLAT = """
id: f
title: f
frame: {A: [0 mm, 0 mm]}
links: {1: {AO: 15 mm, disc: O, radius: 40 mm}, 2: {block: F, face: {through: F, angle: -90 deg from line}}}
joints: [1 touches 2 at K %(side)s of the face, 2 slides on x = 0 mm]
input: {link: 1, phi: 30 deg, omega: ccw}
loads: {Q: {on: 2, at: F, size: 200 N, direction: -90 deg}, M_1: {on: 1, size: "?"}}
find: [R_12, R_32, M_1]
"""
FOUR_BAR = """
id: b
title: b
frame: {A: [0 mm, 0 mm], D: [220 mm, 10 mm]}
links: {1: {AB: 60 mm, S: {along: AB, at: 30 mm, left: 20 mm}}, 2: {BC: 210 mm}, 3: {CD: 170 mm}}
branch: [C left of BD]
input: {link: 1, phi: 70 deg, omega: %(sense)s}
loads: {%(loads)s}
%(more)s
find: [%(find)s]
"""
RUBBING = "friction: {A: {rho: 3 mm}, B: {rho: 3 mm}, C: {rho: 3 mm}, D: {rho: 3 mm}}"


def solved(text: str, **given: str) -> Solution:
    """The problem by the exact hand."""
    return exactly(loads(text % given))


def agree(solution: Solution) -> None:
    """Every answer as drawn is that of the oracle."""
    size = max(abs(answer.exact) for answer in solution.answers.values() if answer.key.startswith("R"))
    assert len(solution.answers) >= 2
    for answer in solution.answers.values():
        one, two = (
            (answer.drawn_vector, answer.exact_vector)
            if answer.drawn_vector is not None
            else (answer.drawn, answer.exact)
        )
        assert one is not None and two is not None and abs(one - two) <= 1e-9 * max(size, abs(two)), answer.key


def stand_alike(solution: Solution) -> None:
    """Every reaction as drawn acts on the line on which the oracle has it, on the same side of its pin."""
    seen = 0
    for answer in solution.answers.values():
        one, two, force = answer.reading.acts, answer.exact_acts, answer.exact_vector
        if one is not None and two is not None and force is not None and abs(force) > 1e-6:
            assert abs(((two.point - one.point) * force.conjugate()).imag) < 1e-9 * abs(force), answer.key
            assert one.tangent == two.tangent, answer.key
            seen += 1
    assert seen >= 2


def told(solution: Solution) -> str:
    return " ".join(step.words.en for step in solution.construction.steps)


@pytest.mark.parametrize("more", ["", "friction: {D: {rho: 4 mm}}"])
@pytest.mark.parametrize(("phi", "sense"), [(90.0, "ccw"), (90.0, "cw"), (60.0, "ccw"), (200.0, "cw")])
def test_a_load_parallel_to_the_force_of_a_block_is_balanced_by_moments_about_the_pin(
    more: str, phi: float, sense: str
) -> None:
    rocker = degrees(cmath.phase(cmath.rect(50, radians(phi)) + 200j))
    text = ROCKER.replace("phi: 90 deg, omega: ccw", f"phi: {phi} deg, omega: {sense}").replace(
        "direction: 180 deg", f"direction: {rocker + 90:.12f} deg"
    )
    solution = solved(text, sought='M_1: {on: 1, size: "?"}', more=more, find="R_23, R_43, R_12, M_1")
    agree(solution)
    stand_alike(solution)
    about = "the point where $R_{43}$ touches the friction circle of $D$" if more else "$D$"
    steps = [one.words.en for one in solution.construction.steps if "The two lines" in one.words.en]
    assert len(steps) == (2 if more else 1) and all(text.startswith("Isolate link 3: ") for text in steps)
    assert "The two lines are parallel: so is the third." in steps[-1]
    assert steps[-1].endswith(f"Moments are taken about {about}, with the arms measured:")


def test_a_load_parallel_to_the_force_of_a_contact_leaves_a_couple_to_the_guide() -> None:
    solution = solved(FLAT, side="right")
    agree(solution)
    assert "the guide bears their couple" in told(solution)
    assert solution.answers["R_32"].drawn == pytest.approx(0.0, abs=1e-9) and solution.answers[
        "R_12"
    ].drawn == pytest.approx(200.0)


def test_a_contact_that_would_have_to_pull_is_refused() -> None:
    with pytest.raises(VecpolyError, match="a contact only presses"):
        solved(FLAT, side="left")


@pytest.mark.parametrize("way", few(["20 deg", "150 deg", "200 deg"], 2))
@pytest.mark.parametrize("more", ["", RUBBING])
def test_a_force_on_the_crank_balances_through_one_point(way: str, more: str) -> None:
    solution = solved(
        FOUR_BAR,
        sense="ccw",
        more=more,
        find="P, R_21, R_41, R_43",
        loads=f'M_3: {{on: 3, size: 20 N*m cw}}, P: {{on: 1, at: S, size: "?", direction: {way}}}',
    )
    agree(solution)
    stand_alike(solution)
    assert "three forces in equilibrium are concurrent, so the frame's reaction $R_{41" in told(solution)


@pytest.mark.parametrize("more", ["", RUBBING])
def test_forces_on_the_crank_itself_join_those_that_reach_it(more: str) -> None:
    solution = solved(
        FOUR_BAR,
        sense="ccw",
        more=more,
        find="R_21, R_41, M_1",
        loads="M_3: {on: 3, size: 20 N*m cw}, F: {on: 1, at: S, size: 150 N, direction: 200 deg}, M_1: {on: 1, size: "
        '"?"}',
    )
    agree(solution)
    stand_alike(solution)
    assert "measure its closing side, $R_{41" in told(solution) and "the resultant of the known forces" in told(
        solution
    )


@pytest.mark.parametrize("sense", ["ccw", "cw"])
@pytest.mark.parametrize("more", ["", RUBBING])
def test_a_couple_on_the_rocker_is_borne_by_two_parallel_reactions(sense: str, more: str) -> None:
    way = {"ccw": "cw", "cw": "ccw"}[sense]
    solution = solved(
        FOUR_BAR,
        sense=sense,
        more=more,
        find="R_23, R_43, R_21, R_41, M_1",
        loads=f'M_3: {{on: 3, size: 20 N*m {way}}}, M_1: {{on: 1, size: "?"}}',
    )
    agree(solution)
    stand_alike(solution)
    assert "Link 3 carries only a couple" in told(solution)
    one, two = solution.answers["R_23"].drawn_vector, solution.answers["R_43"].drawn_vector
    assert one is not None and two is not None and abs(one + two) < 1e-9 * abs(one)


def test_only_couples_on_the_crank_are_balanced_by_a_couple_and_the_frame_bears_nothing() -> None:
    solution = solved(
        FOUR_BAR, sense="ccw", more="", find="R_41, M_1", loads='M_2: {on: 1, size: 7 N*m cw}, M_1: {on: 1, size: "?"}'
    )
    assert solution.answers["M_1"].drawn == pytest.approx(7.0) and solution.answers["M_1"].exact == pytest.approx(7.0)
    assert solution.answers["R_41"].drawn == 0.0 and "Only couples act on link 1" in told(solution)


SLIDE = """
id: s
title: s
frame: {A: [0 mm, 0 mm]}
links: {1: {AB: 50 mm}, 2: {BC: 180 mm}, 3: {block: C, G: {CG: 40 mm, angle: 30 deg from line}}}
joints: [3 slides on y = 10 mm]
branch: [C right of B]
input: {link: 1, phi: 50 deg, omega: ccw}
loads: {M_1: {on: 1, size: 30 N*m ccw}, %(more)s P: {on: 3, at: %(at)s, size: "?", direction: %(way)s deg}}
%(friction)s
find: [P, R_23, R_43, R_21]
"""


@pytest.mark.parametrize(
    "friction", ["", "friction: {A: {rho: 2 mm}, B: {rho: 2 mm}, C: {rho: 2 mm}, 3-4: {phi: 5 deg}}"]
)
@pytest.mark.parametrize(("at", "way"), few([("C", "180"), ("C", "160"), ("G", "180"), ("G", "200")], 3))
@pytest.mark.parametrize("more", ["", "Q: {on: 3, at: G, size: 90 N, direction: -100 deg},"])
def test_a_force_on_a_slide_balances_and_the_guide_s_reaction_passes_where_the_lines_meet(
    at: str, way: str, more: str, friction: str
) -> None:
    solution = solved(SLIDE, at=at, way=way, more=more, friction=friction)
    agree(solution)
    stand_alike(solution)
