"""Masses that a link without a counterweight passes on: whole by a slider, by shares to two hinges by a coupler."""

from __future__ import annotations

from collections.abc import Sequence

from ...board.construction import View
from ...foundation.slotted import replace
from ...mechanism.counterweights import Outlet, Passing
from ...mechanism.joints import FRAME
from ...names import subscripted
from ...words import Words
from ..registry import Stage, method
from .standing import Stand, Weighing

_SOURCE = "机械原理, mass balance of linkages: masses replaced at the hinges of a link (质量代换)"
_Turned = tuple[str, str]  # the symbol of a product, the letters of the angle by which it is turned
IN_LINE = 1e-9  # of the distance of the hinges: a mass so near to their line, and between them, has plain shares


@method(
    stage=Stage.BALANCE,
    group="sliding link",
    source=_SOURCE,
    example="balance-slider-crank",
    title=Words("平动构件的质量集中到铰链", "Mass of a link that only translates, at its pin"),
)
def whole(here: Weighing, of: Passing) -> None:
    """A link that never turns moves like any of its points: its mass may stand at its hinge."""
    (out,) = of.outlets
    number, point = here.desk.mech.number(of.link), subscripted(out.point)
    here.desk.board.step(
        Words(
            f"构件 {number} 只作平动，其质量可看作集中在铰链 ${point}$。",
            f"Link {number} only translates: its mass may be concentrated at the pin ${point}$.",
        ),
        View.MECHANISM,
    )
    for one in here.gather(of):
        here.put(out, one)


@method(
    stage=Stage.BALANCE,
    group="link between hinges",
    source=_SOURCE,
    example="balance-four-bar",
    title=Words("构件的质量代换到两铰链", "Mass of a link, distributed to two of its pins"),
)
def shares(here: Weighing, of: Passing) -> None:
    """m_B = m l_CS / l_BC, m_C = m l_BS / l_BC; off the line BC these products are turned, m_B by the angle BCS."""
    board, number = here.desk.board, here.desk.mech.number(of.link)
    if len(of.outlets) == 1:
        (out,) = of.outlets
        board.step(
            Words(
                f"构件 {number} 的质量就在铰链 ${out.point}$ 处。",
                f"The mass of link {number} is at its pin ${out.point}$ already.",
            ),
            View.MECHANISM,
        )
        for one in here.gather(of):
            here.put(out, one)
        return
    b, c = of.outlets
    board.step(
        Words(
            f"构件 {number} 的质量按杠杆比代换到 ${b.point}$、${c.point}$ 两点，总质量和质心不变：",
            f"The mass of link {number} is put at ${b.point}$ and ${c.point}$ by lever shares; total mass and centre "
            "stay as they are:",
        ),
        View.MECHANISM,
    )
    turned: list[_Turned] = []
    for one in here.gather(of):
        for out, other in ((b, c), (c, b)):
            if one.point == out.point:
                here.put(out, one)
            elif one.point != other.point and out.to != FRAME:
                here.put(out, _share(here, of, one, out, other, turned))
    if turned:
        board.remark(_aside(turned))


def _share(here: Weighing, of: Passing, one: Stand, out: Outlet, other: Outlet, turned: list[_Turned]) -> Stand:
    """The part of a mass that comes to one hinge, by its distance from the other; turned: with what is said of it where
    the mass lies beside their line."""
    desk, board = here.desk, here.desk.board
    at, far, near = (here.local(of.link, point) for point in (one.point, other.point, out.point))
    part = (at - far) / (near - far)
    label = f"{out.point}{desk.mech.number(of.link)}"
    arm, span = desk.length(one.point, other.point), desk.length(out.point, other.point)
    mass = board.compute(f"m_{{{label}}}", one.mass * (arm / span), "kg")
    found = replace(one, label=label, mass=mass, ideal=one.ideal * part)
    if abs(part.imag) < IN_LINE * abs(part) and part.real > 0:
        return found
    start, end, tip = (desk.at[point] for point in (other.point, out.point, one.point))
    turn = board.gauge(start, tip) - board.gauge(start, end)
    letters = "".join(subscripted(point) for point in (out.point, other.point, one.point))
    turned.append((_sym(label), letters))
    return replace(found, turn=turn if one.turn is None else one.turn + turn)


def _aside(turned: Sequence[_Turned]) -> Words:
    """By which angles the products of a mass that lies beside the line of the pins are turned: said once."""
    (first, angle), *others = turned
    zh = "".join(f"，${symbol}$ 的须转过 $∠{letters}$" for symbol, letters in others)
    en = "".join(f", that of ${symbol}$ by the angle ${letters}$" for symbol, letters in others)
    return Words(
        f"（质心不在两铰链之间的连线上：${first}$ 的质径积须自半径方向转过 $∠{angle}${zh}。）",
        f" (The mass does not lie between the pins on their line: the product of ${first}$ is to be turned from its "
        f"radius by the angle ${angle}${en}.)",
    )


def _sym(label: str) -> str:
    return f"m_{{{label}}}"
