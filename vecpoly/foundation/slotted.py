"""Frozen slotted dataclasses whose `__init__` is written when the first of them is made.

The standard library writes and compiles six methods for each class, a third of a millisecond. A cold start imports
hundreds of classes and makes few of them: this is a sixth of its time. Fields, `replace`, `match`, equality, hash,
pickles and FrozenInstanceError are those of `dataclasses`.
"""

from __future__ import annotations

import dataclasses
from collections.abc import Callable, Iterator
from dataclasses import MISSING, Field, FrozenInstanceError, fields
from functools import cache
from operator import attrgetter
from typing import TYPE_CHECKING, Any, Literal, TypeVar

Method = Callable[..., Any]
MANY = 5  # slots from which a twin is filled
_WRITE = ("__setattr__", "__delattr__")  # Python writes at once only where both are those of every object
T = TypeVar("T")


def _dataclass(*, frozen: Literal[True], slots: Literal[True], kw_only: bool = False) -> Callable[[type], type]:
    """As `dataclasses.dataclass` with these arguments."""

    def decorated(cls: type) -> type:
        own = dict(vars(cls))
        made: type = dataclasses.dataclass(init=False, repr=False, eq=False, slots=True, kw_only=kw_only)(cls)
        for name, method in _methods(made).items():
            if own.get(name) is None:  # of a class with an __eq__ of its own, Python says that its __hash__ is None
                setattr(made, name, method)
        return made

    return decorated


def _replace(one: T, **changes: Any) -> T:
    """As `dataclasses.replace`, in a fraction of its time."""
    kind: Any = type(one)
    made: T = _copying(kind)(one, changes)
    return made


if TYPE_CHECKING:
    from dataclasses import dataclass as dataclass
    from dataclasses import replace as replace
else:
    dataclass, replace = _dataclass, _replace


@cache
def _copying(kind: Any) -> Method:
    """What makes one of this class from another with changes: slot by slot, or by what it is made of."""
    names, values = _given(kind)
    if len(names) == len(fields(kind)) and not hasattr(kind, "__post_init__") and (twin := _twin(kind)) is not None:
        return _copied(kind, twin)
    return lambda one, changes: kind(**dict(zip(names, values(one), strict=True)) | changes)


def _copied(kind: Any, twin: type) -> Method:
    """Its twin takes every value, then the changes, and becomes one of the class."""
    names = [one.name for one in fields(kind)]
    known: dict[str, Any] = {"new": object.__new__, "Open": twin, "Kind": kind, "names": frozenset(names)}
    lines = ["if not names.issuperset(changes):", " return Kind(**changes)", "made = new(Open)"]
    lines += [f"made.{name} = one.{name}" for name in names]
    lines += ["for name in changes:", " setattr(made, name, changes[name])", "made.__class__ = Kind", "return made"]
    exec("def copied(one, changes):\n " + "\n ".join(lines), known)
    copied: Method = known["copied"]
    return copied


@cache
def _twin(kind: Any) -> type | None:
    """A class of the same slots that may be written: when one of it is filled it becomes one of the frozen class, in
    less time than its slots take one by one. None of a class of which there can be none."""
    own = {"__slots__": kind.__dict__.get("__slots__", ())}
    try:
        twin = type(kind.__name__, kind.__bases__, own | {name: vars(object)[name] for name in _WRITE})
        object.__new__(twin).__class__ = kind
    except TypeError:  # of another layout, or of a class that makes its subclasses itself
        return None
    return twin


@cache
def _given(kind: Any) -> tuple[tuple[str, ...], Callable[[object], tuple[object, ...]]]:
    """What one of this class is made of: the names, and what gets the values."""
    names = tuple(one.name for one in fields(kind) if one.init)
    return names, attrgetter(*names) if len(names) > 1 else lambda one: tuple(getattr(one, name) for name in names)


def _methods(made: Any) -> dict[str, Method]:
    names = [one.name for one in fields(made) if one.compare]
    values = attrgetter(*names) if names else type

    def init(self: Any, *some: Any, **others: Any) -> None:
        """The first one made: from now on the class has its own."""
        made.__init__ = _written(made)
        made.__init__(self, *some, **others)

    def equal(self: Any, other: object) -> Any:
        if other is self:
            return True
        return values(self) == values(other) if other.__class__ is self.__class__ else NotImplemented

    def hashed(self: Any) -> int:
        return hash(values(self))

    return {"__init__": init, "__eq__": equal, "__hash__": hashed, **_COMMON}


def _written(made: Any) -> Method:
    """The `__init__` of this class: each value goes into its slot, past the `__setattr__` that refuses."""
    known: dict[str, Any] = {"MISSING": MISSING}
    for one in fields(made):
        known[f"set_{one.name}"] = getattr(made, one.name).__set__
        known[f"default_{one.name}"] = one.default if one.default_factory is MISSING else one.default_factory
    asked = sorted((one for one in fields(made) if one.init), key=lambda one: bool(one.kw_only))
    positional = [_parameter(one) for one in asked if not one.kw_only]
    named = [_parameter(one) for one in asked if one.kw_only]
    signature = ", ".join(["self", *positional, *["*"][: len(named)], *named])
    values = {one.name: value for one in fields(made) for value in _value(one)}
    lines = [f"set_{name}(self, {value})" for name, value in values.items()]
    if len(lines) >= MANY and (twin := _twin(made)) is not None:
        known |= {"Open": twin, "Kind": made, "become": object.__dict__["__class__"].__set__}
        quickly = [f"self.{name} = {value}" for name, value in values.items()]
        quickly = ["become(self, Open)", *quickly, "self.__class__ = Kind"]
        lines = ["if self.__class__ is Kind:", *(f" {one}" for one in quickly), "else:", *(f" {one}" for one in lines)]
    if hasattr(made, "__post_init__"):
        lines.append("self.__post_init__()")
    exec(f"def __init__({signature}):\n " + "\n ".join(lines or ["pass"]), known)
    written: Method = known["__init__"]
    written.__qualname__ = f"{made.__qualname__}.__init__"
    return written


def _parameter(one: Field[Any]) -> str:
    if one.default_factory is not MISSING:
        return f"{one.name}=MISSING"
    return one.name if one.default is MISSING else f"{one.name}=default_{one.name}"


def _value(one: Field[Any]) -> Iterator[str]:
    """What goes into the slot of a field; nothing of one that is left to `__post_init__`."""
    fresh = one.default_factory is not MISSING
    if one.init:
        yield f"default_{one.name}() if {one.name} is MISSING else {one.name}" if fresh else one.name
    elif fresh or one.default is not MISSING:
        yield f"default_{one.name}{'()' if fresh else ''}"


def _repr(self: Any) -> str:
    told = ", ".join(f"{one.name}={getattr(self, one.name)!r}" for one in fields(self) if one.repr)
    return f"{type(self).__qualname__}({told})"


def _setattr(self: Any, name: str, value: object) -> None:
    raise FrozenInstanceError(f"cannot assign to field {name!r}")


def _delattr(self: Any, name: str) -> None:
    raise FrozenInstanceError(f"cannot delete field {name!r}")


def _getstate(self: Any) -> list[Any]:
    return [getattr(self, one.name) for one in fields(self)]


def _setstate(self: Any, state: list[Any]) -> None:
    for one, value in zip(fields(self), state, strict=True):
        object.__setattr__(self, one.name, value)


_COMMON: dict[str, Method] = {
    "__repr__": _repr,
    "__setattr__": _setattr,
    "__delattr__": _delattr,
    "__getstate__": _getstate,
    "__setstate__": _setstate,
}
