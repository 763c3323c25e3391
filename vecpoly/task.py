"""A task: what is given, what is asked, what is drawn, what checks it. All problems come through this one door.

A sort of problem is told by its subject. Three files make one: the subject's data (`devices/`, or any `Subject`), how
it is drawn (`methods/tasks/`, registered by `@draws`),
and what is known of it from elsewhere (`check/truths/`, registered by `@knows`).
"""

from __future__ import annotations

from collections.abc import Collection, Mapping

from .board.hand import Hand
from .board.otherwise.amended import Amended
from .check.truth import OfSeveral, Truth, truth_of
from .devices.base import Device
from .drawing.sheets.paper import DrawingPaper
from .figures import View, views
from .foundation.slotted import dataclass
from .methods.desk import Desk
from .methods.drawing import Drawing, drawing_of
from .methods.drawn import Drawn
from .names import Key, Named
from .problem.problem import Problem


@dataclass(frozen=True, slots=True)
class Task:
    """A problem with its drawing, and with the truth that knows nothing of the drawing."""

    problem: Problem
    drawing: Drawing
    truth: Truth

    def given(self, drawn: Collection[View]) -> tuple[View, ...]:
        """The kinds of figure whose scale is given; a scale to the right belongs to such a kind where there is one,
        else to one that is drawn."""
        given = self.problem.scales.given
        first = {view.mu.key: view for view in reversed(views())}
        found = {first[key] for key in given if key in first}
        turned = tuple(reversed(views()))
        last = sorted(turned, key=lambda view: view in drawn)
        across = {view.across.key: view for view in last if view.across is not None}
        known = {view.across.key for view in found if view.across is not None}
        return tuple(sorted(found | {across[key] for key in given if key not in first and key not in known}))

    @property
    def asked(self) -> Mapping[str, Key]:
        """What is to be found, by its key."""
        return {ask.rel.key: ask.rel for ask in self.problem.asks}

    @property
    def turning(self) -> tuple[str, ...]:
        """Units whose sign is a sense of turning; none of a device of which only speeds are known."""
        subject = self.problem.subject
        return self.drawing.turning if not isinstance(subject, Device) or subject.sensed else ()

    def turns(self, rel: Key) -> bool:
        """Whether the sign of a quantity is a sense of turning; none is that of ω_max and ω_min of a machine, sizes of
        a speed whose drive may turn either way."""
        is_size = isinstance(rel, Named) and rel.is_reduced and rel.unit == "rad/s"
        return rel.unit in self.turning and not is_size

    @property
    def others(self) -> Mapping[int, Mapping[str, float]]:
        """The number of each solution that serves as well as the one that is taken → key → its value; mostly none."""
        return self.truth.others if isinstance(self.truth, OfSeveral) else {}

    def draw(self, by: Hand, amended: Amended, sketch: Desk | None = None) -> Drawn:
        """The construction, each figure as large as its place on the sheet allows;
        sketch: of this problem, where there is one."""
        return self.drawing.draw(self.problem, by, DrawingPaper(self.problem.paper), amended, sketch)


def task_of(problem: Problem) -> Task:
    """The task that a problem sets.

    Raises NoMethodError where nobody draws such a problem, NotAskedError where nobody checks it.
    """
    return Task(problem, drawing_of(problem), truth_of(problem))
