"""A cylinder whose links carry nothing else is a two-force member:
its thrust acts on the moved link along the line of the two pins."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from ....board.construction import LineOfAction, Reading, View
from ....diagram.cylinders import pressed
from ....errors import NoMethodError
from ....mechanism.asked.forces import load_named, load_symbol, without_friction
from ....mechanism.groups.assur import Group
from ....mechanism.loads import Force, Loads
from ....mechanism.model import FRAME, Mechanism, Prismatic
from ....names import Named, reaction
from ....plane import Line, Points, foot, nominal
from ....words import Words
from ...desk import Desk
from ..acting import OTHER_END, Acting
from ..state import Statics


def as_outer_forces(desk: Desk, loads: Loads) -> Loads:
    """The loads with every thrust as a force on the link at the rod's end,
    and an opposite one on that at the barrel's, if it moves.

    Raises NoMethodError where a thrust is no such force.
    """
    return replace(
        loads,
        forces=tuple(
            outer for force in loads.forces for outer in (_outer(desk, loads, force) if force.against else (force,))
        ),
    )


def from_the_frame(mech: Mechanism, loads: Loads) -> Loads:
    """The loads with the foot of every thrust on the frame, where one end of its cylinder is:
    cylinder and piston may stand either way round."""
    return replace(loads, forces=tuple(_turned(mech, force) if force.against else force for force in loads.forces))


def _turned(mech: Mechanism, force: Force) -> Force:
    if force.foot not in mech.frame and force.point in mech.frame:
        return replace(force, link=force.against, point=force.foot, against=force.link, foot=force.point)
    return force


def is_outer(mech: Mechanism, loads: Loads, force: Force) -> bool:
    """Whether the thrust acts on one link at each end, in a cylinder that carries nothing else and has no friction."""
    return _hindered(mech, loads, force) is None


def opposite_name(force: Force) -> str:
    """F_c′: what a thrust does at the barrel's end;
    another name than that of the rod's end, for both may stand in one polygon."""
    return f"{force.name}{OTHER_END}"


def is_floating(mech: Mechanism, force: Force) -> bool:
    """Whether the barrel hangs on a moving link."""
    return mech.links_at(force.foot)[-1] != FRAME


def floating_unknown(mech: Mechanism, loads: Loads) -> Force | None:
    """The thrust that is sought, where its cylinder stands between two moving links."""
    return next(
        (force for force in loads.forces if force.against and force.size is None and is_floating(mech, force)), None
    )


def as_moved(mech: Mechanism, force: Force) -> Force:
    """The thrust as a load on the link at the rod's end, its direction left open:
    enough to know which link it balances."""
    return replace(force, link=_beside(mech, force, force.point)[0], against="", foot="")


def _beside(mech: Mechanism, force: Force, pin: str) -> list[str]:
    """The links at a pin of the cylinder, without its own."""
    return [name for name in mech.links_at(pin) if name not in (force.link, force.against)]


def _hindered(mech: Mechanism, loads: Loads, force: Force) -> Words | None:
    """Why the thrust is not that of a two-force member between two links; None where it is."""
    if loads.burdens(force):
        return Words("油缸的构件上另有载荷或质量", "other loads or masses act on its links")
    if _rubs(loads, force):
        i, j = sorted((mech.number(force.link), mech.number(force.against)))
        where = f"{force.foot}, {force.point}, {i}-{j}"
        return Words(f"油缸的运动副中有摩擦（{where} 之一）", f"there is friction in one of its joints, {where}")
    if is_floating(mech, force) and force.size is None and loads.friction:
        return Words(
            "油缸不与机架相连，而机构中有摩擦（虚功率法不计摩擦）",
            "the cylinder is not on the frame and there is friction, of which virtual power knows nothing",
        )
    crowded = next((pin for pin in (force.point, force.foot) if len(_beside(mech, force, pin)) != 1), "")
    return Words(f"${crowded}$ 处不止一个构件", f"at {crowded} there is not one link alone") if crowded else None


