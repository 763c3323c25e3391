"""Pictures for the text: the mechanism or device alone, reduced to fit, and the blank frames of a question sheet."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import fields
from itertools import combinations
from math import inf
from typing import Any

from ..board.construction import Construction, Figure, View
from ..board.paper.extent import extent
from ..board.paper.marks import AngleMark, Cell, Curve, Dot, FixedGuide, Mark, Note, Point, RightAngle, Role, Vector
from ..designs.base import Design
from ..devices.structure import Structure
from ..foundation.slotted import replace
from ..mechanism.model import Mechanism
from ..problem.problem import Problem
from ..words import Words
from .acting import acting
from .sizes.sized import sized

SKETCH = Words("机构简图（示意）", "The mechanism (sketch)")
DEVICE = Words("简图（示意）", "Sketch")
NOT_TO_SCALE = Words("机构示意图", "The mechanism (not to scale)")
POWERS = Words("传动简图与各处的功率", "Block diagram with the powers")
BLOCKS = 168.0  # mm, width of a block diagram
ACTS = 30.0  # mm of the width, for arrows of forces beside a mechanism
CLEAR = 6.5  # mm between two letters of a sketch
TOUCH = 0.01  # mm: nearer than this is one place
SMALL = 45.0  # mm: a sketch is not left smaller
ROOMIER = 1.4  # of the height, where letters would crowd
_HELP = {Role.CONSTRUCTION, Role.PLACE, Role.DIRECTION, Role.IDEAL, Role.HIDDEN}


def picture(problem: Problem, construction: Construction, width: float, height: float) -> Figure | None:
    """The sketch beside the statement: as given, with what acts on it; none where nothing given was drawn."""
    figure = construction.figure(View.MECHANISM) or _from_its_end(construction)
    if figure is None:
        return None
    if isinstance(problem.subject, Design):
        return None  # what is given of a synthesis are numbers; what its first steps draw is what is asked
    if not isinstance(problem.subject, Mechanism):
        drawn = _device(figure, width, height)
        return sized(problem, replace(drawn, title=NOT_TO_SCALE) if isinstance(problem.subject, Structure) else drawn)
    position = construction.steps[0].section
    marks = _given_links(figure, max(step.number for step in construction.steps if step.section == position))
    marks = _without_centres(marks, problem.subject)
    loads = problem.loads or (problem.machine.loads if problem.machine is not None else None)
    if loads is None:
        return sized(problem, reduced(figure, marks, width, height))
    plain = sized(problem, reduced(figure, marks, width - ACTS, height))
    return replace(plain, marks=plain.marks + acting(problem.subject, loads, plain, (figure, *construction.figures)))


def _from_its_end(construction: Construction) -> Figure | None:
    """A rotor without length: its masses, with r and θ."""
    return next((one for one in construction.figures if one.view.name == "end-view"), None)


def to_scale(figure: Figure) -> bool:
    """Whether lengths mean anything on it; on a block diagram they don't."""
    return bool(figure.scale.symbol and figure.scale.value)


def _given_links(figure: Figure, upto: int) -> list[Mark]:
    """The mechanism as it stands after this step, without construction lines and their letters,
    without the pressure angle, and without what a path that is traced is compared by."""
    shown = [m for m in figure.marks if getattr(m, "role", None) not in _HELP and m.step <= upto and not _drawn_on(m)]
    traced = {m.step for m in figure.marks if isinstance(m, Curve) and m.role is Role.CONSTRUCTION}
    return [m for m in shown if m.step not in traced]


def _without_centres(marks: Sequence[Mark], mech: Mechanism) -> list[Mark]:
    """Without the centre of curvature of a profile, which is for the reader to find."""
    letters = {cam.centre for cam in mech.cams}
    spots = [mark.at for mark in marks if isinstance(mark, Point) and mark.label in letters]
    return [m for m in marks if not (isinstance(m, Point) and any(abs(m.at - spot) < TOUCH for spot in spots))]


