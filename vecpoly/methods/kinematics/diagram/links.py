"""The kinematic diagram in its found position: the frame first, then each group as soon as it is located."""

from __future__ import annotations

from ....board.construction import View
from ....board.paper.marks import Dot, FixedGuide, LinkNumber, Point
from ....diagram.cams.contact import contact_drawn
from ....diagram.links import links_drawn
from ....diagram.owners import FIXED
from ....diagram.single import number, pivot
from ....mechanism.model import Revolute
from ....names import subscripted
from ...desk import Desk


def draw_frame(desk: Desk) -> None:
    """What is there before anything moves: fixed pivots, the lowest that has no arrow of a drive with the frame's
    number, and points of the frame from which guides are set out."""
    pinned, posed = {j.point for j in desk.mech.joints if isinstance(j, Revolute)}, desk.posed()
    for name, at in desk.mech.frame.items():
        if name in pinned:
            desk.board.depict(View.MECHANISM, pivot(at * desk.mm(1.0)))
        desk.board.plot(View.MECHANISM, at * desk.mm(1.0), name, posed.dot(name) if name in pinned else Dot.POINT)
    pivots = {name: at for name, at in desk.mech.frame.items() if name in pinned}
    driven = {posed.fixed_pivot(drive.link) for drive in desk.mech.drives}
    free = [at for name, at in pivots.items() if name not in driven]
    if pivots:
        at = min(free or pivots.values(), key=lambda z: (z.imag, z.real)) * desk.mm(1.0)
        desk.board.depict(View.MECHANISM, number(desk.mech.frame_number, at, owner=FIXED))


def number_guide(desk: Desk) -> None:
    """The frame's number at its first guide, where it has no pivot."""
    marks = desk.board.marks(View.MECHANISM)
    guide = next((mark for mark in marks if isinstance(mark, FixedGuide)), None)
    if guide is not None and not any(isinstance(mark, LinkNumber) and mark.owner == FIXED for mark in marks):
        desk.board.depict(View.MECHANISM, number(desk.mech.frame_number, guide.a, guide.b, owner=FIXED))


def draw_links(desk: Desk, links: tuple[str, ...]) -> None:
    """The links of one group, once they are located, with contacts and letters just found."""
    posed = desk.posed()
    desk.board.depict(View.MECHANISM, *links_drawn(posed, links, desk.board.marks(View.MECHANISM)))
    done = {m.label for m in desk.board.marks(View.MECHANISM) if isinstance(m, Point)}
    for contact in desk.mech.contacts:
        if contact.point in desk.at and contact.point not in done:
            desk.board.depict(View.MECHANISM, *contact_drawn(posed, contact))
            desk.board.plot(View.MECHANISM, desk.at[contact.point], contact.point, Dot.POINT)
            done.add(contact.point)
    for name in (letter for link in links for letter in desk.letters(link)):
        if subscripted(name) not in done and name in desk.at and not name.endswith("'"):
            desk.board.plot(View.MECHANISM, desk.at[name], subscripted(name), posed.dot(name))
            done.add(subscripted(name))
