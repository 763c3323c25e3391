"""The maximum pressure angle of a slider-crank: drawn with the crank square to the guide, away from it."""

from __future__ import annotations

from math import pi

import numpy as np

from ...algebra.quantity import Quantity
from ...board.construction import View
from ...board.paper.marks import Dot, Role
from ...designs.quantities import ALPHA_MAX
from ...diagram.single import pivot as ground
from ...plane import Reals, nominal, unit
from ...words import Words
from .angles import marked, valued
from .dimensions import offset as offset_drawn
from .draft import Draft
from .linkage import crank_circle, slider
from .touching import on_guide

SHORT = 1e-6  # mm: C′ below B′


def greatest_pressure(draft: Draft, crank: Quantity, coupler: Quantity, offset: Quantity) -> Reals:
    """α_max in degrees: between the coupler and the guide, B′ being as far from the guide as it gets."""
    board = draft.board
    place = board.open_pane(View.MECHANISM, f"alpha {draft.number}", Words("最大压力角", "Maximum pressure angle"))
    board.step(
        Words(
            "曲柄垂直于导路且 $B$ 离导路最远时压力角最大。按各杆长度作此位置 $AB′C′$，量连杆 $B′C′$ 与导路的夹角。",
            "The pressure angle is greatest with the crank perpendicular to the guide and $B$ at its greatest "
            "distance from it. Draw this position, $AB′C′$, and measure the angle between the coupler $B′C′$ and the "
            "guide.",
        ),
        place,
    )
    per_mm = 1e-3 / board.scale_of(place).value
    a = board.locate(place, "A", 0j)
    b = board.locate(place, "B′", board.lay_off(a, 1j, crank.value * per_mm, key="AB′"))
    n = board.lay_off(a, -1j, offset.value * per_mm)
    guide = board.parallel(n, 1 + 0j)
    c = on_guide(board, guide, b, np.abs(b - n), coupler.value * per_mm, "C′")
    c = board.locate(place, "C′", board.either(c))
    board.rule(place, guide, c)
    board.join(place, a, n, Role.CONSTRUCTION)
    offset_drawn(draft, place, a, n)
    for one, other in ((a, b), (b, c)):
        board.join(place, one, other, Role.LINK)
    for letter, at in (("A", a), ("B′", b), ("C′", c)):
        board.plot(place, at, letter, Dot.JOINT)
    board.depict(place, ground(a))
    crank_circle(draft, a, np.abs(b - a), place, sweep=pi)
    slider(draft, (c,), 1 + 0j, place)
    level = abs(complex(nominal(n - c))) > SHORT
    along = board.parallel(c, unit(n - c) if level else -guide.along, key="nn").along
    alpha = 90.0 - np.abs(90.0 - np.degrees(np.abs(board.gauge(0j, (b - c) / along))))
    own = draft.of_this(ALPHA_MAX)
    marked(draft, c, (n, b), valued(draft, own.symbol, alpha), key=own.key, place=place)
    return alpha
