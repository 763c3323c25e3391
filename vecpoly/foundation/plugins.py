"""Adding a file adds what it registers: the modules of a folder, and those that other packages name, imported when they
are first asked for."""

from __future__ import annotations

from collections.abc import Iterator
from functools import cache
from importlib import import_module
from importlib.metadata import EntryPoint, entry_points
from pkgutil import iter_modules
from typing import Generic, TypeVar

from ..errors import PluginError
from ..words import Words

T = TypeVar("T")
METHODS, DEVICES = (
    "vecpoly.methods",
    "vecpoly.devices",
)  # the groups of entry points: each names a module that registers something


@cache
def load_modules(package: str) -> None:
    """Import every module of this package, so that what stands in them is registered; subpackages keep their own."""
    for _ in each_module(package):
        pass


def each_module(package: str) -> Iterator[str]:
    """The same one after the other, for who may have enough before the last."""
    for module in iter_modules(import_module(package).__path__, f"{package}."):
        import_module(module.name)
        yield module.name


class BySubject(Generic[T]):
    """What the modules of a package register for what a problem may be about."""

    def __init__(self, package: str) -> None:
        self._package = package
        self._found: dict[type, T] = {}

    def put(self, subject: type, registered: T, twice: str) -> None:
        """Register it; raises ValueError, in these words, where something is on file."""
        if subject in self._found:
            raise ValueError(f"{twice} a {subject.__name__}")
        self._found[subject] = registered

    def find(self, subject: object) -> T | None:
        """What is on file for this, or for the nearest class above its own."""
        if not any(type(subject) in self._found for _ in each_module(self._package)):
            load_modules(self._package)
        return next((self._found[kind] for kind in type(subject).__mro__ if kind in self._found), None)


@cache
def load_entries(group: str) -> None:
    """Import the modules that installed packages name in this group of entry points. Raises PluginError where one
    fails."""
    for entry in entry_points(group=group):
        try:
            entry.load()
        except Exception as error:
            raise _broken(entry, error) from error


def _broken(entry: EntryPoint, error: Exception) -> PluginError:
    package = entry.dist.name if entry.dist else entry.value
    why = f"{type(error).__name__}: {error}"
    return PluginError(
        Words(
            f"插件 {package}（{entry.value}）不能载入：{why}；请改正、升级或卸载它",
            f"the plug-in {package} ({entry.value}) cannot be loaded: {why}; mend, update or uninstall it",
        ),
        code="plugin",
        numbers={"package": package, "module": entry.value},
    )
