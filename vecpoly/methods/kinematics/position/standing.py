"""Where a gear or an arm stands in the given position, when that is a datum because gears leave it open."""

from __future__ import annotations

from math import degrees, radians

import numpy as np

from ....algebra.quantity import number
from ....errors import NoMethodError
from ....mechanism.assembly.start import Start
from ....mechanism.model import Link
from ....plane import Points, Reals
from ....problem.values.leaning import X_AXIS, at_angle
from ....words import Words
from ...desk import Desk


def start_of(desk: Desk, link: str) -> Start | None:
    """What the problem tells of this link's angle, if anything."""
    return next((one for one in desk.mech.starts if one.link == link and not one.slide), None)


def told_in(desk: Desk, start: Start) -> Reals:
    """What is told of a link's angle (rad) or travel (m), in every place that is drawn."""
    return desk.board.in_each(start.value, start.key)


def standing(desk: Desk, link: str) -> Points:
    """Paper direction of the link's x axis, laid off with the protractor; along the frame's where nothing is told.

    Raises NoMethodError where the line from which the angle counts is not drawn yet.
    """
    start = start_of(desk, link)
    if start is None:
        return 1 + 0j
    if not set(start.ray) <= set(desk.at):
        ray = "".join(start.ray)
        raise NoMethodError(
            Words(
                f"构件 {link} 的角度自 {ray} 量起，而 {ray} 此时尚未画出；请改自 x 轴或连心线量起",
                f"the angle of link {link} counts from {ray}, which is not drawn before "
                "that link; count it from the x axis or the line of centres",
            )
        )
    zero: Points = desk.towards(*start.ray) if start.ray else 1 + 0j
    return desk.board.turn(zero * np.exp(1j * told_in(desk, start)))


def said_standing(desk: Desk, link: str) -> Words:
    """The sentence that tells how the gear's (or arm's) further point is set out; empty where nothing is told."""
    start, body, other = start_of(desk, link), desk.mech.link(link), told_point(desk, link)
    if start is None or not other:
        return Words("", "")
    first = pivot(desk, body)
    lean = float(np.angle(body.points[other] - body.points[first]))
    turned = degrees(start.value + lean)
    turned = turned if abs(lean) < 1e-9 else (turned + 180) % 360 - 180  # as it is given, where it is
    ray = "".join(start.ray)
    zero = Words(f" ${ray}$ ", f"${ray}$") if ray else X_AXIS
    lies = at_angle(f"{number(turned, 5)}°", radians(turned), zero)
    return Words(
        f"按图示位置 ${first}{other}$ {lies.zh}定出 ${other}$。",
        f" Point ${other}$ is set out with ${first}{other}$, as given, {lies.en}.",
    )


def told_point(desk: Desk, link: str) -> str:
    """The point that `said_standing` sets out; none of a link whose angle is no datum."""
    body = desk.mech.link(link)
    return "" if start_of(desk, link) is None else next((p for p in body.points if p != pivot(desk, body)), "")


def pivot(desk: Desk, body: Link) -> str:
    """The point from which a gear or an arm is set out: one already drawn, a fixed one first."""
    drawn = [p for p in body.points if p in desk.mech.frame] + [p for p in body.points if p in desk.at]
    return next(iter(drawn), next(iter(body.points)))
