"""Groups of two links with rolling gears located: the hinge lies on what the gear leaves it, a circle about the other
gear's centre or a parallel to the rack."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from ....board.construction import View
from ....errors import NoMethodError
from ....foundation.slotted import dataclass
from ....mechanism.gearing import reach
from ....mechanism.groups.assur import Dyad
from ....mechanism.model import FRAME, Circle, Joint, Prismatic, Rack, Revolute, Rolling, Side
from ....plane import Line, Points, Reals, unit
from ....words import Words, begun
from ...desk import Desk
from ...registry import Stage, method
from ..gears.pitch import letter_pitch_points, wheel
from .assembly import choose, said
from .standing import said_standing, standing, start_of, told_in

_SOURCE = "机械原理, kinematic diagrams by Assur groups"


@dataclass(frozen=True, slots=True)
class Round:
    """The hinge lies on a circle (mm on paper)."""

    about: Points
    radius: Reals


Locus = Round | Line


@method(
    stage=Stage.POSITION,
    group="RRG",
    source=_SOURCE,
    example="3-13",
    title=Words("齿轮（纯滚动）杆组的位置", "Position of a group with a rolling gear"),
)
def position_rrg(desk: Desk, d: Dyad) -> None:
    """The gear's centre keeps its distance from the rack or from the other gear's centre,
    the hinge that from the link's other hinge."""
    _located(desk, d)


@method(
    stage=Stage.POSITION,
    group="PRG",
    source=_SOURCE,
    example="",
    title=Words("滑块—齿轮杆组的位置", "Position of a group of a slider and a rolling gear"),
)
def position_prg(desk: Desk, d: Dyad) -> None:
    """The hinge lies on its guide line and at its distance from what the gear rolls on."""
    _located(desk, d)


@method(
    stage=Stage.POSITION,
    group="GRG",
    source=_SOURCE,
    example="",
    title=Words("双滚动齿轮杆组的位置", "Position of a group of two rolling gears"),
)
def position_grg(desk: Desk, d: Dyad) -> None:
    """The hinge keeps its distances from what both gears roll on."""
    _located(desk, d)


def _located(desk: Desk, d: Dyad) -> None:
    assert isinstance(d.inner, Revolute)
    c, board = d.inner.point, desk.board
    sides = ((d.outer_j, d.link_j, d.parent_j), (d.outer_k, d.link_k, d.parent_k))
    board.step(meeting([led(desk, joint, link, c) for joint, link, _ in sides], c), View.MECHANISM)
    one, two = (locus_of(desk, joint, link, c) for joint, link, _ in sides)
    if isinstance(one, Line) and isinstance(two, Line):
        desk.letter(c, board.meet(one, two, _at(d, c)))
        board.remark(Words("。", "."))
    else:
        found, why = choose(desk, c, (d.link_j, d.link_k), crossings(desk, one, two, _at(d, c)))
        desk.letter(c, found)
        board.remark(said(why) + Words("。", "."))
    for locus in (one, two):
        if isinstance(locus, Round):
            board.swing(View.MECHANISM, locus.about, locus.radius, desk.at[c])
    for (joint, link, _), locus in zip(sides, (one, two), strict=True):
        settle_on(desk, joint, link, c, locus)
    letter_pitch_points(desk, (d.outer_j, d.outer_k))


def _at(d: Dyad, c: str) -> Words:
    return Words(f"构件 {d.link_j}、{d.link_k} 在 {c} 处", f"links {d.link_j} and {d.link_k} at {c}")


def crossings(desk: Desk, one: Locus, two: Locus, what: Words) -> tuple[Points, Points]:
    match one, two:
        case Round() as a, Round() as b:
            return desk.board.arcs(a.about, a.radius, b.about, b.radius, what)
        case (Round() as a, Line() as g) | (Line() as g, Round() as a):
            return desk.board.arc_on_line(g, a.about, a.radius, what)
    raise AssertionError


def locus_of(desk: Desk, joint: Joint, link: str, c: str) -> Locus:
    """Where the outer joint leaves the hinge to lie."""
    match joint:
        case Revolute():
            points = desk.mech.link(link).points
            return Round(desk.at[joint.point], desk.mm(abs(points[c] - points[joint.point])))
        case Prismatic():
            return desk.locus(joint, link, c)
        case Rolling():
            return _rolled(desk, joint, link, c)


