"""Where a path bends the other way is told by the drive's own quantity: an angle in degrees, a travel in mm."""

from __future__ import annotations

import re

import pytest

from vecpoly.cycle.facts.path import Shape, path
from vecpoly.cycle.facts.path_words import path_sentences
from vecpoly.cycle.whole_cycle import cycle
from vecpoly.foundation.slotted import replace
from vecpoly.mechanism.model import Mechanism
from vecpoly.problem.library import library
from vecpoly.problem.load import load

SLIDES = [
    one.id
    for one in library()
    if isinstance(mech := load(one.id).subject, Mechanism) and mech.drive.slide and not mech.drive.between
]


@pytest.mark.parametrize(("name", "unit"), [("3-5", "°"), *((name, " mm") for name in SLIDES[:2])])
def test_a_point_of_inflection_is_told_where_the_drive_stands_there(name: str, unit: str) -> None:
    turn = cycle(load(name))
    point = next(column.key[2:] for column in turn.columns if column.key.startswith("p_"))
    at = float(turn.phi[len(turn.phi) // 3])
    bent = replace(
        path(turn, point), shape=Shape.CURVE, once=None, turning=1, crossings=(), cusps=(), inflections=(at,)
    )
    *_, said = path_sentences(turn, replace(bent, length=1.0))
    assert (found := re.search(r"of inflection \(\$.+\$ = (−?[\d.]+)(.+?)\)", said.en)) is not None
    told = float(turn.drive.told(at))
    assert found[2] == unit and float(found[1].replace("−", "-")) == pytest.approx(told, rel=1e-3, abs=0.06)
    assert f"= {found[1]}{unit}）" in said.zh
