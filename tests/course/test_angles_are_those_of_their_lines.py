"""The table of angles names for each link two points only where the line through them has that angle."""

from __future__ import annotations

import re
from cmath import phase
from math import degrees

import pytest

from tests.course.test_course_numbers import Recorder
from tests.studies import studied
from vecpoly.report.course.modelling.axes import _table

NAMED = re.compile(r"\$([A-Z])→([A-Z])\$")


def rows(name: str) -> list[tuple[str, ...]]:
    press = Recorder()
    _table(studied(name), press)
    return press.lines


@pytest.mark.parametrize("name", ["3-8", "3-9", "3-10", "guided-couple", "swinging-block-offset-rod", "4-5"])
def test_the_line_through_the_two_points_named_has_the_angle_printed(name: str) -> None:
    at = studied(name).at
    told = [(found, row[-1]) for row in rows(name) if (found := NAMED.fullmatch(row[2]))]
    assert told
    for found, angle in told:
        line = degrees(phase(at[found[2]] - at[found[1]]))
        printed = float(angle.rstrip("°").replace("−", "-"))
        assert abs((line - printed + 180) % 360 - 180) < 0.01


@pytest.mark.parametrize(("name", "link"), [("3-8", "3"), ("guided-couple", "3")])
def test_a_slotted_link_whose_second_point_lies_beside_the_slot_has_the_angle_of_the_slot(name: str, link: str) -> None:
    [ray] = [row[2] for row in rows(name) if row[0] == link]
    assert ray.startswith("its own slideway")
