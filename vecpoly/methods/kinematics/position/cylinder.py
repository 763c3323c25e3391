"""A driven cylinder in its given length:
its end lies on the circle of that length, and on the circle or the guide of the link that it moves."""

from __future__ import annotations

import numpy as np

from ....algebra.quantity import magnitude
from ....board.construction import View
from ....errors import AssemblyError
from ....mechanism.model import Prismatic, Revolute
from ....mechanism.rams import Ram
from ....plane import Points
from ....words import Words
from ...desk import Desk
from ...registry import Stage, method
from .assembly import choose, said
from .dyads import slider_axis

_SOURCE = "机械原理, kinematic diagrams: the length of the cylinder is the input"


@method(
    stage=Stage.POSITION,
    group="cylinder RR",
    source=_SOURCE,
    example="excavator-boom",
    title=Words("油缸（RR）的位置", "Position of a cylinder with a pinned link"),
)
def position_cylinder_rr(desk: Desk, ram: Ram) -> None:
    """Two arcs: C is where the arc of the cylinder's length about D meets the arc of link l about A."""
    assert isinstance(ram.link_joint, Revolute)
    c, a, d, board = ram.inner.point, ram.link_joint.point, ram.outer.point, desk.board
    reach, radius = _length(desk, ram), _distance(desk, ram.link, a, c)
    board.step(
        Words(
            f"以 ${d}$ 为圆心、油缸长度 $l_{d}{c}/μ_l$ 为半径画弧，以 ${a}$ 为圆心、"
            f"$l_{desk.bar(ram.link, a, c)}/μ_l$ 为半径画弧，交点为 ${c}$",
            f"The arc about ${d}$ with the length $l_{d}{c}/μ_l$ of the cylinder and the arc about "
            f"${a}$ with radius $l_{desk.bar(ram.link, a, c)}/μ_l$ meet at ${c}$",
        ),
        View.MECHANISM,
    )
    pair = board.arcs(
        desk.at[a], radius, desk.at[d], reach, f"links {ram.link} and the cylinder {ram.near}, {ram.far} at {c}"
    )
    _settle(desk, ram, pair, reach)
    board.swing(View.MECHANISM, desk.at[a], radius, desk.at[c])
    desk.settle(ram.link, (a, c))


@method(
    stage=Stage.POSITION,
    group="cylinder RP",
    source=_SOURCE,
    example="lift-gate",
    title=Words("油缸（RP）的位置", "Position of a cylinder with a sliding link"),
)
def position_cylinder_rp(desk: Desk, ram: Ram) -> None:
    """One arc and the guide: C is where the arc of the cylinder's length about D cuts the line on which C is led."""
    assert isinstance(ram.link_joint, Prismatic)
    c, d, board = ram.inner.point, ram.outer.point, desk.board
    reach = _length(desk, ram)
    board.step(
        Words(
            f"以 ${d}$ 为圆心、油缸长度 $l_{d}{c}/μ_l$ 为半径画弧，与 ${c}$ 的导路线交于 ${c}$",
            f"The arc about ${d}$ with the length $l_{d}{c}/μ_l$ of the cylinder cuts the guide line of ${c}$ at ${c}$",
        ),
        View.MECHANISM,
    )
    line = desk.locus(ram.link_joint, ram.link, c)
    pair = board.arc_on_line(line, desk.at[d], reach, f"the cylinder {ram.near}, {ram.far} at {c}")
    _settle(desk, ram, pair, reach)
    desk.settle_turned(ram.link, c, slider_axis(desk, ram.link_joint, ram.link, line))


def _length(desk: Desk, ram: Ram) -> float:
    """Distance of the cylinder's two hinges on paper (mm): the input; with hinges beside the line, its hypotenuse."""
    return desk.mm(abs(_ray(desk, ram)))


def _ray(desk: Desk, ram: Ram) -> complex:
    """From the outer hinge to the inner one in the coordinates of the guide's line (m)."""
    pair = ram.pair
    travel = next(drive.position for drive in desk.mech.drives if drive.pair == {ram.near, ram.far})
    guided, sliding = (ram.outer, ram.inner) if ram.near == pair.guide else (ram.inner, ram.outer)
    foot = (desk.mech.link(pair.guide).points[guided.point] - pair.origin) * complex(np.exp(-1j * pair.direction))
    body = desk.mech.link(pair.block).points
    head = travel + 1j * pair.offset + (body[sliding.point] - body[pair.pin]) * complex(np.exp(1j * pair.turn))
    return head - foot if ram.near == pair.guide else foot - head


def _distance(desk: Desk, link: str, p: str, q: str) -> float:
    points = desk.mech.link(link).points
    return desk.mm(abs(points[p] - points[q]))


def _settle(desk: Desk, ram: Ram, pair: tuple[Points, Points], reach: float) -> None:
    """Choose C; both links of the cylinder lie along DC, leaned where their hinges are beside the line."""
    c, d = ram.inner.point, ram.outer.point
    if reach < 1e-9:
        raise AssemblyError(
            Words(
                f"油缸 {ram.near}-{ram.far} 的长度为零，方向不定；请改变其长度",
                f"the cylinder {ram.near}-{ram.far} has no length here, and so no direction; change its length",
            ),
            code="no-length",
        )
    found, why = choose(desk, c, (ram.link, ram.near, ram.far), pair)
    desk.letter(c, found)
    desk.board.remark(said(why) + Words("。", "."))
    desk.board.swing(View.MECHANISM, desk.at[d], reach, desk.at[c])
    ray = _ray(desk, ram)
    if abs(ray.imag) < 1e-12:  # the length between the hinges is given
        desk.lengths[frozenset((c, d))] = magnitude(f"l_{d}{c}", abs(ray), "m")
    line = desk.towards(d, c) * np.conj(ray / abs(ray))
    for link, pin in ((ram.near, d), (ram.far, c)):
        desk.settle_turned(
            link, pin, line * np.exp(1j * (ram.pair.turn if link == ram.pair.block else -ram.pair.direction))
        )
