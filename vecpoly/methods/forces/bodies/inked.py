"""The arrows of a free body as they are inked: with the line of action of one that stands farther out on it or ends
short of the foot of an arm, and the guide carried on to where a reaction of it acts beyond the body."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Sequence

from ....board.construction import Pane
from ....board.paper.marks import Mark, RightAngle, Role, Segment, Vector
from ....diagram.owners import link as owner_of
from ....mechanism.model import Prismatic
from ....plane import nearest_between, nominal
from ..acting import Acting
from ..state import Statics
from .arrows import Arrow
from .bars import bars_of

OFF = 6.0  # mm from all that is drawn of the body: a force that acts farther off hangs in the air
ON = 0.02  # mm from a line: what lies on it


def ink_arrows(
    st: Statics, pane: Pane, links: Collection[str], forces: Sequence[Acting], arrows: Sequence[Arrow]
) -> None:
    """The arrows, the line of action from its point to one that stands farther out, and the guides that run on."""
    places, shown = {force.named.symbol: complex(nominal(force.at)) for force in forces}, {one.symbol for one in arrows}
    for arrow in arrows:
        if arrow.far:
            at = places[arrow.symbol]
            st.board.join(pane, at, min(arrow.start, arrow.end, key=lambda z: abs(z - at)), Role.DIRECTION)
    for symbol, link in _guided(st, links):
        if symbol in shown:
            _carry_on(st, pane, link, places[symbol])
    for arrow in arrows:
        st.board.arrow(pane, arrow.start, arrow.end, Role.RESULT, key=arrow.key, label=arrow.symbol)
        _carry_to_feet(st, pane, arrow)


def _carry_to_feet(st: Statics, pane: Pane, arrow: Arrow) -> None:
    """The line of action on to the feet of the arms that end on it, where nothing is drawn of it."""
    way = (arrow.end - arrow.start) / abs(arrow.end - arrow.start)
    marks = tuple(st.board.marks(pane))
    for mark in marks:
        if isinstance(mark, RightAngle) and min(abs((leg / way).imag) for leg in (mark.u, mark.v)) < ON:
            near = min(arrow.start, arrow.end, key=lambda z: abs(z - mark.at))
            if abs(((mark.at - arrow.start) / way).imag) < ON and not any(_covers(m, mark.at, way) for m in marks):
                st.board.join(pane, near, mark.at, Role.DIRECTION)


def _covers(mark: Mark, place: complex, way: complex) -> bool:
    """Whether a line or an arrow along this way passes through the place."""
    if not isinstance(mark, Segment | Vector):
        return False
    a, b = (mark.a - place) / way, (mark.b - place) / way
    return max(abs(a.imag), abs(b.imag)) < ON and a.real * b.real <= ON**2


def _guided(st: Statics, links: Collection[str]) -> Iterator[tuple[str, str]]:
    """The reactions of slides between one of these links and another, and that link."""
    for joint in st.mech.joints:
        if isinstance(joint, Prismatic):
            for by, on in ((joint.guide, joint.block), (joint.block, joint.guide)):
                if on in links and by not in links:
                    yield st.named(by, on).symbol, on


def _carry_on(st: Statics, pane: Pane, link: str, at: complex) -> None:
    """From the nearest place of the link to where the reaction acts, if that is beyond it."""
    marks = (mark for mark in st.board.marks(pane) if mark.owner == owner_of(link))
    pins = [complex(nominal(st.desk.at[point])) for point in st.mech.link(link).points if point in st.desk.at]
    places = [*(nearest_between(a, b, at) for a, b in bars_of(marks)), *pins]
    near = min(places, key=lambda place: abs(place - at), default=at)
    if abs(near - at) > OFF:
        st.board.join(pane, near, at, Role.CENTRE)
