"""What the loads need to know of the drive."""

from __future__ import annotations

from math import copysign, degrees, pi

from ...errors import FaultError
from ...foundation.slotted import dataclass
from ...mechanism.model import Drive, Mechanism
from ...units.reading import Dim, read
from ...words import Words
from ..problem import Datum


@dataclass(frozen=True, slots=True, kw_only=True)
class Driven:
    """The drive; how far its own coordinate is ahead of the one that is written (rad, m); whether its rate is given.

    turns: after how many turns of it the loads repeat themselves.
    """

    drive: Drive
    lead: float
    rated: bool
    turns: int = 1

    @property
    def sense(self) -> float:
        """+1 or -1: which way it moves."""
        return copysign(1.0, self.drive.rate)

    @property
    def period(self) -> float:
        """After which its coordinate is the same (rad); 0 of a drive that slides."""
        return 0.0 if self.drive.slide else 2 * pi * self.turns

    def place(self, text: str) -> float:
        """A written place of the drive in its own coordinate; raises FaultError beyond the period."""
        value = read(text, Dim.LENGTH if self.drive.slide else Dim.ANGLE).si
        if self.period and abs(value) > self.period * (1 + 1e-9):
            whole = f"{degrees(self.period):g}°"
            raise FaultError(
                Words(
                    f"“{text}”超出一个周期 0…{whole}；四冲程等两转一周期的载荷须由覆盖 0…720° 的表给出",
                    f"'{text}' lies beyond the period, 0 to {whole}; that loads repeat themselves after two turns only "
                    "is told by a table over 0 to 720 deg",
                ),
                code="no-period",
            )
        return value + self.lead

    def refuse_unrated(self, what: Words) -> None:
        """Raise FaultError where the speed itself matters and only its sense is given."""
        if not self.rated:
            raise FaultError(
                Words(
                    f"{what.zh}与速度有关，而输入只给了转向；请给出角速度的数值，如 omega: 10 rad/s ccw",
                    f"{what.en} depends on the speed, and the input gives only its sense; write the angular velocity "
                    "as a number, e.g. omega: 10 rad/s ccw",
                ),
                code="missing",
            )


def driven_by(mech: Mechanism, motion: tuple[Datum, ...], rated: bool) -> Driven:
    """The drive with what is written of its place (φ_1, s_1, l_BC); of none, told elsewhere, one at rest."""
    if not mech.drives:
        return Driven(drive=Drive(link="", position=0.0, rate=1.0), lead=0.0, rated=True)
    place = next((datum for datum in motion if datum.symbol[:1] in ("φ", "s", "l")), None)
    lead = 0.0 if place is None else mech.drive.position - place.si
    return Driven(drive=mech.drive, lead=lead, rated=rated)
