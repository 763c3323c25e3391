"""The open end of the program: a textbook method is a function registered by `method`; adding the file adds the method."""

from __future__ import annotations

import importlib
import pkgutil
from collections.abc import Callable
from dataclasses import dataclass
from enum import StrEnum
from functools import cache
from typing import Any

from ..errors import NoMethodError
from ..words import Words


class Stage(StrEnum):
    """The passes over the groups of a mechanism, in order."""

    POSITION = "position"
    CENTRES = "centres"
    VELOCITY = "velocity"
    ACCELERATION = "acceleration"
    FORCE = "force"


Draw = Callable[[Any, Any], Any]  # (desk or statics, what it is about)


@dataclass(frozen=True, slots=True, kw_only=True)
class Method:
    """A registered textbook method: what it covers, its title, its source, a library problem that shows it."""

    stage: Stage
    group: str
    title: Words
    source: str
    example: str
    draw: Draw


_METHODS: dict[tuple[Stage, str], Method] = {}


def method(*, stage: Stage, group: str, title: Words, source: str, example: str) -> Callable[[Draw], Draw]:
    """Register a function as the method for one stage of one kind of group.

    Raises ValueError where another function already covers it.
    """

    def register(draw: Draw) -> Draw:
        if (stage, group) in _METHODS:
            raise ValueError(f"two methods cover the {stage} of {group}")
        _METHODS[stage, group] = Method(stage=stage, group=group, title=title, source=source, example=example, draw=draw)
        return draw

    return register


@cache
def _load_all() -> None:
    package = importlib.import_module("vecpoly.methods")
    for module in pkgutil.walk_packages(package.__path__, "vecpoly.methods."):
        if module.name.startswith("vecpoly.methods.devices"):
            continue  # they have a registry of their own
        importlib.import_module(module.name)


def methods() -> tuple[Method, ...]:
    """All registered methods, by stage and group."""
    _load_all()
    return tuple(sorted(_METHODS.values(), key=lambda m: (list(Stage).index(m.stage), m.group)))


def find(stage: Stage, group: str) -> Method:
    """The method for this stage and kind of group; raises NoMethodError where none is on file."""
    _load_all()
    try:
        return _METHODS[stage, group]
    except KeyError:
        covered = ", ".join(sorted({g for s, g in _METHODS if s is stage}))
        raise NoMethodError(
            f"no graphical method on file draws the {stage} of a group {group} (there are: {covered}); "
            f"'vecpoly exact' still gives the analytic answers"
        ) from None
