"""A cam that is taken from another problem has its shape among what is given: a page stands alone."""

from __future__ import annotations

from vecpoly.problem.load import load


def test_the_shape_of_a_cam_is_among_what_is_given() -> None:
    told = [datum.words for datum in load("cam-moves-arm").given.data if datum.words is not None]
    (words,) = [one for one in told if "plate cam" in one.en]
    assert words.en.endswith(
        "base circle $r_0$ = 35 mm; the follower swings out 25° from 0° to "
        "120° by simple harmonic motion (cosine acceleration), dwells from 120° to 150°, swings back 25° from 150° to "
        "270° by constant acceleration and deceleration, dwells from 270° to 360°"
    )
    assert "基圆半径 $r_0$ = 35 mm" in words.zh and "120°～150° 停歇" in words.zh


def test_a_knife_edge_has_no_radius() -> None:
    assert not [datum for datum in load("cam-knife-load").given.data if datum.symbol == "r_2"]
