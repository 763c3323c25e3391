"""A mechanism: the oracle's answer to every question of a problem, under the same key as the reading."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import cached_property, lru_cache
from typing import TYPE_CHECKING

import numpy as np

from ... import oracle
from ...errors import VecpolyError
from ...foundation.slotted import replace
from ...mechanism.asked.forces import given_value, pairs, press_named
from ...mechanism.asked.pressure import driven_links
from ...mechanism.groups.assur import hinges
from ...mechanism.loads import Loads
from ...mechanism.model import Mechanism, Prismatic, Rolling
from ...names import Rel, Sort
from ...problem.asked.asks import Ask, AskNamed
from ...problem.problem import Printed, Problem
from ..likely import natural
from ..nudged import TRIALS, nudged
from ..printed.behind import behind, way
from ..roles import refuse_wrong_roles
from ..truth import ActsAt, Values, finite, knows
from .motion import kinematic
from .weighed import weighed_values

if TYPE_CHECKING:
    from ...oracle.forces import Forces


@knows(Mechanism)
@dataclass(frozen=True)
class Exact:
    """The oracle's opinion of a problem: motion and equilibrium are solved once, when they are first wanted."""

    problem: Problem

    @cached_property
    def motion(self) -> oracle.Motion:
        """Positions, velocities, accelerations in the position drawn."""
        return oracle.solve(self.problem.mechanism)

    @cached_property
    def balance(self) -> Forces:
        """The equilibrium; raises EquilibriumError where a load does not do what the problem says of it."""
        from ...oracle.forces import forces

        mech, loads = self.problem.mechanism, self.problem.loads or Loads()
        found = forces(mech, loads)
        refuse_wrong_roles(loads, found)
        return found

    @cached_property
    def values(self) -> Values:
        """Key → exact value, of all that is asked; an efficiency of 0/0 is NaN.

        Raises NotAskedError for what else has no value with these data.
        """
        moving = kinematic(self.problem, self.motion) | self._geometric()
        known = moving | self._static() | self._reduced() | weighed_values(self.problem)
        return finite(known)

    def _reduced(self) -> Values:
        """What is asked of the mechanism as a machine."""
        machine, asked = self.problem.machine, [ask.rel.key for ask in self.problem.asks if _is_reduced(ask)]
        if machine is None or not asked:
            return {}
        from ...oracle.machine import machine_values

        return dict(machine_values(self.problem.mechanism, machine, asked))

    def _geometric(self) -> Values:
        """What follows from the position alone."""
        return self._central() | self._curved() | self._pressures()

    def _pressures(self) -> Values:
        """Pressure and transmission angles, from the constraints of the joints."""
        keys = {ask.rel.key for ask in self.problem.asks if isinstance(ask, AskNamed) and ask.rel.is_pressure}
        if not keys:
            return {}
        from ...oracle.pressure import Pressures

        known = Pressures(self.problem.mechanism)
        return {
            named.key: value(driven)
            for driven in driven_links(self.problem.mechanism)
            for named, value in ((driven.alpha, known.alpha), (driven.gamma, known.gamma))
            if named.key in keys
        }

    def _curved(self) -> Values:
        """What the rates of a link tell of the curvatures of its paths."""
        asked, curved = self.problem.curvature, [ask.rel.key for ask in self.problem.asks if _is_curved(ask)]
        if asked is None or not curved:
            return {}
        from ...oracle.curvature import Curvatures

        known = Curvatures(self.problem.mechanism, asked.link)
        stepped = known.centrodes(asked.centrodes) if asked.centrodes is not None else {}
        return {key: stepped[key] if key in stepped else known.value(key) for key in curved}

    def _central(self) -> Values:
        """Places, velocities, ratios, limit positions of instant centres;
        a centre at infinity by its direction (deg)."""
        mech, keys = (
            self.problem.mechanism,
            [ask.rel.key for ask in self.problem.asks if isinstance(ask, AskNamed) and ask.rel.is_central],
        )
        if not keys:
            return {}
        from ...oracle.centres import Centres

        centres = Centres(mech)
        return {key: centres.value(key) for key in keys}

    def _static(self) -> Values:
        """Reactions, balancing loads and the like."""
        asked = [
            ask.rel
            for ask in self.problem.asks
            if isinstance(ask, AskNamed)
            and not (ask.rel.is_central or ask.rel.is_curved or ask.rel.is_reduced or ask.rel.is_pressure)
            and ask.rel.sort is not Sort.BALANCE
        ]
        if self.problem.loads is None or not asked:
            return {}
        data = {
            named.key: value for named in asked if (value := given_value(self.problem.loads, named.key)) is not None
        }
        return data | {
            named.key: complex(value) if named.is_vector else float(value.real)
            for named in asked
            if named.key not in data
            for value in [self.balance.value(named.key)]
        }

    @cached_property
    def lines(self) -> dict[str, ActsAt]:
        """Key of every reaction asked for → where it acts; nothing of one that is zero and passes on no couple."""
        asked = {ask.rel.key for ask in self.problem.asks if isinstance(ask, AskNamed)}
        if self.problem.loads is None or not any(key.startswith("R_") for key in asked):
            return {}
        mech = self.problem.mechanism
        found: dict[str, ActsAt] = {}
        for by, on in ((by, on) for a, b in pairs(mech) for by, on in ((a, b), (b, a))):
            key = press_named(mech, by, on).key
            if key in asked:
                point, pin = complex(self.balance.line_of(key)), pin_of(mech, by, on)
                force = complex(self.balance.value(key))
                if force:
                    found[key] = ActsAt(
                        point, _tangent(point - complex(self.motion.position(pin)), force) if pin else ""
                    )
                elif not pin and (couple := float(self.balance.couple_of(key))):
                    found[key] = ActsAt(complex(self.motion.position(_slid(mech, by, on))), couple=couple)
        return found

    @property
    def likely(self) -> dict[str, float]:
        """Unit → size that the data make likely, whatever the position."""
        return natural(self.problem)

    @property
    def nearby(self) -> tuple[Values, ...]:
        """The values with nudged data."""
        return _nearby(self.problem)

    def known(self, rel: Rel) -> complex | float | None:
        """What the motion has of a velocity, an acceleration, ω or α."""
        try:
            value = self.motion.value(rel)
        except VecpolyError:
            return None  # a point that was only thought, for the construction's sake
        return complex(value) if rel.is_vector else float(np.real(value))

    def behind(self) -> Callable[[Printed], float | None]:
        """Sizes behind printed answers."""
        return behind(self.problem)

    def way(self) -> Callable[[Printed], complex | None]:
        """Vectors behind printed answers."""
        return way(self.problem)


