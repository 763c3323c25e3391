"""The thrust of a cylinder as outer forces.

A cylinder whose links carry nothing else is a two-force member: its thrust acts on the moved link along the line of
the two pins. Where they carry loads or masses, or something rubs there, it presses on piston and barrel, which stay a
group.
"""

from __future__ import annotations

import numpy as np

from ....board.construction import View
from ....foundation.slotted import replace
from ....mechanism.asked.forces import load_symbol
from ....mechanism.groups.assur import Group
from ....mechanism.loads import Force, Loads
from ....mechanism.model import FRAME, Mechanism
from ....names import reaction
from ....plane import nominal
from ....words import Words
from ...desk import Desk
from ..acting import OTHER_END


def as_outer_forces(desk: Desk, loads: Loads) -> Loads:
    """The loads with every thrust as forces: on the link at the rod's end, and an opposite one on that at the barrel's,
    if it moves; or on the piston and on the barrel, where these are no two-force member."""
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


def is_strut(mech: Mechanism, loads: Loads, force: Force) -> bool:
    """Whether the thrust acts on one link at each end, in a cylinder that carries nothing else and has no friction: as
    that of a two-force member. One that is sought with friction elsewhere must be on the frame for that."""
    joins = all(len(beside(mech, force, pin)) == 1 for pin in (force.point, force.foot))
    tried = is_floating(mech, force) and force.size is None and bool(loads.friction)
    return joins and not tried and not loads.burdens(force) and not _rubs(loads, force)


def opposite_name(force: Force) -> str:
    """F_c′: what a thrust does at the barrel's end;
    another name than that of the rod's end, for both may stand in one polygon."""
    return f"{force.name}{OTHER_END}"


def is_floating(mech: Mechanism, force: Force) -> bool:
    """Whether the barrel hangs on a moving link."""
    return mech.links_at(force.foot)[-1] != FRAME


def unknown_thrust(loads: Loads) -> Force | None:
    """The thrust that is sought, if it is one."""
    return next((force for force in loads.forces if force.against and force.size is None), None)


def floating_unknown(mech: Mechanism, loads: Loads) -> Force | None:
    """The thrust that is sought, where its cylinder is a two-force member between two moving links."""
    force = unknown_thrust(loads)
    return force if force is not None and is_floating(mech, force) and is_strut(mech, loads, force) else None


def as_moved(mech: Mechanism, loads: Loads, force: Force) -> Force:
    """The thrust as a load on the link at the rod's end, or on the piston, its direction left open:
    enough to know which link it balances."""
    moved = beside(mech, force, force.point)[0] if is_strut(mech, loads, force) else force.link
    return replace(force, link=moved, against="", foot="")


def beside(mech: Mechanism, force: Force, pin: str) -> list[str]:
    """The links at a pin of the cylinder, without its own."""
    return [name for name in mech.links_at(pin) if name not in (force.link, force.against)]


def _outer(desk: Desk, loads: Loads, force: Force) -> tuple[Force, ...]:
    if is_strut(desk.mech, loads, force):
        return _on_its_ends(desk, force)
    return _on_its_links(desk, force, _burdens(loads, force))


def _on_its_links(desk: Desk, force: Force, said: Words) -> tuple[Force, Force]:
    """The thrust on the piston, and the opposite one on the barrel: both along the line of the pins. said: why the
    cylinder is no two-force member."""
    i, j = desk.mech.number(force.link), desk.mech.number(force.against)
    symbol, back = load_symbol(force.name), load_symbol(opposite_name(force))
    pair, pins = f"{force.against}-{force.link}", f"{force.foot}{force.point}"
    desk.board.step(
        Words(
            f"油缸 {pair}{said.zh}推力 ${symbol}$ 沿 ${pins}$ 作用于构件 {i}，等值、反向的 ${back}$ 作用于构件 {j}，"
            "作为外力计入杆组。",
            f"The cylinder {pair}{said.en} its thrust ${symbol}$ acts along ${pins}$ on link {i}, "
            f"and the equal and opposite ${back}$ on link {j}; both count as outer forces on the group.",
        ),
        View.MECHANISM,
    )
    along = _along(desk, force)
    push = replace(force, direction=along, against="", foot="")
    return push, replace(push, name=opposite_name(force), link=force.against, point=force.foot, direction=along + np.pi)


def _along(desk: Desk, force: Force) -> float:
    return float(np.angle(complex(nominal(desk.towards(force.foot, force.point)))))


def _on_its_ends(desk: Desk, force: Force) -> tuple[Force, ...]:
    mech = desk.mech
    (moved,), (base,) = (beside(mech, force, pin) for pin in (force.point, force.foot))
    along = _along(desk, force)
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


def _burdens(loads: Loads, force: Force) -> Words:
    """What makes a cylinder more than a two-force member; a colon alone where nothing on its links does."""
    pair = (force.link, force.against)
    holds = {
        Words("有质量", "whose links have masses"): any(loads.mass(link) for link in pair),
        Words("受其他载荷", "whose links carry other loads"): any(
            load != force for at in pair for load in loads.on(at)
        ),
        Words("有摩擦", "in which there is friction"): _rubs(loads, force),
    }
    found = [words for words, holding in holds.items() if holding]
    if not found:
        return Words("：", ":")
    zh, en = "、".join(one.zh for one in found), " and ".join(one.en for one in found)
    return Words(f" 的构件{zh}，不是二力构件：", f", {en}, is no two-force member:")


def _rubs(loads: Loads, force: Force) -> bool:
    friction = loads.friction
    return bool(
        friction.pins.get(force.foot)
        or friction.pins.get(force.point)
        or friction.slides.get((force.link, force.against))
        or friction.slides.get((force.against, force.link))
    )


def without_cylinders(mech: Mechanism, groups: tuple[Group, ...], loads: Loads) -> tuple[Group, ...]:
    """The groups but those of two-force cylinders."""
    struts = [{one.link, one.against} for one in loads.forces if one.against and is_strut(mech, loads, one)]
    return tuple(group for group in groups if set(group.links) not in struts)
