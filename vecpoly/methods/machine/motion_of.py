"""How fast the equivalent link moves: ω of one that turns, v of a slider, as drawn."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ...algebra.quantity import Product, Quantity, magnitude
from ...board.board import NO_LENGTH
from ...board.construction import View
from ...mechanism.asked.machine import Equivalent, at_rest
from ...mechanism.groups.assur import ends
from ...mechanism.model import FRAME, Prismatic
from ...names import At, Kind, Rel, omega
from ...plane import Points, Reals, nominal
from ..desk import POLE
from ..forces.friction import STILL
from ..forces.state import Statics
from ..kinematics.image import found_tip
from ..standing import computed


@dataclass(frozen=True, slots=True, kw_only=True)
class Motion:
    """size: |ω| or |v|; sign: of ω (ccw positive), 1 of v; symbol: ω_1, v_C."""

    link: str
    size: Quantity
    sign: Reals
    symbol: str
    slides: bool

    @property
    def of_speeds(self) -> str:
        """The unit of v_S over it."""
        return "" if self.slides else "m"

    @property
    def of_turns(self) -> str:
        """The unit of ω_i over it."""
        return "1/m" if self.slides else ""


def motion_of(st: Statics, to: Equivalent) -> Motion:
    """Raises DeadPointError where the link stands still."""
    return _sliding(st, to) if to.slide else _turning(st, to)


def _turning(st: Statics, to: Equivalent) -> Motion:
    turn = st.desk.turns[omega(to.link)]
    if turn.never or abs(float(nominal(turn.value))) <= STILL * st.speed / st.mech.scale:
        raise at_rest(st.mech, to)
    symbol = f"ω_{st.mech.number(to.link)}"
    size = magnitude(symbol, np.abs(turn.value), "rad/s")
    return Motion(link=to.link, size=size, sign=np.sign(turn.value), symbol=symbol, slides=False)


def _sliding(st: Statics, to: Equivalent) -> Motion:
    at = At(_pin(st, to.link), to.link)
    tip = found_tip(st.desk, View.VELOCITY, at)
    if abs(complex(nominal(tip))) < NO_LENGTH:
        raise at_rest(st.mech, to)
    symbol, speed = f"v_{at.point}", speed_of(st, at, tip)
    size = speed if isinstance(speed, Quantity) else st.board.compute(symbol, speed, "m/s")
    return Motion(link=to.link, size=size, sign=1.0, symbol=symbol, slides=True)


def speed_of(st: Statics, at: At, tip: Points) -> Quantity | Product:
    """The speed of a point as it was computed, or given, and laid off; else what is measured from the pole to its
    tip."""
    if (known := computed(st.desk, Rel(Kind.V, at))) is not None:
        return known
    letters = f"{POLE[View.VELOCITY]} {st.desk.tip_label(View.VELOCITY, st.desk.canonical(at))}"
    return st.board.mu(View.VELOCITY) * st.board.measure(0j, tip, letters)


def _pin(st: Statics, link: str) -> str:
    """A lettered point of the slider: the pin of its pair with the frame, where it carries that."""
    pins = [one.pin for one in st.mech.joints if isinstance(one, Prismatic) and set(ends(one)) == {link, FRAME}]
    points = st.mech.link(link).points
    return pins[0] if pins and pins[0] in points else next(iter(points))
