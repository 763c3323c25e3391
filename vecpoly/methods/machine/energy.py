"""The E–φ diagram by graphical integration of the surplus moment: mean ordinates, rays from a pole, chords parallel."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from itertools import pairwise

import numpy as np

from ...algebra.quantity import magnitude
from ...board.construction import Pane
from ...board.paper.marks import Dot, Role
from ...foundation.runs import runs
from ...plane import Line, Points, Reals, nominal, unit
from ...words import Words
from ..diagrams.axes import BEYOND, Axes, angle_ticks, draw_axes
from .french import French
from .period import Period
from .scales import ENERGY, TORQUE, Sizes

RAYS = Words("极点与射线", "Pole and rays")
TITLE = Words("能量线图（图解积分）", "Energy versus angle (graphical integration)")
STRIP = np.radians(15.0)
STEEP, NARROWER = 0.15, 2  # of the range of the moments: what changes more in a strip halves it; so often at most
SAME = 1e-9
TOLD = 2.0  # mm: rays that end nearer to each other share their label


@dataclass(frozen=True, slots=True, kw_only=True)
class Energies:
    """The pane; the places ψ of the ordinates, and the points of the curve there."""

    pane: Pane
    places: tuple[float, ...]
    points: tuple[Points, ...]

    def at(self, psi: float) -> Points:
        """The point at one of the places."""
        return min(zip(self.places, self.points, strict=True), key=lambda pair: abs(pair[0] - psi))[1]


def strips_of(period: Period, contacts: tuple[float, ...]) -> tuple[float, ...]:
    """Ends of the strips: even ones, the jumps of the loads, where the moment is in balance, the places touched."""
    curve = period.curve
    even = np.linspace(0.0, curve.period, round(curve.period / STRIP) + 1)
    own = [*curve.corners, *curve.crossings(-curve.mean), *contacts]
    kept = sorted({*own, *(float(psi) for psi in even if all(abs(psi - one) > STRIP / 4 for one in own))})
    inner = [psi for psi in kept if SAME < psi < curve.period - SAME]
    ends = [0.0, *(psi for i, psi in enumerate(inner) if not i or psi - inner[i - 1] > SAME), curve.period]
    heights = [curve.moment(psi) for psi in ends]
    steep = STEEP * (max(heights) - min(heights))
    return 0.0, *(end for a, b in pairwise(ends) for end in _narrower(curve, a, b, steep, NARROWER))


def _narrower(curve: French, a: float, b: float, steep: float, times: int) -> Iterator[float]:
    """The ends of a strip's parts: it is halved as long as the moment changes much in it."""
    if not times or abs(curve.moment(b, before=True) - curve.moment(a)) <= steep:
        yield b
        return
    yield from _narrower(curve, a, (a + b) / 2, steep, times - 1)
    yield from _narrower(curve, (a + b) / 2, b, steep, times - 1)


def draw_energy(period: Period, sizes: Sizes, contacts: tuple[float, ...], constant: Reals) -> Energies:
    """E(φ) = ∫ (M_d − M_r) dφ, from 0 at the beginning of the period; constant: as it was found (N·m)."""
    board, curve = period.board, period.curve
    pane = board.open_pane(ENERGY, "energy", TITLE, sizes.energy, aside=True)
    _say(period, sizes, pane)
    places = strips_of(period, contacts)
    rays, pole = board.open_pane(TORQUE, "rays", RAYS, sizes.torque, aside=True), -sizes.pole + 0j
    heights = [
        board.lay_off(0j, 1j, (_mean(curve, a, b) * period.factor((a + b) / 2) + constant) / sizes.torque.value)
        for a, b in pairwise(places)
    ]
    _rays(period, rays, pole, heights)
    here: Points = 0j
    points: list[Points] = [here]
    for height, b in zip(heights, places[1:], strict=True):
        chord = board.parallel(here, unit(height - pole))
        foot = board.to_paper_across(pane, b) + 0j
        here = board.meet(chord, Line(foot, 1j), Words("弦与纵线的交点", "the chord on its ordinate"))
        points.append(here)
    _ink(period, pane, places, points)
    return Energies(pane=pane, places=places, points=tuple(points))


