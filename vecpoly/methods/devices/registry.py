"""A device's construction is a function registered by `device_method`; adding the file adds it."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Generic, Never, TypeVar, cast

from ...board.construction import Scale, View
from ...devices.base import Device
from ...errors import NoMethodError
from ...foundation.plugins import DEVICES, load_entries, load_modules
from ...problem.problem import Scales
from ...words import Words
from .bench import Bench

D = TypeVar("D", bound=Device)
Of = TypeVar("Of", bound=Device, contravariant=True)


@dataclass(frozen=True, slots=True, kw_only=True)
class DeviceMethod(Generic[Of]):
    """A registered construction: the device it solves, title, source, a library problem that shows it.

    called: of its main figure, where that is more than a sketch. scales: of its figures, from the device and the scales
    given; None where they are fitted to a sketch.
    """

    device: type[Device]
    title: Words
    source: str
    example: str
    draw: Callable[[Bench, Of], None]
    scales: Callable[[Of, Scales], Mapping[View, Scale]] | None = None
    called: Words | None = None


AnyDevice = DeviceMethod[Never]
_METHODS: dict[type[Device], AnyDevice] = {}


Draw = Callable[[Bench, D], None]


def device_method(
    device: type[D],
    *,
    title: Words,
    source: str,
    example: str,
    scales: Callable[[D, Scales], Mapping[View, Scale]] | None = None,
    called: Words | None = None,
) -> Callable[[Draw[D]], Draw[D]]:
    """Register the construction of a device; raises ValueError where it has one."""

    def register(draw: Draw[D]) -> Draw[D]:
        if device in _METHODS:
            raise ValueError(f"two constructions solve the device {device.kind}")
        made: DeviceMethod[D] = DeviceMethod(
            device=device, title=title, source=source, example=example, draw=draw, scales=scales, called=called
        )
        _METHODS[device] = made
        return draw

    return register


def device_methods() -> tuple[AnyDevice, ...]:
    """All registered constructions, by the device's name."""
    load_modules("vecpoly.methods.devices")
    load_entries(DEVICES)
    return tuple(sorted(_METHODS.values(), key=lambda m: m.device.kind))


def find_device(device: D) -> DeviceMethod[D]:
    """The construction of this device; raises NoMethodError where none is on file."""
    load_modules("vecpoly.methods.devices")
    try:
        return cast("DeviceMethod[D]", _METHODS[type(device)])  # what is on file under a class draws that class
    except KeyError:
        raise NoMethodError(
            Words(f"没有求解装置 {device.kind} 的图解法", f"no construction on file solves the device {device.kind}")
        ) from None
