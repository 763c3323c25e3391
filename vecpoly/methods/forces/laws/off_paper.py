"""What a load asks of the mechanism as it stands and moves, read off the diagram and the velocity polygon."""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np

from ....algebra.quantity import Quantity
from ....board.board import NO_LENGTH
from ....board.construction import View
from ....board.paper.marks import Dot, Role
from ....mechanism.laws.springs import Coil, Spring
from ....mechanism.model import FRAME
from ....names import At, omega
from ....plane import Points, Reals, dot, nominal
from ...desk import Desk
from ...kinematics.image import found_tip
from .stroke import stroke

LONG = 50.0  # mm: the side of an angle that the protractor reads
TICK = 2.5  # mm: half the stroke that marks where a travel begins
Way = tuple[str, str, float]


@dataclass(slots=True)
class OffPaper:
    """The mechanism as drawn. What was read once stands in `travels`, and is not read again."""

    desk: Desk
    travels: dict[Way, tuple[Quantity, float]] = field(default_factory=dict)

    def drive(self) -> Reals:
        """The drive's own coordinate, which is given."""
        drive = self.desk.mech.drive
        return self.desk.board.in_each(drive.position, drive.key)

    def travelled(self, link: str, point: str, direction: float) -> tuple[Reals, float]:
        """How far the point is from where its stroke begins, and how long the stroke is (m)."""
        gone, whole = self.travel((link, point, direction))
        return gone.value, whole

    def speed(self, link: str, point: str, direction: float) -> Reals:
        """v · u off the velocity polygon (m/s); 0 where the tip is at the pole."""
        mm = dot(complex(np.exp(1j * direction)), self.tip(link, point))
        mm = mm if self.desk.board.beside else float(nominal(mm))  # whether it moves is seen on the nominal sheet
        return np.where(np.abs(mm) < NO_LENGTH, 0.0, mm) * self.desk.board.scales[View.VELOCITY].value

    def spin(self, link: str) -> Reals:
        """ω (rad/s), as it was found."""
        drive = self.desk.mech.drive
        return drive.rate if link == drive.link and not drive.slide else self._omega(link)

    def length(self, spring: Spring) -> Reals:
        """The distance of the ends as drawn (m)."""
        a, b = self.ends(spring)
        return np.abs(b - a) * self.desk.board.scales[View.MECHANISM].value

    def lengthening(self, spring: Spring) -> Reals:
        """dl/dt off the velocity polygon (m/s)."""
        a, b = self.ends(spring)
        tips = self.tip(spring.link, spring.point) - self.tip(spring.against, spring.foot)
        return dot((b - a) / np.abs(b - a), tips) * self.desk.board.scales[View.VELOCITY].value

    def turned(self, coil: Coil) -> Reals:
        """φ - φ_0 within half a turn (rad), by the protractor."""
        relative = self.angle(coil.link) - self.angle(coil.against) - coil.free
        seen = relative if self.desk.board.beside else nominal(relative)  # every hand has turned as often as the first
        return relative - 2 * np.pi * np.round(seen / (2 * np.pi))

    def turning(self, coil: Coil) -> Reals:
        """ω - ω' (rad/s)."""
        return self._omega(coil.link) - self._omega(coil.against)

    def angle(self, link: str) -> Reals:
        """Of the link's x axis from the horizontal (rad)."""
        if link == FRAME:
            return 0.0
        origin = self.desk.pose[link].origin
        return self.desk.board.gauge(origin, origin + LONG * self.desk.axis(link))

    def travel(self, way: Way) -> tuple[Quantity, float]:
        """s = μ_l C_0C, measured from where the stroke begins, which is marked; and the whole stroke (m)."""
        if way not in self.travels:
            self.travels[way] = self._measured(way)
        return self.travels[way]

    def _measured(self, way: Way) -> tuple[Quantity, float]:
        board, (link, point, direction) = self.desk.board, way
        low, high = stroke(self.desk.told or self.desk.mech, *way)
        along = complex(np.exp(1j * direction))
        here = self.place(link, point)
        start = here + along * (self.desk.mm(low) - dot(along, here))
        board.join(View.MECHANISM, start - 1j * TICK * along, start + 1j * TICK * along, Role.CONSTRUCTION)
        board.plot(View.MECHANISM, start, f"{point}_0", Dot.NONE)
        on_paper = board.measure(start, here, f"{point}_0 {point}")
        return board.compute(f"s_{point}", board.mu(View.MECHANISM) * on_paper, "m"), high - low

    def ends(self, spring: Spring) -> tuple[Points, Points]:
        """The spring's foot and its point on the diagram (mm)."""
        return self.place(spring.against, spring.foot), self.place(spring.link, spring.point)

    def place(self, link: str, point: str) -> Points:
        """A letter on the diagram (mm)."""
        return self.desk.at[point] if point in self.desk.at else self.desk.where(At(point, link))

    def tip(self, link: str, point: str) -> Points:
        """The end of a point's velocity (mm); that of the frame is the pole."""
        return 0j if link == FRAME else found_tip(self.desk, View.VELOCITY, At(point, link))

    def _omega(self, link: str) -> Reals:
        return 0.0 if link == FRAME else self.desk.turns[omega(link)].value
