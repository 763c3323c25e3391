"""Well-known machines as structural problems: counted as in the textbook,
the same by rank, redundant parts named with their reason."""

from __future__ import annotations

import cmath
import math

import pytest

import vecpoly
from tests.laws import few
from vecpoly import Problem, loads
from vecpoly.check.structure import dependence
from vecpoly.devices.structure import Structure
from vecpoly.errors import ProblemFileError
from vecpoly.methods.devices.structure.count import count
from vecpoly.report.content import cautions
from vecpoly.solution import Solution

Joints = dict[str, str]


def at(z: complex) -> str:
    return f"({z.real:.4f}, {z.imag:.4f})"


def planets(driver: str) -> tuple[Joints, str]:
    """Sun 1, three planets 2, 3, 4 on carrier H, fixed ring."""
    joints = {"A": "R(0, 1, H) at (0, 0)"}
    for k, link in enumerate("234"):
        way = cmath.rect(1.0, math.radians(90 + 120 * k))
        pin, sun, ring = "BCD"[k], "KLM"[k], "XYZ"[k]
        joints |= {
            pin: f"R(H, {link}) at {at(35 * way)}",
            sun: f"G(1 about A, {link} about {pin}) at {at(20 * way)}",
            ring: f"G({link} about {pin}, 0 about A) at {at(50 * way)}",
        }
    return joints, driver


CRANK, SWUNG = cmath.rect(30, math.radians(65)), cmath.rect(30, math.radians(155))
SHAPER = {
    "A": "R(0, 1) at (0, 0)",
    "B": "R(1, 2) at (40, 20)",
    "B'": "P(2, 3) at (40, 20) along (52, 150)",
    "C": "R(3, 0) at (-12, -130)",
    "D": "R(3, 4) at (55.5, 64.7)",
    "E": "R(4, 5) at (-20, 80)",
    "E'": "P(5, 0) at (-20, 80) along (1, 0)",
}
STEPHENSON = {
    "A": "R(0, 1) at (0, 0)",
    "B": "R(1, 2) at (20, 40)",
    "C": "R(2, 3) at (110, 70)",
    "D": "R(3, 4) at (60, 150)",
    "E": "R(4, 0) at (0, 160)",
    "F": "R(3, 5) at (160, 130)",
    "G": "R(5, 0) at (200, 20)",
}
TRAMMEL = {
    "A": "R(1, 2) at (60, 0)",
    "A'": "P(1, 0) at (60, 0) along (1, 0)",
    "B": "R(2, 3) at (0, 80)",
    "B'": "P(3, 0) at (0, 80) along (0, 1)",
    "C": "R(2, 4) at (30, 40)",
    "O": "R(4, 0) at (0, 0)",
}
PRESS = {
    "A": "R(0, 1) at (-40, 0)",
    "B": "R(0, 2) at (40, 0)",
    "M": "G(1 about A, 2 about B) at (0, 0)",
    "C": "R(1, 3) at (-60, 20)",
    "D": "R(2, 4) at (60, 20)",
    "E": "R(3, 5) at (-20, -100)",
    "F": "R(4, 5) at (20, -100)",
    "G": "P(5, 0) at (0, -100) along (0, 1)",
}
SLIDER = {
    "A": "R(0, 1) at (0, 0)",
    "B": "R(1, 2) at (20, 30)",
    "C": "R(2, 3) at (120, 0)",
    "D": "P(3, 0) at (120, 0) along (1, 0)",
}
PARALLEL = {
    "A": "R(0, 1) at (0, 0)",
    "B": f"R(1, 2) at {at(CRANK)}",
    "C": f"R(2, 3) at {at(CRANK + 120)}",
    "D": "R(3, 0) at (120, 0)",
}

