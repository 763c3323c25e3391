"""The paper on which a construction is to be drawn, as the board's planner sees it: how much room there is, and which
scales fill it."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from math import isclose

from ...board.construction import Figure, View
from ...board.paper.extent import extent, figured
from ...board.paper.marks import Disc, Dot, FixedGuide, GearMark, LinkNumber, Mark, Point, Segment, TurnArrow, Vector
from ...board.paper.scales import Sketched
from ...board.place import Pane, Place
from ...foundation.slotted import dataclass, replace
from ...foundation.stock import ANY_A4, Paper
from ..order import reading_order
from ..parted import parted
from .lettering import beside_title, lettered
from .scales.banded import over_legend, weighed
from .scales.crowding import Crowded, crowded
from .slicing import Size
from .space import room

TINY = 0.025  # of its figure: at the largest scale such a vector has its 3 mm to be measured, a shorter one has not
SAME = 0.05  # mm between points that are one


@dataclass(frozen=True, slots=True)
class DrawingPaper:
    """Sheets of this paper, upright or across; either where neither is wished."""

    on: Paper = ANY_A4

    def room(self, view: View, count: int = 1) -> Size:
        """What each of so many figures of a kind should fill (mm)."""
        return room(view, count, self.on.format)

    def compose(
        self, figures: Sequence[Figure], sketched: Mapping[Place, float], given: Mapping[View, float]
    ) -> Mapping[Place, float]:
        """Round scales for the kinds of figure that have none given, and for panes with a scale of their own, with
        which the figures of a sketch, drawn at these scales, fill as few sheets as will do, with room for details."""
        detailed, bare = _planned(figures, sketched)
        return over_legend(detailed, bare, given, self.on)

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
        detailed, _ = _planned(figures, sketched)
        arms = [_arm(figure, measured) for figure in parted(reading_order(figures))]
        read = [replace(one, arm=arm) for one, arm in zip(detailed, arms, strict=True)]
        return weighed(read, chosen, given, self.on)


def _planned(figures: Sequence[Figure], sketched: Mapping[Place, float]) -> tuple[list[Crowded], list[Sketched]]:
    """The figures of a sketch with their details, and without."""
    ordered = parted(reading_order(figures))
    bare = [_sketch(one, sketched) for one in ordered]
    return [crowded(one, figure) for one, figure in zip(bare, ordered, strict=True)], bare


def _sketch(figure: Figure, scales: Mapping[Place, float]) -> Sketched:
    """What a figure takes at any scale: a free body is drawn at the scale of the mechanism."""
    own, kind = Pane(figure.view, figure.name), View.MECHANISM if figure.view is View.BODY else figure.view
    follows = kind in scales and isclose(figure.scale.value, scales[kind], rel_tol=1e-9)
    growing = tuple(mark for mark in figured(figure.marks) if not isinstance(mark, FixedGuide))
    (w, h), (wide, high) = extent(growing), lettered(figure)
    return Sketched(
        view=figure.view,
        name=figure.name,
        of=own if own in scales else kind if follows else None,
        scale=figure.scale.value,
        size=(w, h),
        around=(wide - w, high - h),
        letters=sum(_asks_for_room(mark, figure) for mark in figure.marks),
        spare=beside_title(figure),
        short=_shortest(figure, max(w, h)),
        linked=linked(figure) if figure.scale.symbol else 0.0,  # parts of a sketch may be small
        scaled=bool(figure.scale.symbol),
    )


def _arm(figure: Figure, measured: Sequence[tuple[complex, complex]]) -> float:
    """The shortest line on a mechanism that is measured, as the arm of a couple is; 0 where it has none."""
    if figure.view is not View.MECHANISM:
        return 0.0
    lines = ((mark.a, mark.b) for mark in figure.marks if isinstance(mark, Segment))
    arms = (abs(a - b) for a, b in lines if any(_is_one((a, b), ends) for ends in measured))
    return min((arm for arm in arms if arm > SAME), default=0.0)


def _is_one(line: tuple[complex, complex], ends: tuple[complex, complex]) -> bool:
    """Whether these are the ends of the line."""
    (a, b), (c, d) = line, ends
    return min(abs(a - c) + abs(b - d), abs(a - d) + abs(b - c)) < SAME


def linked(figure: Figure) -> float:
    """How large links, joints and wheels of a mechanism are together (mm); 0 on other figures."""
    marks = (mark for mark in figured(figure.marks) if not isinstance(mark, FixedGuide))
    own = [mark for mark in marks if isinstance(mark, GearMark) or mark.owner.startswith(("link ", "joint "))]
    return max(extent(own)) if figure.view is View.MECHANISM and own else 0.0


def _shortest(figure: Figure, size: float) -> float:
    """The shortest vector of a polygon (mm), but for those that are drawn apart at any scale; of a mechanism how far
    its nearest two pins are apart, as those of short cranks and eccentrics are; 0 where it has none."""
    if figure.view is View.MECHANISM and not figure.aside:
        return nearest_pins(figure, TINY * size)
    if figure.view.bodies:
        return 0.0  # arrows there are no lengths
    lengths = (abs(mark.b - mark.a) for mark in figure.marks if isinstance(mark, Vector))
    return min((length for length in lengths if length > TINY * size), default=0.0)


def nearest_pins(figure: Figure, least: float) -> float:
    """From a pin to the next, or to the centre of a disc that turns about it; pins that all but coincide are one."""
    pins = [mark.at for mark in figure.marks if isinstance(mark, Point) and mark.dot in (Dot.JOINT, Dot.MULTIPLE)]
    discs = [mark.centre for mark in figure.marks if isinstance(mark, Disc)]
    ways = [abs(pin - other) for n, pin in enumerate(pins) for other in (*pins[n + 1 :], *discs)]
    return min((way for way in ways if way > least), default=0.0)


def _asks_for_room(mark: Mark, figure: Figure) -> bool:
    """Whether it has a label among lines; on a structural sketch the number of the frame stands under its support, and
    the arrow with α about the same pivot as that with ω."""
    if isinstance(mark, TurnArrow) and mark.label.startswith("α"):
        return False
    if isinstance(mark, LinkNumber):
        return bool(figure.scale.symbol) or mark.owner != "frame"
    return bool(getattr(mark, "label", ""))
