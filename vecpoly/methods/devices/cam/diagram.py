"""The s–φ diagram (ψ–φ of an arm): axes, the law of every piece, the stations, the curve."""

from __future__ import annotations

from dataclasses import dataclass
from itertools import pairwise
from math import ceil, degrees

import numpy as np

from ....algebra.quantity import number
from ....board.construction import View
from ....board.paper.marks import Dot, Role
from ....devices.cams.asked import travel
from ....devices.cams.cam import Cam
from ....devices.cams.motion import Piece
from ....words import Words
from ..bench import Bench, trial_board
from .laws import Lift, lift
from .read.readings import noted
from .scales import ANGULAR, DISPLACEMENT
from .words.motion import how_drawn, shocks

BEYOND, TICK = 8.0, 8.0  # mm: the axes run on; marks under the ends of pieces
ROOM, DIGITS = 8.0, 5.4  # mm from station to station for all to be numbered; that their numbers take below the axis

SAME, FEWEST = 1e-9, 12  # rad; places through which the curve of a piece is led
BELOW = -1j  # numbers of an axis stand under it, on one line


@dataclass(frozen=True, slots=True, kw_only=True)
class Station:
    """An angle of the cam, the piece that ends there or goes on, and what was found on the diagram."""

    number: int
    phi: float
    piece: Piece
    lift: Lift

    @property
    def name(self) -> float:
        """The angle in degrees, as it is written."""
        return round(degrees(self.phi), 6)


def place_of(cam: Cam) -> View:
    """Displacements of a guided follower, angles of an arm."""
    return ANGULAR if cam.arm else DISPLACEMENT


def displacement(bench: Bench, cam: Cam) -> tuple[Station, ...]:
    """Draw the diagram and read it at every station."""
    board, place = bench.board, place_of(cam)
    symbol = "ψ" if cam.arm else "s"
    board.section(Words("位移线图", "Displacement diagram"))
    board.step(
        Words(
            f"按 $μ_{{φ}}$ 在横轴上量出各运动角并等分，按 {'$μ_{ψ}$' if cam.arm else '$μ_s$'} 量 ${symbol}$，作位移线"
            "图。",
            f"Lay off the angles of the motion to $μ_{{φ}}$, divide them, and draw the diagram of ${symbol}$ to "
            f"{'$μ_{ψ}$' if cam.arm else '$μ_s$'}. ",
        )
        + how_drawn(cam)
        + Words(
            "。分点 1、2…在曲线上的对应点为 1′、2′…（图上只标分点）。",
            ". On the curve above the stations 1, 2 ... lie 1′, 2′ ..., which the figure does not letter.",
        ),
        place,
    )
    _axes(bench, place, cam, symbol)
    found = tuple(
        Station(number=n, phi=phi, piece=piece, lift=lift(board, place, piece, phi, letters=f"{n} {n}′"))
        for n, (phi, piece) in enumerate(cam.places)
    )
    _numbers(bench, place, cam, found)
    _curve(bench, place, cam, found)
    board.remark(shocks(board, place, cam))
    _read(bench, place, cam, found)
    return found


def _axes(bench: Bench, place: View, cam: Cam, symbol: str) -> None:
    board, scale = bench.board, bench.board.scale_of(place)
    turn, high = 2 * np.pi / scale.right.value, cam.lift / scale.value
    for end, letter in ((turn + BEYOND + 0j, "φ"), (1j * (high + BEYOND), symbol)):
        board.arrow(place, 0j, end, Role.DIRECTION)
        board.plot(place, end, letter, Dot.NONE)


def _numbers(bench: Bench, place: View, cam: Cam, found: tuple[Station, ...]) -> None:
    """Under each station its number, of stations close together every other one; under that the angles at which pieces
    end, at marks that leave the numbers free."""
    board, mm = bench.board, bench.board.scale_of(place).right.value
    gap = min(b.phi - a.phi for a, b in pairwise(found)) / mm
    shown = found[:: 1 if gap >= ROOM else 2]
    for station in shown:
        board.note(place, station.lift.foot, Words.same(f"{station.number}"), BELOW)
    names = {station.name for station in shown}
    for end in (piece.end for piece in cam.pieces):
        at, numbered = end / mm, round(degrees(end), 6) in names
        board.join(place, at - DIGITS * 1j * numbered, at - TICK * 1j, Role.CONSTRUCTION)
        board.note(place, at - TICK * 1j, Words.same(f"{number(degrees(end))}°"), BELOW)


def _curve(bench: Bench, place: View, cam: Cam, found: tuple[Station, ...]) -> None:
    """A smooth curve through the stations of every piece, and between them where they are few; it ends where the next
    begins."""
    board = bench.board
    for piece in cam.pieces:
        scratch = trial_board(board)
        inner = [s for s in found if piece.start + SAME < s.phi < piece.end - SAME]
        stops = [piece.start, *(s.phi for s in inner), piece.end]
        known = {s.phi: s.lift.point for s in inner}
        angles = [phi for a, b in pairwise(stops) for phi in np.linspace(a, b, _parts(piece, a, b), endpoint=False)]
        points = [
            known[phi] if phi in known else lift(scratch, place, piece, phi).point
            for phi in map(float, [*angles, piece.end])
        ]
        board.curve(place, points, Role.RESULT)


def _parts(piece: Piece, a: float, b: float) -> int:
    """Into how many parts the way between two stations is cut, so that a piece has FEWEST at least."""
    return max(ceil(FEWEST * (b - a) / piece.angle - SAME), 1)


def _read(bench: Bench, place: View, cam: Cam, found: tuple[Station, ...]) -> None:
    scale = bench.board.scale_of(place)
    for station in found[1:]:
        value = np.degrees(station.lift.s) if cam.arm else 1e3 * station.lift.s
        named = travel(station.name, swings=bool(cam.arm))
        letters = f"{station.number} {station.number}′"
        noted(bench, named, value, station.lift.s / scale.value, letters, scale.symbol)
