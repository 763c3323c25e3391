"""A guide that bears a couple: its forces sum to zero."""

from __future__ import annotations

from ....board.board import NO_LENGTH
from ....board.construction import View
from ....mechanism.model import Prismatic
from ....plane import Line, Points, Reals, cross, nominal
from ....words import Words
from ..acting import Acting
from ..state import Statics
from .links_of_group import Held
from .resultant import Resultant


def balance_on_guide(st: Statics, held: Held, load: Resultant, line: Line, by: str) -> None:
    """R = −P along its own line; the guide's forces sum to zero and bear the couple of the two."""
    st.board.remark(
        Words(
            "故两力等值反向，其力偶由导路承受，导路反力之合力为零。",
            "the two forces are equal and opposite, the guide bears their couple, and its forces sum to zero.",
        )
    )
    drawn = load.forces[0].drawn.reversed() if len(load.forces) == 1 and load.forces[0].drawn else None
    st.keep_reaction(by, held.link, Acting(named=st.named(by, held.link), vector=-load.vector, at=line.at, drawn=drawn))
    paper = cross(line.at - load.at, load.vector)
    couple = st.newton_metres(paper) if abs(nominal(paper)) > NO_LENGTH * abs(nominal(load.vector)) else 0.0
    assert isinstance(held.joint, Prismatic)
    keep_couple(st, held.parent, held.link, st.desk.at[held.joint.pin], couple)


def keep_couple(st: Statics, by: str, on: str, at: Points, couple: Reals) -> None:
    """A guide's forces that sum to zero and bear a couple (N·m, on link `on`)."""
    st.keep_reaction(by, on, Acting(named=st.named(by, on), vector=0j, at=at, couple=couple))


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
            f"Isolate link {j}: only a couple acts on it. ${one}$ and ${two}$, which are not "
            f"parallel, sum to zero, so ${one}$ = ${two}$ = 0; the slide of links {i} and {j} "
            "bears the couple.",
        ),
        View.MECHANISM,
    )
    st.settle(by, held.link, 0j, line.at)
    keep_couple(st, held.parent, held.link, st.desk.at[held.joint.pin], -load.couple)
