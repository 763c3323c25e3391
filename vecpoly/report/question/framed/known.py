"""What of a drawing is given and not found: marks that rest on data alone."""

from __future__ import annotations

from collections.abc import Sequence

from ....board.acts import Act, Area, Compute, Gauge, Image, Invert, Judge, Measure, Meet, Touch, Turn
from ....board.construction import Construction, Figure
from ....board.paper.marks import Arc, Curve, Dot, FixedGuide, Ground, Mark, Outline, Point, Role, Segment, Vector
from ....designs.base import Design
from ....devices.cams.cam import Cam
from ....devices.dynamics.flywheel import Flywheel
from ....devices.dynamics.run_up import RunUp
from ....devices.eccentric_clamp import EccentricClamp
from ....devices.gears.generation import GearGeneration as Generation
from ....devices.ring_spring import RingSpring
from ....devices.vee_guide import VeeGuide
from ....devices.wedge_clamp import WedgeClamp
from ....devices.wedges import Wedges
from ....figures import View
from ....figures.characteristic import CHARACTERISTIC
from ....figures.torque import TORQUE
from ....foundation.slotted import replace
from ....problem.problem import Problem
from ...picture import scaled
from .poses import poses
from .readings import is_measured
from .shapes import cam, clamp, gear

_FOUND = (Area, Compute, Gauge, Image, Invert, Judge, Measure, Meet, Touch, Turn)
_SHAPED = (RingSpring, VeeGuide, WedgeClamp, Wedges)  # bodies whose angles are given
_HELP = (Role.CONSTRUCTION, Role.DIRECTION)
NEAR = 1e-6  # mm
_CIRCLE = 25.0  # mm, radius of the circle on which the numbers of the links stand
HALF_BLOCK = 6.0  # mm: more than a guide lies beside the line of its block
_BRACES = str.maketrans("", "", "{}")  # of a symbol: C_{1} is the point C_1
DIGITS = "0123456789°"  # with which the numbers along an axis end


def by_data(acts: tuple[Act, ...]) -> frozenset[int]:
    """The numbers of the acts that need nothing but data: no meeting, no reading, no computation."""
    found = set[int]()
    for act in acts:
        if isinstance(act, _FOUND) or not found.isdisjoint(act.inputs):
            found.add(act.number)
    return frozenset(act.number for act in acts if act.number not in found)


def given(construction: Construction, figure: Figure, problem: Problem) -> tuple[Mark, ...]:
    """What the first step that draws anything given leaves on a figure: fixed pivots, positions, angles; and points by
    the names of the data, whenever they are drawn."""
    named = {datum.symbol.translate(_BRACES) for datum in problem.given.data}
    known = by_data(construction.acts)
    marks = [mark for mark in figure.marks if mark.act in known]
    places = [mark.at for mark in marks if isinstance(mark, Point)]
    first = min((mark.step for mark in marks if isinstance(mark, Point)), default=0)
    return tuple(mark for mark in marks if (mark.step == first and _stands(mark, places)) or _is_named(mark, named))


def _is_named(mark: Mark, named: set[str]) -> bool:
    """Whether it is a point that the data name, and no letter of a line that is drawn later: of the stroke H."""
    return isinstance(mark, Point) and mark.dot is not Dot.NONE and mark.label in named


def _stands(mark: Mark, places: list[complex]) -> bool:
    """A symbol is depicted wherever it is: it is given where its point is."""
    if isinstance(mark, Ground):
        return any(abs(mark.at - place) < NEAR for place in places)
    return not (isinstance(mark, Arc) and mark.role in _HELP)


def stands(construction: Construction, figure: Figure, problem: Problem) -> tuple[Mark, ...]:
    """Fixed pivots and guides, with whose places a drawing begins: all of a mechanism, those that are given of one that
    is to be found, with the positions that it is given; of a diagram the curve that is given."""
    if isinstance(problem.subject, Flywheel | RunUp) and figure.view in (TORQUE, CHARACTERISTIC):
        return _curve(figure)
    if isinstance(problem.subject, Cam) and figure.name and figure.view is View.MECHANISM:
        return cam(problem.subject, figure)
    if isinstance(problem.subject, Generation) and figure.view is View.MECHANISM:
        return gear(problem.subject, figure)
    if isinstance(problem.subject, EccentricClamp) and figure.view in (View.MECHANISM, View.BODY):
        return clamp(figure)
    if figure.view is View.BODY:  # of wedges their outlines, whose angles are data; one that is measured would tell
        shaped = isinstance(problem.subject, _SHAPED) and not is_measured(construction, figure)
        return tuple(mark for mark in figure.marks if shaped and isinstance(mark, Outline))
    found = tuple(mark for mark in figure.marks if isinstance(mark, (Ground, FixedGuide)))
    if not isinstance(problem.subject, Design):
        return found
    told = given(construction, figure, problem)
    lines = [mark for mark in told if isinstance(mark, Segment)]
    guides = (_along(mark, lines) for mark in found if isinstance(mark, FixedGuide))
    pivots = (mark for mark in found if isinstance(mark, Ground) and mark in told)
    return (*pivots, *(guide for guide in guides if guide is not None), *(() if figure.name else poses(problem, told)))


