"""What a synthesis found: every candidate as data, the valid ones moved by the exact solver, the one that is taken."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from .board.candidates import Candidate
from .board.construction import Construction
from .errors import NotAskedError
from .problem.problem import Problem
from .words import Words, bare

if TYPE_CHECKING:
    from .check.found import Verified


def plain_candidate(one: Candidate) -> dict[str, Any]:
    """A candidate as plain data: its pins in mm on paper, and why it is rejected."""
    pins = {letter: [at.real, at.imag] for letter, at in one.pins.items()}
    why = {} if one.reason is None else {"rejected": bare(one.reason.en)}
    return {"number": one.number, "valid": one.reason is None, **why, "pins_mm": pins, "values": dict(one.values)}


def verification(problem: Problem, construction: Construction) -> tuple[Verified, ...]:
    """What each valid solution does, moved by the exact solver with the lengths read on paper."""
    if not construction.candidates:
        return ()
    from .check.found import verified  # late: a whole cycle, which other problems need not

    found = (verified(problem.design, one.number, one.values, one.spread) for one in _valid(construction))
    return tuple(one for one in found if one is not None)


def linkage(problem: Problem, construction: Construction) -> Problem:
    """The solution that is taken, as a problem of its own; its lengths are those read on paper.

    Raises NotAskedError where nothing was to be found.
    """
    valid = _valid(construction)
    if construction.candidates and problem.design.take <= len(valid):
        from .check.found import linkage as built  # late, likewise

        take = problem.design.take
        if (found := built(problem.design, valid[take - 1].values, f"{problem.id}-{take}")) is not None:
            return found
    raise NotAskedError(
        Words(
            f"题目 {problem.id} 没有求出机构；只有综合题（synthesis）才有",
            f"problem {problem.id} found no mechanism; only a task of synthesis does",
        ),
        code="no-solution",
    )


def objection(problem: Problem, construction: Construction) -> Words | None:
    """That other candidates were found on paper than there are; nothing of other problems."""
    if not construction.candidates:
        return None
    from .check import candidates  # late: other problems need none of it

    return candidates.objection(problem, [one.verdict for one in construction.candidates])


def _valid(construction: Construction) -> list[Candidate]:
    return [one for one in construction.candidates if one.reason is None]
