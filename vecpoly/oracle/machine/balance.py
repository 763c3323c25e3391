"""Counterweights by the independence of the links' turning vectors: the common centre of mass is to stand still.

Over the positions of the drive Σ m r_S + Σ (m_c r_P + w e^{iφ}) = const is linear in the products w = m_c r_c of all
counterweights and in the constant; the masses at pivots that move follow from w, round by round.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ...errors import EquilibriumError
from ...foundation.slotted import replace
from ...mechanism.asked.counterweights import ADDED, SHARE, bearing, product, weight
from ...mechanism.counterweights import Counterweights, Passing
from ...mechanism.loads import Mass
from ...mechanism.model import Mechanism
from ...words import Words
from .. import solve
from ..forces.laws.drives import drive_range
from ..motion import Motion
from ..state import Points, Reals

STATIONS = 48
MARGIN = 0.02  # of the range, from each of its ends
LITTLE = 1e-9  # of all products: what is left of it is rounding
NOTHING = 1e-12  # of them: of a counterweight that is none


@dataclass(frozen=True, eq=False, kw_only=True)
class Hung:
    """A counterweight: w in the coordinates of its link (kg·m), and its mass (kg)."""

    of: Passing
    w: complex

    @property
    def mass(self) -> float:
        """|w| / r."""
        assert self.of.r is not None
        return abs(self.w) / self.of.r


def stations(mech: Mechanism) -> Reals:
    """Positions of the drive over all of its range (rad, or m)."""
    low, high, whole = drive_range(mech)
    edge = 0.0 if whole else MARGIN * (high - low)
    return np.linspace(low + edge, high - edge, STATIONS, endpoint=not whole)


def counterweights(mech: Mechanism, asked: Counterweights) -> tuple[Hung, ...]:
    """All counterweights. Raises EquilibriumError where the common centre of mass moves nevertheless."""
    motion = solve(mech, stations(mech))
    fixed = _summed(motion, asked.loads.masses)
    turning = [motion.bodies[one.link].unit * np.ones(STATIONS) for one in asked.mounts]
    matrix = np.stack([*turning, np.ones(STATIONS)], axis=1)
    if np.linalg.matrix_rank(matrix, LITTLE) < matrix.shape[1]:
        raise _together(mech, asked)
    found = tuple(Hung(of=one, w=0j) for one in asked.mounts)
    for _ in range(len(found) + 1):
        carried = fixed + sum((one.mass * _pivot(motion, one.of) for one in found), np.zeros(STATIONS))
        solution = np.linalg.lstsq(matrix, -carried, rcond=None)[0]
        found = tuple(replace(one, w=complex(w)) for one, w in zip(found, solution, strict=False))
    carried = fixed + sum((one.mass * _pivot(motion, one.of) for one in found), np.zeros(STATIONS))
    left = matrix[:, :-1] @ np.array([one.w for one in found]) + carried
    _refuse_moving(float(np.abs(left - left.mean()).max()), mech, asked)
    return found


def counterweight_values(mech: Mechanism, asked: Counterweights) -> dict[str, float]:
    """Every quantity by its key (SI; angles in degrees); NaN for the angle of one that is none."""
    found: dict[str, float] = {}
    every = counterweights(mech, asked)
    for one in every:
        link, no = mech.link(one.of.link), mech.number(one.of.link)
        line = link.points[one.of.towards] - link.points[one.of.outlets[0].point]
        none = abs(one.w) <= NOTHING * asked.own * mech.scale
        turn = float("nan") if none else float(np.degrees(np.angle(one.w / line)) % 360.0)
        found |= {product(no).key: abs(one.w), bearing(no).key: turn, weight(no).key: one.mass}
    added = sum(one.mass for one in every)
    return found | {ADDED.key: added, SHARE.key: added / asked.own}


def _summed(motion: Motion, masses: tuple[Mass, ...]) -> Points:
    """Σ m r_S (kg·m)."""
    parts = [one.mass * motion.bodies[one.link].point(motion.mech.link(one.link).points[one.centre])
             for one in masses]  # fmt: skip
    return np.asarray(sum(parts, np.zeros(STATIONS, np.complex128)))


def _pivot(motion: Motion, of: Passing) -> Points:
    link = motion.mech.link(of.link)
    return motion.bodies[of.link].point(link.points[of.outlets[0].point])


def _refuse_moving(moved: float, mech: Mechanism, asked: Counterweights) -> None:
    size = asked.own * mech.scale
    if moved > LITTLE * size:
        raise EquilibriumError(
            Words(
                f"加配重后总质心仍移动（Σmr 变化 {moved:.3g} kg·m），这些配重不能完全平衡此机构",
                f"with counterweights the common centre of mass still moves (Σmr by {moved:.3g} kg·m): they cannot "
                "balance this linkage",
            ),
            code="no-balance",
            numbers={"moved": moved},
        )


def _together(mech: Mechanism, asked: Counterweights) -> EquilibriumError:
    links = [mech.number(one.link) for one in asked.mounts]
    return EquilibriumError(
        Words(
            f"构件 {'、'.join(links)} 的转角不独立（如平行四边形机构），配重可任意分配，没有唯一解；请去掉其一",
            f"links {', '.join(links)} do not turn independently (as in a parallelogram): the counterweights may be "
            "shared between them at will; leave one out",
        ),
        code="no-balance",
    )
