"""Higher pairs with a flat face, replaced by a link that slides along the face."""

from __future__ import annotations

import cmath
from math import radians

import pytest

from vecpoly import loads
from vecpoly.devices.structure import Structure
from vecpoly.devices.structure_pairs import Form
from vecpoly.methods.devices.structure.replacement import replaced

CAM = """
id: s
title: a disc on a flat lever
device: structure
data:
  joints:
    A: R(0, 1) at (0, 0)
    K: H({one}, {other}) at ({x:.9f}, {y:.9f})
    D: R(2, 0) at (120, -15)
  drivers: [1]
"""


@pytest.mark.parametrize("degrees", range(-170, 190, 40))
@pytest.mark.parametrize("first", [True, False])
def test_the_substitute_of_a_flat_face_slides_along_it_at_any_inclination(degrees: int, first: bool) -> None:
    centre, normal = complex(8, 5), cmath.rect(1.0, radians(degrees))
    touch = centre + 30 * normal
    ends = ("1 about (8, 5)", "2 flat")
    device = loads(CAM.format(one=ends[not first], other=ends[first], x=touch.real, y=touch.imag)).subject
    assert isinstance(device, Structure)
    (made,) = replaced(device.chain, device).substitutes
    pin, slide = sorted(made.pairs, key=lambda pair: pair.form is Form.P)
    assert (pin.form, slide.form) == (Form.R, Form.P) and {made.link} == set(pin.links) & set(slide.links)
    assert abs((slide.along * normal.conjugate()).real) < 1e-6 and abs(slide.along) == pytest.approx(1)
