"""Claims about lines of action with friction: the tangent, the cone and the way of sliding that are told are those
drawn."""

from __future__ import annotations

import re
from functools import cache

import pytest

from tests.drawn_library import drawn
from vecpoly.board.construction import Step, View
from vecpoly.board.paper.marks import FrictionCircle, Point, Role, Segment
from vecpoly.problem.load import loads
from vecpoly.solution import solve

NAMES = ("4-3a", "4-3b", "compound-hinge-six-bar", "hand-lever")
NEAR = 1e-6  # mm
KINDS = {"inner": ("同向", "内公切线", "the same sense"), "outer": ("反向", "外公切线", "opposite senses")}


@cache
def told(name: str) -> list[tuple[Step, str, list[str]]]:
    """(step, which common tangent, the letters of its two pins)."""
    found = []
    for step in drawn(name).construction.steps:
        if (kind := re.search(r"the line is the (inner|outer) common tangent", step.words.en)) is not None:
            found.append((step, kind[1], re.findall(r"the moment of \$R_\{\d+\}\$ about \$(\w)\$", step.words.en)))
    return found


def side(line: Segment, at: complex) -> float:
    """How far (mm) a point lies to the left of a line."""
    return ((line.b - line.a).conjugate() * (at - line.a)).imag / abs(line.b - line.a)


@pytest.mark.parametrize("name", NAMES)
def test_the_inner_common_tangent_passes_between_the_circles_and_the_outer_beside_them(name: str) -> None:
    (figure,) = (one for one in drawn(name).figures(View.MECHANISM) if not one.name)
    at = {mark.label: mark.at for mark in figure.marks if isinstance(mark, Point)}
    rho = {
        letter: mark.radius
        for mark in figure.marks
        if isinstance(mark, FrictionCircle)
        for letter, place in at.items()
        if abs(place - mark.centre) < NEAR
    }
    assert told(name)
    for step, kind, (p, q) in told(name):
        lines = [
            m for m in figure.marks if isinstance(m, Segment) and m.role is Role.DIRECTION and m.step == step.number
        ]
        (line,) = (m for m in lines if all(abs(abs(side(m, at[pin])) - rho[pin]) < NEAR for pin in (p, q)))
        assert (side(line, at[p]) * side(line, at[q]) < 0) is (kind == "inner"), step.number
        same, zh, senses = KINDS[kind]
        assert f"之矩{same}" in step.words.zh and zh in step.words.zh and senses in step.words.en


@pytest.mark.parametrize("name", ["4-4", "4-5", "4-7"])
def test_the_line_of_action_at_a_contact_is_ruled_to_both_sides_and_lettered_at_its_end(name: str) -> None:
    (figure,) = (one for one in drawn(name).figures(View.MECHANISM) if not one.name)
    points = [mark for mark in figure.marks if isinstance(mark, Point)]
    steps = [step for step in drawn(name).construction.steps if "to the common normal" in step.words.en]
    assert steps
    for step in steps:
        letter = re.search(r"At the contact \$(\w)\$: ", step.words.en)
        assert letter is not None
        (at,) = {mark.at for mark in points if mark.label == letter[1]}
        lines = [
            m for m in figure.marks if isinstance(m, Segment) and m.step == step.number and abs(side(m, at)) < NEAR
        ]
        assert any(
            min(abs(m.a - at), abs(m.b - at)) > 15 and any(abs(mark.at - m.b) < NEAR for mark in points) for m in lines
        )


PRESS = """
id: upright
title: An upright slider-crank
frame: {{A: [0 mm, 0 mm]}}
links: {{1: {{AB: 50 mm}}, 2: {{BC: 150 mm}}, 3: {{block: C}}}}
joints: [3 slides on {guide} = 0 mm]
input: {{link: 1, phi: {phi} deg, omega: 10 rad/s ccw}}
branch: [C {where} B]
loads:
  F: {{on: 3, at: C, size: 100 N, direction: {against} deg, role: resisting}}
  M: {{on: 1, size: "?", role: driving}}
friction: {{3-4: {{phi: 5 deg}}}}
find: [M, R_43, v_C]
"""


@pytest.mark.parametrize(
    ("guide", "where", "phi", "against", "zh", "en"),
    [
        ("x", "above", 30, -90, "向上", "upwards"),
        ("x", "above", 150, 90, "向下", "downwards"),
        ("y", "right of", -60, 180, "向右", "to the right"),
        ("y", "right of", 60, 0, "向左", "to the left"),
    ],
)
def test_the_way_in_which_a_block_slides_is_told_as_it_moves(
    guide: str, where: str, phi: int, against: int, zh: str, en: str
) -> None:
    solution = solve(loads(PRESS.format(guide=guide, where=where, phi=phi, against=against)), repeats=0)
    moved = solution.answers["v_C"].exact_vector
    assert moved is not None
    push = {"向上": moved.imag, "向下": -moved.imag, "向右": moved.real, "向左": -moved.real}
    assert push[zh] == max(push.values()) > 0
    told = [step.words for step in solution.construction.steps if " slides " in step.words.en]
    assert told and all(f"slides {en} along" in words.en and f"沿导路{zh}滑动" in words.zh for words in told)
