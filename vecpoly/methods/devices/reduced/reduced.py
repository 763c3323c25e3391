"""A train reduced to one of its shafts: kinetic energies and powers with the ratios of the speeds."""

from __future__ import annotations

from ....algebra.columns import TOTAL, column, headed, summed
from ....algebra.quantity import Expr, Product, Quantity, Quotient, Sum, magnitude
from ....board.construction import Listing, View
from ....devices.dynamics.reduced import J_E, M_D, M_E, M_R, ReducedTrain, alpha_of, ratio_of
from ....devices.dynamics.shafts import G, Pair
from ....plane import nominal
from ....words import Words
from ..bench import Bench
from ..registry import device_method
from .run import run_up
from .sketch import draw_shafts

HEAD = (
    Words("轴", "shaft"),
    Words.same("$ω_i/ω$"),
    Words.same(headed("$J_i$", "kg·m²")),
    Words.same(headed("$J_i (ω_i/ω)^2$", "kg·m²")),
    Words.same(headed("$M_i$", "N·m")),
    Words.same(headed("$M_i ω_i/ω$", "N·m")),
)


@device_method(
    ReducedTrain,
    title=Words("轮系的等效转动惯量与等效力矩", "Gear train referred to one shaft"),
    source="机械原理, 机械的运转: kinetic energy and power of the equivalent link",
    example="7-3",
)
def draw_reduced(bench: Bench, train: ReducedTrain) -> None:
    """J_e = Σ J_i (ω_i/ω)² + m (v/ω)²; M_e = Σ ± M_i ω_i/ω − G v/ω; α = M_e / J_e."""
    board = bench.board
    place = board.open_pane(View.MECHANISM, "train", Words("传动简图（示意）", "The train (sketch)"))
    board.section(Words("传动比", "Ratios of the speeds"))
    wheels = _BELTED if any(pair.belt for pair in train.pairs) else _MESHING
    board.step(
        Words(
            f"取轴 {train.main} 为等效构件。{wheels.zh}", f"Take shaft {train.main} as the equivalent link. {wheels.en}"
        ),
        place,
    )
    draw_shafts(board, place, train)
    ratios = {name: _ratio(bench, train, name) for name in train.shafts}
    inertia = _inertia(bench, train, ratios)
    moment = _moments(bench, train, ratios)
    _table(bench, train, ratios)
    if moment is None:
        return
    board.step(Words("由 $M_e = J_e α$：", "The equation of motion, $M_e = J_e α$, gives:"))
    alpha = bench.worked(alpha_of(train.main), moment / inertia)
    for name, ratio in ratios.items():
        if name != train.main and ratio is not None:
            bench.worked(alpha_of(name), ratio * alpha)
    run_up(bench, train, ratios, alpha)


_MESHING = Words(
    "相啮合的两轮节线速度相等，故转速与齿数成反比，传动比取大小：",
    "Two gears in mesh have the same pitch-line velocity, so the magnitudes of their speeds are inversely proportional "
    "to their teeth:",
)
_BELTED = Words(
    "相啮合的两轮、同一带上的两带轮节线速度相等，故转速与齿数（直径）成反比，传动比取大小：",
    "Two gears in mesh, or two pulleys joined by a belt, have the same pitch-line velocity, so the magnitudes of their "
    "speeds are inversely proportional to their teeth (diameters):",
)


def _ratio(bench: Bench, train: ReducedTrain, name: str) -> Quantity | None:
    """ω of a shaft over ω, by the pairs on the way; None of the shaft itself."""
    way = train.ways[name]
    if not way:
        return None
    above = [_size(train, pair, first=forwards) for pair, forwards in way]
    below = [_size(train, pair, first=not forwards) for pair, forwards in way]
    return bench.worked(ratio_of(name, train.main), Quotient(_product(above), _product(below)))


def _size(train: ReducedTrain, pair: Pair, *, first: bool) -> Quantity:
    """The teeth, or the diameter, of one of two wheels."""
    one, other = (pair.first, pair.second) if first else (pair.second, pair.first)
    size = pair.sizes[0] if first else pair.sizes[1]
    return magnitude(train.wheel(pair, one, other), 1e3 * size if pair.belt else size, "")


def _product(factors: list[Quantity]) -> Expr:
    return factors[0] if len(factors) == 1 else Product(tuple(factors))


