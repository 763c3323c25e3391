"""The transmission angle of a dyad over the cycle: told where it changes, the same however the mechanism lies."""

from __future__ import annotations

from cmath import rect
from math import degrees

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from tests.laws import often
from vecpoly.cycle import cycle
from vecpoly.cycle.columns import dyads
from vecpoly.cycle.facts.transmission import is_told
from vecpoly.mechanism.model import Mechanism
from vecpoly.problem.load import load, loads

SLOTTED = """
id: slotted
title: a rod through a block that swings, a bar that a block leads
frame: {{A: [0 mm, 0 mm], C: [-100 mm, 0 mm]}}
links: {{1: {{AB: 30 mm}}, 2: {guide}, 3: {{block: {pin}{point}}}}}
joints: [{joint}{beside}]
input: {{link: 1, phi: 45 deg, omega: 10 rad/s cw}}
find: [omega_2]
"""
ROD = {"guide": "{rod: B}", "pin": "C", "joint": "2 passes through 3"}
BAR = {"guide": "{slot: C}", "pin": "B", "joint": "3 slides in 2"}
ARMED = """
id: armed
title: a bar that an arm of its block leads
frame: {{A: [0 mm, 0 mm], C: [-100 mm, 0 mm]}}
links: {{1: {{AG: 30 mm}}, 2: {{slot: C}}, 3: {{block: B, G: {{BG: 20 mm, angle: {angle} deg from line}}}}}}
joints: [3 slides in 2 with B 20 mm {side}]
input: {{link: 1, phi: 45 deg, omega: 10 rad/s cw}}
find: [omega_2]
"""
SLIDER = """
id: slider
title: a slider-crank on a guide that leans
frame: {{A: [0 mm, 0 mm], D: [{x} mm, {y} mm]}}
links: {{1: {{AB: 50 mm}}, 2: {{BC: 200 mm}}, 3: {{block: C}}}}
joints: [3 slides on line through D at {way} deg]
input: {{link: 1, phi: {phi} deg, omega: 10 rad/s}}
guesses: {{C: [{cx} mm, {cy} mm]}}
find: [v_C]
"""


def slotted() -> list[Mechanism]:
    """With and without another point of the block, and a line beside the pin; an arm that brings the pin back."""
    armed = [ARMED.format(angle=angle, side=side) for angle in (90, -90, 30) for side in ("left", "right")]
    return [
        *(loads(text).mechanism for text in armed),
        *(
            loads(SLOTTED.format(**form, point=point, beside=beside)).mechanism
            for form in (ROD, BAR)
            for point in ("", f", G: {{{form['pin']}G: 40 mm, angle: 60 deg from line}}")
            for beside in ("", " with B 20 mm left")
        ),
    ]


def test_the_angle_of_a_dyad_with_a_slot_is_told_exactly_where_it_changes() -> None:
    told = []
    for mech in (*slotted(), *(load(name).mechanism for name in ("3-9", "3-10", "4-5", "swinging-block-offset-rod"))):
        for name, dyad in dyads(mech).items():
            if dyad.kind == "RPR":
                gamma = np.asarray(cycle(mech, 13).column(f"gamma_{name}"))
                assert is_told(mech, dyad) is bool(np.ptp(gamma) > 1e-9), (name, mech.links)
                told.append(is_told(mech, dyad))
    assert told.count(False) >= 7 and told.count(True) >= 9


def slider(way: float, offset: float) -> Mechanism:
    """Turned by an angle (rad) as a whole."""
    foot, near = rect(1.0, way) * 1j * offset, rect(220.0, way)
    place = {"x": foot.real, "y": foot.imag, "cx": near.real, "cy": near.imag}
    return loads(SLIDER.format(way=degrees(way), phi=40 + degrees(way), **place)).mechanism


@settings(max_examples=often(8))
@given(st.floats(-3.0, 3.0), st.floats(-40, 40))
def test_the_angle_of_a_slider_is_the_same_whichever_way_the_mechanism_lies(way: float, offset: float) -> None:
    phi = np.linspace(0.3, 5.9, 7)
    angles = (np.asarray(cycle(slider(turn, offset), over=phi + turn).column("gamma_23")) for turn in (0.0, way))
    assert next(angles) == pytest.approx(next(angles), abs=1e-9)
