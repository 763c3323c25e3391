"""The inversion as it goes: the cam stands, and its follower walks round it from station to station."""

from __future__ import annotations

from collections.abc import Sequence
from math import ceil, degrees

import numpy as np

from ....board.board import Board
from ....board.construction import Figure, View
from ....board.hand import hand
from ....board.paper.marks import Dot, Role
from ....devices.cams.cam import Cam
from ....diagram.cam_plate import arm, cam_pivot, face_arm, stem
from ....problem.problem import Problem
from ....words import Words
from .diagram import place_of
from .inversion import FACE, along_face
from .laws import lift
from .pose import Pose, pose
from .scales import cam_scales
from .trying import traced

EVERY = 3.0  # deg of the cam between two points of its outline
PAST = 8.0  # mm: the normal runs on beyond the follower
CALLED = Words("反转：凸轮不动，从动件绕行", "Inversion: the cam stands, the follower walks round it")


def stations_walked(problem: Problem) -> Sequence[float]:
    """The angles of the stations (deg); none where no cam is drawn by inversion."""
    cam = problem.subject
    if not isinstance(cam, Cam) or cam.r0 is None:
        return ()
    return [round(degrees(phi), 6) for phi, _ in cam.places]


def walked(problem: Problem) -> tuple[Figure, ...]:
    """The cam's figure with the follower at each station, by the exact hand; alike but for the follower."""
    cam = problem.subject
    assert isinstance(cam, Cam)
    scales = cam_scales(cam, problem.scales)
    paper = Board(hand("exact"), scales)
    outline = [part.edge for part in traced(paper, cam, [max(ceil(degrees(p.angle) / EVERY), 4) for p in cam.pieces])]
    return tuple(_station(Board(hand("exact"), scales), cam, number, outline) for number in range(len(cam.places)))


def _station(
    board: Board, cam: Cam, number: int, outline: Sequence[np.ndarray[tuple[int], np.dtype[np.complex128]]]
) -> Figure:
    assert cam.r0
    (phi, piece), view = cam.places[number], View.MECHANISM
    board.step(CALLED, view)
    mm = board.scale_of(view).value
    board.circle(view, 0j, cam.r0.si / mm, Role.CENTRE)
    board.depict(view, *cam_pivot(0j, -cam.sense, "−ω"))
    for edge in outline:
        board.curve(view, [complex(spot) / mm for spot in edge], Role.LINK)
    scratch = board.scratch()
    scratch.step(CALLED)
    it = pose(board, view, cam, phi, lift(scratch, place_of(cam), piece, phi))
    touch = _follower(board, cam, it)
    board.join(view, it.pole, touch + (PAST + cam.follower.radius / mm) * it.outward(cam), Role.DIRECTION)
    board.plot(view, touch, "T", Dot.POINT)
    (figure,) = board.figures({view: CALLED})
    return figure


def _follower(board: Board, cam: Cam, it: Pose) -> complex:
    """The follower, and where it touches."""
    view, mm = View.MECHANISM, board.scale_of(View.MECHANISM).value
    radius = cam.follower.radius / mm
    if cam.arm and cam.follower.flat:
        board.depict(view, *face_arm(it.start, it.b, along_face(cam, it, mm)))
    elif cam.arm:
        board.depict(view, *arm(it.start, it.b, radius))
    else:
        assert cam.r0
        board.depict(view, *stem(it.b, it.way, radius, FACE * cam.r0.si / mm if cam.follower.flat else 0.0))
    touch = it.foot if cam.follower.flat else it.b + radius * it.normal
    return complex(np.asarray(touch).ravel()[0])
