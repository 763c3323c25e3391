"""Where the velocity of a follower drops at once: there the pitch curve has a corner that points outward."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise
from math import degrees, tau

from ...words import Words
from .motion import Law, Piece

DROP = 1e-9  # of the stroke a radian: a smaller drop is none


def corners_of(pieces: Sequence[Piece]) -> tuple[float, ...]:
    """The angles (deg, in (0, 360]) of the outward corners; only uniform motion begins and ends with a velocity."""
    high = max(piece.high for piece in pieces)
    slopes = [piece.rises * piece.lift / piece.angle if piece.law is Law.UNIFORM else 0.0 for piece in pieces]
    ends = zip(pieces, pairwise([*slopes, slopes[0]]), strict=True)
    return tuple(degrees(piece.end % tau or tau) for piece, (one, other) in ends if one - other > DROP * high)


def corners_noted(pieces: Sequence[Piece]) -> tuple[Words, ...]:
    """That ρ_min is that of the smooth parts, where there are corners as well."""
    if not (there := corners_of(pieces)):
        return ()
    zh, en = ("、".join(f"{at:.4g}°" for at in there), ", ".join(f"{at:.4g}°" for at in there))
    return (
        Words(
            f"φ = {zh} 处速度突减，理论廓线有外凸的尖点，该处曲率半径为零；ρ_min 是尖点以外各段的最小曲率半径",
            f"at φ = {en} the velocity drops at once and the pitch curve has an outward corner, of no radius; "
            "ρ_min is the minimum radius of curvature of the parts between corners",
        ),
    )
