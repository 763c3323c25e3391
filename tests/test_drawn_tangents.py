"""Claims about lines of action that touch two friction circles: which common tangent is told is the one that is drawn."""

from __future__ import annotations

import re
from functools import cache

import pytest

from tests.drawn_library import drawn
from vecpoly.board.construction import Step, View
from vecpoly.board.marks import FrictionCircle, Point, Role, Segment

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
    rho = {letter: mark.radius for mark in figure.marks if isinstance(mark, FrictionCircle)
           for letter, place in at.items() if abs(place - mark.centre) < NEAR}
    assert told(name)
    for step, kind, (p, q) in told(name):
        lines = [m for m in figure.marks if isinstance(m, Segment) and m.role is Role.DIRECTION and m.step == step.number]
        (line,) = (m for m in lines if all(abs(abs(side(m, at[pin])) - rho[pin]) < NEAR for pin in (p, q)))
        assert (side(line, at[p]) * side(line, at[q]) < 0) is (kind == "inner"), step.number
        same, zh, senses = KINDS[kind]
        assert f"之矩{same}" in step.words.zh and zh in step.words.zh and senses in step.words.en
