"""One group of a loaded mechanism: by the lines of action where a link passes the force on, else by moments."""

from __future__ import annotations

from ....errors import NoMethodError
from ....mechanism.groups.assur import Group, joint_letter
from ....mechanism.groups.stars import has_plate
from ....mechanism.model import Joint, Prismatic, Revolute
from ....plane import Line, cross, lines_meet, nominal, unit
from ....words import Words
from ...registry import Stage
from ..doors import COUPLES, LINES, MOMENTS, WHOLE
from ..lines.couples_on_guides import couple_on_guide
from ..lines.links_of_group import Held, TwoForce, pieces
from ..lines.parallel_forces import PARALLEL
from ..lines.resultant import Resultant, resultant
from ..lines.three_forces import balance
from ..state import Statics
from ..teeth.carried import carried_of
from ..teeth.mesh import mesh_of, pinned

NEAR_CIRCLE = 1.25  # radii of a friction circle: a tangent from nearer by is no line to rely on


def solve_group(st: Statics, group: Group) -> None:
    """Find the reactions in the joints of a group; raises NoMethodError for groups above class II."""
    whole = has_plate(group) or carried_of(group) is not None
    if whole or (group.dyad is None and mesh_of(group) is not None):
        WHOLE.find(Stage.FORCE, group.kind).draw(st, group)
        return
    if group.dyad is None:
        raise NoMethodError(
            Words(
                f"没有对 {group.name.zh}作力分析的图解法；仍可用 vecpoly exact 求解析解",
                f"no graphical method on file finds the forces in a {group.name.en}; 'vecpoly exact' still "
                "gives the analytic answers",
            )
        )
    dyad = pinned(group.dyad)
    found = pieces(st, dyad)
    if found is not None and not st.loaded(found[1].link):
        _unloaded(st, *found)
    elif found is not None and group.links not in st.by_moments and _direct(st, *found):
        return
    else:
        st.by_moments.add(group.links)
        MOMENTS.find(Stage.FORCE, dyad.kind).draw(st, dyad)


def _direct(st: Statics, two: TwoForce, held: Held) -> bool:
    """Lines of action and one polygon; False where the load's line does not meet the two-force link's."""
    kinds = joint_letter(two.inner), joint_letter(two.outer)
    if "P" in kinds and "R" not in kinds:
        return False
    load = resultant(st, held.link)
    if not _is_met(st, two, held, load):
        return False
    line = line_of(st, two)
    if _is_in_circle(st, two, held, load, line):
        return False
    by = two.by if two.contact else two.link
    if load.is_couple and isinstance(held.joint, Prismatic):
        couple_on_guide(st, held, load, line, by)
    elif load.is_couple:
        COUPLES.find(Stage.FORCE, "link under a couple").draw(st, (held, line, by))
    else:
        balance(st, held, load, line, by)
    if not two.contact:
        _pass_on(st, two, line)
    return True


def _is_met(st: Statics, two: TwoForce, held: Held, load: Resultant) -> bool:
    """Whether the load's line meets that of the two-force link;
    a couple, whether a link under a couple alone bears it."""
    if not load.is_couple:
        return not _parallel(st, load, two)
    # no block, no rod: nothing can be taken apart from the loaded link
    slotted = two.link in st.mech.slot_pins or two.contact is not None
    rubbed = any(on == held.link for _, on in st.couples)  # a friction couple may turn round the force that balances it
    return slotted or not (load.forces or rubbed or not isinstance(held.joint, Revolute))


def _is_in_circle(st: Statics, two: TwoForce, held: Held, load: Resultant, line: Line) -> bool:
    """Whether the three forces would meet in the friction circle of the pin, or all but: the load alone may pass there,
    and while the friction couples are on trial it may pass too near. Moments need no tangent."""
    joint = held.joint
    if load.is_couple or two.contact is not None or not isinstance(joint, Revolute) or not st.rho(joint.point):
        return False
    if abs(float(nominal(cross(load.line.along, line.along)))) < PARALLEL:
        return False
    away = abs(complex(nominal(lines_meet(load.line, line) - st.desk.at[joint.point])))
    return away < NEAR_CIRCLE * float(nominal(st.rho(joint.point)))


def _pass_on(st: Statics, two: TwoForce, line: Line) -> None:
    """The force through the two-force link, at both its joints."""
    passed = st.push(two.link, two.on)
    assert passed is not None
    for joint, by, on in ((two.inner, two.link, two.on), (two.outer, two.by, two.link)):
        at, sense = st.at_joint(joint, line), _sense(st, joint, by, on)
        st.settle(by, on, passed.vector, at, passed.drawn, sense, computed=passed.computed)


def line_of(st: Statics, two: TwoForce) -> Line:
    """The line of action of the force that the two-force link passes on, by the method for its two joints."""
    kind = (
        "contact"
        if two.contact
        else (
            "two-force link R-R"
            if isinstance(two.inner, Revolute) and isinstance(two.outer, Revolute)
            else "two-force block R-P"
        )
    )
    return LINES.find(Stage.FORCE, kind).draw(st, two)


def _sense(st: Statics, joint: Joint, by: str, on: str) -> int:
    """Sense of the moment of R_by,on about the pin of a joint (0: no pin, or no friction)."""
    return st.moment_sense(joint.point, by, on) if isinstance(joint, Revolute) else 0


def _parallel(st: Statics, load: Resultant, two: TwoForce) -> bool:
    """Whether the load is parallel to the line through the two-force link's pins, or along it."""
    if not (isinstance(two.inner, Revolute) and isinstance(two.outer, Revolute)) or two.contact:
        return False
    along = unit(st.desk.at[two.inner.point] - st.desk.at[two.outer.point])
    return abs(float(nominal(cross(load.line.along, along)))) < PARALLEL


def _unloaded(st: Statics, two: TwoForce, held: Held) -> None:
    """No load on the whole group: no force in its joints."""
    where = st.desk.at.get(getattr(two.inner, "point", ""), 0j)
    for by, on in ((two.by, held.link) if two.contact else (two.link, two.on), (held.parent, held.link)):
        st.settle(by, on, 0j, where)
    if not two.contact:
        st.settle(two.by, two.link, 0j, where)
