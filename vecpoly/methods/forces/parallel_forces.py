"""A link whose load is parallel to the reaction of known line: the third force is parallel too, and moments take the place of the meeting point."""

from __future__ import annotations

import numpy as np

from ...board.construction import View
from ...board.marks import Role
from ...errors import EquilibriumError, NoMethodError
from ...mechanism.model import Prismatic, Revolute
from ...plane import Line, Points, cross, nominal
from ...words import Words
from .pieces import Held
from .readings import write_sizes
from .resultant import Resultant
from .senses import pin_words
from .state import Statics

PARALLEL = 1e-6  # sine below which a load and a line of action have no usable meeting point


def balance_parallel(st: Statics, held: Held, load: Resultant, line: Line, by: str) -> None:
    """Pin: ΣM about the point where the parent's force touches the friction circle, R = P a / b. Guide: R = −P, the guide bears the couple."""
    number = st.mech.number(held.link)
    st.board.remark(Words("两作用线平行，", " The two lines are parallel: "))
    if isinstance(held.joint, Prismatic):
        st.board.remark(Words("故两力等值反向，其力偶由导路承受，导路反力之合力为零。", "the two forces are equal and opposite, the guide bears their couple, and its forces sum to zero."))
        st.settle(by, held.link, -load.vector, line.at)
        st.settle(held.parent, held.link, 0j, st.desk.at[held.joint.pin])
        return
    if not isinstance(held.joint, Revolute):
        raise NoMethodError(Words(
            f"没有求构件 {number} 反力的图解法，因为它与相邻构件作纯滚动；仍可用 vecpoly exact 求解",
            f"no graphical method on file finds the reactions of link {number}: it rolls on its neighbour; 'vecpoly exact' still answers"))
    pin = held.joint.point
    st.board.remark(Words(f"第三力亦与之平行；对 ${pin}$ 处的切点取矩：", f"so is the third; moments about the point where it touches the circle at ${pin}$ give:"))
    st.board.remark(pin_words(st, pin, held.parent, held.link))
    _about_pin(st, held, load, line, by)


def _about_pin(st: Statics, held: Held, load: Resultant, line: Line, by: str) -> None:
    assert isinstance(held.joint, Revolute)
    pin, u = held.joint.point, line.along
    sense = st.moment_sense(pin, held.parent, held.link)
    for way in (1, -1):  # the sense of the parent's force decides on which side it touches
        touch = st.touch(pin, u * way, sense)
        arm = cross(line.at - touch, u)
        if abs(float(nominal(arm))) < 1e-9:
            raise EquilibriumError(Words(
                f"构件 {st.mech.number(held.link)}：构件 {st.mech.number(by)} 的作用力过 {pin}，不能平衡载荷；请另取原动件位置",
                f"link {st.mech.number(held.link)}: the line of the force of link {st.mech.number(by)} passes through {pin}, so it balances no load; choose another input position"))
        size = -cross(load.at - touch, load.vector) / arm
        rest: Points = -(load.vector + size * u)
        if not sense or float(nominal((np.conj(u * way) * rest).real)) >= 0:
            break
    st.board.remark(Words("量取两力臂。", " The two arms are measured."))
    one = st.settle(by, held.link, size * u, line.at)
    two = st.settle(held.parent, held.link, rest, touch, None, sense)
    write_sizes(st, one, two)
    st.board.join(View.MECHANISM, line.at - u * 16.0, line.at + u * 16.0, Role.DIRECTION)
