"""A link on a fixed pin with a balancing moment: the forces on it and the frame's reaction form a couple, M = R h."""

from __future__ import annotations

import numpy as np

from ....algebra.formula import sym
from ....algebra.quantity import Product, Quantity, magnitude
from ....board.board import NO_LENGTH
from ....board.construction import View
from ....board.paper.marks import Dot, Role
from ....mechanism.loads import Moment
from ....mechanism.model import FRAME, Revolute
from ....names import Named
from ....plane import Points, Reals, dot, foot, nominal, unit
from ....words import Words
from ...registry import Stage, method
from ..acting import Drawn
from ..bodies.link_polygon import answered, unread
from ..lines.arms import moments_at, size_of
from ..lines.beside import clear_of
from ..lines.links_of_group import Held
from ..lines.meeting import line_of_load, name_once
from ..lines.resultant import Resultant, resultant
from ..readings import keep_arm, keep_nothing, keep_value, measured
from ..senses import TURN, pin_words
from ..state import OFF_SHEET, Statics
from .balancing_force import nothing_acts

_SOURCE = "机械原理, equilibrium of the crank"
ROOM = 12.0  # mm: beside a shorter arm a right angle is only clutter


@method(
    stage=Stage.FORCE,
    group="crank, balancing moment",
    source=_SOURCE,
    example="4-3a",
    title=Words("曲柄：平衡力矩 M = R h", "Crank: balancing moment M = R h"),
)
def moment_on_crank(st: Statics, held: Held) -> None:
    """R_frame = −P (P: resultant of the forces on the link), tangent to the friction circle;
    M_b = P h against their couple."""
    assert isinstance(held.joint, Revolute) and isinstance(st.unknown, Moment)
    load, number, pin = resultant(st, held.link), st.mech.number(held.link), held.joint.point
    if load.is_couple:
        _pure_couple(st, held, load)
        return
    st.board.step(
        Words(
            f"取构件 {number} 为分离体，已知 {load.told.zh}。",
            f"Isolate link {number}: {load.told.en} {'is' if load.is_single else 'are'} known.",
        ),
        View.MECHANISM,
    )
    drawn = _frame_side(st, held, load)
    u = -load.line.along
    sense = st.moment_sense(pin, FRAME, held.link)
    at = st.touch(pin, u, sense)
    frame = st.named(FRAME, held.link).symbol
    one = _joined(load)
    st.board.remark(
        Words(
            f"机架反力 ${frame}$ 与{one.zh}等值、反向、平行。",
            f" The frame's reaction ${frame}$ is equal, opposite and parallel to {one.en}.",
        )
    )
    st.board.remark(
        pin_words(st, pin, FRAME, held.link, at)
        if sense
        else Words(
            f"不计 ${pin}$ 处摩擦，${frame}$ 过 ${pin}$。",
            f" Without friction at ${pin}$, ${frame}$ passes through ${pin}$.",
        )
    )
    st.settle(FRAME, held.link, -load.vector, at, drawn, sense, computed=unread(st, load))
    _couple(st, held, load, at, drawn)


def _joined(load: Resultant) -> Words:
    """What the frame's reaction is parallel to, and where that acts."""
    if load.is_single:
        return Words(f" {load.symbols.zh} ", load.symbols.en)
    zh, en = load.found
    if load.couples:
        return Words(f"已知力与力偶的合力（{zh}）", f"the resultant of the known forces and couples ({en})")
    return Words(f"已知力的合力（{zh}）", f"the resultant of the known forces ({en})")


def _frame_side(st: Statics, held: Held, load: Resultant) -> Drawn | None:
    """The frame's reaction on paper: the side that closes the polygon, or the only force turned round."""
    if len(load.forces) > 1:
        symbol = st.named(FRAME, held.link).symbol
        st.board.remark(
            Words(
                f"由 {load.symbols.zh} 作力多边形，由封闭边量得 ${symbol}$。",
                f" Draw the polygon of {load.symbols.en} and measure its closing side, ${symbol}$.",
            )
        )
    return answered(st, FRAME, held.link, load)


def _couple(st: Statics, held: Held, load: Resultant, at: Points, drawn: Drawn | None) -> None:
    """M_b against the couple of the two parallel forces."""
    line = load.line
    across = foot(line, at)  # from the frame's line square across to the other
    couple = (np.conj(across - at) * load.vector).imag
    if abs(nominal(across - at)) < NO_LENGTH:
        _through_pin(st, load.symbols.zh if load.is_single else "合力")
        return
    if abs(nominal(across - at)) > OFF_SHEET:
        _by_sum(st, held, at)
        return
    named = st.unknown_named
    arm = _arm(st, at, across)
    size = _size(st, load, held, drawn)
    turn, way = TURN[1 if nominal(couple) > 0 else -1], TURN[-1 if nominal(couple) > 0 else 1]
    st.board.remark(
        Words(
            f"两力构成{turn.zh}力偶，量得力臂 ${_letter(st)}$；${named.symbol}$ 与之平衡，为{way.zh}：",
            f" The two form a {turn.en} couple, whose arm ${_letter(st)}$ is measured; "
            f"${named.symbol}$ balances it and is {way.en}:",
        )
    )
    if not st.preliminary:
        keep_arm(st, Named("h", "h", "m"), arm)
    value = st.board.compute(named.symbol, size * arm, "N·m")
    _leave(st, load, (at, across), st.named(FRAME, held.link))
    signed = -np.sign(couple) * value.value
    keep_value(st, named, signed, size * arm)
    st.balance = signed


