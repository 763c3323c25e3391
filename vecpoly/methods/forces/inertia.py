"""Inertia forces: F_I = m a_S against the acceleration,
M_I = J α against the angular acceleration, joined by h = M_I / F_I."""

from __future__ import annotations

import numpy as np

from ...algebra.formula import Node
from ...algebra.quantity import Quantity, magnitude
from ...algebra.worked import worked
from ...board.board import NO_LENGTH
from ...board.construction import LineOfAction, Place, Reading, View
from ...board.paper.marks import Dot, Role
from ...foundation.slotted import replace
from ...mechanism.asked.forces import inertia_named
from ...mechanism.loads import Mass
from ...names import At, Kind, Named, Rel, alpha, ascii_key
from ...plane import Points, Reals, nominal, unit
from ...words import Words
from ..desk import POLE
from ..kinematics.image import found_tip
from ..standing import sized
from .acting import Acting
from .bodies.bars import bars_of, past_bars
from .masses import masses, weight_force
from .senses import TURN
from .state import Statics

ARROW = 16.0  # mm: half the drawn line of a displaced inertia force
SHORT = 1.5  # mm: a shorter arm is not lettered


def inertia_forces(st: Statics) -> None:
    """Inertia force and couple of every mass from the drawn accelerations (N, N·m), and its weight, kept in
    `st.inertia`.

    Where no force is left to displace, or its arm would exceed the mechanism, the couple stays in `st.inertia_couples`.
    """
    masses(st)
    for mass in st.loads.masses:
        if st.loads.inertia:
            _inertia(st, mass)
        if st.loads.weight:
            weight_force(st, mass)


def _inertia(st: Statics, mass: Mass) -> None:
    link, s = mass.link, st.desk.name(At(mass.centre))
    tip = found_tip(st.desk, View.ACCELERATION, At(mass.centre, link))
    st.board.step(
        Words(
            f"构件 {link} 的惯性力 $F_{{I{link}}}$ 与质心加速度 $a_{{{mass.centre}}}$ 方向相反，作用于质心 ${s}$。",
            f"The inertia force $F_{{I{link}}}$ of link {link} acts at its centre of mass "
            f"${s}$, against the acceleration $a_{{{mass.centre}}}$.",
        ),
        View.MECHANISM,
    )
    force = _force(st, mass, tip)
    couple, sense = _couple(st, mass)
    if force is None:
        if sense:
            st.inertia_couples[link] = st.board.found[f"M_I{link}"]
        return
    _join(st, mass, force, couple, sense)


def _force(st: Statics, mass: Mass, tip: Points) -> Acting | None:
    """F_I = m a_S, with a_S read off the acceleration polygon; None where S has no acceleration."""
    board, link = st.board, mass.link
    named, _, _ = inertia_named(mass)
    letters = f"{POLE[View.ACCELERATION]} {st.desk.tip_label(View.ACCELERATION, At(mass.centre))}"
    if abs(complex(nominal(tip))) < NO_LENGTH:
        board.remark(
            Words(
                f"因 $a_{{{mass.centre}}}$ = 0，故 $F_{{I{link}}}$ = 0。",
                f" Here $a_{{{mass.centre}}}$ = 0, so $F_{{I{link}}}$ = 0.",
            )
        )
        st.keep(Reading(key=named.key, symbol=named.symbol, unit="N", scalar=0.0, vector=0j), 0.0)
        return None
    accel = sized(st.desk, Rel(Kind.A, At(mass.centre, link)), f"a_{{{mass.centre}}}", (0j, tip), letters)
    expr = magnitude(f"m_{link}", mass.mass, "kg") * accel
    size = board.compute(named.symbol, expr, "N")
    vector = -unit(tip) * st.mm(size.value)
    each = size.value * np.exp(1j * board.gauge(tip, 0j))
    reading = Reading(
        key=named.key,
        symbol=named.symbol,
        unit="N",
        scalar=float(nominal(size.value)),
        vector=complex(nominal(each)),
        mm=float(nominal(board.to_paper(View.ACCELERATION, accel.value))),
        line=letters,
        scale=board.scales[View.ACCELERATION].symbol,
        factor=f"m_{link}",
        formula=worked(size.node, expr, "N") if board.writes else None,
    )
    st.keep(reading, size.value, each)
    return _settle(st, mass, named, vector, st.desk.where(At(mass.centre)))


def _couple(st: Statics, mass: Mass) -> tuple[Quantity, int]:
    """M_I = J α and its sense, against α; 0 where there is none."""
    board, link, turn = st.board, mass.link, st.desk.turns.get(alpha(mass.link))
    _, named, _ = inertia_named(mass)
    rate: Reals = 0.0 if turn is None else turn.value
    sense = 0 if not mass.inertia else -int(np.sign(float(nominal(rate))))
    formula: Node | None = None
    couple = magnitude(named.symbol, 0.0, named.unit)
    if sense:
        expr = magnitude(mass.inertia_symbol, mass.inertia, "kg·m^2") * magnitude(f"α_{link}", np.abs(rate), "rad/s^2")
        couple = board.compute(named.symbol, expr, named.unit)
        formula = worked(couple.node, expr, named.unit) if board.writes else None
        way = TURN[sense]
        board.remark(
            Words(
                f"惯性力矩 $M_{{I{link}}}$ 与 $α_{link}$ 转向相反，为{way.zh}。",
                f" The inertia couple $M_{{I{link}}}$ turns against $α_{link}$, {way.en}.",
            )
        )
    signed = -mass.inertia * rate
    st.keep(
        Reading(key=named.key, symbol=named.symbol, unit=named.unit, scalar=float(nominal(signed)), formula=formula),
        signed,
    )
    return couple, sense


