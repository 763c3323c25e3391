"""The list of symbols: of what a textbook writes, those that this report uses, in the order of a textbook."""

from __future__ import annotations

from collections.abc import Iterable

from ...findings.study.study import Study
from ...words import Words
from ..flow.style import Style
from ..flow.table import DataTable
from . import symbol_rows
from .numbering import Press
from .spoken_symbols import COUNTED, Row, used

_HEADER = {"zh": ["符号", "含义", "单位"], "en": ["Symbol", "Meaning", "Unit"]}
_SET = Style(size=9.0, leading=10.0, after=0.0, align="left")
_KINDS = (  # by their units: lengths, angles, velocities, accelerations, masses, forces and moments, energies, ratios
    ("mm", "m"),
    ("°",),
    ("m/s", "rad/s"),
    ("m/s²", "rad/s²"),
    ("kg", "kg·m", "kg·m²"),
    ("N", "N·m"),
    ("J", "W"),
    ("—",),
)


def symbols(study: Study, press: Press, told: str = "") -> str:
    """A table without number, two symbols to a line; told: the words of the report, whose symbols it lists too."""
    listed = [
        (symbol.replace("、", "、" if press.lang == "zh" else ", "), words.of(press.lang), unit)
        for symbol, words, unit in rows_of(study, told)
    ]
    half = (len(listed) + 1) // 2
    rows = [(*one, "", *two) for one, two in zip(listed[:half], [*listed[half:], ("", "", "")][:half], strict=True)]
    caption, head = Words("主要符号", "Symbols").of(press.lang), _HEADER[press.lang]
    table = DataTable([*head, "", *head], rows, None, "llc" + "c" + "llc", lang=press.lang, caption=caption, style=_SET)
    return press.objects.add("tab", table)


def rows_of(study: Study, told: str) -> list[Row]:
    """The counts of the structure, the quantities, what is auxiliary, the scales, the letters of the drawings."""
    loaded = study.problem.acting is not None
    own = [*symbol_rows.model(study), *symbol_rows.forces(study), *symbol_rows.components(study)]
    taken = {symbol for symbol, _, _ in own}
    counted, spoken = ([row for row in rows if row[0] not in taken] for rows in (COUNTED, used(told, loaded=loaded)))
    behind = [*symbol_rows.auxiliary(study), *symbol_rows.scales(study), *symbol_rows.letters(study)]
    return [*counted, *symbol_rows.centres(study), *symbol_rows.curvatures(study), *ordered([*own, *spoken]), *behind]


def ordered(rows: Iterable[Row]) -> list[Row]:
    """Kind by kind, in each Latin letters before Greek ones, by the alphabet."""
    return sorted(rows, key=_place)


def _place(row: Row) -> tuple[int, bool, str, str]:
    symbol, _, unit = row
    letters = symbol.strip("$|Δ")
    kind = next((n for n, units in enumerate(_KINDS) if unit in units), len(_KINDS) - 3)
    return kind, not letters[:1].isascii(), letters[:1].lower(), letters
