"""The base of every device: data read from the `data:` of a problem file, and the quantities that may be asked of it.

A new device is one file here (its data), one in `methods/devices` (how it is drawn) and one in `oracle/devices` (its
exact answers); nothing else is edited. Its `kind` is what a problem file writes after `device:`.
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterable, Mapping
from dataclasses import dataclass
from functools import cache
from typing import Annotated, Any, ClassVar, Protocol

from pydantic import BaseModel, BeforeValidator, ConfigDict, WithJsonSchema

from ..errors import FaultError, PluginError, UnknownNameError
from ..foundation.plugins import DEVICES, load_entries, load_modules
from ..names import Named
from ..units.reading import Dim, Quantity, not_negative, positive, pure, read
from ..words import Words


def _reader(dim: Dim, how: Callable[[object, Dim], Quantity]) -> Callable[[Any], Quantity]:
    def value(text: Any) -> Quantity:
        if isinstance(text, Quantity):
            return text
        return how(text, dim)

    return value


def _ratio(text: Any) -> Quantity:
    """A pure number, not negative."""
    if isinstance(text, Quantity):
        return text
    value = pure(text, "0.15")
    if value < 0:
        raise FaultError(
            Words(f"“{text}”不得为负；如写 0.15", f"'{text}' must not be negative; write e.g. 0.15"),
            code="out-of-range",
        )
    return Quantity(value, str(text))


def _efficiency(text: Any) -> Quantity:
    """A pure number in (0, 1]."""
    quantity = _ratio(text)
    if not 0 < quantity.si <= 1:
        raise FaultError(
            Words(
                f"“{quantity.text}”不是效率；应写大于 0 且不大于 1 的数，如 0.97",
                f"'{quantity.text}' is no efficiency; write a number above 0 and not above 1, e.g. 0.97",
            ),
            code="spelling",
        )
    return quantity


_QUANTITY = WithJsonSchema({"type": ["string", "number"]})
Length = Annotated[Quantity, BeforeValidator(_reader(Dim.LENGTH, positive)), _QUANTITY]
Beside = Annotated[Quantity, BeforeValidator(_reader(Dim.LENGTH, not_negative)), _QUANTITY]
Signed = Annotated[Quantity, BeforeValidator(_reader(Dim.LENGTH, read)), _QUANTITY]
Angle = Annotated[Quantity, BeforeValidator(_reader(Dim.ANGLE, read)), _QUANTITY]
ForceSize = Annotated[Quantity, BeforeValidator(_reader(Dim.FORCE, positive)), _QUANTITY]
Speed = Annotated[Quantity, BeforeValidator(_reader(Dim.SPEED, positive)), _QUANTITY]
Omega = Annotated[Quantity, BeforeValidator(_reader(Dim.OMEGA, read)), _QUANTITY]
Power = Annotated[Quantity, BeforeValidator(_reader(Dim.POWER, positive)), _QUANTITY]
Ratio = Annotated[Quantity, BeforeValidator(_ratio), _QUANTITY]
Efficiency = Annotated[Quantity, BeforeValidator(_efficiency), _QUANTITY]


Density = Annotated[Quantity, BeforeValidator(_reader(Dim.DENSITY, positive)), _QUANTITY]
Inertia = Annotated[Quantity, BeforeValidator(_reader(Dim.INERTIA, positive)), _QUANTITY]
WorkScale = Annotated[Quantity, BeforeValidator(_reader(Dim.MU_WORK, positive)), _QUANTITY]
Mass = Annotated[Quantity, BeforeValidator(_reader(Dim.MASS, positive)), _QUANTITY]
Torque = Annotated[Quantity, BeforeValidator(_reader(Dim.MOMENT, positive)), _QUANTITY]
Duration = Annotated[Quantity, BeforeValidator(_reader(Dim.TIME, positive)), _QUANTITY]
Positive = Annotated[Quantity, BeforeValidator(_ratio), _QUANTITY]


class Written(Protocol):
    """A datum that knows how it was written."""

    @property
    def text(self) -> str:
        """As in the problem file."""
        ...


def as_written(data: Iterable[tuple[str, Written | None]]) -> tuple[tuple[str, str], ...]:
    """Symbol and text of each datum that is given."""
    return tuple(
        (symbol, value.text.translate(_TYPED).replace("^2", "²").replace("^3", "³"))
        for symbol, value in data
        if value is not None
    )


_TYPED = str.maketrans({"*": "·"})


@dataclass(frozen=True, slots=True, kw_only=True)
class Tabled:
    """A moment (N·m) that is given at so many places that they stand in a table: over φ in °, over ω in rad/s."""

    over: str
    unit: str
    rows: tuple[tuple[str, str], ...]


class Device(BaseModel):
    """Data of a device, frozen; its fields are quantities in SI together with how they were written."""

    model_config = ConfigDict(extra="forbid", frozen=True, defer_build=True)
    kind: ClassVar[str] = ""
    ends_apart: ClassVar[bool] = False  # whether nothing is chosen by what is drawn on a figure apart: it is read there

    def __hash__(self) -> int:
        return hash((type(self), tuple(_hashable(value) for _, value in self)))

    def quantities(self) -> tuple[Named, ...]:
        """All that may be asked of it, in the order in which a solution gives it."""
        raise NotImplementedError

    def usual(self) -> tuple[Named, ...]:
        """What is asked of it where nothing is named."""
        return self.quantities()

    def given(self) -> tuple[tuple[str, str], ...]:
        """Symbol (notation of `formula`) and value as written of everything given, for the line 已知."""
        raise NotImplementedError

    def task(self, asked: Collection[str]) -> Words:
        """What it is, what its symbols are, from where its angles count: what is told where a problem file has no
        statement; asked: the keys of what is asked."""
        return Words.same("")

    def tabled(self) -> Mapping[str, Tabled | None]:
        """By their symbols what of this stands in a table; None of what stands in the line all the same."""
        return {}

    def told(self) -> tuple[Words, ...]:
        """What is given in words, where symbols and values do not say it."""
        return ()

    def noted(self, asked: Collection[str]) -> tuple[Words, ...]:
        """What is accepted and told, for it may not be meant; asked: the keys of what is asked."""
        return ()

    @property
    def size(self) -> float:
        """A length typical of its sketch (m), from which a scale is guessed before it is fitted;
        0: a sketch, or a block diagram, to no scale."""
        return 0.0

    @property
    def likely(self) -> Mapping[str, float]:
        """Unit → size of such quantities that the data make likely, where an answer may vanish: ΣW of a rotor."""
        return {}

    @property
    def directions(self) -> frozenset[str]:
        """Keys of directions, which have no value where what they are of vanishes."""
        return frozenset()

    @property
    def sensed(self) -> bool:
        """Whether its angular velocities have a sense: the data tell which way it turns."""
        return True

    @property
    def force(self) -> float:
        """A force typical of its polygons (N)."""
        return 100.0


def _hashable(value: Any) -> Any:
    """The same with mappings as sets of pairs, lists as tuples."""
    match value:
        case dict():
            return frozenset((key, _hashable(item)) for key, item in value.items())
        case list() | tuple():
            return tuple(_hashable(item) for item in value)
    return value


@cache
def kinds() -> dict[str, type[Device]]:
    """Every device on file, and of other packages (entry points ``vecpoly.devices``),
    by the name that a problem file uses.

    Raises PluginError where two have one name.
    """
    load_modules("vecpoly.devices")
    load_entries(DEVICES)
    return _by_name()


def kind_of(name: str) -> type[Device]:
    """The device class of this name, other packages being asked where the house has none; raises UnknownNameError."""
    load_modules("vecpoly.devices")
    if (own := _by_name().get(name)) is not None:
        return own
    if name not in kinds():
        raise UnknownNameError(
            Words(f"没有装置“{name}”；已有：{', '.join(kinds())}", f"no device '{name}'; known: {', '.join(kinds())}")
        )
    return kinds()[name]


def _by_name() -> dict[str, type[Device]]:
    found: dict[str, type[Device]] = {}
    for sub in sorted(Device.__subclasses__(), key=lambda s: s.kind):
        if sub.kind in found:
            places = f"{found[sub.kind].__module__}, {sub.__module__}"
            raise PluginError(
                Words(
                    f"两个装置同名“{sub.kind}”：{places}；请改其中一个的 kind",
                    f"two devices are named '{sub.kind}': {places}; give one another kind",
                ),
                code="plugin",
            )
        found[sub.kind] = sub
    return found