def _join(st: Statics, mass: Mass, force: Acting, couple: Quantity, sense: int) -> None:
    """Displace the force by h = M_I / F_I to the side where its moment about S turns as M_I does."""
    board, link = st.board, mass.link
    s = st.desk.where(At(mass.centre))
    along = unit(force.vector)
    _, _, named = inertia_named(mass)
    if not sense:
        st.keep(Reading(key=named.key, symbol=named.symbol, unit="m", scalar=0.0), 0.0)
        _draw_force(st, force.named.symbol, s, along)
        return
    arm = _arm(st, mass, force, couple)
    if float(nominal(arm.value)) > st.mech.scale:
        board.remark(
            Words(
                f"$h_{link}$ 大于机构尺寸，$F_{{I{link}}}$ 与 $M_{{I{link}}}$ 不再合成。",
                f" The distance $h_{link}$ exceeds the mechanism; $F_{{I{link}}}$ and $M_{{I{link}}}$ stay apart.",
            )
        )
        st.inertia_couples[link] = st.board.found[f"M_I{link}"]
        _draw_force(st, force.named.symbol, s, along)
        return
    _displace(st, mass, force, arm.value)


def _arm(st: Statics, mass: Mass, force: Acting, couple: Quantity) -> Quantity:
    """h = M_I / F_I."""
    _, _, named = inertia_named(mass)
    expr = couple / magnitude(force.named.symbol, np.abs(force.vector) * st.scale.value, "N")
    arm = st.board.compute(named.symbol, expr, "m")
    st.keep(
        Reading(
            key=named.key,
            symbol=named.symbol,
            unit="m",
            scalar=float(nominal(arm.value)),
            formula=worked(arm.node, expr, "m") if st.board.writes else None,
        ),
        arm.value,
    )
    return arm


def _displace(st: Statics, mass: Mass, force: Acting, arm: Reals) -> None:
    """The force at the distance h (m) from S, on the side that gives its moment the sense of M_I."""
    board, link, along = st.board, mass.link, unit(force.vector)
    s = st.desk.where(At(mass.centre))
    turning = np.sign(st.board.found[f"M_I{link}"])
    at = board.lay_off(s, -1j * along * turning, board.to_paper(View.MECHANISM, arm))
    board.remark(
        Words(
            f"将 $F_{{I{link}}}$ 平移 $h_{link}$，使其对 $ {st.desk.name(At(mass.centre))}$ 之矩与 $M_{{I{link}}}$ "
            "同向，合成为一个总惯性力。",
            f" Displaced by $h_{link}$ to the side where its moment about "
            f"${st.desk.name(At(mass.centre))}$ has the sense of $M_{{I{link}}}$, the force "
            "replaces both.",
        )
    )
    _settle(st, mass, force.named, force.vector, at)
    _draw_force(st, force.named.symbol, at, along)
    draw_arm(st, View.MECHANISM, inertia_named(mass)[2].symbol, s, at, along)


def _settle(st: Statics, mass: Mass, named: Named, vector: Points, at: Points) -> Acting:
    """The inertia force on its line, in place of an earlier one."""
    scale = st.board.scales[View.MECHANISM].value
    acting = Acting(
        named=named, vector=vector, at=at, direction=Words.same("✓"), size=f"$m_{mass.link} a_{{{mass.centre}}}$"
    )
    st.inertia[mass.link] = [acting]
    line = LineOfAction(point=complex(nominal(at)) * scale)
    st.board.revise(replace(st.board.readings[named.key], acts=line))
    return acting


def _draw_force(st: Statics, symbol: str, at: Points, along: Points) -> None:
    """The line of action on the diagram, and the force on it (not to scale), past the bar along which it acts."""
    start, way = complex(nominal(at)), complex(nominal(along))
    tail = at + past_bars(start, start + ARROW * way, way, [*bars_of(st.board.marks(View.MECHANISM))]) * along
    st.board.join(View.MECHANISM, at - ARROW * along, tail, Role.DIRECTION)
    st.board.arrow(View.MECHANISM, tail, tail + ARROW * along, Role.GIVEN, key=ascii_key(symbol), label=symbol)


def draw_arm(st: Statics, place: Place, symbol: str, s: Points, at: Points, along: Points) -> None:
    """The arm from S to the line of action, with its letter."""
    a, b, u = complex(nominal(s)), complex(nominal(at)), complex(nominal(along))
    st.board.join(place, a, b, Role.CONSTRUCTION)
    if abs(b - a) > SHORT:
        st.board.plot(place, (a + b) / 2, symbol, Dot.NONE)
        st.board.right_angle(place, b, u, (a - b) / abs(b - a))
