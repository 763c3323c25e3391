"""What all chapters of a project's report share: the project, the press, the sheets with their numbers."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

from ...drawing.legend.on_sheet import with_legend
from ...drawing.sheets.sheet import Sheet, bound, sheets
from ...findings.study.study import Study
from ...project.demand import Demand
from ...project.part import Part
from ...project.project import Project
from ...solution import Solution
from ...units.reckoning import Amount
from ...words import Lang, Words
from ..course.numbering import Press
from ..flow.blocks import Plate, SheetPage, spoken
from ..plates.page import sheet_page

APPENDIX = "A"  # where the sheets are bound


@dataclass(frozen=True, kw_only=True)
class Drawn:
    """One drawing: its title, which ends with the position; the position alone (empty but for a mechanism); its
    solution; its sheets and their numbers."""

    title: Words
    where: str
    solution: Solution
    sheets: tuple[Sheet, ...]
    names: tuple[Words, ...]


@dataclass(frozen=True, kw_only=True)
class Binder:
    """A project's report in one language, while it is made."""

    project: Project
    press: Press
    drawn: Mapping[str, tuple[Drawn, ...]]

    @property
    def lang(self) -> Lang:
        return self.press.lang

    def numbers(self, part: Part, *, every: bool = True) -> str:
        """图 A-1、图 A-2: the sheets of a part, or of its first drawing."""
        drawn = self.drawn[part.name] if every else self.drawn[part.name][:1]
        return self.listed([name.of(self.lang) for one in drawn for name in one.names])

    def listed(self, texts: list[str]) -> str:
        return ("、" if self.lang == "zh" else ", ").join(texts)


def binder(project: Project, press: Press) -> Binder:
    """Draw all sheets and number them through."""
    press.chapter = APPENDIX
    drawn = {part.name: tuple(_drawn(part, press)) for part in project.parts}
    return Binder(project=project, press=press, drawn=drawn)


def _drawn(part: Part, press: Press) -> list[Drawn]:
    if not part.moves:
        return [_one(part.solution, part.problem.title, "", press)]
    return [_at(part.study, one.phi, one.solution, press) for one in part.positions]


def _at(study: Study, phi: float, solution: Solution, press: Press) -> Drawn:
    where, title = study.where(phi), solution.problem.title
    return _one(solution, Words(f"{title.zh}（{where}）", f"{title.en} ({where})"), where, press)


def _one(solution: Solution, title: Words, where: str, press: Press) -> Drawn:
    bare = sheets(solution.construction, lang=press.lang, title=title, on=solution.problem.paper, plates=True)
    made = tuple(with_legend(sheet) for sheet in bare)
    return Drawn(title=title, where=where, solution=solution, sheets=made, names=tuple(press.sheet() for _ in made))


def pages(binder: Binder) -> list[str]:
    """All sheets as they are bound at the end, put among the objects of the report."""
    loose = [
        (drawn, sheet, name)
        for drawings in binder.drawn.values()
        for drawn in drawings
        for sheet, name in zip(drawn.sheets, drawn.names, strict=True)
    ]
    whole = bound([sheet for _, sheet, _ in loose], [name for _, _, name in loose])
    return [
        binder.press.objects.add("sheet", _page(sheet, drawn, name, binder.lang))
        for (drawn, _, name), sheet in zip(loose, whole, strict=True)
    ]


def _page(sheet: Sheet, drawn: Drawn, name: Words, lang: Lang) -> SheetPage | Plate:
    title = name + Words("　", ": ") + drawn.title
    return sheet_page(sheet, drawn.solution.construction, spoken(title.of(lang)))


def amount(value: Amount, digits: int = 4) -> str:
    """A value as printed: 33.65°, 310 mm, 843.6 N·m."""
    text = value.shown(digits).replace(" deg", "°").replace("*", "·").replace("-", "−")
    return text.removesuffix(".0").replace(".0 ", " ").replace(".0°", "°")


def allowed(demand: Demand) -> str:
    """What is asked, with what it may be off by where a value is: ≥ 40°, = 210 mm ± 3 %."""
    slack = f" ± {100 * demand.within:g} %" if demand.sign == "=" else ""
    return f"{demand.sign} {amount(demand.asked)}{slack}"
