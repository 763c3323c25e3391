"""The steps cut into beats: in each one vector is drawn, or one line is written, and it alone is pointed at."""

from __future__ import annotations

from bisect import bisect_right
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field
from itertools import accumulate
from math import inf

from ..board.acts import Act, Area, Arrow, Compute, Corner, Gauge, Locate, Measure, Plot, Rule, Swing
from ..board.acts import Leaving as Inked
from ..board.construction import Construction, Step
from ..board.paper.ink import marks_of
from ..board.paper.marks import Mark
from ..board.place import Place
from ..foundation.slotted import replace

TRAILING = (Plot, Corner)  # what is set to a vector that has been drawn: the letter at its tip, its right angle
LINES = (Rule, Swing)  # what meets in the point that a vector then goes to
FRESH = (Compute, Measure, Area, Gauge)  # what a line that has been written has not waited for
READ = (Measure, Area, Gauge)
Event = Act | int  # something done, or the number of a formula in its step


@dataclass(frozen=True, slots=True, kw_only=True)
class Beat:
    """What is done at once: acts of one step, and the numbers of the formulas that are written with them.

    number: over all steps, from 1 on.
    """

    number: int
    step: int
    acts: tuple[Act, ...]
    formulas: tuple[int, ...]

    @property
    def arrow(self) -> Arrow | None:
        """The vector that is drawn."""
        return next((act for act in self.acts if isinstance(act, Arrow) and act.shown), None)

    @property
    def sought(self) -> tuple[Place, complex] | None:
        """The one point that is sought, on its figure (mm): the tip of the vector, or the last point that was found."""
        arrow = self.arrow
        last = next((act for act in reversed(self.acts) if isinstance(act, Locate)), None)
        done, at = (arrow, arrow.b) if arrow is not None else (last, 0j if last is None else last.at)
        return None if done is None or done.head.place is None else (done.head.place, at)


@dataclass(slots=True)
class _Open:
    """The beat that is being filled."""

    acts: list[Act] = field(default_factory=list)
    formulas: list[int] = field(default_factory=list)

    @property
    def has_vector(self) -> bool:
        return any(isinstance(act, Arrow) and act.shown for act in self.acts)

    def ends_before(self, event: Event) -> bool:
        """Whether this is more than goes into one beat."""
        if isinstance(event, int):
            return bool(self.formulas) or self.has_vector
        if isinstance(event, Arrow) and event.shown:
            return self.has_vector or any(isinstance(act, LINES) for act in self.acts)
        if self.formulas and isinstance(event, FRESH):
            return not isinstance(event, Compute) or any(isinstance(act, Compute) for act in self.acts)
        return self.has_vector and not isinstance(event, TRAILING)

    @property
    def shows(self) -> bool:
        """Whether anything is to be seen of it."""
        return bool(self.formulas) or any(isinstance(act, Inked) and marks_of(act) for act in self.acts)


def beats(construction: Construction) -> tuple[Beat, ...]:
    """All beats in order; every step has one at least."""
    inside: dict[int, list[Act]] = {step.number: [] for step in construction.steps}
    lines = sorted((at, step.number) for step in construction.steps for at in step.written)
    for act in construction.acts:
        if (home := _step_of(act, lines)) in inside:
            inside[home].append(act)
    found: list[Beat] = []
    for step in construction.steps:
        for one in _cut(step, inside[step.number]):
            number = len(found) + 1
            found.append(Beat(number=number, step=step.number, acts=tuple(one.acts), formulas=tuple(one.formulas)))
    return tuple(found)


def _step_of(act: Act, lines: Sequence[tuple[int, int]]) -> int:
    """The step of an act; of what is read when all is drawn, that of the line which it is for.

    lines: of each formula the number of the act before which it was written, and its step.
    """
    following = bisect_right(lines, (act.number, inf))
    if isinstance(act, READ) and following < len(lines):
        return min(act.head.step, lines[following][1])
    return act.head.step


def _cut(step: Step, acts: Sequence[Act]) -> list[_Open]:
    """The beats of one step."""
    out = [_Open()]
    for event in _events(step, acts):
        if out[-1].ends_before(event):
            out.append(_Open())
        (out[-1].formulas if isinstance(event, int) else out[-1].acts).append(event)  # type: ignore[arg-type]
    return _joined(out)


def _joined(cut: list[_Open]) -> list[_Open]:
    """Without beats in which nothing is to be seen: their acts belong to the next, or at the end to the last."""
    out: list[_Open] = []
    waiting: list[Act] = []
    for one in cut:
        if one.shows:
            out.append(_Open([*waiting, *one.acts], one.formulas))
            waiting = []
        else:
            waiting += one.acts
    if not out:
        return [_Open(waiting)]
    out[-1].acts += waiting
    return out


def _events(step: Step, acts: Sequence[Act]) -> Iterator[Event]:
    """Acts and formulas in the order in which they came; a formula stands after the acts that were done before it."""
    standing = accumulate(step.written, max)  # revealed from above to below, though some were written later
    waiting = list(zip(standing, range(len(step.formulas)), strict=True))
    for act in acts:
        while waiting and waiting[0][0] <= act.number:
            yield waiting.pop(0)[1]
        yield act
    yield from (number for _, number in waiting)


def stepped(construction: Construction) -> Construction:
    """The same with the number of its beat wherever a mark has that of its step."""
    cut = beats(construction)
    of = {act.number: beat.number for beat in cut for act in beat.acts}
    last = {beat.step: beat.number for beat in cut}

    def anew(mark: Mark) -> Mark:
        return replace(mark, step=of.get(mark.act) or last.get(mark.step, mark.step)) if mark.step else mark

    figures = tuple(replace(one, marks=tuple(map(anew, one.marks))) for one in construction.figures)
    return replace(construction, figures=figures)
