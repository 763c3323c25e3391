"""The link that drives by its load where it is not the one whose position is the variable:
dead points, transmission angle."""

from __future__ import annotations

from dataclasses import dataclass
from math import pi, radians

import numpy as np
from numpy.typing import NDArray

from ..cycle.facts.duties import duties, idle
from ..cycle.facts.transmission import angle_of, folded, is_told
from ..cycle.facts.transmission_range import USUAL
from ..cycle.root import ridders
from ..cycle.sample import sample
from ..errors import VecpolyError
from ..foundation.slotted import replace
from ..mechanism.groups.assur import Dyad, decompose, ends, hinges
from ..mechanism.model import FRAME, Drive, Mechanism, Prismatic
from .study.study import Study

_POOR = radians(USUAL)
_GRID = 1441
Reals = NDArray[np.float64]


@dataclass(frozen=True, slots=True)
class Driven:
    """A link driven by these loads at the given position; dead: where their power vanishes (rad, or m).

    pair: the links between which the last group's transmission angle lies;
    gamma: its least and greatest value, poor: where it is below 40°.
    """

    link: str
    names: tuple[str, ...]
    dead: tuple[float, ...]
    pair: tuple[str, str]
    gamma: tuple[float, float] | None
    poor: tuple[tuple[float, float], ...]


def driven(study: Study) -> Driven | None:
    """None where the load that drives acts on the driving link itself, or on a link that is not on the frame."""
    loads, mech = study.problem.loads, study.mech
    turn = study.whole.period
    here = next((d for d in duties(study.whole) if not d.cause and d.holds(mech.drive.position, turn)), None)
    if loads is None or here is None or len(here.drives) != 1:
        return None
    load = next(load for load in loads.all if load.name == here.drives[0])
    if load.link == mech.drive.link or load.link not in _on_frame(mech):
        return None
    dyad = _last(mech, load.link)
    low, high, poor = _gamma(study, dyad) if dyad else (0.0, 0.0, ())
    pair = (mech.number(dyad.link_j), mech.number(dyad.link_k)) if dyad else ("", "")
    first, second = sorted(pair)
    return Driven(
        load.link, here.drives, idle(study.whole, load.name), (first, second), (low, high) if dyad else None, poor
    )


def _on_frame(mech: Mechanism) -> dict[str, bool]:
    """Links on the frame, and whether they slide there."""
    found = {name: False for names in hinges(mech).values() if FRAME in names for name in names if name != FRAME}
    return found | {
        name: True
        for joint in mech.joints
        if isinstance(joint, Prismatic) and FRAME in ends(joint)
        for name in ends(joint)
        if name != FRAME
    }


def _last(mech: Mechanism, link: str) -> Dyad | None:
    """The group that holds the former driving link when this link drives."""
    try:
        groups = decompose(
            replace(mech, drives=(Drive(link=link, position=0.0, rate=1.0, slide=_on_frame(mech)[link]),))
        )
    except VecpolyError:
        return None
    dyad = next((g.dyad for g in groups if g.dyad is not None and mech.drive.link in g.links), None)
    return dyad if dyad is not None and is_told(mech, dyad) else None


def _gamma(study: Study, dyad: Dyad) -> tuple[float, float, tuple[tuple[float, float], ...]]:
    """Least and greatest angle, and the stretches in which it is below 40°."""

    def angle(phi: Reals) -> Reals:
        return folded(np.broadcast_to(angle_of(sample(study.mech, None, phi).motion, dyad), phi.shape))

    phi = np.linspace(study.whole.low, study.whole.high, _GRID)
    gamma = angle(phi)
    less = gamma < _POOR
    change = np.flatnonzero(less[:-1] != less[1:])
    edges = [float(q) for q in ridders(lambda q: angle(q) - _POOR, phi[change], phi[change + 1])]
    dead = np.array([phi[int(np.argmin(gamma))]])
    least = float(np.min(gamma))
    near = _refined(angle, float(dead[0]), float(phi[1] - phi[0]))
    if less[0] and edges:
        edges = [*edges[1:], edges[0] + 2 * pi] if study.whole.whole else [float(phi[0]), *edges]
    if len(edges) % 2:
        edges.append(float(phi[-1]))
    return (
        min(least, near),
        float(np.nanmax(gamma)),
        tuple((a, b) for a, b in zip(edges[::2], edges[1::2], strict=True)),
    )


def _refined(angle: object, phi: float, step: float) -> float:
    """The least angle about a place on the grid."""
    from ..cycle.root import highest

    assert callable(angle)
    at = highest(lambda q: -angle(q), np.array([phi - step]), np.array([phi + step]))
    return float(angle(at)[0])
