"""Friction circles on a free body: one that would not be seen is drawn larger, and what touches it goes out with it."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np

from ....board.construction import Pane
from ....diagram.single import friction_circle
from ....foundation.slotted import replace
from ....plane import nominal
from ....words import Words
from ..acting import Acting
from ..state import Statics

SMALL = 1.0  # mm: a friction circle of less is drawn larger, with a note
_NEAR = 1e-6  # mm from a circle: what touches it there


def draw_circles(st: Statics, pane: Pane, link: str) -> Mapping[str, float]:
    """The friction circles of the link's pins; how many times those are enlarged that would not be seen."""
    larger = dict[str, float]()
    for point in st.mech.link(link).points:
        radius = st.rho(point)
        if radius:
            times = 1.0 if radius >= SMALL else float(np.ceil(1.5 * SMALL / radius))
            st.board.depict(pane, friction_circle(point, st.desk.at[point], radius, times))
            if times > 1:
                larger[point] = times
                told = Words(f"摩擦圆及其切线的偏距放大 {times:g} 倍", f"friction circle and tangent × {times:g}")
                st.board.note(pane, st.desk.at[point] + 6 - 6j, told)
    return larger


def tangent_as_drawn(st: Statics, forces: Sequence[Acting], larger: Mapping[str, float]) -> list[Acting]:
    """The forces, those that touch a circle drawn larger as tangents of the circle as it is drawn."""
    return [_moved_out(st, force, larger) for force in forces]


def _moved_out(st: Statics, force: Acting, larger: Mapping[str, float]) -> Acting:
    for point, times in larger.items() if force.tangent else ():
        out = force.at - st.desk.at[point]
        if abs(abs(complex(nominal(out))) - float(nominal(st.rho(point)))) < _NEAR:
            return replace(force, at=force.at + (times - 1.0) * out)
    return force
