"""What a template may say of a problem that is only asked: empty rows, squares to work on with the table below them."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import Any

from ...board.construction import Construction, Figure
from ...board.paper.marks import Dot, Point
from ...devices.structure import Structure
from ...figures import View
from ...foundation.slotted import replace
from ...solution import Solution
from ...words import Lang, Words
from ..content import Objects
from ..flow.base import Block
from ..flow.blocks import Drawing, Heading
from ..plates.sketch import sketch_of
from .blanks import are_lined, empty_table, is_framed
from .columns import Framed
from .equation_rows import equation_rows
from .framed.fields import FIELDS
from .framed.frames import BORDER
from .framed.known import begun, enlarged, is_circle
from .framed.readings import lined, valued
from .lined import lined as words_for
from .room import working_room
from .sketches import sketching, to_sketch
from .working import working

WORKING = Words("计算过程", "Working")
_READ, _FOUND = Words("量取结果", "Readings"), Words("结果", "Results")


def _starts(figure: Figure) -> bool:
    """Whether a force polygon, or a link that is set free, has its first point in its frame."""
    return figure.view in (View.FORCE, View.BODY) and any(isinstance(mark, Point) for mark in figure.marks)


def _has_pole(figure: Figure) -> bool:
    return any(isinstance(mark, Point) and mark.dot is Dot.POLE for mark in figure.marks)


def _circles(solution: Solution, blank: Sequence[Figure], lang: Lang) -> Iterator[Drawing]:
    """The circle diagrams that have no frame, with the numbers of the links and no line."""
    framed = {(one.view, one.name) for one in blank}
    for one in solution.construction.figures:
        if is_circle(one) and (one.view, one.name) not in framed:
            large = enlarged(one)
            yield sketch_of(replace(large, marks=begun(large)), solution, lang, sketch=True)


def _working(solution: Solution, foot: Sequence[Block], lang: Lang) -> list[Block]:
    """Squares to work on with this at their foot; frames between them where something is sketched."""
    name, room = WORKING.of(lang), working_room(solution)
    titles = to_sketch(solution, lang)
    if not (room or foot or titles):
        return []
    return sketching(name, room, titles, foot, lang) if titles else working(name, room, foot, lang)


def question(solution: Solution, sheets: Construction, lang: Lang, objects: Objects) -> dict[str, Any]:
    """Names of the rows for vector equations, of circle diagrams without a frame, and of the squares with the table of
    results at their foot, and lines for what is answered in words; whether a polygon is drawn from a pole that
    is printed in its frame (sheets), or from a point that is; whether a diagram has axes, and whether anything
    that is given stands in a frame.

    Which links a joint connects is seen on the drawing, where there is one: counting them is what is asked.
    """
    figures, blank = solution.construction.figures, sheets.figures
    framed = Framed(lined(sheets), valued(sheets))
    read = all(one.reading.mm is not None for one in solution.answers.values()) and not are_lined(
        solution, framed.lined
    )
    title, answered = _READ if read else _FOUND, words_for(solution.problem.explain, lang)
    if is_framed(solution, framed):
        foot = [*answered]
    else:
        foot = [Heading(title.of(lang), 3, lang), empty_table(solution, lang, framed), *answered]
    shown = isinstance(solution.problem.subject, Structure) and solution.construction.figure(View.MECHANISM) is not None
    told = shown and bool(solution.problem.statement.zh)  # which links drive it stands in the statement
    return ({"given": ""} if told else {}) | {
        "rows": [objects.add("rows", one) for one in equation_rows(solution, lang)],
        "circle": [objects.add("pic", one) for one in _circles(solution, blank, lang)],
        "working": [objects.add("work", one) for one in _working(solution, foot, lang)],
        "poles": any(map(_has_pole, blank)),
        "alone": len(blank) == 1,
        "axes": any(figure.view.across is not None for figure in figures),
        "starts": any(map(_starts, blank)),
        "placed": any(mark.key not in FIELDS for figure in blank for mark in figure.marks[BORDER:]),
    }
