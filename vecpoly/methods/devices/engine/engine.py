"""In-line engine 多缸机: polygons of forces and couples, at the crank angles and at twice these angles."""

from __future__ import annotations

from collections.abc import Mapping
from math import degrees

from ....algebra.quantity import Expr, Quantity, magnitude
from ....board.construction import Scale, View
from ....board.paper.titled import CRANKSHAFT
from ....board.place import view_named
from ....devices.balancing.engine import ORDERS, RATIO, InlineEngine, of_order
from ....names import Named
from ....plane import Reals, nominal
from ....problem.problem import Scales
from ....words import Words
from ..bench import Bench
from ..registry import device_method
from ..rotor.polygon import Laid, Polygon, heading, stated_bearing, summed
from ..rotor.scales import COUPLES, END_VIEW, POLYGON, WIDE, across, fitting
from ..speeds import angular_velocity
from .sketch import LONG, crankshaft, stars

PRODUCTS = view_named("products")
SMALL = 0.6  # of the largest polygon that a rotor has: here there are four


def engine_scales(engine: InlineEngine, given: Scales) -> Mapping[View, Scale]:
    """As given, or round ones that fit."""
    product = engine.m.si * engine.r.si
    chains = [[product * _unit(laid) for laid in _laid(engine, times, product)] for times in (1, 2)]
    arms = [[w * engine.z[i] for w, i in zip(chain, engine.firing, strict=True)] for chain in chains]
    wide = POLYGON * SMALL
    found = {
        View.MECHANISM: given.of(View.MECHANISM.mu) or fitting(engine.size / LONG),
        END_VIEW: given.of(END_VIEW.mu) or fitting(2 * engine.r.si / (WIDE * SMALL)),
        PRODUCTS: given.of(PRODUCTS.mu) or fitting(max(map(across, chains)) / wide),
        COUPLES: given.of(COUPLES.mu) or fitting(max(map(across, arms)) / wide),
    }
    return {kind: Scale.of(kind, value) for kind, value in found.items()}


def _unit(laid: Laid) -> complex:
    return complex(heading(laid.degrees))


@device_method(
    InlineEngine,
    title=Words("直列多缸机惯性力的平衡", "Inertia forces of an in-line engine"),
    source="机械原理, balance of multi-cylinder engines: polygons of first and second order",
    example="engine-three",
    scales=engine_scales,
    called=CRANKSHAFT,
)
def draw_engine(bench: Bench, engine: InlineEngine) -> None:
    """The crankshaft, λ, then for both orders the polygon of forces and that of couples."""
    crankshaft(bench, engine)
    stars(bench, engine)
    ratio, speed, product = _numbers(bench, engine)
    for times, order in enumerate(ORDERS, 1):
        words = Words(f"{_zh(times)}惯性力和惯性力偶", f"Forces and couples of {_en(times)} order")
        bench.board.section(words)
        factor = (speed.squared(),) if times == 1 else (ratio, speed.squared())
        _forces(bench, engine, order, times, product, factor)
        _couples(bench, engine, order, times, product, factor)


def _numbers(bench: Bench, engine: InlineEngine) -> tuple[Quantity, Quantity, Quantity]:
    """λ = r/l, ω = π n/30 and W = m r."""
    board = bench.board
    board.section(Words("各缸的质径积", "The products"))
    board.step(
        Words(
            "往复质量 $m$ 的惯性力沿缸心线：$F$ = $m r ω²$($cos α$ + $λ cos 2α$)。一阶部分是沿曲柄方向的矢量 $W$ = "
            "$m r$ 在缸心线上的"
            "投影，二阶部分是方向角为 $2α$ 的矢量的投影，再乘 $λ$ = $r$/$l$。",
            "The inertia force of a reciprocating mass $m$ acts along its cylinder: $F$ = $m r ω²$($cos α$ + $λ cos "
            "2α$). "
            "Its first order is the projection of a vector $W$ = $m r$ along the crank, its second that of one at "
            "$2α$, "
            "times $λ$ = $r$/$l$.",
        )
    )
    mass, crank = magnitude("m", engine.m.si, "kg"), magnitude("r", engine.r.si, "m")
    ratio = bench.worked(RATIO, crank / magnitude("l", engine.l.si, "m"))
    speed = angular_velocity(board, "ω", abs(engine.n.si))
    return ratio, speed, board.compute("W", mass * crank, "kg·m")


