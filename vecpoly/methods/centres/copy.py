"""The mechanism once more, at the scale of the figure of its centres."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

from ...board.construction import View
from ...board.paper.marks import AngleMark, Dot, Mark, Point, Role, Segment
from ...mechanism.groups.assur import Group
from ..desk import Desk
from ..diagram import Pose
from ..kinematics.diagram.links import draw_frame, draw_links
from .size import Paper

FEW = 4  # links: with more, the letters of the points would crowd those of the centres


def mechanism_marks(desk: Desk, paper: Paper, groups: tuple[Group, ...]) -> Iterator[Mark]:
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
    crowded = len(desk.mech.bodies) >= FEW
    for mark in scratch.board.marks(View.MECHANISM):
        if not _helps(mark):
            yield _unlettered(mark) if crowded else replace(mark, step=0)


def _helps(mark: Mark) -> bool:
    """Whether a mark belongs to a construction: thin lines, their letters, angles."""
    lines = isinstance(mark, Segment) and mark.role in (Role.CONSTRUCTION, Role.HIDDEN)
    return lines or isinstance(mark, AngleMark) or (isinstance(mark, Point) and mark.dot is Dot.NONE)


def _unlettered(mark: Mark) -> Mark:
    return replace(mark, label="", step=0) if isinstance(mark, Point) else replace(mark, step=0)