def _rolled(desk: Desk, joint: Rolling, link: str, c: str) -> Locus:
    """The path that contact leaves the gear's centre, shifted to the hinge;
    turned with the line of centres where the gear's angle counts from it."""
    mine = wheel(joint, link)
    if not isinstance(mine, Circle):
        raise NoMethodError(
            Words(
                f"铰链 {c} 在齿条 {link} 上，而该齿条没有导路：没有相应的图解法",
                f"the hinge {c} is on rack {link}, which has no guide: no graphical method on file locates it",
            )
        )
    points = desk.mech.link(link).points
    arm = desk.mm(1.0) * (points[c] - points[mine.centre])
    turned = _with_centres(desk, joint, link, c)
    shift = 0j if turned or arm == 0 else standing(desk, link) * arm
    if isinstance(joint.on, Rack):
        along = desk.axis(joint.on.link) * np.exp(1j * joint.on.direction)
        left = 1 if joint.side is Side.LEFT else -1
        return Line(
            desk.place(joint.on.link, joint.on.origin) + 1j * left * along * desk.mm(mine.radius) + shift, along
        )
    other = joint.on if joint.gear.link == link else joint.gear
    return Round(desk.at[other.centre] + shift, np.abs(_out(desk, joint, link, c)) if turned else desk.mm(reach(joint)))


def _with_centres(desk: Desk, joint: Rolling, link: str, c: str) -> bool:
    """Whether the hinge is off the gear's centre and the gear's angle counts from the line of centres."""
    start, mine = start_of(desk, link), wheel(joint, link)
    other = joint.on if joint.gear.link == link else joint.gear
    return (
        isinstance(mine, Circle)
        and isinstance(other, Circle)
        and mine.centre != c
        and start is not None
        and set(start.ray) == {mine.centre, other.centre}
    )


def _out(desk: Desk, joint: Rolling, link: str, c: str) -> Points:
    """The hinge from the other gear's centre, in coordinates along the line of centres (mm)."""
    start, mine = start_of(desk, link), wheel(joint, link)
    assert start is not None and isinstance(mine, Circle)
    points, sign = desk.mech.link(link).points, 1 if start.ray[1] == mine.centre else -1
    out = sign * np.exp(1j * told_in(desk, start)) * (points[c] - points[mine.centre])
    found: Points = desk.mm(1.0) * (reach(joint) + out)
    return found


def settle_on(desk: Desk, joint: Joint, link: str, c: str, locus: Locus) -> None:
    """The link's pose, once its hinge is found."""
    match joint:
        case Revolute():
            desk.settle(link, (joint.point, c))
        case Prismatic():
            assert isinstance(locus, Line)
            desk.settle_turned(
                link, c, locus.along * np.exp(1j * (joint.turn if link == joint.block else -joint.direction))
            )
        case Rolling():
            if _with_centres(desk, joint, link, c):
                start, mine = start_of(desk, link), wheel(joint, link)
                assert start is not None and isinstance(mine, Circle) and isinstance(locus, Round)
                way = unit((desk.at[c] - locus.about) / _out(desk, joint, link, c)) * (
                    1 if start.ray[1] == mine.centre else -1
                )
                desk.settle_turned(link, c, way * np.exp(1j * told_in(desk, start)))
            else:
                desk.settle_turned(link, c, standing(desk, link))
            desk.board.remark(said_standing(desk, link))


def meeting(told: Sequence[Words], c: str) -> Words:
    """That the lines by which a point is led meet there."""
    return begun(
        Words(
            "；".join(one.zh for one in told) + f"；两者交于 ${c}$",
            "; ".join(one.en for one in told) + f"; they meet at ${c}$",
        )
    )


def led(desk: Desk, joint: Joint, link: str, c: str) -> Words:
    """What leads the hinge."""
    match joint:
        case Revolute():
            bar = desk.bar(link, joint.point, c)
            return Words(
                f"以 ${joint.point}$ 为圆心、$l_{{{bar}}}/μ_l$ 为半径画弧",
                f"swing the arc about ${joint.point}$ with radius $l_{{{bar}}}/μ_l$",
            )
        case Prismatic():
            return Words(f"画 ${c}$ 的导路线", f"draw the guide line of ${c}$")
        case Rolling():
            mine = wheel(joint, link)
            centre = mine.centre if isinstance(mine, Circle) else ""
            if isinstance(joint.on, Rack):
                return Words(
                    f"齿轮 {link} 在齿条上纯滚动，轮心 ${centre}$ 在距节线 $r_{link}/μ_l$ 的平行线上",
                    f"gear {link} rolls on the rack: its centre ${centre}$ keeps to the parallel at $r_{link}/μ_l$",
                )
            other = joint.on if joint.gear.link == link else joint.gear
            size = f"{_centre_distance(joint)}{1e3 * reach(joint):.6g} mm"
            return Words(
                f"齿轮 {link} 保持啮合，轮心 ${centre}$ 与 ${other.centre}$ 的中心距为 {size}，"
                f"以 ${other.centre}$ 为圆心画弧",
                f"gear {link} stays in mesh: the centres are {size} apart: swing that arc about ${other.centre}$",
            )


def _centre_distance(joint: Rolling) -> str:
    """$r_3$ + $r_4$ = of two gears outside each other; of others the number alone tells it."""
    if not isinstance(joint.on, Circle) or joint.internal or FRAME in (joint.gear.link, joint.on.link):
        return ""
    return f"$r_{joint.on.link}{joint.on.mark}$ + $r_{joint.gear.link}{joint.gear.mark}$ = "
