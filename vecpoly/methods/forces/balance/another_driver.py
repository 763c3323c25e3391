"""The balancing load found before the reactions, which then follow from a link of which the groups are drawn:
how a mechanism comes apart depends on the driver, equilibrium does not (换原动件拆组)."""

from __future__ import annotations

from ....board.construction import View
from ....errors import NoMethodError
from ....mechanism.groups.assur import decompose
from ....mechanism.loads import Loads
from ....mechanism.model import FRAME, Rolling
from ....words import Words
from ..closing.thrust import unknown_thrust
from ..lines.links_of_group import Held
from ..order import Order
from ..state import Statics
from .power_alone import power_first


def found_before(st: Statics, order: Order, loads: Loads) -> Held:
    """The balancing load acts on a link that does not close:
    by virtual power it is known before any reaction.

    loads: as the problem has them, a thrust as one load that acts on two links.

    Raises NoMethodError where no link closes.
    """
    name, link = st.unknown.name, st.mech.number(st.unknown.link)
    if order.held is None:
        raise NoMethodError(
            Words(
                f"{name} 作用于构件 {link}，该构件和原动件都不与机架相连，没有可用的图解法。请令平衡力（矩）"
                "作用于与机架相连的构件，或用 vecpoly exact",
                f"{name} acts on link {link}; neither it nor the driving link is joined to the frame, and no graphical "
                "method on file balances it there; let it act on a link joined to the frame, or use 'vecpoly exact'",
            ),
            code="no-method",
            numbers={"link": link},
        )
    power_first(st, None if unknown_thrust(loads) is None else loads)
    _say_exchanged(st, order.held)
    return order.held


def _say_exchanged(st: Statics, held: Held) -> None:
    """From which link the groups are taken off, where it is not the driving one."""
    if held.link == st.mech.drive.link:
        return
    if st.mech.drive.on != FRAME:
        _say_started(st, held)
        return
    had, has = _groups_before(st), _groups_after(st)
    name, number, driver = st.unknown_named.symbol, st.mech.number(held.link), st.mech.number(st.mech.drive.link)
    st.board.step(
        Words(
            f"以构件 {driver} 为原动件拆组时，含有{had.zh}，不便逐组求反力。拆组与取哪个构件为"
            f"原动件有关，而力的平衡与之无关：既求得 ${name}$，改取构件 {number} 为原动件，机构全由{has.zh}"
            f"组成，于是逐组求反力，最后考虑构件 {number}。",
            f"Taken apart from link {driver} the mechanism has {had.en}. How it comes "
            "apart depends on the link from which one starts, but equilibrium does not: once "
            f"${name}$ is known, link {number} is taken as the driver. Then there are only {has.en}, "
            f"which are solved one by one, and link {number} comes last.",
        ),
        View.MECHANISM,
    )


def _say_started(st: Statics, held: Held) -> None:
    """From which link the groups are taken off where a drive between two moving links moves the mechanism."""
    name, number, has = st.unknown_named.symbol, st.mech.number(held.link), _groups_after(st)
    i, j = st.mech.number(st.mech.drive.on), st.mech.number(st.mech.drive.link)
    st.board.step(
        Words(
            f"原动力作用于构件 {i}、{j} 之间，二者都不是由机架反力单独平衡的构件。力的平衡与取哪个构件为"
            f"原动件无关：既求得 ${name}$，改取构件 {number} 为原动件拆组，机构由{has.zh}组成，逐组求反力，"
            f"最后考虑构件 {number}。",
            f"The drive acts between links {i} and {j}. Equilibrium does not depend on which link is taken as the "
            f"driver: once ${name}$ is known, the groups are taken off from link {number}. There are only {has.en}, "
            f"which are solved one by one, and link {number} comes last.",
        ),
        View.MECHANISM,
    )


def _groups_before(st: Statics) -> Words:
    """Why the mechanism is not solved from its own driver."""
    high = any(group.kind.startswith("class") for group in decompose(st.mech))
    return Words("高于 Ⅱ 级的杆组", "groups above class II") if high else Words("行星轮系", "planet gears")


def _groups_after(st: Statics) -> Words:
    """What it comes apart into from the other."""
    geared = any(isinstance(joint, Rolling) for joint in st.mech.joints)
    return Words(" Ⅱ 级杆组", "class II groups") + (
        Words("和单个齿轮", " and single gears") if geared else Words("", "")
    )
