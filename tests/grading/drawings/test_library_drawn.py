"""An exact drawing of any problem is right, and a right one by hand is not taken for another."""

from __future__ import annotations

import pytest

from tests.drawn_library import LIBRARY
from tests.each import each
from tests.grading.drawings.made import by_pencil, drawn, key_of, marked
from tests.laws import few, often
from vecpoly.grading.allowance import STUDENT
from vecpoly.grading.drawings.judging.mark import Verdict
from vecpoly.grading.drawings.segment import SHORTEST

MIRRORED = ("engine-four",)  # its couples of both orders are one polygon, told apart by letters alone


@each([name for name in few(LIBRARY, 12) if name not in MIRRORED])
def test_an_exact_drawing_is_right_throughout(name: str) -> None:
    key = key_of(name)
    mark = marked(key, drawn(key.exact))
    wrong = [(one.figure, one.key, one.verdict) for one in mark.vectors if one.verdict is not Verdict.RIGHT]
    assert not wrong and not mark.mirrored and not mark.turned


@pytest.mark.parametrize("name", ["A-30-b", "C-inertia", "peaucellier"])
def test_a_vector_that_is_too_short_to_be_drawn_is_not_missed(name: str) -> None:
    key = key_of(name)
    assert all(abs(edge.along) > SHORTEST for shape in key.exact.shapes if not shape.diagram for edge in shape.edges)
    assert all(one.verdict is Verdict.RIGHT for one in marked(key, drawn(key.exact)).vectors)


@pytest.mark.parametrize("name", ["6-2", "6-3b"])
def test_polygons_of_two_planes_that_mirror_each_other_are_told_by_their_senses(name: str) -> None:
    key = key_of(name, STUDENT)
    for seed in range(often(6)):
        mark = marked(key, by_pencil(key, seed))
        assert not any(abs(figure.turned) > 90 for figure in mark.figures if figure.turned), seed


@pytest.mark.parametrize("seed", [0, 3])
def test_the_scale_is_told_by_the_vector_laid_off_first_and_not_by_what_was_drawn_badly(seed: int) -> None:
    """Of links nearly in one line a pencil makes v_D 6 % too long, and v_B is right."""
    key = key_of("3-4a-straight", STUDENT)
    assert marked(key, by_pencil(key, seed))["velocity"]["v_B"].verdict is Verdict.RIGHT
