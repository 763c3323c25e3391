"""The tables of a report: readings beside exact values, printed answers with their verdicts, empty answer tables."""

from __future__ import annotations

import re
from collections.abc import Iterable, Sequence
from math import ceil, isfinite

from ..algebra.columns import padded
from ..algebra.quantity import number
from ..algebra.rounding import places_of
from ..board.construction import Listing
from ..check.printed.verdict import Checked, Verdict, is_angle
from ..drawing.hues import ink_called
from ..figures.hue import Hue
from ..names import is_place
from ..problem.problem import Problem, as_printed
from ..solution import YES_NO, Solution
from ..typeset.box import Rgb
from ..words import Lang, Words
from .flow.results.blocked import BlockTable
from .flow.table import DataTable
from .heads import unit_column, united
from .statement.in_table import in_table
from .values import value

_PRINTED = {
    "zh": ("所求量", "原书", "精确值", "偏差 /%", "结论"),
    "en": ("Quantity", "Textbook", "Exact", "Deviation /%", "Verdict"),
}
_OFF, _OFF_EITHER = 3, Words("偏差", "Deviation")  # column; its head where there are angles, too
_NUMBER_UNIT = re.compile(r"([+−-]?\d+(?:\.\d+)?) ?([^\d\s.(（]\S*)")
_UNIT = Words("单位", "Unit")
_NUMBER, _EXACT = re.compile(r"\d+(?:\.\d+)?"), 4  # figures of an exact value beside a printed one, at least
_NONE = "—"
_SENSE, _TURNING = re.compile(r"cw\b|[顺逆]"), (Words("顺时针", "clockwise"), Words("逆时针", "counter-clockwise"))
_MANIFOLD = 2.0  # share off from which a deviation is told as a factor
MOST_COLUMNS = 15  # of a table of stations, in all its blocks
MOST_GIVEN = 140  # rows of a table that is printed with what is given
FEW = 6  # rows of a table that stays one block


def inks_of(solution: Solution, keys: Iterable[str]) -> tuple[Rgb | None, ...]:
    """The ink in which each of these vectors is drawn; none for what is black."""
    tones, answers = solution.construction.tones, solution.answers
    read = {key: answers[key].reading for key in answers}
    found = (
        ink_called(key, read[key].symbol, tones, read[key].formula) if key in read else ink_called(key, "", tones)
        for key in keys
    )
    return tuple(None if hue == Hue.BLACK else hue.value for hue in found)


