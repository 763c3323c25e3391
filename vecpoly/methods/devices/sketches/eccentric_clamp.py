"""How an eccentric clamp is drawn: pin, disc, handle and work to scale, and the disc apart with its three forces."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from ....board.board import NO_LENGTH
from ....board.construction import Pane, View
from ....board.paper.marks import Dot, Role
from ....devices.eccentric_clamp import FORCE, R21, R31, EccentricClamp
from ....diagram.single import disc, friction_circle, number, outline, pivot, rim, rod
from ....names import Named
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
    u, foot31 = (complex(nominal(z)) for z in (u31, touch))
    foot31 *= seen(clamp)
    bench.board.arrow(place, foot31 - 1.6 * ARROW * u, foot31, Role.RESULT, label=R31.symbol)
    starts = {R21.key: clamp.k, FORCE.key: clamp.h, R31.key: foot31}
    ends = carried_on(bench, place, starts, meet, Role.DIRECTION)
    if abs(complex(nominal(meet))) < FAR:
        bench.board.plot(place, meet, "X")
    else:
        told = Words("三线交于图外的 $X$", "the three lines meet at $X$,\noff the sheet")
        bench.board.note(place, ends[R31.key], told)


def carried_on(
    bench: Bench, place: Pane, starts: Mapping[str, Points], meet: Points, role: Role
) -> Mapping[str, complex]:
    """The lines of the forces, carried on to the point where they meet, or a little way towards it; where they end."""
    x = complex(nominal(meet))
    way, begun = x / abs(x), {key: complex(nominal(at)) for key, at in starts.items()}
    top = max((z * way.conjugate()).real for z in begun.values()) + 1.5 * ARROW
    ends: dict[str, complex] = {}
    for key, start in begun.items():
        towards = (x - start) / abs(x - start)
        short = max(ARROW, (top - (start * way.conjugate()).real) / (towards * way.conjugate()).real)
        ends[key] = start + towards * (abs(x - start) if abs(x) < FAR else short)
        bench.board.join(place, start, ends[key], role, key=key)
    return ends


def without_friction(bench: Bench, place: Pane, clamp: Clamp, meet: Points, names: tuple[Named, Named]) -> None:
    """Beside the lines with friction, dashed, those without it: the normal at K, and the line through the pin A."""
    press_on, hold = names
    ends = carried_on(bench, place, {press_on.key: clamp.k, hold.key: 0j}, meet, Role.IDEAL)
    for named in names:
        bench.board.plot(place, ends[named.key], named.symbol, Dot.NONE, key=named.key)


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
