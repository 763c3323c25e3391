"""The inversion as it goes: the cam stands, and its follower walks round it from station to station."""

from __future__ import annotations

from collections.abc import Sequence
from math import degrees

from ....board.board import Board
from ....board.construction import Figure, View
from ....board.hand import hand
from ....board.paper.marks import Dot, Role
from ....devices.cams.cam import Cam
from ....diagram.cams.plate import cam_pivot
from ....plane import nominal
from ....problem.problem import Problem
from ....words import Words
from ..bench import trial_board
from .diagram import place_of
from .inversion import draw_follower
from .laws import lift
from .pose import pose
from .scales import cam_scales
from .trying import Spots, outlined

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
    outline = outlined(Board(hand("exact"), scales), cam, EVERY)
    return tuple(_station(Board(hand("exact"), scales), cam, number, outline) for number in range(len(cam.places)))


def _station(board: Board, cam: Cam, number: int, outline: Sequence[Spots]) -> Figure:
    assert cam.r0
    (phi, piece), view = cam.places[number], View.MECHANISM
    board.step(CALLED, view)
    mm = board.scale_of(view).value
    board.circle(view, 0j, cam.r0.si / mm, Role.CENTRE)
    board.depict(view, *cam_pivot(0j, -cam.sense, "−ω"))
    for edge in outline:
        board.curve(view, [complex(spot) / mm for spot in edge], Role.LINK)
    it = pose(board, view, cam, phi, lift(trial_board(board), place_of(cam), piece, phi))
    draw_follower(board, cam, it)
    touch = complex(nominal(it.touch(cam, mm)))
    board.join(view, it.sighted, touch + (PAST + cam.follower.radius / mm) * it.outward(cam), Role.DIRECTION)
    board.plot(view, touch, "T", Dot.POINT)
    (figure,) = board.figures({view: CALLED})
    return figure
