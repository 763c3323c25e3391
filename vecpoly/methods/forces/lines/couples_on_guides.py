"""A guide that bears a couple: its forces sum to zero."""

from __future__ import annotations

from ....board.board import NO_LENGTH
from ....board.construction import View
from ....mechanism.model import Prismatic
from ....plane import Line, Points, Reals, cross, nominal
from ....words import Words
from ..acting import Acting
from ..bodies.link_polygon import unread
from ..senses import inclined
from ..state import Statics
from .links_of_group import Held
from .resultant import Resultant


def balance_on_guide(st: Statics, held: Held, load: Resultant, line: Line, by: str) -> None:
    """R = −P along its own line; the guide's forces sum to zero and bear the couple of the two."""
    assert isinstance(held.joint, Prismatic)
    st.board.remark(
        Words(
            "故两力等值反向，其力偶由导路承受，导路反力之合力为零。",
            "the two forces are equal and opposite, the guide bears their couple, and its forces sum to zero.",
        )
    )
    one, two = _shares(st, held, load, line)
    drawn = load.forces[0].drawn.reversed() if len(load.forces) == 1 and load.forces[0].drawn else None
    found = Acting(named=st.named(by, held.link), vector=one, at=line.at, drawn=drawn, computed=unread(st, load))
    st.keep_reaction(by, held.link, found)
    pin = st.desk.at[held.joint.pin]
    paper = cross(line.at - load.at, load.vector) + cross(line.at - pin, -load.vector - one)
    couple = st.newton_metres(paper) if abs(nominal(paper)) > NO_LENGTH * abs(nominal(load.vector)) else 0.0
    keep_couple(st, held.parent, held.link, pin, couple, two)


def _shares(st: Statics, held: Held, load: Resultant, line: Line) -> tuple[Points, Points]:
    """−P as the force along the known line and what is left for the guide: nothing where the two lines are parallel;
    a little while a balancing load is on trial, which that little moves to the place where they are."""
    assert isinstance(held.joint, Prismatic)
    beside = cross(load.vector, line.along)
    if abs(float(nominal(beside))) <= NO_LENGTH:
        return -load.vector, 0j
    u = inclined(st, held.joint, held.parent, held.link)
    i, j = st.mech.number(held.parent), st.mech.number(held.link)
    what = Words(f"构件 {i} 与 {j} 间导路的法线", f"the normal of the guide of links {i} and {j}")
    one = st.board.meet(Line(0j, line.along), Line(-load.vector, u), what)
    return one, -load.vector - one


def keep_couple(st: Statics, by: str, on: str, at: Points, couple: Reals, left: Points = 0j) -> None:
    """A guide's forces that sum to zero, or all but (`left`), and bear a couple (N·m, on link `on`)."""
    st.keep_reaction(by, on, Acting(named=st.named(by, on), vector=left, at=at, couple=couple))


def couple_on_guide(st: Statics, held: Held, load: Resultant, line: Line, by: str) -> None:
    """A couple on a link that slides on its parent:
    two forces in lines that are not parallel cannot sum to zero, so the guide bears it alone."""
    assert isinstance(held.joint, Prismatic)
    i, j = st.mech.number(held.parent), st.mech.number(held.link)
    one, two = st.named(by, held.link).symbol, st.named(held.parent, held.link).symbol
    st.board.step(
        Words(
            f"取构件 {j} 为分离体：其上只有力偶，而 ${one}$ 与 ${two}$ 的方向不平行，两者之和为零，"
            f"故 ${one}$ = ${two}$ = 0；力偶由构件 {i} 与 {j} 间的移动副承受。",
            f"Isolate link {j}: only a couple acts on it. The reactions ${one}$ and ${two}$, which are not "
            f"parallel, sum to zero, so ${one}$ = ${two}$ = 0; the slide of links {i} and {j} "
            "bears the couple.",
        ),
        View.MECHANISM,
    )
    st.settle(by, held.link, 0j, line.at)
    keep_couple(st, held.parent, held.link, st.desk.at[held.joint.pin], -load.couple)
