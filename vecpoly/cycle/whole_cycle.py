"""The whole cycle of a problem, or of a mechanism."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike

from ..errors import AssemblyError, MobilityError
from ..foundation.arguments import of_kind
from ..mechanism.loads import Loads
from ..mechanism.model import Mechanism
from ..problem.problem import Problem
from ..problem.without_cycle import no_cycle
from ..words import Words
from .cycle import Cycle
from .grid import range_of


def cycle(
    subject: Problem | Mechanism,
    n: int = 361,
    loads: Loads | None = None,
    points: tuple[str, ...] | None = None,
    *,
    over: ArrayLike | None = None,
) -> Cycle:
    """The whole cycle of a problem, or of a mechanism.

    n: number of positions of one turn, or of the range, both ends included; where loads need two turns to repeat
    themselves, as those of a four-stroke engine, the cycle has both. loads: instead of the problem's own. points: the
    letters to be listed in `columns` (all that move). over: positions of the drive of your own (rad, or m), in
    increasing order, instead of a whole cycle.
    Raises AssemblyError where no position can be assembled; MobilityError for a device, or where nothing is driven.
    """
    of_kind(subject, (Problem, Mechanism), Words("题目或机构", "a problem or a mechanism"))
    mech, own, name = (subject, None, "") if isinstance(subject, Mechanism) else _parts(subject)
    unbalanced = subject.acting if isinstance(subject, Problem) and subject.loads is None else None
    if not mech.drives:
        raise MobilityError(Words("没有原动件：整周分析需要 input", "no link is driven: a cycle needs an `input`"))
    if n < 2:
        raise AssemblyError(
            Words(f"{n} 个位置不成一周；至少取 2 个", f"{n} positions make no cycle; ask for at least 2")
        )
    low, high, whole = range_of(mech)
    if whole:  # it begins where what the problem tells of the drive is 0
        low, high = low + mech.drive.lead, high + mech.drive.lead
    acting = own if loads is None else loads
    known = acting or unbalanced
    turns = known.turns if whole and known is not None else 1
    high, n = high + 2 * np.pi * (turns - 1), (n - 1) * turns + 1
    phi = np.linspace(low, high, n) if over is None else np.atleast_1d(np.asarray(over, np.float64))
    return Cycle(name, mech, acting, phi, low, high, whole, points, unbalanced)


def _parts(problem: Problem) -> tuple[Mechanism, Loads | None, str]:
    if not isinstance(problem.subject, Mechanism):
        raise MobilityError(no_cycle(problem))
    return problem.subject, problem.loads, problem.id
