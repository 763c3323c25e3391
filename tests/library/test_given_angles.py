"""Claims about the lengths and angles that are listed as given: they are those of the link between these letters."""

from __future__ import annotations

import cmath
import re
from collections.abc import Iterator
from math import pi

import pytest

from tests.drawn_library import given as read
from tests.drawn_library import ids
from tests.each import Later, each
from tests.texts import SLIDER_CRANK
from vecpoly.mechanism.model import Link
from vecpoly.problem.load import loads
from vecpoly.problem.problem import Problem

IDS = Later(lambda: ids())
LETTER = r"[A-Z][₀-₉]?(?:_\d)?[′']?"
TURNED = (
    SLIDER_CRANK.replace("BC: 230 mm", "BC: 230 mm, E: {BE: 70 mm, angle: 50 deg from BC}")
    + "input: {link: 1, phi: 52 deg, omega: 10 rad/s ccw}\nbranch: [C right of B]\nfind: [v_E]\n"
)


def of_letters(problem: Problem, *letters: str) -> Iterator[Link]:
    """The links that have all these points."""
    return (link for link in problem.mechanism.links if set(letters) <= link.points.keys())


def wrong(problem: Problem) -> tuple[int, list[str]]:
    """How many angles between three letters are listed, and the symbols of those that are another angle."""
    count, found = 0, []
    for datum in problem.given.lengths:
        angle = re.fullmatch(rf"∠({LETTER})({LETTER})({LETTER})", datum.symbol or "")
        if angle is None or datum.si is None:
            continue
        first, corner, last = angle.groups()
        count += 1
        turns = [
            cmath.phase((link.points[last] - link.points[corner]) / (link.points[first] - link.points[corner]))
            for link in of_letters(problem, first, corner, last)
            if len({first, corner, last}) == 3
        ]
        if not any(abs((turn - datum.si + pi) % (2 * pi) - pi) < 1e-6 for turn in turns):
            found.append(datum.symbol)
    return count, found


@each(IDS)
def test_an_angle_that_is_given_is_between_three_points_of_a_link_as_its_letters_say(name: str) -> None:
    assert wrong(read(name))[1] == []


@pytest.mark.parametrize("degrees", [-120, 20, 50, 190])
def test_an_angle_from_a_bar_is_listed_with_the_end_of_the_bar_its_corner_and_the_point(degrees: int) -> None:
    problem = loads(TURNED.replace("50 deg from", f"{degrees} deg from"))
    assert wrong(problem) == (1, [])
