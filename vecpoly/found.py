"""What a synthesis found: its candidates as data, each solution moved by the exact solver, or as a problem of its "
"own."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

from .board.candidates import Candidate
from .errors import NotAskedError
from .problem.problem import Problem
from .words import Words, bare

if TYPE_CHECKING:
    from .check.found import Verified


def candidate_json(one: Candidate) -> dict[str, Any]:
    """A candidate as plain data: its pins in mm on paper, and why it is rejected."""
    pins = {letter: [at.real, at.imag] for letter, at in one.pins.items()}
    why = {} if one.reason is None else {"rejected": bare(one.reason.en)}
    return {"number": one.number, "valid": one.reason is None, **why, "pins_mm": pins, "values": dict(one.values)}


def verification(problem: Problem, candidates: Sequence[Candidate]) -> tuple[Verified, ...]:
    """What each valid solution does, moved by the exact solver with the lengths read on paper; nothing of other
    problems."""
    if not candidates:
        return ()
    from .check.found import verified  # late: a whole cycle, which other problems need not

    found = (verified(problem.design, one.number, one.values, one.spread, one.lost) for one in _valid(candidates))
    return tuple(one for one in found if one is not None)


def taken(problem: Problem, candidates: Sequence[Candidate]) -> Candidate | None:
    """The solution that is taken; None where there are not so many, or nothing was to be found."""
    valid = _valid(candidates)
    return valid[problem.design.take - 1] if valid and problem.design.take <= len(valid) else None


def linkage(problem: Problem, candidates: Sequence[Candidate]) -> Problem:
    """The solution that is taken, as a problem of its own; raises NotAskedError where nothing was to be found."""
    one = taken(problem, candidates)
    if one is not None:
        from .check.found import linkage as made  # late, likewise

        name, title = f"{problem.id}-{problem.design.take}", _titled(problem, len(_valid(candidates)))
        if (found := made(problem.design, one.values, name, title)) is not None:
            return found
    raise NotAskedError(
        Words(
            f"题目 {problem.id} 没有求出机构；只有综合题（synthesis）才有",
            f"problem {problem.id} found no mechanism; only a task of synthesis does",
        ),
        code="no-solution",
    )


def _titled(problem: Problem, count: int) -> Words:
    """The motion of the linkage that was found: of several, of that with this number."""
    title, take = Words("所求机构的运动分析", "Motion of the linkage that was found"), problem.design.take
    return title + Words(f"（解 {take}）", f" (solution {take})") if count > 1 else title


def objection(problem: Problem, candidates: Sequence[Candidate]) -> Words | None:
    """That a synthesis found other candidates on paper than there are; nothing of other problems."""
    if not candidates:
        return None
    from .check.candidates import objection as told  # late: other problems need none of it

    return told(problem, {one.number: one.verdict for one in candidates})


def _valid(candidates: Sequence[Candidate]) -> list[Candidate]:
    return [one for one in candidates if one.reason is None]
