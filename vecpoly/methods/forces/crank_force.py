"""A link on a fixed pin with a balancing force of given line: three forces through one point."""

from __future__ import annotations

import numpy as np

from ...mechanism.loads import Force
from ...mechanism.model import FRAME
from ...plane import Line, Points
from ...words import Words
from ..registry import Stage, method
from .balancing_force import close_polygon
from .pieces import Held
from .resultant import resultant
from .state import Statics
from .three_forces import direction_through

_SOURCE = "机械原理, three forces through one point"


@method(stage=Stage.FORCE, group="crank, balancing force", source=_SOURCE, example="",
        title=Words("曲柄：平衡力，三力汇交", "Crank: balancing force, three forces through one point"))
def force_on_crank(st: Statics, held: Held) -> None:
    """P + F + R_frame = 0: P and F meet in a point, R_frame passes through it, tangent to the friction circle."""
    load, force = resultant(st, held.link), st.unknown
    assert isinstance(force, Force)
    along = complex(np.exp(1j * force.direction))
    line = Line(st.desk.at[force.point], along)
    number = st.mech.number(held.link)
    st.board.step(Words(f"取构件 {number} 为分离体：{load.symbols.zh}{'' if len(load.forces) == 1 else ' 的合力'}与 ${st.unknown_named.symbol}$ 的作用线交于一点，机架反力 ${st.named(FRAME, held.link).symbol}$ 过此点。",
                        f"Isolate link {number}: the lines of {load.symbols.en}{'' if len(load.forces) == 1 else ' (joined)'} and of ${st.unknown_named.symbol}$ meet in a point; the frame's reaction ${st.named(FRAME, held.link).symbol}$ passes through it."))
    x: Points = st.board.meet(load.line, line, Words(f"构件 {number}：载荷与平衡力", f"link {number}: load and balancing force"))
    u, sense = direction_through(st, held.joint, FRAME, held.link, x)
    close_polygon(st, held, load, line, (u, x, sense))
