"""The masses that stand on each link while they are passed on to the frame."""

from __future__ import annotations

from dataclasses import dataclass, field

from ...algebra.quantity import Quantity, Sum, magnitude
from ...foundation.slotted import replace
from ...mechanism.counterweights import Counterweights, Outlet, Passing
from ...mechanism.joints import FRAME
from ...plane import Reals
from ..desk import Desk
from ..devices.bench import Bench


@dataclass(frozen=True, slots=True, eq=False, kw_only=True)
class Stand:
    """A mass at a lettered point; its product is turned against its radius by `turn` (rad; None: not at all).

    ideal: the same of the data, as one complex mass (kg): of use where a scale is chosen.
    """

    point: str
    label: str  # m_{label}, W_{label}
    mass: Quantity
    ideal: complex
    turn: Reals | None = None


@dataclass(slots=True, kw_only=True)
class Weighing:
    """What has been passed on so far, by link; and the counterweights found (kg)."""

    desk: Desk
    asked: Counterweights
    given: float | None = None  # μ_W, where the file gives it
    stands: dict[str, list[Stand]] = field(default_factory=dict)
    hung: list[Quantity] = field(default_factory=list)

    @property
    def bench(self) -> Bench:
        """The sheet, as where devices are balanced."""
        return Bench(self.desk.board)

    def local(self, link: str, point: str) -> complex:
        """A point in the coordinates of its link (m)."""
        return self.desk.mech.link(link).points[point]

    def put(self, out: Outlet, one: Stand) -> None:
        """Let a mass stand at a hinge of the next link; on the frame it is of no matter."""
        if out.to == FRAME:
            return
        here = self.stands.setdefault(out.to, [])
        taken = {other.label for other in here}
        while one.label in taken:
            one = replace(one, label=f"{one.label}'")
        here.append(replace(one, point=out.point))

    def gather(self, of: Passing) -> list[Stand]:
        """All that stands on a link: masses at one point that are not turned are one, m_B = m_{B2} + ..."""
        found: list[Stand] = []
        here = self.stands.get(of.link, [])
        for point in dict.fromkeys(one.point for one in here):
            plain = [one for one in here if one.point == point and one.turn is None]
            found += [self._together(plain)] if len(plain) > 1 else plain
            found += [one for one in here if one.point == point and one.turn is not None]
        return found

    def _together(self, ones: list[Stand]) -> Stand:
        point = ones[0].point
        total = Sum(tuple(one.mass for one in ones), (1,) * len(ones))
        mass = self.desk.board.compute(f"m_{{{point}}}", total, "kg")
        return Stand(point=point, label=point, mass=mass, ideal=sum(one.ideal for one in ones))


def weighing_of(desk: Desk, asked: Counterweights, given: float | None) -> Weighing:
    """Every mass of the linkage at its centre."""
    here = Weighing(desk=desk, asked=asked, given=given)
    for one in asked.loads.masses:
        number = desk.mech.number(one.link)
        mass = magnitude(f"m_{{{number}}}", one.mass, "kg")
        here.stands.setdefault(one.link, []).append(
            Stand(point=one.centre, label=number, mass=mass, ideal=complex(one.mass))
        )
    return here
