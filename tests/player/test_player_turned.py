"""The crank turned: where the drive stands, at what scales each place is drawn, and what is read there."""

from __future__ import annotations

import re
from dataclasses import replace
from functools import cache
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from tests.laws import few, often, soaking
from tests.player.pages import PLACES as FEWER
from tests.player.pages import motion, page_of, solved
from vecpoly import oracle
from vecpoly.board.paper.extent import bounds
from vecpoly.board.paper.scales import round_up
from vecpoly.drawing.figure import scale_box
from vecpoly.drawing.scene import Rect
from vecpoly.foundation.data import data_dir
from vecpoly.mechanism.assembly.branch import margin
from vecpoly.mechanism.model import SideOf
from vecpoly.player.figures import key_of
from vecpoly.player.fitting import AMPLE, MOST, SIDE, coarsened
from vecpoly.player.motion import moving
from vecpoly.player.page import PLACES
from vecpoly.player.setting.ink import Ink
from vecpoly.player.turned import Cycle, cycle, in_order
from vecpoly.problem.load import load
from vecpoly.problem.problem import Problem
from vecpoly.solution import scales_of, solve

KINEMATICS, DEVICE = "3-9", "5-5"
FEW = 24 if soaking() else 8  # places of the pages that need not be large


def test_the_first_place_is_the_given_one() -> None:
    solution = solved(KINEMATICS)
    through = cycle(solution, 8)
    given = through.turns[through.start].solution
    assert through.whole and through.round and through.start == 0 and len(through.turns) == 8
    assert given.problem.mechanism.drive == solution.problem.mechanism.drive
    assert {key: answer.exact for key, answer in given.answers.items()} == {
        key: answer.exact for key, answer in solution.answers.items()
    }


def test_what_is_read_at_a_place_is_what_a_problem_given_there_would_read() -> None:
    turn = cycle(solved(KINEMATICS), 9).turns[2]
    scales = turn.solution.problem.scales
    text = Path(data_dir("problems") / "ch3" / "3-9.yaml").read_text(encoding="utf-8")
    there = load_text(re.sub(r"phi: 45 deg", f"phi: {turn.shown.rstrip('°')} deg", text))
    assert there.mechanism.drive.position != solved(KINEMATICS).problem.mechanism.drive.position
    own = solve(replace(there, scales=scales), repeats=0)
    for key, answer in turn.solution.answers.items():
        assert answer.exact == pytest.approx(own.answers[key].exact, rel=1e-9)
        assert answer.drawn == pytest.approx(own.answers[key].drawn, rel=1e-9)


@pytest.mark.parametrize("name", few([KINEMATICS, "3-5", "A-27"], 3))
def test_drawn_values_follow_the_oracle_round_the_turn(name: str) -> None:
    solution = solve(load(name), by="exact", repeats=0)
    for turn in cycle(solution, FEW).turns:
        for answer in turn.solution.answers.values():
            assert answer.drawn == pytest.approx(answer.exact, rel=1e-6, abs=1e-6 * max(1.0, abs(answer.exact)))


@pytest.mark.parametrize("name", few(["A-27", "3-4a", "3-4b"], 3))
def test_the_assembly_is_kept_round_the_turn(name: str) -> None:
    """The statement 'C above AD' may have to become 'C below AD': the drawing goes on where the oracle does."""
    solution = solved(name)
    turns = cycle(solution, FEW).turns
    mech = solution.problem.mechanism
    places = np.array([turn.solution.problem.mechanism.drive.position for turn in turns])
    motion = oracle.solve(mech, places, order=0)
    for i, turn in enumerate(turns):
        moved = turn.solution.problem.mechanism
        at = {
            letter: complex(np.broadcast_to(motion.position(letter), places.shape)[i])
            for s in moved.branches
            if isinstance(s, SideOf)
            for letter in (s.point, *s.ref)
        }
        assert all(margin(statement, at) >= 0 for statement in moved.branches)
        own = oracle.solve(moved, order=0)
        for link in mech.links:
            assert complex(own.origin(link.name)) == pytest.approx(
                complex(motion.origin(link.name)[i]), abs=1e-9 * mech.scale
            )


BESIDE_A_DEAD_POINT = "B-24"  # its accelerations grow to twenty times those of the given place


@cache
def turned_and_drawn(name: str) -> tuple[Cycle, list[dict[str, Any]], Ink]:
    ink, through = Ink(), cycle(solved(name), FEW)
    return through, moving(through, solved(name).construction, ink), ink


@pytest.mark.parametrize("name", few([KINEMATICS, BESIDE_A_DEAD_POINT], 2))
def test_nearly_all_places_share_their_scales_and_none_is_finer_than_given(name: str) -> None:
    given = scales_of(solved(name).construction)
    scales = [turn.solution.problem.scales for turn in turned_and_drawn(name)[0].turns]
    assert {one.given["mu_l"] for one in scales} == {given.given["mu_l"]}
    for field in ("mu_v", "mu_a"):
        values = [one.given[field] for one in scales]
        assert min(values) >= given.given[field]
        assert max(map(values.count, values)) >= MOST * len(values) - 1


