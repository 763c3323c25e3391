"""A link whose load does not meet the force of known line, being parallel to it or a couple:
moments take the place of the meeting point."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ....algebra.quantity import Quantity, magnitude
from ....board.board import NO_LENGTH
from ....board.construction import View
from ....board.paper.marks import Dot, Role
from ....errors import EquilibriumError, LockedError, NoMethodError
from ....foundation.slotted import replace
from ....mechanism.model import Prismatic, Revolute
from ....names import Named
from ....plane import Line, Points, Reals, ahead, cross, dot, foot, lines_meet, nominal, unit
from ....words import Words
from ..acting import Acting
from ..bodies.link_polygon import closing_side, pane_of
from ..readings import write_sizes
from ..senses import pin_words
from ..state import OFF_SHEET, Statics
from .arms import size_of
from .couples_on_guides import balance_on_guide
from .letters import arm_about_point
from .links_of_group import Held
from .meeting import resultant_of
from .resultant import Resultant

PARALLEL = 1e-6  # sine below which a load and a line of action are parallel
ROUNDS = 40  # of trying where a friction circle is touched
NOTHING = 1e-9  # of the force of known line: what is left for the pin is rounding


@dataclass(frozen=True, slots=True, kw_only=True)
class Balanced:
    """The force of known line (signed along it, N) and the pin's force:
    its vector (mm), where it touches the friction circle, its sense."""

    size: Reals
    rest: Points
    touch: Points
    sense: int


def off_sheet(load: Resultant, line: Line, pin: Points) -> bool:
    """Whether a load meets a line of action nowhere, or too far away to be of use."""
    if abs(float(nominal(cross(load.line.along, line.along)))) < PARALLEL:
        return True
    return abs(complex(nominal(lines_meet(load.line, line) - pin))) > OFF_SHEET


def balance_parallel(st: Statics, held: Held, load: Resultant, line: Line, by: str) -> None:
    """Pin: ΣM about the point where the parent's force touches the friction circle, R = P a / b.
    Guide: R = −P, the guide bears the couple."""
    number, one, parallel = (
        st.mech.number(held.link),
        st.named(by, held.link),
        abs(float(nominal(cross(load.line.along, line.along)))) < PARALLEL,
    )
    st.board.step(_taken(st, held, load, by), View.MECHANISM)
    if parallel:
        st.board.remark(Words("两作用线平行，", " The two lines are parallel: "))
    else:
        st.board.remark(
            Words(
                "两作用线的交点在图纸之外，改用力矩平衡。",
                " The two lines meet off the sheet; moments take the place of their meeting point.",
            )
        )
    if isinstance(held.joint, Prismatic):
        balance_on_guide(st, held, load, line, by)
        return
    if not isinstance(held.joint, Revolute):
        raise NoMethodError(
            Words(
                f"没有求构件 {number} 反力的图解法，因为它与相邻构件作纯滚动；仍可用 vecpoly exact 求解",
                f"no graphical method on file finds the reactions of link {number}: it rolls on its neighbour; "
                "'vecpoly exact' still answers",
            )
        )
    if parallel:
        st.board.remark(Words("第三力亦与之平行。", "so is the third."))
    found = about_pin(st, held, load, line, one)
    known = st.keep_reaction(
        by, held.link, Acting(named=one, vector=line.along * st.mm(found.size), at=line.at, computed=np.abs(found.size))
    )
    if parallel:
        keep_pin(st, held, found)
    else:
        _close(st, held, replace(load, forces=(*load.forces, known)), found)


def _taken(st: Statics, held: Held, load: Resultant, by: str) -> Words:
    number, known = st.mech.number(held.link), load.told
    one, two = f"${st.named(by, held.link).symbol}$", f"${st.named(held.parent, held.link).symbol}$"
    return Words(
        f"取构件 {number} 为分离体：{known.zh}、{one}、{two} 平衡；{one} 的作用线已知。",
        f"Isolate link {number}: {known.en}, {one} and {two} balance; the line of {one} is known.",
    )


def _close(st: Statics, held: Held, load: Resultant, found: Balanced) -> None:
    """The polygon of the load and the force found by moments; its closing side is the parent's force."""
    link, named = held.link, st.named(held.parent, held.link)
    st.board.step(
        Words(
            f"按 $μ_F$ 作构件 {st.mech.number(link)} 的力多边形，由封闭边量得 ${named.symbol}$。",
            f"Draw the force polygon of link {st.mech.number(link)} to $μ_F$; its closing side "
            f"is ${named.symbol}$, which is measured.",
        ),
        pane_of(st, link),
    )
    side = closing_side(st, held.parent, link, load)
    write_sizes(st, st.settle(held.parent, link, side.end - side.start, found.touch, side, found.sense))


