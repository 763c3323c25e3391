"""Reactions as they are asked: between links that have a joint, their numbers together or apart."""

from __future__ import annotations

import pytest

from vecpoly import loads
from vecpoly.errors import ProblemFileError
from vecpoly.problem.problem import Problem

TEXT = """
id: mine
title: mine
frame: {A: [0 mm, 0 mm], D: [200 mm, 40 mm], G: [420 mm, 0 mm]}
links: {2: {AB: 50 mm}, 5: {BC: 190 mm}, 9: {DC: 110 mm, E: {along: DC, at: 150 mm}}, 11: {EF: 230 mm}, 12: {GF: 14 cm}}
input: {link: 2, phi: 5 deg, omega: 9 rad/s ccw}
branch: [C left of BD, F left of GE]
loads: {M_12: {on: 12, size: 30 N*m cw}, M_2: {on: 2, size: "?"}}
find: [ASKED]
"""


def asking(key: str) -> Problem:
    return loads(TEXT.replace("ASKED", key))


@pytest.mark.parametrize(
    ("written", "key"),
    [("R_2_5", "R_25"), ("R_25", "R_25"), ("R_9_11", "R_9_11"), ("R_11_9", "R_11_9"), ("R_12_13", "R_12_13")],
)
def test_numbers_may_stand_together_or_apart(written: str, key: str) -> None:
    assert [ask.rel.key for ask in asking(written).asks] == [key]


@pytest.mark.parametrize(
    ("written", "links", "there"),
    [("R_29", ("2", "9"), "R_59"), ("R_2_11", ("2", "11"), "R_9_11"), ("R_5_13", ("5", "13"), "R_9_13")],
)  # fmt: skip
def test_links_without_a_joint_do_not_act_on_each_other(written: str, links: tuple[str, str], there: str) -> None:
    with pytest.raises(ProblemFileError) as refused:
        asking(written)
    (fault,) = refused.value.faults
    assert f"no joint joins links {links[0]} and {links[1]}" in fault.words.en and there in fault.words.en
    assert f"构件 {links[0]} 与构件 {links[1]} 之间没有运动副" in fault.words.zh and fault.path == ("find", 0)


@pytest.mark.parametrize("name", ["boom-thrust", "planetary-reactions"])
def test_where_nothing_is_asked_it_is_the_load_and_what_reactions_can_be_drawn_from_some_link(name: str) -> None:
    unasked = loads(f"id: mine\nextends: {name}\nfind: null\n")
    assert unasked.loads is not None
    load, *reactions = (ask.rel.key for ask in unasked.asks)
    assert load == unasked.loads.unknown.name and reactions and all(key.startswith("R_") for key in reactions)
