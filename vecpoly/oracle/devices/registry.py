"""The exact answers of a device: a function registered by `answers`; adding the file adds it."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any

from ...devices.base import Device
from ...errors import NoMethodError
from ...foundation.plugins import load_modules
from ...words import Words

Values = Mapping[str, complex | float]
Exact = Callable[[Any], Values]
_EXACT: dict[type[Device], Exact] = {}


def answers(device: type[Device]) -> Callable[[Exact], Exact]:
    """Register the oracle of a device: data → key of every quantity it may be asked → value (complex: a vector)."""

    def register(exact: Exact) -> Exact:
        if device in _EXACT:
            raise ValueError(f"two oracles answer for the device {device.kind}")
        _EXACT[device] = exact
        return exact

    return register


def device_answers(device: Device) -> Values:
    """The exact value of every quantity of this device; raises NoMethodError where no oracle is on file."""
    load_modules("vecpoly.oracle.devices")
    try:
        return _EXACT[type(device)](device)
    except KeyError:
        raise NoMethodError(
            Words(f"解析法不能求解装置 {device.kind}", f"the oracle knows no device {device.kind}")
        ) from None
