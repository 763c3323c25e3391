"""The shapes of devices that are data and stand in their frames: the base circle of a cam, the blank of a gear, the
disc of a clamp."""

from __future__ import annotations

from math import pi

from ....board.construction import Figure
from ....board.paper.marks import Arc, Disc, Dot, FrictionCircle, Mark, Note, Point, Role, Segment, Vector
from ....devices.cams.cam import Cam
from ....devices.gears.generation import GearGeneration
from ....figures import View
from ....foundation.slotted import replace
from ....problem.problem import Problem
from ....words import Words

_DATUM = Words("齿条中线", "datum line of the rack")
_CENTRES = ("A", "O")  # of the pin of a clamp, and of its disc


def cam(subject: Cam, figure: Figure) -> tuple[Mark, ...]:
    """What a place of a cam that is drawn apart begins with: its centre, and its base circle where that is given."""
    centre = next((m for m in figure.marks if isinstance(m, Point) and m.label == "O" and m.dot is Dot.JOINT), None)
    if centre is None:
        return ()
    if subject.r0 is None:
        return (centre,)
    size = subject.r0.si / figure.scale.value
    return centre, Arc(centre=centre.at, radius=size, start=0.0, sweep=2 * pi, role=Role.CENTRE, step=1)


def completed(figure: Figure, problem: Problem) -> Figure:
    """A place of a cam with the base circle that its frame has room for, whole; any other figure as it is."""
    if not (isinstance(problem.subject, Cam) and figure.name and figure.view is View.MECHANISM):
        return figure
    first = min(mark.step for mark in figure.marks)
    return replace(figure, marks=(*figure.marks, *(replace(m, step=first) for m in cam(problem.subject, figure)[1:])))


def gear(subject: GearGeneration, figure: Figure) -> tuple[Mark, ...]:
    """With what the generation of a tooth begins: the reference circle with its letter, and the datum line of the rack,
    which x m parts."""
    circle = next(m for m in figure.marks if isinstance(m, Arc))
    letter = next(m for m in figure.marks if isinstance(m, Point) and m.dot is Dot.NONE)
    height = circle.centre + 1j * (circle.radius + subject.x * subject.m.si / figure.scale.value)
    line = Segment(a=height - circle.radius, b=height + circle.radius, role=Role.CENTRE, step=1)
    return circle, letter, line, Note(at=line.b, words=_DATUM, side=-1j, step=1)


def clamp(figure: Figure) -> tuple[Mark, ...]:
    """The disc of an eccentric clamp with its pin, friction circle, handle and the force on that, which are data; the
    whole of the first figure is."""
    first = min(mark.step for mark in figure.marks) == 1
    return tuple(mark for mark in figure.marks if first or _is_clamp(mark))


def _is_clamp(mark: Mark) -> bool:
    if isinstance(mark, Point):
        return mark.label in _CENTRES or (mark.dot is Dot.POINT and mark.at == 0j)
    if isinstance(mark, Segment | Arc):
        return mark.role is Role.LINK
    return isinstance(mark, Disc | FrictionCircle) or (isinstance(mark, Vector) and mark.role is Role.GIVEN)
