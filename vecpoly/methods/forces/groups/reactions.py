"""Reactions of a group as sides of its polygon, and where they act:
a pin's touches its friction circle, a slide's lies where moments put it."""

from __future__ import annotations

import numpy as np

from ....algebra.quantity import magnitude, number
from ....board.board import NO_LENGTH
from ....board.construction import Pane, View
from ....board.paper.marks import Dot, Role
from ....mechanism.groups.assur import Dyad
from ....mechanism.model import Prismatic
from ....plane import Points, Reals, nominal, unit
from ....words import Words
from ..acting import Acting, Drawn
from ..bodies.arrows import REACH
from ..lines.arms import Turning
from ..lines.letters import arm_about_point
from ..readings import measured
from ..senses import TURN, at_normal, inclined, pin_words, slide_words
from ..state import Statics
from .body import SHORT, draw_forces, group_pane
from .corners import Reaction

INSIDE = 14.0  # mm: drawn length of a force between the group's own links


def settle_pin(st: Statics, by: str, on: str, point: str, drawn: Drawn) -> None:
    """A pin's reaction through the centre, or touching the friction circle on the side against the relative turning."""
    vector = drawn.end - drawn.start
    if abs(nominal(vector)) < NO_LENGTH:
        st.settle(by, on, 0j, st.desk.at[point])
        return
    sense = st.moment_sense(point, by, on)
    at = st.touch(point, _along(vector), sense)
    st.board.remark(pin_words(st, point, by, on, at))
    st.settle(by, on, vector, at, drawn, sense)


def settle_slide(
    st: Statics, links: tuple[str, ...], by: str, on: str, drawn: Drawn, about: tuple[str, Turning], of: str = ""
) -> None:
    """A slide's reaction on the line where ΣM = 0 of the link it acts on puts it (or of the other link, `of`):
    h = Σ M / R from the point of moments.

    Where no force is left the slide still passes on the couple −Σ M: the line has gone to infinity.
    """
    point, turning = about
    vector, pin = drawn.end - drawn.start, st.desk.at[point]
    if no_force(st, drawn):
        couple = -turning.value if turning.way else 0.0
        _say_couple(st, by, on, couple)
        st.keep_reaction(by, on, Acting(named=st.named(by, on), vector=vector, at=pin, drawn=drawn, couple=couple))
        return
    at = pin
    if turning.way:
        at = _displaced(st, group_pane(st, *links), by, on, point, drawn, turning)
    else:
        st.board.remark(_through(st, st.named(by, on).symbol, of or on, about))
    st.settle(by, on, vector, at, drawn)
    _leave(st, links, by, on, pin, at, vector)


def _through(st: Statics, symbol: str, link: str, about: tuple[str, Turning]) -> Words:
    """Why a slide's reaction passes through the point of moments: all other forces on the link do."""
    (point, turning), j = about, st.mech.number(link)
    if turning.terms:
        why = Words(
            f"构件 {j} 的其余各力对 ${point}$ 点之矩互相抵消，故 ", f" About ${point}$ the moments on link {j} cancel:"
        )
    else:
        why = Words(
            f"构件 {j} 的其余各力都过 ${point}$ 点，故 ", f" All other forces on link {j} pass through ${point}$:"
        )
    return why + Words(f"${symbol}$ 过 ${point}$ 点。", f" the reaction ${symbol}$ passes through ${point}$ too.")


def no_force(st: Statics, drawn: Drawn) -> bool:
    """Whether a side of the polygon is too short to be read."""
    return abs(nominal(drawn.end - drawn.start)) < NO_LENGTH or not nominal(measured(st, drawn).value)


def _say_couple(st: Statics, by: str, on: str, couple: Reals) -> None:
    """The forces on both sides of the guide are equal and opposite: R = 0, at infinity, and M_R."""
    i, j, symbol = st.mech.number(by), st.mech.number(on), st.named(by, on).symbol
    size, told = float(nominal(couple)), f"${symbol}$ = " in st.board.steps[-1].words.zh
    if not size:
        if not told:
            st.board.remark(Words(f"${symbol}$ = 0。", f" Hence ${symbol}$ = 0."))
        return
    way = TURN[1 if size > 0 else -1]
    none = Words("但 ", " However,") if told else Words(f"${symbol}$ = 0，而 ", f" Here ${symbol}$ = 0, while")
    st.board.remark(
        none
        + Words(
            "$ΣM$ ≠ 0：导路两侧的压力等值、反向，合成为一力偶（作用线在无穷远处），"
            f"构件 {i} 对构件 {j} 的力偶矩为 {number(abs(size))} N·m，{way.zh}。",
            " $ΣM$ ≠ 0: the pressures on the two sides of the guide "
            "are equal and opposite and form a couple (a force of zero at infinity); link "
            f"{i} turns link {j} with {number(abs(size))} N·m, {way.en}.",
        )
    )