# name: joints, driver, (n, p_L, p_H, F', p', F), groups, class, words of the reason
MACHINES: dict[str, tuple[Joints, str, tuple[int, int, int, int, int, int], int, int, str]] = {
    "jaw crusher": (
        {
            "A": "R(0, 1) at (0, 0)",
            "B": "R(1, 2) at (15, 12)",
            "C": "R(2, 3, 4) at (-10, -110)",
            "D": "R(3, 0) at (80, -130)",
            "E": "R(4, 5) at (-100, -120)",
            "F": "R(5, 0) at (-120, 40)",
        },
        "1",
        (5, 7, 0, 0, 0, 1),
        2,
        2,
        "",
    ),
    "shaper": (SHAPER, "1", (5, 7, 0, 0, 0, 1), 2, 2, ""),
    "shaper driven by its ram": (SHAPER, "5", (5, 7, 0, 0, 0, 1), 2, 2, ""),
    "Stephenson III": (STEPHENSON, "1", (5, 7, 0, 0, 0, 1), 1, 3, ""),
    "Stephenson III, other driver": (STEPHENSON, "4", (5, 7, 0, 0, 0, 1), 2, 2, ""),
    "Oldham": (
        {
            "A": "R(0, 1) at (0, 0)",
            "B": "P(2, 1) at (30, 10) along 20 deg",
            "C": "P(2, 3) at (30, 10) along 110 deg",
            "D": "R(3, 0) at (40, 0)",
        },
        "1",
        (3, 4, 0, 0, 0, 1),
        1,
        2,
        "",
    ),
    "geared five-bar": (
        {
            "A": "R(0, 1) at (0, 0)",
            "B": "R(1, 2) at (-20, 50)",
            "C": "R(2, 3) at (60, 110)",
            "D": "R(3, 4) at (140, 50)",
            "E": "R(4, 0) at (120, 0)",
            "M": "G(1 about A, 4 about E) at (60, 0)",
        },
        "1",
        (4, 5, 1, 0, 0, 1),
        2,
        2,
        "",
    ),
    "parallel cranks with a third": (
        PARALLEL | {"E": f"R(2, 4) at {at(CRANK + 60 + 20j)}", "F": "R(4, 0) at (60, 20)"},
        "1",
        (4, 6, 0, 0, 1, 1),
        1,
        2,
        "∥",
    ),
    "parallel cranks with a second coupler": (
        PARALLEL | {"E": f"R(1, 4) at {at(SWUNG)}", "F": f"R(4, 3) at {at(SWUNG + 120)}"},
        "1",
        (4, 6, 0, 0, 1, 1),
        1,
        2,
        "always keep",
    ),
    "trammel driven by a block": (TRAMMEL, "1", (4, 6, 0, 0, 1, 1), 1, 2, "even without link 4"),
    "trammel driven by its crank": (TRAMMEL, "4", (4, 6, 0, 0, 1, 1), 1, 2, "even without block 3"),
    "trammel with guides at 100°": (
        {
            "O": "R(0, 1) at (0, 0)",
            "C": "R(1, 2) at (30, 40)",
            "X": f"R(2, 3) at {at(x := 30 + 40j + cmath.rect(50, math.radians(200)))}",
            "X'": f"P(3, 0) at {at(x)} along {at(x)}",
            "Y": f"R(2, 4) at {at(y := 30 + 40j + cmath.rect(50, math.radians(80)))}",
            "Y'": f"P(4, 0) at {at(y)} along {at(y)}",
        },
        "1",
        (4, 6, 0, 0, 1, 1),
        1,
        2,
        "even without block 4",
    ),
    "press of two mirrored trains": (PRESS, "1", (5, 7, 1, 0, 1, 1), 2, 2, "mirror image"),
    "three planets, sun driving": (*planets("1"), (5, 5, 6, 0, 2, 1), 1, 3, "share the load"),
    "three planets, carrier driving": (*planets("H"), (5, 5, 6, 0, 2, 1), 2, 2, "share the load"),
    "two rods side by side": (
        SLIDER | {"B'": "R(1, 4) at (20, 30)", "C'": "R(4, 3) at (120, 0)"},
        "1",
        (4, 6, 0, 0, 1, 1),
        1,
        2,
        "beside link 2",
    ),
    "two rods on common pins": (
        SLIDER | {"B": "R(1, 2, 4) at (20, 30)", "C": "R(2, 3, 4) at (120, 0)"},
        "1",
        (4, 6, 0, 0, 1, 1),
        1,
        2,
        "beside link 2",
    ),
    "a bar between two points of the frame": (
        SLIDER | {"A": "R(0, 1, 5) at (0, 0)", "E": "R(5, 0) at (60, -40)"},
        "1",
        (4, 6, 0, 0, 1, 1),
        1,
        2,
        "points of the frame",
    ),
    "a bar between two points of a rod": (
        SLIDER | {"E": "R(2, 4) at (40, 50)", "F": "R(2, 4) at (90, 40)"},
        "1",
        (4, 6, 0, 0, 1, 1),
        1,
        2,
        "points of link 2",
    ),
    "shaft in three bearings, long slide": (
        SLIDER | {"A'": "R(0, 1) at (0, 0)", "A2": "R(0, 1) at (0, 0)", "D'": "P(3, 0) at (170, 0) along (1, 0)"},
        "1",
        (3, 7, 0, 0, 6, 1),
        1,
        2,
        "only one of them constrains",
    ),
    "cam of constant breadth": (
        {
            "A": "R(0, 1) at (0, 0)",
            "K": "H(1 about (8, 6), 2 flat) at (8, 46)",
            "L": "H(1 about (8, 6), 2 flat) at (8, -34)",
            "D": "P(2, 0) at (0, 90) along (0, 1)",
        },
        "1",
        (2, 2, 2, 0, 1, 1),
        1,
        2,
        "common normal",
    ),
    "crank and two wedges": (
        {
            "C": "P(2, 0) at (60, 60) along (0, 1)",
            "O": "R(0, 3) at (-150, 0)",
            "E": "R(3, 4) at (-130, 25)",
            "G": "R(4, 1) at (-40, 0)",
            "A": "P(1, 0) at (0, 0) along (1, 0)",
            "B": "P(1, 2) at (30, 20) along 30 deg",
        },
        "3",
        (4, 6, 0, 0, 1, 1),
        2,
        2,
        "a loop of prismatic joints alone",
    ),
    "truss": (
        {"A": "R(0, 1) at (0, 0)", "B": "R(1, 2) at (50, 80)", "C": "R(2, 0) at (110, 0)"},
        "1",
        (2, 3, 0, 0, 0, 0),
        0,
        0,
        "",
    ),
    "truss with a bar too many": (
        {
            "A": "R(0, 1) at (0, 0)",
            "B": "R(1, 2, 3) at (50, 80)",
            "C": "R(2, 0) at (110, 0)",
            "D": "R(3, 0) at (160, 10)",
        },
        "1",
        (3, 5, 0, 0, 0, -1),
        0,
        0,
        "",
    ),
    "multiple joint of four": (
        {
            "A": "R(0, 1) at (0, 0)",
            "B": "R(1, 2) at (20, 40)",
            "C": "R(2, 3, 4, 5) at (110, 70)",
            "D": "R(3, 0) at (130, 0)",
            "E": "R(4, 6) at (200, 120)",
            "F": "R(6, 0) at (230, 20)",
            "G": "R(5, 7) at (100, 170)",
            "H": "P(7, 0) at (100, 170) along (0, 1)",
        },
        "1",
        (7, 10, 0, 0, 0, 1),
        3,
        2,
        "",
    ),
}


