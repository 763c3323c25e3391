"""A planet and its arm (行星轮与系杆): what the arm bears across itself, ΣM of the planet about one pitch point for the
teeth at the other, and the polygons of planet and arm for their bearings.

The arm, the planet's centre and both pitch points lie on one line, so whatever acts along it has no moment about either
pitch point, and it does not matter which flank of the other pair of teeth works.
"""

from __future__ import annotations

from math import degrees

import numpy as np

from ....board.construction import View
from ....board.paper.marks import Dot, Role
from ....mechanism.groups.assur import Group
from ....plane import Line, Points, foot, nominal, unit
from ....words import Words
from ...registry import Stage, method
from ..acting import Acting
from ..bodies.link_polygon import closing_side, pane_of
from ..groups.body import SHORT, draw_forces, group_pane
from ..groups.corners import Reaction, part_named
from ..groups.reactions import settle_pin
from ..groups.rrr import split
from ..lines.arms import Turning, acting_on, joined, moments_at, moments_of, without_moment
from ..lines.letters import arm_about_point
from ..lines.resultant import Resultant
from ..readings import write_sizes
from ..state import Statics
from .carried import Carried, carried_of
from .line_of_action import draw_line_of_action, flank_words
from .mesh import Mesh

HALF = 8.0  # mm of the line of R^t to either side of the planet's pin
_FLANK = "其指向由力矩确定；齿面间只能受压，由此确定工作齿面"  # of which the first step tells
_SOURCE = "机械原理, forces in epicyclic gear trains: equilibrium of arm, planet and central gears"


@method(
    stage=Stage.FORCE,
    group="gear train",
    source=_SOURCE,
    example="two-trains-one-sun",
    title=Words("行星轮与系杆的力分析", "Forces on a planet and its arm"),
)
def forces_on_planet(st: Statics, group: Group) -> None:
    """ΣM_A = 0 of the arm: R^t at the planet's pin; ΣM_K = 0 of the planet: the teeth at H; ΣF = 0 of both."""
    one = carried_of(group)
    assert one is not None
    if not any(st.loaded(link) for link in one.links):
        _unloaded(st, one)
        return
    st.by_moments.add(group.links)
    across = split(st, one.links, one.planet, one.arm, (one.pin, one.pivot))
    here, there = one.meshes
    _teeth(st, one, across, (here, there))
    _teeth(st, one, across, (there, here))
    _bearing(st, one.arm, one.planet, one.pin)
    _bearing(st, one.parent, one.arm, one.pivot)
    _draw_body(st, one)


def _unloaded(st: Statics, one: Carried) -> None:
    """No load on the planet and the arm: no force in their joints."""
    for mesh in one.meshes:
        st.settle(mesh.by, one.planet, 0j, st.desk.at[mesh.teeth.point])
    st.settle(one.arm, one.planet, 0j, st.desk.at[one.pin])
    st.settle(one.parent, one.arm, 0j, st.desk.at[one.pivot])


def _teeth(st: Statics, one: Carried, across: Reaction, pair: tuple[Mesh, Mesh]) -> None:
    """R of the first pair of teeth, from ΣM of the planet about the pitch point of the second: R = Σ M / h."""
    mesh, other = pair
    h, k = (st.desk.at[each.teeth.point] for each in pair)
    named = st.named(mesh.by, one.planet)
    before = any(_FLANK in step.words.zh for step in st.board.steps)
    st.board.step((_told_again if before else _told)(st, one, pair), group_pane(st, *one.links))
    turning = _known(st, one, across, other.teeth.point, k)
    if not turning.way:
        st.board.remark(without_moment(f"${named.symbol}$", turning))
        st.settle(mesh.by, one.planet, 0j, h)
        return
    along = st.board.turn(_pressing(st, mesh, h, -turning.way * 1j * unit(h - k)))
    if not st.preliminary:  # teeth have no friction: the line is the same in both passes
        draw_line_of_action(st, mesh, h, along, 1j * unit(h - k))
    end, symbol = foot(Line(h, along), k), arm_about_point(named.symbol, other.teeth.point)
    arm = st.board.mu(View.MECHANISM) * st.board.measure(k, end, symbol)
    size = st.board.compute(named.symbol, turning.size / arm, "N")
    _draw_arm(st, one, (k, h), end, symbol)
    st.settle(mesh.by, one.planet, along * st.mm(size.value), h, computed=size.value)


def _known(st: Statics, one: Carried, across: Reaction, letter: str, place: Points) -> Turning:
    """What turns the planet about a pitch point: its loads, and the arm's R^t; the teeth that mesh there do not."""
    pane, named = group_pane(st, *one.links), part_named(st.named(one.arm, one.planet), "t")
    assert across.across is not None
    force = [Acting(named=named, vector=-across.across, at=st.desk.at[one.pin])] if across.part else []
    for part in force:  # it is no force on the group, but its arm stands square to its line
        st.board.join(pane, part.at - part.line.along * HALF, part.at + part.line.along * HALF, Role.DIRECTION)
    own = moments_at(st, pane, (one.planet,), place, letter)
    return joined(own, moments_of(st, pane, force, place, letter))


