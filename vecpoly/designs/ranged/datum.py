"""One number among the data of a synthesis, and the same task with another in its place."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import Any, Generic, TypeVar

from pydantic import BaseModel

from ...foundation.slotted import dataclass
from ...names import Named
from ...units.reading import Quantity
from ...words import Words
from ..place import OnLine

Task = TypeVar("Task", bound=BaseModel)
_GUIDE = "guide"  # the key of the line on which a slider runs; other lines have that of the pin which lies on them
_AXES = (("x", 1 + 0j), ("y", 1j))


@dataclass(frozen=True, slots=True, kw_only=True)
class Datum(Generic[Task]):
    """A number (SI) that may be told of: its name as it is said, its unit ("mm", "deg", or "" for a ratio), and the
    task with another. signed: of either sign, as the coordinate of a point is."""

    name: Words
    unit: str
    value: float
    signed: bool = False
    put: Callable[[float], Task]


def of_field(design: Task, named: Named) -> Datum[Task] | None:
    """A quantity of the data, or where a line x = …, y = … lies; None where that is not given."""
    given = getattr(design, named.key, None)
    if given is None:
        return None
    line = isinstance(given, OnLine)
    at = _across(given) if isinstance(given, OnLine) else given.si
    return Datum(
        name=_called(named, given),
        unit=named.unit,
        value=at,
        signed=line,
        put=lambda value: put(design, {named.key: _moved(given, value) if line else quantity(value)}),
    )


def of_point(name: Words, at: complex, put: Callable[[complex], Task]) -> Iterator[Datum[Task]]:
    """The coordinates x and y of a point (m)."""
    for axis, way in _AXES:
        value = (at * way.conjugate()).real

        def moved(to: float, way: complex = way, value: float = value) -> Task:
            return put(at + (to - value) * way)

        said = Words(f"{name.zh} 的 {axis} 坐标", f"the {axis} of {name.en}")
        yield Datum(name=said, unit="mm", value=value, signed=True, put=moved)


def quantity(value: float) -> Quantity:
    """A number (SI) as a datum."""
    return Quantity(value, f"{value:.17g}")


def put(design: Task, data: dict[str, Any]) -> Task:
    """The design with these data in the place of its own; raises what the design raises."""
    return type(design)(**(dict(design) | data))


def put_in(design: Task, field: str, key: str, value: Any) -> Task:
    """The design with this value for a key of one of its tables."""
    return put(design, {field: getattr(design, field) | {key: value}})


def _called(named: Named, given: OnLine | Quantity) -> Words:
    """A quantity by its symbol, a line by what runs on it."""
    if not isinstance(given, OnLine):
        return Words.same(f"${named.symbol}$")
    axis = "x" if given.along == 1j else "y"
    whose = Words("导路", "guide") if named.key == _GUIDE else Words(f"{named.key} 所在直线", f"line of {named.key}")
    return Words(f"{whose.zh}的 {axis} 坐标", f"the {axis} of the {whose.en}")


def _across(line: OnLine) -> float:
    return line.at.real if line.along == 1j else line.at.imag


def _moved(line: OnLine, value: float) -> OnLine:
    return OnLine(complex(value) if line.along == 1j else 1j * value, line.along, f"{value:.17g}")
