"""A cylinder whose links carry nothing else is a two-force member: its thrust acts on the moved link along the line of the two pins."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from ...board.construction import LineOfAction, Reading, View
from ...errors import NoMethodError
from ...mechanism.assur import Group
from ...mechanism.loads import Force, Loads
from ...mechanism.model import FRAME, Mechanism, Prismatic
from ...mechanism.quantities import load_named, load_symbol, without_friction
from ...names import Named, reaction
from ...plane import Line, Points, foot, nominal
from ...words import Words
from ..desk import Desk
from ..kinematics.cylinder_symbol import pressed
from .acting import Acting
from .state import Statics


def as_outer_force(desk: Desk, loads: Loads) -> Loads:
    """The loads with every thrust as a force on the link at the rod's end, in the direction drawn; NoMethodError where it is no such force."""
    return replace(loads, forces=tuple(_outer(desk, loads, _from_the_frame(desk.mech, force)) if force.against else force for force in loads.forces))


def _from_the_frame(mech: Mechanism, force: Force) -> Force:
    """The thrust with its foot on the frame, where one end of the cylinder is: cylinder and piston may stand either way round."""
    if force.foot not in mech.frame and force.point in mech.frame:
        return replace(force, link=force.against, point=force.foot, against=force.link, foot=force.point)
    return force


def _outer(desk: Desk, loads: Loads, force: Force) -> Force:
    mech, pair = desk.mech, {force.link, force.against}
    if force.foot not in mech.frame:
        raise _no_method(force, Words(f"油缸的 ${force.foot}$、${force.point}$ 两端都不在机架上", f"neither of its pins {force.foot} and {force.point} is on the frame"))
    if any(load.name != force.name for link in pair for load in loads.on(link)) or any(loads.mass(link) for link in pair):
        raise _no_method(force, Words("油缸的构件上另有载荷或质量", "other loads or masses act on its links"))
    if _rubs(loads, force):
        raise _no_method(force, Words("油缸的运动副中有摩擦", "there is friction in its joints"))
    moved = [name for name in mech.links_at(force.point) if name not in pair]
    if len(moved) != 1:
        raise _no_method(force, Words(f"${force.point}$ 处不止一个构件", f"at {force.point} there is not one link alone"))
    along = float(np.angle(complex(nominal(desk.towards(force.foot, force.point)))))
    below, above = (reaction(mech.number(by), mech.number(on)).symbol for by, on in ((FRAME, force.against), (force.link, moved[0])))
    desk.board.step(Words(f"油缸 {force.against}-{force.link} 不受其他载荷，为二力构件，推力 ${load_symbol(force.name)}$ 沿 ${force.foot}{force.point}$ 作用于构件 {moved[0]} 的 ${force.point}$ 点；${force.foot}$、${force.point}$ 两铰链的反力 ${below}$、${above}$ 都等于它。",
                          f"The cylinder {force.against}-{force.link} carries nothing else and is a two-force member: its thrust ${load_symbol(force.name)}$ acts along ${force.foot}{force.point}$ on link {moved[0]} at ${force.point}$, and the reactions ${below}$ at ${force.foot}$ and ${above}$ at ${force.point}$ equal it."), View.MECHANISM)
    return Force(name=force.name, link=moved[0], point=force.point, direction=along, size=force.size, role=force.role)


def _rubs(loads: Loads, force: Force) -> bool:
    friction = loads.friction
    return bool(friction.pins.get(force.foot) or friction.pins.get(force.point) or friction.slides.get((force.link, force.against)))


def _no_method(force: Force, why: Words) -> NoMethodError:
    return NoMethodError(Words(f"油缸推力 {force.name}：{why.zh}，已有的图解法不能求解；vecpoly exact 给出解析解", f"the thrust {force.name}: {why.en}, and no graphical method on file covers that; 'vecpoly exact' gives it"), code="thrust")


def without_cylinders(groups: tuple[Group, ...], loads: Loads) -> tuple[Group, ...]:
    """The groups but those of two-force cylinders."""
    rams = [{force.link, force.against} for force in loads.forces if force.against]
    return tuple(group for group in groups if set(group.links) not in rams)


def read_thrusts(st: Statics, loads: Loads) -> None:
    """The reactions at a cylinder's pins are its thrust, and act there along the line of the two pins."""
    for force in (_from_the_frame(st.mech, one) for one in loads.forces if one.against):
        outer = next(one for one in st.loads.forces if one.name == force.name)
        for by, on, point in ((force.link, outer.link, force.point), (FRAME, force.against, force.foot)):
            thrust = _thrust(st, outer)
            st.settle(by, on, thrust / st.scale.value, st.desk.at[point], computed=np.abs(thrust))
            for one, two, sign in ((by, on, 1), (on, by, -1)):
                named = reaction(st.mech.number(one), st.mech.number(two))
                _keep(st, named, sign * thrust, point)
                if loads.friction and st.ideal is not None:
                    _keep(st, without_friction(named), sign * _thrust(st.without_friction, outer), point)


def _thrust(st: Statics, outer: Force) -> Points:
    """The thrust in this pass, as it acts on the moved link (N)."""
    vector: Points = st.size_of(outer) * np.exp(1j * outer.direction)
    return vector


def _keep(st: Statics, named: Named, vector: Points, point: str) -> None:
    at, metres = complex(nominal(vector)), complex(nominal(st.desk.at[point])) * st.board.scales[View.MECHANISM].value
    st.keep(Reading(key=named.key, symbol=named.symbol, unit="N", scalar=abs(at), vector=at, acts=LineOfAction(point=metres)), np.abs(vector))


def in_cylinders(st: Statics, loads: Loads) -> dict[str, list[Acting]]:
    """Every thrust where it presses, for the free bodies: on the piston, and oppositely on the bottom of the barrel.

    On the moved link the rod's reaction stands in its place.
    """
    found: dict[str, list[Acting]] = {}
    for force in (_from_the_frame(st.mech, one) for one in loads.forces if one.against):
        outer = next(one for one in st.loads.forces if one.name == force.name)
        pair, line = {force.link, force.against}, st.desk.towards(force.foot, force.point)
        joint = next(j for j in st.mech.joints if isinstance(j, Prismatic) and {j.guide, j.block} == pair)
        vector = _thrust(st, outer) / st.scale.value
        for link, at in zip((joint.guide, joint.block), pressed(st.desk, joint), strict=True):
            sign = 1 if link == force.link else -1
            found.setdefault(link, []).append(Acting(named=load_named(outer), vector=sign * vector, at=foot(Line(st.desk.at[force.foot], line), at)))
    return found

