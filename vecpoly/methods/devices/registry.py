"""A device's construction is a function registered by `device_method`; adding the file adds it."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

from ...devices.base import Device
from ...errors import NoMethodError
from ...plugins import DEVICES, load_entries, load_modules
from ...words import Words
from .bench import Bench

Draw = Callable[[Bench, Any], None]


@dataclass(frozen=True, slots=True, kw_only=True)
class DeviceMethod:
    """A registered construction: the device it solves, title, source, a library problem that shows it."""

    device: type[Device]
    title: Words
    source: str
    example: str
    draw: Draw


_METHODS: dict[type[Device], DeviceMethod] = {}


def device_method(device: type[Device], *, title: Words, source: str, example: str) -> Callable[[Draw], Draw]:
    """Register the construction of a device; raises ValueError where it has one."""

    def register(draw: Draw) -> Draw:
        if device in _METHODS:
            raise ValueError(f"two constructions solve the device {device.kind}")
        _METHODS[device] = DeviceMethod(device=device, title=title, source=source, example=example, draw=draw)
        return draw

    return register


def device_methods() -> tuple[DeviceMethod, ...]:
    """All registered constructions, by the device's name."""
    load_modules("vecpoly.methods.devices")
    load_entries(DEVICES)
    return tuple(sorted(_METHODS.values(), key=lambda m: m.device.kind))


def find_device(device: Device) -> DeviceMethod:
    """The construction of this device; raises NoMethodError where none is on file."""
    load_modules("vecpoly.methods.devices")
    try:
        return _METHODS[type(device)]
    except KeyError:
        raise NoMethodError(Words(
            f"没有求解装置 {device.kind} 的图解法",
            f"no construction on file solves the device {device.kind}")) from None
