"""The profile as so many points, and by how much a curve through them may leave it."""

from __future__ import annotations

from dataclasses import dataclass
from math import ceil, degrees

import numpy as np

from ...board.board import Board
from ...board.hand import hand
from ...devices.cams.cam import Cam
from ...devices.cams.motion import Law
from ...errors import NoMethodError
from ...methods.devices.cam.curvature import is_spoilt
from ...methods.devices.cam.scales import cam_scales
from ...methods.devices.cam.trying import Traced, traced
from ...problem.problem import Problem
from ...words import Words

STEP = 1.0  # deg between the points


@dataclass(frozen=True, slots=True)
class Profile:
    """Stretches without a jump of curvature inside, in the order of the cam's angle; lengths in mm.

    between: the same stretches, each with a point between any two: what a curve is held against.
    """

    stretches: tuple[Traced, ...]
    between: tuple[Traced, ...]

    @property
    def chords(self) -> float:
        """By how much the chords between the points leave the profile at most (mm)."""
        return max(
            float(np.abs(fine.edge[1::2] - (part.edge[:-1] + part.edge[1:]) / 2).max())
            for part, fine in zip(self.stretches, self.between, strict=True)
        )


def profile_of(problem: Problem) -> Profile:
    """The profile by the exact hand; raises NoMethodError where this is no cam that can be made."""
    cam = problem.subject
    if not isinstance(cam, Cam) or cam.r0 is None:
        raise NoMethodError(
            Words(
                "只有给出 r0 的凸轮题（device: cam）才有廓线可写成 DXF 或 CSV；其他题请用 vecpoly draw",
                "only a cam with its r0 (device: cam) has a profile for DXF or CSV; for others take vecpoly draw",
            ),
            code="export-cam",
        )
    board = Board(hand("exact"), cam_scales(cam, problem.scales))
    if is_spoilt(board, cam):
        raise NoMethodError(
            Words(
                "凸轮廓线失真，不能加工，不写出；", "the profile is undercut and cannot be made, so it is not written; "
            )
            + cam.follower.remedy,
            code="export-cam",
        )
    counts = [max(ceil(degrees(piece.angle) / STEP), 2) for piece in cam.pieces]
    # a parabola has its halves alike: of an odd count the points between would stand elsewhere
    counts = [n + n % 2 if p.law is Law.PARABOLIC else n for n, p in zip(counts, cam.pieces, strict=True)]
    return Profile(
        tuple(_mm(part) for part in traced(board, cam, counts)),
        tuple(_mm(part) for part in traced(board, cam, [2 * count for count in counts])),
    )


def _mm(part: Traced) -> Traced:
    return Traced(phi=part.phi, pitch=1e3 * part.pitch, edge=1e3 * part.edge)
