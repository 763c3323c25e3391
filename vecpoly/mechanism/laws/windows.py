"""When a load acts: while a point or a link moves one way, within part of its stroke, during part of the drive's turn.

A window is half open: at its first place the load acts, at its last it does not any more; at a dead centre nothing
moves one way.
"""

from __future__ import annotations

from ...foundation.slotted import dataclass


@dataclass(frozen=True, slots=True, kw_only=True)
class Moving:
    """While a point moves towards `direction` (rad): v · u > 0, and only between two parts of its stroke, counted so.

    low, high: 0 where the point sets out, 1 where it turns back; the stroke is that of its coordinate along u.
    """

    link: str
    point: str
    direction: float
    low: float = 0.0
    high: float = 1.0

    @property
    def is_part(self) -> bool:
        """Whether it is less than the whole stroke."""
        return self.low > 0.0 or self.high < 1.0


@dataclass(frozen=True, slots=True, kw_only=True)
class Turning:
    """While a link turns one way: sense ω > 0; sense: +1 counter-clockwise, -1 clockwise."""

    link: str
    sense: int


@dataclass(frozen=True, slots=True, kw_only=True)
class During:
    """Between two places of the drive's own coordinate (rad, or m of one that slides).

    period: rad after which it acts again, 0 of a sliding drive; where low > high it goes on past the period's end.
    """

    low: float
    high: float
    period: float


Window = Moving | Turning | During