def _outer(desk: Desk, loads: Loads, force: Force) -> tuple[Force, ...]:
    mech = desk.mech
    if (why := _hindered(mech, loads, force)) is not None:
        raise _no_method(loads, force, why)
    (moved,), (base,) = (_beside(mech, force, pin) for pin in (force.point, force.foot))
    along = float(np.angle(complex(nominal(desk.towards(force.foot, force.point)))))
    below, above = (
        reaction(mech.number(by), mech.number(on)).symbol for by, on in ((base, force.against), (force.link, moved))
    )
    back = load_symbol(opposite_name(force))
    opposite = (
        Words("", "")
        if base == FRAME
        else Words(
            f"，并以等值、反向的 ${back}$ 作用于构件 {base} 的 ${force.foot}$ 点",
            f", and as the equal and opposite ${back}$ on link {base} at ${force.foot}$",
        )
    )
    desk.board.step(
        Words(
            f"油缸 {force.against}-{force.link} 不受其他载荷，为二力构件，推力 ${load_symbol(force.name)}$ 沿 "
            f"${force.foot}{force.point}$ 作用于构件 {moved} 的 ${force.point}$ 点{opposite.zh}；${force.foot}$、"
            f"${force.point}$ 两铰链的反力 ${below}$、${above}$ 都等于它。",
            f"The cylinder {force.against}-{force.link} carries nothing else and is a "
            f"two-force member: its thrust ${load_symbol(force.name)}$ acts along "
            f"${force.foot}{force.point}$ on link {moved} at ${force.point}${opposite.en}; "
            f"the reactions ${below}$ at ${force.foot}$ and ${above}$ at ${force.point}$ "
            "equal it.",
        ),
        View.MECHANISM,
    )
    push = Force(name=force.name, link=moved, point=force.point, direction=along, size=force.size, role=force.role)
    return (
        (push,)
        if base == FRAME
        else (push, replace(push, name=opposite_name(force), link=base, point=force.foot, direction=along + np.pi))
    )


def _rubs(loads: Loads, force: Force) -> bool:
    friction = loads.friction
    return bool(
        friction.pins.get(force.foot)
        or friction.pins.get(force.point)
        or friction.slides.get((force.link, force.against))
    )


def _no_method(loads: Loads, force: Force, why: Words) -> NoMethodError:
    """Why, and what is drawn instead: without friction the balancing load alone, else without that of the cylinder."""
    name = loads.unknown.name
    alone = Words(
        f"只求平衡载荷：find: [{name}]（虚功率法）", f"ask the balancing load alone, find: [{name}] (virtual power)"
    )
    if not loads.friction:
        remedy = Words("可", "") + alone
    elif _rubs(loads, force) and not loads.burdens(force):
        remedy = Words(
            "可去掉油缸处的摩擦（其余运动副的摩擦可保留）", "leave out that of the cylinder, the others' may stay"
        )
    else:
        remedy = Words("可去掉摩擦，", "leave out the friction and ") + alone
    return NoMethodError(
        Words(
            f"油缸推力 {force.name}：{why.zh}，已有的图解法不能求解；",
            f"the thrust {force.name}: {why.en}, and no graphical method on file covers that; ",
        )
        + remedy
        + Words("；vecpoly exact 给出解析解", "; 'vecpoly exact' gives it"),
        code="thrust",
    )


def without_cylinders(groups: tuple[Group, ...], loads: Loads) -> tuple[Group, ...]:
    """The groups but those of two-force cylinders."""
    rams = [{force.link, force.against} for force in loads.forces if force.against]
    return tuple(group for group in groups if set(group.links) not in rams)


def read_thrusts(st: Statics, loads: Loads) -> None:
    """The reactions at a cylinder's pins are its thrust, and act there along the line of the two pins; piston and
    barrel do not press on each other sideways."""
    for force in (one for one in loads.forces if one.against):
        outer = next(one for one in st.loads.forces if one.name == force.name)
        _keep_none(st, loads, force)
        base = _beside(st.mech, force, force.foot)[0]
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
            sign = 1 if link == force.link else -1
            found.setdefault(link, []).append(
                Acting(named=load_named(outer), vector=sign * vector, at=foot(Line(st.desk.at[force.foot], line), at))
            )
    return found