def listed(listing: Listing, lang: Lang) -> DataTable:
    """What a step reads at many places: in as many blocks beside each other as a page has room for."""
    blocks = max(1, min(listing.blocks, MOST_COLUMNS // len(listing.head)))
    blocks = blocks if len(listing.rows) > max(blocks, FEW) else 1
    blocks = ceil(len(listing.rows) / max(1, ceil(len(listing.rows) / blocks))) or 1  # none of them stays empty
    heads = [head.of(lang) for head in listing.head]
    return BlockTable.of(heads, padded(listing.rows), blocks, "d" * len(heads), lang)


def given_tables(problem: Problem, lang: Lang) -> list[DataTable]:
    """The tables among what is given, each in columns beside each other, and that of many data with subscripts; not
    those that would fill pages."""
    tables, many = (datum.table for datum in problem.given.data), in_table(problem, lang)[1]
    return ([] if many is None else [many]) + [
        listed(Listing(head=tuple(map(Words.same, one.head)), rows=one.rows, blocks=MOST_COLUMNS), lang)
        for one in tables
        if one is not None and len(one.rows) <= MOST_GIVEN
    ]


def trimmed(
    header: Sequence[str],
    rows: Sequence[Sequence[str]],
    widths: Sequence[float],
    align: str,
    lang: Lang = "zh",
    groups: Sequence[str] = (),
) -> DataTable:
    """The table without columns in which nothing stands; groups: of the rows, the units of their numbers."""
    kept = [i for i in range(len(header)) if not rows or any(row[i] not in (_NONE, "") for row in rows)]
    return DataTable(
        [header[i] for i in kept],
        [[row[i] for i in kept] for row in rows],
        [widths[i] for i in kept] if widths else None,
        "".join(align[i] for i in kept),
        lang=lang,
        groups=groups,
    )


def printed_table(checked: Sequence[Checked], lang: Lang) -> DataTable | None:
    """Printed answers, the exact values, and what is to be said of them; None where all are counts that agree."""
    told = [c for c in checked if not agreed(c)]
    if not told:
        return None
    header, rows, align = [*_PRINTED[lang]], [_printed_row(c, lang) for c in told], "ldddl"
    if any(is_angle(c.printed) for c in told):
        header[_OFF], rows = _OFF_EITHER.of(lang), [_in_its_unit(row, c) for row, c in zip(rows, told, strict=True)]
    if len(told) > 1 and all(c.verdict is Verdict.REPRODUCED and c.slip is None for c in told):
        header, rows, align = header[:-1], [row[:-1] for row in rows], align[:-1]  # a sentence says that all agree
    heads, cells = united(header, rows)
    apart = unit_column(cells, (1, 2)) if heads[1:3] == header[1:3] else None
    if apart is None:
        return DataTable(heads, cells, None, align, lang=lang)
    return DataTable([heads[0], _UNIT.of(lang), *heads[1:]], apart, None, f"lc{align[1:]}", lang=lang)


def _in_its_unit(row: tuple[str, ...], c: Checked) -> tuple[str, ...]:
    """The row with the unit of its deviation beside it: of an angle degrees, else per cent."""
    before, off, behind = row[:_OFF], row[_OFF], row[_OFF + 1 :]
    if not is_angle(c.printed):
        return (*before, off if off == _NONE else f"{off} %", *behind)
    told = percent(c.deviation * c.exact / 100, 1 if c.printed.kind == "graphical" else 2).removesuffix(" %")
    return (*before, f"{told}°", *behind)


def agreed(c: Checked) -> bool:
    """Whether the answer is a count, or yes or no, and right: a sentence says so."""
    return counted(c) and not c.deviation and c.slip is None


def counted(c: Checked) -> bool:
    """Whether the answer is a count, or yes or no, which has no exact value to come near to."""
    return c.printed.rel is not None and c.printed.rel.unit in ("", YES_NO) and float(c.exact).is_integer()


def _printed_row(c: Checked, lang: Lang) -> tuple[str, ...]:
    verdict = c.verdict.words.of(lang)
    slip = f"：{c.slip.zh}" if c.slip and lang == "zh" else (f": {c.slip.en}" if c.slip else "")
    off = percent(c.deviation, 1 if c.printed.kind == "graphical" else 2).removesuffix(" %")
    if abs(c.deviation) >= _MANIFOLD and isfinite(c.deviation):
        off = f"{100 * c.deviation:+.0f}".replace("-", "−")
    off = off if c.exact else _NONE  # no share of nothing
    return f"${symbol_of(c)}$", _as_given(c, lang), _exact_like(c, lang), off, verdict + slip


def _as_given(checked: Checked, lang: Lang) -> str:
    """The printed answer as it stands there, and what it is where a length on paper is printed."""
    printed = checked.printed
    text = as_printed(printed.text, lang).replace("*", "·")
    if printed.scale:
        unit = printed.rel.unit if printed.rel else "m"
        text += f" ≙ {number(abs(printed.value))} {unit}"
    return text


def _exact_like(checked: Checked, lang: Lang) -> str:
    """The exact value with its unit."""
    rel = checked.printed.rel
    if rel is None or is_place(rel):
        return f"{number(checked.exact, _figures(checked))} m"
    text = _as_told(checked) or value(checked.exact, rel.unit, lang, digits=_figures(checked))
    if not checked.exact or not _SENSE.search(checked.printed.text):
        return text
    told = _TURNING[checked.exact > 0].of(lang)  # as the printed one has its sense
    return text.lstrip("−") + (f"（{told}）" if lang == "zh" else f" ({told})")


def _figures(checked: Checked) -> int:
    """Of the exact value beside a printed one: one more than that has, so that the last can be judged."""
    found = _NUMBER.search(checked.printed.text)
    own = 0 if found is None else len(found[0].replace(".", "").lstrip("0"))
    figures = max(_EXACT, own + 1)
    return figures + number(checked.exact, figures).endswith("5")  # which way it rounds: 0.822347, not 0.82235


def _as_told(checked: Checked) -> str:
    """The exact value in the unit in which the book tells its own: kg·cm beside kg·cm; nothing where none is told."""
    printed = checked.printed
    told = _NUMBER_UNIT.fullmatch(as_printed(printed.text, "en").replace("*", "·"))
    if told is None or printed.scale or not printed.value or is_angle(printed):
        return ""
    exact = number(checked.exact * float(told[1].replace("−", "-")) / printed.value, _figures(checked))
    return f"{_as_fine(exact, told[1])} {told[2]}"


def _as_fine(exact: str, printed: str) -> str:
    """The exact value with no fewer decimals than the printed one: 284.80 beside 284.82; not of a whole number."""
    short = places_of(printed) - places_of(exact)
    return exact + "0" * short if short > 0 and "." in exact and "×" not in exact else exact


def symbol_of(checked: Checked) -> str:
    """The textbook's symbol of a printed answer."""
    return checked.printed.rel.symbol if checked.printed.rel else checked.printed.symbol


def percent(ratio: float, digits: int) -> str:
    """A signed percentage; no sign on zero."""
    text = f"{100 * ratio:+.{digits}f}"
    return (text.lstrip("+-") if float(text) == 0 else text.replace("-", "−")) + " %"
