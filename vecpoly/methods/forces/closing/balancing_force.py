"""The last polygon where a force balances: known forces, the balancing force along its line, the frame's reaction."""

from __future__ import annotations

from ....board.board import NO_LENGTH
from ....board.construction import Reading
from ....mechanism.model import FRAME, Revolute
from ....names import Named
from ....plane import Line, Points, Reals, dot, nominal
from ....vector.equation import Term
from ....words import Words
from ..acting import Drawn
from ..bodies.link_polygon import draw_polygon, pane_of
from ..lines.links_of_group import Held
from ..lines.resultant import Resultant
from ..lines.three_forces import KNOWN
from ..readings import keep_measured, keep_nothing, say_measured
from ..state import Statics


def close_polygon(
    st: Statics, held: Held, load: Resultant, line: Line, frame_force: tuple[Points, Points, int]
) -> None:
    """ΣF = 0: keeps the frame's reaction (direction, point of its line, sense about the pin) and reads the balancing
    force, signed along its direction."""
    u, at, sense = frame_force
    rest = draw_balance(st, held, load, line, u)
    st.settle(FRAME, held.link, rest.end - rest.start, at, rest, sense)


def draw_balance(st: Statics, held: Held, load: Resultant, line: Line, u: Points) -> Drawn:
    """The polygon of P, F and R_frame; reads F. Gives the side of R_frame."""
    link, number = held.link, st.mech.number(held.link)
    force, frame = st.unknown_named, st.named(FRAME, link)
    st.board.step(
        Words(
            f"列构件 {number} 的力平衡方程，按 $μ_F$ 作力多边形，各力首尾相接。",
            f"Write the equilibrium of link {number} and draw its polygon to $μ_F$, the forces head to tail.",
        ),
        pane_of(st, link),
    )
    drawn = draw_polygon(
        st,
        link,
        load,
        (
            Term(rel=force, symbol=force.symbol, direction=KNOWN, magnitude="?", along=line.along),
            Term(
                rel=frame, symbol=frame.symbol, direction=Words("方向已定", "direction found"), magnitude="?", along=u
            ),
        ),
    )
    sought = drawn[force.key]
    say_measured(st, ((force.symbol, sought),))
    if abs(nominal(sought.end - sought.start)) < NO_LENGTH:
        keep_nothing(st, force)
        st.balance = 0.0
    else:
        sign = 1 if nominal(dot(sought.end - sought.start, line.along)) > 0 else -1
        st.balance = keep_measured(st, force, sought, sign)
    return drawn[frame.key]


def keep_force(st: Statics, named: Named, size: Reals) -> None:
    """The balancing force as computed in the step, signed along its direction."""
    st.keep(Reading(key=named.key, symbol=named.symbol, unit=named.unit, scalar=float(nominal(size))), size)
    st.balance = size


def nothing_acts(st: Statics, held: Held) -> None:
    """No load reaches the link: the balancing load and the frame's reaction are zero."""
    number, named, frame = st.mech.number(held.link), st.unknown_named, st.named(FRAME, held.link)
    st.board.step(
        Words(
            f"构件 {number} 上无其他力作用，故 ${named.symbol}$ = 0，${frame.symbol}$ = 0。",
            f"No other force reaches link {number}: ${named.symbol}$ = 0 and ${frame.symbol}$ = 0.",
        )
    )
    _settle_nothing(st, held)
    keep_nothing(st, named)
    st.balance = 0.0


def frame_free(st: Statics, held: Held) -> None:
    """No force reaches the link, and its balancing load acts elsewhere: the frame's reaction is zero."""
    number, frame = st.mech.number(held.link), st.named(FRAME, held.link)
    st.board.step(
        Words(
            f"构件 {number} 上各力之和为零，故机架反力 ${frame.symbol}$ = 0。",
            f"The forces on link {number} sum to zero: the frame's reaction ${frame.symbol}$ = 0.",
        )
    )
    _settle_nothing(st, held)


def _settle_nothing(st: Statics, held: Held) -> None:
    st.settle(FRAME, held.link, 0j, st.desk.at[held.joint.point] if isinstance(held.joint, Revolute) else 0j)
