"""All numbers in the data of a design, however deep they lie in them."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import fields, is_dataclass
from typing import Any, TypeVar

from pydantic import BaseModel

from ..foundation.slotted import replace
from .base import Design

D = TypeVar("D", bound=Design)
Change = Callable[[float], float]


def with_numbers(design: D, change: Change) -> D:
    """The design with every number changed, of complex ones each part.

    Counts, words, unit vectors and the number one (no quick return) stay as they are.
    """
    return _changed(design, change)  # type: ignore[no-any-return]


def _changed(value: Any, change: Change) -> Any:
    match value:
        case complex():
            return value if abs(value) == 1.0 else complex(change(value.real), change(value.imag))
        case float():
            return value if value == 1.0 else change(value)
        case tuple():
            return tuple(_changed(one, change) for one in value)
        case Mapping():
            return type(value)({key: _changed(one, change) for key, one in value.items()})  # type: ignore[call-arg]
        case BaseModel():
            return value.model_copy(update={name: _changed(one, change) for name, one in value})
    if is_dataclass(value) and not isinstance(value, type):
        return replace(value, **{field.name: _changed(getattr(value, field.name), change) for field in fields(value)})
    return value
