"""A link with a rack and a gear, at one pin too: which of them a gear rolls on is said, and never guessed."""

from __future__ import annotations

import pytest

from vecpoly import loads, solve
from vecpoly.errors import ProblemFileError
from vecpoly.mechanism.model import Circle, Mechanism, Rack, Rolling
from vecpoly.problem.problem import Problem

TEXT = """
id: mine
title: mine
frame: {A: [0 mm, 0 mm], D: [100 mm, 30 mm]}
links: {1: {AB: 40 mm}, 2: {LINK}, 3: {gear: D, radius: 30 mm}, 4: {gear: A, radius: 20 mm}}
joints: [FIRST, SECOND]
input: {link: 1, phi: 75 deg, omega: 10 rad/s ccw}
find: [omega_2, omega_3, omega_4, alpha_3, alpha_4]
"""
LINKS = (
    "rack: B, gear: B, radius: 20 mm",
    "BE: 50 mm, gear: B, radius: 20 mm, rack: {through: B, angle: 30 deg from BE}",
    "BE: 90 mm, gear: B, radius: 20 mm, rack: {through: B, left: 10 mm}",
)
RACK, GEAR = "3 rolls on the rack of 2 at H", "4 rolls on the gear of 2 at K"


def written(link: str = LINKS[0], first: str = RACK, second: str = GEAR) -> Problem:
    return loads(TEXT.replace("LINK", link).replace("FIRST", first).replace("SECOND", second))


@pytest.mark.parametrize("link", LINKS)
def test_both_flanks_of_a_link_roll_drawn_as_exact(link: str) -> None:
    solution = solve(written(link), by="exact")
    assert len(solution.answers) == 5
    for answer in solution.answers.values():
        assert answer.drawn == pytest.approx(answer.exact, rel=1e-9)


@pytest.mark.parametrize(
    ("first", "second"),
    [
        (RACK, "4 rolls on 2 of 20 mm at K"),
        (RACK, "2 rolls on 4 at K"),
        ("3 与 2 的齿条在 H 处啮合", "4 与 2 的齿轮在 K 处啮合"),
    ],
)
def test_the_flank_may_be_told_in_other_ways(first: str, second: str) -> None:
    wanted, told = (solve(one, by="exact").answers for one in (written(), written(first=first, second=second)))
    assert [answer.exact for answer in told.values()] == pytest.approx([one.exact for one in wanted.values()])
    subject = written(first=first, second=second).subject
    assert isinstance(subject, Mechanism)
    pairs = {joint.point: joint.on for joint in subject.joints if isinstance(joint, Rolling)}
    assert isinstance(pairs["H"], Rack) and isinstance(pairs["K"], Circle)


@pytest.mark.parametrize(("first", "second"), [("3 rolls on 2 at H", GEAR), (RACK, "4 与 2 在 K 处啮合")])
def test_what_may_mean_either_is_refused_with_both(first: str, second: str) -> None:
    with pytest.raises(ProblemFileError) as refused:
        written(first=first, second=second)
    (fault,) = refused.value.faults
    assert "'on the rack of 2' or 'on the gear of 2'" in fault.words.en and "既有齿条又有齿轮" in fault.words.zh


def test_a_rack_that_is_none_is_refused() -> None:
    with pytest.raises(ProblemFileError, match="link 4 has no rack"):
        written(first="3 rolls on the rack of 4 at H")
