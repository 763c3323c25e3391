"""The reactions at the pins of a two-force cylinder, and every thrust where it presses."""

from __future__ import annotations

import numpy as np

from ....board.construction import LineOfAction, Reading, View
from ....diagram.cylinders import pressed
from ....mechanism.asked.forces import without_friction
from ....mechanism.loads import Force, Loads
from ....mechanism.model import Prismatic
from ....names import Named, reaction
from ....plane import Line, Points, foot, nominal
from ..acting import Acting
from ..state import Statics
from .thrust import beside, is_strut, opposite_name


def read_thrusts(st: Statics, loads: Loads) -> None:
    """The reactions at a cylinder's pins are its thrust, and act there along the line of the two pins; piston and
    barrel do not press on each other sideways."""
    for force in (one for one in loads.forces if one.against and is_strut(st.mech, loads, one)):
        outer = next(one for one in st.loads.forces if one.name == force.name)
        _keep_none(st, loads, force)
        base = beside(st.mech, force, force.foot)[0]
        for by, on, point in ((force.link, outer.link, force.point), (base, force.against, force.foot)):
            thrust = _thrust(st, outer)
            st.settle(by, on, thrust / st.scale.value, st.desk.at[point], computed=np.abs(thrust))
            for one, two, sign in ((by, on, 1), (on, by, -1)):
                named = reaction(st.mech.number(one), st.mech.number(two))
                _keep(st, named, sign * thrust, point)
                if loads.friction and st.ideal is not None:
                    _keep(st, without_friction(named), sign * _thrust(st.without_friction, outer), point)


def _keep_none(st: Statics, loads: Loads, force: Force) -> None:
    pair = (force.link, force.against), (force.against, force.link)
    for named in (reaction(st.mech.number(one), st.mech.number(two)) for one, two in pair):
        for each in (named, without_friction(named)) if loads.friction else (named,):
            st.keep(Reading(key=each.key, symbol=each.symbol, unit="N", scalar=0.0, vector=0j), np.zeros(()))


def _thrust(st: Statics, outer: Force) -> Points:
    """The thrust in this pass, as it acts on the moved link (N)."""
    vector: Points = st.size_of(outer) * np.exp(1j * outer.direction)
    return vector


def _keep(st: Statics, named: Named, vector: Points, point: str) -> None:
    at, metres = complex(nominal(vector)), complex(nominal(st.desk.at[point])) * st.board.scales[View.MECHANISM].value
    st.keep(
        Reading(
            key=named.key, symbol=named.symbol, unit="N", scalar=abs(at), vector=at, acts=LineOfAction(point=metres)
        ),
        np.abs(vector),
        vector,
    )


def in_cylinders(st: Statics, loads: Loads) -> dict[str, list[Acting]]:
    """Every thrust where it presses, for the free bodies: on the piston, and oppositely on the bottom of the barrel.

    On the moved link the rod's reaction stands in its place.
    """
    found: dict[str, list[Acting]] = {}
    posed = st.desk.posed()
    for force in (one for one in loads.forces if one.against):
        outer = next(one for one in st.loads.forces if one.name == force.name)
        pair, line = {force.link, force.against}, st.desk.towards(force.foot, force.point)
        joint = next(j for j in st.mech.joints if isinstance(j, Prismatic) and {j.guide, j.block} == pair)
        vector = _thrust(st, outer) / st.scale.value
        for link, at in zip((joint.guide, joint.block), pressed(posed, joint), strict=True):
            sign, own = (1, outer) if link == force.link else (-1, _opposite(st, outer, link))
            found.setdefault(link, []).append(
                Acting(named=st.name_of(own), vector=sign * vector, at=foot(Line(st.desk.at[force.foot], line), at))
            )
    return found


def _opposite(st: Statics, outer: Force, barrel: str) -> Force:
    """F_c′ where the thrust counts as an outer force on the barrel; else it is F_c that presses there too."""
    name = opposite_name(outer)
    return next((one for one in st.loads.forces if one.name == name and one.link == barrel), outer)
