"""Multiple joints whose pin belongs to another link than the one on which the groups hang: the pin counts by itself,
and is given to its link last.

Which link carries a pin changes no group. While the groups are solved, R_Ci is the force of the pin at C on link i,
whoever carries it. Then every R_Ci is that of the carrier, and a small polygon of the pin gives the force of the link
on which the groups hung. Friction acts between the carrier and each other link: while the groups are solved as couples
on the links, found from round to round (`settling`).
"""

from __future__ import annotations

from collections.abc import Iterable

import numpy as np

from ...board.board import NO_LENGTH
from ...board.construction import View
from ...foundation.slotted import replace
from ...mechanism.groups.assur import hinges
from ...mechanism.model import Drive, Mechanism
from ...mechanism.seats import seat, seated
from ...plane import Points, Reals, nominal
from ...words import Words
from ..desk import Desk
from .acting import Acting, Drawn
from .bodies.link_polygon import closing_side
from .friction import Hub
from .lines.resultant import Resultant
from .readings import write_sizes
from .senses import pin_words
from .state import Statics


def on_groups(mech: Mechanism, drive: Drive) -> Mechanism:
    """The mechanism with each pin in the link on which the groups hang that are taken off when this drive moves it."""
    return replace(seated(replace(mech, drives=(drive,))), drives=mech.drives)


def hubs_of(mech: Mechanism, hung: Mechanism) -> tuple[Hub, ...]:
    """The hinges at which the problem gives the pin to another link than the groups would."""
    found = ((point, names, seat(mech, point), seat(hung, point)) for point, names in hinges(mech).items())
    thought = {*mech.substitutes, *mech.slot_pins}
    return tuple(
        Hub(
            point=point,
            carrier=own,
            hung=other,
            links=tuple(name for name in names if name not in thought),
            blocks=tuple(name for name in names if name in mech.slot_pins),
        )
        for point, names, own, other in found
        if own is not None and other is not None and own != other
    )


def say_hubs(st: Statics) -> None:
    """What R_Ci is, before the groups are solved."""
    for hub in st.hubs:
        carrier, point, number = st.mech.number(hub.carrier), hub.point, st.mech.number(hub.links[0])
        symbol = f"R_{{{point}{number}}}"
        st.board.step(
            Words(
                f"铰链 ${point}$ 的销轴属于构件 {carrier}，但不影响拆组：先把它单独看待，以 ${symbol}$ 等表示销轴 "
                f"${point}$ 对各构件的作用力，最后再归并到构件 {carrier}。",
                f"The pin at ${point}$ belongs to link {carrier}, which does not change how the "
                f"groups come apart: it is first thought by itself, ${symbol}$ and so on being "
                f"its force on each link, and is joined to link {carrier} at the end.",
            ),
            View.MECHANISM,
        )


def joined(st: Statics, desk: Desk) -> Statics:
    """The same pass with every pin in its own link:
    reactions between the carrier and each of the others. desk: that of the problem's own joints."""
    if not st.hubs:
        return st
    own = replace(st, desk=desk, hubs=(), own=None, acting=dict(st.acting))
    for hub in st.hubs:
        pushes = {
            link: force
            for link in (*hub.links, *hub.blocks)
            if link != hub.hung and (force := st.push(hub.hung, link)) is not None
        }
        for link in pushes:
            own.acting.pop((hub.hung, link), None)
            own.acting.pop((link, hub.hung), None)
        for link in (one for one in pushes if one in hub.blocks):
            own.acting[hub.carrier, link] = replace(pushes[link], named=own.named(hub.carrier, link))
        for link in (one for one in pushes if one != hub.carrier and one not in hub.blocks):
            _keep(own, hub, link, pushes[link].vector, pushes[link].drawn, pushes[link].computed)
        side = _pin_polygon(st, own, hub, pushes)
        _keep(
            own,
            hub,
            hub.hung,
            0j if side is None else side.start - side.end,
            None if side is None else side.reversed(),
            None,
        )
    return own


def hub_couples(st: Statics, desk: Desk) -> dict[tuple[str, str], Reals]:
    """Friction couples (N·m) of the carriers on the others, and of these on the carriers:
    ρ R against the relative turning."""
    own, found = replace(st, desk=desk, hubs=(), own=None, rubbing=True), dict[tuple[str, str], Reals]()
    for hub in st.hubs:
        total: Points = 0j
        sizes: dict[str, Reals] = {}
        for link in (one for one in (*hub.links, *hub.blocks) if one != hub.hung):
            force = st.push(hub.hung, link)
            vector = 0j if force is None else force.vector
            total, sizes[link] = total - vector, np.abs(vector)
        sizes[hub.hung] = np.abs(total)
        for link in (one for one in hub.links if one != hub.carrier and own.rho(hub.point)):
            couple = own.newton_metres(
                sizes[link] * own.rho(hub.point) * own.moment_sense(hub.point, hub.carrier, link)
            )
            found[hub.carrier, link], found[link, hub.carrier] = couple, -couple
    return found


def _keep(own: Statics, hub: Hub, link: str, vector: Points, drawn: Drawn | None, computed: Reals | None) -> None:
    """R of the carrier on a link: through the pin's centre, or touching its friction circle."""
    if abs(nominal(vector)) < NO_LENGTH:
        own.settle(hub.carrier, link, 0j, own.desk.at[hub.point])
        return
    sense = own.moment_sense(hub.point, hub.carrier, link)
    at = own.touch(hub.point, vector / np.abs(vector), sense)
    if sense and not own.preliminary:
        own.board.remark(pin_words(own, hub.point, hub.carrier, link, at))
    own.settle(hub.carrier, link, vector, at, drawn, sense, computed=computed)


def _pin_polygon(st: Statics, own: Statics, hub: Hub, pushes: dict[str, Acting]) -> Drawn | None:
    """The forces of the links on the pin sum to zero: the closing side is that of the link on which the groups hung."""
    known = [
        force
        for link in pushes
        if (force := st.push(link, hub.hung)) is not None and abs(nominal(force.vector)) > NO_LENGTH
    ]
    point, carrier = hub.point, own.mech.number(hub.carrier)
    named, renamed = own.named(hub.hung, hub.carrier), _renamed(st, own, hub)
    pane = st.polygon(f"pin {point}", Words(f"销轴 {point} 的力多边形", f"Force polygon of the pin at {point}"))
    st.board.step(
        Words(
            f"销轴 ${point}$ 上各力平衡；销轴属于构件 {carrier}，故{renamed.zh}，并由封闭边量得 ${named.symbol}$。",
            f"The forces on the pin at ${point}$ balance. The pin belongs to link {carrier}: "
            f"{renamed.en}, and the closing side is ${named.symbol}$, which is measured.",
        ),
        pane,
    )
    total: Points = sum((force.vector for force in known), 0j)
    if not known or abs(nominal(total)) < NO_LENGTH:
        return None
    side = closing_side(own, hub.hung, hub.carrier, Resultant(forces=tuple(known), vector=total, at=0j), pane)
    write_sizes(own, Acting(named=named, vector=side.end - side.start, at=0j, drawn=side))
    return side


def _renamed(st: Statics, own: Statics, hub: Hub) -> Words:
    """$R_{43}$ = $R_{C3}$ of every link but the carrier and the one on which the groups hung."""
    others: Iterable[str] = (link for link in hub.links if link not in (hub.carrier, hub.hung))
    told = [f"${own.named(hub.carrier, link).symbol}$ = ${st.named(hub.hung, link).symbol}$" for link in others]
    return Words("、".join(told), ", ".join(told))
