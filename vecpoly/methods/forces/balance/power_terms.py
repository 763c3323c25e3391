"""The power of every load, read off the velocity polygon:
a force by the component of its point's velocity along it, a couple by ω."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from ....algebra.quantity import Expr, magnitude
from ....board.board import NO_LENGTH
from ....board.construction import View
from ....board.paper.marks import Dot, Role
from ....errors import EquilibriumError
from ....mechanism.asked.forces import load_named
from ....mechanism.loads import Force, Load, Moment
from ....names import At, Named, omega
from ....plane import Points, Reals, ahead, dot, nominal, unit
from ....words import Words
from ...desk import POLE
from ...kinematics.image import found_tip
from ..acting import OTHER_END
from ..friction import STILL
from ..lines.letters import foot_letter
from ..state import Statics


@dataclass(frozen=True, slots=True, kw_only=True)
class Rate:
    """How fast a load's place moves along it: v (m/s) or ω (rad/s) as measured,
    its sign by all hands, and where it was measured."""

    expr: Expr
    sign: Reals
    letters: str = ""
    tip: Points = 0j  # on the velocity polygon; foot on the load's direction through the pole
    foot: Points = 0j
    start: Points = 0j  # the pole; of a cylinder the tip of the pin of its barrel

    @property
    def way(self) -> int:
        """Sign by the nominal hand: 0 where nothing moves."""
        return int(nominal(self.sign))


@dataclass(frozen=True, slots=True, kw_only=True)
class Work:
    """The power of one given load: |F| × |v| with its sign."""

    named: Named
    expr: Expr
    sign: Reals
    rate: Rate
    inertia: bool = False  # of an inertia force or couple

    @property
    def value(self) -> Reals:
        """Signed power (W)."""
        return self.sign * self.expr.value


def works(st: Statics) -> Iterator[Work]:
    """Powers of the loads of given size, of the inertia forces and couples, of the weights."""
    for load in st.loads.all:
        if load.size is not None:
            rate, named = rate_of(st, load), load_named(load)
            signed = st.size_of(load)
            way = 1.0 if st.is_told_signed(load) else np.sign(signed)
            size = magnitude(named.symbol, way * signed, named.unit)
            yield Work(named=named, expr=size * rate.expr, sign=way * rate.sign, rate=rate)
    for mass in st.loads.masses:
        yield from _mass_works(st, mass.link, mass.centre)


def powers(st: Statics) -> dict[str, Reals]:
    """Power (W) of each load of given size, of the inertia of each link (force and couple together), of each weight;
    of a cylinder or a spring of both its ends together. Nothing is drawn or written."""
    found: dict[str, Reals] = {}
    for work in works(st):
        key = work.named.key.replace("M_I", "F_I", 1) if work.inertia else work.named.key.removesuffix(OTHER_END)
        found[key] = found.get(key, 0.0) + work.value
    return found


def rate_of(st: Statics, load: Load) -> Rate:
    """v of a force's point along the force, or ω of a moment's link."""
    if isinstance(load, Moment):
        return turning(st, load.link)
    if load.against:
        return lengthening(st, load)
    along = st.along(load)
    return along_force(st, At(load.point, load.link), along, load_named(load).symbol)


def turning(st: Statics, link: str) -> Rate:
    """ω of a link; one that does not turn by this hand may turn by another."""
    value = st.desk.turns[omega(link)].value
    still = np.abs(value) <= STILL * st.speed / st.mech.scale
    return Rate(expr=magnitude(f"ω_{link}", np.abs(value), "rad/s"), sign=np.where(still, 0, np.sign(value))[()])


def along_force(st: Statics, at: At, along: Points, symbol: str) -> Rate:
    """The component of a point's velocity along a force,
    measured from the pole to the foot of the perpendicular from the tip."""
    board, desk = st.board, st.desk
    tip = found_tip(desk, View.VELOCITY, at)
    part = dot(along, tip)
    foot = along * part
    small = np.abs(part) < NO_LENGTH
    whole = desk.tip_label(View.VELOCITY, desk.canonical(at))
    letters = f"{POLE[View.VELOCITY]} {whole if abs(nominal(foot - tip)) < NO_LENGTH else foot_letter(whole, symbol)}"
    sign = np.where(small, 0, np.sign(part))[()]
    return Rate(
        expr=board.mu(View.VELOCITY) * board.measure(0j, foot, letters), sign=sign, letters=letters, tip=tip, foot=foot
    )


def lengthening(st: Statics, thrust: Force) -> Rate:
    """How fast a cylinder grows longer:
    the part along it of the velocity of its rod's pin against that of its barrel's."""
    board, desk = st.board, st.desk
    along = desk.towards(thrust.foot, thrust.point)
    head, base = (
        found_tip(desk, View.VELOCITY, At(letter, link))
        for letter, link in ((thrust.point, thrust.link), (thrust.foot, thrust.against))
    )
    part = dot(along, head - base)
    foot = ahead(base, along, part)
    start, whole = (
        desk.start_label(View.VELOCITY, desk.canonical(At(letter, link)))
        for letter, link in ((thrust.foot, thrust.against), (thrust.point, thrust.link))
    )
    letters = (
        f"{start} {whole if abs(nominal(foot - head)) < NO_LENGTH else foot_letter(whole, load_named(thrust).symbol)}"
    )
    sign = np.where(np.abs(part) < NO_LENGTH, 0, np.sign(part))[()]
    return Rate(
        expr=board.mu(View.VELOCITY) * board.measure(base, foot, letters),
        sign=sign,
        letters=letters,
        tip=head,
        foot=foot,
        start=base,
    )


def idle(load: Load) -> EquilibriumError:
    """The balancing load does no work in this position."""
    return EquilibriumError(
        Words(
            f"平衡载荷 {load.name} 的作用点不沿其方向运动，在此位置不作功；请另取原动件位置或另选平衡载荷",
            f"the balancing load {load.name} does no work in this position: its point does not move along "
            "it; choose another input position or another balancing load",
        )
    )


def draw_rate(st: Statics, rate: Rate) -> None:
    """The perpendicular from the tip to the load's direction through the pole."""
    if not rate.letters or not rate.way or abs(nominal(rate.foot - rate.tip)) < NO_LENGTH:
        return
    board, view = st.board, View.VELOCITY
    board.join(view, rate.start, rate.foot, Role.CONSTRUCTION)
    board.join(view, rate.tip, rate.foot, Role.CONSTRUCTION)
    board.right_angle(view, rate.foot, unit(rate.start - rate.foot), unit(rate.tip - rate.foot))
    board.plot(view, rate.foot, rate.letters.split()[1], Dot.POINT)


def _mass_works(st: Statics, link: str, centre: str) -> Iterator[Work]:
    for acting in st.inertia.get(link, []):
        if abs(nominal(acting.vector)) < NO_LENGTH:
            continue  # a_S = 0 in this position
        rate = along_force(st, At(centre, link), unit(acting.vector), acting.named.symbol)
        size = magnitude(acting.named.symbol, np.abs(acting.vector) * st.scale.value, "N")
        yield Work(
            named=acting.named,
            expr=size * rate.expr,
            sign=rate.sign,
            rate=rate,
            inertia=acting.named.key == f"F_I{link}",
        )
    couple = st.board.found.get(f"M_I{link}", 0.0) if st.loads.inertia else 0.0  # the sheet may know it all the same
    if nominal(couple):
        rate, named = turning(st, link), Named(f"M_I{link}", f"M_{{I{link}}}", "N·m")
        yield Work(
            named=named,
            expr=magnitude(named.symbol, np.abs(couple), "N·m") * rate.expr,
            sign=np.sign(couple) * rate.sign,
            rate=rate,
            inertia=True,
        )
