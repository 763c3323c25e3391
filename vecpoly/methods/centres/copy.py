"""The mechanism once more, at the scale of the figure of its centres."""

from __future__ import annotations

from collections.abc import Iterator

from ...board.construction import View
from ...board.paper.symbols import Symbol
from ...diagram.copied import copied
from ...mechanism.groups.assur import Group
from ..desk import Desk
from ..diagram import Pose
from ..kinematics.diagram.links import draw_frame, draw_links
from .size import Paper

FEW = 4  # links: with more, the letters of the points would crowd those of the centres


def mechanism_copied(desk: Desk, paper: Paper, groups: tuple[Group, ...]) -> Iterator[Symbol]:
    """Frame and links as in the position diagram, reduced;
    without their construction lines, and of many links without letters."""
    scratch = Desk(
        board=desk.board.scratch({View.MECHANISM: paper.scale}),
        mech=desk.mech,
        coincident=desk.coincident,
        shapes=desk.shapes,
    )
    scratch.at = {name: desk.at[name] * paper.factor for name in desk.mech.frame}
    for number, links in enumerate(((desk.mech.drive.link,), *(group.links for group in groups))):
        for name in links:
            pose = desk.pose[name]
            scratch.pose[name] = Pose(pose.origin * paper.factor, pose.along)
            scratch.at |= {letter: desk.at[letter] * paper.factor for letter in desk.letters(name) if letter in desk.at}
        scratch.at |= {
            c.point: desk.at[c.point] * paper.factor for c in desk.mech.contacts if set(c.links) <= set(scratch.pose)
        }
        if number == 0:
            draw_frame(scratch)
        draw_links(scratch, links)
    return copied(scratch.board.marks(View.MECHANISM), lettered=len(desk.mech.bodies) < FEW)
