"""A link with a counterweight: the mass–radius polygon about its pivot, closed by the product of the counterweight."""

from __future__ import annotations

import numpy as np

from ...algebra.formula import Row, Txt, sym
from ...algebra.quantity import magnitude, number
from ...board.board import NO_LENGTH
from ...board.construction import Pane, Scale, View
from ...board.paper.marks import Dot, Lump, Role
from ...board.place import view_named
from ...diagram.single import disc
from ...mechanism.asked.counterweights import bearing, product, weight
from ...mechanism.counterweights import Passing
from ...names import Named, subscripted
from ...plane import Points, Reals, nominal
from ...words import Words
from ..devices.rotor.polygon import Laid, Polygon, chain
from ..devices.rotor.scales import fitting
from ..registry import Stage, method
from .standing import Stand, Weighing

PRODUCTS = view_named("products")
LONG = 120.0  # mm: all products of a polygon in line
SIZE = 2.5  # mm: of a counterweight on the diagram


@method(
    stage=Stage.BALANCE,
    group="counterweight",
    source="机械原理, mass balance of linkages: the products about the pivot of a link add to nothing (Berkof–Lowen)",
    example="balance-four-bar",
    title=Words("构件上的配重（质径积多边形）", "Counterweight of a link by its mass–radius polygon"),
)
def hung(here: Weighing, of: Passing) -> None:
    """Σ m l + W_c = 0 about the pivot (kg·m); m_c = W_c / r_c; with the counterweight all stands at the pivot."""
    board, mech = here.desk.board, here.desk.mech
    no, pivot = mech.number(of.link), of.outlets[0].point
    place = _pane(here, of)
    mu = board.scale_of(place).symbol
    board.step(
        Words(
            f"构件 {no} 上的质量绕 ${subscripted(pivot)}$ 转动。由 $W$ = $m l$ 算各质径积，按 ${mu}$ 自 $O$ 首尾相接，"
            f"方向与图中的半径相同；封闭边就是配重的质径积 ${product(no).symbol}$。",
            f"The masses on link {no} turn about ${subscripted(pivot)}$. Lay off their products $W$ = $m l$ to the "
            f"scale ${mu}$ head to tail from $O$, along their radii on the diagram; the closing side is the product "
            f"${product(no).symbol}$ of the counterweight.",
        ),
        place,
    )
    stands = here.gather(of)
    laid = [_laid(here, of, one) for one in stands if one.point != pivot]
    polygon = chain(here.bench, place, laid, product(no))
    _read(here, of, polygon)
    for one in stands:
        here.put(of.outlets[0], one)
    ideal = sum(one.ideal * (here.local(of.link, one.point) - here.local(of.link, pivot)) for one in stands)
    here.put(
        of.outlets[0], Stand(point=pivot, label=f"c{no}", mass=here.hung[-1], ideal=complex(abs(ideal) / _radius(of)))
    )


def _radius(of: Passing) -> float:
    assert of.r is not None
    return of.r


def _pane(here: Weighing, of: Passing) -> Pane:
    """A figure of its own, its scale by the data."""
    no, pivot = here.desk.mech.number(of.link), of.outlets[0].point
    at = here.local(of.link, pivot)
    whole = sum(abs(one.ideal * (here.local(of.link, one.point) - at)) for one in here.stands[of.link])
    scale = Scale.of(PRODUCTS, here.given or fitting(whole / LONG))
    title = Words(f"构件 {no} 的质径积多边形", f"Mass–radius polygon of link {no}")
    return here.desk.board.open_pane(PRODUCTS, f"link {no}", title, scale)


def _laid(here: Weighing, of: Passing, one: Stand) -> Laid:
    desk, pivot = here.desk, of.outlets[0].point
    again = "′" * (f"W_{one.label}" in desk.board.ledger.sizes)  # about the pivot of another link: another product
    named = Named(f"W{again}_{one.label}", f"W{again}_{{{one.label}}}", "kg·m")
    size = here.bench.worked(named, one.mass * desk.length(pivot, one.point))
    turn = desk.board.gauge(desk.at[pivot], desk.at[one.point]) + (0.0 if one.turn is None else one.turn)
    return Laid(named=named, size=size.value, degrees=np.degrees(turn) % 360.0)


def _read(here: Weighing, of: Passing, polygon: Polygon) -> None:
    """Product, angle and mass off the closing side; the counterweight on the diagram."""
    board, bench, no = here.desk.board, here.bench, here.desk.mech.number(of.link)
    found = bench.measured(product(no), polygon.place, polygon.tip, 0j * polygon.tip, f"{polygon.letter} O")
    here.hung.append(bench.worked(weight(no), found / magnitude(f"r_{{c{no}}}", _radius(of), "m")))
    named = bearing(no)
    if float(nominal(np.abs(polygon.tip))) <= max(polygon.least, NO_LENGTH):
        board.remark(Words("（封闭边为零，此构件不需要配重。）", " (The side vanishes: nothing need be hung here.)"))
        bench.stated(named, np.nan * np.abs(polygon.tip), Row((sym(named.symbol), Txt(" —"))))
        return
    pivot, towards = here.desk.at[of.outlets[0].point], here.desk.at[of.towards]
    way = board.gauge(0j * polygon.tip, -polygon.tip)
    _mark(here, of, pivot, way)
    _state(here, of, np.degrees(way - board.gauge(pivot, towards)) % 360.0)


def _state(here: Weighing, of: Passing, turn: Reals) -> None:
    no, line = here.desk.mech.number(of.link), f"{of.outlets[0].point}{of.towards}"
    here.desk.board.remark(
        Words(f"（角度自 ${line}$ 逆时针量起。）", f" (The angle is measured counter-clockwise from ${line}$.)")
    )
    named = bearing(no)
    here.bench.stated(named, turn, Row((sym(named.symbol), Txt(f" = {number(float(nominal(turn)), 5)}°"))))


def _mark(here: Weighing, of: Passing, pivot: Points, way: Reals) -> None:
    """The counterweight where it sits on the diagram."""
    board, view, no = here.desk.board, View.MECHANISM, here.desk.mech.number(of.link)
    board.step(
        Words(
            f"在机构图上自 ${of.outlets[0].point}$ 沿封闭边的方向取 $r_{{c{no}}}$，标出配重。",
            f"On the diagram lay off $r_{{c{no}}}$ from ${of.outlets[0].point}$ along the closing side, and mark the "
            "counterweight.",
        ),
        view,
    )
    end = pivot + here.desk.mm(_radius(of)) * np.exp(1j * way)
    board.join(view, pivot, end, Role.HIDDEN)
    board.depict(view, disc(f"link {no}", complex(nominal(end)), SIZE, Lump.COUNTERWEIGHT))
    board.plot(view, end, f"m_{{c{no}}}", Dot.NONE)
