"""A gear whose centre other links hold: at the pitch point it has the velocity,
and the tangential acceleration, of what it rolls on."""

from __future__ import annotations

from ....board.construction import View
from ....mechanism.groups.assur import Group
from ....mechanism.model import Circle, Rolling
from ....names import At, Kind, Rel
from ....vector.equation import Term
from ....words import Words
from ...desk import Desk
from ...registry import Stage, method
from ..chains import letters
from ..image import found_tip, images_of_link
from ..terms import known, normal
from ..turning import angular_acceleration, angular_velocity
from .meshing import mesh
from .pitch import pitch_velocity, rolling_of, wheel
from .rolled import image_circle

_SOURCE = "机械原理, pure rolling: the pitch point is the relative instant centre"


@method(
    stage=Stage.VELOCITY,
    group="gear",
    source=_SOURCE,
    example="planet-drive",
    title=Words("齿轮（行星轮）的速度", "Velocity of a gear on a held centre"),
)
def velocity_gear(desk: Desk, group: Group) -> None:
    """ω = v_CH / r: the velocities of centre C and pitch point H are known both; about a fixed centre ω = v_H / r."""
    view, gear = View.VELOCITY, group.links[0]
    joint, c = _pair(group)
    h = joint.point
    found_tip(desk, view, At(c))
    pitch_velocity(desk, joint, gear)
    about, to = (c, h) if desk.at_rest(view, At(c)) and not desk.at_rest(view, At(h)) else (h, c)
    ref = None if desk.at_rest(view, At(about)) else At(about)
    rel = Rel(Kind.V, At(to), ref)
    ends = desk.tip(view, At(about)), desk.tip(view, At(to))
    desk.board.arrow_once(view, *ends, key=desk.key(rel))
    angular_velocity(desk, gear, about, to, ends, letters(desk, view, ref, At(to)), desk.symbol(rel))
    image_circle(desk, gear, c, h)
    images_of_link(desk, view, gear)


@method(
    stage=Stage.ACCELERATION,
    group="gear",
    source=_SOURCE,
    example="planet-drive",
    title=Words("齿轮（行星轮）的加速度", "Acceleration of a gear on a held centre"),
)
def acceleration_gear(desk: Desk, group: Group) -> None:
    """a_C + a^n_HC + a^t_HC = a_Hm + a_HkHm (along the line of centres):
    the tangential accelerations agree, which gives α."""
    view, gear = View.ACCELERATION, group.links[0]
    joint, c = _pair(group)
    h, own = joint.point, At(joint.point, gear)
    rest = desk.at_rest(view, At(c))
    rel = Rel(Kind.AT, own, None if rest else At(c))

    def led() -> tuple[Term, ...]:
        tangent = Term(
            rel=rel,
            symbol=desk.symbol(rel),
            direction=Words.same(f"⊥$ {h}{c}$"),
            magnitude="?",
            along=1j * desk.towards(c, h),
        )
        return (*(() if rest else (known(desk, view, At(c)),)), normal(desk, own, At(c), gear), tangent)

    closed = mesh(desk, joint, gear, led, Words(f"，列方程求 $α_{gear}$：", f"; write the equation for $α_{gear}$:"))
    angular_acceleration(
        desk, gear, c, h, closed.ends[rel.key], f"{desk.n_tip(gear)} {desk.tip_label(view, own)}", desk.symbol(rel)
    )
    images_of_link(desk, view, gear)


def _pair(group: Group) -> tuple[Rolling, str]:
    """The rolling pair, and the letter of the gear's centre."""
    joint = rolling_of(group)
    mine = wheel(joint, group.links[0])
    assert isinstance(mine, Circle)
    return joint, mine.centre
