"""The player of a cam: its follower walks round the standing cam."""

from __future__ import annotations

import numpy as np
import pytest

from tests.laws import few
from vecpoly.board.paper.marks import Curve, Point
from vecpoly.devices.cams.cam import Cam
from vecpoly.oracle.devices.cams.shape import profile
from vecpoly.player.page import player
from vecpoly.player.turned import cycle
from vecpoly.problem.load import load
from vecpoly.solution import solve

CAMS = ("cam-roller-offset", "cam-flat-face", "cam-flat-arm", "cam-rocker", "cam-heart")


@pytest.mark.parametrize("name", few(CAMS, 3))
def test_the_follower_touches_the_standing_profile_at_every_station(name: str) -> None:
    solution = solve(load(name), by="exact", repeats=0)
    cam, through = solution.problem.subject, cycle(solution, 72)
    assert isinstance(cam, Cam) and through.inverts and len(through.turns) == len(cam.places) - 1
    standing = set()
    for (phi, piece), turn in zip(cam.places[1:], through.turns, strict=True):
        (figure,) = turn.solution.construction.figures
        (touch,) = [mark.at for mark in figure.marks if isinstance(mark, Point) and mark.label == "T"]
        exact = complex(profile(cam, piece, np.array([phi]))[0])
        assert touch * figure.scale.value == pytest.approx(exact, abs=1e-9)
        standing.add(tuple(mark.points for mark in figure.marks if isinstance(mark, Curve)))
    assert len(standing) == 1  # the cam stands


def test_each_station_tells_what_was_read_there() -> None:
    solution = solve(load("cam-roller-offset"), by="exact", repeats=0)
    turn = cycle(solution, 72).turns[3]
    assert turn.shown == "60°" and set(turn.solution.answers) == {"s", "r", "alpha"}
    for stem, answer in turn.solution.answers.items():
        assert answer.drawn == pytest.approx(solution.answers[f"{stem}_60"].exact, abs=1e-9)


def test_the_page_offers_the_walk_and_other_devices_have_steps_only() -> None:
    pages = {name: player(solve(load(name), repeats=0), places=4).html for name in ("cam-heart", "cam-least-circle")}
    assert ["从动件绕行" in html for html in pages.values()] == [True, False]
    assert "Turn the crank" not in pages["cam-heart"]
