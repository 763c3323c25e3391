"""Which passes over a mechanism the questions of a problem need."""

from __future__ import annotations

from ..names import Kind
from ..problem.asked.asks import AskNamed, AskPoint, AskRel
from ..problem.problem import Problem
from .registry import Stage

_ACCELERATIONS = {Kind.A, Kind.AN, Kind.AT, Kind.AK, Kind.AR, Kind.ALPHA}
_BY_CENTRES = (Kind.V, Kind.OMEGA)


def stages(problem: Problem) -> tuple[Stage, ...]:
    """The passes that the questions need, in order."""
    rels = [ask.rel for ask in problem.asks if not isinstance(ask, AskNamed)]
    loads = problem.loads
    accelerated = (
        any(r.kind in _ACCELERATIONS for r in rels)
        or (loads is not None and loads.dynamic)
        or any(isinstance(a, AskPoint) and a.acceleration is not None for a in problem.asks)
    )
    last = (*((Stage.FORCE,) if loads is not None else ()), *((Stage.MACHINE,) if problem.machine is not None else ()))
    weighed = problem.counterweights is not None
    central, curved = needs_centres(problem), problem.curvature is not None
    pressed = any(isinstance(a, AskNamed) and a.rel.is_pressure for a in problem.asks)
    moving = needs_polygons(problem) or bool(last)
    return (
        Stage.POSITION,
        *((Stage.CENTRES,) if central else ()),
        *((Stage.CURVATURE,) if curved else ()),
        *((Stage.PRESSURE,) if pressed else ()),
        *((Stage.VELOCITY,) if moving or not (central or curved or pressed or weighed) else ()),
        *((Stage.ACCELERATION,) if accelerated else ()),
        *last,
        *((Stage.BALANCE,) if weighed else ()),
    )


def needs_centres(problem: Problem) -> bool:
    """Whether the problem asks for centres, or for what is found from them; a pole is drawn with the curvatures."""
    if problem.curvature is not None:
        return False
    asked = any(isinstance(a, AskNamed) and a.rel.is_central for a in problem.asks)
    return asked or problem.by_centres or any(isinstance(a, AskPoint) and a.slowest is not None for a in problem.asks)


def needs_polygons(problem: Problem) -> bool:
    """Whether anything is asked that centres do not give:
    accelerations, or velocities where the problem does not want them by centres."""
    return any(not _given_by_centres(problem, ask) for ask in problem.asks)


def _given_by_centres(problem: Problem, ask: object) -> bool:
    match ask:
        case AskNamed():
            return True
        case AskPoint(slowest=slowest):
            return slowest is not None
        case AskRel(rel=rel):
            return rel.kind is Kind.P or (rel.kind in _BY_CENTRES and (problem.by_centres or _of_slowest(problem, ask)))
    return False


def _of_slowest(problem: Problem, ask: AskRel) -> bool:
    """The velocity of a point that is itself found by centres."""
    return any(isinstance(a, AskPoint) and a.slowest is not None and a.at == ask.rel.to for a in problem.asks)
