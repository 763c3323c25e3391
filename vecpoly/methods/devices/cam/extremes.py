"""Where a pressure angle is greatest, or a radius of curvature least: tried on scratch paper, ever closer."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import dataclass
from math import degrees

import numpy as np

from ....algebra.quantity import number
from ....board.board import Board
from ....board.construction import View
from ....devices.cams.cam import Cam
from ....devices.cams.motion import Piece
from ....plane import Reals, cross, dot
from ..bench import trial_board
from .laws import Lift, lift, stretches
from .pose import centre_of_curvature, pose

TRIED, CLOSER = 41, 6  # places in a row, and how often the best is looked at closer
Merit = Callable[[Board, Reals, Lift], Reals]


@dataclass(frozen=True, slots=True, kw_only=True)
class Spot:
    """A place of the motion: its angle, its piece, whether after a jump of the acceleration; how good it is."""

    phi: float
    piece: Piece
    late: bool
    merit: float

    @property
    def told(self) -> str:
        """Its angle in degrees, as a place is told that was found by trial: to 0.1°, as a protractor is read."""
        return number(round(degrees(self.phi), 1) + 0.0)


def best(board: Board, place: View, pieces: Iterable[Piece], merit: Merit) -> Spot:
    """The place where the merit is greatest; the first of equals."""
    spots = (_best(board, place, piece, *stretch, merit) for piece in pieces for stretch in stretches(piece))
    return max(spots, key=_rank)


def _rank(spot: Spot) -> float:
    return round(spot.merit, 9)


def _best(board: Board, place: View, piece: Piece, low: float, high: float, late: bool, merit: Merit) -> Spot:
    for _ in range(CLOSER):
        trial = trial_board(board, like=View.MECHANISM)
        tried = np.linspace(low, high, TRIED)
        found = np.asarray(merit(trial, tried, lift(trial, place, piece, tried, late=late)), dtype=float)
        top = int(np.argmax(np.where(np.isnan(found), -np.inf, found)))
        low, high = float(tried[max(top - 1, 0)]), float(tried[min(top + 1, TRIED - 1)])
    return Spot(phi=float(tried[top]), piece=piece, late=late, merit=float(found[top]))


def slanting(cam: Cam) -> Merit:
    """tan α."""

    def merit(trial: Board, phi: Reals, at: Lift) -> Reals:
        it = pose(trial, View.MECHANISM, cam, phi, at)
        return np.abs(cross(it.way, it.normal) / dot(it.way, it.normal))

    return merit


def curving(cam: Cam) -> Merit:
    """1/ρ of the pitch curve, or −ρ under a flat face."""

    def merit(trial: Board, phi: Reals, at: Lift) -> Reals:
        it = pose(trial, View.MECHANISM, cam, phi, at)
        if cam.follower.flat:
            return -(dot(it.way, it.b - it.pole) + it.beyond)
        centre, *_ = centre_of_curvature(trial, it)
        return 1 / dot(it.normal, centre - it.b)

    return merit


def reaching(cam: Cam, sign: int) -> Merit:
    """How far the contact is from the foot of A along a flat face that swings; sign: −1 for the nearest."""

    def merit(trial: Board, phi: Reals, at: Lift) -> Reals:
        it = pose(trial, View.MECHANISM, cam, phi, at)
        return sign * np.abs(it.foot - it.b)

    return merit


def parting(trial: Board, phi: Reals, at: Lift) -> Reals:
    """|ds/dφ|: how far the contact is from the guide under a flat face."""
    return np.abs(at.slope)
