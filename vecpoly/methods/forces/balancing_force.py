"""The last polygon where a force balances: known forces, the balancing force along its line, the frame's reaction."""

from __future__ import annotations

from ...board.marks import Dot
from ...mechanism.model import FRAME, Revolute
from ...plane import Line, Points, dot, nominal
from ...vector.close import close
from ...vector.equation import Equation, Term
from ...words import Words
from .pieces import Held
from .readings import keep_measured
from .resultant import Resultant
from .state import Drawn, Statics
from .three_forces import LETTERS


def close_polygon(st: Statics, held: Held, load: Resultant, line: Line, through: tuple[Points, Points, int]) -> None:
    """ΣF = 0: keeps the frame's reaction and reads the balancing force, signed along its given direction."""
    u, x, sense = through
    link, number = held.link, st.mech.number(held.link)
    force, frame = st.unknown_named, st.named(FRAME, link)
    pane = st.polygon(number, Words(f"构件 {number} 的力多边形", f"Force polygon of link {number}"))
    terms = [Term(rel=f.named, symbol=f.named.symbol, direction=f.direction, magnitude=f.size, vector=f.vector, tip=LETTERS[i + 1]) for i, f in enumerate(load.forces)]
    terms += [Term(rel=force, symbol=force.symbol, direction=Words("作用线已知", "line known"), magnitude="?", along=line.along),
              Term(rel=frame, symbol=frame.symbol, direction=Words("方向已定", "direction found"), magnitude="?", along=u)]
    eq = Equation(left=tuple(terms), right=())
    st.board.step(Words(f"构件 {number} 的力平衡方程，按 $μ_F$ 作力多边形。", f"Equilibrium of link {number}; its polygon to $μ_F$."), pane)
    st.board.equate(eq.table())
    st.board.plot(pane, 0j, LETTERS[0], Dot.POINT)
    ends = close(st.board, pane, 0j, eq).ends
    (start, corner), (_, end) = ends[force.key], ends[frame.key]
    n = len(load.forces)
    st.board.plot(pane, corner, LETTERS[n + 1], Dot.POINT)
    at = x + u * dot(u, st.desk.at[held.joint.point] - x) if isinstance(held.joint, Revolute) else x
    st.settle(FRAME, link, end - corner, at, Drawn(place=pane, start=corner, end=end, letters=f"{LETTERS[n + 1]} {LETTERS[0]}"), sense)
    sign = 1 if nominal(dot(corner - start, line.along)) > 0 else -1
    value = keep_measured(st, force, Drawn(place=pane, start=start, end=corner, letters=f"{LETTERS[n]} {LETTERS[n + 1]}"), sign)
    st.balance = value
