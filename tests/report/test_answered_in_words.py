"""What a statement asks in words has its sentence in the box of answers."""

from __future__ import annotations

import re

import pytest

from tests.drawn_library import drafted, given
from vecpoly import load, loads, solve
from vecpoly.report.content import conclusions
from vecpoly.words import Lang

PRINTED = re.compile(r"(?ms)^printed:.*")


@pytest.mark.parametrize("lang", ["zh", "en"])
def test_the_motion_of_a_translating_link_is_told_under_the_symbol_that_the_statement_asks_by(lang: Lang) -> None:
    asked = given("3-5").text.replace("$v_F$", "$v_5$").replace("$a_F$", "$a_5$")
    told = conclusions(solve(loads(asked), repeats=0, precise=False), lang)
    assert all(any(f"${symbol}$ = $" in text for text in told) for symbol in ("v_5", "a_5"))


def test_an_in_line_four_leaves_the_force_of_second_order() -> None:
    solution = drafted("engine-four")
    assert solution is not None
    (told,) = conclusions(solution, "en")
    assert told == "Left unbalanced is the force of second order $F_{II}$; the others are balanced."
    assert conclusions(solution, "zh") == ["未平衡的是二阶惯性力 $F_{II}$，其余各项均已平衡。"]


def said(name: str, lang: Lang, *changed: tuple[str, str]) -> str:
    text = PRINTED.sub("", load(name).text)
    for old, new in changed:
        assert old in text
        text = text.replace(old, new)
    return " ".join(conclusions(solve(loads(text), by="exact", repeats=0, precise=False), lang))


def test_a_clamp_says_whether_it_locks_by_itself() -> None:
    assert said("5-2", "en") == "Not self-locking, since $α$ = 21° > $2φ$ = 14.8°."
    assert said("5-2", "zh") == "不自锁，因 $α$ = 21° > $2φ$ = 14.8°。"
    assert said("5-2", "en", ("alpha: 21 deg", "alpha: 14 deg")) == "Self-locking, since $α$ = 14° ≤ $2φ$ = 14.8°."


def test_wedges_and_springs_say_which_way_they_lock() -> None:
    assert said("5-4", "zh") == "两个行程都不自锁，因 $φ$ = 6.84° < $α$ = 38° < $90° − φ$ = 83.2°。"
    assert (
        said("5-4", "en", ("alpha: 38 deg", "alpha: 84 deg"))
        == "The release is self-locking, since $α$ = 84° ≥ $90° − φ$ = 83.2°."
    )
    assert "return stroke is not self-locking" in said("4-2", "en")
    assert "正行程不自锁" in said("4-2", "zh")
    assert "反行程自锁" in said("4-2", "zh", ("alpha: 60 deg, beta: 60 deg", "alpha: 83 deg, beta: 83 deg"))


def test_a_rotor_says_whether_other_planes_will_do() -> None:
    assert said("6-5", "zh") == "能实现：在平面 $I$ 和 $II$ 内各加一个质径积。 转子动不平衡。"
    assert said("6-5", "en").endswith("in each of the planes $I$ and $II$. The rotor is not in dynamic balance.")
    assert said("6-7", "en") == "", "it is not asked there"


@pytest.mark.parametrize(("name", "kind"), [("8-9", "a slider-crank"), ("8-10", "a rocker-slider")])
def test_of_what_type_a_slider_linkage_is_stands_in_the_box(name: str, kind: str) -> None:
    solution = drafted(name)
    assert solution is not None
    assert conclusions(solution, "en")[0] == f"The linkage $ABC$ is {kind}."
