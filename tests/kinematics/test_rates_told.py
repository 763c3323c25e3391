"""How the turning of a link is found can be followed: a proportion has its numbers, and a vector is placed at a point
that moves, not at the pivot about which the link turns."""

from __future__ import annotations

import re

import pytest

from tests.drawn_library import IDS, drawn
from tests.each import Later, each
from vecpoly.mechanism.model import FRAME, Mechanism
from vecpoly.problem.library import library
from vecpoly.problem.load import load

NUMBER = r"([−-]?[\d.]+(?:e[−-]?\d+)?)"
TOLD = re.compile(
    rf"得输入的加速度为 {NUMBER} m/s²，实际为 {NUMBER} m/s²；.*每 1 \S+ 得 {NUMBER} m/s².*故 .* = {NUMBER} rad/s²"
)
PLACED = re.compile(r"将 \$[va](?:\^t)?_\{?(\w)(\d*)\w*\}?\$ 移至 \$(\w)\$ 点")


def exchanged() -> list[str]:
    """Problems whose input acts between moving links, of the library."""
    found = {one.id: load(one.id).subject for one in library()}
    return [name for name, one in found.items() if isinstance(one, Mechanism) and one.drive.on != FRAME]


def value(text: str) -> float:
    return float(text.replace("−", "-"))


@each(Later(exchanged))
def test_the_acceleration_of_the_link_thought_to_drive_follows_from_the_numbers_beside_it(name: str) -> None:
    steps = [step.words.zh for step in drawn(name).construction.steps if "试作加速度多边形" in step.words.zh]
    for text in steps:
        met = TOLD.search(text)
        assert met is not None, text
        trial, given, factor, found = map(value, met.groups())
        assert found == pytest.approx((given - trial) / factor, rel=2e-3, abs=1e-9), text
    assert steps or name != "scissor-lift", "others lay the cylinder's rate off itself"


@each(tuple(dict.fromkeys((*IDS, "geared-five-bar", "rack-drives-pinion", "ring-output", "winch-gears"))))
def test_a_vector_that_tells_a_turning_is_placed_at_a_moving_point_which_is_its_own(name: str) -> None:
    """v_DH was moved to the fixed pivot D: a point of the frame it may be only where it is one of a moving link."""
    subject = drawn(name).problem.subject
    pivots = set(subject.frame) if isinstance(subject, Mechanism) else set()
    for step in drawn(name).construction.steps:
        for of, link, at in PLACED.findall(step.words.zh):
            assert of == at and (at not in pivots or link), step.words.zh
