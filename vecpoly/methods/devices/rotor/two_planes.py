"""Dynamic balance 动平衡 in two planes: every product shared by the lever, and one polygon for each plane."""

from __future__ import annotations

from collections.abc import Mapping
from math import degrees

from ....algebra.quantity import Quantity, magnitude
from ....devices.balancing.asked import bearing, correction, product_of, static_unbalance
from ....devices.balancing.rotor import Rotor
from ....plane import nominal
from ....words import Words
from ..bench import Bench
from .about import about_a_third_plane
from .correct import corrected
from .grade import permitted_circles
from .polygon import Laid, Polygon, chain, read_closing, summed
from .scales import arm_letter, polygon_view
from .static import laid_whole
from .verdict import told_kind
from .views.ends import planes_from_their_end


def in_two_planes(bench: Bench, rotor: Rotor, sizes: Mapping[str, Quantity]) -> None:
    """The static sum, the shares, two polygons; which kind of unbalance; what is added, and the check."""
    whole = _sum(bench, rotor, sizes)
    shares = _shares(bench, rotor, sizes)
    polygons: dict[str, Polygon] = {}
    found: dict[str, Quantity] = {}
    bench.board.section(Words("两校正平面的质径积多边形", "The polygons of the two planes"))
    everything = sum(abs(float(nominal(size.value))) for size in sizes.values())
    for end, laid in shares.items():
        polygons[end], found[end] = _plane(bench, rotor, end, laid, everything)
    told_kind(bench, rotor, whole, polygons)
    circles = permitted_circles(bench, rotor, polygons) if rotor.tolerance is not None else {}
    for end, polygon in polygons.items():
        corrected(bench, rotor, end, polygon, found[end], circles.get(end))
    about_a_third_plane(bench, rotor, sizes, polygons, found)


def _sum(bench: Bench, rotor: Rotor, sizes: Mapping[str, Quantity]) -> Polygon:
    """ΣW: whether the rotor is in static balance."""
    board, unit, view = bench.board, rotor.weighing, polygon_view(rotor)
    board.section(Words("静平衡校核", "Static balance"))
    place = board.open_pane(view, "S", Words("静平衡校核：各质径积之和", "Static balance: the sum of all products"))
    board.step(
        Words(
            f"先看静平衡：按 ${view.mu.symbol}$ 把各质径积首尾相接，其和 $W_S$ 由极点 $O$ 指向末端。量得：",
            f"Static balance first: to the scale ${view.mu.symbol}$ lay all products off head to tail. Their sum $W_S$ "
            "leads from the pole $O$ to the last tip. Read it off:",
        ),
        place,
    )
    named = static_unbalance(unit)
    polygon = summed(bench, place, [laid_whole(rotor, name, size) for name, size in sizes.items()], named)
    bench.measured(named, place, 0j * polygon.tip, polygon.tip, f"O {polygon.letter}")
    return polygon


def _shares(bench: Bench, rotor: Rotor, sizes: Mapping[str, Quantity]) -> dict[str, list[Laid]]:
    """W_iI = W_i (L − l_i)/L and W_iII = W_i l_i/L; overhung: one of them is negative."""
    board, unit = bench.board, rotor.weighing
    (one, first), (other, second) = rotor.correct.items()
    board.section(Words("向两校正平面分解", "Resolution into the two planes"))
    over = [name for name in rotor.masses if min(share[name] for share in rotor.shares.values()) < -1e-12]
    letter = arm_letter(first.at)
    arm_told = "$z_i$" if letter == "z" else f"$l_i$ = $z_i$ − $z_{{b{one}}}$"
    span_told = f"$L$ = $z_{{b{other}}}$" + (f" − $z_{{b{one}}}$" if letter == "l" else "")
    board.step(
        Words(
            f"把每个质径积按杠杆关系分解到平面 ${one}$ 和 ${other}$：{arm_told} 为质量 $i$ 到平面 ${one}$ 的距离，"
            f"{span_told} 为两平面的距离。",
            f"Resolve every product into the planes ${one}$ and ${other}$ by the lever rule: {arm_told} is the "
            f"distance of mass $i$ from plane ${one}$, {span_told} that of the two planes.",
        )
        + _overhung(over)
    )
    span = magnitude("L", (second.at - first.at) * 1e3, "mm")
    laid: dict[str, list[Laid]] = {one: [], other: []}
    for name, size in sizes.items():
        arm = magnitude(f"{letter}_{{{name}}}", (rotor.masses[name].place - first.at) * 1e3, "mm")
        pair = product_of(name, unit, one), product_of(name, unit, other)
        found = bench.divided(pair, (size * ((span - arm) / span), size * (arm / span)))
        sign = -1.0 if rotor.masses[name].removed else 1.0
        turn = degrees(rotor.masses[name].at.si)
        for end, named, share in zip((one, other), pair, found, strict=True):
            laid[end].append(Laid(named=named, size=sign * share.value, degrees=turn))
    planes_from_their_end(bench, rotor)
    return laid


def _overhung(names: list[str]) -> Words:
    if not names:
        return Words.same("")
    listed = "、".join(names)
    return Words(
        f"质量 {listed} 在两平面之外（悬臂），它在较远平面内的分量为负，即与 $W$ 反向。",
        f" Mass {listed.replace('、', ', ')} lies outside the planes (overhung): its share in the farther plane is "
        "negative, it points against $W$.",
    )


def _plane(bench: Bench, rotor: Rotor, end: str, laid: list[Laid], whole: float) -> tuple[Polygon, Quantity]:
    board, view = bench.board, polygon_view(rotor)
    closing = correction(end, rotor.weighing)
    place = board.open_pane(view, end, Words(f"平面 ${end}$ 的质径积多边形", f"Polygon of plane ${end}$"))
    board.step(
        Words(
            f"在平面 ${end}$ 内把各分量首尾相接，封闭边即 ${closing.symbol}$。量得：",
            f"In plane ${end}$ lay the components off head to tail; the closing side is ${closing.symbol}$. "
            "Read it off:",
        ),
        place,
        again=Words(
            f"同样作平面 ${end}$ 的多边形，量得：", f"Draw the polygon of plane ${end}$ in the same way and read off:"
        ),
    )
    polygon = chain(bench, place, laid, closing, whole)
    return polygon, read_closing(bench, polygon, closing, bearing(end))
