"""How an eccentric clamp is drawn: pin, disc, handle and work to scale, and the disc apart with its three forces."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ....board.board import NO_LENGTH
from ....board.construction import Pane, View
from ....board.paper.marks import Dot, Role
from ....devices.eccentric_clamp import FORCE, R21, R31, EccentricClamp
from ....diagram.single import disc, friction_circle, number, outline, pivot, rim, rod
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
            "on workpiece 2 at $K$; the friction circle at $A$.",
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
    work = outline("link 2", k - wide, k + wide, k + wide - 12j, k - wide - 12j, fixed=True)
    numbers = (number("1", 0.5 * h, 0.7 * h), number("2", k + wide - 6j), number("3", 12 - 6j))
    board.depict(place, work, pivot(0j), *numbers)
    board.curved_arrow(place, 0j, 0.7 * wide, -0.4, device.turn > 0, "")
    return clamp


def draw_disc(bench: Bench, place: Pane, clamp: Clamp) -> None:
    """The disc with its centre, its pin and the friction circle (larger than true where it would not be seen),
    and the point of contact."""
    board = bench.board
    board.depict(place, disc("link 1", clamp.o, clamp.mm_r))
    board.plot(place, 0j, "A", Dot.JOINT)
    board.plot(place, clamp.o, "O")
    board.plot(place, clamp.k, "K")
    board.join(place, 0j, clamp.o, Role.CONSTRUCTION)
    if nominal(clamp.rho):
        board.depict(place, friction_circle("A", 0j, clamp.rho, seen(clamp)))


def seen(clamp: Clamp) -> float:
    """How many times larger than true the friction circle is drawn: 1 where it is large enough to be seen."""
    rho = float(nominal(clamp.rho))
    return 1.0 if rho >= SMALL or not rho else float(np.ceil(1.5 * SMALL / rho))


def handle(bench: Bench, place: Pane, clamp: Clamp, symbol: str) -> None:
    """The handle, which is one link with the disc, and the force on it."""
    bench.board.depict(place, rod("link 1", 0j, clamp.h))
    bench.board.arrow(place, clamp.h, clamp.h + ARROW * clamp.pull, Role.GIVEN, label=symbol)


def free_body(bench: Bench, place: Pane, clamp: Clamp, meet: Points, up: Points, u31: Points, touch: Points) -> None:
    """The disc apart with its three forces; their lines carried on towards the point where they meet."""
    draw_disc(bench, place, clamp)
    handle(bench, place, clamp, FORCE.symbol)
    press(bench, place, Press(symbol=R21.symbol, at=clamp.k, normal=1j, along=up))
    x, u, foot31 = (complex(nominal(z)) for z in (meet, u31, touch))
    foot31 *= seen(clamp)
    h, k = complex(nominal(clamp.h)), complex(nominal(clamp.k))
    board = bench.board
    board.arrow(place, foot31 - 1.6 * ARROW * u, foot31, Role.RESULT, label=R31.symbol)
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
        board.join(place, start, start + towards * length, Role.HIDDEN)
        if not near and start == foot31:
            told = Words("三线交于图外的 $X$", "the three lines meet in $X$,\noff the sheet")
            board.note(place, start + towards * length, told)
    if near:
        board.plot(place, x, "X")


def draw_released(bench: Bench, place: Pane, clamp: Clamp, back: Points, near: Points) -> None:
    """About the pin, larger: the line of R'_21, its arm, the friction circle;
    of the disc the arc that presses on the work."""
    o, k, c, u = (complex(nominal(z)) for z in (clamp.o, clamp.k, near, back))
    rho, radius = float(nominal(clamp.rho)), float(nominal(clamp.mm_r))
    board, beside = bench.board, 1.2 * (c / abs(c) if abs(c) > NO_LENGTH else 1 + 0j)  # A and C may lie close together
    board.depict(place, rim("link 1", o, radius, -np.pi / 2, 0.45))
    board.plot(place, 0j, "")
    board.plot(place, -beside, "A", Dot.NONE)
    board.plot(place, o, "O")
    board.plot(place, k, "K")
    board.join(place, 0j, o, Role.CONSTRUCTION)
    if rho:
        board.depict(place, friction_circle("A", 0j, rho))
    press(bench, place, Press(symbol="R′_{21}", at=k, normal=1j, along=u))
    board.join(place, k, c + 2.2 * rho * u + 8 * u, Role.CONSTRUCTION)
    board.join(place, 0j, c, Role.CONSTRUCTION)
    board.plot(place, c, "")
    board.plot(place, c + beside, "C", Dot.NONE)
