"""What is read at the stations of a cam, as a table: number, φ, s or ψ, r, and the pressure angle."""

from __future__ import annotations

from collections.abc import Sequence

from .....algebra.quantity import number
from .....board.construction import Listing
from .....devices.cams.asked import pressure, radius, travel
from .....devices.cams.cam import Cam
from .....words import Words
from ...bench import Bench
from ..diagram import Station


def stations_read(bench: Bench, cam: Cam, stations: Sequence[Station]) -> Listing:
    """A row for every station, in the order of the cam's angle."""
    level = Words.same("$ψ$/°" if cam.arm else "$s$/mm")
    head: tuple[Words, ...] = (Words("点", "No."), Words.same("$φ$/°"), level, Words.same("$r$/mm"))
    if not cam.follower.flat:
        head = (*head, Words.same("$α$/°"))
    return Listing(head=head, rows=tuple(_row(bench, cam, station) for station in stations))


def _row(bench: Bench, cam: Cam, station: Station) -> tuple[str, ...]:
    keys = [travel(station.name, swings=bool(cam.arm)), radius(station.name)]
    if not cam.follower.flat:
        keys.append(pressure(station.name))
    read = bench.board.readings
    values = [number(read[key.key].scalar) if key.key in read else "0" for key in keys]  # at the start nothing is read
    return (f"{station.number}", number(station.name), *values)
