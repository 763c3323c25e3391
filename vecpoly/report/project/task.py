"""Chapter 1, the task: what is wanted, what is given of each part, what is demanded; chapter 2, the schemes."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

from ...drawing.figure import draw_figure
from ...mechanism.model import FRAME
from ...project.part import Part
from ...words import Words
from ..course.modelling.dimensions import rounded
from ..course.numbering import SMALL
from ..course.structure import chapter as structure
from ..picture import picture
from ..sources import printed_source
from ..statement.task import task as told_of
from .binder import Binder, allowed

_PICTURE = (110.0, 92.0)  # mm
_DATA = {"zh": ["部分", "已知"], "en": ["Part", "Given"]}
_DEMANDS = {"zh": ["要求", "允许值"], "en": ["Demand", "Allowed"]}
_SCHEMES = {"zh": ["方案", "优点", "缺点", "结论"], "en": ["Scheme", "Merits", "Faults", "Verdict"]}
_CHOSEN = Words("采用", "chosen")


def task(binder: Binder) -> dict[str, Any]:
    """The words of the task, its data by parts, its demands."""
    project, press, lang = binder.project, binder.press, binder.lang
    press.chapter = "1"
    rows = [(part.problem.title.of(lang), binder.listed(list(_given(part, binder)))) for part in project.parts]
    data = press.table(Words("设计数据", "The data"), _DATA[lang], rows, "ll", style=SMALL)
    asked = [(one.say.of(lang), allowed(one)) for one in project.demands]
    return {
        "statement": project.statement.of(lang),
        "source": printed_source(project.source, lang),
        "data": data,
        "demands": press.table(Words("设计要求", "The demands"), _DEMANDS[lang], asked, "ll") if asked else "",
        "parts": [(part.problem.title.of(lang), told_of(part.problem).of(lang)) for part in project.parts],
    }


def _given(part: Part, binder: Binder) -> Iterator[str]:
    """The data of a part; of a linkage that was found only its motion and loads, for its lengths are results."""
    given = part.problem.given
    own = (*given.motion, *given.loads) if part.base else given.data
    yield from (datum.of(binder.lang) for datum in own)


def schemes(binder: Binder) -> dict[str, Any]:
    """The table of schemes, and the structure of the mechanism that was chosen."""
    project, press, lang = binder.project, binder.press, binder.lang
    press.chapter = "2"
    verdict = {True: _CHOSEN.of(lang), False: "—"}
    rows = [
        (one.name.of(lang), one.merits.of(lang), one.faults.of(lang), verdict[one.chosen]) for one in project.schemes
    ]
    title = Words("方案比较", "The schemes compared")
    table = press.table(title, _SCHEMES[lang], rows, "lllc", style=SMALL) if rows else ""
    chosen = binder.listed([one.name.of(lang) for one in project.schemes if one.chosen])
    moving = next((part for part in project.parts if part.moves), None)
    built = structure.told(moving.study, press) if moving else {}
    return {"table": table, "chosen": chosen, "structure": built, "frame": FRAME}


def sketch(part: Part, binder: Binder) -> Any:
    """The mechanism of a part to a round scale."""
    figure = picture(part.problem, part.solution.construction, *_PICTURE)
    return rounded(figure) if figure else None


def scene(figure: Any, binder: Binder) -> Any:
    return draw_figure(figure, lang=binder.lang, caption=False)
