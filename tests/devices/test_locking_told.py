"""Which way a pair of wedges locks itself is told as its limits say."""

from __future__ import annotations

import re

import pytest

from vecpoly import load, loads, solve
from vecpoly.board.paper.marks import LinkNumber, Outline, Point

PLAIN = re.sub(r"(?ms)^printed:.*", "", load("4-2").text)


@pytest.mark.parametrize(
    ("angle", "locked", "en", "zh"),
    [
        (60, False, "neither way is self-locking", "正、反行程都不自锁"),
        (83, True, "self-locking: the return stroke", "反行程自锁"),
    ],
)
def test_a_way_locks_where_the_friction_angle_is_beyond_its_limit(angle: int, locked: bool, en: str, zh: str) -> None:
    text = PLAIN.replace("{alpha: 60 deg, beta: 60 deg", f"{{alpha: {angle} deg, beta: {angle} deg")
    text = re.sub(r"find: .*", "find: [phi, lock_direct, lock_reverse]", text)
    solution = solve(loads(text), by="exact", repeats=0)
    exact = {key: answer.exact for key, answer in solution.answers.items()}
    assert (exact["phi"] > exact["lock_reverse"]) is locked and exact["phi"] < exact["lock_direct"]
    told = [step.words for step in solution.construction.steps if "Here $φ$" in step.words.en]
    assert len(told) == 1 and en in told[0].en and zh in told[0].zh


def test_the_clamping_wedge_at_its_limit_lies_as_it_is_clamped() -> None:
    """Thick end at the left, the face on 1 below, that on 2 above, each at right angles to the normal of its name."""
    figures = solve(load("5-2"), by="exact", repeats=0).construction.figures
    marks = next(figure for figure in figures if figure.name.startswith("limit")).marks
    (wedge,) = [mark for mark in marks if isinstance(mark, Outline)]
    edge, *thick = wedge.points
    over, under = sorted(thick, key=lambda at: -at.imag)
    assert edge == 0 and max(at.real for at in thick) < -30.0 and under.imag < 0.0 < over.imag
    number = {mark.number: mark.a for mark in marks if isinstance(mark, LinkNumber)}
    assert (number["1"] / under).imag > 0.0 > (number["2"] / over).imag and under.imag < number["3"].imag < over.imag
    normal = {mark.label: mark.at for mark in marks if isinstance(mark, Point)}
    assert (normal["n_{13}"].conjugate() * under).real == pytest.approx(0.0, abs=1e-9)
    assert (normal["n_{23}"].conjugate() * over).real == pytest.approx(0.0, abs=1e-9)
