"""Two profiles in contact (cam, eccentric disc): the reaction leans by φ from the common normal against the sliding."""

from __future__ import annotations

import numpy as np

from ....board.construction import View
from ....board.paper.marks import Dot, Role
from ....plane import Line, Points, nominal
from ....words import Words
from ...registry import Stage, method
from ..senses import leaning, velocity_of
from ..state import Statics
from .links_of_group import TwoForce
from .slip_at_contact import slip_words

_SOURCE = "机械原理, friction in higher pairs"


@method(
    stage=Stage.FORCE,
    group="contact",
    source=_SOURCE,
    example="4-4",
    title=Words(
        "高副接触：反力偏离公法线 φ 角", "Contact of two profiles: reaction inclined by φ from the common normal"
    ),
)
def line_of_contact(st: Statics, two: TwoForce) -> Line:
    """Line of the force of the parent on the loaded link through the contact K, along that force (it presses).

    R = N + F_f: along the common normal, turned by φ against the sliding of the loaded link past its parent.
    """
    contact = two.contact
    assert contact is not None
    k = st.desk.contact_of(contact)
    outward = st.desk.normal_of(contact)  # from the disc's centre through K
    normal = outward if two.by == contact.disc.link else -outward
    slip = velocity_of(st, two.on, k) - velocity_of(st, two.by, k)
    what, named = Words(f"接触点 {contact.point}", f"contact {contact.point}"), st.named(two.by, two.on)
    u = leaning(st, normal, slip, st.phi(contact), what, key=named.key)
    if st.phi(contact):
        _say(st, two, slip, normal)
    else:
        symbol = st.named(two.by, two.on).symbol
        rubs = st.loads.friction and st.rubbing
        zh, en = (
            ("该接触处无摩擦", "No friction acts at this contact, so") if rubs else ("不计摩擦", "Without friction")
        )
        st.board.step(
            Words(
                f"{zh}，接触点 ${contact.point}$ 处的反力 ${symbol}$ 沿公法线 $n–n$。",
                f"{en} the reaction ${symbol}$ at ${contact.point}$ acts along the common normal $n–n$.",
            ),
            View.MECHANISM,
        )
    u = st.board.turn(u)
    st.board.join(View.MECHANISM, k - u * 22.0, k + u * 22.0, st.ruled(Role.DIRECTION), key=named.key)
    st.board.plot(View.MECHANISM, k + u * 22.0, named.symbol, Dot.NONE, key=named.key)
    return Line(k, u)


def _say(st: Statics, two: TwoForce, slip: Points, normal: Points) -> None:
    assert two.contact is not None
    i, j, point, phi = st.mech.number(two.by), st.mech.number(two.on), two.contact.point, st.phi_symbol(two.contact)
    right = float(nominal((np.conj(1j * normal) * slip).real)) < 0
    side, side_en = ("右", "right") if right else ("左", "left")
    there = f"v_{{{point}{j}{point}{i}}}"
    st.board.step(slip_words(st, point, (two.by, two.on), slip, normal), View.MECHANISM)
    st.board.remark(
        Words(
            f"面向 $R_{{{i}{j}}}$ 的指向看，构件 {j} 相对构件 {i} 向{side}滑动。摩擦力与之反向，"
            f"故 $R_{{{i}{j}}}$ 自公法线偏转 ${phi}$ 角，与 ${there}$ 成 90° + ${phi}$。",
            f" Looking along $R_{{{i}{j}}}$, link {j} slides to the {side_en} past link {i}. Friction opposes it, so "
            f"$R_{{{i}{j}}}$ is inclined at ${phi}$ to the common normal and makes 90° + ${phi}$ with ${there}$.",
        )
    )
