"""Problem files: schema, loading with precise errors, the library, assignments.
Called, it makes a problem of a dictionary."""

from __future__ import annotations

import sys
from importlib import import_module
from types import ModuleType
from typing import Any


class _Package(ModuleType):
    """This package, which `vecpoly.problem({...})` calls:
    a package and a function of one name, which stands at the door."""

    def __call__(self, *data: Any, **options: Any) -> Any:
        return import_module("vecpoly.door").problem(*data, **options)


sys.modules[__name__].__class__ = _Package
