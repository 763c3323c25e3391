"""Acceleration of a group with a rolling gear: the centre first, then the gear's α from the pitch point.

On a fixed rack the centre moves parallel to the rack and a_C = α r. On another gear the centre turns about that gear's centre O
as if an arm OC held it, ω_OC = v_CO / l_OC; at the pitch point the two gears' accelerations differ only along OC.
"""

from __future__ import annotations

import numpy as np

from ...board.construction import View
from ...errors import NoMethodError
from ...mechanism.assur import Dyad
from ...mechanism.model import FRAME, Circle, Rack, Revolute, Rolling
from ...names import At, Kind, Rel, alpha, omega
from ...plane import cross
from ...quantity import magnitude
from ...vector.equation import Equation, Term
from ...words import Words
from ..desk import Desk, Turn
from ..registry import Stage, method
from .chains import solve, turning_chain
from .image import imaged, images_of_link
from .rrr import opening, total, turn_of_link
from .terms import known, normal, symbol
from .turning import angular_acceleration

_VIEW = View.ACCELERATION


@method(stage=Stage.ACCELERATION, group="RRG", source="机械原理, pure rolling", example="",
        title=Words("纯滚动齿轮杆组的加速度", "Acceleration of a group with a rolling gear"))
def acceleration_rrg(desk: Desk, d: Dyad) -> None:
    """a_C (∥ rack) or a_O + a^n_CO + a^t_CO = a_P + a^n_CP + a^t_CP."""
    joint = d.outer_k
    assert isinstance(d.inner, Revolute) and isinstance(d.outer_j, Revolute) and isinstance(joint, Rolling)
    c, p = d.inner.point, d.outer_j.point
    if isinstance(joint.on, Rack) and d.parent_k != FRAME:
        raise NoMethodError(Words(
            f"构件 {d.link_k} 在运动的齿条上滚动，没有求其加速度的图解法",
            f"link {d.link_k} rolls on a moving rack: no graphical method on file draws its acceleration"))
    desk.board.step(opening(_VIEW, c, d.link_j, d.link_k), _VIEW)
    centre = _along_rack(desk, joint, c) if isinstance(joint.on, Rack) else _about_gear(desk, joint, joint.on, c)
    swung = turning_chain(desk, _VIEW, At(c), p, d.link_j)
    front = "" if len(centre) == 1 else total(desk, _VIEW, At(c), 2)
    closed = solve(desk, _VIEW, Equation(left=centre, right=swung, total=front), At(c))
    turn_of_link(desk, _VIEW, closed.ends, At(c), p, d.link_j)
    images_of_link(desk, _VIEW, d.link_j)
    if isinstance(joint.on, Circle):
        _pitch_point(desk, joint, joint.on, c)
    else:
        angular_acceleration(desk, d.link_k, joint.point, c, (0j, desk.tip(_VIEW, At(c))), f"p′ {desk.tip_label(_VIEW, At(c))}", f"a_{c}")
    images_of_link(desk, _VIEW, d.link_k)


def _along_rack(desk: Desk, joint: Rolling, c: str) -> tuple[Term, ...]:
    """The centre of a gear on a fixed rack moves parallel to it."""
    assert isinstance(joint.on, Rack)
    rel = Rel(Kind.A, At(c))
    return (Term(rel=rel, symbol=symbol(desk, rel), direction=Words("∥齿条", "∥rack"), magnitude="?",
                 along=complex(np.exp(1j * joint.on.direction)) * desk.axis(joint.on.link)),)


def _about_gear(desk: Desk, joint: Rolling, other: Circle, c: str) -> tuple[Term, ...]:
    """a_O + a^n_CO + a^t_CO, the centre held by the line of centres as by an arm."""
    o, board = other.centre, desk.board
    arm = f"{o}{c}"
    v_o, v_c = (desk.tip(View.VELOCITY, At(x)) for x in (o, c))
    desk.lengths[frozenset((o, c))] = magnitude(f"l_{arm}", other.radius + (-1 if joint.internal else 1) * joint.gear.radius, "m")
    on_paper = board.measure(v_o, v_c, f"{o.lower()} {c.lower()}")
    speed = board.compute(f"ω_{arm}", board.mu(View.VELOCITY) * on_paper / desk.length(o, c), "rad/s")
    desk.turns[omega(arm)] = Turn(speed.value * np.sign(cross(desk.towards(o, c), v_c - v_o)))
    rest = desk.at_rest(_VIEW, At(o))
    rel = Rel(Kind.AT, At(c), None if rest else At(o))
    tangent = Term(rel=rel, symbol=symbol(desk, rel), direction=Words.same(f"⊥$ {arm}$"), magnitude="?", along=1j * desk.towards(o, c))
    return (*(() if rest else (known(desk, _VIEW, At(o)),)), normal(desk, At(c), At(o), arm), tangent)


def _pitch_point(desk: Desk, joint: Rolling, other: Circle, c: str) -> None:
    """a_C + a^n_HC + a^t_HC = a_H of the other gear + a vector along the line of centres: gives α of this gear."""
    h, gear, o = joint.point, joint.gear.link, other.centre
    base = At(h, other.link)
    _alpha_known(desk, other.link)
    if not desk.has_tip(_VIEW, base):
        imaged(desk, _VIEW, other.link, base)
    desk.board.step(Words(f"啮合点 ${h}$：两轮在 ${h}$ 处的加速度只差沿连心线的分量，列方程求 $α_{gear}$：",
                          f"Pitch point ${h}$: the accelerations of the two gears there differ only along the line of centres; for $α_{gear}$:"), _VIEW)
    at = At(h, gear)
    rel = Rel(Kind.AT, at, At(c))
    tangent = Term(rel=rel, symbol=symbol(desk, rel), direction=Words.same(f"⊥$ {h}{c}$"), magnitude="?", along=1j * desk.towards(c, h))
    slide = Rel(Kind.AR, at, base)
    along = Term(rel=slide, symbol=symbol(desk, slide), direction=Words.same(f"∥$ {o}{c}$"), magnitude="?", along=desk.towards(o, c))
    left = (known(desk, _VIEW, At(c)), normal(desk, at, At(c), gear), tangent)
    closed = solve(desk, _VIEW, Equation(left=left, right=(known(desk, _VIEW, base), along)), at)
    angular_acceleration(desk, gear, c, h, closed.ends[rel.key], f"n_{gear}^′ {desk.tip_label(_VIEW, at)}", symbol(desk, rel))


def _alpha_known(desk: Desk, link: str) -> None:
    if alpha(link) not in desk.turns:
        raise NoMethodError(Words(
            f"图上没有求得齿轮 {link} 的角加速度",
            f"the angular acceleration of gear {link} is not known on the drawing"))