def lean(st: Statics, links: tuple[str, ...], joint: Prismatic, by: str, on: str) -> Reaction:
    """A slide's reaction along the normal of its guide, inclined by φ where there is friction; of all slides of a group
    that are looked at in turn that is said in one step."""
    why, pane, last = slide_words(st, joint, by, on), group_pane(st, *links), st.board.steps[-1]
    if (last.view, last.words) == (pane, st.leaning):
        st.board.remark(why)
    else:
        st.board.step(Words(why.zh, why.en.strip()), pane)
    st.leaning = st.board.steps[-1].words
    direction = at_normal(st, joint)
    return Reaction(by=by, on=on, line=inclined(st, joint, by, on), direction=direction)


def _displaced(st: Statics, pane: Pane, by: str, on: str, point: str, drawn: Drawn, turning: Turning) -> Points:
    """The point of the line nearest to the point of moments."""
    named, j = st.named(by, on), st.mech.number(on)
    force = magnitude(named.symbol, measured(st, drawn).value, "N")
    st.board.step(
        Words(
            f"由构件 {j} 的 $ΣM_{point}$ = 0 定出 ${named.symbol}$ 的作用线至 ${point}$ 的距离：",
            f"The moments $ΣM_{point}$ = 0 of link {j} give the distance of the line of ${named.symbol}$ from "
            f"${point}$:",
        ),
        pane,
    )
    arm = st.board.compute(arm_about_point(named.symbol), turning.size / force, "m")
    side = -1j * _along(drawn.end - drawn.start) * -np.sign(turning.value)
    return st.board.lay_off(st.desk.at[point], side, st.board.to_paper(View.MECHANISM, arm.value))


def draw_body(st: Statics, d: Dyad, first: Reaction, last: Reaction) -> None:
    """All forces on the group at their lines of action; what its links do to each other stays inside."""
    links = d.links
    own = {st.named(by, on).key for by, on in (links, links[::-1], (d.parent_j, d.link_j), (d.parent_k, d.link_k))}
    forces = [force for link in links for force in st.known(link) if force.named.key not in own]
    draw_forces(st, group_pane(st, *links), links, [*forces, *first.parts(st), *last.parts(st)])


def _leave(st: Statics, links: tuple[str, ...], by: str, on: str, pin: Points, at: Points, vector: Points) -> None:
    """The arm of a slide's reaction; inside the group also its line."""
    pane = group_pane(st, *links)
    away = float(abs(nominal(at - pin)))
    if away > REACH:
        st.board.remark(
            Words(f"其作用线远在 {away:.0f} mm 之外，图上不画。", f" Its line is {away:.0f} mm away and is not drawn.")
        )
        return
    if away > SHORT:
        st.board.join(pane, pin, at, Role.CONSTRUCTION)
        st.board.right_angle(pane, at, unit(pin - at), _along(vector))
        st.board.plot(pane, (pin + at) / 2, arm_about_point(st.named(by, on).symbol), Dot.NONE)
    if {by, on} <= set(links) and not {by, on} & set(st.mech.slot_pins):  # its pin's force on the group is the same
        u, named = _along(vector), st.named(by, on)
        st.board.join(pane, at - u * INSIDE, at, Role.DIRECTION)
        st.board.arrow(pane, at, at + u * INSIDE, Role.RESULT, key=named.key, label=named.symbol)
        st.board.remark(
            Words(
                f"（${named.symbol}$ 为杆组内部的反力，画在杆组图上以示其作用线。）",
                f" (The reaction ${named.symbol}$ is internal to the group; its figure shows the line of action.)",
            )
        )


def _along(vector: Points) -> Points:
    size = np.abs(vector)
    return vector / np.where(size > NO_LENGTH, size, 1.0)
