"""What is seen of the generation: the rack in its places round the gear, and the tooth that they leave."""

from __future__ import annotations

from itertools import pairwise
from math import hypot, pi, tan

import numpy as np

from ....board.board import Board
from ....board.paper.marks import Role
from ....devices.gears.generation import GearGeneration
from ....plane import nominal
from .rack import VIEW, Rack, contact, corner_at, half_thickness, on_gear, place_rack

BEFORE, AFTER = 1.1, 0.35  # pitches before and after the rack stands over P
POINTS = 9  # of a flank
ROUND = 0.35  # of the clearance: how far the rack's rounded tip draws in


def draw_places(board: Board, rack: Rack) -> None:
    """The rack's teeth on either side of the gear's tooth, each rolled on a little from place to place."""
    pitch = pi * rack.module
    for turned in np.linspace(-BEFORE, AFTER, rack.gear.steps) * pitch / rack.r:
        spots = [(spot + rack.r * turned) * np.exp(1j * turned) for spot in _outline(rack)]
        for line in (spots, [-np.conj(spot) for spot in spots]):
            for a, b in pairwise(line):
                board.join(VIEW, a, b, Role.CONSTRUCTION)


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
    """Involute, path of the corner and top land of the tooth under P, both flanks; lengths in mm on paper."""
    trial = board.scratch()
    trial.step(VIEW.title)
    rack = place_rack(trial, gear, mm)
    base, half = float(nominal(np.abs(rack.foot))), half_thickness(rack)
    at, way = contact(trial, rack, np.linspace(hypot(aside, rack.tip), tip, POINTS))
    flank = np.asarray(on_gear(rack, at, way, half, base))
    fillet = np.asarray(corner_at(rack, np.linspace(0.0, aside, POINTS))[1])
    top = tip * np.exp(1j * np.linspace(np.angle(flank[-1]), pi - np.angle(flank[-1]), 5))
    for mirrored in (False, True):
        for line in (flank, fillet):
            points = -np.conj(line) if mirrored else line
            board.curve(VIEW, [complex(spot) for spot in points], Role.LINK)
    board.curve(VIEW, [complex(spot) for spot in top], Role.LINK)
