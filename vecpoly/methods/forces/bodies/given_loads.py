"""The given loads on the kinematic diagram:
arrows at their points, curved arrows for moments, the balancing load's symbol."""

from __future__ import annotations

import numpy as np

from ....board.construction import View
from ....board.paper.arrow_radius import clear_radius
from ....board.paper.marks import Role, Segment, Vector
from ....board.paper.pulling import pulls
from ....foundation.slotted import replace
from ....mechanism.asked.forces import load_symbol
from ....mechanism.loads import Force, Moment
from ....plane import nominal
from ..state import Statics

LENGTH = 18.0  # mm of an arrow
RADIUS = 13.0  # mm of a curved arrow: outside the one of ω


def draw_given_loads(st: Statics) -> None:
    """Arrows of the loads of given size; a balancing force along its direction. Its moment's sense is not known yet."""
    for load in st.loads.all:
        if isinstance(load, Force) and load.against:
            along = float(np.angle(complex(nominal(st.desk.towards(load.foot, load.point)))))
            _force(st, replace(load, direction=along))
            _force(st, replace(load, point=load.foot, direction=along + np.pi))
        elif isinstance(load, Force):
            _force(st, load)
        elif load.size is not None:
            _moment(st, load)


def _force(st: Statics, load: Force) -> None:
    """Pulling at its point or pressing on it, whichever stays clear of the links drawn."""
    at = complex(nominal(st.desk.at[load.point]))
    u = complex(np.exp(1j * load.direction)) * (-1 if load.size is not None and load.size < 0 else 1)
    pull, press = (at, at + LENGTH * u), (at - (LENGTH + 2.0) * u, at - 2.0 * u)
    start, end = max((press, pull), key=lambda ends: _clearance(st, ends))
    st.board.arrow(View.MECHANISM, start, end, Role.RESULT, key=load.name, label=load_symbol(load.name))


def ways_of_loads(st: Statics) -> tuple[set[str], set[str]]:
    """The symbols of the forces that press on their points on the kinematic diagram, and of those that pull at them."""
    here = st.board.marks(View.MECHANISM)
    places = {load_symbol(one.name): nominal(st.desk.at[one.point]) for one in st.loads.forces if not one.against}
    ways = {symbol: pulls(here, symbol, complex(at)) for symbol, at in places.items()}
    return {symbol for symbol, way in ways.items() if way is False}, {symbol for symbol, way in ways.items() if way}


def _clearance(st: Statics, ends: tuple[complex, complex]) -> float:
    """Distance of the arrow's middle and far end from the links and other arrows on the diagram."""
    lines = [
        m.a + (m.b - m.a) * np.linspace(0.0, 1.0, 40)
        for m in st.board.marks(View.MECHANISM)
        if isinstance(m, Vector) or (isinstance(m, Segment) and m.role is Role.LINK)
    ]

    def clear(end: complex) -> float:
        return min((float(np.abs(line - end).min()) for line in lines), default=0.0)

    far = max(ends, key=clear)
    spots = (far, (ends[0] + ends[1]) / 2)
    return min((float(np.abs(line - spot).min()) for line in lines for spot in spots), default=0.0)


def _moment(st: Statics, load: Moment) -> None:
    points = st.mech.link(load.link).points
    pivot = next((p for p in points if p in st.mech.frame), next(iter(points)))
    assert load.size is not None
    at, ccw = st.desk.at[pivot], load.size > 0
    radius = clear_radius(st.board.marks(View.MECHANISM), complex(nominal(at)), RADIUS)
    st.board.curved_arrow(View.MECHANISM, at, radius, 2.2 if ccw else 0.9, ccw, load_symbol(load.name))
