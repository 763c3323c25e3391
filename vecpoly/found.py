"""What a synthesis found: its candidates as data, each solution moved by the exact solver, or as its own problem."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any

from .board.candidates import Candidate
from .board.construction import Construction, Reading
from .errors import NotAskedError
from .mechanism.model import Mechanism
from .problem.problem import Problem
from .words import Words, bare

if TYPE_CHECKING:
    from .check.designs.found import Verified


def candidate_json(one: Candidate) -> dict[str, Any]:
    """A candidate as plain data: its pins in mm on paper, and why it is rejected."""
    pins = {letter: [round(at.real, 9) + 0.0, round(at.imag, 9) + 0.0] for letter, at in one.pins.items()}
    why = {} if one.reason is None else {"rejected": bare(one.reason.en)}
    return {"number": one.number, "valid": one.reason is None, **why, "pins_mm": pins, "values": dict(one.values)}


def found_json(construction: Construction, moved: Sequence[Verified]) -> dict[str, Any]:
    """The candidates of a synthesis and what the valid ones do, or that none serves; nothing of other problems."""
    ended = construction.conclusion
    told = {} if ended is None else {"conclusion": {"zh": bare(ended.zh), "en": bare(ended.en)}}
    if not construction.candidates:
        return told
    candidates = [candidate_json(one) for one in construction.candidates]
    return {"candidates": candidates, "verification": [one.as_json() for one in moved], **told}


def answered(problem: Problem, construction: Construction, exact: Mapping[str, object]) -> dict[str, Reading]:
    """The readings that are answers: all but those of a synthesis without a solution that have no exact value; a
    solution that is on paper alone is told by `objection`."""
    sought = _is_sought(problem)
    return {key: one for key, one in construction.readings.items() if key in exact or not sought}


def conclusion(problem: Problem, candidates: Sequence[Candidate]) -> Words | None:
    """That no candidate of a synthesis serves, and why; None where one does, and of other problems."""
    if not candidates or _valid(candidates):
        return None
    from .check.designs.unsolvable import conclusion as told  # late: other problems need none of it

    return told(problem)


def rejections(candidates: Sequence[Candidate]) -> Words | None:
    """Why candidates beside the solutions are rejected; None where none is, or where none serves (`conclusion`)."""
    if not _valid(candidates) or len(_valid(candidates)) == len(candidates):
        return None
    from .check.designs.unsolvable import rejected  # late, likewise

    return rejected((one.number, one.reason) for one in candidates if one.reason is not None)


def verification(problem: Problem, candidates: Sequence[Candidate]) -> tuple[Verified, ...]:
    """What each valid solution does, moved by the exact solver with the lengths read on paper; nothing of other
    problems."""
    if not candidates:
        return ()
    from .check.designs.found import verified  # late: a whole cycle, which other problems need not

    found = (verified(problem.design, one) for one in _valid(candidates))
    return tuple(one for one in found if one is not None)


def taken(problem: Problem, candidates: Sequence[Candidate]) -> Candidate | None:
    """The solution that is taken; None where there are not so many, or nothing was to be found."""
    valid = _valid(candidates)
    return valid[problem.design.take - 1] if valid and problem.design.take <= len(valid) else None


def linkage(problem: Problem, candidates: Sequence[Candidate]) -> Problem:
    """The solution that is taken, as a problem of its own; raises NotAskedError where nothing was to be found."""
    one = taken(problem, candidates)
    if one is not None:
        from .check.designs.found import linkage as made  # late, likewise
        from .check.designs.found import verified

        moved = verified(problem.design, one)
        if moved is not None and moved.spoilt is not None:
            raise _spoilt(problem, moved.spoilt)

        name, title = f"{problem.id}-{problem.design.take}", _titled(problem, len(_valid(candidates)))
        if (found := made(problem.design, one.values, name, title, last=one.last)) is not None:
            return found
    if candidates and not _valid(candidates):
        raise _of_no_use(problem)
    if one is not None:
        raise _no_one_linkage(problem)
    raise NotAskedError(
        Words(
            f"题目 {problem.id} 没有求出机构；只有综合题（synthesis）才有",
            f"problem {problem.id} found no mechanism; only a task of synthesis does",
        ),
        code="no-solution",
    )


def _no_one_linkage(problem: Problem) -> NotAskedError:
    return NotAskedError(
        Words(
            f"题目 {problem.id}（{problem.design.kind}）是综合题，但其结果不是一个可供继续分析的机构；要分析其中的某一"
            "机构，请按其尺寸用 frame、links 另写一题",
            f"problem {problem.id} ({problem.design.kind}) is a task of synthesis, but its result is no single linkage "
            "that could be gone on with; write the one that is meant as a problem of its own, with frame and links",
        ),
        code="no-solution",
    )


def _spoilt(problem: Problem, exactly: Words) -> NotAskedError:
    """Who reads the linkage off the paper has another one."""
    return NotAskedError(
        Words(f"题目 {problem.id} 的解 {problem.design.take} 不能继续分析：", "")
        + Words("", f"solution {problem.design.take} of problem {problem.id} cannot be gone on with: ")
        + exactly
        + Words("；或用 --hand exact", "; or use --hand exact"),
        code="spoilt",
    )


def _of_no_use(problem: Problem) -> NotAskedError:
    return NotAskedError(
        Words(
            f"题目 {problem.id} 的候选解均已舍去，没有机构可作进一步分析；请改动数据",
            f"all candidates of problem {problem.id} are rejected: there is no linkage to go on with; change the data",
        ),
        code="no-solution",
    )


def _titled(problem: Problem, count: int) -> Words:
    """The motion of the linkage that was found: of several, of that with this number."""
    title, take = Words("所求机构的运动分析", "Motion of the linkage that was found"), problem.design.take
    return title + Words(f"（解 {take}）", f" (solution {take})") if count > 1 else title


def objection(problem: Problem, candidates: Sequence[Candidate]) -> Words | None:
    """That a synthesis found other candidates on paper than there are, or none; nothing of other problems."""
    if not _is_sought(problem):
        return None
    from .check.candidates import objection as told  # late: other problems need none of it

    return told(problem, {one.number: one.verdict for one in candidates})


def _valid(candidates: Sequence[Candidate]) -> list[Candidate]:
    return [one for one in candidates if one.reason is None]


def _is_sought(problem: Problem) -> bool:
    """Whether a mechanism is to be found."""
    if isinstance(problem.subject, Mechanism):
        return False
    from .designs.base import Design  # late, likewise

    return isinstance(problem.subject, Design)
