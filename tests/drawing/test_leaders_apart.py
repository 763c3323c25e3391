"""A leader is seen to be one: it does not run beside a line that begins at the same point."""

from __future__ import annotations

import cmath

import numpy as np
import pytest

from vecpoly.drawing.labels.about.obstacles import Obstacles
from vecpoly.drawing.labels.leading import ALONG, WITHIN, alongside
from vecpoly.drawing.labels.spots import on_leaders
from vecpoly.drawing.labels.want import Piece, Thing, Want
from vecpoly.drawing.scene import Stroke
from vecpoly.drawing.style import THIN, Hue
from vecpoly.typeset import Box

AT = 20 + 30j


def letter() -> Want:
    piece = Piece(box=Box(3.0, 2.5, 0.5, ()), dx=0.0, hue=Hue.BLACK, step=1)
    return Want(pieces=(piece,), feet=(AT,), normals=(0j,), radius=1.0, own=(AT, AT), thing=Thing.POINT)


@pytest.mark.parametrize("way", [0.0, 0.7, 2.0, -2.5])
def test_a_leader_beside_a_line_from_its_own_point_is_dear_and_no_other(way: float) -> None:
    line = (AT, AT + cmath.rect(40.0, way))
    obstacles = Obstacles.of((Stroke(points=line, width=THIN, hue=Hue.BLACK),))
    spots = on_leaders(letter())
    cost, off = alongside(letter(), obstacles, spots), np.abs(np.angle((spots.centre - AT) / cmath.rect(1.0, way)))
    assert (cost[off >= WITHIN] == 0).all() and (cost[off < WITHIN] > 0).all()
    assert cost.max() > 0.5 * ALONG


def test_a_line_that_only_passes_by_makes_no_leader_dearer() -> None:
    obstacles = Obstacles.of((Stroke(points=(AT + 5j - 20, AT + 5j + 20), width=THIN, hue=Hue.BLACK),))
    assert not alongside(letter(), obstacles, on_leaders(letter())).any()
