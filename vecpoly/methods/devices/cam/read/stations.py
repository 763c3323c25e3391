"""What is read at the stations of a cam, as a table: number, φ, s or ψ, r and θ, and the pressure angle."""

from __future__ import annotations

from collections.abc import Sequence

from .....algebra.columns import column, places_of
from .....algebra.quantity import number
from .....board.construction import Listing
from .....devices.cams.asked import polar, pressure, radius, travel
from .....devices.cams.cam import Cam
from .....words import Words
from ...bench import Bench
from ..diagram import Station

TENTH = 0.1  # mm of a rule, degrees of a protractor


def stations_read(bench: Bench, cam: Cam, stations: Sequence[Station]) -> Listing:
    """A row for every station, in the order of the cam's angle."""
    level = Words.same("$ψ$ /°" if cam.arm else "$s$ /mm")
    head: tuple[Words, ...] = (
        Words("点", "No."),
        Words.same("$φ$ /°"),
        level,
        Words.same("$r$ /mm"),
        Words.same("$θ$ /°"),
    )
    if not cam.follower.flat:
        head += (Words.same("$α$ /°"),)
    named = [(travel(s.name, swings=bool(cam.arm)), radius(s.name), polar(s.name), pressure(s.name)) for s in stations]
    columns = [_read(bench, [row[k].key for row in named]) for k in range(len(head) - 2)]
    numbers = tuple((f"{station.number}", number(station.name)) for station in stations)
    rows = tuple((*two, *row) for two, row in zip(numbers, zip(*columns, strict=True), strict=True))
    return Listing(head=head, rows=rows)


def _read(bench: Bench, keys: Sequence[str]) -> tuple[str, ...]:
    """What is read at the stations, with the decimals of a tenth of a millimetre, or of a degree."""
    found = [bench.board.readings.get(key) for key in keys]  # at the start nothing is read
    tenths = [TENTH * abs(one.scalar) / one.mm for one in found if one is not None and one.mm]
    return column([0.0 if one is None else one.scalar for one in found], places_of(max(tenths, default=TENTH)))
