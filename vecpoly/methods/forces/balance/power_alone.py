"""The balancing load asked for alone:
virtual power gives it for every mechanism whose velocities are drawn, without a single reaction."""

from __future__ import annotations

from collections.abc import Iterable

from ....errors import NoMethodError
from ....foundation.slotted import replace
from ....mechanism.groups.assur import Group
from ....mechanism.groups.stars import has_plate
from ....mechanism.loads import Loads
from ....problem.problem import Problem
from ....words import Words
from ...registry import Stage
from ..doors import BALANCING
from ..state import Statics
from ..teeth.carried import carried_of
from ..teeth.mesh import mesh_of


def is_alone(problem: Problem) -> bool:
    """Whether no reaction, no efficiency and no arm is asked for: then no group need be in equilibrium on paper."""
    asked = {ask.rel.key for ask in problem.asks}
    return not any(key.startswith("R_") or key in ("eta", "h") for key in asked)


def is_plain(groups: Iterable[Group]) -> bool:
    """Whether these are dyads, and gears and racks that one pair of teeth drives, alone."""
    return all(group.dyad is not None or mesh_of(group) is not None for group in groups)


def is_drawn(groups: Iterable[Group]) -> bool:
    """Whether the reactions of all these groups are drawn: those of plain ones, of a central link on three legs, and of
    a planet on its arm."""
    return all(is_plain((group,)) or has_plate(group) or carried_of(group) is not None for group in groups)


def power_first(st: Statics, loads: Loads | None = None) -> None:
    """The balancing load by virtual power, kept as the answer; reactions that follow take it as given.

    loads: as the problem has them, with the thrust of a cylinder that is no outer force of one link.
    """
    BALANCING.find(Stage.FORCE, "virtual power").draw(st if loads is None else replace(st, loads=loads), None)
    found, named = st.board.readings[f"{st.unknown.name}_power"], st.unknown_named
    st.keep(replace(found, key=named.key, symbol=named.symbol), st.board.found[f"{st.unknown.name}_power"])
    st.balance, st.balanced = st.board.found[f"{st.unknown.name}_power"], True


def refuse_undrawn(st: Statics, groups: Iterable[Group]) -> NoMethodError:
    """Why the reactions are not drawn, and that the balancing load alone would be."""
    name, undrawn = st.unknown.name, [group for group in groups if not is_drawn((group,))]
    zh, en = "、".join(group.name.zh for group in undrawn), ", ".join(group.name.en for group in undrawn)
    if st.loads.friction:
        return NoMethodError(
            Words(
                f"没有求{zh}中各运动副反力的图解法，计入摩擦时平衡载荷 {name} 也因此求不出；"
                f"请去掉 friction 而只求 find: [{name}]（虚功率法），或用 vecpoly exact 求全部解析解",
                f"no graphical method on file finds the reactions in the {en}, and with friction the balancing "
                f"load {name} needs them; leave out the friction and ask find: [{name}] alone (virtual power), "
                "or use 'vecpoly exact'",
            ),
            code="no-method",
        )
    return NoMethodError(
        Words(
            f"没有求{zh}中各运动副反力的图解法；可只求平衡载荷：find: [{name}]（虚功率法，不需任何反力），"
            "各反力可用 vecpoly exact 求解析解",
            f"no graphical method on file finds the reactions in the {en}; the balancing load alone can be "
            f"asked, find: [{name}] (virtual power needs no reaction), and 'vecpoly exact' gives every reaction",
        ),
        code="no-method",
    )
