"""The wheels of a train side by side, each as large as its teeth or its diameter tell, to no scale."""

from __future__ import annotations

from cmath import exp
from collections.abc import Mapping, Sequence
from math import asin

from ....board.board import Board
from ....board.construction import Place
from ....board.paper.marks import Dot, Role
from ....devices.dynamics.reduced import ReducedTrain
from ....diagram.single import disc, gear, pivot

WIDE, HIGH = 145.0, 115.0  # mm that all wheels take at most: the sketch stands in the text
LEAST = 5.0  # mm: a wheel is not drawn smaller
APART = 1.35  # of the sum of its radii: how far the pulleys of a belt stand from each other
WAYS = (1 + 0j, 1j, -1j, -1 + 0j)  # the first wheel that a shaft drives stands on its right, the next above it ...

Wheel = tuple[str, float, bool]  # its shaft, its radius, whether a belt runs on it


def draw_shafts(board: Board, place: Place, train: ReducedTrain) -> None:
    """Pulleys and the pitch circles of gears on their pivots; larger ones below."""
    at, wheels = _placed(train)
    mm = _size(at, wheels)
    for name, size, belt in sorted(wheels, key=lambda wheel: -wheel[1]):
        board.depict(place, (disc if belt else gear)(f"link {name}", at[name] * mm, max(size * mm, LEAST)))
    for pair in train.pairs:
        if pair.belt:
            _belt(board, place, at[pair.first] * mm, at[pair.second] * mm, pair.sizes[0] / pair.sizes[1])
    for name, centre in at.items():
        board.depict(place, pivot(centre * mm))
        board.plot(place, centre * mm, name, Dot.JOINT)


def _size(at: Mapping[str, complex], wheels: Sequence[Wheel]) -> float:
    """How many mm a unit is."""
    ends = [at[name] + side * radius for name, radius, _ in wheels for side in (-1 - 1j, 1 + 1j)]
    if not ends:
        return 1.0
    wide, high = (max(part) - min(part) for part in ([z.real for z in ends], [z.imag for z in ends]))
    return min(WIDE / wide, HIGH / high)


def _placed(train: ReducedTrain) -> tuple[dict[str, complex], list[Wheel]]:
    """The centres, and every wheel with the shaft on which it sits: diameters of belts as so many teeth."""
    at: dict[str, complex] = {train.main: 0j}
    used: dict[str, int] = {}
    wheels: list[Wheel] = []
    teeth = [sum(pair.sizes) for pair in train.pairs if not pair.belt]
    for name, way in sorted(train.ways.items(), key=lambda item: len(item[1])):
        if not way:
            continue
        pair, forwards = way[-1]
        here = pair.first if forwards else pair.second
        factor = (max(teeth) if teeth else 1.0) / sum(pair.sizes) if pair.belt else 1.0
        sizes = [size * factor for size in (pair.sizes if forwards else pair.sizes[::-1])]
        way_to = WAYS[min(used.get(here, 0), len(WAYS) - 1)]
        used[here] = used.get(here, 0) + 1
        at[name] = at[here] + way_to * sum(sizes) / 2 * (APART if pair.belt else 1.0)
        wheels += [(here, sizes[0] / 2, pair.belt), (name, sizes[1] / 2, pair.belt)]
    return at, wheels


def _belt(board: Board, place: Place, a: complex, b: complex, ratio: float) -> None:
    """Both outer tangents; ratio: of the radii, which together fill all but the gap."""
    both = abs(b - a) / APART
    one, other = both * ratio / (1 + ratio), both / (1 + ratio)
    lean = asin((one - other) / abs(b - a))
    for side in (1, -1):
        normal = 1j * side * exp(-1j * side * lean) * (b - a) / abs(b - a)
        board.join(place, a + one * normal, b + other * normal, Role.GIVEN)
