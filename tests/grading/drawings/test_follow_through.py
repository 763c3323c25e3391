"""One mistake on a drawing is one vector, whatever follows from it; figures that are nearly alike are told apart."""

from __future__ import annotations

from dataclasses import replace
from itertools import product

import pytest

from tests.grading.drawings.made import by_pencil, drawn, key_of, marked, put
from tests.laws import few, often
from vecpoly.grading.allowance import STUDENT
from vecpoly.grading.drawings.judging.mark import Basis, DrawingMark, Verdict
from vecpoly.grading.drawings.segment import Drawing, Label

FORCES = ("4-3a", "4-5", "4-4")


def costs(mark: DrawingMark) -> list[str]:
    return [f"{one.figure}:{one.key}" for one in mark.vectors if one.costs]


@pytest.mark.parametrize(("problem", "share"), few([("3-9", 0.9), ("4-3a", 0.9), ("A-27", 0.9)], 3))
def test_nine_of_ten_mistakes_cost_one_vector(problem: str, share: float) -> None:
    key = key_of(problem)
    tried = few(key.worlds, 2) if len(key.worlds) >= 20 else key.worlds
    found = [costs(marked(key, drawn(world), declared=True)) for _, world in tried]
    assert len(found) >= 10 and sum(len(one) <= 1 for one in found) >= share * len(found)


def test_what_follows_from_a_mistake_that_is_named_says_from_which() -> None:
    key = key_of("3-9")
    world = next(world for slip, world in key.worlds if str(slip) == "a_B scaled")
    mark = marked(key, drawn(world), declared=True)
    assert costs(mark) == ["acceleration:a_B"]
    following = [one for one in mark.vectors if one.basis is Basis.SLIP]
    assert following and all("a_{B}" in one.reason.zh and "不重复扣分" in one.reason.zh for one in following)


def test_the_corner_of_a_force_polygon_is_gone_on_from() -> None:
    key = key_of("4-3a")
    world = next(world for slip, world in key.worlds if str(slip) == "force 3:F halved")
    mark = marked(key, drawn(world), declared=True)
    by_key = {one.key: one for one in mark["force 3"].vectors}
    assert costs(mark) == ["force 3:F"]
    assert by_key["R_23"].basis is by_key["R_43"].basis is Basis.OWN


def test_of_two_directions_that_meet_the_wrong_one_alone_is_wrong() -> None:
    """R_23 on the other side of its friction circle: R_43 along its right line is as long as that makes it."""
    key = key_of("4-3a")
    world = next(world for slip, world in key.worlds if str(slip) == "R_32 other tangent")
    mark = marked(key, drawn(world), declared=True)
    assert costs(mark) == ["force 3:R_23"]
    assert mark["force 3"]["R_43"].verdict is Verdict.RIGHT


@pytest.mark.parametrize(("problem", "turned"), few([*product(FORCES, (False, True))], 5))
def test_polygons_with_and_without_friction_are_told_apart_at_ones_own_scale(problem: str, turned: bool) -> None:
    key = key_of(problem, STUDENT)
    for seed in range(often(2)):
        drawing = put(by_pencil(key, seed), lambda z: 0.7 * z)
        lines = drawing.segments[::-1] if turned else drawing.segments
        mark = marked(key, replace(drawing, segments=lines))
        assert all(one.where == f"{one.figure}:{one.key}" for one in mark.vectors), seed


def test_a_diagram_is_never_taken_for_a_polygon_of_forces() -> None:
    key = key_of("4-3a")
    lines = tuple(one for one in drawn(key.exact).segments if not one.where.startswith("force 3 ideal"))
    mark = marked(key, Drawing(file="made", segments=lines))
    assert not mark["force 3 ideal"].drawn and mark["force 3"].drawn


def test_a_scale_on_the_drawing_goes_before_that_of_the_sheet() -> None:
    key = key_of("3-9")
    own = put(drawn(key.exact), lambda z: 0.5 * z)
    mu = 2 * key.problem.scales.given["mu_v"], 2 * key.problem.scales.given["mu_a"]
    said = [f"μ_v = {mu[0]:g} (m/s)/mm", f"μ_a = {mu[1]:g} (m/s²)/mm"]
    labels = tuple(Label(text=text, at=-50j * (n + 1)) for n, text in enumerate(said))
    stated = marked(key, replace(own, labels=labels), declared=True)
    assert stated.right and all(one.declared and not one.remarks for one in stated.figures)
    sized = marked(key, own, declared=True)
    assert any("0.500" in words.en for words in sized.remarks) and not any("0.500" in w.en for w in stated.remarks)
