"""The rotor as it is drawn: along its axis, with planes and masses, and from its end, with r and θ."""

from __future__ import annotations

from cmath import rect
from math import degrees, pi, sin

import numpy as np

from ....board.construction import View
from ....board.paper.marks import Dot, Role
from ....devices.balancing.mass import RotorMass
from ....devices.balancing.plane import RotorPlane
from ....devices.balancing.rotor import Rotor
from ....diagram.single import disc, outline, rod
from ....plane import nominal
from ....words import Words
from ..bench import Bench
from ..sketches.dimensions import dimension
from .polygon import Polygon, heading
from .scales import END_VIEW, widest

SHAFT, RUN, LUMP = 1.6, 9.0, 2.0  # mm: half the shaft, how far it runs on, radius of a mass as drawn
LOW, TALL = 9.0, 17.0  # mm: arms shorter than LOW on the scale of the shaft are drawn TALL, to no scale
DEEP, APART = 9.0, 6.5  # mm: the first line of dimensions under the arms, from line to line
AXIS, FIRST, STEP = 7.0, 8.0, 4.5  # mm: the axes run on; radius of the first angle, from one to the next
FEW = 5  # masses whose angles and distances are written into the figures


def sketch(bench: Bench, rotor: Rotor) -> None:
    """Both views; the one along the axis only where there is a length."""
    bench.board.section(Words("转子简图", "The rotor"))
    if rotor.length > 0:
        _along(bench, rotor)
    _from_its_end(bench, rotor)


def _along(bench: Bench, rotor: Rotor) -> None:
    board, view = bench.board, View.MECHANISM
    mm = board.scale_of(view).value
    true = widest(rotor) / mm >= LOW
    board.step(
        Words(
            "按 $μ_l$ 画出转子的轴向简图：各质量和校正平面的轴向位置"
            + ("，半径方向取投影 $r$sin$θ$。" if true else "（半径方向不按比例）。"),
            "Draw the rotor along its axis to the scale $μ_l$: the planes of the masses and those of the correction"
            + (", radially the projections $r$ sin $θ$." if true else " (radially to no scale)."),
        ),
        view,
    )
    start = min(rotor.stations)
    reach = widest(rotor) / mm if true else TALL
    _shaft(bench, rotor.length / mm)
    for name, mass in rotor.masses.items():
        arm = reach if mass.r is None or not true else mass.r.si / mm
        turn = pi / 2 if "at" in mass.unknown else mass.at.si
        _mass_beside(bench, name, complex((mass.place - start) / mm, 0.0), arm * sin(turn), mass)
    for name, plane in rotor.correct.items():
        at = complex((plane.at - start) / mm, 0.0)
        board.join(view, at - 1j * (reach + 4), at + 1j * (reach + 6), Role.HIDDEN)
        board.plot(view, at + 1j * (reach + 6), name, Dot.NONE)
    _distances(bench, rotor, -reach - DEEP)


def _shaft(bench: Bench, long: float) -> None:
    view = View.MECHANISM
    ends = (-RUN - SHAFT * 1j, long + RUN - SHAFT * 1j, long + RUN + SHAFT * 1j, -RUN + SHAFT * 1j)
    bench.board.depict(view, outline("shaft", *ends))
    bench.board.join(view, complex(-RUN - AXIS, 0), complex(long + RUN + AXIS, 0), Role.CENTRE)


def _mass_beside(bench: Bench, name: str, foot: complex, high: float, mass: RotorMass) -> None:
    """The mass at the end of its arm, as it is seen from the side; a hole is a ring."""
    board, view, at = bench.board, View.MECHANISM, foot + 1j * high
    if abs(high) > SHAFT + LUMP:
        way = 1j if high > 0 else -1j
        board.depict(view, rod(f"mass {name}", foot + way * SHAFT, at - way * LUMP))
    _lump(bench, view, name, at, mass)


def _lump(bench: Bench, view: View, name: str, at: complex, mass: RotorMass) -> None:
    if mass.removed:
        bench.board.circle(view, at, LUMP, Role.HIDDEN)
    else:
        bench.board.depict(view, disc(f"mass {name}", at, LUMP))
    bench.board.plot(view, at, f"m_{{{name}}}", Dot.NONE)


