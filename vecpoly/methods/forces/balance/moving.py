"""Which links move: from one that all but stands still while others move the groups are near a change point, and what
the lines of their forces meet in is hardly found."""

from __future__ import annotations

from ....board.construction import View
from ....mechanism.model import FRAME
from ....names import omega
from ....plane import nominal
from ...desk import Desk
from ...kinematics.image import known_tips

SLOW = 1e-3  # of the fastest link's: on paper no more than a hair


def moving(desk: Desk) -> frozenset[str]:
    """The links whose points or whose turning are more than a hair on the velocity polygon; all where nothing moves."""
    paces = {link: _pace(desk, link) for link in desk.mech.bodies}
    fastest = max(paces.values(), default=0.0)
    return frozenset(link for link, pace in paces.items() if pace >= SLOW * fastest)


def _pace(desk: Desk, link: str) -> float:
    """How fast a link moves (m/s): its fastest point drawn, or its turning over the mechanism's size."""
    scale, turn = desk.board.scales[View.VELOCITY].value, desk.turns.get(omega(link))
    turning = 0.0 if turn is None or link == FRAME else abs(float(nominal(turn.value)))
    tips = [abs(complex(nominal(desk.tip(View.VELOCITY, at)))) for _, at in known_tips(desk, View.VELOCITY, link)]
    return max([scale * tip for tip in tips] + [desk.mech.scale * turning])
