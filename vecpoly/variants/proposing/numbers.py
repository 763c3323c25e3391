"""The numbers of a problem that a lecturer would vary, each in round steps about the value that stands there."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from decimal import Decimal
from math import floor, log10
from typing import Any

from ...problem.meaning import said
from ...problem.values.parameters import named

_NUMBER = re.compile(r"\s*(-?\d+(?:\.\d+)?)\s*([^\d\s].*)?")
_SENSE = re.compile(r"\s*(ccw|cw|顺时针|逆时针)$")
# what stays as it is: scales, stations, what an assumption is, and what hardly shows on a drawing
_KEPT = re.compile(r"mu_|stations|steps|drivers|density|guess|direction_|at_S|f_|rho_|J_|f$|rho$|phi_\d+-\d")
_FIRST = (r"phi$|s$|length$", r"[FMPQ](_\w+)?$", r"omega$|v$", r"[A-Z]{2}$", r"[xy]_")  # then all others
_MOST = Decimal("0.35")  # of the value: how far a range goes to either side
_SHARE = 25  # a step is about so much of the value
_TURN = Decimal(5)  # deg, of a position of the drive
WIDE, NARROW = 8, 3  # steps to either side
DIGITS = 5  # of a number that somebody set; what has more was reckoned from others


@dataclass(frozen=True, slots=True, kw_only=True)
class Span:
    """A number by its name, and its range as it is written after `vary`."""

    name: str
    text: str


def numbers(data: Mapping[str, Any]) -> Iterator[tuple[Span, ...]]:
    """Those of a problem's values that may vary, what a lecturer would vary first, each in a wide range and in a narrow
    one."""
    taken = set[object]()
    known = named(data)
    for name in sorted(known, key=_rank):
        slot = known[name][0]
        if name == slot.full or slot.pair or slot.path in taken or _KEPT.match(name):
            continue
        texts = [spread(said(data, slot), steps, of_drive=name == "phi") for steps in (WIDE, NARROW)]
        if any(texts):
            taken.add(slot.path)
            yield tuple(Span(name=name, text=text) for text in texts if text)


def _rank(name: str) -> int:
    return next((n for n, one in enumerate(_FIRST) if re.match(one, name)), len(_FIRST))


def spread(written: str, steps: int, *, of_drive: bool = False) -> str:
    """A range of so many round steps to either side of a value as it is written: three of 30 mm are 27 mm .. 33 mm by
    1 mm, and of 17 teeth 14 .. 20 by 1; nothing where there is no number, or nought, or one with
    many digits, or no step is small enough."""
    found = _NUMBER.fullmatch(written)
    if found is None or not (value := Decimal(found[1])):
        return ""
    if len(value.normalize().as_tuple().digits) > DIGITS:
        return ""
    unit = (found[2] or "").strip()
    if " " in _SENSE.sub("", unit):  # 7 um at 63 deg
        return ""
    step = _TURN if of_drive else round_step(abs(value) / _SHARE)
    if not unit and value == value.to_integral_value():
        step = max(step, Decimal(1))
    steps = steps if of_drive else min(steps, int(_MOST * abs(value) / step))
    if not steps:
        return ""
    low, high = (f"{_plain(value + way * steps * step)} {unit}".strip() for way in (-1, 1))
    return f"{low} .. {high} by {_plain(step)} {_SENSE.sub('', unit)}".strip()


def round_step(size: Decimal) -> Decimal:
    """The nearest of 1, 2 and 5 times a power of ten."""
    power = Decimal(10) ** floor(log10(size))
    return min((n * power for n in (Decimal(1), Decimal(2), Decimal(5), Decimal(10))), key=lambda one: abs(one - size))


def _plain(value: Decimal) -> str:
    return format(value.normalize(), "f")
