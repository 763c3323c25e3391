"""What has no curvature is refused with its reason; what is asked wrongly, with what to write."""

from __future__ import annotations

import re

import pytest

import vecpoly
from vecpoly.check.truth import exact_values
from vecpoly.errors import NoMethodError, NotAskedError, ProblemFileError

FOUR_BAR = """
id: t
title: t
frame: {A: [0 mm, 0 mm], D: [70 mm, 0 mm]}
links:
  1: {AB: 35 mm}
  2: {BC: 51 mm, E: {along: BC, at: 20 mm, left: 25 mm}}
  3: {DC: 69 mm}
input: {link: 1, phi: 30 deg, omega: ccw}
branch: [C left of BD]
"""
PARALLELOGRAM = FOUR_BAR.replace("BC: 51", "BC: 70").replace("DC: 69", "DC: 35")
SLIDER = """
id: t
title: t
frame: {A: [0 mm, 0 mm]}
links: {1: {AB: 35 mm}, 2: {BC: 60 mm}, 3: {block: C}}
joints: [3 slides on y = 0 mm]
input: {link: 1, phi: 60 deg, omega: ccw}
branch: [C right of B]
method: curvature
"""


def curved(text: str, find: str, more: str = "") -> vecpoly.Problem:
    """A problem by curvatures."""
    return vecpoly.loads(f"{text}method: curvature\nfind: [{find}]\n{more}")


def test_a_link_that_does_not_turn_has_no_inflection_circle() -> None:
    problem = curved(PARALLELOGRAM, "W_2, delta_2")
    for ask in (problem.solve, lambda: exact_values(problem)):
        with pytest.raises(NotAskedError, match="infinity") as refused:
            ask()
        assert refused.value.code == "pole-at-infinity"


def test_a_point_on_the_inflection_circle_is_told_to_run_straight() -> None:
    problem = vecpoly.loads(SLIDER + "find: [delta_2, rho_C]")
    for ask in (problem.solve, lambda: exact_values(problem)):
        with pytest.raises(NotAskedError, match="ρ = ∞") as refused:
            ask()
        assert refused.value.code == "inflection" and "拐点圆" in refused.value.words.zh


def test_a_point_that_is_the_pole_has_a_cusp() -> None:
    pole = exact_values(curved(FOUR_BAR, "P_24"))["P_24"]
    assert isinstance(pole, complex)
    b = 0.035 * complex(3**0.5 / 2, 0.5)
    c = complex(47.908290397, 65.367854231) / 1e3
    local = (pole - b) * (c - b).conjugate() / abs(c - b) * 1e3
    there = f"at: {local.real!r} mm, left: {local.imag!r} mm"
    problem = curved(FOUR_BAR.replace("at: 20 mm, left: 25 mm", there), "W_2, rho_E")
    for ask in (problem.solve, lambda: exact_values(problem)):
        with pytest.raises(NotAskedError, match=r"cusp|ρ = ∞|off the sheet"):
            ask()


def test_a_point_that_paper_cannot_tell_from_the_pole_has_a_cusp() -> None:
    text = """
id: t
title: t
frame: {A: [0 mm, 0 mm], D: [100 mm, 0 mm]}
links: {1: {AB: 40 mm}, 2: {BC: 90 mm, E: {along: BC, at: 67.554 mm, right: 22.406 mm}}, 3: {DC: 70 mm}}
input: {link: 1, phi: 20 deg, omega: ccw}
branch: [C left of BD]
"""
    with pytest.raises(NotAskedError, match="cusp"):
        curved(text, "p_OE, rho_E", "construction: euler-savary\n").solve()


def test_a_link_on_the_frame_needs_no_drawing() -> None:
    with pytest.raises(NoMethodError, match="joined to the frame itself"):
        curved(FOUR_BAR, "W_3, delta_3").solve()


