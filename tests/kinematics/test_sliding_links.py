"""Links that slide on links that turn: coincident points are no pins,
guides keep their direction, rods may pass beside their pins."""

from __future__ import annotations

import re

import pytest

from tests.at_once import exactly
from tests.generators.family import families, member
from vecpoly import loads
from vecpoly.board.acts import Locate
from vecpoly.errors import AssemblyError, ProblemFileError
from vecpoly.solution import Solution, solve

OLDHAM = """
frame: {A: [0 mm, 0 mm], D: [60 mm, 0 mm]}
links: {1: {slot: A}, 2: {block: K, E: {KE: 30 mm, angle: 50 deg from line}}, 3: {slot: D}}
joints: [2 slides in 1, 2 slides in 3 turned 90 deg]
input: {link: 1, phi: 40 deg, omega: 10 rad/s ccw}
"""
CROSSED = """
frame: {A: [0 mm, 0 mm], D: [120 mm, 20 mm]}
links: {1: {AB: 100 mm}, 2: {block: D}, 3: {slot: E}}
joints: [2 slides in 3, 3 slides on AB turned 90 deg]
input: {link: 1, phi: 60 deg, omega: 10 rad/s ccw}
"""
OFFSET_ROD = """
frame: {A: [0 mm, 0 mm], C: [100 mm, 0 mm]}
links: {1: {AB: 30 mm}, 2: {rod: B}, 3: {block: C, G: {CG: 10 mm, angle: 60 deg from line}}}
joints: [2 passes through 3 with B 20 mm left]
input: {link: 1, phi: 90 deg, omega: 10 rad/s ccw}
"""


def vectors(text: str, *find: str) -> dict[str, complex]:
    """The vectors drawn by the exact hand."""
    return {
        key: answer.drawn_vector
        for key, answer in solved(text, *find).answers.items()
        if answer.drawn_vector is not None
    }


def solved(text: str, *find: str) -> Solution:
    """The problem drawn by the exact hand; drawing and oracle agree."""
    solution = solve(
        loads(f"id: test\ntitle: test\n{text}find: [{', '.join(find)}]\n"), by="exact", repeats=0, precise=False
    )
    for key, answer in solution.answers.items():
        drawn, exact = (
            (answer.drawn_vector, answer.exact_vector)
            if answer.exact_vector is not None
            else (answer.drawn, answer.exact)
        )
        assert drawn == pytest.approx(exact, rel=1e-9, abs=1e-12), key
    return solution


def test_the_cross_of_an_oldham_coupling_runs_round_its_circle_at_twice_the_speed() -> None:
    found = solved(OLDHAM, "v_K", "a_K", "v_E", "a_E", "omega_3").answers
    assert found["v_K"].drawn == pytest.approx(0.6) and found["a_K"].drawn == pytest.approx(
        12.0
    )  # a circle of 60 mm, at 20 rad/s
    assert found["omega_3"].drawn == pytest.approx(10.0)


def test_a_bar_that_slides_across_a_turning_bar_keeps_to_its_block() -> None:
    found = solved(CROSSED, "v_E", "a_E").answers
    assert found["v_E"].drawn == pytest.approx(1.2166, rel=1e-4) and found["a_E"].drawn == pytest.approx(
        24.331, rel=1e-4
    )


def test_relative_motion_of_a_sliding_pair_is_the_same_at_every_point_and_turns_round() -> None:
    found = vectors(
        OLDHAM, "v_K2K1", "v_K1K2", "v_D2D1", "ak_K2K1", "ak_D2D1", "ak_D1D2", "ar_K2K1", "ar_K1K2", "a_K2K1"
    )
    assert found["v_K2K1"] == pytest.approx(found["v_D2D1"])
    assert found["v_K1K2"] == pytest.approx(-found["v_K2K1"])
    assert found["ak_D1D2"] == pytest.approx(-found["ak_K2K1"])
    assert found["ak_K2K1"] + found["ar_K2K1"] == pytest.approx(found["a_K2K1"])


@pytest.mark.parametrize(
    ("angle", "place"), [(0, (109.951, -0.985)), (60, (105.829, 8.125)), (170, (90.371, 2.699)), (180, (90.049, 0.985))]
)
def test_a_point_of_a_block_is_set_out_from_the_direction_of_its_rod(angle: int, place: tuple[float, float]) -> None:
    found = solved(OFFSET_ROD.replace("60 deg", f"{angle} deg"), "p_G").answers["p_G"]
    assert found.drawn_vector == pytest.approx(complex(*place) * 1e-3, abs=1e-6)


