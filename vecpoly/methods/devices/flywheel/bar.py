"""The energy indicator bar, and what is read off it: ΔW_max, and where the speed is greatest and least."""

from __future__ import annotations

import numpy as np

from ....algebra.quantity import Quantity
from ....devices.dynamics.asked import DW, PHI_MAX, PHI_MIN
from ....foundation.slotted import replace
from ....plane import Reals, nominal
from ...diagrams.indicator import Bar, indicator
from ..bench import Bench
from ..cam.read.readings import noted
from .pieces import Pieces
from .scales import INDICATOR, TORQUE
from .words import BAR, BAR_SECTION, extremes, read_off_bar


def energy_bar(bench: Bench, pieces: Pieces) -> Quantity:
    """Draw it; ΔW_max."""
    board = bench.board
    board.section(BAR_SECTION)
    board.step(BAR, INDICATOR)
    bar = indicator(board, INDICATOR, pieces.works, pieces.letters, DW.symbol)
    board.remark(extremes(bar.letters[bar.top], bar.letters[bar.bottom]))
    swing = bench.worked(DW, board.mu(INDICATOR) * bar.swing)
    bench.read_off(DW, INDICATOR, bar.swing, f"{bar.letters[bar.bottom]} {bar.letters[bar.top]}")
    if not pieces.ends:
        _told_as_read(bench, pieces, bar)
    for named, number in ((PHI_MAX, bar.top), (PHI_MIN, bar.bottom)):
        if pieces.ends:
            mm = 0.0 * pieces.ends[number].real
            if number % len(pieces.works):
                mm = board.measure(0j, pieces.ends[number].real + 0j, f"O {bar.letters[number]}").value
            noted(bench, named, *_angle(bench, mm), f"O {bar.letters[number]}", "μ_{φ}")
    return swing


def _told_as_read(bench: Bench, pieces: Pieces, bar: Bar) -> None:
    """Beside energies that are exact the one that is read is told to be so, with their difference."""
    first, last = sorted((bar.bottom, bar.top))
    between = abs(float(nominal(sum(pieces.works[first:last], start=np.float64(0.0)))))
    words = read_off_bar(bar.letters[bar.top], bar.letters[bar.bottom], between)
    bench.board.revise(replace(bench.board.readings[DW.key], remark=words))


def _angle(bench: Bench, mm: Reals) -> tuple[Reals, Reals]:
    """In degrees, and how long it is on paper."""
    return np.degrees(mm * bench.board.scale_of(TORQUE).right.value), mm