def _distances(bench: Bench, rotor: Rotor, level: float) -> None:
    """l_i from the first plane, L between the planes; of few masses, each on a line of its own."""
    if rotor.static or len(rotor.masses) > FEW:
        return
    board, view, mm, start = (
        bench.board,
        View.MECHANISM,
        bench.board.scale_of(View.MECHANISM).value,
        min(rotor.stations),
    )
    origin = rotor.masses[next(iter(rotor.masses))].place if rotor.sought else next(iter(rotor.correct.values())).at
    spans = [(f"l_{{{name}}}", mass.place) for name, mass in rotor.masses.items() if abs(mass.place - origin) > 1e-9]
    if not rotor.sought:
        spans.append(("L", [*rotor.correct.values()][1].at))
    for i, (symbol, place) in enumerate(sorted(spans, key=lambda one: (one[0] == "L", abs(one[1] - origin)))):
        y = level - i * APART
        a, b = complex((origin - start) / mm, y), complex((place - start) / mm, y)
        for end in (a, b):
            board.join(view, end + 1j * (APART if i else DEEP / 2), end - 1.5j, Role.CONSTRUCTION)
        dimension(bench, view, a, b, symbol)


def _from_its_end(bench: Bench, rotor: Rotor) -> None:
    board = bench.board
    mm = board.scale_of(END_VIEW).value
    board.step(
        Words(
            "画出端视图：各质量的半径 $r$ 和方位角 $θ$（自 $x$ 轴逆时针为正）。",
            "Draw the end view: radius $r$ and direction $θ$ of every mass, counter-clockwise from the $x$ axis.",
        ),
        END_VIEW,
    )
    reach = widest(rotor) / mm
    for way in (1, 1j):
        board.join(END_VIEW, -way * (reach + AXIS), way * (reach + AXIS), Role.CENTRE)
    board.plot(END_VIEW, reach + AXIS + 0j, "x", Dot.NONE)
    board.plot(END_VIEW, 0j, "O", Dot.JOINT)
    seen = [(name, mass) for name, mass in rotor.masses.items() if "at" not in mass.unknown]
    for i, (name, mass) in enumerate(sorted(seen, key=lambda one: reach if one[1].r is None else one[1].r.si)):
        away = reach if mass.r is None else mass.r.si / mm
        _mass_seen(bench, name, mass, away, FIRST + STEP * i if len(seen) <= FEW else 0.0)


def _mass_seen(bench: Bench, name: str, mass: RotorMass, away: float, ring: float) -> None:
    board, at = bench.board, rect(away, mass.at.si)
    if mass.r is None:
        board.arrow(END_VIEW, 0j, at, Role.GIVEN, key=f"U_{name}", label=f"U_{{{name}}}")
    else:
        board.depict(END_VIEW, rod(f"mass {name}", 0j, at * (1 - LUMP / away)))
        _lump(bench, END_VIEW, name, at, mass)
    turn = mass.at.si % (2 * pi)
    if ring and ring < away and 1e-6 < turn < 2 * pi - 1e-6:
        board.angle(END_VIEW, 0j, 1 + 0j, turn, ring, f"{degrees(turn):.4g}°")


def added(bench: Bench, rotor: Rotor, end: str, polygon: Polygon, plane: RotorPlane) -> None:
    """What balances the plane, drawn into the end view: a weight, or the hole opposite to it."""
    if abs(complex(nominal(polygon.tip))) < 1e-6:
        return
    way = float(np.angle(nominal(-polygon.tip)))
    turns = [way] if plane.hole is None else [way + pi + side for side in _sides(plane)]
    _drawn_in(bench, end, plane, [degrees(turn) for turn in turns], [f"m_{{b{end}}}"] * len(turns))


def _sides(plane: RotorPlane) -> tuple[float, ...]:
    return (0.0,) if plane.spread is None else (plane.spread.si, -plane.spread.si)


def placed(bench: Bench, rotor: Rotor, end: str, at: tuple[float, float], plane: RotorPlane) -> None:
    """The weights at fixed places, drawn into the end view."""
    _drawn_in(bench, end, plane, list(at), [f"m_{{b{end},{which}}}" for which in (1, 2)])


def _drawn_in(bench: Bench, end: str, plane: RotorPlane, turns: list[float], labels: list[str]) -> None:
    board = bench.board
    assert plane.r is not None
    away = plane.r.si / board.scale_of(END_VIEW).value
    for turn, label in zip(turns, labels, strict=True):
        at = complex(heading(turn)) * away
        board.join(END_VIEW, 0j, at, Role.HIDDEN)
        board.circle(END_VIEW, at, LUMP, Role.RESULT)
        board.plot(END_VIEW, at, label, Dot.NONE)