@pytest.mark.parametrize(
    "other",
    [
        OFFSET_ROD.replace("passes through", "slides on"),
        OFFSET_ROD.replace(" with B 20 mm left", "").replace("rod: B", "rod: {through: B, right: 20 mm}"),
        OFFSET_ROD.replace("with B 20 mm left", "with C 20 mm right"),
    ],
)
def test_the_forms_of_an_offset_rod_say_the_same(other: str) -> None:
    keys = ("p_G", "omega_2", "alpha_2", "v_G", "a_G")
    first, second = (solved(text, *keys).answers for text in (OFFSET_ROD, other))
    assert [first[key].drawn for key in keys] == pytest.approx([second[key].drawn for key in keys])


def test_an_offset_said_twice_and_unlike_is_refused() -> None:
    with pytest.raises(ProblemFileError, match=r"20 mm.*15 mm"):
        solved(OFFSET_ROD.replace("rod: B", "rod: {through: B, right: 20 mm}").replace("B 20 mm", "B 15 mm"), "p_G")


def test_a_guide_that_could_point_either_way_asks_for_a_branch() -> None:
    text = OFFSET_ROD.replace("2: {rod: B}", "2: {BE: 140 mm}").replace(
        "2 passes through 3 with B 20 mm left", "3 slides on EB"
    )
    with pytest.raises(AssemblyError, match="either way"):
        solved(text, "omega_2")
    ways = [vectors(text + f"branch: [E {side} of BA]\n", "p_E", "omega_2")["p_E"] for side in ("left", "right")]
    assert abs(ways[0] - ways[1]) == pytest.approx(0.28)  # E ahead of B, and behind it
    for way in ways:
        rough = f"guesses: {{E: [{1e3 * way.real + 30:.0f} mm, {1e3 * way.imag - 30:.0f} mm]}}\n"
        assert solved(text + rough, "p_E", "omega_2").answers["p_E"].drawn_vector == pytest.approx(way)


def test_a_rough_place_does_not_turn_a_slot_whose_block_lies_ahead() -> None:
    slot = (
        "frame: {A: [0 mm, 0 mm], C: [100 mm, 0 mm]}\nlinks: {1: {AB: 30 mm}, 2: {block: B}, 3: {slot: C, E: "
        "{along: C, at: 150 mm}}}\njoints: [2 slides in 3]\ninput: {link: 1, phi: 60 deg, omega: ccw}\n"
    )
    plain, behind = (solved(slot + more, "p_E").answers["p_E"] for more in ("", "guesses: {E: [240 mm, -40 mm]}\n"))
    assert behind.drawn_vector == plain.drawn_vector and behind.exact_vector == pytest.approx(behind.drawn_vector)


WITH_K = """
frame: {A: [0 mm, 0 mm], C: [120 mm, 0 mm]}
links: {1: {AB: 40 mm}, 2: {block: B}, 3: {slot: C, K: {CK: 60 mm, angle: 20 deg from line}}}
joints: [2 slides in 3]
input: {link: 1, phi: 50 deg, omega: 10 rad/s ccw}
"""


@pytest.mark.parametrize(("text", "tips"), [(WITH_K, 2), (OLDHAM, 3), (OLDHAM.replace("K", "I"), 2)])
def test_the_tip_of_a_coriolis_acceleration_has_a_letter_of_its_own(text: str, tips: int) -> None:
    asked = "a_K" if "K" in text else "a_E"
    points = [act for act in solved(text, asked).construction.acts if isinstance(act, Locate) and act.key[:1] == "k"]
    places = {act.names[0]: {one.at for one in points if one.names[0] == act.names[0]} for act in points}
    assert all(len(at) == 1 for at in places.values())
    assert sum(name.startswith("acceleration:") for name in places) == tips


@pytest.mark.parametrize(("kind", "number", "pair"), [("linkage-rpp", 5, "P8P5"), ("linkage-prp", 13, "P9P1")])
def test_a_coriolis_term_is_not_nothing_because_its_relative_velocity_was_read_first(
    kind: str, number: int, pair: str
) -> None:
    """Members of the soak, of which one link slides on two others: v of the pair stands since it was asked."""
    text = member(next(one for one in families() if one.name == kind), 613, number)
    asked = re.sub("find: .*", f"find: [v_{pair}, ak_{pair}, ar_{pair}]", text)
    answers = exactly(loads(asked)).answers
    assert abs(answers[f"ak_{pair}"].drawn_vector or 0j) > 1
    for answer in answers.values():
        assert answer.drawn_vector == pytest.approx(answer.exact_vector, rel=1e-9)