def problem(joints: Joints, driver: str) -> Problem:
    lines = "\n".join(f"    {letter}: {written}" for letter, written in joints.items())
    return loads(f"id: x\ntitle: x\ndevice: structure\ndata:\n  joints:\n{lines}\n  drivers: [{driver}]\n")


def told(solution: Solution, lang: str) -> str:
    return " ".join(getattr(step.words, lang) for step in solution.construction.steps)


@pytest.mark.parametrize("name", few(list(MACHINES), 2))
def test_a_machine_is_counted_as_in_the_textbook_and_the_rank_agrees_in_every_answer(name: str) -> None:
    joints, driver, counts, groups, rank, why = MACHINES[name]
    solution = problem(joints, driver).solve()
    answers = solution.answers
    assert tuple(answers[key].drawn for key in ("n", "p_l", "p_h", "F_local", "p_redundant", "F")) == counts
    assert (answers[f"groups_{driver}"].drawn, answers[f"class_{driver}"].drawn) == (groups, rank)
    assert {key: answer.exact for key, answer in answers.items()} == {
        key: answer.drawn for key, answer in answers.items()
    }
    assert why in told(solution, "en")


@pytest.mark.parametrize(
    ("name", "letter", "moved"),
    [
        ("trammel driven by its crank", "B", "R(2, 3) at (0, 84)"),
        ("two rods side by side", "C'", "R(4, 3) at (124, 0)"),
        ("parallel cranks with a second coupler", "F", f"R(4, 3) at {at(SWUNG + 123)}"),
        ("press of two mirrored trains", "D", "R(2, 4) at (66, 20)"),
    ],
)
def test_sizes_that_are_not_exact_lock_the_machine(name: str, letter: str, moved: str) -> None:
    joints, driver, *_ = MACHINES[name]
    answers = problem(joints | {letter: moved}, driver).solve().answers
    assert answers["p_redundant"].drawn == 0 and answers["F"].drawn == 0 == answers["F"].exact


