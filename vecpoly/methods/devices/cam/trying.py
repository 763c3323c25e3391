"""The whole profile on scratch paper: against the roller in all its places, and for other programs."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from math import ceil, degrees

import numpy as np
import numpy.typing as npt

from ....board.board import Board
from ....board.construction import View
from ....devices.cams.cam import Cam
from ....devices.cams.motion import Piece
from ..bench import trial_board
from .diagram import place_of
from .laws import lift, stretches
from .pose import pose

DENSE, FEWEST = 240, 4  # chords a piece; the fewest of one that is outlined
CLEAR = 1e-5  # m by which a point may lie inside the roller
Spots = npt.NDArray[np.complex128]
Angles = npt.NDArray[np.float64]


@dataclass(frozen=True, slots=True, kw_only=True)
class Traced:
    """Points of a stretch in which nothing jumps: the cam's angle, the pitch curve, the profile."""

    phi: Angles
    pitch: Spots
    edge: Spots


def traced(board: Board, cam: Cam, counts: Sequence[int] | None = None) -> tuple[Traced, ...]:
    """Every piece with so many chords (m)."""
    each = counts or [DENSE] * len(cam.pieces)
    return tuple(
        _stretch(board, cam, piece, phi, late)
        for piece, count in zip(cam.pieces, each, strict=True)
        for phi, late in _spans(piece, count)
    )


def _spans(piece: Piece, count: int) -> tuple[tuple[Angles, bool], ...]:
    """The angles of a piece; of a parabola its halves, each drawn from its own end."""
    parts = stretches(piece)
    each = -(-count // len(parts))
    return tuple((np.linspace(low, high, each + 1), late) for low, high, late in parts)


def _stretch(board: Board, cam: Cam, piece: Piece, phi: Angles, late: bool) -> Traced:
    trial, mm = trial_board(board), board.scale_of(View.MECHANISM).value
    it = pose(trial, View.MECHANISM, cam, phi, lift(trial, place_of(cam), piece, phi, late=late))
    return Traced(phi=phi, pitch=np.asarray(it.b * mm), edge=np.asarray(it.touch(cam, mm) * mm))


def outlined(board: Board, cam: Cam, every: float) -> tuple[Spots, ...]:
    """The profile of every stretch (m), in points not more than so many degrees of the cam apart."""
    counts = [max(ceil(degrees(piece.angle) / every), FEWEST) for piece in cam.pieces]
    return tuple(part.edge for part in traced(board, cam, counts))


def interferes(board: Board, cam: Cam) -> bool:
    """Whether the roller in some place covers a point of the profile that it does not touch."""
    parts = traced(board, cam)
    centres = np.concatenate([part.pitch for part in parts])
    limit = cam.follower.radius - CLEAR
    return any(bool((np.abs(part.edge[::3, None] - centres[None, :]) < limit).any()) for part in parts)