@pytest.mark.parametrize("name", [KINEMATICS, BESIDE_A_DEAD_POINT])
def test_no_polygon_leaves_its_pane(name: str) -> None:
    through, figures, _ = turned_and_drawn(name)
    assert not any(figure["cut"] for figure in figures)
    for figure in figures[1:]:
        x, y, wide, high = (side / 100 for side in figure["clip"])
        assert max(wide, high) < 2 * SIDE
        for turn in through.turns:
            low, up = bounds(next(f.marks for f in turn.solution.construction.figures if key_of(f) == figure["key"]))
            assert x <= low.real and up.real <= x + wide and y <= -up.imag and -low.imag <= y + high


def test_the_scale_under_a_figure_is_that_of_its_drawing_at_every_place() -> None:
    through, figures, ink = turned_and_drawn(BESIDE_A_DEAD_POINT)
    given = {key_of(f): f.scale for f in solved(BESIDE_A_DEAD_POINT).construction.figures}
    assert any(len(figure["captions"]) > 1 for figure in figures)
    for figure in figures:
        for number, turn in zip(figure["scale"], through.turns, strict=True):
            drawn = next(f for f in turn.solution.construction.figures if key_of(f) == figure["key"])
            caption = figure["captions"][number]
            assert f'href="#{ink.type(scale_box(drawn.scale))}"' in caption["svg"]
            assert caption["other"] == (drawn.scale != given[figure["key"]])


@given(
    reaches=st.lists(st.tuples(*[st.floats(-3, 3)] * 2), min_size=1, max_size=12),
    given=st.sampled_from([0.003, 0.02, 1.0, 25.0]),
)
@settings(max_examples=often(60))
def test_any_polygons_fit_together_at_round_scales(reaches: list[tuple[float, float]], given: float) -> None:
    tips = [complex(np.sign(x) * 10 ** abs(x), np.sign(y) * 10 ** abs(y)) for x, y in reaches]
    boxes = [{"": Rect(min(z.real, 0), min(z.imag, 0), max(z.real, 0), max(z.imag, 0))} for z in tips]
    values = coarsened(boxes, boxes[0], given)
    side = max(SIDE, AMPLE * max(boxes[0][""].width, boxes[0][""].height))
    drawn = [z * given / value for z, value in zip(tips, values, strict=True)]
    for part in (np.real(drawn), np.imag(drawn)):
        assert max(*part, 0) - min(*part, 0) <= side * (1 + 1e-9)
    assert all(value == given or (value > given and round_up(value) == pytest.approx(value)) for value in values)


def test_a_drive_that_passes_dead_points_goes_round_from_the_given_place() -> None:
    assert in_order([0, 1, 2, 4, 5, 6, 7, 9, 10, 11], 12) == ([0, 1, 2, 4, 5, 6, 7, 9, 10, 11], True)
    assert in_order([0, 1, 2, 7, 8, 9, 10, 11], 12) == ([7, 8, 9, 10, 11, 0, 1, 2], False)
    assert in_order([0], 12) == ([0], False) and in_order([], 12) == ([], False)


def test_a_rocker_that_cannot_turn_round_is_run_through_from_end_to_end() -> None:
    through = cycle(solved("3-4a"), FEW)
    assert not through.whole and not through.round and 2 < len(through.turns) < FEW
    angles = np.array([turn.solution.problem.mechanism.drive.position for turn in through.turns])
    assert np.allclose(np.abs((np.diff(angles) + np.pi) % (2 * np.pi) - np.pi), 2 * np.pi / FEW)


def test_a_sliding_drive_is_moved_over_its_travel() -> None:
    text = """
id: pushed
title: {zh: 滑块, en: Slider}
frame: {A: [0 mm, 0 mm]}
links: {1: {block: C}, 2: {BC: 100 mm}, 3: {AB: 40 mm}}
joints: [1 slides on y = 0 mm]
input: {link: 1, s: 110 mm, v: 0.5 m/s}
branch: [B above AC]
find: [v_B, omega_3]
"""
    solution = solve(load_text(text), repeats=0)
    through = cycle(solution, 12)
    travel = [turn.solution.problem.mechanism.drive.position for turn in through.turns]
    assert len(travel) > 8 and travel == sorted(travel) and min(travel) > 0.0599 and max(travel) < 0.1401
    assert travel[through.start] == pytest.approx(0.11)
    assert through.turns[through.start].shown == "110 mm"


def load_text(text: str) -> Problem:
    with TemporaryDirectory() as folder:
        file = Path(folder) / "problem.yaml"
        file.write_text(text, encoding="utf-8")
        return load(file)


def test_a_device_has_no_crank_to_turn() -> None:
    assert cycle(solved(DEVICE), PLACES).turns == ()
    assert 'id="mode-turn"' not in page_of(DEVICE) and 'id="mode-turn"' in page_of(KINEMATICS)


def test_motion_data_hold_a_drawing_and_all_readings_for_every_place() -> None:
    data = motion(page_of(KINEMATICS))
    assert len(data["shown"]) == len(data["readings"]) == FEWER and data["shown"][0] == "45°"
    assert all(len(row) == len(solved(KINEMATICS).answers) for row in data["readings"])
    for figure in data["figures"]:
        assert len(figure["sets"][0]["moving"]) == FEWER and all(figure["sets"][0]["moving"])