def test_a_link_of_which_only_one_path_is_known_is_refused() -> None:
    five = """
id: t
title: t
frame: {A: [0 mm, 0 mm], D: [70 mm, 0 mm], G: [120 mm, 10 mm]}
links: {1: {AB: 35 mm}, 2: {BC: 51 mm, E: {along: BC, at: 80 mm}}, 3: {DC: 69 mm}, 4: {EF: 60 mm}, 5: {GF: 70 mm}}
input: {link: 1, phi: 30 deg, omega: ccw}
branch: [C left of BD, F left of EG]
"""
    with pytest.raises(NoMethodError, match="here there is 1"):
        curved(five, "W_4").solve()


@pytest.mark.parametrize(
    ("find", "told"),
    [
        ("W_9", "no curvature"),
        ("rho_X", "no curvature"),
        ("P_24, W_3", "several links"),
        ("p_C", "no curvature is asked"),
        ("{centrodes: 7}", "link '7' does not exist"),
        ("{centrodes: 2, positions: 3}", "4 to 24"),
        ("{centrodes: 2, over: [20 deg, 20 deg]}", "the same"),
        ("{centrodes: 2}, {centrodes: 3}", "one link"),
        ("{centrodes: 2, point: M2}", "centrodes does not go together with point"),
        ("W_2, {point: M2, on: 2, velocity: 0, positions: 8}", "point does not go together with positions"),
        ("{centrodes: 2}, rho_D", "several links"),
    ],
)
def test_a_question_that_cannot_be_meant_is_told_at_its_place(find: str, told: str) -> None:
    with pytest.raises(ProblemFileError, match=told) as refused:
        curved(FOUR_BAR, find)
    assert any("find" in fault.path for fault in refused.value.faults)


def test_curvatures_are_not_asked_without_their_method() -> None:
    for find in ("rho_E", "W_2", "{centrodes: 2}"):
        with pytest.raises(ProblemFileError, match="write method: curvature"):
            vecpoly.loads(f"{FOUR_BAR}find: [{find}]")
    with pytest.raises(ProblemFileError, match="goes with method: curvature"):
        vecpoly.loads(f"{FOUR_BAR}find: [v_C]\nconstruction: hartmann")


def test_centrodes_that_run_off_the_sheet_ask_for_a_smaller_range() -> None:
    with pytest.raises(NotAskedError, match="narrow `over`"):
        curved(FOUR_BAR, "{centrodes: 2, over: [30 deg, 179 deg]}").solve()


def test_velocities_may_be_asked_beside_curvatures() -> None:
    text = FOUR_BAR.replace("omega: ccw", "omega: 10 rad/s ccw")
    answers = curved(text, "delta_2, v_C").solve(by="exact").answers
    assert answers["delta_2"].drawn == pytest.approx(0.069917463794, abs=1e-11)
    assert answers["v_C"].drawn == pytest.approx(answers["v_C"].exact, rel=1e-9)


def test_a_construction_whose_rod_is_pivoted_in_the_pole_is_refused_with_another_that_works() -> None:
    text = """
id: t
title: t
frame: {A: [112.257635 mm, 46.6130884 mm]}
links:
  1: {rod: A}
  2: {BC: 109.540754 mm}
  3: {AD: 81.4934239 mm}
joints: [2 slides in 1 with B 52.2519655 mm left turned -25.7372944 deg, 3 slides on BC of 2 turned 143.639509 deg]
input: {link: 1, phi: -3.09580893 deg, omega: 3 rad/s}
branch: []
method: curvature
"""
    with pytest.raises(NotAskedError, match="use construction: euler-savary"):
        vecpoly.loads(f"{text}construction: hartmann\nfind: [W_2]").solve()


def test_what_is_written_as_an_example_can_be_asked() -> None:
    with pytest.raises(ProblemFileError, match="no curvature is asked") as refused:
        curved(FOUR_BAR, "p_C")
    (find,) = re.findall(r"find: \[(.*)\]", refused.value.faults[0].words.en)
    assert curved(FOUR_BAR, find).solve().answers.keys() == set(find.split(", "))
