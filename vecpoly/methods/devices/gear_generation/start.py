"""Where the involute starts: the corner of the rack touches it there, or has cut off what lies below."""

from __future__ import annotations

from math import sqrt, tan

import numpy as np

from ....board.board import Board
from ....devices.gears.generation import GearGeneration
from ....plane import nominal
from ..bench import trial_board
from .rack import contact, corner_at, half_thickness, on_gear, place_rack

TRIED, CLOSER, OVER = 41, 9, 1e-9  # places in a row, how often closer; of the range: above the base circle


def cuts_in(board: Board, gear: GearGeneration, mm: float) -> bool:
    """Whether the rack's corner reaches below N."""
    rack = place_rack(trial_board(board), gear, mm)
    return rack.tip < complex(nominal(rack.foot)).imag


def crossing(board: Board, gear: GearGeneration, mm: float) -> float:
    """How far the corner stands beside OP (mm) where its path crosses the involute: by trial on scratch paper."""
    rack = place_rack(trial_board(board), gear, mm)
    base, half = float(nominal(np.abs(rack.foot))), half_thickness(rack)
    low, high = sqrt(max(base**2 - rack.tip**2, 0.0)), (rack.r - rack.tip) / tan(gear.alpha.si)
    low += OVER * (high - low)
    for _ in range(CLOSER):
        aside = np.linspace(low, high, TRIED)
        at, cut = corner_at(rack, aside)
        touch, way = contact(trial_board(board), rack, np.abs(at))
        flank = on_gear(rack, touch, way, half, base)
        clear = np.angle(cut / flank) < 0  # the corner has left the tooth, to its right
        first = max(int(np.argmax(clear)), 1)
        low, high = float(aside[first - 1]), float(aside[first])
    return high