def lettered(figure: Figure, main: Figure | None) -> Figure:
    """A figure on which the mechanism is drawn once more, its fixed pivots with their letters; main: the first."""
    if main is None or figure is main or figure.view is not View.MECHANISM or not figure.scale.value:
        return figure
    share = main.scale.value / figure.scale.value
    pivots = {mark.at for mark in figure.marks if isinstance(mark, Ground)}
    letters = [mark for mark in main.marks if isinstance(mark, Point) and mark.dot is Dot.JOINT]

    def named(mark: Mark) -> Mark:
        if not isinstance(mark, Point) or mark.label or mark.at not in pivots:
            return mark
        found = (one.label for one in letters if abs(one.at * share - mark.at) < NEAR)
        return replace(mark, label=next(found, ""))

    return replace(figure, marks=tuple(map(named, figure.marks)))


def begun(figure: Figure) -> tuple[Mark, ...]:
    """With what a figure begins that rests on no datum: the axes of an end view with their centre, the circle of a
    polygon of centres with the numbers of the links."""
    first = min(mark.step for mark in figure.marks)
    here = [mark for mark in figure.marks if mark.step == first]
    lines = [mark for mark in here if isinstance(mark, Segment) and mark.role is Role.CENTRE]
    ends = {0j, *(end for line in lines for end in (line.a, line.b))}
    axes = (mark for mark in here if isinstance(mark, Point) and mark.at in ends) if lines else ()
    numbers = [mark for mark in here if isinstance(mark, Point) and mark.label.isdigit()]
    circles = (mark for mark in here if isinstance(mark, Arc)) if numbers else ()
    return (*lines, *axes, *circles, *numbers)


def is_circle(figure: Figure) -> bool:
    """Whether it is a circle diagram: numbers of links on a circle."""
    return figure.view is View.MECHANISM and not figure.scale.value and any(isinstance(m, Arc) for m in begun(figure))


def enlarged(figure: Figure) -> Figure:
    """A circle diagram so large that lines between the numbers on it are told apart; any other figure as it is."""
    if not is_circle(figure):
        return figure
    factor = _CIRCLE / max(mark.radius for mark in begun(figure) if isinstance(mark, Arc))
    return replace(figure, marks=tuple(scaled(mark, factor) for mark in figure.marks))


def begins_at(figure: Figure) -> Point | None:
    """The point from which a polygon, or a link that is set free, is drawn: the pole, the start of the first force, the
    first joint."""
    points = [mark for mark in figure.marks if isinstance(mark, Point)]
    if pole := next((mark for mark in points if mark.dot is Dot.POLE), None):
        return pole
    if figure.view is View.BODY:
        lettered = [mark for mark in points if mark.dot in (Dot.JOINT, Dot.POINT) and mark.label]
        return min(lettered, key=lambda mark: (mark.dot is Dot.POINT, mark.label), default=None)
    first = min((mark for mark in figure.marks if isinstance(mark, Vector)), key=lambda mark: mark.step, default=None)
    if figure.view is not View.FORCE or first is None:
        return None
    letter = next((mark.label for mark in points if abs(mark.at - first.a) < NEAR), "")
    return Point(at=first.a, label=letter, dot=Dot.POLE, step=1)


def _curve(figure: Figure) -> tuple[Mark, ...]:
    """What a diagram begins with: a curve with its letter."""
    first = min(mark.step for mark in figure.marks)
    here = [mark for mark in figure.marks if mark.step == first]
    drawn = [mark for mark in here if isinstance(mark, (Segment, Curve)) and mark.role is Role.RESULT]
    ends = {mark.b for mark in here if isinstance(mark, Vector)}
    letters = (
        mark for mark in here if isinstance(mark, Point) and mark.dot is Dot.NONE and mark.label[-1] not in DIGITS
    )
    return (*drawn, *(mark for mark in letters if mark.at not in ends))


def _along(guide: FixedGuide, told: Sequence[Segment]) -> FixedGuide | None:
    """The guide with a point of the line on which the block's pin moves, where that is given: the line itself, or the
    foot of the offset that is laid off to it. Where the guide stands on the figure, the block was found."""
    way = (guide.b - guide.a) / abs(guide.b - guide.a)
    lines = [line.a for line in told if line.role is Role.CENTRE and _beside(guide, way, line.a, line.b)]
    feet = [line.b for line in told if abs(_across(line, way)) < NEAR and _beside(guide, way, line.b)]
    return next((replace(guide, about=at) for at in (*lines, *feet)), None)


def _across(line: Segment, way: complex) -> float:
    """How far a line runs along the guide (mm)."""
    return ((line.b - line.a) * way.conjugate()).real


def _beside(guide: FixedGuide, way: complex, *ends: complex) -> bool:
    """Whether these places lie on one line beside the guide, as near as the pin of its block."""
    away = [((end - guide.a) * way.conjugate()).imag for end in ends]
    return max(away) - min(away) < NEAR and abs(away[0]) < HALF_BLOCK
