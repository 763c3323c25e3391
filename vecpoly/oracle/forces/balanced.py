"""The equations of equilibrium set up and solved: what the answers are read from."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike

from ...mechanism.loads import Loads
from ...mechanism.model import Mechanism
from ..run import Run
from .acting import checked, given, sought
from .flanks import solved
from .laws.drives import unit_drive
from .laws.stands import Stands
from .pairs import pairs_of
from .refusal import Judge
from .solved import Equilibrium
from .system import System


def balanced(mech: Mechanism, loads: Loads, position: ArrayLike | None, *, strict: bool) -> Equilibrium:
    """As `forces`, which tells more."""
    from .. import solve

    checked(mech, loads)
    motion = solve(mech, position, order=2 if loads.dynamic else 1, strict=strict)
    moving = mech.drive.rate != 0.0
    rates = motion.bodies if moving else solve(unit_drive(mech), position, order=1, strict=strict).bodies
    asked = np.atleast_1d(np.asarray(mech.drive.position if position is None else position, dtype=np.float64))
    stands = Stands(mech, motion.bodies, asked)
    judge = Judge(Run(asked, strict, "mm" if mech.drive.slide else "deg", zero=mech.drive.lead))
    with np.errstate(invalid="ignore", divide="ignore", over="ignore"):  # places where it does not assemble
        system = System(
            tuple(name for name in mech.bodies if name not in mech.slot_pins),
            motion.bodies,
            pairs_of(mech, motion.bodies, rates, loads.friction),
            given(mech, loads, motion.bodies, asked),
            sought(mech, loads, motion.bodies),
            mech.scale,
            asked.size,
        )
        judge.idle(system, rates)
        skip = judge.lost.copy()
        judge.senseless(system, rates, moving)
        dry, wet, reached = solved(system, skip)
        judge.unsolved(system, dry)
        judge.locked(system, (dry, wet), reached, loads.helps, rates)
        judge.parting(system, wet)
    return Equilibrium(mech, loads, motion, rates, system, dry, wet.without(judge.lost), judge.causes, stands)