def _mean(curve: French, a: float, b: float) -> float:
    """The mean ordinate of a strip (N·m)."""
    return (curve.work(b, 0.0) - curve.work(a, 0.0)) / (b - a)


def _rays(period: Period, pane: Pane, pole: complex, heights: list[Points]) -> None:
    """From the pole to every height on the M axis."""
    board, spots = period.board, [complex(nominal(height)) for height in heights]
    top, low = max(0.0, *(spot.imag for spot in spots)), min(0.0, *(spot.imag for spot in spots))
    board.arrow(pane, 1j * (low - BEYOND / 2), 1j * (top + BEYOND), Role.DIRECTION)
    board.plot(pane, 1j * (top + BEYOND), "M", Dot.NONE)
    board.plot(pane, pole, "P", Dot.POLE)
    board.join(pane, pole, 0j, Role.DIRECTION)
    for height in heights:
        board.join(pane, pole, height, Role.CONSTRUCTION)
    for at, strips in _named(spots):
        board.plot(pane, at, strips, Dot.NONE)


def _named(spots: list[complex]) -> Iterator[tuple[complex, str]]:
    """Each ray by the numbers of its strips, whose chord is parallel to it; of rays that lie too close all."""
    rays: list[tuple[complex, list[int]]] = []
    for number, at in sorted(enumerate(spots, 1), key=lambda one: one[1].imag):
        if rays and abs(at - rays[-1][0]) < TOLD:
            rays[-1][1].append(number)
        else:
            rays.append((at, [number]))
    for at, strips in rays:
        yield at, ", ".join(f"{run[0]}–{run[-1]}" if len(run) > 1 else f"{run[0]}" for run in runs(sorted(strips)))


def _say(period: Period, sizes: Sizes, pane: Pane) -> None:
    board = period.board
    board.step(
        Words(
            "图解积分：将力矩线图分成窄条（力矩变化快处取得更窄），取各条中盈余力矩的平均高度；极距 "
            f"$H$ = {sizes.pole:g} mm，自极点 $P$ 引射线至各平均高度在 $M$ 轴上的投影（射线旁注窄条的序号），在 "
            "$E$–$φ$ 图中依次作其平行线。",
            "Graphical integration: divide the diagram of moments into strips, narrower ones where the moment changes "
            "fast, and take the mean height of the surplus moment in each. With the pole distance "
            f"$H$ = {sizes.pole:g} mm draw rays from the pole $P$ to these heights on the $M$ axis, each by the number "
            "of its strip, and chords parallel to them in the $E$–$φ$ diagram.",
        ),
        pane,
    )
    span = magnitude("H", sizes.pole, "mm")
    expr = span * magnitude("μ_M", sizes.torque.value, "N·m/mm") * magnitude("μ_φ", sizes.torque.right.value, "rad/mm")
    board.compute(board.scale_of(pane).symbol, expr, "J/mm")


def _ink(period: Period, pane: Pane, places: tuple[float, ...], points: list[Points]) -> None:
    board, curve = period.board, period.curve
    heights = [complex(nominal(point)).imag for point in points]
    wide = float(board.to_paper_across(pane, curve.period))
    axes = Axes(wide=wide, low=min(heights), high=max(heights), across="φ", up="E")
    draw_axes(board, pane, axes, angle_ticks(board, pane, curve.period))
    for point in points:
        board.join(pane, complex(nominal(point)).real + 0j, point, Role.CONSTRUCTION)
    corners = [0, *(i for i, psi in enumerate(places) if any(abs(psi - one) < SAME for one in curve.corners))]
    for a, b in pairwise(sorted({*corners, len(points) - 1})):
        if b > a:
            board.curve(pane, points[a : b + 1], Role.RESULT)
    for i in corners[1:]:
        board.plot(pane, points[i], "", Dot.POINT)
