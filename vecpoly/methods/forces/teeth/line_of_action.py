"""The line of action of teeth (啮合线): through the pitch point, at the pressure angle to the common tangent."""

from __future__ import annotations

from math import degrees

import numpy as np

from ....board.construction import View
from ....board.paper.marks import Dot, Role
from ....mechanism.model import Prismatic, Revolute
from ....plane import Line, Points, cross, dot, nominal, unit
from ....words import Words
from ..lines.resultant import Resultant
from ..state import Statics
from .mesh import Mesh

HALF = 20.0  # mm of the common tangent and of the line of action to either side of the pitch point
ARC = 15.0  # mm, radius of the mark of α
_PRESSED = "alpha"  # the pressure angle of the driven link, where it is asked too


def line_of_teeth(st: Statics, mesh: Mesh, load: Resultant) -> Line:
    """The line of the force of the teeth on the held link: through the pitch point H, at α to the common tangent.

    Of the two lines that of the flank which works: teeth only press, so the force leans towards the gear's centre.
    """
    h = st.desk.at[mesh.teeth.point]
    out = unit(st.desk.at[mesh.teeth.gear.centre] - h)  # the gear is pressed away from its partner
    side = _flank(st, mesh, load, h, 1j * out)
    alpha = mesh.teeth.alpha
    lean = 1j * out * side * np.cos(alpha) + out * np.sin(alpha)  # on the gear
    along = lean if mesh.teeth.gear.link == mesh.held.link else -lean
    st.board.step(_told(st, mesh), View.MECHANISM)
    along = st.board.turn(along)
    if not st.preliminary:  # teeth have no friction: the line is the same in both passes
        draw_line_of_action(st, mesh, h, along, 1j * out)
    return Line(h, along)


def _flank(st: Statics, mesh: Mesh, load: Resultant, h: Points, tangent: Points) -> int:
    """The sign, along `tangent`, of the force that presses on the gear: as it was before, or as the known loads ask."""
    own = 1 if mesh.teeth.gear.link == mesh.held.link else -1
    before = st.pushed_before(mesh.by, mesh.held.link)
    if before is not None and nominal(np.abs(before)) > 0:
        return 1 if own * nominal(dot(before, tangent)) > 0 else -1
    lever, driven = _need(st, mesh, load, h, tangent)
    return -own if float(nominal(lever * driven)) > 0 else own


def _need(st: Statics, mesh: Mesh, load: Resultant, h: Points, tangent: Points) -> tuple[Points, Points]:
    """What a force along the tangent on the held link does, and what the known loads do to it:
    moments about its pin, or parts along its guide."""
    joint = mesh.held.joint
    if isinstance(joint, Prismatic):
        along = st.desk.guide_line(joint).along
        return dot(tangent, along), dot(load.vector, along)
    assert isinstance(joint, Revolute)
    pin = st.desk.at[joint.point]
    moment = st.paper_moment(load.couple) if load.is_couple else cross(load.at - pin, load.vector)
    if abs(float(nominal(moment))) <= 1e-9 * abs(nominal(load.vector)) * abs(nominal(h - pin)):
        moment = float(st.moment_sense(joint.point, mesh.held.parent, mesh.held.link))  # only the friction of the pin
    return cross(h - pin, tangent), moment


def _told(st: Statics, mesh: Mesh) -> Words:
    """Which line it is, and what tells its side."""
    i, j, h = st.mech.number(mesh.by), st.mech.number(mesh.held.link), mesh.teeth.point
    symbol, alpha = st.named(mesh.by, mesh.held.link).symbol, f"{degrees(mesh.teeth.alpha):g}°"
    need = (
        Words(f"须使构件 {j} 沿导路平衡", f"must balance link {j} along its guide")
        if isinstance(mesh.held.joint, Prismatic)
        else Words(
            f"对 ${_pin(mesh)}$ 之矩须与构件 {j} 上已知力之矩相反",
            f"must turn link {j} about ${_pin(mesh)}$ against its known loads",
        )
    )
    if st.pushed_before(mesh.by, mesh.held.link) is not None:
        need = Words("的指向由不计摩擦的力分析得知", "presses as it does without friction")
    angle = flank_words(st)
    return Words(
        f"构件 {i}、{j} 的轮齿在节点 ${h}$ 啮合，不计齿面摩擦：${symbol}$ 沿啮合线，过 ${h}$，与节圆公切线 $t–t$ 成"
        f"{angle.zh} = {alpha}；${symbol}$ {need.zh}；齿面间只能受压，由此确定工作齿面及其啮合线。",
        f"The teeth of links {i} and {j} mesh at the pitch point ${h}$. Without friction on the flanks ${symbol}$ acts "
        f"along the line of action, through ${h}$ at the {angle.en} = {alpha} to the common tangent $t–t$. "
        f"The force ${symbol}$ {need.en}, and teeth can only press: this determines the flank.",
    )


def flank(st: Statics) -> str:
    """The angle of the line of action: α, or α' where the pressure angle α of the driven link is marked as well."""
    return "α'" if _PRESSED in st.board.found else "α"


def flank_words(st: Statics) -> Words:
    """What that angle is called, and its symbol."""
    symbol = flank(st)
    if symbol == "α":
        return Words(f"压力角 ${symbol}$", f"pressure angle ${symbol}$")
    return Words(f"啮合角 ${symbol}$", f"working pressure angle ${symbol}$")


def _pin(mesh: Mesh) -> str:
    return mesh.held.joint.point if isinstance(mesh.held.joint, Revolute) else ""


def draw_line_of_action(st: Statics, mesh: Mesh, h: Points, along: Points, tangent: Points) -> None:
    """The common tangent, the line of action, and α between the two."""
    board = st.board
    toward = tangent if float(nominal(dot(tangent, along))) > 0 else -tangent
    board.join(View.MECHANISM, h - toward * HALF, h + toward * HALF, Role.CENTRE)
    named = st.named(mesh.by, mesh.held.link)
    board.join(View.MECHANISM, h - along * HALF, h + along * HALF, Role.DIRECTION, key=named.key)
    board.plot(View.MECHANISM, h + along * HALF, named.symbol, Dot.NONE, key=named.key)
    if mesh.teeth.alpha:
        board.angle(View.MECHANISM, h, -toward, np.angle(along / toward), ARC, flank(st))
