"""A group drawn apart, with the forces on it at their lines of action and
the arms about the points of its moment equations."""

from __future__ import annotations

from ....board.construction import Pane, Place, View
from ....board.paper.marks import Dot, Point, Role, Vector
from ....diagram.links import ALONE, link_alone
from ....names import At
from ....plane import Line, Points, nominal, unit
from ....words import Words
from ..acting import Acting
from ..bodies.arrows import REACH, place_arrows, say_far
from ..bodies.bars import bars_of
from ..bodies.given_loads import ways_of_loads
from ..bodies.inked import ink_arrows
from ..couples import couples_on
from ..state import Statics

COUPLE = 8.0  # mm, radius of a couple's arrow
SHORT = 2.0  # mm: shorter arms carry no letter
BESIDE = 30.0  # mm from a point of the body
PIECE = 8.0  # mm to both sides of a foot that is far from where the force acts


def group_pane(st: Statics, *links: str) -> Pane:
    """The figure of a group freed from the other links, in the position of the kinematic diagram."""
    numbers = "-".join(st.mech.number(link) for link in links)
    name = st.polygon(numbers, polygon_title(st, *links)).name
    ideal = Words("不计摩擦时", " without friction") if st.preliminary else Words.same("")
    pane = st.board.open_pane(
        View.BODY, name, Words(f"{ideal.zh}杆组 {numbers} 受力图", f"Free body of group {numbers}{ideal.en}")
    )
    if st.board.seen and not st.board.marks(pane):
        for link in links:
            _draw_link(st, pane, link)
    return pane


def polygon_title(st: Statics, *links: str) -> Words:
    """Title of a group's force polygon."""
    numbers = "-".join(st.mech.number(link) for link in links)
    return Words(f"杆组 {numbers} 的力多边形", f"Force polygon of group {numbers}")


def draw_arm(st: Statics, pane: Place, about: Points, end: Points, line: Line, letter: str) -> None:
    """The arm from the point to the line of action, with its letter; the line runs from its own point to the foot, of
    a foot that is far from there no more than a piece about it."""
    board, at = st.board, line.at
    if (arm := float(abs(nominal(end - about)))) > REACH and not _reaches(st, pane, end):
        board.remark(_not_drawn(letter, arm))
        return
    board.join(pane, about, end, Role.CONSTRUCTION)
    away = abs(nominal(end - at))
    if away > REACH:
        board.join(pane, end - PIECE * line.along, end + PIECE * line.along, Role.DIRECTION)
    elif away > 1.0:
        board.join(pane, at, end, Role.DIRECTION)
    if abs(nominal(end - about)) > SHORT:
        board.right_angle(pane, end, unit(about - end), unit(at - end) if away > 1.0 else line.along)
        board.plot(pane, (about + end) / 2, letter, Dot.NONE)


def _reaches(st: Statics, pane: Place, end: Points) -> bool:
    """Whether the body itself goes as far as the end of an arm, or nearly."""
    points = (mark.at for mark in st.board.marks(pane) if isinstance(mark, Point) and mark.dot is not Dot.NONE)
    return any(abs(at - complex(nominal(end))) < BESIDE for at in points)


def _not_drawn(letter: str, arm: float) -> Words:
    """What is measured on the diagram and has no room on a free body."""
    return Words(
        f"（力臂 ${letter}$ 在机构图上长 {arm:.0f} mm，受力图上不画。）",
        f" (The arm ${letter}$ is {arm:.0f} mm long on the diagram and is not drawn on the free body.)",
    )


def draw_forces(st: Statics, pane: Pane, links: tuple[str, ...], forces: list[Acting]) -> None:
    """All outer forces and couples on the group, as far apart as their lines allow;
    once, for later rounds only repeat them."""
    if not st.board.seen:
        return
    there = [mark for mark in st.board.marks(pane) if isinstance(mark, Vector)]
    if {mark.label for mark in there} & {force.named.symbol for force in forces}:
        return
    spots = [complex(nominal(st.desk.at[p])) for link in links for p in st.mech.link(link).points if p in st.desk.at]
    bars, inside = [*bars_of(st.board.marks(pane))], [(mark.a, mark.b) for mark in there]
    arrows = place_arrows(forces, spots, *ways_of_loads(st), bars=bars, standing=inside)
    ink_arrows(st, pane, links, forces, arrows)
    say_far(st, forces, spots)
    for link in links:
        pivot = complex(nominal(st.desk.at[next(iter(st.mech.link(link).points))]))
        for turn, (symbol, size) in enumerate(
            (symbol, size) for symbol, size in couples_on(st, link, within=links) if nominal(size)
        ):
            st.board.curved_arrow(pane, pivot, COUPLE + 3 * turn, 2.2, bool(nominal(size) > 0), symbol)


def _draw_link(st: Statics, pane: Pane, link: str) -> None:
    """The link as it is drawn alone, its letters once."""
    desk, board = st.desk, st.board
    posed = desk.posed()
    board.depict(pane, link_alone(posed, link, lettered=False))
    lettered = {m.label for m in board.marks(pane) if isinstance(m, Point)}
    for letter in (letter for letter in desk.mech.link(link).points if letter in desk.at):
        if desk.name(At(letter)) not in lettered:
            place = complex(nominal(desk.at[letter]))
            dot = posed.dot(letter)
            board.plot(pane, place, desk.name(At(letter)), ALONE.get(dot, dot))
