"""A gear or a rack that one pair of teeth drives: known loads, the force of the teeth on its line of action, and the
reaction of the bearing or the guide."""

from __future__ import annotations

from ....board.board import NO_LENGTH
from ....board.construction import View
from ....mechanism.groups.assur import Group
from ....mechanism.model import Prismatic, Revolute
from ....plane import cross, nominal
from ....words import Words
from ...registry import Stage, method
from ..bodies.link_polygon import answered, unread
from ..doors import COUPLES
from ..lines.couples_on_guides import couple_on_guide
from ..lines.resultant import Resultant, resultant
from ..lines.three_forces import balance
from ..state import Statics
from .line_of_action import line_of_teeth
from .mesh import Mesh, mesh_of

_SOURCE = "机械原理, forces between the teeth of gears: along the line of action"


@method(
    stage=Stage.FORCE,
    group="gear",
    source=_SOURCE,
    example="winch-gears",
    title=Words("齿轮的力分析：啮合力与轴承反力", "Forces on a gear: its teeth and its bearing"),
)
def forces_on_gear(st: Statics, group: Group) -> None:
    """P + R_teeth + R_bearing = 0: three forces that meet in one point, or a couple P and two equal forces."""
    _solve(st, group)


@method(
    stage=Stage.FORCE,
    group="rack",
    source=_SOURCE,
    example="rack-lift",
    title=Words("齿条的力分析：啮合力与导路反力", "Forces on a rack: its teeth and its guide"),
)
def forces_on_rack(st: Statics, group: Group) -> None:
    """P + R_teeth + R_guide = 0, R_guide normal to the guide (or at φ to that)."""
    _solve(st, group)


def _solve(st: Statics, group: Group) -> None:
    mesh = mesh_of(group)
    assert mesh is not None
    held = mesh.held
    if not st.loaded(held.link):
        _unloaded(st, mesh)
        return
    load = resultant(st, held.link)
    if _idle(st, mesh, load):
        _bearing_alone(st, mesh, load)
        return
    line = line_of_teeth(st, mesh, load)
    if not load.is_couple:
        balance(st, held, load, line, mesh.by)
    elif isinstance(held.joint, Prismatic):
        couple_on_guide(st, held, load, line, mesh.by)
    else:
        COUPLES.find(Stage.FORCE, "link under a couple").draw(st, (held, line, mesh.by))


def _unloaded(st: Statics, mesh: Mesh) -> None:
    """Nothing acts on the gear: nothing on its teeth and in its bearing."""
    held = mesh.held
    for by in (mesh.by, held.parent):
        st.settle(by, held.link, 0j, st.desk.at[mesh.teeth.point])


def _idle(st: Statics, mesh: Mesh, load: Resultant) -> bool:
    """Whether the known loads pass through a bearing without friction: then they turn nothing."""
    joint = mesh.held.joint
    if load.is_couple or not isinstance(joint, Revolute) or st.rho(joint.point):
        return False
    arm = float(nominal(cross(load.line.along, st.desk.at[joint.point] - load.at)))
    return abs(arm) < NO_LENGTH


def _bearing_alone(st: Statics, mesh: Mesh, load: Resultant) -> None:
    """The bearing alone bears loads that pass through it."""
    held = mesh.held
    assert isinstance(held.joint, Revolute)
    teeth, bearing, pin = st.named(mesh.by, held.link), st.named(held.parent, held.link), held.joint.point
    number = st.mech.number(held.link)
    st.board.step(
        Words(
            f"取构件 {number} 为分离体：{load.told.zh} 的合力过 ${pin}$，对 ${pin}$ 无矩，故齿间的 "
            f"${teeth.symbol}$ = 0，${bearing.symbol}$ 与之等值、反向、共线。",
            f"Isolate link {number}: {load.told.en} pass through ${pin}$ and turn nothing about it, so the teeth "
            f"carry nothing, ${teeth.symbol}$ = 0; ${bearing.symbol}$ is equal and opposite, in the same line.",
        ),
        View.MECHANISM,
    )
    st.settle(mesh.by, held.link, 0j, st.desk.at[mesh.teeth.point])
    drawn = answered(st, held.parent, held.link, load)
    st.settle(held.parent, held.link, -load.vector, st.desk.at[pin], drawn, computed=unread(st, load))
