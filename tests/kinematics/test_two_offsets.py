"""A guide that passes neither its pivot nor the pin of its block: the step tells the radius that is drawn."""

from __future__ import annotations

import re

import pytest

from vecpoly import loads
from vecpoly.board.paper.marks import Arc, Point
from vecpoly.report.question.sketch import sketched

BOTH = """
id: x
title: x
frame: {{A: [0 mm, 0 mm], C: [0 mm, -110 mm]}}
links:
  1: {{AB: 50 mm}}
  3: {{CD: 200 mm, slot: {{through: C, angle: 0 deg from CD, left: {left} mm}}}}
  2: {{block: B}}
joints: [2 slides in 3 with B {off}]
input: {{link: 1, phi: 30 deg, omega: 10 rad/s}}
branch: [D above C]
find: [omega_3]
"""


@pytest.mark.parametrize(
    ("left", "off", "told", "mm"),
    [(12, "8 mm left", "之和", 20.0), (-12, "8 mm left", "之差", 4.0), (12, "8 mm right", "之差", 4.0)],
)
def test_the_radius_of_an_arc_of_two_offsets_is_told_as_their_sum_or_difference(
    left: int, off: str, told: str, mm: float
) -> None:
    """e was called the radius, whichever way the guide passed the pivot."""
    construction = loads(BOTH.format(left=left, off=off)).solve(by="exact").construction
    (step,) = [one.words.zh for one in construction.steps if "为半径作弧，过" in one.words.zh]
    assert told in step and "$e/μ_l$" not in step
    figure = construction.figures[0]
    (pin,) = [mark.at for mark in figure.marks if isinstance(mark, Point) and mark.label == "B"]
    assert "r = e" not in [mark.label for mark in figure.marks if isinstance(mark, Point)]
    radii = [mark.radius for mark in figure.marks if isinstance(mark, Arc) and abs(mark.centre - pin) < 1e-9]
    assert mm / 1e3 / figure.scale.value in [pytest.approx(radius) for radius in radii]


SEVERAL = """
id: x
title: x
frame: {A: [0 mm, 0 mm], D: [-120 mm, 0 mm], F: [-60 mm, 90 mm]}
links:
  1: {AB: 50 mm}
  2: {block: B}
  3: {slot: D, C: {along: D, at: 200 mm}}
  4: {block: C}
  5: {slot: {through: F, left: 12 mm}}
  6: {CE: 120 mm}
  7: {block: E}
joints: [2 slides in 3 with B 15 mm left, 4 slides in 5, 7 slides on y = 30 mm with E 20 mm left]
input: {link: 1, phi: 40 deg, omega: 10 rad/s ccw}
branch: [E right of C]
find: [omega_3]
"""


def _offsets(words: str) -> list[str]:
    return re.findall(r"\$(e(?:_\{\w+\})?)\$ = ", words)


def test_of_several_offsets_each_has_a_letter_of_its_own_in_data_steps_and_sketch() -> None:
    """All were called e, and so was the distance of a slot from its pin, which no datum calls so."""
    problem = loads(SEVERAL)
    given = [name for datum in problem.given.data for name in _offsets(datum.of("zh"))]
    assert given == ["e_{2}", "e_{7}"]
    solution = problem.solve(by="exact")
    steps = [step.words.en for step in solution.construction.steps]
    assert [name for words in steps for name in re.findall(r"offset \$(e.*?)/μ_l", words)] == ["e_{2}"]
    (slotted,) = [words for words in steps if "the distance of $F$ from the guide" in words]
    assert "arc about $C$" in slotted
    sketch = sketched(problem, solution.construction, 165.0, 90.0)
    assert sketch is not None
    assert {mark.label for mark in sketch.marks if isinstance(mark, Point) and mark.label.startswith("e")} == {*given}


def test_an_offset_that_is_the_only_one_is_called_e() -> None:
    problem = loads(SEVERAL.replace(" with E 20 mm left", ""))
    assert [name for datum in problem.given.data for name in _offsets(datum.of("zh"))] == ["e"]
