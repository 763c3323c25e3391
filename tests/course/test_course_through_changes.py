"""Where rates run away in the cycle, at a change point, the course report tells numbers, or ∞: no inf and no nan."""

from __future__ import annotations

import re
from contextlib import closing

from pypdfium2 import PdfDocument

from tests.studies import in_small
from vecpoly import loads, solve
from vecpoly.algebra.quantity import number
from vecpoly.report.document import report_bytes

ANTIPARALLELOGRAM = """
id: change-points
title: change points
frame: {A: [0 mm, 0 mm], D: [116 mm, 0 mm]}
links:
  1: {AB: 53 mm}
  2: {BC: 116 mm, E: {along: BC, at: 22 mm, left: -8 mm}}
  3: {DC: 53 mm}
input: {link: 1, phi: 120 deg, omega: -5 rad/s}
branch: [ABCD antiparallelogram]
find: [v_C, a_C, v_E, a_E, omega_2, omega_3, alpha_2, alpha_3]
"""


def printed() -> str:
    """The words of its pages, the lettering of its curves too."""
    with in_small(blank=False):
        written = report_bytes([solve(loads(ANTIPARALLELOGRAM), repeats=0)], lang="en", style="course")
    with closing(PdfDocument(written)) as document:
        return " ".join(page.get_textpage().get_text_range() for page in document)


def test_a_course_report_through_a_change_point_tells_numbers() -> None:
    text = printed()
    assert "at a change point" in " ".join(text.split())  # once, where the transmission angle is told
    assert not re.search(r"\b(inf|nan)\b", text)


def test_what_is_infinite_is_written_as_a_hand_writes_it() -> None:
    assert (number(float("inf")), number(-float("inf"))) == ("∞", "−∞")