def _arm(st: Statics, at: Points, across: Points) -> Product:
    """The arm as it stands in the line of the moment: μ_l times its length on paper, which bears its letter."""
    return st.board.mu(View.MECHANISM) * st.board.measure(at, across, _letter(st))


def _letter(st: Statics) -> str:
    """The arm: h, or h_0 in the pass without friction."""
    return "h_0" if st.preliminary else "h"


def _size(st: Statics, load: Resultant, held: Held, drawn: Drawn | None) -> Quantity:
    named = load.forces[0].named if len(load.forces) == 1 else st.named(FRAME, held.link)
    if drawn is None:  # the only known force, which stands on no polygon
        return size_of(st, load.forces[0])
    expr = measured(st, drawn)
    if len(load.forces) > 1:
        st.board.write_worked(sym(named.symbol), expr, "N")
    return magnitude(named.symbol, expr.value, "N")


def _leave(st: Statics, load: Resultant, arm: tuple[Points, Points], frame: Named) -> None:
    """The two parallel lines and the arm on the diagram; the arm without friction stands beside that with it."""
    board, line, role, (at, across) = st.board, load.line, st.ruled(Role.DIRECTION), arm
    (known, _), u = line_of_load(load), line.along
    reach, aside = u * dot(u, line.at - across), clear_of(st, at, across, u) if st.preliminary else 0.0
    here, there, along = at + u * aside, across + u * aside, np.sign(aside) or -1.0
    board.join(View.MECHANISM, across + reach + u * 4.0, there + u * along * 10.0, role, key=known.key if known else "")
    name_once(st, known, there + u * along * 10.0)
    board.join(View.MECHANISM, at - u * along * 16.0, here + u * along * (10.0 if aside else 16.0), role, key=frame.key)
    board.plot(View.MECHANISM, at - u * along * 16.0, frame.symbol, Dot.NONE, key=frame.key)
    if abs(nominal(across - at)) > 1.0:
        board.join(View.MECHANISM, here, there, st.ruled(Role.CONSTRUCTION))
        board.plot(View.MECHANISM, here + 0.65 * (there - here), _letter(st), Dot.NONE, key=_letter(st))
    if abs(nominal(across - at)) > ROOM and not st.preliminary:
        board.right_angle(View.MECHANISM, there, unit(here - there), u)


def _pure_couple(st: Statics, held: Held, load: Resultant) -> None:
    """Only couples act: the balancing moment is their sum turned round, the pin is unloaded.
    Nothing acts: both are zero."""
    if not nominal(load.couple):
        nothing_acts(st, held)
        return
    number = st.mech.number(held.link)
    st.board.step(
        Words(
            f"构件 {number} 上只有力偶，${st.unknown_named.symbol}$ 与之平衡，机架反力为零。",
            f"Only couples act on link {number}: ${st.unknown_named.symbol}$ balances them, and the frame's reaction "
            "is zero.",
        ),
        View.MECHANISM,
    )
    value: Reals = -load.couple
    st.settle(FRAME, held.link, 0j, st.desk.at[held.joint.point] if isinstance(held.joint, Revolute) else 0j)
    keep_value(st, st.unknown_named, value, magnitude(st.unknown_named.symbol, np.abs(value), "N·m"))
    st.balance = value


def _by_sum(st: Statics, held: Held, at: Points) -> None:
    """The couples outweigh the forces so far that their one line is off the sheet:
    ΣM about the frame's reaction instead."""
    named = st.unknown_named
    st.board.remark(
        Words(
            "各力与力偶合成后的作用线在图纸之外，改对机架反力的作用点列力矩平衡：",
            " The line of the joined forces and couples is off the sheet; the moments about the point of the "
            "frame's reaction give:",
        )
    )
    turning = moments_at(st, None if st.preliminary else View.MECHANISM, (held.link,), at)
    size = st.board.compute(named.symbol, turning.size, "N·m")
    keep_value(st, named, -turning.way * size.value, turning.size)
    if not st.preliminary:
        frame = st.push(FRAME, held.link)
        assert frame is not None
        ratio = size / magnitude(frame.named.symbol, np.abs(frame.vector) * st.scale.value, "N")
        keep_value(st, Named("h", "h", "m"), ratio.value, ratio)
    st.balance = -turning.way * size.value


def _through_pin(st: Statics, symbol: str) -> None:
    """The force on the link passes through its pin, as the frame's reaction does: no arm, no moment."""
    named = st.unknown_named
    st.board.remark(
        Words(
            f"{symbol} 与机架反力共线，力臂 ${_letter(st)}$ = 0，故 ${named.symbol}$ = 0。",
            f" It and the frame's reaction lie in one line, the arm ${_letter(st)}$ = 0, so ${named.symbol}$ = 0.",
        )
    )
    keep_nothing(st, named)
    if not st.preliminary:
        keep_nothing(st, Named("h", "h", "m"))
    st.balance = 0.0
