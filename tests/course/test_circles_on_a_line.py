"""The drawn values as circles on the exact line fill the frame: they do not lie flat on its axis."""

from __future__ import annotations

import numpy as np
import pytest
from matplotlib.figure import Figure

from vecpoly.report.course.checks.comparison import FLAT, spread


@pytest.mark.parametrize("end", [1.2, 3.0, 10.0, 1e3, -1e3])
def test_drawn_values_take_a_good_part_of_the_frame_however_far_the_line_runs_on(end: float) -> None:
    at, told = Figure().add_axes((0.1, 0.1, 0.8, 0.8)), np.array([0.2, 0.5, 1.0])
    at.set_ylim(min(0.0, end), max(1.0, end))
    words = spread(at, told)
    bottom, top = at.get_ylim()
    assert np.ptp(told) >= FLAT * (top - bottom) and bottom <= told.min() and told.max() <= top
    assert bool(words.en) is (end != 1.2), "what is cut off is told"
