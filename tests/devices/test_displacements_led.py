"""The curve of a displacement diagram is that of its law between the stations, too, and not at the stations alone."""

from __future__ import annotations

import numpy as np
import pytest

from tests.drawn_library import LIBRARY, drawn, given
from tests.each import Later, each
from vecpoly.board.construction import Figure
from vecpoly.board.paper.marks import Curve
from vecpoly.devices.cams.cam import Cam
from vecpoly.devices.cams.motion import Law, Piece
from vecpoly.methods.devices.cam.diagram import place_of

NEAR = 0.08  # mm


def _share(piece: Piece, u: float) -> float:
    """Which part of its lift a piece has risen after this part of its angle."""
    match piece.law:
        case None | Law.UNIFORM:
            return u
        case Law.PARABOLIC:
            return 2 * u**2 if u < 0.5 else 1 - 2 * (1 - u) ** 2
        case Law.COSINE:
            return float(1 - np.cos(np.pi * u)) / 2
        case Law.SINE:
            return float(u - np.sin(2 * np.pi * u) / (2 * np.pi))
        case Law.POLYNOMIAL:
            return 10 * u**3 - 15 * u**4 + 6 * u**5


def _figures(name: str) -> list[Figure]:
    cam = given(name).subject
    return [one for one in drawn(name).construction.figures if isinstance(cam, Cam) and one.view is place_of(cam)]


@each(Later(lambda: [name for name in LIBRARY if isinstance(given(name).subject, Cam) and _figures(name)]))
def test_a_displacement_is_drawn_between_its_stations_as_the_law_has_it(name: str) -> None:
    cam = given(name).subject
    assert isinstance(cam, Cam)
    (figure,) = _figures(name)
    curves = [np.array(mark.points) for mark in figure.marks if isinstance(mark, Curve)]
    assert len(curves) == len(cam.pieces) and figure.scale.right is not None
    for piece, curve in zip(cam.pieces, curves, strict=True):
        us = (curve.real * figure.scale.right.value - piece.start) / piece.angle
        risen = [_share(piece, u if piece.rises >= 0 else 1 - u) for u in np.clip(us, 0.0, 1.0).tolist()]
        exact = (piece.low + piece.lift * np.array(risen)) / figure.scale.value
        assert curve.imag == pytest.approx(exact, abs=NEAR), piece
