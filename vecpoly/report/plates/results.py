"""The results that stand on a sheet: each where the figure stands from which it was read."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Sequence

from ...algebra.formula import Node, Row, Txt
from ...board.construction import View
from ...board.ruler import READABLE
from ...drawing.legend.on_sheet import with_legend, with_legend_under
from ...drawing.sheets.boxes.results import Listed, with_results
from ...drawing.sheets.sheet import Sheet
from ...foundation.slotted import replace
from ...names import Kind, Rel
from ...solution import YES_NO, Answer, Solution
from ...words import Lang, Words
from ..answers.line import named_line
from ..answers.order import arranged, broken
from ..flow.results.grid import sentence

CONCLUSION = Words("结论", "Conclusion")
WIDE = (70.0, 100.0, 130.0, 50.0)  # mm: of the lines in which a conclusion is told
_STAR, NARROW = " *", 54.0  # mm: of the lines in which it is told what the star is for
SHORT = Words(f"* 图上不足 {READABLE:g} mm，不可靠", f"* under {READABLE:g} mm, not reliable")
_PARTS = (Kind.AN, Kind.AT, Kind.AK, Kind.AR)
_READ_FROM = {"omega": View.VELOCITY, "alpha": View.ACCELERATION}


def concluded(
    made: Sequence[Sheet], solution: Solution, lang: Lang, keys: Collection[str] | None = None, *, legend: bool = False
) -> tuple[Sheet, ...]:
    """The sheets with the answers that were read on them, where they have room; what was read on none, on the last.
    keys: of the answers that are told; None: all. legend: under them stands what lines and arrows are."""
    answers = [one for key, one in solution.answers.items() if keys is None or key in keys]
    kept = [one for one in answers if not one.is_place]
    home = {one.key: _home(one, made, solution) for one in kept}
    own = [[one for one in kept if home[one.key] == n] for n in range(len(made))]
    ended = solution.construction.conclusion
    listed = [
        _without_solution(some, solution, ended.of(lang), lang)
        if ended is not None and n == 0
        else _attempts(some, solution, lang)
        if some
        else []
        for n, some in enumerate(own)
    ]
    return tuple(_written(sheet, some, legend) for sheet, some in zip(made, listed, strict=True))


def _written(sheet: Sheet, attempts: Sequence[Sequence[Listed]], legend: bool) -> Sheet:
    """With the first of these that has room, and with a legend under it."""
    if not legend:
        return with_results(sheet, attempts) if attempts else sheet
    if not attempts:
        return with_legend(sheet)
    return with_legend_under(sheet, lambda bare: with_results(bare, attempts))


def _without_solution(answers: Sequence[Answer], solution: Solution, text: str, lang: Lang) -> list[list[Listed]]:
    """That no linkage serves, in lines as long as there is room for."""

    def lines(wide: float) -> Listed:
        heading = CONCLUSION.of(lang)
        return Listed(heading, (), lambda em: tuple(sentence(text, em, wide, lang == "zh")))

    return [[*(_listed(answers, solution, lang) if answers else []), lines(wide)] for wide in WIDE]


def _attempts(answers: Iterable[Answer], solution: Solution, lang: Lang) -> list[list[Listed]]:
    """All of them, then without yes and no, then without parts of vectors and what is relative, which stand in the
    steps, then the last of each kind, the output's; in the order of the box of answers."""
    every = list(answers)
    numbers = [one for one in every if one.reading.unit != YES_NO]
    whole = [one for one in numbers if not _is_part(one)]
    last = [*{one.rel.kind if isinstance(one.rel, Rel) else one.key: one for one in whole}.values()]
    lists = (every, numbers, whole, last)
    tried = [some for n, some in enumerate(lists) if some and some not in lists[:n]]
    return [_listed(some, solution, lang) for some in tried]


def _is_part(answer: Answer) -> bool:
    """Whether it is a part of a velocity or acceleration, or one relative to another point."""
    return isinstance(answer.rel, Rel) and (answer.rel.ref is not None or answer.rel.kind in _PARTS)


def _listed(answers: Iterable[Answer], solution: Solution, lang: Lang) -> list[Listed]:
    """What came out of each, on every sheet in the one form that has room on all: the ways to it stand in the steps."""
    idle, parts = broken(solution), list(arranged(answers))
    listed = [
        Listed(part.heading(lang, idle), tuple(_line(one, solution, lang) for one in part.answers)) for part in parts
    ]
    if any(one.short for part in parts for one in part.answers):
        listed[-1] = replace(listed[-1], said=lambda em: tuple(sentence(SHORT.of(lang), em, NARROW, lang == "zh")))
    return listed


def _line(answer: Answer, solution: Solution, lang: Lang) -> Node:
    """One of them; starred where it was read off a length that is too short."""
    line = named_line(answer, solution, lang)
    return Row((line, Txt(_STAR))) if answer.short else line


def _home(answer: Answer, made: Sequence[Sheet], solution: Solution) -> int:
    """The last sheet with a figure to whose scale it was read."""
    kind = _READ_FROM.get(answer.key.partition("_")[0])
    scales = {(figure.view, figure.name): figure.scale.symbol for figure in solution.construction.figures}
    for n in range(len(made) - 1, -1, -1):
        for one in made[n].figures:
            if one.view is kind or (answer.reading.scale and scales.get((one.view, one.name)) == answer.reading.scale):
                return n
    return len(made) - 1
