"""A crank-rocker from K: θ first, then A on the circle η, or C₂ on a ray from A."""

from __future__ import annotations

from math import degrees

from ....designs.crank_rocker import CrankRocker
from ....designs.quantities import AD, CD, SWING
from ....words import Words
from ..advance import theta_of
from ..draft import Draft
from ..registry import design_method
from .by_limit import by_limit
from .by_swing import by_swing


@design_method(
    CrankRocker,
    title=Words("按行程速比系数 K 设计曲柄摇杆机构", "Crank-rocker from its time ratio K"),
    source="机械原理, synthesis by the coefficient of travel speed variation: inscribed angle over the chord C1C2",
    example="8-15",
)
def draw_crank_rocker(draft: Draft, design: CrankRocker) -> None:
    """θ = 180° (K − 1) / (K + 1), and the construction that goes with what is given beside."""
    theta = theta_of(draft, design.K.si)
    draft.shared(CD, design.CD.si * 1e3)
    for named, given in ((SWING, design.swing), (AD, design.AD)):
        if given is not None:
            draft.shared(named, given.si * 1e3 if named is AD else degrees(given.si))
    by_limit(draft, design, theta) if design.swing is None else by_swing(draft, design, theta)
