"""能量–质量图: E over J_e as a loop; two tangents of slopes ½ ω² tell the flywheel, by where they cut J_e = 0."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ...algebra.formula import Frac, Txt, sym
from ...algebra.quantity import Quantity, magnitude
from ...board.construction import Pane, Reading
from ...board.paper.marks import Dot, Role
from ...mechanism.asked.machine import J_F, J_F_AREAS, OMEGA_MAX, OMEGA_MIN, PHI_MAX, PHI_MIN
from ...plane import Line, Points, Reals, nominal
from ...words import Words
from ..devices.speeds import PI, THIRTY, turns_a_minute
from ..diagrams.axes import Axes, draw_axes
from .energy import Energies
from .period import Period, kept, shown
from .scales import WITTENBAUER, Sizes

TITLE = Words("能量–质量图", "Energy over inertia")
ONE = Quantity(Txt("1"), 1.0, "")


@dataclass(frozen=True, slots=True, kw_only=True)
class Contact:
    """A tangent: the speed that it stands for (rad/s), and the place ψ that it touches."""

    speed: float
    psi: float


def contacts_of(period: Period) -> tuple[Contact, Contact]:
    """The set square is slid along until it touches: ω_max from above, ω_min from below."""
    run, curve = period.run, period.curve
    assert run is not None and run.delta is not None
    fast, slow = (run.speed * (1 + sign * run.delta / 2) for sign in (1, -1))
    return (
        Contact(speed=fast, psi=curve.highest(fast**2 / 2, curve.mean, 1.0)),
        Contact(speed=slow, psi=curve.highest(slow**2 / 2, curve.mean, -1.0)),
    )


def reach_of(period: Period, contacts: tuple[Contact, Contact]) -> float:
    """The energies (J) from the lowest to the highest of what the loop's figure shows: its places, and where the
    tangents cut the axis, far from it where J_e hardly varies."""
    curve = period.curve
    touched = [(curve.work(one.psi, curve.mean), one.speed**2 / 2 * curve.inertia(one.psi)) for one in contacts]
    ends = [curve.work(curve.highest(0.0, curve.mean, sign), curve.mean) for sign in (1.0, -1.0)]
    shown_there = [*ends, *(energy - below for energy, below in touched)]
    return max(shown_there) - min(shown_there)


def draw_loop(period: Period, sizes: Sizes, energies: Energies, contacts: tuple[Contact, Contact]) -> None:
    """The loop point by point, both tangents, J_F = (a − b) / (δ ω_m²)."""
    board = period.board
    pane = board.open_pane(WITTENBAUER, "energy-mass", TITLE, sizes.loop, aside=True)
    board.step(
        Words(
            "将 $J_e$–$φ$ 图转过 90°，与 $E$–$φ$ 图逐点对应，作出 $E$–$J_e$ 曲线（能量–质量图）。",
            "Turn the $J_e$–$φ$ diagram by 90° and combine it with the $E$–$φ$ diagram point by point: the loop of $E$ "
            "versus $J_e$.",
        ),
        pane,
    )
    points = [_point(period, pane, psi, at) for psi, at in zip(energies.places, energies.points, strict=True)]
    _ink(period, pane, energies, points)
    _speeds(period, pane)
    cuts = [_tangent(period, pane, sizes, one, energies, name) for one, name in zip(contacts, "ab", strict=True)]
    _flywheel(period, pane, cuts[0], cuts[1])
    _places(period, energies, contacts)


def _point(period: Period, pane: Pane, psi: float, energy: Points) -> Points:
    """E carried over from its diagram, J_e laid off to the right."""
    board = period.board
    return board.lay_off(1j * energy.imag, 1 + 0j, board.to_paper_across(pane, period.inertia(psi)))


def _ink(period: Period, pane: Pane, energies: Energies, points: list[Points]) -> None:
    board, spots = period.board, [complex(nominal(point)) for point in points]
    heights = [spot.imag for spot in spots]
    axes = Axes(wide=max(spot.real for spot in spots), low=min(heights), high=max(heights), across="J_e", up="E")
    draw_axes(board, pane, axes, ())
    board.curve(pane, points, Role.GIVEN)
    step = period.curve.period / (len(period.read) - 1)
    for psi, point in zip(energies.places[:-1], points, strict=False):
        if abs(psi / step - round(psi / step)) < 1e-9:
            board.plot(pane, point, str(round(psi / step)), Dot.POINT)


def _speeds(period: Period, pane: Pane) -> None:
    """ω_max and ω_min = ω_m (1 ± δ / 2)."""
    board, run = period.board, period.run
    assert run is not None and run.delta is not None
    scale = board.scale_of(pane)
    energy, mass = scale.symbol, scale.right.symbol
    corner = Words("载荷突变处的尖点也算切点。", " A corner, where a load jumps, may be touched as well.")
    board.step(
        Words(
            f"由 $ω_m$ 和 $δ$ 得最大、最小角速度，作斜率为 $½ω²$ ${mass}/{energy}$ 的两条切线（上切、下切），与"
            " $J_e$ = 0 的纵轴交于 $a$、$b$。",
            "The values $ω_m$ and $δ$ give the maximum and the minimum speed. Draw the tangents of slope $½ω²$ "
            f"${mass}/{energy}$, one above the loop and one below it; they cut the axis $J_e$ = 0 in $a$ and $b$.",
        )
        + (corner if period.curve.corners else Words("", "")),
        pane,
    )
    mean, half = _mean(period), Quantity(Frac(sym("δ"), Txt("2")), run.delta / 2, "")
    for named, sign in ((OMEGA_MAX, 1), (OMEGA_MIN, -1)):
        kept(board, named, mean * (ONE + half if sign > 0 else ONE - half))


def _mean(period: Period) -> Quantity:
    """ω_m = π n / 30, of the speed that is given."""
    assert period.run is not None
    mean = magnitude("ω_m", period.run.speed, "rad/s")
    period.board.write_worked(mean.node, PI * turns_a_minute("n", period.run.speed) / THIRTY, mean.unit)
    return mean


def _tangent(period: Period, pane: Pane, sizes: Sizes, one: Contact, energies: Energies, name: str) -> Points:
    """Through the place that it touches, down or up to the axis."""
    board = period.board
    slope = one.speed**2 / 2 * sizes.loop.right.value / sizes.loop.value
    at = _point(period, pane, one.psi, energies.at(one.psi))
    line = board.parallel(at, (1 + 1j * slope) / abs(1 + 1j * slope))
    cut = board.meet(line, Line(0j, 1j), Words("切线与纵轴的交点", "the tangent on the axis"))
    found = board.locate(pane, name, cut)
    board.rule(pane, Line(found, line.along), at)
    board.plot(pane, found, name, Dot.POINT)
    board.plot(pane, at, "", Dot.POINT)
    return found


def _flywheel(period: Period, pane: Pane, a: Points, b: Points) -> None:
    board, run = period.board, period.run
    assert run is not None and run.delta is not None
    board.step(
        Words(
            "飞轮转动惯量由纵轴上的截距 $ab$ 求得（计入 $J_e$ 的变化）：",
            "The moment of inertia of the flywheel follows from the intercept $ab$ on the axis; the variation of $J_e$ "
            "is included:",
        ),
        pane,
    )
    delta, mean = magnitude("δ", run.delta, ""), magnitude("ω_m", run.speed, "rad/s")
    long = board.measure(b, a, "a b")
    side = 1.0 if complex(nominal(a - b)).imag > 0 else -1.0
    if side < 0:
        _none_needed(period)
        return
    kept(board, J_F, board.mu(pane) * long / (delta * mean.squared()))


def _none_needed(period: Period) -> None:
    period.board.remark(
        Words(
            "$a$ 在 $b$ 之下：机器本身已足够均匀，不需要飞轮。",
            " Point $a$ lies below $b$: the machine is even enough by itself, and no flywheel is needed.",
        )
    )
    period.board.keep(Reading(key=J_F.key, symbol=J_F.symbol, unit=J_F.unit, scalar=0.0), 0.0)


def keep_areas(period: Period, surplus: Quantity) -> None:
    """J_F = ΔW_max / (δ ω_m²), as if J_e were constant."""
    run = period.run
    assert run is not None and run.delta is not None
    period.board.step(
        Words(
            "若略去 $J_e$ 的变化，由最大盈亏功近似求飞轮转动惯量 $J_F$：",
            "If the variation of $J_e$ is neglected, the maximum surplus of work gives $J_F$ approximately:",
        )
    )
    mean = _mean(period)
    kept(period.board, J_F_AREAS, surplus / (magnitude("δ", run.delta, "") * mean.squared()))


def _places(period: Period, energies: Energies, contacts: tuple[Contact, Contact]) -> None:
    """φ of the fastest and the slowest place, read on the E–φ diagram."""
    board, mu = period.board, period.board.mu_across(energies.pane)
    whole = float(np.degrees(period.curve.period))
    for named, one in zip((PHI_MAX, PHI_MIN), contacts, strict=True):
        foot = energies.at(one.psi).real + 0j
        mm = board.measure(0j, foot, f"O {named.key[-3:]}")
        turned: Reals = np.degrees(mm.value * mu.value)
        value = (turned if period.curve.sense > 0 else whole - turned) - np.degrees(period.lead)
        if period.lead:  # within the period, all hands alike
            value = value - whole * np.floor(shown(value) / whole)
        board.keep(
            Reading(key=named.key, symbol=named.symbol, unit="deg", scalar=shown(value), mm=shown(mm.value)), value
        )
