"""What is seen of the generation: the rack in its places round the gear, and the tooth that they leave."""

from __future__ import annotations

from itertools import pairwise
from math import hypot, pi, tan

import numpy as np
from numpy.typing import NDArray

from ....board.board import Board
from ....board.paper.marks import Dot, Role
from ....devices.gears.generation import GearGeneration
from ....plane import nominal
from .rack import VIEW, Rack, contact, corner_at, half_thickness, on_gear, place_rack

BEFORE, AFTER = 1.1, 0.35  # pitches before and after the rack stands over P
POINTS = 9  # of a flank
TAKEN = 0.9  # of the path of the corner, from its lowest place: there the rounded tip cuts deeper
ROUND = 0.35  # of the clearance: how far the rack's rounded tip draws in


def draw_places(board: Board, rack: Rack) -> None:
    """The rack's teeth on either side of the gear's tooth, each rolled on a little from place to place."""
    pitch = pi * rack.module
    for turned in np.linspace(-BEFORE, AFTER, rack.gear.steps) * pitch / rack.r:
        spots = [(spot + rack.r * turned) * np.exp(1j * turned) for spot in _outline(rack)]
        for line in (spots, [-np.conj(spot) for spot in spots]):
            for a, b in pairwise(line):
                board.join(VIEW, a, b, Role.PLACE)


def _outline(rack: Rack) -> list[complex]:
    """The tooth to the right of the space over P: flank, rounded tip, flank."""
    gear, m = rack.gear, rack.module
    middle, slope = pi * m / 2, tan(gear.alpha.si)
    half = pi * m / 4
    up, down, clear = gear.ha.si * m, gear.ha.si * m, gear.c.si * m
    right = [
        complex(half + up * slope, rack.datum + up),
        complex(half - down * slope, rack.datum - down),
        complex(half - down * slope - ROUND * clear, rack.datum - down - clear),
    ]
    left = [complex(-spot.real, spot.imag) for spot in reversed(right)]
    return [spot + middle for spot in (*right, *left)]


def draw_tooth(board: Board, gear: GearGeneration, mm: float, tip: float, aside: float) -> None:
    """Involute, fillet, root and top land of the tooth under P, both flanks; S on the right one. In mm on paper."""
    trial = board.scratch()
    trial.step(VIEW.title)
    rack = place_rack(trial, gear, mm)
    base, half = float(nominal(np.abs(rack.foot))), half_thickness(rack)
    at, way = contact(trial, rack, np.linspace(hypot(aside, rack.tip), tip, POINTS))
    flank = np.asarray(on_gear(rack, at, way, half, base))
    fillet = _fillet(rack, aside)
    root = (rack.tip - gear.c.si * rack.module) * np.exp(1j * np.linspace(np.angle(fillet[0]), pi / 2 - pi / gear.z, 3))
    top = tip * np.exp(1j * np.linspace(np.angle(flank[-1]), pi - np.angle(flank[-1]), 5))
    for mirrored in (False, True):
        for line in (flank, fillet, root):
            points = -np.conj(line) if mirrored else line
            board.curve(VIEW, [complex(spot) for spot in points], Role.LINK)
    board.curve(VIEW, [complex(spot) for spot in top], Role.LINK)
    board.plot(VIEW, complex(flank[0]), "S", Dot.POINT)


def _fillet(rack: Rack, most: float) -> NDArray[np.complex128]:
    """The path of the rack's corner, which its rounded tip takes over towards the root circle."""
    aside = np.linspace(0.0, most, 2 * POINTS)
    share = np.clip(aside / (TAKEN * most), 0.0, 1.0)
    deep = (1.0 - share**2 * (3.0 - 2.0 * share)) * rack.gear.c.si * rack.module
    path = np.asarray(corner_at(rack, aside)[1], dtype=complex)
    return np.asarray((np.abs(path) - deep) * np.exp(1j * (np.angle(path) - ROUND * deep / rack.r)), dtype=complex)
