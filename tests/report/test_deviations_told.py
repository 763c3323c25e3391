"""How far a drawn value is off, as it stands beside the exact one."""

from __future__ import annotations

import vecpoly
from vecpoly.report.answers.tables import deviation_told

NEARLY_STILL = """
id: t
title: t
frame: {A: [0 mm, 0 mm], D: [80 mm, 0 mm]}
links: {1: {AB: 30 mm}, 2: {BC: 70 mm}, 3: {DC: 60 mm}, 4: {CE: 90 mm}, 5: {block: E}}
joints: [5 slides on y = 20 mm]
input: {link: 1, phi: 40 deg, omega: 10 rad/s ccw}
branch: [C left of BD, E right of C]
find: [v_E, omega_4]
"""


def test_what_is_so_small_that_it_stands_there_as_0_is_off_by_no_per_cent() -> None:
    """Link 4 turns at 0.0005 rad/s, which the drawing does not tell: the report ended in a division by 0."""
    solution = vecpoly.loads(NEARLY_STILL).solve()
    slow, quick = solution.answers["omega_4"], solution.answers["v_E"]
    assert 0 < abs(slow.exact) < 1e-3
    assert slow.drawn == 0
    assert deviation_told(slow) == "—"
    assert abs(float(deviation_told(quick).replace("−", "-"))) < 5
