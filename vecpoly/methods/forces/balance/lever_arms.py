"""Forces and pairs of forces on the Zhukovsky lever: each at the tip of its point, its arm about the pole measured."""

from __future__ import annotations

from dataclasses import dataclass
from math import isfinite

import numpy as np

from ....algebra.quantity import Quantity
from ....board.board import NO_LENGTH
from ....board.construction import Pane, View
from ....board.paper.marks import Dot, Role
from ....mechanism.asked.forces import load_named, load_symbol
from ....mechanism.loads import Force
from ....names import At, Named, ascii_key
from ....plane import Line, Points, Reals, cross, foot, nominal, unit
from ...desk import POLE
from ...kinematics.image import found_tip
from ..closing.thrust import opposite_name
from ..lines.letters import arm_about_pole, pair_symbol
from ..lines.pairs import Pair
from ..state import Statics

ARROW = 16.0  # mm: forces on the lever show direction only
Tips = dict[At, Points]


@dataclass(frozen=True, slots=True, kw_only=True)
class Arm:
    """A force or a pair of forces on the lever:
    its arm about the pole (mm) and the sense of its moment by all hands."""

    mm: Quantity
    sign: Reals

    @property
    def way(self) -> int:
        """Sense by the nominal hand, 0 where there is no arm, or none that is finite."""
        sign = float(nominal(self.sign))
        return int(sign) if isfinite(sign) else 0


def force_arm(st: Statics, pane: Pane, tips: Tips, at: At, along: Points, named: Named) -> Arm:
    """The perpendicular from the pole to the force at the tip of its point, measured."""
    tip = _tip(st, tips, at)
    end = foot(Line(tip, along), 0j)
    side = cross(tip, along)
    square = abs(nominal(end - tip)) < NO_LENGTH  # then the ray itself is the arm
    letters = (
        f"{POLE[View.VELOCITY]} {st.desk.tip_label(View.VELOCITY, st.desk.canonical(at))}"
        if square
        else arm_about_pole(named.symbol)
    )
    arm = Arm(mm=st.board.measure(0j, end, letters), sign=np.where(np.abs(side) < NO_LENGTH, 0, np.sign(side))[()])
    _draw_force(st, pane, tip, along, named.symbol)
    if arm.way and not square:
        _draw_arm(st, pane, tip, end, letters)
    return arm


def thrust_arm(st: Statics, pane: Pane, tips: Tips, thrust: Force, way: int) -> Arm:
    """A thrust is two opposite forces at the tips of the pins of its cylinder: the arm is the distance of their lines.
    way: +1 where it pushes the pins apart."""
    named, along = load_named(thrust), way * st.desk.towards(thrust.foot, thrust.point)
    head, base = At(thrust.point, thrust.link), At(thrust.foot, thrust.against)
    tip, start = _tip(st, tips, head), _tip(st, tips, base)
    end = foot(Line(tip, along), start)
    side = cross(tip - start, along)
    square = abs(nominal(end - tip)) < NO_LENGTH
    pins = " ".join(st.desk.start_label(View.VELOCITY, st.desk.canonical(at)) for at in (base, head))
    letters = pins if square else arm_about_pole(named.symbol)
    arm = Arm(mm=st.board.measure(start, end, letters), sign=np.where(np.abs(side) < NO_LENGTH, 0, np.sign(side))[()])
    _draw_force(st, pane, tip, along, named.symbol)
    _draw_force(st, pane, start, -along, load_symbol(opposite_name(thrust)))
    if arm.way and not square:
        _draw_arm(st, pane, tip, end, letters, start)
    return arm


def pair_arm(st: Statics, tips: Tips, pair: Pair, sense: int) -> Arm:
    """Two opposite forces at the tips of two points of the link; the arm of the pair is the distance of the tips."""
    one, two = (_tip(st, tips, At(letter, pair.link)) for letter in (pair.p, pair.q))
    letters = " ".join(
        st.desk.start_label(View.VELOCITY, st.desk.canonical(At(letter, pair.link))) for letter in (pair.p, pair.q)
    )
    side = cross(two - one, 1j * sense * st.desk.towards(pair.p, pair.q))
    return Arm(
        mm=st.board.measure(one, two, letters), sign=np.where(np.abs(two - one) < NO_LENGTH, 0, np.sign(side))[()]
    )


def draw_pair(st: Statics, pane: Pane, tips: Tips, pair: Pair, sense: int, named: Named) -> None:
    """Both forces of the pair, as it turns its link."""
    along = 1j * sense * st.desk.towards(pair.p, pair.q)
    for letter, way in ((pair.q, along), (pair.p, -along)):
        _draw_force(st, pane, _tip(st, tips, At(letter, pair.link)), way, pair_symbol(named.symbol))


def _tip(st: Statics, tips: Tips, at: At) -> Points:
    """A tip of the velocity polygon turned by 90° clockwise, carried over once."""
    own = st.desk.canonical(at)
    if own not in tips:
        there = found_tip(st.desk, View.VELOCITY, at)
        moved = abs(complex(nominal(there))) > NO_LENGTH
        tips[own] = st.board.hand.carry_vector(-1j * there) if moved else 0j
    return tips[own]


def _draw_force(st: Statics, pane: Pane, tip: Points, along: Points, symbol: str) -> None:
    st.board.arrow(pane, tip, tip + ARROW * along, Role.RESULT, key=ascii_key(symbol), label=symbol)


def _draw_arm(st: Statics, pane: Pane, tip: Points, end: Points, letter: str, start: Points = 0j) -> None:
    st.board.join(pane, start, end, Role.CONSTRUCTION)
    st.board.plot(pane, (start + end) / 2, letter, Dot.NONE)
    if abs(nominal(end - tip)) > 1.0:
        st.board.join(pane, tip, end, Role.CONSTRUCTION)
        st.board.right_angle(pane, end, unit(start - end), unit(tip - end))
