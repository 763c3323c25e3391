"""The acceleration at a pitch point of which both bodies' motions are led:
the tangential parts agree, the rest is along the common normal.

a_Hk (as the link k is led) = a_Hm + a_HkHm,    a_HkHm along the line of centres,
or perpendicular to a rack's pitch line
"""

from __future__ import annotations

from collections.abc import Callable

from ....board.construction import View
from ....mechanism.model import Rolling
from ....names import At
from ....vector.close import Closed
from ....vector.equation import Equation, Term
from ....words import Words
from ...desk import Desk
from ..chains import solve
from ..dyads.rrr import total
from .pitch import along_normal, normal_words, partner_acceleration


def mesh(desk: Desk, joint: Rolling, link: str, led: Callable[[], tuple[Term, ...]], asked: Words) -> Closed:
    """Write and draw the equation; `led` gives the terms of the link's own point,
    `asked` ends the sentence of the step."""
    view, own = View.ACCELERATION, At(joint.point, link)
    base = partner_acceleration(desk, joint, link)
    desk.board.step(_tangents_agree(joint) + asked, view)
    left = led()
    front = total(desk, view, own, len(left)) if len(left) > 1 and base else ""
    return solve(desk, view, Equation(left=left, right=(*base, along_normal(desk, joint, link)), total=front), own)


def _tangents_agree(joint: Rolling) -> Words:
    """What pure rolling says of the accelerations at the pitch point."""
    h, way = joint.point, normal_words(joint)
    return Words(
        f"啮合点 ${h}$：两构件在 ${h}$ 处的切向加速度相等，加速度只差{way.zh}分量",
        f"At the pitch point ${h}$ both bodies have the same tangential acceleration; their "
        f"accelerations differ only by a component {way.en}",
    )
