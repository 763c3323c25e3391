"""The arm of the couple on the link whose moment is sought, on the free body of that link too: its two parallel lines
are the only ones there."""

from __future__ import annotations

from collections.abc import Sequence

from ....board.acts import Measure
from ....board.construction import Pane
from ....board.paper.marks import Role
from ....mechanism.loads import Moment
from ....mechanism.model import FRAME
from ....plane import foot, nominal
from ..acting import Acting
from ..inertia import SHORT, draw_arm
from ..state import Statics
from .arrows import REACH, Arrow

ARM = "h"  # as it is measured on the kinematic diagram
PAST = 3.0  # mm: so far a line goes on beyond the arm


def draw_couple_arm(st: Statics, pane: Pane, link: str, forces: Sequence[Acting], arrows: Sequence[Arrow]) -> None:
    """From the frame's reaction square across to the other force, whose line is carried on to it."""
    frame = st.named(FRAME, link).symbol
    measured = any(isinstance(act, Measure) and act.key == ARM for act in st.board.acts)
    if not isinstance(st.unknown, Moment) or st.unknown.link != link or not measured or len(forces) != 2:
        return
    own = next((force for force in forces if force.named.symbol == frame), None)
    other = next((force for force in forces if force.named.symbol != frame), None)
    arrow = next((one for one in arrows if other is not None and one.symbol == other.named.symbol), None)
    if own is None or other is None or arrow is None:
        return
    line, at = other.line, complex(nominal(own.at))
    across, u = complex(nominal(foot(line, at))), complex(nominal(line.along))
    if SHORT < abs(across - at) < REACH:
        near = min(arrow.start, arrow.end, key=lambda end: abs(end - across))
        if ((arrow.start - across).conjugate() * (arrow.end - across)).real > 0.0:  # the arm meets no arrow
            st.board.join(pane, near, across + PAST * (across - near) / abs(across - near), Role.DIRECTION)
        elif abs(near - across) < PAST:  # it meets one at its end
            past = PAST * (near - across) / abs(near - across) if near != across else PAST * u
            st.board.join(pane, across - past, across + past, Role.DIRECTION)
        draw_arm(st, pane, ARM, at, across, u)
