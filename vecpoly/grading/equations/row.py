"""One row of a vector equation: of each term whether its direction, or its magnitude, is given or unknown."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from enum import StrEnum
from typing import assert_never

from ...board.construction import Construction, EquationTable, Step
from ...board.place import View
from ...words import Words
from ..derive.blocks import block_of

UNKNOWN = "?"


class Which(StrEnum):
    """Which row of the table."""

    DIRECTION = "dir"
    MAGNITUDE = "size"

    @property
    def words(self) -> Words:
        """As the table has it."""
        match self:
            case Which.DIRECTION:
                return Words("方向", "direction")
            case Which.MAGNITUDE:
                return Words("大小", "magnitude")
            case _:
                assert_never(self)


@dataclass(frozen=True, slots=True, kw_only=True)
class EquationRow:
    """key: ``eq1_dir``, by the number of the equation on the question sheet. printed: the equation; symbols: of its
    terms; known: of each of them. points: that go to this row from those for lines, where it was filled in."""

    key: str
    which: Which
    block: str
    printed: str
    symbols: tuple[str, ...]
    known: tuple[bool, ...]
    points: float = 0.0


def rows_of(construction: Construction) -> tuple[EquationRow, ...]:
    """Both rows of every equation, in the order of the question sheet."""
    steps = [step for step in construction.steps if step.equation is not None]
    return tuple(row for n, step in enumerate(steps, 1) for row in _rows(n, step))


def _rows(n: int, step: Step) -> Iterator[EquationRow]:
    table = step.equation
    assert table is not None
    terms = [i for i, size in enumerate(table.magnitudes) if size or table.directions[i].en]  # not the 0 of a sum
    for which in Which:
        cells = table.magnitudes if which is Which.MAGNITUDE else [one.en for one in table.directions]
        yield EquationRow(
            key=f"eq{n}_{which}", which=which, block=_block(step), printed=_printed(table),
            symbols=tuple(table.symbols[i] for i in terms), known=tuple(cells[i] != UNKNOWN for i in terms),
        )  # fmt: skip


def _block(step: Step) -> str:
    place = step.view
    return block_of(None if place is None else place if isinstance(place, View) else place.view)


def _printed(table: EquationTable) -> str:
    parts = (f"{sign} {symbol}".strip() for sign, symbol in zip(table.signs, table.symbols, strict=True))
    return " ".join(parts)