def _pressing(st: Statics, mesh: Mesh, h: Points, way: Points) -> Points:
    """The direction of the teeth's force on the planet: at α to the tangent, the gear pressed away from its partner."""
    out = unit(st.desk.at[mesh.teeth.gear.centre] - h)
    own = 1 if mesh.teeth.gear.link == mesh.held.link else -1
    pressed: Points = way * np.cos(mesh.teeth.alpha) + own * out * np.sin(mesh.teeth.alpha)
    return pressed


def _draw_arm(st: Statics, one: Carried, where: tuple[Points, Points], end: Points, symbol: str) -> None:
    """From the point of moments to the line of action, which runs through the pitch point."""
    pane, (place, pitch) = group_pane(st, *one.links), where
    if abs(nominal(end - place)) > SHORT:
        st.board.join(pane, place, end, Role.CONSTRUCTION)
        st.board.join(pane, pitch, end, Role.DIRECTION)
        st.board.right_angle(pane, end, unit(place - end), 1j * unit(end - place))
        st.board.plot(pane, (place + end) / 2, symbol, Dot.NONE)


def _told(st: Statics, one: Carried, pair: tuple[Mesh, Mesh]) -> Words:
    """Which line the teeth press along, and about which point nothing else of them turns the planet."""
    mesh, other = pair
    i, number = st.mech.number(mesh.by), st.mech.number(one.planet)
    h, k, bar = mesh.teeth.point, other.teeth.point, st.desk.bar(one.arm, one.pivot, one.pin)
    symbol, rest = (st.named(each.by, one.planet).symbol for each in pair)
    held, alpha = st.named(one.arm, one.planet).symbol, f"{degrees(mesh.teeth.alpha):g}°"
    angle = flank_words(st)
    return Words(
        f"构件 {i}、{number} 的轮齿在节点 ${h}$ 啮合，不计齿面摩擦，${symbol}$ 沿啮合线，与节圆公切线成"
        f"{angle.zh} = {alpha}；${rest}$ 过节点 ${k}$，${held}$ 沿 ${bar}$ 的分力也过 ${k}$，故由构件 {number} 的 "
        f"$ΣM_{k}$ = 0 求 ${symbol}$（{_FLANK}）：",
        f"The teeth of links {i} and {number} mesh at the pitch point ${h}$; without friction on the flanks "
        f"${symbol}$ acts along the line of action, at the {angle.en} = {alpha} to the common tangent. The "
        f"reaction ${rest}$ passes through ${k}$, and so does the part of ${held}$ along ${bar}$: $ΣM_{k}$ = 0 of "
        f"link {number} gives ${symbol}$ and its sense; teeth can only press, which determines the flank:",
    )


def _told_again(st: Statics, one: Carried, pair: tuple[Mesh, Mesh]) -> Words:
    """The same of other teeth, whose line of action and flank are found likewise."""
    k, number = pair[1].teeth.point, st.mech.number(one.planet)
    symbol = st.named(pair[0].by, one.planet).symbol
    return Words(
        f"同样，${symbol}$ 沿节点 ${pair[0].teeth.point}$ 处的啮合线，由构件 {number} 的 $ΣM_{k}$ = 0 求 ${symbol}$：",
        f"Likewise ${symbol}$ acts along the line of action at ${pair[0].teeth.point}$; $ΣM_{k}$ = 0 of link "
        f"{number} gives ${symbol}$:",
    )


def _bearing(st: Statics, by: str, on: str, pin: str) -> None:
    """The force of a pin on a link of which all else is known: the closing side of its polygon."""
    named, number = st.named(by, on), st.mech.number(on)
    st.board.step(
        Words(
            f"列构件 {number} 的力平衡方程，作其力多边形，封闭边即 ${named.symbol}$。",
            f"Write the equilibrium of link {number} and draw its polygon: the closing side is ${named.symbol}$.",
        ),
        pane_of(st, on),
    )
    rest = Resultant(forces=tuple(acting_on(st, on)), vector=0j, at=0j)
    drawn = closing_side(st, by, on, rest)
    settle_pin(st, by, on, pin, drawn)
    write_sizes(st, *([found] if (found := st.push(by, on)) is not None else []))


def _draw_body(st: Statics, one: Carried) -> None:
    """All forces on planet and arm at their lines of action; what they do to each other stays inside."""
    own = {st.named(by, on).key for by, on in (one.links, one.links[::-1])}
    forces = [force for link in one.links for force in st.known(link) if force.named.key not in own]
    draw_forces(st, group_pane(st, *one.links), one.links, forces)
