"""A rack hinged to a known link and a pinion hinged to another:
the pitch line touches the pitch circle, the rack's hinge lies beside it."""

from __future__ import annotations

import numpy as np

from ....board.construction import View
from ....board.paper.marks import Role
from ....errors import AssemblyError, NoMethodError
from ....mechanism.groups.assur import Dyad
from ....mechanism.model import Rack, Revolute, Rolling, Side
from ....plane import distance, nominal, unit
from ....words import Words
from ...desk import Desk
from ...registry import Stage, method
from ..gears.pitch import letter_pitch_points
from .standing import said_standing, standing

_ON_LINE = 1e-9  # m


@method(
    stage=Stage.POSITION,
    group="RGR",
    source="机械原理, kinematic diagrams by Assur groups",
    example="crank-rack-pinion",
    title=Words("齿条—齿轮杆组的位置", "Position of a group of a pinned rack and a pinion"),
)
def position_rgr(desk: Desk, d: Dyad) -> None:
    """The tangent from the rack's hinge to the pitch circle is the pitch line;
    where the hinge lies beside it, to the circle of r ± e."""
    joint = d.inner
    assert isinstance(joint, Rolling) and isinstance(d.outer_j, Revolute) and isinstance(d.outer_k, Revolute)
    pins = {d.link_j: d.outer_j.point, d.link_k: d.outer_k.point}
    gear, rack, c = joint.gear.link, joint.on, joint.gear.centre
    p, q = pins[rack.link], pins[gear]
    if not isinstance(rack, Rack):
        raise NoMethodError(
            Words(
                f"齿轮 {gear} 与 {rack.link} 都不绕轮心铰接（偏心齿轮）：没有相应的图解法；可用 vecpoly exact 求解析值",
                f"gears {gear} and {rack.link} are hinged off their centres: no graphical "
                "method on file locates them; 'vecpoly exact' gives the analytic answers",
            )
        )
    desk.board.step(
        _words(rack.link, gear, c, p, joint.point, on_line=abs(_beside(desk, rack, p)) < _ON_LINE), View.MECHANISM
    )
    desk.settle_turned(gear, q, standing(desk, gear))
    desk.board.remark(said_standing(desk, gear))
    left = desk.mm((1 if joint.side is Side.LEFT else -1) * joint.gear.radius - _beside(desk, rack, p))
    span = distance(desk.at[p], desk.at[c])
    if float(nominal(span)) <= abs(left) + 1e-9:
        raise AssemblyError(
            Words(
                f"构件 {rack.link} 与 {gear}：图上 {p}{c} = {nominal(span):.3f} mm，不大于 {abs(left):.3f} mm，"
                "作不出切线；请改变原动件位置或尺寸",
                f"links {rack.link} and {gear}: {p}{c} is {nominal(span):.3f} mm on "
                f"paper, not longer than {abs(left):.3f} mm, so there is no tangent; "
                "choose another input position or other lengths",
            )
        )
    along = desk.board.turn(unit(desk.at[c] - desk.at[p]) * np.exp(-1j * np.arcsin(left / span)))
    desk.settle_turned(rack.link, p, along * np.exp(-1j * rack.direction))
    letter_pitch_points(desk, (joint,))
    desk.board.join(View.MECHANISM, desk.at[c], desk.at[joint.point], Role.CONSTRUCTION)


def _beside(desk: Desk, rack: Rack, p: str) -> float:
    """How far the hinge lies to the left of the pitch line (m)."""
    return float((np.exp(-1j * rack.direction) * (desk.mech.link(rack.link).points[p] - rack.origin)).imag)


def _words(rack: str, gear: str, c: str, p: str, h: str, *, on_line: bool) -> Words:
    through = Words(f"过 ${p}$ ", f"through ${p}$")
    if not on_line:
        through = Words(f"按 ${p}$ 到节线的距离", f"at the distance of ${p}$ from it,")
    return Words(
        f"以 ${c}$ 为圆心作齿轮 {gear} 的节圆；{through.zh}作齿条 {rack} 的节线与节圆相切，切点为啮合点 ${h}$。",
        f"About ${c}$ draw the pitch circle of gear {gear}; {through.en} draw the "
        f"pitch line of rack {rack} tangent to it: it touches at the pitch "
        f"point ${h}$.",
    )
