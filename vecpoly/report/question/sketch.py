"""The sketch beside a question: the mechanism; of one that is to be found, what is given of it."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from ...board.construction import Construction, Figure, View
from ...board.paper.marks import AngleMark, Ground, Mark, Plate, Point, Role, Segment
from ...board.paper.tones import key_of, whose
from ...designs.base import Design
from ...designs.inversion.cognates import Cognates
from ...designs.limit_lines import LimitLines
from ...designs.straight_line import StraightLine
from ...figures.hue import Hue
from ...foundation.frozen import FrozenMap
from ...foundation.slotted import replace
from ...problem.problem import Problem
from ...words import Words
from ..picture import SKETCH, picture, reduced
from ..sizes.coordinates import coordinates
from ..sizes.limits import lines_of_limits
from ..sizes.sized import sized
from .assembled import assembled
from .framed.known import NEAR, given
from .whole import whole

GIVEN = Words("已知条件（示意）", "What is given (sketch)")
LOW = 0.72  # of the height of other sketches
_FEWEST = 3  # places and lines that are worth a picture


def sketched(problem: Problem, construction: Construction, width: float, height: float) -> Figure | None:
    """The picture of a question, to fit width × height mm; None where nothing given can be drawn."""
    drawn = _sketched(problem, construction, width, height)
    return None if drawn is None else _untoned(drawn)


def _untoned(figure: Figure) -> Figure:
    """In black, where nothing on it is told apart by its tone: beside a question in black and a solution in colours
    stands one figure, which is drawn once."""
    if not figure.tones or figure.view.tint is not Hue.PLATE or figure.view.across is not None:
        return figure
    known = {whose(key) for mark in figure.marks for key in (mark.key, key_of(mark))}
    return replace(figure, tones=FrozenMap({})) if known.isdisjoint(figure.tones) else figure


def _sketched(problem: Problem, construction: Construction, width: float, height: float) -> Figure | None:
    figure = construction.figure(View.MECHANISM)
    if isinstance(problem.subject, StraightLine | Cognates) and figure is not None:
        return sized(problem, replace(reduced(figure, linkage(figure), width, LOW * height), title=SKETCH))
    if not isinstance(problem.subject, Design) or figure is None:
        return picture(problem, construction, width, height)
    if (drawn := whole(problem, width, LOW * height)) is not None:
        return drawn
    found = [mark for mark in given(construction, figure, problem) if getattr(mark, "role", None) is not Role.OTHER]
    letters = {mark.at: mark.label.partition("_") for mark in found if isinstance(mark, Point)}
    marks = [_fine(mark) for mark in found if not _is_chord(mark, letters)]
    if isinstance(problem.subject, LimitLines):
        return _limits(problem.subject, reduced(figure, marks, width / 2, LOW * height))
    if sum(isinstance(mark, (Point, Segment)) for mark in marks) < _FEWEST:
        return None
    marks += assembled(problem.subject, figure, marks)
    marks += coordinates(problem.subject, figure, marks)
    return sized(problem, replace(reduced(figure, marks, width, height), title=GIVEN))


def _limits(subject: LimitLines, figure: Figure) -> Figure:
    """Two places of a pin with the directions of the coupler there."""
    return replace(figure, marks=(*figure.marks, *lines_of_limits(subject, figure.marks)), title=GIVEN)


def linkage(figure: Figure) -> list[Mark]:
    """A mechanism that is given whole, in the first of its positions that is drawn in full; of the points of several
    positions that of this one, without its number."""
    bars = [mark for mark in figure.marks if isinstance(mark, Segment) and mark.role is Role.LINK]
    first = min((bar.step for bar in bars), default=0)
    bars = [bar for bar in bars if bar.step == first]
    plates = [mark for mark in figure.marks if isinstance(mark, Plate) and mark.step == first]
    ends = [end for bar in bars for end in (bar.a, bar.b)] + [corner for plate in plates for corner in plate.points]
    points = [mark for mark in figure.marks if isinstance(mark, Point) and mark.label and _is_at(mark.at, ends)]
    pivots = [mark for mark in figure.marks if isinstance(mark, Ground) and _is_at(mark.at, ends)]
    return [*plates, *bars, *(replace(mark, label=mark.label.partition("_")[0]) for mark in points), *pivots]


def _is_at(place: complex, ends: Sequence[complex]) -> bool:
    return any(abs(place - end) < NEAR for end in ends)


def _is_chord(mark: Mark, letters: Mapping[complex, tuple[str, str, str]]) -> bool:
    """Whether a line of help joins two places of one point: C_1 C_2, which is no link."""
    if not isinstance(mark, Segment) or mark.role is not Role.CONSTRUCTION:
        return False
    (one, _, first), (other, _, second) = (letters.get(end, ("", "", "")) for end in (mark.a, mark.b))
    return bool(one) and one == other and first != second


def _fine(mark: Mark) -> Mark:
    """Another position of a link in a fine line that is given, not in one of help; an angle by its name alone: its size
    stands in the data, or is to be worked out from them."""
    if isinstance(mark, AngleMark):
        return replace(mark, label=mark.label.partition("=")[0].rstrip())
    return replace(mark, role=Role.GIVEN) if isinstance(mark, Segment) and mark.role is Role.CONSTRUCTION else mark
