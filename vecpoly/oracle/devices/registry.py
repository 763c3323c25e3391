"""The exact answers of a device: a function registered by `answers`; adding the file adds it."""

from __future__ import annotations

import importlib
import pkgutil
from collections.abc import Callable, Mapping
from functools import cache
from typing import Any

from ...devices.base import Device
from ...errors import NoMethodError

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


@cache
def _load_all() -> None:
    package = importlib.import_module("vecpoly.oracle.devices")
    for module in pkgutil.iter_modules(package.__path__, "vecpoly.oracle.devices."):
        importlib.import_module(module.name)


def device_answers(device: Device) -> Values:
    """The exact value of every quantity of this device; raises NoMethodError where no oracle is on file."""
    _load_all()
    try:
        return _EXACT[type(device)](device)
    except KeyError:
        raise NoMethodError(f"the oracle knows no device {device.kind}") from None
