"""A link on a fixed pin with a balancing moment: the forces on it and the frame's reaction form a couple, M = R h."""

from __future__ import annotations

import numpy as np

from ...board.construction import View
from ...board.marks import Dot, Role
from ...errors import EquilibriumError
from ...mechanism.loads import Moment
from ...mechanism.model import FRAME, Revolute
from ...names import Named
from ...plane import Line, Points, Reals, dot, foot, nominal
from ...quantity import Quantity, magnitude
from ...vector.close import close
from ...vector.equation import Equation, Term
from ...words import Words
from ..registry import Stage, method
from .pieces import Held
from .readings import keep_value
from .resultant import Resultant, resultant
from .senses import TURN, pin_words
from .state import Drawn, Statics
from .three_forces import LETTERS

_SOURCE = "机械原理, equilibrium of the crank"


@method(stage=Stage.FORCE, group="crank, balancing moment", source=_SOURCE, example="4-3a",
        title=Words("曲柄：平衡力矩 M = R h", "Crank: balancing moment M = R h"))
def moment_on_crank(st: Statics, held: Held) -> None:
    """R_frame = −P (P: resultant of the forces on the link), tangent to the friction circle; M_b = P h against their couple.

    Raises EquilibriumError where no force acts on the link.
    """
    assert isinstance(held.joint, Revolute) and isinstance(st.unknown, Moment)
    load, number, pin = resultant(st, held.link), st.mech.number(held.link), held.joint.point
    if load.is_couple:
        _pure_couple(st, held, load)
        return
    frame = st.mech.number(FRAME)
    st.board.step(Words(f"取构件 {number}：已知 {load.symbols.zh}。", f"Take link {number}: {load.symbols.en} known."), View.MECHANISM)
    drawn = _frame_side(st, held, load)
    u = -load.line.along
    sense = st.moment_sense(pin, FRAME, held.link)
    at = st.desk.at[pin] - 1j * u * sense * st.rho(pin)
    st.board.remark(Words(f"机架反力 $R_{{{frame}{number}}}$ 与其合力等值、反向、平行。", f" The frame's reaction $R_{{{frame}{number}}}$ is equal, opposite and parallel to their sum."))
    st.board.remark(pin_words(st, pin, FRAME, held.link) if sense else Words(f"$R_{{{frame}{number}}}$ 过 ${pin}$。", f" It passes through ${pin}$."))
    st.settle(FRAME, held.link, -load.vector, at, drawn, sense)
    _couple(st, held, load, at, drawn)


def _frame_side(st: Statics, held: Held, load: Resultant) -> Drawn | None:
    """The frame's reaction on paper: the side that closes the polygon, or the only force turned round."""
    if len(load.forces) == 1:
        return load.forces[0].drawn.reversed() if load.forces[0].drawn else None
    number, named = st.mech.number(held.link), st.named(FRAME, held.link)
    pane = st.polygon(number, Words(f"构件 {number} 的力多边形", f"Force polygon of link {number}"))
    terms = [Term(rel=f.named, symbol=f.named.symbol, direction=f.direction, magnitude=f.size, vector=f.vector, tip=LETTERS[i + 1]) for i, f in enumerate(load.forces)]
    terms.append(Term(rel=named, symbol=named.symbol, direction=Words.same("?"), magnitude="?"))
    eq = Equation(left=tuple(terms), right=())
    st.board.remark(Words(f"由 {load.symbols.zh} 作力多边形，封闭边即 ${named.symbol}$。", f" Draw the polygon of {load.symbols.en}; its closing side is ${named.symbol}$."))
    st.board.equate(eq.table())
    st.board.plot(pane, 0j, LETTERS[0], Dot.POINT)
    start, end = close(st.board, pane, 0j, eq).ends[named.key]
    return Drawn(place=pane, start=start, end=end, letters=f"{LETTERS[len(load.forces)]} {LETTERS[0]}")


def _couple(st: Statics, held: Held, load: Resultant, at: Points, drawn: Drawn | None) -> None:
    """M_b against the couple of the two parallel forces."""
    line = load.line
    across = foot(line, at)  # from the frame's line square across to the other
    couple = np.asarray((np.conj(across - at) * load.vector).imag)
    named = st.unknown_named
    arm = _arm(st, at, across)
    size = _size(st, load, held, drawn)
    way = TURN[-1 if nominal(couple) > 0 else 1]
    st.board.remark(Words(f"两力构成力偶，量得力臂 $h$；${named.symbol}$ 与之平衡，为{way.zh}：", f" The two form a couple of arm $h$, measured; ${named.symbol}$ balances it and is {way.en}:"))
    value = st.board.compute(named.symbol, size * arm, "N·m")
    _leave(st, line, at, across)
    signed = -np.sign(couple) * value.value
    keep_value(st, named, signed, size * arm)
    if st.rubbing or not st.loads.friction:
        keep_value(st, Named("h", "h", "m"), arm.value, arm)
    st.balance = signed


def _arm(st: Statics, at: Points, across: Points) -> Quantity:
    on_paper = st.board.measure(at, across, "h")
    return st.board.compute("h", st.board.mu(View.MECHANISM) * on_paper, "m")


def _size(st: Statics, load: Resultant, held: Held, drawn: Drawn | None) -> Quantity:
    named = load.forces[0].named if len(load.forces) == 1 else st.named(FRAME, held.link)
    if drawn is None:
        return magnitude(named.symbol, np.abs(load.vector) * st.scale.value, "N")
    on_paper = st.board.measure(drawn.start, drawn.end, drawn.letters)
    return magnitude(named.symbol, (st.board.mu(drawn.place) * on_paper).value, "N")


def _leave(st: Statics, line: Line, at: Points, across: Points) -> None:
    """The two parallel lines and the arm on the diagram, in the pass that counts."""
    if st.ideal is None and st.loads.friction:
        return
    board, u = st.board, line.along
    reach = u * dot(u, line.at - across)
    board.join(View.MECHANISM, across - u * 10.0, across + reach + u * 4.0, Role.DIRECTION)
    board.join(View.MECHANISM, at - u * 16.0, at + u * 16.0, Role.DIRECTION)
    if abs(nominal(across - at)) > 1.0:
        board.join(View.MECHANISM, at, across, Role.CONSTRUCTION)


def _pure_couple(st: Statics, held: Held, load: Resultant) -> None:
    """Only couples act: the balancing moment is their sum turned round, the pin is unloaded."""
    number = st.mech.number(held.link)
    if abs(nominal(load.couple)) < 1e-12:
        raise EquilibriumError(f"no load reaches link {number}: {st.unknown.name} balances nothing; give a load that does work")
    st.board.step(Words(f"构件 {number} 上只有力偶，", f"Only couples act on link {number}."), View.MECHANISM)
    value: Reals = -load.couple
    st.settle(FRAME, held.link, 0j, st.desk.at[held.joint.point] if isinstance(held.joint, Revolute) else 0j)
    keep_value(st, st.unknown_named, value, magnitude(st.unknown_named.symbol, np.abs(value), "N·m"))
    st.balance = value

