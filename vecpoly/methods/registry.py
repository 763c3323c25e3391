"""The open end of the program: a textbook method is a function registered by `method`; adding the file adds the method."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from enum import StrEnum
from typing import Any

from ..errors import NoMethodError
from ..plugins import METHODS, load_entries, load_modules
from ..words import Words


class Stage(StrEnum):
    """The passes over the groups of a mechanism, in order."""

    POSITION = "position"
    CENTRES = "centres"
    VELOCITY = "velocity"
    ACCELERATION = "acceleration"
    FORCE = "force"

    @property
    def words(self) -> Words:
        """速度, velocity."""
        return Words(_STAGES[self], self.value)

    @property
    def folder(self) -> str:
        """The package whose files draw this stage."""
        inside = {Stage.CENTRES: "centres", Stage.FORCE: "forces"}.get(self, "kinematics")
        return f"vecpoly.methods.{inside}"


_STAGES = {
    Stage.POSITION: "位置", Stage.CENTRES: "瞬心", Stage.VELOCITY: "速度", Stage.ACCELERATION: "加速度", Stage.FORCE: "反力",
}  # fmt: skip

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

    Raises ValueError where another function already covers it, or where a file of the house stands in the folder of another stage.
    A module of another package names itself in the entry points ``vecpoly.methods`` instead.
    """

    def register(draw: Draw) -> Draw:
        if (stage, group) in _METHODS:
            raise ValueError(f"two methods cover the {stage} of {group}")
        if draw.__module__.startswith("vecpoly.") and not draw.__module__.startswith(f"{stage.folder}."):
            raise ValueError(f"a method that draws the {stage} belongs into the package {stage.folder}, not into {draw.__module__}")
        _METHODS[stage, group] = Method(stage=stage, group=group, title=title, source=source, example=example, draw=draw)
        return draw

    return register


def methods() -> tuple[Method, ...]:
    """All registered methods, by stage and group."""
    for stage in Stage:
        load_modules(stage.folder)
    load_entries(METHODS)
    return tuple(sorted(_METHODS.values(), key=lambda m: (list(Stage).index(m.stage), m.group)))


def find(stage: Stage, group: str) -> Method:
    """The method for this stage and kind of group; raises NoMethodError where none is on file."""
    load_modules(stage.folder)
    if (stage, group) not in _METHODS:
        load_entries(METHODS)  # asked only where the house has nothing: other packages add methods, and replace none
    try:
        return _METHODS[stage, group]
    except KeyError:
        covered = ", ".join(sorted({g for s, g in _METHODS if s is stage}))
        raise NoMethodError(Words(
            f"没有求 {group} 组{stage.words.zh}的图解法（已有：{covered}）；仍可用 vecpoly exact 求解析解",
            f"no graphical method on file draws the {stage} of a group {group} (there are: {covered}); 'vecpoly exact' still gives the analytic answers")) from None
