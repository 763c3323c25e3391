"""How the data of rotors are written: masses, products, densities; a question mark for what is sought."""

from __future__ import annotations

import re
from collections.abc import Callable
from typing import Annotated, Any

from pydantic import BaseModel, BeforeValidator, ConfigDict, WithJsonSchema

from ...errors import FaultError
from ...units.reading import Dim, Quantity, not_negative, positive, read
from ...words import Words

SOUGHT = Quantity(0.0, "?")
_TEXT = WithJsonSchema({"type": ["string", "number"]})


class Entry(BaseModel):
    """An entry of a device's data, frozen."""

    model_config = ConfigDict(extra="forbid", frozen=True)


def is_sought(value: Quantity | None) -> bool:
    """Whether the value is what is to be found."""
    return value is not None and value.text == SOUGHT.text


def _reader(dim: Dim, how: Callable[[object, Dim], Quantity], *, sought: bool = False) -> Callable[[Any], Quantity]:
    def value(text: Any) -> Quantity:
        if isinstance(text, Quantity):
            return text
        if sought and str(text).strip() in ("?", "？"):
            return SOUGHT
        return how(text, dim)

    return value


def _positive(dim: Dim) -> BeforeValidator:
    return BeforeValidator(_reader(dim, positive))


MassSize = Annotated[Quantity, _positive(Dim.MASS), _TEXT]
MassOrNone = Annotated[Quantity, BeforeValidator(_reader(Dim.MASS, not_negative)), _TEXT]
Product = Annotated[Quantity, _positive(Dim.PRODUCT), _TEXT]
Density = Annotated[Quantity, _positive(Dim.DENSITY), _TEXT]
Turning = Annotated[Quantity, _positive(Dim.OMEGA), _TEXT]
MassOrSought = Annotated[Quantity, BeforeValidator(_reader(Dim.MASS, positive, sought=True)), _TEXT]
Bearing = Annotated[Quantity, BeforeValidator(_reader(Dim.ANGLE, read, sought=True)), _TEXT]

_NAME = re.compile(r"[A-Za-z0-9]{1,3}")


def named_well(names: list[str], what: Words, taken: tuple[str, ...]) -> None:
    """FaultError for a name that cannot be a subscript, or that means something else."""
    for name in names:
        if not _NAME.fullmatch(name) or name in taken:
            raise FaultError(
                Words(
                    f"{what.zh}的名称“{name}”不能作下标：用一至三个字母或数字，且不用 {'、'.join(taken)}",
                    f"'{name}' cannot be the subscript of {what.en}: take one to three letters or digits, but not "
                    f"{', '.join(taken)}",
                ),
                name,
                code="spelling",
            )
