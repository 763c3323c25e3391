"""A number on paper that knows the acts it came from: whatever is computed from it knows them too.

The acts of the board give such numbers and take them again, so that an act knows its inputs without being told. Plane
geometry, numpy's
elementwise functions and the arithmetic of quantities pass them on; only `nominal`, and turning one into a plain
`complex`, `float` or `bool`
(for marks, words and choices), forgets them.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from typing import Any, TypeVar

import numpy as np

Acts = frozenset[int]  # numbers of acts, in the order of the sheet
NO_ACTS: Acts = frozenset()
Number = TypeVar("Number")


class Traced:
    """A point, a direction or a length with the acts that it came from;
    `value` is a number or an array with one for each hand."""

    __slots__ = ("acts", "value")

    def __init__(self, value: Any, acts: Acts) -> None:
        self.value = value
        self.acts = acts

    def __repr__(self) -> str:
        return f"{self.value!r} of acts {sorted(self.acts)}"

    # -- arithmetic -------------------------------------------------------------------------------------------

    def __add__(self, other: Any) -> Traced:
        return (
            _with(self.value + other.value, self, other)
            if type(other) is Traced
            else Traced(self.value + other, self.acts)
        )

    def __radd__(self, other: Any) -> Traced:
        return Traced(other + self.value, self.acts)

    def __sub__(self, other: Any) -> Traced:
        return (
            _with(self.value - other.value, self, other)
            if type(other) is Traced
            else Traced(self.value - other, self.acts)
        )

    def __rsub__(self, other: Any) -> Traced:
        return Traced(other - self.value, self.acts)

    def __mul__(self, other: Any) -> Traced:
        return (
            _with(self.value * other.value, self, other)
            if type(other) is Traced
            else Traced(self.value * other, self.acts)
        )

    def __rmul__(self, other: Any) -> Traced:
        return Traced(other * self.value, self.acts)

    def __truediv__(self, other: Any) -> Traced:
        return (
            _with(self.value / other.value, self, other)
            if type(other) is Traced
            else Traced(self.value / other, self.acts)
        )

    def __rtruediv__(self, other: Any) -> Traced:
        return Traced(other / self.value, self.acts)

    def __pow__(self, power: Any) -> Traced:
        return Traced(self.value**power, self.acts)

    def __mod__(self, other: Any) -> Traced:
        return Traced(self.value % bare(other), acts_of(self, other))

    def __neg__(self) -> Traced:
        return Traced(-self.value, self.acts)

    def __abs__(self) -> Traced:
        return Traced(abs(self.value), self.acts)

    def __lt__(self, other: Any) -> Any:
        return self.value < bare(other)

    def __le__(self, other: Any) -> Any:
        return self.value <= bare(other)

    def __gt__(self, other: Any) -> Any:
        return self.value > bare(other)

    def __ge__(self, other: Any) -> Any:
        return self.value >= bare(other)

    def __eq__(self, other: object) -> Any:
        return self.value == bare(other)

    def __ne__(self, other: object) -> Any:
        return self.value != bare(other)

    __hash__ = None  # type: ignore[assignment]  # like an array

    # -- as numpy's arrays ------------------------------------------------------------------------------------

    @property
    def real(self) -> Traced:
        """The part to the right."""
        return Traced(self.value.real, self.acts)

    @property
    def imag(self) -> Traced:
        """The part upwards."""
        return Traced(self.value.imag, self.acts)

    @property
    def ndim(self) -> int:
        """1 for many hands, 0 for one."""
        return np.ndim(self.value)

    @property
    def shape(self) -> tuple[int, ...]:
        """(n,) of n hands, () of one."""
        return np.shape(self.value)

    def reshape(self, *shape: Any) -> Traced:
        """The same numbers in another shape."""
        return Traced(np.reshape(self.value, shape[0] if len(shape) == 1 else shape), self.acts)

    def __getitem__(self, which: Any) -> Traced:
        return Traced(self.value[which] if np.ndim(self.value) or which != () else self.value, self.acts)

    def __iter__(self) -> Iterator[Any]:
        return iter(self.value)

    def __complex__(self) -> complex:
        return complex(self.value)

    def __float__(self) -> float:
        return float(self.value)

    def __bool__(self) -> bool:
        return bool(self.value)

    def __array__(self, dtype: Any = None, copy: bool | None = None) -> Any:
        return np.array(self.value, dtype=dtype)

    def __array_ufunc__(self, ufunc: Any, method: str, *inputs: Any, **options: Any) -> Any:
        found = getattr(ufunc, method)(*map(bare, inputs), **options)
        return _joined(found, inputs)

    def __array_function__(self, function: Any, types: Any, args: Any, options: Any) -> Any:
        seen: list[Traced] = []
        found = function(*_stripped(args, seen), **{name: _stripped(value, seen) for name, value in options.items()})
        return _joined(found, seen)


def traced(value: Number, acts: Acts) -> Number:
    """The number, knowing these acts; it behaves like the number that it stands for, and is typed as such.
    One of no acts is the number."""
    if not acts:
        return bare(value)  # type: ignore[no-any-return]
    return Traced(bare(value), acts)  # type: ignore[return-value]


def bare(value: Any) -> Any:
    """The number alone."""
    return value.value if type(value) is Traced else value


def acts_of(*values: Any) -> Acts:
    """The acts that these numbers came from; of a line or a tuple those of its parts."""
    known: Acts = NO_ACTS
    for value in values:
        kind = type(value)
        if kind is Traced:
            known = known | value.acts if known and known is not value.acts else value.acts
        elif kind is complex or kind is float or kind is np.complex128 or kind is np.float64 or kind is np.ndarray:
            continue
        elif isinstance(value, tuple):
            known = known | acts_of(*value)
        elif hasattr(value, "along") and hasattr(value, "at"):
            known = known | acts_of(value.at, value.along)
    return known


def _with(value: Any, one: Traced, other: Traced) -> Traced:
    return Traced(value, one.acts if one.acts is other.acts else one.acts | other.acts)


def _joined(found: Any, inputs: Iterable[Any]) -> Any:
    """What numpy gave, knowing the acts of all that it was given; truth values and counts know none."""
    if isinstance(found, tuple | list):
        return type(found)(_joined(one, inputs) for one in found)
    kind = getattr(getattr(found, "dtype", None), "kind", "f" if isinstance(found, float | complex) else "")
    return Traced(found, acts_of(*inputs)) if kind in "fc" and kind else found


def _stripped(value: Any, seen: list[Traced]) -> Any:
    if type(value) is Traced:
        seen.append(value)
        return value.value
    if isinstance(value, tuple | list):
        return type(value)(_stripped(one, seen) for one in value)
    return value
