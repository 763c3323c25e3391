"""A rack that a known gear drives along its guide, fixed or moving."""

from __future__ import annotations

from ....board.construction import View
from ....board.paper.marks import Dot
from ....mechanism.groups.assur import Group, ends
from ....mechanism.model import FRAME, Prismatic, Rolling
from ....names import At, Kind, Rel, omega
from ....vector.close import close
from ....vector.equation import UNKNOWN, Equation, Term
from ....words import Words, joined
from ...desk import Desk
from ...registry import Stage, method
from ..chains import coincident_tip, never_turns, sliding_chain
from ..image import images_of_link
from ..terms import known
from ..turning import same_turn
from .meshing import mesh
from .pitch import pitch_velocity, rolling_of

_NUMBER = (("image", "coincides"), ("images", "coincide"))
_SOURCE = "机械原理, pure rolling; relative motion of coincident points"


@method(
    stage=Stage.VELOCITY,
    group="rack",
    source=_SOURCE,
    example="pinion-drives-rack",
    title=Words("齿条的速度", "Velocity of a driven rack"),
)
def velocity_rack(desk: Desk, group: Group) -> None:
    """v_H of the rack is that of the gear at the pitch point; on a moving guide v_Hk = v_Hg + v_HkHg."""
    view, rack = View.VELOCITY, group.links[0]
    joint, _, led = _pairs(group)
    pitch_velocity(desk, joint, rack)
    h = joint.point
    own, base = At(h, rack), At(h, led)
    desk.put_tip(view, own, desk.tip(view, At(h)))
    if led == FRAME:
        desk.board.step(
            Words(
                f"齿条 {rack} 沿固定导路移动，其上各点的速度都等于啮合点 ${h}$ 的速度 $v_{h}$。",
                f"Rack {rack} slides along its fixed guide: all its points have the velocity "
                f"$v_{h}$ of the pitch point ${h}$.",
            ),
            view,
        )
        never_turns(desk, rack)
    else:
        coincident_tip(desk, view, h, led)
        desk.board.step(
            Words(
                f"齿条 {rack} 与导路所在构件 {led} 在 ${h}$ 处的重合点间的相对速度：",
                f"The velocity of rack {rack} relative to link {led}, its guide, at ${h}$:",
            ),
            view,
        )
        rel = Rel(Kind.V, own, desk.canonical(base))
        slip = Term(rel=rel, symbol=desk.symbol(rel), direction=UNKNOWN, magnitude="?")
        eq = Equation(left=(known(desk, view, own),), right=(known(desk, view, base), slip))
        desk.board.equate(eq.table())
        close(desk.board, view, 0j, eq)
        same_turn(desk, rack, led, view)
    _lettered(desk, view, rack, At(h))


@method(
    stage=Stage.ACCELERATION,
    group="rack",
    source=_SOURCE,
    example="pinion-drives-rack",
    title=Words("齿条的加速度", "Acceleration of a driven rack"),
)
def acceleration_rack(desk: Desk, group: Group) -> None:
    """a_Hk (∥ guide; on a moving one a_Hg + a^k + a^r) = a_Hm + a_HkHm (along the common normal)."""
    view, rack = View.ACCELERATION, group.links[0]
    joint, slide, led = _pairs(group)
    h = joint.point
    coincident_tip(desk, view, h, led)
    mesh(desk, joint, rack, lambda: sliding_chain(desk, view, At(h, rack), At(h, led), slide, led), Words("：", ":"))
    if led != FRAME:
        same_turn(desk, rack, led, view)
    _lettered(desk, view, rack, At(h, rack))


def _lettered(desk: Desk, view: View, rack: str, pitch: At) -> None:
    """The rack's own points; on one that only translates they all lie at one tip, that of the pitch point, which gets
    their letters."""
    images_of_link(desk, view, rack)
    if not desk.turns[omega(rack)].never:
        return
    for letter in desk.mech.link(rack).points:
        desk.board.plot(view, desk.tip(view, At(letter)), desk.tip_label(view, At(letter)), Dot.NONE)
    own = [letter for letter in desk.mech.link(rack).points if letter != pitch.point]
    if own:
        points = joined([Words.same(f"${letter}$") for letter in own])
        tips = joined([Words.same(f"${desk.tip_label(view, At(letter))}$") for letter in own])
        at, (image, coincide) = desk.tip_label(view, pitch), _NUMBER[len(own) > 1]
        desk.board.remark(
            Words(
                f"齿条上 {points.zh} 点的影像 {tips.zh} 与 ${at}$ 重合。",
                f" The {image} of {points.en} on the rack, {tips.en}, {coincide} with ${at}$.",
            )
        )


def _pairs(group: Group) -> tuple[Rolling, Prismatic, str]:
    """The rolling pair, the slide, and the link along which the rack slides."""
    joint = rolling_of(group)
    slide = next(outer.joint for outer in group.outer if isinstance(outer.joint, Prismatic))
    return joint, slide, next(name for name in ends(slide) if name != group.links[0])
