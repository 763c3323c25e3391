"""The areas between two curves: lettered at their ends, hatched, measured on paper."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise

import numpy as np
import numpy.typing as npt

from ...algebra.quantity import Quantity
from ...board.acts import Way
from ...board.board import Board
from ...board.construction import Place
from ...board.paper.marks import Dot, Role
from ...errors import NotAskedError
from ...plane import Points, Reals, nominal
from ...words import Words
from .graph import SAME, Graph
from .meetings import Found, Meeting, meetings

Corners = npt.NDArray[np.complex128]
GRID, NEARER = 33, 0.05  # places each way that are tried for a letter; how much one in the middle is preferred


@dataclass(frozen=True, slots=True, kw_only=True)
class Lobe:
    """An area between two meetings: its outline, what was read (mm²), +1 where it is a surplus, −1 a deficit."""

    outline: tuple[Points, ...]
    area: Quantity
    sign: Reals


@dataclass(frozen=True, slots=True, kw_only=True)
class Lobes:
    """All areas of a period, and the points at their ends: the first and the last are the ends of the period."""

    lobes: tuple[Lobe, ...]
    ends: tuple[Points, ...]
    letters: tuple[str, ...]


def lobes_between(
    board: Board, place: Place, upper: Graph, lower: Graph, letters: Sequence[str], way: Way, symbol: str = "A"
) -> Lobes:
    """Letter the meetings, hatch the areas, surplus where the first curve is above, and read them.

    letters: of the ends of the areas, as many as are needed; none: areas are measured, and nothing is left on paper.
    """
    found = meetings(board, upper, lower)
    if letters and len(found.meetings) + 2 != len(letters):
        raise _unreadable(len(found.meetings) + 1, len(letters) - 1)
    ends = _ends(board, place, upper, found, letters)
    if letters:
        _close(board, place, upper, lower)
    signs = _signs(board, place, found, letters)
    read = []
    for n, (outline, sign) in enumerate(zip(_outlines(upper, lower, found.meetings), signs, strict=True), 1):
        name = f"{symbol}_{n}"
        if letters:
            board.hatch(place, outline, rising=bool(nominal(sign) > 0))
            board.plot(place, middle_of(outline), name, Dot.NONE)
        read.append(Lobe(outline=outline, area=board.area(place, outline, name, way), sign=sign))
    return Lobes(lobes=tuple(read), ends=ends, letters=tuple(letters))


def _ends(board: Board, place: Place, upper: Graph, found: Found, letters: Sequence[str]) -> tuple[Points, ...]:
    """The beginning of the period, every meeting, its end."""
    at = [upper.corners[0].real + 0j, *(one.at for one in found.meetings), upper.corners[-1].real + 0j]
    if not letters:
        return tuple(at)
    lettered = tuple(board.locate(place, name, point) for point, name in zip(at, letters, strict=True))
    for point, name in zip(lettered, letters, strict=True):
        board.plot(place, point, name, Dot.POINT)
    return lettered


def _close(board: Board, place: Place, upper: Graph, lower: Graph) -> None:
    """Where the period ends, the ordinate of both curves closes the last area, and that above the axis."""
    ends = upper.corners[-1], lower.corners[-1]
    low, *_, high = sorted((*ends, ends[0].real + 0j), key=lambda end: complex(nominal(end)).imag)
    if abs(complex(nominal(high - low))) > SAME:
        board.join(place, low, high, Role.CONSTRUCTION)


def _unreadable(drawn: int, given: int) -> NotAskedError:
    return NotAskedError(
        Words(
            f"图上两曲线之间有 {drawn} 块面积，按数据应有 {given} 块：有的太小，图上分辨不出；请用 --hand drafting，"
            "或合并相近的点",
            f"there are {drawn} areas between the curves on paper, and {given} by the data: some are too small to be "
            "seen; draw with --hand drafting, or leave out corners that are nearly together",
        ),
        code="unreadable",
        numbers={"drawn": drawn, "given": given},
    )


def _signs(board: Board, place: Place, found: Found, letters: Sequence[str]) -> list[Reals]:
    """Of the first area as it is seen; then the other one wherever the curves cross."""
    signs: list[Reals] = [1.0 if found.above else -1.0]
    for n, one in enumerate(found.meetings, 1):
        turned = board.judged(place, letters[n], crosses=one.crosses) if letters else -1.0 if one.crosses else 1.0
        signs.append(signs[-1] * turned)
    return signs


def _outlines(upper: Graph, lower: Graph, between: Sequence[Meeting]) -> list[tuple[Points, ...]]:
    """Along the first curve to the right, and back along the other."""
    first: list[tuple[Points | None, int, int]] = [(None, 0, 0)]
    last: tuple[Points | None, int, int] = (None, len(upper.corners), len(lower.corners))
    stops = [*first, *((one.at, one.upper, one.lower) for one in between), last]
    found = []
    for (a, i, j), (b, k, m) in pairwise(stops):
        there, back = upper.corners[i:k], lower.corners[j:m][::-1]
        start = () if a is None else (a,)
        end = () if b is None else (b,)
        found.append((*start, *there, *end, *back))
    return found


def middle_of(outline: Sequence[Points]) -> complex:
    """A place for a letter: of a grid over the area the point within it that is farthest from its outline."""
    corners = np.array([complex(nominal(corner)) for corner in outline])
    xs, ys = (np.linspace(part.min(), part.max(), GRID)[1:-1] for part in (corners.real, corners.imag))
    points = (xs[None, :] + 1j * ys[:, None]).ravel()
    a, b = corners[None, :], np.roll(corners, -1)[None, :]
    far = np.min(_distances(points[:, None], a, b), axis=1) - NEARER * np.abs(points - np.mean(corners))
    return complex(points[int(np.argmax(np.where(_within(points[:, None], a, b), far, -np.inf)))])


def _distances(p: Corners, a: Corners, b: Corners) -> npt.NDArray[np.float64]:
    """Of points from segments (mm)."""
    along = b - a
    long = np.maximum(np.abs(along) ** 2, 1e-12)
    share = np.clip(((p - a) * along.conj()).real / long, 0.0, 1.0)
    return np.asarray(np.abs(p - a - share * along), dtype=float)


def _within(p: Corners, a: Corners, b: Corners) -> npt.NDArray[np.bool_]:
    """Whether a ray to the right leaves the outline an odd number of times."""
    over = (a.imag > p.imag) != (b.imag > p.imag)
    high = np.where(over, b.imag - a.imag, 1.0)
    right = a.real + (b.real - a.real) * (p.imag - a.imag) / high > p.real
    return np.asarray(np.sum(over & right, axis=1) % 2 == 1)
