"""Adding a file adds what it registers: the modules of a folder, imported when something in them is first asked for."""

from __future__ import annotations

from functools import cache
from importlib import import_module
from pkgutil import iter_modules


@cache
def load_modules(package: str) -> None:
    """Import every module of this package, so that what stands in them is registered; subpackages keep their own."""
    for module in iter_modules(import_module(package).__path__, f"{package}."):
        import_module(module.name)
