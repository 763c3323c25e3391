"""The solution of a mechanism for which no drawing method is on file (a class III group):
a sketch from the computed places, and no answers."""

from __future__ import annotations

from ....board.construction import Construction, Figure, Scale, Step, View
from ....board.paper.marks import Ground, Mark, TurnArrow
from ....cycle.sample import sample
from ....errors import NoMethodError
from ....mechanism.groups.assur import Group, decompose, hinges
from ....mechanism.model import FRAME, Mechanism
from ....problem.problem import Problem
from ....solution import Solution
from ....words import Words
from .groups_apart import sketched

_WIDE, _HIGH = 110.0, 80.0  # mm
_ARROW = 8.0


def undrawn(problem: Problem, error: NoMethodError, by: str = "drafting") -> Solution:
    """A solution without drawings, for a course report about groups of a higher class.

    Raises the error again where it is for another reason that nothing was drawn.
    """
    if not isinstance(problem.subject, Mechanism) or not higher(problem.subject) or problem.loads is not None:
        raise error
    step = Step(
        number=1,
        section=Words("机构简图", "The mechanism"),
        words=Words("由计算所得的各点位置作简图。", "The sketch shows the computed positions."),
    )
    figure = Figure(
        view=View.MECHANISM,
        title=Words("机构简图", "The mechanism"),
        scale=Scale(symbol="μ_l", value=_scale(problem.subject), unit="m"),
        marks=_marks(problem),
    )
    return Solution(
        problem, Construction(problem=problem.id, hand=by, figures=(figure,), steps=(step,), readings={}), {}
    )


def higher(mech: Mechanism) -> list[Group]:
    """The groups of class III and above."""
    return [group for group in decompose(mech) if group.kind.startswith("class")]


def _places(mech: Mechanism) -> dict[str, complex]:
    motion = sample(mech, None, mech.drive.position).motion
    return {letter: complex(motion.position(letter)) for link in mech.links for letter in link.points} | dict(
        mech.frame
    )


def _scale(mech: Mechanism) -> float:
    at = list(_places(mech).values())
    wide, high = (max(part) - min(part) for part in ([z.real for z in at], [z.imag for z in at]))
    return max(wide / _WIDE, high / _HIGH)


def _marks(problem: Problem) -> tuple[Mark, ...]:
    mech = problem.mechanism
    at, k = _places(mech), 1 / _scale(mech)
    motion = sample(mech, None, mech.drive.position).motion
    pins = tuple(hinges(mech))
    grounds = tuple(Ground(at=at[p] * k, down=-1j) for p, names in hinges(mech).items() if FRAME in names)
    bars = sketched(
        problem,
        at,
        {link.name: float(motion.angle(link.name)) for link in mech.links},
        k,
        tuple(link.name for link in mech.links),
        pins,
    )
    pivot = next((p for p, names in hinges(mech).items() if FRAME in names and mech.drive.link in names), "")
    arrow = (
        (TurnArrow(at=at[pivot] * k, radius=_ARROW, start=0.0, ccw=mech.drive.rate > 0, label=f"ω_{mech.drive.link}"),)
        if pivot and not mech.drive.slide
        else ()
    )
    return (*grounds, *bars, *arrow)
