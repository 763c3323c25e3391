"""How two profiles slide at their contact is told as it is, and how it is found."""

from __future__ import annotations

import re

import numpy as np
import pytest

from tests.drawn_library import drawn
from tests.each import each
from vecpoly import oracle
from vecpoly.plane import nominal

SAID = re.compile(
    r"\$v_\{(?P<at>[A-Z])(?P<on>\d)(?P=at)(?P<by>\d)\}\$ = [^;]* is (?P<size>[\d.]+) m/s along the common tangent, "
    r"(?P<way>to the left|to the right|upwards|downwards)\."
)
WAYS = {"to the right": 1, "to the left": -1, "upwards": 1j, "downwards": -1j}
RUBBING = ("4-4", "4-5", "4-5-circles", "4-7", "cam-face-load", "cam-knife-load")


@each(RUBBING)
def test_the_sliding_at_a_contact_is_told_with_its_size_and_its_way(name: str) -> None:
    here = drawn(name)
    (said,) = (found for step in here.construction.steps if (found := SAID.search(step.words.en)))
    assert here.desk is not None
    (contact,) = (one for one in here.desk.mech.contacts if one.point == said["at"])
    motion = oracle.solve(here.problem.mechanism)
    place = np.array([complex(nominal(here.desk.contact_of(contact))) / here.desk.mm(1.0)])
    on, by = (motion.moving(said[link]).velocity_at(place)[0] for link in ("on", "by"))
    slip = complex(on - by)
    assert float(said["size"]) == pytest.approx(abs(slip), rel=6e-3)
    assert (np.conj(WAYS[said["way"]]) * slip).real > abs(slip) * 0.7


def test_of_a_flat_face_it_is_not_the_sliding_of_the_substitute() -> None:
    """v_K2K1 is 0.086 m/s to the left; by v_T1 = ω_1 l_OT, 56.17 mm under the face, v_T2T1 = 0.562 m/s to the right."""
    (said,) = (words for step in drawn("cam-face-load").construction.steps if SAID.search(words := step.words.en))
    assert "is 0.562 m/s along the common tangent, to the right" in said and "velocity polygon" not in said
