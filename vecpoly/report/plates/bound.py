"""The sheets of a solution among the objects of its report, and the section of the text behind which each plate
stands: that before the one in which the last of its figures is begun, so that no figure shows what is long to come, and
none comes behind the answer that is read off it."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import accumulate, groupby
from typing import Any

from ...board.construction import Construction
from ...board.place import Pane, Place, view_of
from ...drawing.legend.on_sheet import with_legend
from ...drawing.sheets.sheet import Placed, Sheet, sheets
from ...solution import Solution
from ...words import Lang, Words
from ..content import Objects
from ..flow.blocks import Plate, SheetPage
from .page import sheet_page


def pages(solution: Solution, lang: Lang, objects: Objects) -> tuple[list[str], list[int]]:
    """The names of the sheets, without the results, which stand in the box of answers; and of the plates, and the pages
    before the last of them, the section (from 0) behind which each stands, in order."""
    construction, problem = solution.construction, solution.problem
    made = sheets(construction, lang=lang, title=problem.title, on=problem.paper, plates=True, bands=False)
    names = bound([with_legend(sheet) for sheet in made], construction, lang, objects)
    made_of = [objects.named[name] for name in names]
    count = max((n for n, one in enumerate(made_of, 1) if isinstance(one, Plate)), default=0)
    for one in made_of[:count]:
        if isinstance(one, SheetPage):
            one.behind, one.led = 1, True  # behind the page of text on which it is met
    homes = [_home(sheet, construction) for sheet in made[:count]]
    return names, [max(0, home - 1) for home in accumulate(homes, max)]


def bound(made: Sequence[Sheet], shown: Construction, lang: Lang, objects: Objects) -> list[str]:
    """These sheets among the objects; shown: of blank ones the blank figures, so that no word gives away the others."""
    number = shown.problem
    name = Words(f"图纸：题 {number}", f"Sheet: problem {number}").of(lang)
    return [objects.add("sheet", sheet_page(sheet, shown, name)) for sheet in made]


def with_plates(
    sections: Sequence[dict[str, Any]], names: Sequence[str], homes: Sequence[int], objects: Objects
) -> list[dict[str, Any]]:
    """The sections, each with the plates behind it, and the pages that are met before it."""
    told = [(name, home, isinstance(objects.named[name], Plate)) for name, home in zip(names, homes, strict=False)]
    return [
        one
        | {
            "before": [name for name, home, plate in told if home == n and not plate],
            "plates": [name for name, home, plate in told if home == n and plate],
        }
        for n, one in enumerate(sections)
    ]


def _home(sheet: Sheet, construction: Construction) -> int:
    begun = [n for one in sheet.figures if (n := _begun(one, construction)) is not None]
    return max(begun, default=0)


def _begun(figure: Placed, construction: Construction) -> int | None:
    """The section in which a figure is begun; None where no act draws on it."""
    steps = {act.head.step for act in construction.acts if _is_on(act.head.place, figure)}
    parts = [{step.number for step in some} for _, some in groupby(construction.steps, key=lambda one: one.section.en)]
    return next((n for n, part in enumerate(parts) if steps & part), None)


def _is_on(place: Place | None, figure: Placed) -> bool:
    name = place.name if isinstance(place, Pane) else ""
    return place is not None and view_of(place) is figure.view and name == figure.name
