"""The wheels of a train side by side, each as large as its teeth or its diameter tell, with what turns them and what
they lift; to no scale."""

from __future__ import annotations

from cmath import exp, pi
from collections.abc import Sequence
from math import asin

from ....board.board import Board
from ....board.construction import Place
from ....board.paper.marks import Dot, Role
from ....devices.dynamics.reduced import ReducedTrain
from ....devices.dynamics.shafts import Shaft
from ....diagram.single import disc, gear, outline, pivot
from ..turning import arrow_about
from .shafts import APART, Shafts, Wheel, placed

WIDE, HIGH = 132.0, 96.0  # mm that all takes at most: the sketch stands in the text
SPEED, MOMENT, NEXT = 9.0, 14.0, 4.0  # mm: radii of the curved arrows, from one to the next
BEARING = 9.0  # mm: the radius of wheels that a bearing does not hide
OUTSIDE = 2.0  # mm from a rim to the size of its wheel
DRUM, LEAST_DRUM = 0.5, 9.0  # of the radius of the wheel beside it; mm
_SPREAD = (-0.35, -0.2, -0.1, 0.0, 0.1, 0.2, 0.35)  # of half a turn: where an arrow about a shaft is
ROPE, LOAD, WEIGHT = 5.0, 12.0 + 8.0j, 11.0  # mm: rope below the wheels; the load's width and height; its arrow


def draw_shafts(board: Board, place: Place, train: ReducedTrain) -> None:
    """Pulleys and the pitch circles of gears, which touch, larger ones below; their bearings where these leave all of
    them to be seen; speeds, moments, the load."""
    shafts = _fitted(train)
    for wheel in sorted(shafts.wheels, key=lambda wheel: -wheel.radius):
        board.depict(place, (disc if wheel.belt else gear)(f"link {wheel.shaft}", shafts.at[wheel.shaft], wheel.radius))
    for pair in train.pairs:
        if pair.belt:
            _belt(board, place, shafts.at[pair.first], shafts.at[pair.second], pair.sizes[0] / pair.sizes[1])
    if train.hoist is not None:
        _load(board, place, shafts, *train.hoist)
    borne = min(wheel.radius for wheel in shafts.wheels) >= BEARING
    for name, centre in shafts.at.items():
        if borne:
            board.depict(place, pivot(centre))
        board.plot(place, centre, name, Dot.JOINT)
        _turning(board, place, shafts, name, train.shafts[name])
    taken = [spot for name in shafts.at for spot in _over(shafts, name, train.shafts[name])]
    for wheel in shafts.wheels:
        taken.append(_size(board, place, shafts, wheel, taken))


def _fitted(train: ReducedTrain) -> Shafts:
    """As large as there is room for; below a hoist the load needs some."""
    shafts = placed(train)
    low, high = shafts.corners
    below = ROPE + LOAD.imag + WEIGHT if train.hoist is not None else 0.0
    span = high - low
    return shafts.enlarged(min(WIDE / span.real, (HIGH - below) / span.imag))


def _belt(board: Board, place: Place, a: complex, b: complex, ratio: float) -> None:
    """Both outer tangents; ratio: of the radii, which together fill all but the gap."""
    both = abs(b - a) / APART
    one, other = both * ratio / (1 + ratio), both / (1 + ratio)
    lean = asin((one - other) / abs(b - a))
    for side in (1, -1):
        normal = 1j * side * exp(-1j * side * lean) * (b - a) / abs(b - a)
        board.join(place, a + one * normal, b + other * normal, Role.GIVEN)


def _turning(board: Board, place: Place, shafts: Shafts, name: str, shaft: Shaft) -> None:
    """ω over the shaft, and the moments on it, those that resist against ω; within its largest wheel, or about it."""
    largest, ccw, side = max(shafts.on(name)), shafts.turns[name] > 0, shafts.free_side(name)
    inside, speed = _is_inside(shafts, name), _speed(shafts, name)
    arrow_about(board, place, shafts.at[name], speed, 1j, ccw, f"ω_{{{name}}}")
    radius = max(largest + NEXT / 2, speed + NEXT) if not inside or shaft.lifts is not None else MOMENT
    for letter, moment, along in (("d", shaft.drives, ccw), ("r", shaft.resists, not ccw)):
        if moment is not None:
            arrow_about(board, place, shafts.at[name], radius, side, along, f"M_{{{letter}{name}}}")
            radius += NEXT


def _is_inside(shafts: Shafts, name: str) -> bool:
    """Whether the arrows about a shaft have room within its largest wheel."""
    return max(shafts.on(name)) > MOMENT + NEXT


def _speed(shafts: Shafts, name: str) -> float:
    """The radius of the arrow of ω."""
    return SPEED if _is_inside(shafts, name) else max(shafts.on(name)) + NEXT / 2


def _over(shafts: Shafts, name: str, shaft: Shaft) -> list[complex]:
    """Places on the arrow of ω and beside it, where its letter stands; likewise of a moment."""
    ways = [1j, *([shafts.free_side(name)] if shaft.drives is not None or shaft.resists is not None else [])]
    spots = [(_speed(shafts, name) + out, exp(1j * pi * part)) for part in _SPREAD for out in (0.0, NEXT)]
    return [shafts.at[name] + radius * way * turn for way in ways for radius, turn in spots]


def _size(board: Board, place: Place, shafts: Shafts, wheel: Wheel, taken: Sequence[complex]) -> complex:
    """The symbol of its teeth, or of its diameter, which are given, outside the rim, as large as all letters; where
    it stands."""
    at = shafts.beside(wheel, OUTSIDE, taken)
    board.plot(place, at, wheel.symbol, Dot.NONE)
    return at


def _load(board: Board, place: Place, shafts: Shafts, name: str, shaft: Shaft) -> None:
    """The drum, the rope that leaves it on the side that rises, the load with its weight and its speed."""
    assert shaft.drum is not None
    centre, (low, _) = shafts.at[name], shafts.corners
    radius = max(DRUM * max(shafts.on(name)), LEAST_DRUM)
    side = shafts.turns[name]
    start = centre + side * radius
    end = complex(start.real, low.imag - ROPE)
    board.depict(place, disc(f"link {name}", centre, radius))
    board.join(place, start, end, Role.GIVEN)
    half, down = LOAD.real / 2, LOAD.imag * 1j
    board.depict(place, outline("load", end - half, end + half, end + half - down, end - half - down))
    board.arrow(place, end - down, end - down - 1j * WEIGHT, Role.GIVEN, label="mg")
    beside = end + side * (half + NEXT) - down
    board.arrow(place, beside, beside + 1j * WEIGHT, Role.GIVEN, label="v")
    board.plot(place, centre + radius * exp(-0.25j * pi * side), f"D_{{{name}}}", Dot.NONE)
