"""What the masses do to the frame over the cycle, and what counterweights on the turning links would leave of it."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from ...cycle import Cycle, Extremes, extremes
from ...cycle.shaking import FORCE, MOMENT
from ...foundation.slotted import replace
from ...mechanism.groups.assur import pivot_of
from ...mechanism.loads import Loads, Mass
from ...oracle.machine.balance import counterweights
from ...oracle.machine.counterweighted import shaking as counterweighted
from ...words import Words
from ..study.study import Study

NOTHING = 1e-9  # of the size of the mechanism: the centre of mass is on the pivot


@dataclass(frozen=True, slots=True, kw_only=True)
class Weight:
    """The counterweight of a link that turns about a fixed pivot: m r (kg·m), opposite its centre of mass."""

    link: str
    pivot: str
    product: float


@dataclass(frozen=True, slots=True, eq=False, kw_only=True)
class Best:
    """The counterweight on the crank that leaves the least mean square force. product: m r (kg·m); angle: of its arm
    from the crank's own axis (rad); before, after: greatest force (N); mean_before, mean_after: root mean squares."""

    product: float
    angle: float
    before: float
    after: float
    mean_before: float
    mean_after: float


@dataclass(frozen=True, slots=True, eq=False, kw_only=True)
class Shaking:
    """force, moment: their extremes over the cycle. weights: of the links whose centres of mass are off their pivots;
    left: the greatest force with all of them (N), rest: the links that it comes from. best: of the crank alone, where
    it turns right round and evenly. designed: the greatest force (N) with the counterweights that the problem asks
    for, None where it asks for none."""

    force: Extremes
    moment: Extremes
    weights: tuple[Weight, ...]
    left: float
    rest: tuple[str, ...]
    best: Best | None
    designed: float | None


def shaking(study: Study) -> Shaking | Words | None:
    """Shaking force and moment; why there are none; None where there is neither mass nor load."""
    loads = study.problem.acting
    if loads is None:
        return None
    if not loads.masses:
        return Words("题目没有给出构件的质量", "no masses are given")
    if not loads.inertia:
        return Words("题目规定不计惯性力", "the problem neglects inertia forces")
    if not study.varies(FORCE.key):
        return Words("机构的惯性力不随位置变化", "the shaking force is the same all through")
    weights, force = tuple(_weights(study, loads)), study.extremes(FORCE.key)
    return Shaking(
        force=force,
        moment=study.extremes(MOMENT.key),
        weights=weights,
        left=_left(study.whole, loads, {one.link for one in weights}),
        rest=tuple(dict.fromkeys(one.link for one in loads.masses if not pivot_of(study.mech, one.link))),
        best=best(study),
        designed=_designed(study, force),
    )


def _weights(study: Study, loads: Loads) -> list[Weight]:
    """m |r_S| of every link on a fixed pivot; a link of several masses is told once for each."""
    found = []
    for mass in loads.masses:
        if (pivot := pivot_of(study.mech, mass.link)) and (arm := _arm(study, mass, pivot)) > NOTHING:
            found.append(Weight(link=mass.link, pivot=pivot, product=mass.mass * arm))
    return found


def _arm(study: Study, mass: Mass, pivot: str) -> float:
    points = study.mech.link(mass.link).points
    return float(abs(points[mass.centre] - points[pivot]))


def _left(whole: Cycle, loads: Loads, balanced: set[str]) -> float:
    """The greatest force of the masses that no counterweight holds (N): balanced, a centre of mass rests."""
    rest = replace(loads, masses=tuple(mass for mass in loads.masses if mass.link not in balanced))
    if not rest.masses or not balanced:
        return 0.0
    spot = extremes(whole.under(rest), FORCE.key).highest
    return spot.value if spot is not None else 0.0


def _designed(study: Study, without: Extremes) -> float | None:
    """The greatest force with the counterweights that the problem asks for; 0 where only rounding is left (N)."""
    asked = study.problem.counterweights
    if asked is None:
        return None
    left = counterweighted(study.mech, asked, counterweights(study.mech, asked)).largest[0]
    return left if without.highest is None or left > NOTHING * without.highest.value else 0.0


def best(study: Study) -> Best | None:
    """Least squares: of the force in the crank's own axes the mean is what a counterweight can take away."""
    drive, turn = study.mech.drive, study.turn
    if drive.slide or drive.between or drive.accel or not drive.rate or not turn.whole:
        return None
    force = np.asarray(turn.column(FORCE.key), np.complex128)[:-1]
    crank: NDArray[np.complex128] = np.exp(1j * turn.phi[:-1])
    part = complex(np.mean(force / crank))
    rest = force - part * crank
    return Best(
        product=abs(part) / drive.rate**2,
        angle=float(np.angle(-part)),
        before=float(np.abs(force).max()),
        after=float(np.abs(rest).max()),
        mean_before=float(np.sqrt(np.mean(np.abs(force) ** 2))),
        mean_after=float(np.sqrt(np.mean(np.abs(rest) ** 2))),
    )
