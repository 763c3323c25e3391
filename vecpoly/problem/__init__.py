"""Problem files: schema, loading with precise errors, the library, assignments. Called, it makes a problem of a dictionary."""

from __future__ import annotations

import sys
from types import ModuleType
from typing import Any


class _Package(ModuleType):
    """This package, which `vecpoly.problem({...})` calls: a package and a function of one name."""

    def __call__(self, *data: Any, **options: Any) -> Any:
        from .made import problem

        return problem(*data, **options)


sys.modules[__name__].__class__ = _Package