def _inertia(bench: Bench, train: ReducedTrain, ratios: dict[str, Quantity | None]) -> Quantity:
    bench.board.section(Words("等效转动惯量", "Equivalent moment of inertia"))
    drum = "" if train.hoist is None else f"{train.hoist[0]}"
    bench.board.step(
        Words(
            f"动能相等，各转动惯量 $J$ 乘以传动比的平方{f'（卷筒半径 $R$ = $D_{{{drum}}}$/2）' if drum else ''}：",
            "Equating kinetic energies, each $J$ is multiplied by the square of its speed ratio"
            f"{f' (the radius of the drum is $R$ = $D_{{{drum}}}$/2)' if drum else ''}:",
        )
    )
    terms: list[Expr] = []
    for name, shaft in train.shafts.items():
        for n, one in enumerate(shaft.J):
            mark = "" if len(shaft.J) == 1 else "′" * n
            terms.append(_reduced(magnitude(f"J{mark}_{{{name}}}", one.si, "kg·m^2"), ratios[name], squared=True))
        if shaft.lifts is not None and shaft.drum is not None:
            mass, radius = magnitude("m", shaft.lifts.si, "kg"), magnitude("R", shaft.drum.si / 2, "m")
            terms.append(_reduced(mass * radius.squared(), ratios[name], squared=True))
    return bench.worked(J_E, _sum(terms, [1] * len(terms)))


def _moments(bench: Bench, train: ReducedTrain, ratios: dict[str, Quantity | None]) -> Quantity | None:
    """M_e = M_ed − M_er; None where nothing drives."""
    if not (train.driven or train.resisted):
        return None
    bench.board.section(Words("等效力矩", "Equivalent moment"))
    bench.board.step(
        Words(
            "按功率相等，各力矩乘以传动比；驱动力矩与阻力矩分别求和（表中驱动为正、阻力为负）：",
            "Equating powers, each moment is multiplied by its speed ratio; driving and resisting moments are added "
            "separately (in the table driving ones are positive):",
        )
    )
    driving: list[Expr] = []
    resisting: list[Expr] = []
    for name, shaft in train.shafts.items():
        if shaft.drives is not None:
            driving.append(_reduced(magnitude(f"M_{{d{name}}}", shaft.drives.si, "N·m"), ratios[name]))
        if shaft.resists is not None:
            resisting.append(_reduced(magnitude(f"M_{{r{name}}}", shaft.resists.si, "N·m"), ratios[name]))
        if shaft.lifts is not None and shaft.drum is not None:
            weight = magnitude("m", shaft.lifts.si, "kg") * magnitude("g", G, "m/s^2")
            resisting.append(_reduced(weight * magnitude("R", shaft.drum.si / 2, "m"), ratios[name]))
    drives = bench.worked(M_D, _sum(driving, [1] * len(driving))) if driving else None
    resists = bench.worked(M_R, _sum(resisting, [1] * len(resisting))) if resisting else None
    if drives is None:
        return bench.worked(M_E, Sum((resists,), (-1,))) if train.moves and resists is not None else None
    return bench.worked(M_E, drives if resists is None else drives - resists)


def _reduced(term: Expr, ratio: Quantity | None, *, squared: bool = False) -> Expr:
    if ratio is None:
        return term
    return term * (ratio.squared() if squared else ratio)


def _sum(terms: list[Expr], signs: list[int]) -> Expr:
    return terms[0] if len(terms) == 1 else Sum(tuple(terms), tuple(signs))


def _table(bench: Bench, train: ReducedTrain, ratios: dict[str, Quantity | None]) -> None:
    """Shaft by shaft, the weight that is lifted with its drum; under them the sums."""
    rows = []
    for name, shaft in train.shafts.items():
        ratio = ratios[name]
        turns = 1.0 if ratio is None else float(nominal(ratio.value))
        inertia = sum(one.si for one in shaft.J)
        moment = (shaft.drives.si if shaft.drives else 0.0) - (shaft.resists.si if shaft.resists else 0.0)
        if shaft.lifts is not None and shaft.drum is not None:
            inertia += shaft.lifts.si * (shaft.drum.si / 2) ** 2
            moment -= shaft.lifts.si * G * shaft.drum.si / 2
        rows.append((turns, inertia, inertia * turns**2, moment, moment * turns))
    turning, own, reduced, moments, powers = zip(*rows, strict=True)
    (*energies, energy), (*driving, drive) = (summed(each) for each in (reduced, powers))
    columns = column(turning), column(own), energies, column(moments), driving
    total = (TOTAL, "", "", energy, "", drive)
    bench.board.tabulate(Listing(head=HEAD, rows=(*zip(train.shafts, *columns, strict=True), total), blocks=1))
