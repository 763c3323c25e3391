"""The stranger: exact kinematics of a mechanism over all positions of its drive, sharing nothing with the drawing.

motion = solve(mech, np.radians(np.arange(0.0, 360.0)))
motion.value(parse_rel("a_E"))
"""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike

from ..foundation.slotted import replace
from ..mechanism.model import Mechanism
from .assembly.feasible import SEARCHED
from .motion import Motion
from .planning import plan_for


def solve(mech: Mechanism, position: ArrayLike | None = None, *, order: int = 2, strict: bool = True) -> Motion:
    """The mechanism's motion at one or many positions of its drive.

    position: of the drive (rad, or m of travel), one number or a row of them; None is the problem's own. Rate and
    acceleration of the drive are the same at each. order: 0 positions, 1 velocities too, 2 accelerations too.
    strict: the first position that fails raises AssemblyError or DeadPointError; else such positions give NaN.
    Also raises MobilityError, and UnknownNameError for an unknown letter in a branch statement.
    """
    asked = np.asarray(mech.drive.position if position is None else position, dtype=np.float64)
    return Motion(
        mech, plan_for(mech, own=position is None).bodies(np.atleast_1d(asked), order, strict), asked.shape, order
    )


def feasible(mech: Mechanism) -> tuple[str, ...]:
    """The ranges of the drive in which the mechanism can be assembled, as text."""
    return plan_for(mech).ranges()


def spans(mech: Mechanism) -> tuple[tuple[float, float], ...]:
    """The same ranges as numbers (rad, or m along the guide), ends refined by bisection."""
    return plan_for(mech).spans()


def changes(mech: Mechanism) -> bool:
    """Whether a dyad has change points, beside which rates keep fewer digits (about 1e-8 of their size)."""
    return plan_for(mech).has_changes


def is_iterated(mech: Mechanism) -> bool:
    """Whether a group is solved by iteration along a path from the own position, which takes a hundred times as
    long."""
    return plan_for(mech).followed


def placed(mech: Mechanism) -> Mechanism:
    """The mechanism with the places of its points as guesses: changed a little it keeps its assembly, without a search
    of all others."""
    motion = solve(mech, order=0)
    letters = {letter for link in mech.links for letter in link.points}
    return replace(mech, guesses={letter: complex(motion.position(letter)) for letter in sorted(letters)})


__all__ = ["SEARCHED", "Motion", "changes", "feasible", "is_iterated", "placed", "solve", "spans"]
