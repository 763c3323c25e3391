"""Chapter 6, the drawn polygons: at the given position step by step, at chosen others as sheets."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np

from ....drawing.sheets.sheet import Sheet, bound, sheets
from ....errors import VecpolyError
from ....findings.study.study import Study
from ....foundation.slotted import replace
from ....printed.midway import some_go_down
from ....solution import Answer, Solution
from ....words import Lang, Words
from ...answers.notes import unread_words
from ...answers.placed import endless_words, place_words
from ...answers.tables import lone_place, readings_at, readings_tables
from ...content import scales
from ...flow.blocks import Plate, SheetPage, spoken
from ...plates.page import sheet_page
from ...plates.results import concluded
from ...steps.sections import sections
from ..analysis.force_words import role_note
from ..numbering import SMALL, Press
from .cramped import cramped
from .drawn_views import drawn_views
from .elsewhere import own_steps
from .positions import at_position, draw_there
from .repeated import without_repeated

POSITIONS, LOADED = 4, 3  # with forces, or centres beside polygons, every position fills two sheets
_APART = np.radians(12.0)
_NOTHING = 1e-6  # of the greatest value: there is no vector to draw
_ALIKE = 0.03  # of the range of a sliding drive
_QUARTER = Words("由题设位置转过 90°，供比较", "90° on from the given position, for comparison")
_CHOSEN = {"zh": ["位置", "选取理由", "比例尺", "图号"], "en": ["Position", "Why it is chosen", "Scales", "Sheet"]}


@dataclass(frozen=True)
class Drawn:
    """One position with its drawing, and why it was chosen."""

    phi: float
    why: Words
    solution: Solution
    sheets: tuple[Sheet, ...]


def chosen(study: Study, lang: Lang) -> list[Drawn]:
    """The given position, then those of extreme values of what is asked for,
    as far as they can be drawn; none where there is no method."""
    if not study.drawn:
        return []
    given = study.mech.drive.position
    first = _sheets(study, given, study.solution, lang)
    found = [Drawn(given, Words("题设位置", "the given position"), study.solution, first)]
    for phi, why in (*_candidates(study), *_quarter(study)):
        if len(found) == (POSITIONS if study.problem.loads is None and len(found[0].sheets) == 1 else LOADED):
            break
        if why == _QUARTER and len(found) > 1:
            break  # there are places of extreme values
        if all(_far(study, phi, other.phi) for other in found):
            drawn = _drawn(study, phi, why, lang, True)
            if drawn is None or (len(drawn.sheets) > 1 and study.problem.loads is None):
                own = _drawn(study, phi, why, lang, False)  # at a scale of its own it may need one sheet only
                drawn = _fewer(drawn, own)
            found += [drawn] if drawn else []
    return _in_order([found[0], *sorted(found[1:], key=lambda one: one.phi)], study, lang)


def _fewer(one: Drawn | None, own: Drawn | None) -> Drawn | None:
    """The one with fewer sheets, unless they cost too much."""
    if one is None or own is None:
        return one or own
    saved = len(own.sheets) < len(one.sheets)
    return own if saved and not cramped(own.solution.construction, one.solution.construction) else one


def _in_order(drawn: list[Drawn], study: Study, lang: Lang) -> list[Drawn]:
    """Sheets of one kind: a plate among pages would stand in the text, out of its turn."""
    if len({sheet.plate for one in drawn for sheet in one.sheets}) == 1:
        return drawn
    return [replace(one, sheets=_sheets(study, one.phi, one.solution, lang, plates=False)) for one in drawn]


def _drawn(study: Study, phi: float, why: Words, lang: Lang, same_scale: bool) -> Drawn | None:
    """The drawing at this position; none at a dead point, or where a figure is larger than a sheet."""
    try:
        given = study.solution.construction
        found = draw_there(at_position(study, phi, same_scale=same_scale), given.hand)
        solution = found.toned({**found.construction.tones, **given.tones})  # one vector, one ink in all positions
        solution = replace(solution, answers=_as_sure(solution.answers, study.solution.answers))
        return Drawn(phi, why, solution, _sheets(study, phi, solution, lang))
    except VecpolyError:
        return None


def _as_sure(there: Mapping[str, Answer], here: Mapping[str, Answer]) -> dict[str, Answer]:
    """The answers as sure as those of the given position, which alone was drawn again and again: a hand reads as
    coarsely everywhere, and so every table has as many decimals."""
    return {
        key: replace(one, expected_error=here[key].expected_error) if key in here and not one.computed else one
        for key, one in there.items()
    }


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
        spots = [
            s for s in (found.highest, found.lowest) if s is not None and not s.end and abs(s.value) > _NOTHING * size
        ]
        magnitude = f"|{symbol}|" if study.whole.info(key).is_vector else symbol
        for spot in sorted(spots, key=lambda s: -abs(s.value)):
            yield spot.phi, Words.same(f"${magnitude}$ ") + _extreme(most=spot is found.highest, value=spot.value)
    for t in study.facts.transmissions:
        if t.is_constant:
            continue
        yield (
            t.least.phi,
            Words(
                f"传动角 ${study.whole.info(t.key).symbol}$ 最小",
                f"the transmission angle ${study.whole.info(t.key).symbol}$ is least",
            ),
        )


def _quarter(study: Study) -> Iterator[tuple[float, Words]]:
    """A position for comparison, where nothing has an extreme value that could be drawn."""
    if study.whole.whole:
        yield study.reduced(study.mech.drive.position + np.pi / 2), _QUARTER


def _extreme(*, most: bool, value: float) -> Words:
    """What is said of a greatest or a least value: of one the other way round that it is the greatest that way."""
    if most:
        return Words("取最大值", "is greatest")
    return Words("取负向最大值", "is most negative") if value < 0 else Words("取最小值", "is least")


def chapter(study: Study, press: Press, drawn: list[Drawn]) -> dict[str, Any]:
    """Steps of the given position, its readings, the list of the others, all sheets."""
    press.chapter = "6"
    if not drawn:
        texts, lists = ("positions", "scales", "readings", "placed"), ("sections", "others", "own", "sheets")
        return {**dict.fromkeys(texts, ""), **dict.fromkeys(lists, ())}
    loose = [(one, sheet) for one in drawn for sheet in one.sheets]
    names = [press.sheet() for _ in loose]
    rows = [
        (
            study.where(one.phi),
            _why(study, one).of(press.lang),
            scales(one.solution, press.lang),
            press.through([name.of(press.lang) for (other, _), name in zip(loose, names, strict=True) if other is one]),
        )
        for one in drawn
    ]
    return {
        "positions": press.table(Words("作图的位置", "The positions drawn"), _CHOSEN[press.lang], rows, "llll"),
        "views": drawn_views(study.solution.construction).of(press.lang),
        "sections": sections(study.solution, press.lang, press.objects),
        "scales": scales(study.solution, press.lang),
        "to_even": some_go_down(study.solution.construction),
        "readings": _given(study, press),
        "placed": _placed(study, press.lang),
        "others": _others(study, press, drawn[1:]),
        "own": own_steps(study.solution, ((study.where(one.phi), one.solution) for one in drawn[1:]), press),
        "sheets": [
            press.objects.add("sheet", _page(study, one, sheet, press.lang))
            for (one, _), sheet in zip(loose, bound([sheet for _, sheet in loose], names), strict=True)
        ],
    }


def _given(study: Study, press: Press) -> list[str]:
    """The readings at the given position beside the exact values."""
    title = Words("题设位置的图解值与精确值", "Drawn and exact values at the given position")
    made = readings_tables(study.solution, press.lang)
    return press.tabled(title, made if _lone(study) is None else made[:1], SMALL)


def _placed(study: Study, lang: Lang) -> str:
    """What could not be read, a lone place, and the places at infinity, in words."""
    lone, answers = _lone(study), study.solution.answers.values()
    told = unread_words(answers, lang), "" if lone is None else place_words(lone, lang), endless_words(answers, lang)
    return ("" if lang == "zh" else " ").join(filter(None, told))


def _lone(study: Study) -> Answer | None:
    return lone_place(study.solution.answers.values())


def _why(study: Study, one: Drawn) -> Words:
    """Why the position is chosen, and what drives there where that is not what the problem tells."""
    note = role_note(study, one.phi)
    return one.why + Words(f"（{note.zh}）", f" ({note.en})") if note.zh else one.why


def _others(study: Study, press: Press, drawn: list[Drawn]) -> list[str]:
    """The readings at the other positions, without the expected errors of the given one."""
    told = [(study.where(one.phi).split(" = ")[1], one.solution, _told(study, one)) for one in drawn]
    title = Words("其余位置的图解值与精确值", "Drawn and exact values at the other positions")
    return press.tabled(title, readings_at(told, f"${study.turn.drive.symbol}$", press.lang), SMALL)


def _told(study: Study, one: Drawn) -> list[Answer]:
    """The readings of the output link and point, and of the balancing load."""
    told = {*study.main, *(f"p_{letter}" for letter in study.points)}
    answers = one.solution.answers
    return [answer for key, answer in answers.items() if key in told] or list(answers.values())


def _sheets(study: Study, phi: float, solution: Solution, lang: Lang, *, plates: bool = True) -> tuple[Sheet, ...]:
    title, where, note = study.problem.title, study.where(phi), role_note(study, phi)
    where_en = f"{where}; {note.en}" if note.en else where
    where = f"{where}，{note.zh}" if note.zh else where
    zh = f"{title.zh[:-1]}，{where}）" if title.zh.endswith("）") else f"{title.zh}（{where}）"
    en = f"{title.en[:-1]}, {where_en})" if title.en.endswith(")") else f"{title.en} ({where_en})"
    paper = study.problem.paper
    drawn = without_repeated(solution.construction, study.solution.construction, paper.format)
    made = sheets(drawn, lang=lang, title=Words(zh, en), on=paper, plates=plates)
    return concluded(made, solution, lang, study.given.answers, legend=True)


def _page(study: Study, one: Drawn, sheet: Sheet, lang: Lang) -> SheetPage | Plate:
    """The sheet, bound in behind the page on which its chapter ends, so that it tears no step and no table of it."""
    page = sheet_page(sheet, one.solution.construction, _name(study, one, sheet).of(lang))
    if isinstance(page, SheetPage):
        page.behind = 1
    return page


def _name(study: Study, one: Drawn, sheet: Sheet) -> Words:
    """A sheet's name for the bookmarks."""
    where = spoken(study.where(one.phi))
    return sheet.strip.name + Words(f"　{where}", f": {where}")
