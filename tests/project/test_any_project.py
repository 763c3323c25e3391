"""Any design project of this kind is solved, or refused at its line: K, stroke, offset, position, loads, a cam."""

from __future__ import annotations

from math import tau
from pathlib import Path

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from tests.laws import often
from vecpoly.devices.cams.cam import Cam
from vecpoly.errors import ProblemFileError
from vecpoly.project.project import load_project

WRITTEN = """\
title: A feeder
statement: Find it.
parts:
  linkage:
    title: The linkage
    synthesis: slider-crank
    data: {{K: {advance:.3g}, H: {stroke} mm, e: <{part:.2f} * {stroke} mm>}}
    find: [theta, AB, BC, gamma_min]
  motion:
    title: Its motion
    of: linkage
    round: {step} mm
    input: {{phi: {phi} deg, omega: 2 rad/s {sense}}}
    works: {{load: F_r, from: {start} %}}
    loads:
      F_r: {{on: 3, at: C, size: 600 N, direction: {way} deg, role: resisting}}
      M_1: {{on: 1, size: "?", role: driving}}
    find: [v_C, M_1]
  cam:
    title: Its cam
    device: cam
    data:
      follower: {{roller: 8 mm}}
      r0: <linkage.AB / 2>
      motion: [rise 20 mm in <(180 deg - linkage.theta) / 2> cosine, return in <90 deg - linkage.theta / 2> sine,
               dwell <180 deg + linkage.theta>]
    find: [alpha_max]
demands:
  - motion.K = {advance:.3g} within 5 %
  - motion.stroke = {stroke} mm within 2 %
"""


@given(
    advance=st.floats(1.05, 1.6),
    stroke=st.integers(40, 400),
    part=st.floats(0.15, 0.6),
    step=st.sampled_from(["0.05", "0.1"]),
    phi=st.integers(0, 359),
    sense=st.sampled_from(["cw", "ccw"]),
    start=st.integers(0, 60),
    way=st.sampled_from([0, 180]),
)
@settings(max_examples=often(6, 120))
def test_a_project_is_solved_and_meets_what_it_was_designed_for_or_is_refused_at_its_line(
    tmp_path_factory: pytest.TempPathFactory, **data: object
) -> None:
    path: Path = tmp_path_factory.mktemp("project") / "feeder.yaml"
    path.write_text(WRITTEN.format(**data), encoding="utf-8")
    try:
        found = load_project(path)
    except ProblemFileError as refused:
        assert all(one.place is not None and one.place.line > 1 for one in refused.faults)
        return
    assert all(one.holds for one in found.demands), [str(one.say.en) for one in found.demands if not one.holds]
    cam = found.parts[-1].problem.device
    assert isinstance(cam, Cam) and cam.pieces[-1].end == tau
