"""The numbers of the stations about a cam: all of them, each outside, on the ray of its station."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from math import sqrt

from ....board.board import Board
from ....board.construction import View
from ....board.paper.marks import Role
from ....plane import Points, nominal
from ....words import Words
from .diagram import Station
from .pose import Pose

BEYOND = 1.5  # mm: of the line of a guide, beyond the circles of the roller or the tangents
Posed = Sequence[tuple[Station, Pose]]
Seen = Callable[[complex, complex], Iterable[float]]  # what lies on a ray, as far from where that begins


def beyond_rollers(board: Board, cuts: Posed, r: float) -> None:
    """Of a roller on a guide, each beyond all circles of the roller, at the end of its guide."""
    centres = [complex(nominal(it.b)) for _, it in cuts]

    def seen(at: complex, u: complex) -> Iterable[float]:
        found = ((centre - at) * u.conjugate() for centre in centres)
        return (z.real + sqrt(r**2 - z.imag**2) for z in found if abs(z.imag) < r)

    _on_rays(board, [one for one in cuts if one[0].number], seen)


def beyond_faces(board: Board, cuts: Posed, half: float) -> None:
    """Of a flat face on a guide, each beyond all tangents, which go so far to either side."""
    faces = [(complex(nominal(it.b)), 1j * complex(nominal(it.way))) for _, it in cuts]

    def seen(at: complex, u: complex) -> Iterable[float]:
        found = (((b - at) * u.conjugate(), along * u.conjugate()) for b, along in faces)
        cross = ((z, way, -z.imag / way.imag) for z, way in found if abs(way.imag) > 1e-6)
        return ((z + part * way).real for z, way, part in cross if abs(part) <= half)

    _on_rays(board, cuts[1:], seen)


def _on_rays(board: Board, cuts: Posed, seen: Seen) -> None:
    """At the end of a line that goes on along the guide until nothing is in its way."""
    for station, it in cuts:
        at, u = complex(nominal(it.b)), complex(nominal(it.way))
        far = max(seen(at, u), default=0.0) + BEYOND
        board.join(View.MECHANISM, it.b, it.b + far * it.way, Role.CONSTRUCTION)
        _write(board, station, it.b + far * it.way, u)


def beyond_pivots(board: Board, cuts: Posed, *, flat: bool) -> None:
    """Of an arm, each beyond its pivot, or the foot of that on a flat face; the first is named by its letter."""
    for station, it in cuts[1:]:
        at = it.b if flat else it.start
        out = complex(nominal(at))
        _write(board, station, at, out / abs(out))


def on_profile(board: Board, cuts: Posed) -> None:
    """Of an edge, each beyond its point of the profile."""
    for station, it in cuts[1:]:
        out = complex(nominal(it.b))
        _write(board, station, it.b, out / abs(out))


def _write(board: Board, station: Station, at: Points, side: complex) -> None:
    board.note(View.MECHANISM, at, Words.same(f"{station.number}"), side)
