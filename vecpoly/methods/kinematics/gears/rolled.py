"""The velocity image of a gear: a circle."""

from __future__ import annotations

import numpy as np

from ....board.construction import View
from ....board.paper.marks import Role
from ....names import At
from ....plane import Reals, nominal
from ....words import Words
from ...desk import Desk

LEAST = 0.5  # mm: smaller images are points


def image_circle(desk: Desk, link: str, c: str, h: str) -> None:
    """The image of a gear's pitch circle is a circle about the tip of its centre."""
    centre, rim = (desk.tip(View.VELOCITY, At(x)) for x in (c, h))
    radius: Reals = np.abs(rim - centre)
    if nominal(radius) < LEAST:
        return
    desk.board.circle(View.VELOCITY, centre, radius, Role.CENTRE)
    desk.board.remark(
        Words(
            f"以 ${c.lower()}$ 为圆心、过 ${h.lower()}$ 的圆即齿轮 {link} 的速度影像。",
            f" The circle about ${c.lower()}$ through ${h.lower()}$ is the velocity image of gear {link}.",
        )
    )
