"""The asked quantities beside the moving figures: a line each, and what it reads for every place of the drive."""

from __future__ import annotations

from collections.abc import Sequence

from ..algebra.quantity import number
from ..drawing.hues import ink_called
from ..printed.units import printed_unit
from ..report.answers.tables import way
from ..report.values import called, value
from ..solution import YES_NO, Answer, Solution
from ..tagging.speech import spoken
from ..words import Lang, Words
from .figures import LANGS
from .inverted import Turned
from .setting.ink import inked
from .setting.type import Faces, html, words_html
from .steps import heard

Cells = tuple[str, str, str, str, str]  # value zh, value en, direction zh, direction en, exact


def names(solution: Solution, faces: Faces) -> tuple[tuple[Words, Words], ...]:
    """The symbol of each quantity asked, and how it is read out."""
    tones = solution.construction.tones
    found = []
    for key, answer in solution.answers.items():
        symbol = Words(*(called(answer.reading.symbol, key, lang) for lang in LANGS))
        shown, read = html(symbol, faces), answer.reading
        ink = ink_called(key, read.symbol, tones, read.formula)
        found.append((Words(*(inked(shown.of(lang), ink) for lang in LANGS)), heard(symbol)))
    return tuple(found)


def ways_heard(turns: Sequence[Turned]) -> dict[str, str]:
    """How what stands for a direction in the table is read out: a sense in its own words, a sign by its name."""
    solutions = [turn.solution for turn in turns]
    found = {way(a, one.problem, lang): lang for one in solutions for a in one.answers.values() for lang in LANGS}
    return {text: _heard(text, lang) for text, lang in found.items() if not any(map(str.isdigit, text))}


def _heard(text: str, lang: Lang) -> str:
    return text if any(map(str.isalpha, text)) else spoken(text, lang)


def readings(turns: Sequence[Turned], faces: Faces) -> list[list[Cells]]:
    """For every place, for every quantity: as drawn, its direction or sense, and exact."""
    return [[_cells(answer, turn.solution, faces) for answer in turn.solution.answers.values()] for turn in turns]


def _cells(answer: Answer, solution: Solution, faces: Faces) -> Cells:
    if answer.is_place:
        return _place(answer, faces)
    ways = html(Words(*(way(answer, solution.problem, lang) for lang in LANGS)), faces)
    unit = answer.reading.unit
    shown = html(
        Words(*(value(_clean(answer.counted * answer.drawn), unit, lang, answer.key) for lang in LANGS)), faces
    )
    exact = (
        value(answer.exact, YES_NO, "en")
        if unit == YES_NO
        else number(_clean(printed_unit(unit)[0] * answer.counted * answer.exact), 5)
    )
    return shown.zh, shown.en, ways.zh, ways.en, words_html(exact, faces)


def _place(answer: Answer, faces: Faces) -> Cells:
    """Coordinates of a point in mm; of one at infinity its direction."""
    if answer.drawn_vector is None or answer.exact_vector is None:
        drawn, exact = (f"{turn:.1f}°".replace("-", "−") for turn in (answer.drawn, answer.exact))
        return "∞", "∞", drawn, drawn, exact
    drawn, exact = (
        words_html(f"({number(1e3 * v.real)}, {number(1e3 * v.imag)})", faces)
        for v in (answer.drawn_vector, answer.exact_vector)
    )
    return f"{drawn} mm", f"{drawn} mm", "—", "—", exact


def _clean(size: float) -> float:
    """Zero where only rounding noise is left."""
    return 0.0 if abs(size) < 1e-9 else size
