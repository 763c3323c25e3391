"""A plate cam in a mechanism: its profile as drawn, its base circle, and the circle that osculates at the contact."""

from __future__ import annotations

from collections.abc import Iterator
from math import pi

from ...board.paper.marks import Arc, Curve, Dot, LinkNumber, Mark, Point, Role
from ...mechanism.model import CamProfile, Circle
from ..posed import Posed

INSIDE = 0.55  # of the base circle: where the cam's number stands


def profile_marks(posed: Posed, profile: CamProfile, radius: float) -> Iterator[Mark]:
    """radius: of the osculating circle (m). The base circle is that of the pitch curve."""
    about, axis = posed.at[profile.pivot], posed.axis(profile.link)
    spots = [about + axis * posed.mm(1.0) * spot for spot in profile.outline]
    yield Curve(points=tuple(spots), role=Role.LINK)
    base = min(abs(spot - about) for spot in spots) + posed.mm(_roller(posed, profile))
    yield Arc(centre=about, radius=base, start=0.0, sweep=2 * pi, role=Role.CENTRE)
    centre = posed.at[profile.centre]
    yield Arc(centre=centre, radius=posed.mm(radius), start=0.0, sweep=2 * pi, role=Role.CONSTRUCTION)
    yield Point(at=centre, label="", dot=Dot.POINT)
    spot = about - 1j * INSIDE * base
    yield LinkNumber(a=spot, b=spot, number=posed.name(profile.link))


def _roller(posed: Posed, profile: CamProfile) -> float:
    """The radius of the roller (m), about the pin of which the base circle r_0 is measured; 0 without one."""
    on = next(contact.on for contact in posed.mech.contacts if contact.point == profile.point)
    return on.radius if isinstance(on, Circle) else 0.0
