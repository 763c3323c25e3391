"""The profile of a cam for other programs: every point where the oracle has it, each file with its tolerance."""

from __future__ import annotations

import csv
import io
import re
from math import radians

import numpy as np
import pytest
from ezdxf import document as drawing

from tests.laws import few
from vecpoly.devices.cams.cam import Cam
from vecpoly.errors import NoMethodError
from vecpoly.export.cams.drawing import cam_dxf, tolerance
from vecpoly.export.cams.profile import profile_of
from vecpoly.export.cams.table import cam_csv
from vecpoly.foundation.slotted import replace
from vecpoly.oracle.devices.cams.shape import profile
from vecpoly.problem.load import load, loads

CAMS = ("cam-roller-offset", "cam-flat-face", "cam-flat-arm", "cam-rocker", "cam-heart")
PARABOLIC = """
id: s
title: a rise that is no even number of degrees
device: cam
data:
  follower: {{roller: 10 mm}}
  r0: 50 mm
  motion: [rise 30 mm in {rise} deg parabolic, dwell {rest} deg, return in 120 deg cosine, dwell 60 deg]
"""


@pytest.mark.parametrize("name", CAMS)
def test_every_point_of_the_table_lies_on_the_exact_profile(name: str) -> None:
    problem = load(name)
    cam = problem.subject
    assert isinstance(cam, Cam)
    told, *lines = cam_csv(profile_of(problem)).decode().splitlines()
    rows = [[float(cell) for cell in row] for row in list(csv.reader(io.StringIO("\n".join(lines))))[1:]]
    assert len(rows) > 355 and rows[0][0] == 0 and rows[-1][0] == 360
    for phi, x, y, *_ in rows[::7]:
        pieces = [piece for piece in cam.pieces if piece.start - 1e-9 <= radians(phi) <= piece.end + 1e-9]
        exact = [1e3 * complex(profile(cam, piece, np.array([radians(phi)]))[0]) for piece in pieces]
        assert min(abs(complex(x, y) - spot) for spot in exact) < 2e-6
    found = re.search(r"by ([\d.]+) mm", told)
    assert found and 0 < float(found[1]) < 0.02


@pytest.mark.parametrize("name", few(CAMS, 2))
def test_the_splines_close_and_keep_their_tolerance(name: str) -> None:
    made = profile_of(load(name))
    doc = drawing.Drawing.read(io.StringIO(cam_dxf(made).decode()))
    assert doc.units == 4 and not doc.audit().errors
    splines = list(doc.modelspace().query("SPLINE"))
    assert len(splines) == len(made.stretches)
    joined = list(doc.modelspace().query("LINE"))
    ends = [(s.construction_tool().control_points[0], s.construction_tool().control_points[-1]) for s in splines]
    gaps = [a.distance(b) for (_, a), (b, _) in zip(ends, [*ends[1:], ends[0]], strict=True)]
    assert sum(gap > 1e-6 for gap in gaps) == len(joined)
    assert 0 < tolerance(made) < 1e-3
    (told,) = doc.modelspace().query("TEXT")
    assert f"{tolerance(made):.6f} mm" in told.dxf.text


@pytest.mark.parametrize("rise", [75, 76])
def test_the_tolerance_of_the_chords_is_measured_halfway_between_the_points(rise: int) -> None:
    problem = loads(PARABOLIC.format(rise=rise, rest=180 - rise))
    cam, made = problem.subject, profile_of(problem)
    assert isinstance(cam, Cam)
    most = 0.0
    for part, fine in zip(made.stretches, made.between, strict=True):
        halfway = (part.phi[:-1] + part.phi[1:]) / 2
        np.testing.assert_allclose(fine.phi[1::2], halfway, rtol=0, atol=1e-12)
        (piece,) = [one for one in cam.pieces if one.start <= halfway[0] <= one.end]
        exact = 1e3 * profile(cam, piece, halfway)
        most = max(most, float(np.abs(exact - (part.edge[:-1] + part.edge[1:]) / 2).max()))
    assert made.chords == pytest.approx(most, abs=2e-6)


@pytest.mark.parametrize("name", ["cam-undercut", "cam-least-circle", "3-9", "5-5"])
def test_what_has_no_profile_that_can_be_made_is_refused(name: str) -> None:
    with pytest.raises(NoMethodError, match=r"undercut|only a cam"):
        profile_of(load(name))


@pytest.mark.parametrize(
    ("name", "flat", "zh"), [("cam-flat-face", True, "加大 r0"), ("cam-undercut", False, "减小滚子")]
)
def test_a_face_has_no_roller_that_might_be_smaller(name: str, flat: bool, zh: str) -> None:
    """The remedy of an undercut profile is one for its follower."""
    text = load(name).text
    r0 = re.search(r"r0: (\d+) mm", text)
    assert r0 is not None
    small = text.replace(r0[0], "r0: 5 mm") if flat else text
    with pytest.raises(NoMethodError, match="undercut") as refused:
        profile_of(loads(small))
    assert zh in refused.value.words.zh and ("roller" in refused.value.words.en) is not flat


@pytest.mark.parametrize("name", CAMS)
def test_no_point_of_the_drawing_stands_there_twice(name: str) -> None:
    """Where two stretches meet there was a second one."""
    space = drawing.Drawing.read(io.StringIO(cam_dxf(profile_of(load(name))).decode())).modelspace()
    spots = [complex(one.dxf.location.x, one.dxf.location.y) for one in space.query("POINT")]
    assert len(spots) > 355
    assert min(abs(spot - before) for spot, before in zip(spots, [spots[-1], *spots], strict=False)) > 1e-6


@pytest.mark.parametrize("at", [1, 31])
def test_the_tolerance_is_told_for_the_point_that_its_spline_passes_farthest(at: int) -> None:
    made = profile_of(load("cam-roller-offset"))
    for n, fine in enumerate(made.between):
        edge = fine.edge.copy()
        edge[at] *= 1 + 0.2 / abs(edge[at])  # mm, outwards
        off = replace(made, between=(*made.between[:n], replace(fine, edge=edge), *made.between[n + 1 :]))
        assert 0.15 < tolerance(off) < 0.201
