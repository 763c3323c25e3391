"""What a short name of a quantity means in a problem's values: AB, phi, x_D, F."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

from ..errors import FaultError, UnknownNameError
from ..units.reading import Dim, read
from ..words import Words
from .schema.faults import meant
from .text.source import Value
from .values.parameters import named, other_way
from .values.slot import Slot


def meant_by(
    name: str, data: Mapping[str, Value], known: Mapping[str, tuple[Slot, ...]] | None = None
) -> tuple[Slot, ...]:
    """The quantities of this name; raises UnknownNameError where there is none, or several that differ.

    known: all names of these data, where they were found already (`named`).
    """
    known = named(data) if known is None else known
    found = known.get(name) or known.get(other_way(name)) or ()
    if not found:
        short = [key for key, of in known.items() if key != of[0].full]
        raise UnknownNameError(
            Words(f"本题没有可改的量“{name}”", f"nothing that is given is called '{name}'")
            + meant(name, short)
            + _frame(name, data),
            code="unknown-name",
        )
    if not alike(data, found):
        zh, en = (comma.join(f"{slot.full} = {said(data, slot)}" for slot in found) for comma in ("、", ", "))
        raise UnknownNameError(
            Words(
                f'“{name}”指几个不同的量：{zh}；请写全名，如 vary(**{{"{found[0].full}": ...}})',
                f"'{name}' means several that differ: {en}; "
                f'give the full name, e.g. vary(**{{"{found[0].full}": ...}})',
            ),
            code="ambiguous-name",
        )
    return found


def _frame(name: str, data: Mapping[str, Value]) -> Words:
    """That the distance of two fixed points is no value of its own."""
    first, second = name[:1], name[1:]
    frame = data.get("frame") or {}
    if first in frame and second in frame:
        return Words(
            f"；{first}、{second} 是机架上的点，请改其坐标 x_{second}、y_{second} 或 {second}=(x, y)",
            f"; {first} and {second} are points of the frame: vary x_{second} and y_{second}, or {second}=(x, y)",
        )
    return Words.same("")


def said(data: Mapping[str, Value], slot: Slot) -> str:
    """What is written there."""
    value = at(data, slot.path)
    text = ", ".join(map(str, value)) if isinstance(value, list) else str(value)
    return f"{text[slice(*slot.span)]} {slot.unit}".rstrip() if slot.span else text


def alike(data: Mapping[str, Value], found: Sequence[Slot]) -> bool:
    """Whether all say the same, in whatever units."""
    return len({_amount(said(data, slot), slot.dim) for slot in found}) == 1


def _amount(text: str, dim: Dim | None) -> float | str:
    try:
        return float(text) if dim is None else read(text, dim).si
    except (FaultError, ValueError):
        return text


def at(data: Any, path: Sequence[str | int]) -> Any:
    """What stands at this path."""
    for step in path:
        data = data[step]
    return data