def _laid(engine: InlineEngine, times: int, product: Reals) -> list[Laid]:
    """The products in firing order, else by the cylinders' numbers, at the angles of the cranks or at twice these."""
    return [
        Laid(
            named=Named(f"W_{i + 1}", f"W_{{{i + 1}}}", "kg·m"),
            size=product,
            degrees=times * degrees(engine.cranks[i].si),
        )
        for i in engine.firing
    ]


def _forces(
    bench: Bench, engine: InlineEngine, order: str, times: int, product: Quantity, factor: tuple[Expr, ...]
) -> None:
    """ΣW in that order; F = ΣW ω², of the second order times λ."""
    board = bench.board
    order_zh, order_en = (
        ("按发火顺序", "In firing order") if engine.order else ("按缸号依次", "In the order of the cylinders")
    )
    place = board.open_pane(PRODUCTS, order, Words(f"{_zh(times)}惯性力多边形", f"Forces, {_en(times)} order"))
    board.step(
        Words(
            f"{order_zh}把各缸的 $W$（方向角 ${_angle(times)}$）首尾相接，自极点 $O$ 到末端即其和 $W_{{{order}}}$：",
            f"{order_en} lay the products $W$ (at ${_angle(times)}$) off head to tail; from the pole $O$ to the "
            "last "
            f"tip is their sum $W_{{{order}}}$:",
        ),
        place,
        again=_likewise(times, f"W_{{{order}}}"),
    )
    named, turned, force, *_ = of_order(order)
    polygon = summed(bench, place, _laid(engine, times, product.value), named)
    _read(bench, polygon, (named, turned, force), factor)


def _couples(
    bench: Bench, engine: InlineEngine, order: str, times: int, product: Quantity, factor: tuple[Expr, ...]
) -> None:
    """ΣW z about the middle plane, drawn along W; M = ΣW z ω²."""
    board = bench.board
    place = board.open_pane(COUPLES, order, Words(f"{_zh(times)}惯性力偶多边形", f"Couples, {_en(times)} order"))
    board.step(
        Words(
            f"对中间平面取矩：各力偶 $W z$（转过 90°，沿 $W$ 画；$z$ < 0 的反向）首尾相接，其和为 $C_{{{order}}}$：",
            "Take moments about the middle plane: lay the couples $W z$, turned by 90° so that they lie along $W$ "
            "($z$ < 0: "
            f"reversed), off head to tail; their sum is $C_{{{order}}}$:",
        ),
        place,
        again=_likewise(times, f"C_{{{order}}}"),
    )
    *_, named, turned, moment = of_order(order)
    laid = [
        Laid(named=Named(f"C_{i + 1}", f"C_{{{i + 1}}}", "kg·m^2"), size=one.size * engine.z[i], degrees=one.degrees)
        for one, i in zip(_laid(engine, times, product.value), engine.firing, strict=True)
    ]
    polygon = summed(bench, place, laid, named)
    _read(bench, polygon, (named, turned, moment), factor)


def _read(bench: Bench, polygon: Polygon, named: tuple[Named, ...], factor: tuple[Expr, ...]) -> None:
    """Measure the sum, its direction, and what it amounts to at this speed."""
    total, turned, result = named
    found = bench.measured(total, polygon.place, 0j * polygon.tip, polygon.tip, f"O {polygon.letter}")
    stated_bearing(bench, turned, polygon.tip, polygon.least)
    if float(nominal(abs(polygon.tip))) <= polygon.least:
        bench.board.remark(Words("多边形封闭：已平衡。", " The polygon closes, so they are in balance."))
    whole: Expr = found * factor[0]
    for other in factor[1:]:
        whole = whole * other
    bench.worked(result, whole)


def _likewise(times: int, symbol: str) -> Words:
    """The polygon of the second order, drawn as that of the first."""
    return Words(
        f"同样以方向角 ${_angle(times)}$ 作图，得 ${symbol}$：",
        f"Likewise, with ${_angle(times)}$, ${symbol}$ is found:",
    )


def _zh(times: int) -> str:
    return "一阶" if times == 1 else "二阶"


def _en(times: int) -> str:
    return "first" if times == 1 else "second"


def _angle(times: int) -> str:
    return "α" if times == 1 else "2α"