SCISSOR = {
    "A": "R(0, 1) at (0, 0)",
    "B": f"R(1, 2) at {at(q := cmath.rect(50, 0.6))}",
    "C": f"R(2, 3) at {at(complex(2 * q.real))}",
    "C'": f"P(3, 0) at {at(complex(2 * q.real))} along (1, 0)",
    "D": f"R(2, 4) at {at(complex(0, 2 * q.imag))}",
    "E": f"R(1, 5) at {at(2 * q)}",
    "E'": f"P(5, 4) at {at(2 * q)} along (1, 0)",
    "G": f"P(4, 0) at {at(complex(0, 2 * q.imag + 30))} along (0, 1)",
}


def test_a_redundancy_that_counting_does_not_know_is_named_by_its_joints() -> None:
    solution = problem(SCISSOR, "3").solve()
    device = solution.problem.subject
    assert (
        isinstance(device, Structure) and count(device.chain, ("3",)).freedom == -1 and solution.answers["F"].exact == 1
    )
    words = dependence(device)
    assert (
        words is not None
        and "2 constraints are redundant" in words.en
        and "$G$" in words.en
        and "2 个虚约束" in words.zh
    )
    assert words.en in cautions(solution, "en")
    plain = problem({letter: written for letter, written in SCISSOR.items() if letter != "G"}, "3").solve()
    assert isinstance(plain.problem.subject, Structure) and dependence(plain.problem.subject) is None
    assert plain.answers["F"].drawn == 1 == plain.answers["F"].exact


def test_joints_that_have_no_part_in_a_dependence_are_not_named() -> None:
    joints = MACHINES["two rods side by side"][0] | {
        "E": "R(2, 6) at (60, 40)",
        "F": "R(6, 7) at (80, 120)",
        "G": "R(7, 0) at (150, 90)",
    }
    device = problem(joints, "1").subject
    assert isinstance(device, Structure)
    words = dependence(device)
    assert (
        words is not None
        and all(f"${letter}$" in words.en for letter in ("B", "C"))
        and not any(f"${letter}$" in words.en for letter in ("E", "F", "G", "A"))
    )


def test_a_link_that_hangs_on_nothing_is_refused_by_name() -> None:
    with pytest.raises(ProblemFileError, match=r"line 5.*data.joints: links 2, 3 hang on nothing"):
        problem({"A": "R(0, 1) at (0, 0)", "B": "R(2, 3) at (30, 40)"}, "1")


def test_a_part_without_links_is_not_counted_in_links() -> None:
    told_zh = told(vecpoly.solve(problem(*MACHINES["shaft in three bearings, long slide"][:2])), "zh")
    assert "0 个构件" not in told_zh and "−1 个高副" not in told(
        problem(*MACHINES["crank and two wedges"][:2]).solve(), "zh"
    )