def _drawn_on(mark: Mark) -> bool:
    """Whether a mark belongs to a construction line: the letter at its end, its right angle, the pressure angle α."""
    letter = isinstance(mark, Point) and mark.dot is Dot.NONE
    return letter or isinstance(mark, RightAngle) or (isinstance(mark, AngleMark) and not mark.label.startswith("φ"))


def _device(figure: Figure, width: float, height: float) -> Figure:
    """A device as its first step draws it; a block diagram without the powers noted in it."""
    first = min(m.step for m in figure.marks)
    marks = [m for m in figure.marks if m.step == first and not (isinstance(m, Vector) and m.role is Role.RESULT)]
    blocks = any(isinstance(m, Cell) for m in marks)
    shown = [m for m in marks if not isinstance(m, Note)] if blocks else marks
    drawn = reduced(figure, shown, BLOCKS if blocks else width, height)
    return drawn if figure.name else replace(drawn, title=DEVICE)


def diagram(construction: Construction) -> Figure | None:
    """The block diagram with all that the solution wrote into it, for the text;
    none where there are drawings for a sheet."""
    figure = construction.figure(View.MECHANISM)
    if figure is None or not any(isinstance(mark, Cell) for mark in figure.marks):
        return None
    return replace(reduced(figure, figure.marks, BLOCKS, BLOCKS), title=POWERS)


def reduced(figure: Figure, marks: Sequence[Mark], width: float, height: float) -> Figure:
    """These marks of a figure, reduced so that they fit width × height mm; symbols keep their size."""
    title = SKETCH if not figure.name else figure.title
    return magnified(replace(figure, title=title, marks=tuple(marks)), _factor(marks, width, height))


def magnified(figure: Figure, factor: float) -> Figure:
    """The figure so many times as large; symbols keep their size."""
    marks = tuple(scaled(mark, factor) for mark in figure.marks)
    return replace(figure, marks=marks, scale=replace(figure.scale, value=figure.scale.value / factor))


def _factor(marks: Sequence[Mark], width: float, height: float) -> float:
    """So that the marks fit; where letters would crowd, or nothing could be seen, larger, and higher by ROOMIER."""
    across, up = (max(size, 1.0) for size in extent(marks))
    fits = min(1.0, width / across, height / up)
    wanted = max(CLEAR / _nearest(marks), SMALL / max(across, up), fits)
    return max(fits, min(wanted, width / across, ROOMIER * height / up))


def _nearest(marks: Sequence[Mark]) -> float:
    """mm between the two points with letters that are nearest to each other, those at one place aside."""
    places = [mark.at for mark in marks if isinstance(mark, Point) and mark.label]
    return min((gap for one, other in combinations(places, 2) if (gap := abs(one - other)) > TOUCH), default=inf)


def _guide_scaled(guide: FixedGuide, about: complex, factor: float) -> FixedGuide:
    """As far from the block or rack as it is; along its way reduced with a rack, as long as it is beside a block."""
    way = (guide.b - guide.a) / abs(guide.b - guide.a)
    longer = factor - 1.0 if guide.to_scale else 0.0
    a, b = (end + about * (factor - 1.0) + longer * ((end - about) / way).real * way for end in (guide.a, guide.b))
    return replace(guide, a=a, b=b, about=about * factor)


def scaled(mark: Mark, factor: float) -> Any:
    """The mark with all its places multiplied by the factor; radii of arrows and angle marks stay, and so does the way
    from a block to its guide."""
    changed: dict[str, Any] = {}
    if isinstance(mark, FixedGuide) and mark.about is not None:
        return _guide_scaled(mark, mark.about, factor)
    for f in fields(mark):
        value = getattr(mark, f.name)
        if isinstance(value, complex) and f.name in ("a", "b", "at", "centre"):
            changed[f.name] = value * factor
        elif f.name == "points":
            changed[f.name] = tuple(p * factor for p in value)
        elif f.name in ("width", "height") or (f.name == "radius" and hasattr(mark, "centre")):
            changed[f.name] = value * factor
    return replace(mark, **changed)
