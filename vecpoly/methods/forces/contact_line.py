"""Two profiles in contact (cam, eccentric disc): the reaction leans by φ from the common normal against the sliding."""

from __future__ import annotations

import numpy as np

from ...board.construction import View
from ...board.marks import Role
from ...plane import Line, Points, nominal
from ...words import Words
from ..registry import Stage, method
from .pieces import TwoForce
from .senses import leaning, velocity_of
from .state import Statics

_SOURCE = "机械原理, friction in higher pairs"


@method(stage=Stage.FORCE, group="contact", source=_SOURCE, example="4-4",
        title=Words("高副接触：反力偏离公法线 φ 角", "Contact of two profiles: reaction inclined by φ from the common normal"))
def line_of_contact(st: Statics, two: TwoForce) -> Line:
    """Line of the force of the parent on the loaded link through the contact K, along that force (it presses).

    R = N + F_f: along the common normal, turned by φ against the sliding of the loaded link past its parent.
    """
    contact = two.contact
    assert contact is not None
    k = st.desk.contact_of(contact)
    outward = st.desk.normal_of(contact)  # from the disc's centre through K
    normal = outward if two.by == contact.disc.link else -outward
    i, j = st.mech.number(two.by), st.mech.number(two.on)
    slip = velocity_of(st, two.on, k) - velocity_of(st, two.by, k)
    u = leaning(st, normal, slip, st.phi(contact), f"contact {contact.point}")
    if st.phi(contact):
        _say(st, i, j, contact.point, slip, normal)
    else:
        st.board.step(Words(f"接触点 ${contact.point}$ 处的反力 $R_{{{i}{j}}}$ 沿公法线。", f"At the contact ${contact.point}$ the reaction $R_{{{i}{j}}}$ acts along the common normal."), View.MECHANISM)
    u = np.asarray(st.board.hand.tilt(u))[()]
    st.board.join(View.MECHANISM, k - u * 22.0, k + u * 22.0, Role.DIRECTION)
    return Line(k, u)


def _say(st: Statics, i: str, j: str, point: str, slip: Points, normal: Points) -> None:
    right = float(nominal((np.conj(1j * normal) * slip).real)) < 0
    side, side_en = ("右", "right") if right else ("左", "left")
    st.board.step(Words(f"接触点 ${point}$ 处，构件 {j} 相对构件 {i} 沿公切线滑动（顺 $R_{{{i}{j}}}$ 的指向看，向{side}滑），故 $R_{{{i}{j}}}$ 偏离公法线 $φ$ 角以阻止此滑动。",
                        f"At the contact ${point}$ link {j} slides past link {i} along the common tangent, to the {side_en} looking along $R_{{{i}{j}}}$; "
                        f"the reaction leans by $φ$ from the common normal so as to hinder it."), View.MECHANISM)
