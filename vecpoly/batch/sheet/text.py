"""The text of a question in pages of its own: paragraphs, sketch and empty equation tables, set where they will
stand."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

from ...board.construction import EquationTable
from ...board.paper.extent import extent
from ...foundation.data import data_dir
from ...report.content import Objects, beside_tables
from ...report.document import PICTURE
from ...report.flow.xml import to_flowables
from ...report.plates.sketch import sketch_of
from ...report.question.lined import lined
from ...report.question.room import room_of_lines
from ...report.question.sketch import sketched
from ...report.question.working import LEAST_ROOM, Squares
from ...report.tables import given_tables
from ...report.templates import filled
from ...solution import Solution
from ...typeset.box import MM
from ...variants.frames import beside_sheet, on_sheet
from ...words import Lang, Words
from .layout import BOTTOM, LEFT, RIGHT, TOP

WIDTH, HEIGHT = RIGHT - LEFT, TOP - BOTTOM
BLANK, LEAST = 24.0, 13.0  # mm for what is written into an equation, and where it has many terms
AROUND = 15.0  # mm above and below a diagram that is drawn where the work is done
_UNDERSCORE = 1.85  # mm in running text


@dataclass(frozen=True, slots=True)
class Placed:
    """Something set, with its lower left corner (mm)."""

    block: Any
    x: float
    y: float

    def draw(self, canvas: Any) -> None:
        """Draw it there."""
        self.block.drawOn(canvas, self.x * MM, self.y * MM)


def text_pages(solution: Solution, lang: Lang) -> tuple[tuple[Placed, ...], ...]:
    """The text of a problem, page after page."""
    objects, solution = Objects(), solution.toned({})  # a question is in black
    drawn = sketched(solution.problem, solution.construction, *PICTURE)
    beside = beside_sheet(solution.construction.figures)
    tables = [step.equation for step in solution.construction.steps if step.equation]
    context = {
        **beside_tables(solution, lang),
        "blanks": [objects.add("eq", _emptied(table, n)) for n, table in enumerate(tables, 1)],
        "data": [objects.add("tab", one) for one in given_tables(solution.problem, lang)],
        "alone": len(on_sheet(solution.construction.figures)) == 1,
        "unframed": Words("、", ", ").of(lang).join(one.title.of(lang) for one in beside),
        "picture": objects.add("pic", sketch_of(drawn, solution, lang, sketch=True)) if drawn else "",
    }
    xml = filled(f"sheet.{lang}.xml.j2", (data_dir("templates"),), {"p": context})
    need = room_of_lines(solution) + sum(extent(one.marks)[1] + AROUND for one in beside)
    blocks = [*to_flowables(xml, objects.named, lang)]
    blocks[-1:-1] = lined(solution.problem.explain, lang)  # the last is the heading over the squares
    return worked(paged(blocks), need)


def worked(pages: tuple[tuple[Placed, ...], ...], need: float) -> tuple[tuple[Placed, ...], ...]:
    """The rest of the last page squared under the heading that ends it, and one page more where that is less than the
    work needs (mm); both overleaf where the page is all but full."""
    last = pages[-1][-1]
    room = _under(last)
    if room * MM < LEAST_ROOM:
        high = last.block.wrap(WIDTH * MM, HEIGHT * MM)[1] / MM
        head = Placed(last.block, LEFT, TOP - high)
        return (*pages[:-1], pages[-1][:-1], (head, squared(_under(head))))
    more = ((squared(HEIGHT),),) if room < need else ()
    return (*pages[:-1], (*pages[-1], squared(room)), *more)


def _under(placed: Placed) -> float:
    """The room below something on its page, mm."""
    return float(placed.y - placed.block.getSpaceAfter() / MM - BOTTOM)


def squared(room: float) -> Placed:
    """Squares of this height (mm) at the foot of a page."""
    squares = Squares(room * MM)
    squares.wrap(WIDTH * MM, room * MM)
    return Placed(squares, LEFT, BOTTOM)


def paged(blocks: Sequence[Any]) -> tuple[tuple[Placed, ...], ...]:
    """Blocks under each other; what does not fit goes to the next page, a heading with what follows it."""
    pages, here, y = list[list[Placed]](), list[Placed](), TOP
    for i, block in enumerate(blocks):
        before = 0.0 if y == TOP else block.getSpaceBefore() / MM
        high = block.wrap(WIDTH * MM, HEIGHT * MM)[1] / MM
        needed = high + (_following(blocks, i) if block.keepWithNext else 0.0)
        if here and y - before - needed < BOTTOM:
            pages, here, y, before = [*pages, here], [], TOP, 0.0
        y -= before + high
        here.append(Placed(block, LEFT, y))
        y -= block.getSpaceAfter() / MM
    return tuple(tuple(page) for page in (*pages, here))


def _following(blocks: Sequence[Any], i: int) -> float:
    return float(blocks[i + 1].wrap(WIDTH * MM, HEIGHT * MM)[1]) / MM if i + 1 < len(blocks) else 0.0


def _emptied(table: EquationTable, n: int) -> EquationTable:
    """The equation under its number, by which its rows are typed in, with rows to be filled in by hand."""
    count = len(table.symbols)
    wide = max(LEAST, min(BLANK, (WIDTH - 20.0) / count - 6.0))
    line = "_" * round(wide / _UNDERSCORE)
    return EquationTable(
        symbols=table.symbols,
        signs=(f"({n})", *table.signs[1:]),
        directions=(Words.same(line),) * count,
        magnitudes=(line,) * count,
    )
