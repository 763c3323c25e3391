"""What may differ from student to student: ``vary: {AB: 80 mm .. 120 mm by 5 mm}``, a grid of written values."""

from __future__ import annotations

from collections.abc import Mapping
from decimal import Decimal
from functools import lru_cache

from ..errors import FaultError
from ..foundation.patterns import pattern
from ..limits import GRID
from ..units.patterns import NUMBER, SENSE
from ..units.reading import pure, read
from ..words import Words
from .meaning import meant_by
from .ranges import Range
from .schema.faults import Faults
from .text.source import Value
from .values.parameters import named
from .values.slot import Slot

SPAN = r"(\.\.|…|~|～|至)"  # between the ends
STEP = r"(by|，?步长|，?间隔)"  # before the step
_FORM = pattern(rf"\s*(?P<low>.+?)\s*{SPAN}\s*(?P<high>.+?)\s*{STEP}\s*(?P<step>.+?)\s*")
_PART = pattern(rf"(?P<number>{NUMBER})\s*(?P<unit>.*)")
_TURNING = pattern(rf"\s*{SENSE}$")
_EXAMPLE = "AB: 80 mm .. 120 mm by 5 mm"


def read_ranges(written: Mapping[str, str], data: Mapping[str, Value], faults: Faults) -> tuple[Range, ...]:
    """The ranges in this mapping; what is wrong with each is noted at its place."""
    found: list[Range] = []
    touched: dict[tuple[str | int, ...], str] = {}
    known: Mapping[str, tuple[Slot, ...]] | None = None
    for name, text in written.items():
        with faults.at("vary", name):
            known = named(data) if known is None else known
            slots = meant_by(name, data, known)
            _once(name, slots, touched)
            found.append(_read(name, text, slots[0]))
    return tuple(found)


def _once(name: str, slots: tuple[Slot, ...], touched: dict[tuple[str | int, ...], str]) -> None:
    for slot in slots:
        other = touched.setdefault((*slot.path, *slot.names[:1]), name)
        if other != name:
            raise FaultError(
                Words(
                    f"{other} 与 {name} 是同一个量；请删去其一", f"{other} and {name} are one quantity; leave one out"
                ),
                code="contradiction",
            )
        if slot.pair:
            raise FaultError(
                Words(
                    f"点 {name} 有两个坐标；请分别写 x_{name}、y_{name}",
                    f"the point {name} has two coordinates; vary x_{name} and y_{name}",
                ),
                code="spelling",
            )


@lru_cache(maxsize=64)
def _read(name: str, text: str, slot: Slot) -> Range:
    """A range as written, checked against the kind of quantity."""
    found = _FORM.fullmatch(text)
    if found is None:
        raise FaultError(
            Words(f"“{text}”不是范围；如写 {_EXAMPLE}", f"'{text}' is no range; write e.g. {_EXAMPLE}"), code="spelling"
        )
    (low, unit), (high, same), (step, by) = (_part(found[key], slot) for key in ("low", "high", "step"))
    if same != unit or by not in (unit, _TURNING.sub("", unit)):
        raise FaultError(
            Words(
                f"“{text}”：三个值的单位（及转向）须相同：{unit}、{same}、{by}；请改成一种",
                f"'{text}': the three values must have one unit (and sense): {unit}, {same}, {by}; write one of them",
            ),
            code="wrong-unit",
        )
    return Range(name=name, first=low, step=step, count=_count(text, low, high, step), unit=unit)


def _part(text: str, slot: Slot) -> tuple[Decimal, str]:
    """The number and its unit; raises FaultError for what is no such quantity. A device reads its own data later."""
    if slot.dim is not None:
        read(text, slot.dim)
    elif slot.path[0] != "data":
        pure(text, "0.1")
    found = _PART.fullmatch(text.replace("−", "-"))
    if found is None:
        raise FaultError(
            Words(
                f"“{text}”不是数和单位；如写 {_EXAMPLE}", f"'{text}' is no number with a unit; write e.g. {_EXAMPLE}"
            ),
            code="spelling",
        )
    return Decimal(found["number"]), found["unit"].strip()


def _count(text: str, low: Decimal, high: Decimal, step: Decimal) -> int:
    """How many values; raises FaultError where the end is not one of them, or there are too many."""
    if step <= 0 or high <= low:
        raise FaultError(
            Words(
                f"“{text}”：步长须大于零，末值须大于初值；如写 {_EXAMPLE}",
                f"'{text}': the step must be above zero and the end above the start; write e.g. {_EXAMPLE}",
            ),
            code="out-of-range",
        )
    steps, rest = divmod(high - low, step)
    if rest:
        last = low + steps * step
        raise FaultError(
            Words(
                f"“{text}”：末值 {high} 不在步长 {step} 的格上；请取 {last} 或 {last + step}",
                f"'{text}': the end {high} is no whole number of steps of {step} from {low}; "
                f"end at {last} or {last + step}",
            ),
            code="out-of-range",
            numbers={"end": str(high), "step": str(step)},
        )
    if steps >= GRID:
        raise FaultError(
            Words(
                f"“{text}”有 {steps + 1} 个值，最多 {GRID} 个；请加大步长",
                f"'{text}' has {steps + 1} values, {GRID} at most; take a larger step",
            ),
            code="out-of-range",
        )
    return int(steps) + 1
