"""Which way a pair of wedges locks itself is told as its limits say."""

from __future__ import annotations

import re

import pytest

from vecpoly import load, loads, solve

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
