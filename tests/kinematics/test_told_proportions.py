"""A drive between two moving links is found by proportion: who has the numbers that are told can reckon it again."""

from __future__ import annotations

import re

import pytest

from tests.drawn_library import drawn
from tests.each import Later, each
from vecpoly.mechanism.model import FRAME, Mechanism
from vecpoly.problem.library import library
from vecpoly.problem.load import load

NUMBER = r"([−-]?[\d.]+(?:e[−-]?\d+)?)"
TOLD = re.compile(
    rf"得输入的加速度为 {NUMBER} m/s²，实际为 {NUMBER} m/s²；.*每 1 \S+ 得 {NUMBER} m/s².*故 .* = {NUMBER} rad/s²"
)


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
