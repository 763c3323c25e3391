"""Reactions of a class III group by special points (特殊点法):
where the axes of two legs meet, ΣM leaves the third alone.

R^t of each leg from its own moments; ΣM_S = 0 of the group about the special point S of two legs gives what the third
presses along its axis; the force polygon of the group gives the other two.
"""

from __future__ import annotations

import numpy as np

from ....algebra.quantity import Quantity
from ....board.construction import View
from ....board.paper.marks import Dot, Role
from ....mechanism.groups.assur import Group, ends
from ....mechanism.model import Prismatic
from ....names import Named
from ....plane import Line, Points, cross, foot, nominal
from ....words import Words
from ...kinematics.class_iii.special import special_of
from ...kinematics.class_iii.star import star_of
from ...registry import Stage, method
from ..bodies.arrows import REACH
from ..groups.body import draw_arm, group_pane
from ..groups.corners import part_named
from ..lines.arms import Turning, joined, moments_at, without_moment
from ..lines.letters import arm_about_point
from ..state import Statics
from .chain import draw_chain
from .legs import Pressed, known_moment, pressed
from .settling_legs import draw_group_body, name_legs, settle_leg
from .two_slides import forces_two_slides

_SOURCE = "机械原理, class III groups by special points (Assur points): forces"


@method(
    stage=Stage.FORCE,
    group="class III",
    source=_SOURCE,
    example="plate-on-crank",
    title=Words("Ⅲ级杆组的力分析（特殊点法）", "Forces in a class III group, by a special point"),
)
def forces_class_iii(st: Statics, group: Group) -> None:
    """ΣM_S = 0 gives the third leg's reaction, ΣF = 0 of the group those of the two whose axes meet in S."""
    star = star_of(group)
    if not any(st.loaded(link) for link in group.links):
        _unloaded(st, group)
        return
    st.by_moments.add(group.links)
    if star.parallel is not None:
        forces_two_slides(st, group, star, star.parallel)
        return
    links = group.links
    special = special_of(st.desk, star)
    one, two, third = (pressed(st, star, leg, links) for leg in (*special.pair, special.third))
    legs = (one, two, third)
    about = (special.at.point, _meeting(st, legs, special.at.point, links))
    parts = (moments_at(st, group_pane(st, *links), (star.plate,), about[1], about[0]),)
    turning = joined(*parts, *(known_moment(st, leg, about, links) for leg in legs))
    known = _along_axis(st, third, about, turning, links)
    sides = draw_chain(st, links, star.plate, legs, known)
    name_legs(st, star, legs, sides)
    for leg, found in zip(legs, sides, strict=True):
        settle_leg(st, star, leg, found, links)
    draw_group_body(st, star, legs, links)


def _meeting(st: Statics, legs: tuple[Pressed, Pressed, Pressed], letter: str, links: tuple[str, ...]) -> Points:
    """The special point, on the free body of the group: where the lines of two reactions meet."""
    board, pane, pair = st.board, group_pane(st, *links), legs[:2]
    one, two = (st.mech.number(leg.leg.link) for leg in pair)
    first, second, third = (f"${_sought(st, leg).symbol}$" for leg in legs)
    board.step(
        Words(
            f"构件 {one} 的 {first} 与构件 {two} 的 {second} 的作用线交于特殊点 ${letter}$；对 ${letter}$ 取矩时二者"
            f"不出现，由整个杆组的 $ΣM_{letter}$ = 0 可求 {third}。",
            f"The lines of {first} of link {one} and {second} of link {two} meet at the special point ${letter}$; "
            f"about ${letter}$ neither has a moment, so $ΣM_{letter}$ = 0 of the whole group gives {third}.",
        ),
        pane,
    )
    lines = [board.parallel(leg.line.at, leg.line.along) for leg in pair]
    what = Words(f"构件 {one}、{two} 的反力线", f"the lines of what links {one} and {two} bear")
    found = board.meet(lines[0], lines[1], what)
    here = complex(nominal(found))
    for leg in pair:
        if abs(here - complex(nominal(st.desk.at[leg.inner]))) < REACH:
            board.join(pane, st.desk.at[leg.inner], here, Role.DIRECTION)
            board.plot(pane, here, letter, Dot.POINT)
    return found


def _sought(st: Statics, leg: Pressed) -> Named:
    """What a leg still has to bear, along its axis."""
    return part_named(st.named(leg.reaction.by, leg.reaction.on), leg.reaction.part)


def _along_axis(
    st: Statics, leg: Pressed, about: tuple[str, Points], turning: Turning, links: tuple[str, ...]
) -> tuple[Points, Quantity | None]:
    """R = Σ M / h along the leg's axis: mm on the polygon, and its size (N) where it is not zero."""
    letter, place = about
    named = _sought(st, leg)
    if not turning.way:
        known = without_moment(f"${named.symbol}$", turning)
        st.board.remark(Words(known.zh, f" Here{known.en}"))
        return 0j, None
    end = foot(leg.line, place)
    symbol = arm_about_point(named.symbol, letter)
    arm = st.board.mu(View.MECHANISM) * st.board.measure(place, end, symbol)
    axis = Line(st.desk.at[leg.inner], leg.line.along)
    draw_arm(st, group_pane(st, *links), place, end, axis, symbol)
    size = st.board.compute(named.symbol, turning.size / arm, "N")
    sense = np.sign(cross(end - place, leg.line.along)) * np.sign(turning.value)
    return -leg.line.along * sense * st.mm(size.value), size


def _unloaded(st: Statics, group: Group) -> None:
    """No load on the whole group: no force in its joints."""
    for joint in (*group.inner, *(out.joint for out in group.outer)):
        st.settle(*ends(joint), 0j, st.desk.at[joint.pin if isinstance(joint, Prismatic) else joint.point])
