"""Cams and eccentric discs: the higher pair is replaced by a link and two lower pairs of the same motion (高副低代).

A disc on a disc: a bar between the two centres, as long as R + r; a disc on a flat face: a block pinned at the disc's
centre, led parallel to the face. With constant radii both are exact, for velocities and for accelerations.
"""

from __future__ import annotations

from ....board.construction import View
from ....diagram.cams.contact import contact_replaced
from ....diagram.cams.follower import pressure_angle
from ....mechanism.groups.assur import Group
from ....mechanism.model import Circle, Contact, Prismatic
from ....words import Words
from ...desk import Desk
from ...registry import Stage


def say_replaced(desk: Desk, stage: Stage, group: Group) -> None:
    """A step for each contact that the group's motion depends on:
    what stands for it, and that its accelerations are the same."""
    for name in group.links:
        contact = contact_replaced(desk.mech, name)
        if contact is not None and stage is Stage.POSITION:
            desk.board.step(
                _bar(desk, contact, group) if isinstance(contact.on, Circle) else _block(contact, group), View.MECHANISM
            )
        elif contact is not None and stage is Stage.ACCELERATION:
            said = _here(contact, group) if _profiled(desk, contact) else _same_motion(contact, group)
            desk.board.step(said, View.ACCELERATION)


def letter_contacts(desk: Desk, links: tuple[str, ...]) -> None:
    """Find the points of contact, once both links are drawn."""
    for contact in desk.mech.contacts:
        if set(links) & {*contact.links, contact.substitute} and set(contact.links) <= set(desk.pose):
            desk.letter(contact.point, desk.contact_of(contact))
            desk.board.remark(_found(contact))
            if not desk.loaded and any(pressure_angle(desk.posed(), contact)):
                desk.board.remark(
                    Words(
                        "公法线与从动件受力点运动方向所夹的锐角 $α$ 为压力角。",
                        " The acute angle $α$ between the common normal and the direction of motion of the follower "
                        "at the contact point is the pressure angle.",
                    )
                )


def tangent_words(desk: Desk, joint: Prismatic) -> Words | None:
    """How a link with a flat face is placed on its disc: by a parallel to the face through the disc's centre."""
    contact = contact_replaced(desk.mech, joint.block)
    if contact is None:
        return None
    o, link = contact.disc.centre, contact.on.link
    r = "ρ" if _profiled(desk, contact) else f"r_{desk.mech.disc_number(contact.disc.link)}"
    return Words(
        f"平底与 ${o}$ 始终相距 ${r}$：过 ${o}$ 的虚拟导路与平底平行，由此定出构件 {link} 的位置",
        f"The face of link {link} is always at the distance ${r}$ from ${o}$, parallel to the guide through ${o}$",
    )


def _profiled(desk: Desk, contact: Contact) -> bool:
    """Whether a circle stands for a profile here: of radius ρ, as the step calls it that finds it."""
    return any(cam.point == contact.point for cam in desk.mech.cams)


def _bar(desk: Desk, contact: Contact, group: Group) -> Words:
    assert isinstance(contact.on, Circle)
    bar, (one, two) = contact.substitute, map(desk.mech.disc_number, (contact.disc.link, contact.on.link))
    length = f"r_{two} − r_{one}" if contact.internal else f"r_{one} + r_{two}"
    if not contact.on.radius:
        length = f"r_{one}"  # an edge has none
    if _profiled(desk, contact):
        length = "ρ"  # of the tip's path on the cam
    real = _real(group, contact)
    if not contact.on.radius:
        return _edge(
            contact, Words(f"构件 {real} 组成 {group.kind} 杆组", f"link {real} an {group.kind} group"), length
        )
    return Words(
        f"高副低代：接触点 ${contact.point}$ 处两廓线的曲率中心为 ${contact.disc.centre}$、"
        f"${contact.on.centre}$，以连心线 ${bar}$ 为杆长（$l_{{{bar}}} = {length}$），用一杆两转动副代替高副 "
        f"${contact.point}$，与构件 {real} 组成 {group.kind} 杆组。",
        f"Replace the higher pair: the centres of curvature at the contact ${contact.point}$ are "
        f"${contact.disc.centre}$ and ${contact.on.centre}$; a bar ${bar}$ along the line of "
        f"centres ($l_{{{bar}}} = {length}$) stands for the contact, and link {real} becomes part "
        f"of an {group.kind} group.",
    )


