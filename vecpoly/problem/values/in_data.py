"""The quantities in the data of a device, or of a mechanism that is to be found: alone, or several in a phrase."""

from __future__ import annotations

from collections.abc import Iterator

from ...foundation.patterns import pattern
from ..schema.faults import Path
from ..text.source import Value
from .slot import Slot

_SINGLE = pattern(r"\s*[-+−]?[\d.]")
_LETTER = pattern(r"[A-Z]\d?")
_NUMBER = r"[-+−]?(?:\d+\.?\d*|\.\d+)"
_UNIT = r"(?:mm|cm|m|deg|rad|°|度|毫米|厘米|米)(?![A-Za-z])"
_BRACKETED = pattern(rf"[(（]\s*({_NUMBER})\s*[,，]\s*({_NUMBER})\s*[)）]\s*({_UNIT})")  # (49, 12) mm
_ALONE = pattern(rf"(?<![\w.])({_NUMBER})\s*{_UNIT}")  # 30 mm, in a phrase


def in_data(path: Path, data: Value, stem: str = "", which: str = "") -> Iterator[Slot]:
    """Every quantity; stem: the name of the entry in which these stand, with its number.

    which: of the entry of a table, one of several alike: m_1 is the m of mass 1, at_2 the angle of the second run.
    """
    if isinstance(data, list):
        yield from _listed(path, data, stem)
        return
    for key, item in data.items() if isinstance(data, dict) else ():
        name = f"{key}_{which}" if which else key
        if isinstance(item, dict) and _alike(list(item.values())):
            for entry, inner in item.items():
                yield from in_data((*path, key, entry), inner, key, entry)
        elif isinstance(item, dict | list):
            yield from in_data((*path, key), item, name)
        elif item is not None:
            yield from _told((*path, key), str(item), name)


def _alike(entries: list[Value]) -> bool:
    """Whether all are tables of data: masses, planes."""
    return bool(entries) and all(isinstance(entry, dict) for entry in entries)


def _runs(entries: list[Value]) -> bool:
    """Whether the entries of a list are several tables with the same keys."""
    return len(entries) > 1 and _alike(entries) and len({frozenset(entry) for entry in entries if entry}) == 1


def _listed(path: Path, data: list[Value], stem: str) -> Iterator[Slot]:
    """A point's coordinates are x_B and y_B; other entries are numbered."""
    point = len(data) == 2 and _LETTER.fullmatch(stem) and not any(_BRACKETED.search(str(item)) for item in data)
    for i, item in enumerate(data):
        name = f"{'xy'[i]}_{stem}" if point else f"{stem}_{i + 1}"
        if isinstance(item, dict | list):
            yield from in_data((*path, i), item, name, str(i + 1) if _runs(data) else "")
        elif item is not None:
            yield from _told((*path, i), str(item), name)


def _told(path: Path, text: str, name: str) -> Iterator[Slot]:
    """The one value that this is, or those in it in the order in which they are written: motion_1_1, motion_1_2."""
    spans = _spans(text)
    if len(spans) < 2 and _SINGLE.match(text):
        yield Slot(path, None, (name,))
        return
    for (span, unit), called in zip(spans, _called(name, spans), strict=True):
        yield Slot(path, None, (called,), span, several=True, unit=unit)


def _called(name: str, spans: list[tuple[tuple[int, int], str]]) -> list[str]:
    """A place alone has two coordinates; other values of a phrase are numbered."""
    if len(spans) == 1:
        return [name]
    if len(spans) == 2 and all(unit for _, unit in spans):
        return [f"x_{name}", f"y_{name}"]
    return [f"{name}_{number}" for number in range(1, len(spans) + 1)]


def _spans(text: str) -> list[tuple[tuple[int, int], str]]:
    """Where the quantities of a phrase stand; a number in brackets with the unit behind them."""
    pairs = list(_BRACKETED.finditer(text))
    bare = [(m.span(n), m[3]) for m in pairs for n in (1, 2)]
    alone = [
        (m.span(), "")
        for m in _ALONE.finditer(text)
        if not any(pair.start() < m.end() and m.start() < pair.end() for pair in pairs)
    ]
    return sorted([*bare, *alone])
