"""The oracle gives the numbers of the book's exercises and of the reports, to 1e-9 of the case's size."""

from __future__ import annotations

import numpy as np
import pytest

from tests.oracle.test_oracle_models import (
    MM,
    a16,
    a26,
    a27,
    b_sixbar,
    conveyor,
    fourbar,
    geared,
    hay_press,
    peaucellier,
    rocker,
    sine,
    sloped_slot,
    swinging_block,
)
from tests.oracle.test_oracle_numbers import EXPECTED, TABLES
from vecpoly.mechanism.model import Mechanism
from vecpoly.names import parse_rel
from vecpoly.oracle import solve

MECHANISMS: dict[str, Mechanism] = {
    "3-4a generic": peaucellier(0.05, 0.07, 0.15, 0.062, 0.14, 0.078, 0.066, -0.085 - 0.01j, 62.0),
    "3-4a exact": peaucellier(0.05, 0.06, 0.15, 0.06, 0.15, 0.06, 0.06, -0.05, 41.0),
    "3-5 400": hay_press(0.4),
    "3-5 600": hay_press(0.6),
    "3-6": fourbar(0.04, 0.1, 0.08, 0.11, (68.0, 10.0)),
    "3-7a": rocker(0.05, -0.11j, 72.0, 10.0),
    "3-7b": rocker(0.05, -0.11j, -27.03569178941229, 10.0),
    "3-7c": rocker(0.05, -0.11j, 90.0, 10.0),
    "3-7d": sine(0.05, 33.0, 10.0),
    "3-7e": swinging_block(0.04, -0.095, 64.0, 10.0),
    "3-9": swinging_block(0.03, -0.1, 45.0, -10.0, D=0.05, E=0.05 + 0.04j),
    "3-10": rocker(0.045, 0.115 - 0.02j, 63.0, 12.0, 0.025),
    "3-13": geared(),
    "3-14": sloped_slot(0.4, 45.0, 100.0, 60.0),
}


@pytest.mark.parametrize("case", MECHANISMS)
def test_every_vector_of_the_exercise_comes_out(case: str) -> None:
    motion = solve(MECHANISMS[case])
    expected = EXPECTED[case]
    for key, value in expected.items():
        stem = key[0]
        size = max(abs(v) for k, v in expected.items() if k[0] == stem)
        assert abs(motion.value(parse_rel(key)) - value) <= 1e-9 * max(size, 1e-6), key


def test_image_point_of_the_coupler_has_its_velocity() -> None:
    """3-4b: the four-bar's letters there are A B D E with the coupler point C."""
    motion = solve(fourbar(0.045, 0.12, 0.085, 0.13 - 0.015j, (118.0, 8.0), P=0.08 + 0.05j))
    expected = EXPECTED["3-4b"]
    here = {
        "v_B": "v_B",
        "v_D": "v_C",
        "v_DB": "v_CB",
        "v_C": "v_P",
        "v_CB": "v_PB",
        "p_D": "p_C",
        "p_C": "p_P",
        "omega_2": "omega_2",
        "omega_3": "omega_3",
    }
    for book, ours in here.items():
        assert motion.value(parse_rel(ours)) == pytest.approx(expected[book], rel=1e-9)


def test_points_with_a_given_velocity_or_acceleration() -> None:
    """3-6: X1 X2 X3 have v_x; M2 has no velocity, Q2 no acceleration."""
    motion = solve(MECHANISMS["3-6"])
    points = [0.014 + 0.025j, 0.020319230263909666 + 0.10260397088564441j, 0.14829850789567423 + 0.06839019267084681j]
    for link, point in zip("123", points, strict=True):
        assert abs(motion.point_with(link, velocity=-0.25 + 0.14j) - point) < 1e-12
    assert abs(motion.velocity_pole("2") - (0.09620288685077225 + 0.23811050050504187j)) < 1e-12
    assert abs(motion.acceleration_pole("2") - (0.13574135383411745 - 0.029106125725953343j)) < 1e-12


def test_coriolis_vanishes_only_where_the_rocker_rests_or_the_slider_rests() -> None:
    ak = parse_rel("ak_B3B2")
    assert abs(solve(MECHANISMS["3-7a"]).value(ak)) == pytest.approx(0.6623481712126161, rel=1e-9)
    for case in ("3-7b", "3-7c", "3-7d"):
        assert abs(solve(MECHANISMS[case]).value(ak)) < 1e-12
    assert abs(solve(MECHANISMS["3-7e"]).value(parse_rel("ak_C2C3"))) == pytest.approx(1.3529891905317293, rel=1e-9)


def test_gear_ratio_of_3_13_holds_at_the_pitch_points() -> None:
    motion = solve(geared())
    assert abs(motion.velocity("D")) < 1e-15
    assert abs(motion.value(parse_rel("v_H3")) - motion.value(parse_rel("v_H4"))) < 1e-15


TABLED = {
    "p26": a26(),
    "p27_prog": a27(),
    "p27_stmt": a27(25.0),
    "s001_B": b_sixbar(),
    "s003_40rpm": conveyor(),
    "p16": a16(),
}


@pytest.mark.parametrize("case", TABLES)
def test_report_table_comes_out_over_the_cycle(case: str) -> None:
    rows = TABLES[case]
    motion = solve(TABLED[case], np.radians(list(rows)))
    for name in next(iter(rows.values())):
        table = np.array([row[name] for row in rows.values()])
        if len(table[0]) == 3:
            got = np.stack([motion.angle(name), motion.omega(name), motion.alpha(name)], axis=1)
            got[:, 0] += 2 * np.pi * np.round((table[:, 0] - got[:, 0]) / (2 * np.pi))
        else:
            points = (motion.position(name), motion.velocity(name), motion.acceleration(name))
            got = np.stack([part for z in points for part in (z.real, z.imag)], axis=1) / MM
        assert (np.abs(got - table) <= 1e-9 * np.abs(table).max(axis=0)).all(), name
