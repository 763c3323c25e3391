"""A link with two pins and no load (二力杆): one line of action, tangent to both friction circles."""

from __future__ import annotations

from ...board.construction import View
from ...board.marks import Role
from ...mechanism.model import Revolute
from ...plane import Line, Points, dot, nominal, unit
from ...words import Words
from ..registry import Stage, method
from .pieces import TwoForce
from .senses import pin_words
from .state import Statics

_SOURCE = "机械原理, friction circle; the two-force link"


@method(stage=Stage.FORCE, group="two-force link R-R", source=_SOURCE, example="4-3a",
        title=Words("二力杆：作用线切于两摩擦圆", "Two-force link: its line touches both friction circles"))
def line_of_two_pins(st: Statics, two: TwoForce) -> Line:
    """Line of the force of the link on the loaded link, along that force.

    Without friction the line passes through both pins. With friction the reaction at each pin has a moment about it against
    the relative turning there; of the four common tangents of the friction circles this leaves one.
    """
    assert isinstance(two.inner, Revolute) and isinstance(two.outer, Revolute)
    p, q = two.inner.point, two.outer.point
    at_p, at_q = st.desk.at[p], st.desk.at[q]
    board, number = st.board, st.mech.number(two.link)
    if st.ideal is None:
        board.step(Words(f"构件 {number} 不受外力，为二力杆，两端铰链处的反力沿 ${st.desk.bar(two.link, p, q)}$。",
                         f"No load acts on link {number}: it is a two-force link, the forces at its pins act along ${st.desk.bar(two.link, p, q)}$."), View.MECHANISM)
        return Line(at_p, unit(at_p - at_q))
    on = st.ideal.acting[two.link, two.on].vector  # the force it exerts: pushing away from q where compressed
    compressed = float(nominal(dot(on, at_p - at_q))) > 0
    state, state_en = ("压", "compression") if compressed else ("拉", "tension")
    board.step(Words(f"构件 {number} 不受外力，为二力杆，由不计摩擦的分析知其受{state}。", f"No load acts on link {number}: it is a two-force link, in {state_en} as found without friction."), View.MECHANISM)
    board.remark(pin_words(st, q, two.by, two.link))
    board.remark(pin_words(st, p, two.on, two.link))
    line = board.tangent_to_both(at_p, st.rho(p), st.moment_sense(p, two.on, two.link),
                                 at_q, st.rho(q), st.moment_sense(q, two.by, two.link), 1 if compressed else -1)
    board.remark(Words("两力共线，故作用线为两摩擦圆的公切线。", " Both forces lie on one line, the common tangent of the two circles."))
    _draw(st, line, at_p, at_q)
    return Line(line.at, -line.along)


def _draw(st: Statics, line: Line, at_p: Points, at_q: Points) -> None:
    """The tangent on the diagram, a little longer than the link."""
    ends = [line.at + line.along * dot(line.along, pin - line.at) for pin in (at_p, at_q)]
    over = unit(ends[1] - ends[0]) * 12.0
    st.board.join(View.MECHANISM, ends[0] - over, ends[1] + over, Role.DIRECTION)
