"""Many data: with subscripts, m_1, r_1, θ_1, m_2 ..., a table, a row a body, as any book has them; others a table of
symbol, value and unit."""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import dataclass

from ...algebra.columns import padded
from ...algebra.rounding import braced
from ...devices.balancing.rotor import Rotor
from ...devices.base import Device
from ...problem.problem import Problem
from ...problem.values.given import Datum, as_printed
from ...words import Lang, Words
from ..flow.results.blocked import BlockTable
from ..flow.table import DataTable
from .given_data import given_data
from .shortened import shortened

_LEAST = 3  # quantities, and bodies, that make a table
_SYMBOL = re.compile(r"([A-Za-zφθ])_\{?([A-Za-z0-9]+)\}?")
_VALUE = re.compile(r"(−?[\d.]+|\?)(°| .+)?")
_SOUGHT = "?"
_ROWS = Words("序号 $i$", "$i$")
_NONE = "—"
_SEE = Words("见下表", "see the table")
OTHERS = Words("；其余数据见下表", "; the other data are in the table")  # behind what stands in the line
_MANY = 8  # numbers that make a table where they have no columns
_SCALAR = re.compile(r"\$([^$]+)\$ = ([^（(]+)")
_TERM = re.compile(r"(−?[\d.]+(?:/[\d.]+)?)(°|\s?[^\s\d+/][^+]*)?")  # of a sum: 0.08 kg·m² + 0.01 kg·m²; 1/60
_PLUS = " + "
_HEAD = (Words("符号", "Symbol"), Words("数值", "Value"), Words("单位", "Unit"))
_BLOCKS = 4  # beside each other, at most
_MEANT = {  # of a rotor
    "m": Words("质量", "masses"),
    "W": Words("质径积", "mass-radius products"),
    "r": Words("回转半径", "radii"),
    "θ": Words("方位角（逆时针为正）", "angular positions (counter-clockwise)"),
    "z": Words("轴向位置", "axial positions"),
}


@dataclass(frozen=True, slots=True)
class _Cell:
    """One datum in the table: its letter (column), its subscript (row), number and unit."""

    column: str
    row: str
    text: str
    unit: str
    datum: Datum


def in_table(problem: Problem, lang: Lang) -> tuple[tuple[Datum, ...], DataTable | None]:
    """What is given in the line, and the table of the rest; all in the line where they make no table."""
    data = given_data(problem)
    if isinstance(problem.subject, Device) and (found := _by_bodies(data, lang)) is not None:
        return found
    scalars = {id(one): cells for one in data if (cells := scalar(one, lang)) is not None}
    if len(scalars) < _MANY:
        return data, None
    return tuple(one for one in data if id(one) not in scalars), _abreast(tuple(scalars.values()), lang)


def scalar(one: Datum, lang: Lang) -> tuple[str, str, str] | None:
    """Symbol, number (or a sum of numbers), unit of what is nothing but these; what has a sense beside them, or no one
    unit, stands in the line."""
    found = None if one.words is not None or one.table is not None else _SCALAR.fullmatch(shortened(one.of(lang)))
    terms = [_TERM.fullmatch(term) for term in found[2].split(_PLUS)] if found is not None else []
    told = [term for term in terms if term is not None]
    units = {(term[2] or _NONE).strip() for term in told}
    if found is None or len(told) < len(terms) or len(units) != 1:
        return None
    return f"${found[1]}$", _PLUS.join(term[1] for term in told), units.pop()


def _abreast(rows: Sequence[tuple[str, ...]], lang: Lang) -> DataTable:
    """In as few rows as so many blocks beside each other make."""
    high = -(-len(rows) // _BLOCKS)
    return BlockTable.of([head.of(lang) for head in _HEAD], rows, -(-len(rows) // high), "ldc", lang)


def _by_bodies(data: tuple[Datum, ...], lang: Lang) -> tuple[tuple[Datum, ...], DataTable] | None:
    """A row a body, a column a letter; None where there are too few columns."""
    cells = [cell for one in data if (cell := _cell(one, lang)) is not None]
    columns = [c for c in dict.fromkeys(cell.column for cell in cells) if _is_column(c, cells)]
    if len(columns) < _LEAST:
        return None
    told = [cell for cell in cells if cell.column in columns]
    rows = [_row(name, columns, told) for name in dict.fromkeys(cell.row for cell in told)]
    heads = [_ROWS.of(lang), *(_head(column, told) for column in columns)]
    kept = {id(cell.datum) for cell in told}
    table = DataTable(heads, padded(rows), None, "c" + "d" * len(columns), lang=lang)
    return tuple(one for one in data if id(one) not in kept), table


def in_table_words(problem: Problem, lang: Lang) -> str:
    """What the columns of the table mean, and where it stands: masses m_i, radii r_i ... as in the table."""
    table = in_table(problem, lang)[1]
    if table is None or not isinstance(problem.subject, Rotor) or not problem.statement.zh:  # whose task tells them
        return _SEE.of(lang)
    if table.header[0] != _ROWS.of(lang):
        return _SEE.of(lang)
    letters = [head.split("_i")[0].strip("$") for head in table.header[1:]]
    told = [_MEANT[letter].of(lang) + f" ${letter}_i$" for letter in letters if letter in _MEANT]
    return Words("、".join(told) + "，见下表", ", ".join(told) + "; see the table").of(lang) if told else _SEE.of(lang)


def _cell(one: Datum, lang: Lang) -> _Cell | None:
    symbol, value = _SYMBOL.fullmatch(one.symbol), _VALUE.fullmatch(as_printed(one.text, lang))
    if symbol is None or value is None or one.words is not None:
        return None
    return _Cell(symbol[1], symbol[2], value[1], (value[2] or "").strip(), one)


def _is_column(column: str, cells: Sequence[_Cell]) -> bool:
    """Whether as many bodies have it as make a table, all in one unit."""
    own = [cell for cell in cells if cell.column == column]
    return len(own) >= _LEAST and len({cell.unit for cell in own if cell.text != _SOUGHT}) == 1


def _row(name: str, columns: Sequence[str], cells: Sequence[_Cell]) -> tuple[str, ...]:
    found = {cell.column: cell.text for cell in cells if cell.row == name}
    return (f"${name}$" if name[0].isalpha() else name, *(found.get(column, _NONE) for column in columns))


def _head(column: str, cells: Sequence[_Cell]) -> str:
    unit = next(cell.unit for cell in cells if cell.column == column and cell.text != _SOUGHT)
    return f"${column}_i$" + (f" /{braced(unit)}" if unit else "")
