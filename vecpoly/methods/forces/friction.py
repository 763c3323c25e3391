"""The friction of one pass: circles of pins, angles of slides and contacts, and the senses in which it acts."""

from __future__ import annotations

from dataclasses import dataclass
from math import atan, tan

from ...errors import NoSlipSenseError
from ...mechanism.asked.forces import leaning_symbol
from ...mechanism.loads import Loads
from ...mechanism.model import FRAME, Contact, Mechanism, Prismatic
from ...names import omega
from ...plane import Points, nominal
from ...words import Words
from ..desk import Desk

STILL = 1e-9  # of the driver's rate: links that turn or slide slower than this past each other have no friction sense


@dataclass(frozen=True, slots=True, kw_only=True)
class Hub:
    """A multiple joint whose pin belongs to `carrier`, though the groups hang at it on `hung`;
    `links` are all that meet there.

    blocks: those that are thought about the pin, in the slots in which it runs.
    """

    point: str
    carrier: str
    hung: str
    links: tuple[str, ...]
    blocks: tuple[str, ...] = ()


@dataclass(slots=True)
class Rubbing:
    """`rubbing`: whether friction counts in this pass; `share` of it, while it is raised; `hubs`: pins that are thought
    by themselves while the groups are solved, at which it acts as couples; `bare`: joints that bear nothing, in which
    none is put (pins by their letter, slides by block and guide)."""

    desk: Desk
    loads: Loads
    rubbing: bool = False
    share: float = 1.0
    hubs: tuple[Hub, ...] = ()
    bare: frozenset[str | tuple[str, str]] = frozenset()

    @property
    def mech(self) -> Mechanism:
        """The mechanism."""
        return self.desk.mech

    def rho(self, point: str) -> float:
        """Radius of the friction circle of a pin on paper (mm); 0 in a pass without friction."""
        alone = point in self.bare or any(hub.point == point for hub in self.hubs)  # there friction acts as couples
        return (
            self.share * self.desk.mm(self.loads.friction.pins.get(point, 0.0)) if self.rubbing and not alone else 0.0
        )

    def phi_symbol(self, joint: Prismatic | Contact) -> str:
        """Of its friction angle, as it is given: φ_T, φ_{23}."""
        return leaning_symbol(self.mech, joint.point if isinstance(joint, Contact) else (joint.block, joint.guide))

    def phi(self, joint: Prismatic | Contact) -> float:
        """Friction angle of a slide or a contact (rad); 0 in a pass without friction.

        A share of the friction is one of f = tan φ, as it is one of ρ = f r: slides that are steeper than that against
        the pins would help where they bind, and others bind where they help.
        """
        friction = self.loads.friction
        if not self.rubbing or (isinstance(joint, Prismatic) and (joint.block, joint.guide) in self.bare):
            return 0.0
        whole = (
            friction.contacts.get(joint.point, 0.0)
            if isinstance(joint, Contact)
            else friction.slides.get((joint.block, joint.guide), 0.0)
        )
        return whole if self.share == 1.0 else atan(self.share * tan(whole))

    def turning(self, link: str, against: str) -> float:
        """ω of a link relative to another, as drawn (rad/s)."""
        return self._omega(link) - self._omega(against)

    def moment_sense(self, point: str, by: str, on: str) -> int:
        """Sense (+1 ccw) of the moment of R_by,on about the pin's centre: against the turning of `on` relative to `by`.

        0 where the pin has no friction, or only runs in a slot.
        Raises NoSlipSenseError where the links do not turn relative to each other.
        """
        if not self.rho(point) or {by, on} & self.mech.slot_pins.keys():
            return 0
        rate = self.turning(on, by)
        if abs(rate) <= STILL * self._rate():
            i, j = self.mech.number(by), self.mech.number(on)
            raise NoSlipSenseError(
                Words(
                    f"转动副 {point}：构件 {i} 与 {j} 在此位置无相对转动，摩擦力矩方向不定；请另取原动件位置，"
                    f"或去掉 {point} 处的摩擦",
                    f"pin {point}: links {i} and {j} do not turn relative to each other in this position, so "
                    "their friction has no sense; choose another input position, or leave out the friction of "
                    f"{point}",
                )
            )
        return -1 if rate > 0 else 1

    def touch(self, point: str, along: Points, sense: int) -> Points:
        """Where a force along a unit vector, with a moment of this sense about the pin, touches its friction circle."""
        return self.desk.at[point] - 1j * along * sense * self.rho(point)

    @property
    def speed(self) -> float:
        """A speed typical of the mechanism (m/s)."""
        return self._rate() * self.mech.scale

    def _omega(self, link: str) -> float:
        return 0.0 if link == FRAME else float(nominal(self.desk.turns[omega(link)].value))

    def _rate(self) -> float:
        drive = self.mech.drive
        return abs(drive.rate) / (self.mech.scale if drive.slide else 1.0)
