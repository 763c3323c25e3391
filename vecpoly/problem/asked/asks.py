"""What a problem asks for: a closed union."""

from __future__ import annotations

from ...foundation.slotted import dataclass
from ...names import At, Kind, Named, Rel


@dataclass(frozen=True, slots=True, kw_only=True)
class AskRel:
    """One quantity by its key: v_E, ak_B3B2, omega_2 ..."""

    rel: Rel


@dataclass(frozen=True, slots=True, kw_only=True)
class AskPoint:
    """The point `name` of the link with this velocity (m/s) or acceleration (m/s²),
    or the slowest on the line of two points; one is given.

    `name` is letter and link number, as in the textbook: M2 is the point M of link 2.
    """

    name: str
    link: str
    velocity: complex | None = None
    acceleration: complex | None = None
    slowest: tuple[str, str] | None = None

    @property
    def at(self) -> At:
        """The point as the keys of other quantities name it: a_M2 is At('M', '2')."""
        return At(self.name.removesuffix(self.link), self.link)

    @property
    def rel(self) -> Rel:
        """The key of its position, p_M2."""
        return Rel(Kind.P, At(self.name))


@dataclass(frozen=True, slots=True, kw_only=True)
class AskCoriolis:
    """Does the Coriolis term `rel` (ak_B3B2) exist, and where does it point?"""

    rel: Rel


@dataclass(frozen=True, slots=True, kw_only=True)
class AskNamed:
    """A load, a reaction, an efficiency, any quantity with a name of its own."""

    rel: Named


Ask = AskRel | AskPoint | AskCoriolis | AskNamed
