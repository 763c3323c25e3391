"""A reading that is quite wrong leads to an answer with the alarm beside it, and to no warning of arithmetic."""

from __future__ import annotations

import warnings
from textwrap import dedent

from vecpoly import loads, solve
from vecpoly.board.acts import Measure

TRAIN = """
    id: train
    title: t
    frame: {A: [0 mm, 0 mm], B: [31.44 mm, 6.19 mm], F: [34.03 mm, 37.29 mm]}
    links: {1: {gear: A, radius: 25.13 mm}, 2: {gear: B, radius: 57.17 mm}, 5: {gear: F, radius: 25.355 mm}}
    joints: [1 rolls inside 2 at D, 5 rolls on 1 at G]
    input: {link: 1, phi: 40 deg, omega: 4 rad/s cw}
    method: centres
    find: [omega_1, omega_2, omega_5]
"""


def test_a_distance_read_as_nothing_raises_the_alarm() -> None:
    problem = loads(dedent(TRAIN))
    read = [
        act.key
        for act in solve(problem, repeats=0, precise=False).construction.acts
        if isinstance(act, Measure) and act.key
    ]
    assert read
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        told = [solve(problem, readings={key: 0.0}, repeats=0, precise=False) for key in dict.fromkeys(read)]
    assert any(one.suspect for one in told)
