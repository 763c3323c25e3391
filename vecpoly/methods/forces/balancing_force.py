"""The last polygon where a force balances: known forces, the balancing force along its line, the frame's reaction."""

from __future__ import annotations

from ...mechanism.model import FRAME
from ...plane import Line, Points, dot, nominal
from ...vector.equation import Term
from ...words import Words
from .link_polygon import draw_polygon, pane_of
from .pieces import Held
from .readings import keep_measured
from .resultant import Resultant
from .state import Statics


def close_polygon(st: Statics, held: Held, load: Resultant, line: Line, through: tuple[Points, Points, int]) -> None:
    """ΣF = 0: keeps the frame's reaction and reads the balancing force, signed along its given direction."""
    u, x, sense = through
    link, number = held.link, st.mech.number(held.link)
    force, frame = st.unknown_named, st.named(FRAME, link)
    st.board.step(Words(f"列构件 {number} 的力平衡方程，按 $μ_F$ 作力多边形，各力首尾相接，由图量得 ${force.symbol}$。", f"Write the equilibrium of link {number}, draw its polygon to $μ_F$, the forces head to tail, and measure ${force.symbol}$."), pane_of(st, link))
    drawn = draw_polygon(st, link, load, (
        Term(rel=force, symbol=force.symbol, direction=Words("作用线已知", "line known"), magnitude="?", along=line.along),
        Term(rel=frame, symbol=frame.symbol, direction=Words("方向已定", "direction found"), magnitude="?", along=u)))
    sought, rest = drawn[force.key], drawn[frame.key]
    st.settle(FRAME, link, rest.end - rest.start, st.at_joint(held.joint, Line(x, u)), rest, sense)
    sign = 1 if nominal(dot(sought.end - sought.start, line.along)) > 0 else -1
    st.balance = keep_measured(st, force, sought, sign)
