"""Chapter 6, the drawn polygons: at the given position step by step, at chosen others as sheets."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from ...drawing.pdf import draw_pdf
from ...drawing.sheet import Sheet, sheets
from ...errors import VecpolyError
from ...solution import Solution, solve
from ...words import Lang, Words
from ..content import scales, sections
from ..flow.blocks import spoken
from ..flow.doc import SheetPage
from ..flow.table import DataTable
from ..tables import readings_table
from .numbering import SMALL, Press
from .positions import at_position
from .study import Study

POSITIONS, LOADED = 4, 3  # with forces every position fills two sheets
_APART = np.radians(12.0)
_NOTHING = 1e-6  # of the greatest value: there is no vector to draw
_ALIKE = 0.03  # of the range of a sliding drive
_CHOSEN = {"zh": ["位置", "选取理由", "比例尺"], "en": ["Position", "Why it is chosen", "Scales"]}


@dataclass(frozen=True)
class Drawn:
    """One position with its drawing, and why it was chosen."""

    phi: float
    why: Words
    solution: Solution
    sheets: tuple[Sheet, ...]


def chosen(study: Study, lang: Lang) -> list[Drawn]:
    """The given position, then those of extreme values of what is asked for, as far as they can be drawn."""
    given = study.mech.drive.position
    found = [Drawn(given, Words("题设位置", "the given position"), study.solution, _sheets(study, given, study.solution, lang))]
    for phi, why in _candidates(study):
        if len(found) == (POSITIONS if study.problem.loads is None else LOADED):
            break
        if all(_far(study, phi, other.phi) for other in found):
            drawn = _drawn(study, phi, why, lang, True) or _drawn(study, phi, why, lang, False)
            found += [drawn] if drawn else []
    return [found[0], *sorted(found[1:], key=lambda one: one.phi)]


def _drawn(study: Study, phi: float, why: Words, lang: Lang, same_scale: bool) -> Drawn | None:
    """The drawing at this position; none at a dead point, or where a figure is larger than a sheet."""
    try:
        solution = solve(at_position(study, phi, same_scale=same_scale), by=study.solution.construction.hand, repeats=0)
        return Drawn(phi, why, solution, _sheets(study, phi, solution, lang))
    except VecpolyError:
        return None


def _far(study: Study, one: float, other: float) -> bool:
    gap = abs(one - other)
    if study.mech.drive.slide:
        return gap > _ALIKE * (study.whole.high - study.whole.low)
    return bool(min(gap, abs(2 * np.pi - gap)) > _APART) if study.whole.whole else bool(gap > _APART / 3)


def _candidates(study: Study) -> Iterator[tuple[float, Words]]:
    """Places of extremes: of accelerations first, then of velocities, then of transmission angles."""
    last = study.outputs[::-1]  # the output link stands last
    order = sorted(last, key=lambda key: ("alpha", "omega", "a", "v").index(key.partition("_")[0]))
    for key in (*study.forces[:1], *order):
        found, symbol = study.extremes(key), study.whole.info(key).symbol
        size = max((abs(s.value) for s in (found.highest, found.lowest) if s is not None), default=0.0)
        spots = [s for s in (found.highest, found.lowest) if s is not None and not s.end and abs(s.value) > _NOTHING * size]
        for spot in sorted(spots, key=lambda s: -abs(s.value)):
            most = spot is found.highest
            magnitude = f"|{symbol}|" if study.whole.info(key).is_vector else symbol
            yield spot.phi, Words(f"${magnitude}$ 取最{'大' if most else '小'}值", f"${magnitude}$ is {'greatest' if most else 'least'}")
    for t in study.facts.transmissions:
        yield t.least.phi, Words(f"传动角 ${study.whole.info(t.key).symbol}$ 最小", f"the transmission angle ${study.whole.info(t.key).symbol}$ is least")


def chapter(study: Study, press: Press, drawn: list[Drawn]) -> dict[str, Any]:
    """Steps of the given position, its readings, the list of the others, all sheets."""
    press.chapter = "6"
    rows = [(study.where(one.phi), one.why.of(press.lang), scales(one.solution, press.lang)) for one in drawn]
    return {
        "positions": press.table(Words("作图的位置", "The positions drawn"), _CHOSEN[press.lang], rows, "lll"),
        "sections": sections(study.solution, press.lang, press.objects), "scales": scales(study.solution, press.lang),
        "readings": press.objects.add("tab", readings_table(study.solution, press.lang)),
        "others": _others(study, press, drawn[1:]),
        "sheets": [press.objects.add("sheet", _page(sheet, _name(study, one).of(press.lang))) for one in drawn for sheet in one.sheets],
    }


def _others(study: Study, press: Press, drawn: list[Drawn]) -> list[str]:
    """The readings at the other positions, in one table where all have the same columns; without the expected errors of the given one."""
    made = [(study.where(one.phi), _readings(study, one, press)) for one in drawn]
    rows: dict[tuple[str, ...], list[tuple[str, ...]]] = {}
    for where, table in made:
        lines = rows.setdefault(table.header[:-1], [])
        lines += [(where.split(" = ")[1] if not i else "", *row[:-1]) for i, row in enumerate(table.rows)]
    title = Words("其余位置的图解值与精确值", "Drawn and exact values at the other positions")
    return [press.table(title, [f"${study.turn.drive.symbol}$", *header], lines, "ll" + "c" * (len(header) - 3) + "rr", style=SMALL) for header, lines in rows.items()]


def _readings(study: Study, one: Drawn, press: Press) -> DataTable:
    """The readings of the output link and point, and of the balancing load."""
    told = {*study.main, *(f"p_{letter}" for letter in study.points)}
    answers = {key: answer for key, answer in one.solution.answers.items() if key in told} or one.solution.answers
    return readings_table(replace(one.solution, answers=answers), press.lang)


def _sheets(study: Study, phi: float, solution: Solution, lang: Lang) -> tuple[Sheet, ...]:
    head = study.problem.title + Words(f"（{study.where(phi)}）", f" ({study.where(phi)})")
    return sheets(solution.construction, lang=lang, title=head)


def _name(study: Study, one: Drawn) -> Words:
    """A sheet's name for the bookmarks."""
    where = spoken(study.where(one.phi))
    return Words(f"图纸：{where}", f"Sheet: {where}")


def _page(sheet: Sheet, name: str) -> SheetPage:
    return SheetPage(lambda canvas, x, y: draw_pdf(sheet.scene, canvas, x, y), wide=sheet.landscape, title=name, alt=name)
