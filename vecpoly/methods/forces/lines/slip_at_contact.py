"""How two profiles slide at their contact: from the velocities that both have in T, as the drawing tells them."""

from __future__ import annotations

import numpy as np

from ....algebra.columns import significant
from ....board.construction import View
from ....mechanism.model import FRAME
from ....names import Kind, Rel
from ....plane import Points, nominal
from ....words import Words, joined
from ...kinematics.image import known_tips
from ..senses import velocity_of, way_of
from ..state import Statics


def slip_words(st: Statics, point: str, links: tuple[str, str], slip: Points, normal: Points) -> Words:
    """v_T2T1 = v_T2 − v_T1, each told by how its link moves; the size (m/s), and the way along the common tangent.

    links: the one that presses and the one that is pressed; slip: mm on the velocity polygon, where a vector between
    the tips of a substitute's points is another velocity.
    """
    by, on = links
    i, j, tangent = st.mech.number(by), st.mech.number(on), 1j * complex(nominal(normal))
    along = (tangent.conjugate() * complex(nominal(slip))).real
    size = significant(abs(along) * st.board.scales[View.VELOCITY].value, 3)
    way, there = way_of(tangent * float(np.sign(along))), f"v_{{{point}{j}{point}{i}}}"
    both = joined([_velocity_at(st, point, link) for link in links if link != FRAME])
    terms = " − ".join(f"$v_{{{point}{st.mech.number(link)}}}$" for link in (on, by) if link != FRAME)
    gives = f"${there}$ = " + "−" * (on == FRAME) + terms
    return Words(
        f"接触点 ${point}$ 处：{both.zh}；{gives} 沿公切线{way.zh}，大小为 {size} m/s。",
        f"At the contact ${point}$: {both.en}; {gives} is {size} m/s along the common tangent, {way.en}.",
    )


def _velocity_at(st: Statics, point: str, link: str) -> Words:
    """The velocity of the link's point at the contact: that of any of its points where it only translates."""
    number, own = st.mech.number(link), f"v_{{{point}{st.mech.number(link)}}}"
    pivot = next((p for p in st.mech.link(link).points if p in st.mech.frame), "")
    if pivot:
        return _turned(f"${own}$ = $ω_{number}$ $l_{{{pivot}{point}}}$", pivot + point)
    (_, at), *_ = known_tips(st.desk, View.VELOCITY, link)
    known = st.desk.symbol(Rel(Kind.V, at))
    if not _turns(st, link):
        return Words(f"${own}$ = ${known}$（构件 {number} 平动）", f"${own}$ = ${known}$ (link {number} translates)")
    letter = st.desk.show(at)
    return _turned(f"${own}$ = ${known}$ + $ω_{number}$ $l_{{{letter}{point}}}$", letter + point)


def _turned(velocity: str, arm: str) -> Words:
    return Words(f"{velocity}（⊥ ${arm}$）", f"{velocity} (⊥ ${arm}$)")


def _turns(st: Statics, link: str) -> bool:
    """Whether the link turns, and does not only translate."""
    return not np.array_equal(velocity_of(st, link, 1.0 + 0j), velocity_of(st, link, 0j))
