"""The energy indicator bar, and what is read off it: ΔW_max, and where the speed is greatest and least."""

from __future__ import annotations

import numpy as np

from ....algebra.quantity import Quantity
from ....devices.dynamics.asked import DW, PHI_MAX, PHI_MIN
from ....plane import Reals
from ...diagrams.indicator import indicator
from ..bench import Bench
from ..cam.read.readings import noted
from .pieces import Pieces
from .scales import INDICATOR, TORQUE
from .words import BAR, BAR_SECTION, extremes


def energy_bar(bench: Bench, pieces: Pieces) -> Quantity:
    """Draw it; ΔW_max."""
    board = bench.board
    board.section(BAR_SECTION)
    board.step(BAR, INDICATOR)
    bar = indicator(board, INDICATOR, pieces.works, pieces.letters, DW.symbol)
    board.remark(extremes(bar.letters[bar.top], bar.letters[bar.bottom]))
    swing = bench.worked(DW, board.mu(INDICATOR) * bar.swing)
    bench.read_off(DW, INDICATOR, bar.swing, f"{bar.letters[bar.bottom]} {bar.letters[bar.top]}")
    for named, number in ((PHI_MAX, bar.top), (PHI_MIN, bar.bottom)):
        if pieces.ends:
            mm = 0.0 * pieces.ends[number].real
            if number % len(pieces.works):
                mm = board.measure(0j, pieces.ends[number].real + 0j, f"O {bar.letters[number]}").value
            noted(bench, named, *_angle(bench, mm), f"O {bar.letters[number]}", "μ_{φ}")
    return swing


def _angle(bench: Bench, mm: Reals) -> tuple[Reals, Reals]:
    """In degrees, and how long it is on paper."""
    return np.degrees(mm * bench.board.scale_of(TORQUE).right.value), mm
