"""Groups of a class that no construction draws: what is said of them, and what to do instead."""

from __future__ import annotations

from collections.abc import Iterable

from ..errors import NoMethodError
from ..mechanism.groups.assur import Group
from ..mechanism.groups.other_inputs import other_inputs
from ..mechanism.model import Mechanism
from ..words import Words
from .kinematics.class_iii.star import is_star


def refuse_higher(mech: Mechanism, groups: Iterable[Group]) -> None:
    """Raise NoMethodError for the first group that is neither of class II nor a central link on three legs."""
    for group in groups:
        if group.kind.startswith("class ") and not is_star(group):
            raise NoMethodError(_what(group) + _instead(mech), numbers={"links": len(group.links)})


def _what(group: Group) -> Words:
    number = group.kind.removeprefix("class ")
    if number == "III":
        return Words(
            f"{group.name.zh}不是一个中心构件带三个双副支链，尚无图解法。",
            f"the {group.name.en} is not one central link on three legs, and no graphical method on file draws it.",
        )
    return Words(
        f"{group.name.zh}没有只用已知矢量列出的两个未知量的方程，图解法不适用。",
        f"no graphical method on file draws the {group.name.en}: no vector equation of it has only two unknowns.",
    )


def _instead(mech: Mechanism) -> Words:
    """vecpoly exact; and the links with which as the input the mechanism can be drawn."""
    links = other_inputs(mech, lambda group: group.dyad is not None or is_star(group))
    if not links:
        return Words("“vecpoly exact”给出解析解。", " 'vecpoly exact' gives its analytic answers.")
    return Words(
        f"“vecpoly exact”给出解析解；若改以构件 {'、'.join(links)} 为原动件，则可用图解法。",
        f" 'vecpoly exact' gives its analytic answers; with link {' or '.join(links)} as the input it can be drawn.",
    )
