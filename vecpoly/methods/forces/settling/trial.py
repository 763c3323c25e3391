"""The balancing load on trial (试算): where friction counts and another link closes than the one on which it acts.

With a size that is assumed all reactions follow group by group, and the link that closes needs some power more, or
less, to be in equilibrium. Between two changes of sense that rest is linear in the size: two trials give the size for
which nothing is left. It is found along with the friction couples of pins (`settling`), by the same secant.
"""

from __future__ import annotations

from collections.abc import Mapping

from ....algebra.quantity import number
from ....board.board import NO_LENGTH
from ....board.construction import Reading, View
from ....mechanism.groups.assur import Group
from ....mechanism.loads import Force, Load
from ....plane import Reals, dot, nominal
from ....words import Words
from ..balance.power_terms import idle
from ..lines.links_of_group import Held
from ..senses import TURN, velocity_of
from ..state import Statics

BALANCE = ("balancing load", "")  # its key among the couples of a round; on no link


def on_trial(st: Statics) -> dict[tuple[str, str], Reals]:
    """The size of the balancing load (as N·m) for the next round: less what the link that closes had too much."""
    if not st.balanced:
        return {}
    return {BALANCE: (st.balance - st.rest / _pace(st)) * _arm(st)}


def tried(st: Statics, couples: Mapping[tuple[str, str], Reals]) -> Reals:
    """The size on trial in this round (N·m, or N along its direction)."""
    return couples[BALANCE] / _arm(st) if BALANCE in couples else st.balance


def say_trial(st: Statics, groups: tuple[Group, ...], held: Held) -> None:
    """How the balancing load is found where friction counts; keeps it."""
    named, link = st.unknown_named, st.mech.number(held.link)
    value = float(nominal(st.balance))
    way = _way(st.unknown, value)
    st.board.step(
        Words(
            f"计入摩擦时不能先由功率求出 ${named.symbol}$，用试算法：假设 ${named.symbol}$ 的大小，逐组求反力，看构件 "
            f"{link} 能否平衡；余下的力（矩）与 ${named.symbol}$ 成线性关系，由两次试算定出使构件 {link} "
            f"恰好平衡的 ${named.symbol}$ = {number(abs(value))} {named.unit}{way.zh}。以下为最后一次试算。",
            f"With friction ${named.symbol}$ does not follow from the powers, so it is found by trial: with a size "
            f"assumed for it the groups are solved one by one; what is then missing on link {link} changes linearly "
            f"with ${named.symbol}$, and two trials give the size that leaves link {link} in equilibrium: "
            f"${named.symbol}$ = {number(abs(value))} {named.unit}{way.en}. The last trial follows.",
        ),
        View.MECHANISM,
    )
    st.keep(Reading(key=named.key, symbol=named.symbol, unit=named.unit, scalar=value), st.balance)


def _way(load: Load, value: float) -> Words:
    """How a balancing load of this value turns, or that it acts against the direction that is given."""
    if isinstance(load, Force):
        against = Words("，与给定方向相反", ", against the direction given")
        return against if value < 0 else Words("", "")
    turns = TURN[1 if value > 0 else -1]
    return Words(f"（{turns.zh}）", f", {turns.en}") if value else Words("", "")


def _arm(st: Statics) -> float:
    """A force counts by its moment at the mechanism's size, to be of the size of couples."""
    return st.mech.scale if isinstance(st.unknown, Force) else 1.0


def _pace(st: Statics) -> float:
    """How fast the balancing load moves along itself (m/s, rad/s): it only tells how long the next stride is."""
    load = st.unknown
    if not isinstance(load, Force):
        return st.turning(load.link, "0")
    ends = [one for one in st.loads.forces if one.size is None]  # of a cylinder there are two
    mm = sum(float(nominal(dot(st.along(one), velocity_of(st, one.link, st.desk.at[one.point])))) for one in ends)
    if abs(mm) < NO_LENGTH:
        raise idle(load)
    return mm * st.board.scales[View.VELOCITY].value
