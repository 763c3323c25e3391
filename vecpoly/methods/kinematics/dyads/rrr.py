"""Velocity and acceleration of an RRR group: v_C = v_B + v_CB, closed by ⊥CD and ⊥CB."""

from __future__ import annotations

from ....board.construction import View
from ....mechanism.groups.assur import Dyad
from ....mechanism.model import Revolute
from ....names import At, Kind, Rel
from ....vector.close import Ends
from ....vector.equation import Equation
from ....words import Words
from ...desk import QUANTITY, VECTOR, Desk
from ...registry import Stage, method
from ..chains import letters, solve, turning_chain
from ..image import images_of_link
from ..terms import ref_at
from ..turning import angular_acceleration, angular_velocity
from .parallelogram import is_parallelogram, move_parallelogram

_SOURCE = "机械原理, relative motion of two points of one link"


@method(
    stage=Stage.VELOCITY,
    group="RRR",
    source=_SOURCE,
    example="3-5",
    title=Words("RRR 杆组的速度", "Velocity of an RRR group"),
)
def velocity_rrr(desk: Desk, d: Dyad) -> None:
    """v_P + v_CP = v_Q + v_CQ: two perpendiculars meet in c."""
    _hinge_group(desk, View.VELOCITY, d)


@method(
    stage=Stage.ACCELERATION,
    group="RRR",
    source=_SOURCE,
    example="3-5",
    title=Words("RRR 杆组的加速度", "Acceleration of an RRR group"),
)
def acceleration_rrr(desk: Desk, d: Dyad) -> None:
    """a_P + a^n_CP + a^t_CP = a_Q + a^n_CQ + a^t_CQ."""
    _hinge_group(desk, View.ACCELERATION, d)


def _hinge_group(desk: Desk, view: View, d: Dyad) -> None:
    assert isinstance(d.inner, Revolute) and isinstance(d.outer_j, Revolute) and isinstance(d.outer_k, Revolute)
    if is_parallelogram(desk, d):
        move_parallelogram(desk, view, d)
        return
    c = d.inner.point
    desk.board.step(opening(view, c, d.link_j, d.link_k), view)
    hinge_polygon(desk, view, c, (d.outer_j.point, d.link_j), (d.outer_k.point, d.link_k))


def hinge_polygon(desk: Desk, view: View, c: str, *arms: tuple[str, str]) -> None:
    """The vector of C from two links that turn about known points: (point, link) each; then ω or α of both."""
    sides = sorted((turning_chain(desk, view, At(c), about, link) for about, link in arms), key=len)
    eq = Equation(left=sides[0], right=sides[1], total=total(desk, view, At(c), len(sides[0])))
    closed = solve(desk, view, eq, At(c))
    for about, link in arms:
        turn_of_link(desk, view, closed.ends, At(c), about, link)
    for _, link in arms:
        images_of_link(desk, view, link)


def total(desk: Desk, view: View, to: At, terms: int) -> str:
    """The sought vector's own symbol, where no side of the equation is that vector alone."""
    return "" if view is View.VELOCITY and terms == 1 else desk.symbol(Rel(VECTOR[view], desk.canonical(to)))


def turn_of_link(desk: Desk, view: View, ends: Ends, to: At, about: str, link: str) -> None:
    """ω (from v) or α (from a^t) of a link that turns about one of its hinges."""
    ref = ref_at(desk, view, At(about), link)
    rel = Rel(Kind.V if view is View.VELOCITY else Kind.AT, desk.canonical(to), ref)
    if view is View.VELOCITY:
        angular_velocity(desk, link, about, to.point, ends[rel.key], letters(desk, view, ref, to), desk.symbol(rel))
    else:
        line = f"{desk.n_tip(link)} {desk.tip_label(view, to)}"
        angular_acceleration(desk, link, about, to.point, ends[rel.key], line, desk.symbol(rel))


def opening(view: View, c: str, *links: str) -> Words:
    """The sentence before an equation;
    links that are only thought (the substitute of a contact, a pin in a slot) have no number."""
    links = tuple(name for name in links if name[0].isdigit())
    kind, kind_en = QUANTITY[view].zh, QUANTITY[view].en
    plural = "s" if len(links) > 1 else ""
    return Words(
        f"求构件 {'、'.join(links)} 上 ${c}$ 点的{kind}，列矢量方程并作图。",
        f"Point ${c}$ belongs to link{plural} {' and '.join(links)}: write the vector equation of its {kind_en} and "
        "draw it.",
    )
