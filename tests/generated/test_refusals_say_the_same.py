"""Damaged files by lot: what is wrong is told with the same numbers in both languages, with no gap where a name should
stand, and with what there is or what to do."""

from __future__ import annotations

import re

import numpy as np
import pytest

import vecpoly
from tests.fuzz.mutants import mutant
from vecpoly.errors import ProblemFileError, VecpolyError
from vecpoly.problem.library import library
from vecpoly.words import Words

COUNT = 150
NUMBER = re.compile(r"\d+(?:\.\d+)?(?:e[-+]?\d+)?")
QUOTED = re.compile(r"'[^']*'|“[^”]*”")  # as it stands in the file
GAP = re.compile(r" {2}|\( | \)|（ | ）|[;:,] *$|[；：，]$|\[\]|\bby *$")


@pytest.fixture(scope="module")
def refusals() -> tuple[Words, ...]:
    rng = np.random.default_rng(2601)
    texts, found = [entry.path.read_text("utf-8") for entry in library()], dict[str, Words]()
    for _ in range(COUNT):
        try:
            vecpoly.loads(mutant(rng, texts))
        except VecpolyError as error:
            for fault in error.faults:
                found.setdefault(NUMBER.sub("#", fault.said.en), fault.said)
    return tuple(found.values())


def test_numbers_are_the_same_in_both_languages(refusals: tuple[Words, ...]) -> None:
    assert len(refusals) > COUNT / 8
    for said in refusals:
        assert sorted(NUMBER.findall(said.zh)) == sorted(NUMBER.findall(said.en)), said


def test_no_name_is_left_out(refusals: tuple[Words, ...]) -> None:
    """“原动件是构件 （转动）” was said of a drive that could not be read, “应缩进  个空格” of a first line."""
    for said in refusals:
        assert not any(GAP.search(QUOTED.sub("'q'", text)) for text in (said.zh, said.en)), said


GUIDES = """
id: a
title: a
frame: {A: [0 mm, 0 mm], D: [200 mm, 0 mm]}
links: {1: {AB: 50 mm}, 2: {BC: 180 mm}, 3: {CD: 120 mm}, 4: {block: C}}
joints: [4 slides on %s]
input: {link: 1, phi: 60 deg, omega: 3 rad/s}
"""


@pytest.mark.parametrize(
    ("guide", "said"),
    [
        ("BD", "B is on link 1 and link 2; D is on the frame and link 3"),
        ("AE", "A is on the frame and link 1; E lies on none"),
    ],
)
def test_where_no_link_has_both_points_of_a_guide_it_is_told_where_they_are(guide: str, said: str) -> None:
    with pytest.raises(ProblemFileError) as refused:
        vecpoly.loads(GUIDES % guide)
    assert f"no link has both points {guide[0]} and {guide[1]} ({said}" in refused.value.faults[0].said.en


SLIDING = """
id: a
title: a
frame: {A: [0 mm, 0 mm]}
links: {1: {AB: 50 mm}, 2: {BC: 180 mm}, 3: {block: C}}
joints: [3 slides on y = 0 mm]
input: %s
loads: {M: {on: 1, size: constant}, F_3: {on: 3, at: C, size: 20 N, direction: 0 deg}}
"""


@pytest.mark.parametrize(
    ("drive", "said"),
    [("{link: 3, s: 200 mm, v: 1 m/s}", '(slides); write size: "?" instead'), ("{lnk: 1}", "unknown key 'lnk'")],
)
def test_a_constant_moment_is_not_sent_to_what_does_not_turn(drive: str, said: str) -> None:
    with pytest.raises(ProblemFileError) as refused:
        vecpoly.loads(SLIDING % drive)
    told = [fault.said.en for fault in refused.value.faults]
    assert any(said in one for one in told) and not any("link  drives" in one for one in told)
