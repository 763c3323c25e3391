"""The couples that act on a link, by their symbols: given ones, inertia couples, those that slides pass on; and those
of friction in the pins of groups that moments solved."""

from __future__ import annotations

from collections.abc import Collection, Iterator

import numpy as np

from ...foundation.slotted import replace
from ...mechanism.groups.assur import Group
from ...mechanism.loads import Moment
from ...mechanism.model import Revolute
from ...plane import Reals
from .lines.letters import slide_couple
from .state import Statics


def couples_on(st: Statics, link: str, *, within: Collection[str] = ()) -> Iterator[tuple[str, Reals]]:
    """Symbol and size (N·m, counter-clockwise positive) of the known couples;
    friction couples of pins are no couples of their own.

    within: links drawn together with this one; what slides pass on between them is an inner couple and left out.
    """
    inner = {st.named(other, link).symbol for other in within if other != link}
    for load in st.sized(link):
        if isinstance(load, Moment):
            yield st.name_of(load).symbol, st.size_of(load)
    if link in st.inertia_couples:
        yield f"M_{{I{link}}}", st.inertia_couples[link]
    for force in st.reactions(link):
        if force.named.symbol not in inner:
            yield slide_couple(force.named.symbol), force.couple


def every_couple(st: Statics, link: str) -> Iterator[tuple[str, Reals]]:
    """These couples, and those of friction in pins."""
    yield from couples_on(st, link)
    for (by, on), couple in st.couples.items():
        if on == link:
            yield f"M_{{f{st.mech.number(by)}{st.mech.number(on)}}}", couple


def pin_couples(st: Statics, groups: tuple[Group, ...]) -> dict[tuple[str, str], Reals]:
    """Friction couples (N·m) of the pins of groups that were solved by moments: ρ R against the relative turning."""
    found: dict[tuple[str, str], Reals] = {}
    rubbing = replace(st, rubbing=True)
    for group in groups:
        if group.links not in st.by_moments:
            continue
        for joint in (*group.inner, *(out.joint for out in group.outer)):
            if isinstance(joint, Revolute) and rubbing.rho(joint.point):
                for by, on in ((joint.a, joint.b), (joint.b, joint.a)):
                    force = st.push(by, on)
                    if on in group.links and force is not None:
                        found[by, on] = st.newton_metres(
                            np.abs(force.vector) * rubbing.rho(joint.point) * rubbing.moment_sense(joint.point, by, on)
                        )
    return found
