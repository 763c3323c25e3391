"""How an eccentric clamp is drawn: pin, disc, handle and work to scale, and the disc apart with its three forces."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ....board.board import NO_LENGTH
from ....board.construction import Pane, View
from ....board.paper.marks import (
    Arc,
    Disc,
    Dot,
    FrictionCircle,
    Ground,
    LinkNumber,
    Note,
    Outline,
    Point,
    Role,
    Segment,
    TurnArrow,
    Vector,
)
from ....devices.eccentric_clamp import FORCE, R21, R31, EccentricClamp
from ....plane import Points, Reals, nominal
from ....words import Words
from ..bench import Bench
from ..inclined import ARROW, Press, press

SMALL = 1.0  # mm: a friction circle smaller than this is drawn larger than true
FAR = 110.0  # mm on paper: a meeting point further than this from A is off the sheet


@dataclass(slots=True, kw_only=True)
class Clamp:
    """Where things stand on paper, A being the origin."""

    o: Points
    k: Points
    h: Points
    rho: Reals
    mm_r: Reals
    pull: complex
    phi: float


def sketch(bench: Bench, device: EccentricClamp) -> Clamp:
    """The clamp to scale: pin, disc, handle, work."""
    board, place = (
        bench.board,
        bench.board.open_pane(View.MECHANISM, "clamp", Words("偏心夹紧机构简图", "The eccentric clamp")),
    )
    board.section(Words("机构简图", "Sketch"))
    board.step(
        Words(
            "按 $μ_l$ 作机构简图：圆盘 1 绕机架 3 上的销轴 $A$ 转动，在 $K$ 点压紧工件 2；作 $A$ 处的摩擦圆。",
            "Draw to the scale $μ_l$: disc 1 turns about the pin $A$ of the frame 3 and presses "
            "on the work 2 at $K$; the friction circle at $A$.",
        ),
        place,
    )
    e, lever, mm_r, rho = (
        board.to_paper(place, metres) for metres in (device.e.si, device.lever.si, device.R.si, device.radius)
    )
    o, h = board.lay_off(0j, np.exp(1j * device.theta.si), e), board.lay_off(0j, np.exp(1j * device.handle.si), lever)
    clamp = Clamp(
        o=o, k=board.lay_off(o, -1j, mm_r), h=h, rho=rho, mm_r=mm_r, pull=complex(np.exp(1j * device.F.si)), phi=0.0
    )
    draw_disc(bench, place, clamp)
    handle(bench, place, clamp, "F")
    k, wide = complex(nominal(clamp.k)), 0.9 * float(nominal(mm_r))
    board.mark(
        place,
        Outline(points=(k - wide, k + wide, k + wide - 12j, k - wide - 12j), fixed=True),
        Ground(at=0j, down=-1j),
        LinkNumber(a=0.5 * complex(nominal(h)), b=0.7 * complex(nominal(h)), number="1"),
        LinkNumber(a=k + wide - 6j, b=k + wide - 6j, number="2"),
        LinkNumber(a=12 - 6j, b=12 - 6j, number="3"),
        TurnArrow(at=0j, radius=0.7 * wide, start=-0.4, ccw=device.turn > 0, label=""),
    )
    return clamp


def draw_disc(bench: Bench, place: Pane, clamp: Clamp) -> None:
    """The disc with its centre, its pin and the friction circle (larger than true where it would not be seen),
    and the point of contact."""
    o, k, rho = complex(nominal(clamp.o)), complex(nominal(clamp.k)), float(nominal(clamp.rho))
    bench.board.mark(
        place,
        Disc(centre=o, radius=float(nominal(clamp.mm_r))),
        Point(at=0j, label="A", dot=Dot.JOINT),
        Point(at=o, label="O", dot=Dot.POINT),
        Point(at=k, label="K", dot=Dot.POINT),
        Segment(a=0j, b=o, role=Role.CONSTRUCTION),
    )
    if rho:
        times = seen(clamp)
        bench.board.mark(place, FrictionCircle(centre=0j, radius=rho * times, enlarged=times))


def seen(clamp: Clamp) -> float:
    """How many times larger than true the friction circle is drawn: 1 where it is large enough to be seen."""
    rho = float(nominal(clamp.rho))
    return 1.0 if rho >= SMALL or not rho else float(np.ceil(1.5 * SMALL / rho))


def handle(bench: Bench, place: Pane, clamp: Clamp, symbol: str) -> None:
    h = complex(nominal(clamp.h))
    bench.board.mark(
        place, Segment(a=0j, b=h, role=Role.LINK), Vector(a=h, b=h + ARROW * clamp.pull, role=Role.GIVEN, label=symbol)
    )


def free_body(bench: Bench, place: Pane, clamp: Clamp, meet: Points, up: Points, u31: Points, touch: Points) -> None:
    """The disc apart with its three forces; their lines carried on towards the point where they meet."""
    draw_disc(bench, place, clamp)
    handle(bench, place, clamp, FORCE.symbol)
    press(bench, place, Press(symbol=R21.symbol, at=clamp.k, normal=1j, along=up))
    x, u, foot31 = (complex(nominal(z)) for z in (meet, u31, touch))
    foot31 *= seen(clamp)
    h, k = complex(nominal(clamp.h)), complex(nominal(clamp.k))
    bench.board.mark(place, Vector(a=foot31 - 1.6 * ARROW * u, b=foot31, role=Role.RESULT, label=R31.symbol))
    near = abs(x) < FAR
    way = x / abs(x)
    top = max((z * way.conjugate()).real for z in (h, k, foot31)) + 1.5 * ARROW
    for start in (k, h, foot31):
        towards = (x - start) / abs(x - start)
        length = (
            abs(x - start)
            if near
            else max(ARROW, (top - (start * way.conjugate()).real) / (towards * way.conjugate()).real)
        )
        bench.board.mark(place, Segment(a=start, b=start + towards * length, role=Role.HIDDEN))
        if not near and start == foot31:
            bench.board.mark(
                place,
                Note(
                    at=start + towards * length,
                    words=Words("三线交于图外的 $X$", "the three lines meet in $X$,\noff the sheet"),
                ),
            )
    if near:
        bench.board.mark(place, Point(at=x, label="X", dot=Dot.POINT))


def draw_released(bench: Bench, place: Pane, clamp: Clamp, back: Points, near: Points) -> None:
    """About the pin, larger: the line of R'_21, its arm, the friction circle;
    of the disc the arc that presses on the work."""
    o, k, c, u = (complex(nominal(z)) for z in (clamp.o, clamp.k, near, back))
    rho, radius = float(nominal(clamp.rho)), float(nominal(clamp.mm_r))
    board, beside = bench.board, 1.2 * (c / abs(c) if abs(c) > NO_LENGTH else 1 + 0j)  # A and C may lie close together
    board.mark(
        place,
        Arc(centre=o, radius=radius, start=-np.pi / 2 - 0.45, sweep=0.9, role=Role.LINK),
        Point(at=0j, label="", dot=Dot.POINT),
        Point(at=-beside, label="A", dot=Dot.NONE),
        Point(at=o, label="O", dot=Dot.POINT),
        Point(at=k, label="K", dot=Dot.POINT),
        Segment(a=0j, b=o, role=Role.CONSTRUCTION),
    )
    if rho:
        board.mark(place, FrictionCircle(centre=0j, radius=rho))
    press(bench, place, Press(symbol="R′_{21}", at=k, normal=1j, along=u))
    board.mark(
        place,
        Segment(a=k, b=c + 2.2 * rho * u + 8 * u, role=Role.CONSTRUCTION),
        Segment(a=0j, b=c, role=Role.CONSTRUCTION),
        Point(at=c, label="", dot=Dot.POINT),
        Point(at=c + beside, label="C", dot=Dot.NONE),
    )