def about_pin(st: Statics, held: Held, load: Resultant, line: Line, named: Named) -> Balanced:
    """ΣM = 0 about the point where the parent's force touches the friction circle of its pin: F b = P a, or F b = M.

    Raises EquilibriumError where the known line passes through that
    point, LockedError where no such point is found.
    """
    assert isinstance(held.joint, Revolute)
    pin, u, number = held.joint.point, line.along, st.mech.number(held.link)
    sense = st.moment_sense(pin, held.parent, held.link)
    touch = _touching(st, held, load, line, sense)
    if abs(float(nominal(cross(line.at - touch, u)))) < NO_LENGTH:
        raise EquilibriumError(
            Words(
                f"构件 {number}：${named.symbol}$ 的作用线过 {pin}，不能平衡任何力偶；请另选输入位置",
                f"link {number}: the line of {named.key} passes through {pin}, so it "
                "balances no load; choose another input position",
            ),
            code="no-arm",
            numbers={"link": number, "pin": pin},
        )
    st.board.remark(pin_words(st, pin, held.parent, held.link, touch))
    st.board.remark(_about(st, held, pin, sense))
    size = np.sign(_needed(st, load, line, touch)) * _written(st, held.link, load, (line, touch), named)
    return Balanced(size=size, rest=-ahead(load.vector, u, st.mm(size)), touch=touch, sense=sense)


def _about(st: Statics, held: Held, pin: str, sense: int) -> Words:
    """About which point the moments are taken: there the parent's force has no arm."""
    parent = f"${st.named(held.parent, held.link).symbol}$"
    at = (
        Words(f"{parent} 与 ${pin}$ 处摩擦圆的切点", f"the point where {parent} touches the friction circle of ${pin}$")
        if sense
        else Words.same(f"${pin}$")
    )
    return Words(
        f"对{at.zh if sense else ' ' + at.zh + ' '}取矩，量取各力臂，由力矩平衡得：",
        f" Moments are taken about {at.en}, with the arms measured:",
    )


def _touching(st: Statics, held: Held, load: Resultant, line: Line, sense: int) -> Points:
    """The pin's centre, or the point of its friction circle that the parent's force touches:
    tried until force and point agree.

    Where both sides of the circle would do, the force keeps the side on which it pressed before.
    """
    assert isinstance(held.joint, Revolute)
    pin, u = held.joint.point, line.along
    centre = st.desk.at[pin]
    through = -ahead(load.vector, u, _needed(st, load, line, centre))
    if not sense or abs(complex(nominal(through))) < NOTHING * abs(float(nominal(_needed(st, load, line, centre)))):
        return centre  # without friction, or where the pin bears nothing that could touch its circle
    before = st.pushed_before(held.parent, held.link)
    first = 1 if float(nominal(dot(through if before is None else before, u))) >= 0 else -1
    for way in (first, -first):
        touch = st.touch(pin, u * way, sense)
        for _ in range(ROUNDS):
            rest = -ahead(load.vector, u, _needed(st, load, line, touch))
            before, touch = touch, st.touch(pin, unit(rest), sense)
            if abs(complex(nominal(touch - before))) < NO_LENGTH:
                return touch
    raise LockedError(
        Words(
            f"构件 {st.mech.number(held.link)}：计入 {pin} 处摩擦后无法平衡；请减小 f 或 ρ",
            f"link {st.mech.number(held.link)}: with the friction at {pin} there is no equilibrium; lower f or ρ",
        ),
        code="locked",
        numbers={"link": held.link, "pin": pin},
    )


def _needed(st: Statics, load: Resultant, line: Line, touch: Points) -> Reals:
    """The force along the line that balances the load about a point (mm on the polygon), with its sign."""
    turning = st.paper_moment(load.couple) if load.is_couple else cross(load.at - touch, load.vector)
    needed: Reals = -turning / cross(line.at - touch, line.along)
    return needed


def keep_pin(st: Statics, held: Held, found: Balanced) -> None:
    """The parent's force at the pin, parallel to the others."""
    parent = st.named(held.parent, held.link)
    st.keep_reaction(
        held.parent,
        held.link,
        Acting(
            named=parent,
            vector=found.rest,
            at=found.touch,
            tangent=found.sense,
            computed=np.abs(found.rest) * st.scale.value,
        ),
    )


def _written(st: Statics, link: str, load: Resultant, where: tuple[Line, Points], named: Named) -> Reals:
    """F = P a / b, or M / b, with the arms measured."""
    (line, touch), board = where, st.board
    b = board.mu(View.MECHANISM) * _arm(st, line, touch, arm_about_point(named.symbol))
    away = abs(nominal(cross(load.at - touch, load.vector))) > OFF_SHEET * abs(nominal(load.vector))
    if load.is_couple or away:  # far out a force is little more than a couple
        turning = load.couple if load.is_couple else st.newton_metres(cross(load.at - touch, load.vector))
        expr = magnitude("M", np.abs(turning), "N·m") / b
    else:
        force = (
            size_of(st, load.forces[0])
            if load.is_single
            else magnitude(resultant_of(st, link), np.abs(load.vector) * st.scale.value, "N")
        )
        letter = arm_about_point(load.forces[0].named.symbol if load.is_single else resultant_of(st, link))
        expr = force * (board.mu(View.MECHANISM) * _arm(st, load.line, touch, letter)) / b
    return board.compute(named.symbol, expr, "N").value


def _arm(st: Statics, line: Line, touch: Points, letter: str) -> Quantity:
    """The distance of a line from the touching point, on the diagram."""
    end = foot(line, touch)
    if 1.0 < abs(nominal(end - touch)) < OFF_SHEET:
        st.board.join(View.MECHANISM, touch, end, st.ruled(Role.CONSTRUCTION))
        st.board.plot(View.MECHANISM, (touch + end) / 2, letter, Dot.NONE)
        st.board.join(View.MECHANISM, end - line.along * 16.0, end + line.along * 16.0, st.ruled(Role.DIRECTION))
    return st.board.measure(touch, end, letter)