def _is_curved(ask: Ask) -> bool:
    return isinstance(ask, AskNamed) and ask.rel.is_curved


def _is_reduced(ask: Ask) -> bool:
    return isinstance(ask, AskNamed) and ask.rel.is_reduced


@lru_cache(maxsize=512)
def _nearby(problem: Problem) -> tuple[Values, ...]:
    """The exact values with nudged data: the same whatever hand draws the problem, so they are found once."""
    rng = np.random.default_rng(0)
    mech = _placed(problem.mechanism)
    nudges = [replace(problem, subject=nudged(mech, rng)) for _ in range(TRIALS)]
    return tuple(values for one in nudges if (values := _values(one)) is not None)


def _placed(mech: Mechanism) -> Mechanism:
    """The mechanism with the places of its points, where a group is solved by iteration and none rolls."""
    rolls = any(isinstance(joint, Rolling) for joint in mech.joints)
    return oracle.placed(mech) if oracle.is_iterated(mech) and not rolls else mech


def _values(problem: Problem) -> Values | None:
    """The exact values; None where the end of a range lies within the nudge."""
    try:
        return Exact(problem).values
    except VecpolyError:
        return None


def pin_of(mech: Mechanism, a: str, b: str) -> str:
    """The letter of the hinge between two links; "" where they slide or touch."""
    return next((point for point, names in hinges(mech).items() if a in names and b in names), "")


def _slid(mech: Mechanism, a: str, b: str) -> str:
    """The letter of the pin of a sliding pair's block."""
    return next(
        joint.pin for joint in mech.joints if isinstance(joint, Prismatic) and {joint.guide, joint.block} == {a, b}
    )


def _tangent(arm: complex, force: complex) -> str:
    """ccw or cw by the sign of the moment; "" where the force passes through the pin but for rounding."""
    moment = (arm.conjugate() * force).imag
    if abs(moment) <= 1e-9 * abs(force):
        return ""
    return "ccw" if moment > 0 else "cw"
