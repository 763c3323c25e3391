"""The parts of one answer, typed into columns of their own, joined as a student would write them in one place."""

from __future__ import annotations

import re
from collections.abc import Mapping

from ...grading.key import AnswerKey, Kind
from ...grading.reading.characters import plain
from ...grading.reading.direction import as_direction
from ...grading.reading.number import NUMBER
from ...grading.reading.sense import as_sense
from ...grading.reading.written import State, written
from .heads import Head, Part

_NUMBER = re.compile(r"[\d.]+")


def joined(key: AnswerKey, parts: Mapping[Head, str]) -> dict[str, str]:
    """Symbol → answer: a direction stands behind its value, a sense too, a length on paper under its own letters."""
    cells: dict[str, str] = {}
    for head, text in parts.items():
        if head.part is Part.VALUE:
            cells[head.symbol] = with_unit(text, head.unit) if head.unit and text.strip() else text
    for head, text in parts.items():
        if not text.strip():
            continue
        if head.part is Part.LENGTH:
            _length(key, head, text, cells)
    for head, text in parts.items():
        if not text.strip() or not cells.get(head.symbol, "").strip():
            continue
        if head.part is Part.DIRECTION:
            cells[head.symbol] += f" {as_direction(text)}"
        elif head.part is Part.SENSE:
            cells[head.symbol] = f"{cells[head.symbol]} {as_sense(text)}"
    return cells


def twice(more: Mapping[Head, str], known: Mapping[Head, str]) -> bool:
    """Whether something is written of what is written already, by whatever names."""
    there = {head.what for head, text in known.items() if text.strip()}
    return any(head.what in there for head, text in more.items() if text.strip())


def cell_of(key: AnswerKey, head: Head) -> str:
    """The symbol under which what stands in a column is judged: a length on paper has letters of its own."""
    one = key.find(head.symbol)
    return one.line if one is not None and head.part is Part.LENGTH and one.line else head.symbol


def with_unit(text: str, unit: str) -> str:
    """What was written, with the unit of its column where none stands beside it."""
    bare = text.strip()
    if not _NUMBER.fullmatch(bare):
        said = written(bare)
        if said.state is not State.READ or said.unit is not None or said.yes is not None:
            return bare
        if said.direction is not None and (found := NUMBER.search(bare := plain(bare))) is not None:
            return f"{bare[: found.end()]} {unit} {bare[found.end() :]}"
    return f"{bare} {unit}"


def _length(key: AnswerKey, head: Head, text: str, cells: dict[str, str]) -> None:
    """Under the letters of the length where it is one that is read; else it stands for the value."""
    one = key.find(head.symbol)
    if one is None:
        return
    if one.kind is Kind.READING:
        cells[head.symbol] = text
    elif not cells.get(name := cell_of(key, head), "").strip():
        cells[name] = with_unit(text, "mm")
