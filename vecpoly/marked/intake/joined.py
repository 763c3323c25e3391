"""The parts of one answer, typed into columns of their own, joined as a student would write them in one place."""

from __future__ import annotations

from collections.abc import Mapping

from ...grading.key import AnswerKey, Kind
from ...grading.reading.direction import as_direction
from ...grading.reading.sense import as_sense
from .heads import Head, Part


def joined(key: AnswerKey, parts: Mapping[Head, str]) -> dict[str, str]:
    """Symbol → answer: a direction stands behind its value, a sense too, a length on paper under its own letters."""
    cells: dict[str, str] = {}
    for head, text in parts.items():
        if head.part is Part.VALUE:
            cells[head.symbol] = text
    for head, text in parts.items():
        if not text.strip():
            continue
        if head.part is Part.LENGTH:
            _length(key, head.symbol, text, cells)
    for head, text in parts.items():
        if not text.strip() or not cells.get(head.symbol, "").strip():
            continue
        if head.part is Part.DIRECTION:
            cells[head.symbol] += f" {as_direction(text)}"
        elif head.part is Part.SENSE:
            cells[head.symbol] = f"{cells[head.symbol]} {as_sense(text)}"
    return cells


def _length(key: AnswerKey, symbol: str, text: str, cells: dict[str, str]) -> None:
    """Under the letters of the length where it is one that is read; else it stands for the value."""
    one = key.find(symbol)
    length = text if "mm" in text else f"{text.strip()} mm"
    if one is None:
        return
    if one.line:
        cells.setdefault(one.line, length)
        if not cells[one.line].strip():
            cells[one.line] = length
    elif one.kind is Kind.READING:
        cells[symbol] = text
    elif not cells.get(symbol, "").strip():
        cells[symbol] = length