def _block(contact: Contact, group: Group) -> Words:
    o, real = contact.disc.centre, _real(group, contact)
    return Words(
        f"高副低代：构件 {contact.on.link} 为平底，其曲率中心在无穷远处；以铰接于另一廓线曲率中心 ${o}$、"
        f"沿平底方向滑动的滑块代替高副 ${contact.point}$，与构件 {real} 组成 {group.kind} 杆组。",
        f"Replace the higher pair: the face of link {contact.on.link} has its centre of curvature "
        f"at infinity; a block pinned at the centre of curvature ${o}$ of the other profile and sliding parallel to "
        f"the face stands for the contact ${contact.point}$, and with link {real} makes an {group.kind} group.",
    )


def _same_motion(contact: Contact, group: Group) -> Words:
    """Why the substitute serves for accelerations too."""
    return Words(
        f"接触点 ${contact.point}$ 处两廓线的曲率半径为常数，高副低代后加速度也不变，仍用该 {group.kind} 杆组求解。",
        f"The radii of curvature at ${contact.point}$ are constant, so that the {group.kind} group "
        "has the same accelerations as the higher pair.",
    )


def _here(contact: Contact, group: Group) -> Words:
    """Why it serves at this place of a profile whose curvature changes."""
    return Words(
        f"曲率圆与廓线在 ${contact.point}$ 处有相同的切线和曲率，故此瞬时的加速度与高副相同，仍用该 {group.kind} "
        "杆组求解。",
        f"The osculating circle has the tangent and the curvature of the profile at ${contact.point}$, so that the "
        f"{group.kind} group has the accelerations of the higher pair at this instant.",
    )


def _edge(contact: Contact, group: Words, length: str) -> Words:
    """Of a knife edge, which is the point of contact itself."""
    assert isinstance(contact.on, Circle)
    k, b, t, bar = contact.disc.centre, contact.on.centre, contact.point, contact.substitute
    return Words(
        f"高副低代：尖顶 ${b}$ 即接触点 ${t}$，凸轮廓线在该处的曲率中心为 ${k}$；以 ${bar}$ 为杆长"
        f"（$l_{{{bar}}} = {length}$），用一杆两转动副代替高副 ${t}$，与{group.zh}。",
        f"Replace the higher pair: the knife edge ${b}$ is the point of contact ${t}$ itself, and ${k}$ the centre of "
        f"curvature of the cam there; a bar ${bar}$ ($l_{{{bar}}} = {length}$) stands for the contact and forms with "
        f"{group.en}.",
    )


def _real(group: Group, contact: Contact) -> str:
    """The real links of the group, by their numbers."""
    return "、".join(name for name in group.links if name != contact.substitute)


def _found(contact: Contact) -> Words:
    k, o = contact.point, contact.disc.centre
    if isinstance(contact.on, Circle) and not contact.on.radius:
        bar = f"{o}{contact.on.centre}"
        return Words(f"公法线 $n$–$n$ 为 ${bar}$。", f" The common normal $n$–$n$ is ${bar}$.")
    if isinstance(contact.on, Circle):
        return Words(
            f"接触点 ${k}$ 在连心线 ${o}{contact.on.centre}$ 上，该线即公法线 $n$–$n$。",
            f" The point of contact ${k}$ lies on the line of centres ${o}{contact.on.centre}$, "
            "which is the common normal $n$–$n$.",
        )
    return Words(
        f"由 ${o}$ 向平底作垂线，垂足为接触点 ${k}$，该垂线即公法线 $n$–$n$。",
        f" The perpendicular from ${o}$ to the face is the common normal $n$–$n$; its foot is the "
        f"point of contact ${k}$.",
    )
