"""A follower that dwells rests over a stretch: the cycle tells the stretches, and no quick return between them."""

from __future__ import annotations

from math import degrees

import numpy as np
import pytest

from tests.laws import few
from vecpoly.cycle import cycle, extremes, facts, path
from vecpoly.cycle.facts.crossings import _pairs
from vecpoly.cycle.facts.rests import stood
from vecpoly.cycle.facts.sentences import sentences
from vecpoly.cycle.table import table
from vecpoly.errors import NoMethodError
from vecpoly.problem.load import load, loads

CAM = """
id: cam
title: t
frame: {O: [0 mm, 0 mm]}
links:
  1: {cam: {about: O, follower: {roller: 10 mm, offset: 6 mm}, r0: 50 mm, motion: [rise 30 mm in 110 deg %s, dwell 40 deg, return in 120 deg %s, dwell 90 deg]}}
  2: {block: B}
  3: {disc: B, radius: 10 mm}
joints: [2 slides on x = 6 mm, 1 touches 3 at T]
input: {link: 1, phi: 80 deg, omega: 10 rad/s ccw}
find: [v_B]
"""  # noqa: E501


@pytest.mark.parametrize(("rise", "back"), few([("cosine", "parabolic"), ("sine", "3-4-5")], 2))
def test_rests_at_both_limits_are_told_as_stretches_with_the_strokes_between_them(rise: str, back: str) -> None:
    turn = cycle(loads(CAM % (rise, back)), n=37)
    (stroke,) = facts(turn).strokes
    low, high = stroke.rests
    assert low is not None and high is not None
    assert [degrees(a) for a in (*low, *high)] == pytest.approx([270.0, 360.0, 110.0, 150.0], abs=0.02)
    assert (degrees(stroke.forth), degrees(stroke.back)) == pytest.approx((110.0, 120.0), abs=0.02)
    said = " ".join(words.en for words in sentences(turn, facts(turn)))
    assert "up in 110.0°, back in 120.0°" in said and "$K$" not in said


def test_an_extreme_that_is_kept_over_a_stretch_has_the_stretch_for_its_place() -> None:
    """Within a dwell it was told at the one place that rounding chose, 314.9998°."""
    turn = cycle(load("cam-moves-arm"), n=13)
    for key, lowest in (("phi_2", (120.0, 150.0)), ("v_B", (270.0, 360.0))):
        found = extremes(turn, key)
        assert found.lowest is not None and found.highest is not None
        assert [degrees(a) for a in stood(turn, found, found.lowest) or ()] == pytest.approx(lowest, abs=1e-4)
        assert (stood(turn, found, found.highest) is None) == (key == "v_B")


def test_a_limit_position_that_is_passed_at_once_is_no_rest() -> None:
    strokes = facts(cycle(load("3-12"), n=37)).strokes
    assert strokes and all(stroke.rests == (None, None) for stroke in strokes)


def test_what_moves_along_y_has_no_component_along_x_in_a_table() -> None:
    made = table(cycle(loads(CAM % ("cosine", "cosine")), n=37), ("v_B",))
    across = made.values[:, [column.key for column in made.columns].index("v_B.x")]
    along = made.values[:, [column.key for column in made.columns].index("v_B.y")]
    moving = abs(along) > 1e-6
    assert moving.sum() > 10 and not across[moving].any()


def test_a_point_that_rests_crosses_its_path_nowhere_meanwhile_and_a_centre_of_curvature_has_no_path() -> None:
    """Every pair of places within a dwell once counted as a crossing: ten thousand sentences of one cam."""
    turn = cycle(load("cam-moves-arm"), n=13)
    assert "p_K" not in {column.key for column in turn.columns} and "p_B" in {column.key for column in turn.columns}
    with pytest.raises(NoMethodError, match="K is the centre of curvature of the profile of cam 1"):
        path(turn, "K")
    t = np.linspace(0.1, 0.1 + 2 * np.pi, 400)
    eight = np.sin(2 * t) + 1j * np.sin(t)
    resting = np.append(eight, eight[-1] + 1e-12 * np.exp(7j * t))
    assert list(_pairs(resting, False)) == list(_pairs(eight, False)) != []


def test_a_link_that_only_translates_has_no_angular_acceleration_though_rounding_grows_towards_a_dead_point() -> None:
    """plate-two-slides printed "α_2 has a peak of −6·10⁻⁹ rad/s²", and spent four fifths of its time on it."""
    found = extremes(cycle(load("plate-two-slides"), n=37), "alpha_2")
    assert found.is_constant and found.highest is not None and found.highest.value == 0.0
