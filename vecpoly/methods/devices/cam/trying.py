"""The whole profile on scratch paper: against the roller in all its places, and for other programs."""

from __future__ import annotations

import numpy as np
import numpy.typing as npt

from ....board.board import Board
from ....board.construction import View
from ....devices.cams.cam import Cam
from ....devices.cams.motion import Law, Piece
from ....plane import Line, foot
from ....words import Words
from .diagram import place_of
from .laws import lift
from .pose import pose

DENSE, CLEAR = 241, 1e-5  # points a piece; m by which a point may lie inside the roller
Spots = npt.NDArray[np.complex128]


def traced(board: Board, cam: Cam, count: int = DENSE) -> tuple[tuple[Spots, Spots], ...]:
    """Of every piece so many points of the pitch curve and of the profile (m)."""
    return tuple(_piece(board, cam, piece, span) for piece in cam.pieces for span in _spans(piece, count))


def _spans(piece: Piece, count: int) -> tuple[npt.NDArray[np.float64], ...]:
    """The angles of a piece; of a parabola its halves, each drawn from its own end."""
    if piece.law is not Law.PARABOLIC:
        return (np.linspace(piece.start, piece.end, count),)
    middle = piece.start + piece.angle / 2
    return np.linspace(piece.start, middle, count // 2 + 1), np.linspace(middle, piece.end, count // 2 + 1)


def _piece(board: Board, cam: Cam, piece: Piece, phi: npt.NDArray[np.float64]) -> tuple[Spots, Spots]:
    trial, mm = board.scratch(), board.scale_of(View.MECHANISM).value
    trial.step(Words("试作", "trial"))
    middle = piece.start + piece.angle / 2
    late = piece.law is Law.PARABOLIC and (bool(phi[-1] > middle + 1e-9) == (piece.rises > 0))
    it = pose(trial, View.MECHANISM, cam, phi, lift(trial, place_of(cam), piece, phi, late=late))
    inset = cam.follower.radius / mm
    edge = foot(Line(it.b, 1j * it.way), it.pole) if cam.follower.flat else it.b + inset * it.normal
    return np.asarray(it.b * mm), np.asarray(edge * mm)


def interferes(board: Board, cam: Cam) -> bool:
    """Whether the roller in some place covers a point of the profile that it does not touch."""
    parts = traced(board, cam)
    centres = np.concatenate([pitch for pitch, _ in parts])
    limit = cam.follower.radius - CLEAR
    return any(bool((np.abs(edge[::3, None] - centres[None, :]) < limit).any()) for _, edge in parts)
