"""What is drawn of a problem: registered for what the problem is about by `draws`; adding the file adds it."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from typing import Protocol, TypeVar

from ..board.construction import Figure
from ..board.hand import Hand
from ..board.otherwise.amended import Amended
from ..board.place import Place, View
from ..errors import NoMethodError
from ..foundation.plugins import BySubject
from ..problem.problem import Problem
from ..words import Words
from .desk import Desk
from .drawn import Drawn

Size = tuple[float, float]


class Paper(Protocol):
    """How much room there is: all that a drawing may know of the sheet (mm)."""

    def __hash__(self) -> int: ...  # scales that were chosen for it are remembered

    def room(self, view: View, count: int = 1) -> Size:
        """What each of so many figures of a kind should fill."""
        ...

    def compose(
        self, figures: Sequence[Figure], sketched: Mapping[Place, float], given: Mapping[View, float]
    ) -> Mapping[Place, float]:
        """Round scales for the kinds of figure that have none given, and for panes with a scale of their own, with
        which the figures of a sketch, drawn at these scales, fill as few sheets as will do."""
        ...

    def exchange(
        self,
        figures: Sequence[Figure],
        sketched: Mapping[Place, float],
        given: Mapping[View, float],
        chosen: Mapping[Place, float],
        measured: Sequence[tuple[complex, complex]],
    ) -> Mapping[Place, float]:
        """These round scales of the figures of a sketch, or others for as many sheets at which what is read is larger.

        measured: the ends of lengths that are read off it."""
        ...


class Drawing(Protocol):
    """How problems of one sort are drawn. turning: units whose sign is a sense of turning."""

    @property
    def turning(self) -> tuple[str, ...]: ...

    def draw(self, problem: Problem, by: Hand, paper: Paper, amended: Amended, sketch: Desk | None = None) -> Drawn:
        """The construction, by all hands and by the ideal one. Raises AssemblyError, DeadPointError, NoMethodError."""
        ...


D = TypeVar("D", bound=Callable[[], Drawing])
_DRAWINGS: BySubject[Drawing] = BySubject("vecpoly.methods.tasks")


def draws(subject: type) -> Callable[[D], D]:
    """Register how problems about this are drawn; raises ValueError where that is on file."""

    def register(drawing: D) -> D:
        _DRAWINGS.put(subject, drawing(), "two drawings solve a problem about")
        return drawing

    return register


def drawing_of(problem: Problem) -> Drawing:
    """How this problem is drawn; raises NoMethodError where nobody knows."""
    if (drawing := _DRAWINGS.find(problem.subject)) is not None:
        return drawing
    raise NoMethodError(
        Words(
            f"没有“{type(problem.subject).__name__}”类题目的图解法；请用 @draws 登记",
            f"no drawing on file solves a problem about a {type(problem.subject).__name__}; register one by @draws",
        )
    )
