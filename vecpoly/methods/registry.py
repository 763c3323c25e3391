"""The open end of the program: a textbook method is a function registered by `method`;
adding the file adds the method."""

from __future__ import annotations

from collections.abc import Callable
from enum import StrEnum
from typing import Generic, Never, TypeVar, cast

from ..board.place import View
from ..errors import NoMethodError
from ..foundation.plugins import METHODS, load_entries, load_modules
from ..foundation.slotted import dataclass
from ..words import Words


class Stage(StrEnum):
    """The passes over the groups of a mechanism, in order."""

    POSITION = "position"
    CENTRES = "centres"
    CURVATURE = "curvature"
    PRESSURE = "pressure"
    VELOCITY = "velocity"
    ACCELERATION = "acceleration"
    FORCE = "force"
    MACHINE = "machine"
    BALANCE = "balance"

    @property
    def words(self) -> Words:
        """速度, velocity."""
        return Words(_STAGES[self], self.value)

    @property
    def view(self) -> View:
        """The kind of figure on which it draws."""
        polygons = {Stage.VELOCITY: View.VELOCITY, Stage.ACCELERATION: View.ACCELERATION, Stage.FORCE: View.FORCE}
        return polygons.get(self, View.MECHANISM)

    @property
    def folder(self) -> str:
        """The package whose files draw this stage."""
        own = (Stage.CENTRES, Stage.CURVATURE, Stage.PRESSURE, Stage.MACHINE, Stage.BALANCE)
        inside = "forces" if self is Stage.FORCE else self.value if self in own else "kinematics"
        return f"vecpoly.methods.{inside}"


_STAGES = {
    Stage.POSITION: "位置",
    Stage.CENTRES: "瞬心",
    Stage.CURVATURE: "曲率",
    Stage.PRESSURE: "压力角",
    Stage.VELOCITY: "速度",
    Stage.ACCELERATION: "加速度",
    Stage.FORCE: "反力",
    Stage.MACHINE: "等效量",
    Stage.BALANCE: "平衡",
}

State = TypeVar("State", contravariant=True)
Piece = TypeVar("Piece", contravariant=True)
Result = TypeVar("Result", covariant=True)
S = TypeVar("S")
P = TypeVar("P")
R = TypeVar("R")


@dataclass(frozen=True, slots=True, kw_only=True)
class Method(Generic[State, Piece, Result]):
    """A registered textbook method: what it covers, its title, its source, a library problem that shows it.

    draw: given the state of the drawing (a desk, a board under forces) and the piece that it solves.
    signature: its types as they are written.
    """

    stage: Stage
    group: str
    title: Words
    source: str
    example: str
    draw: Callable[[State, Piece], Result]
    signature: tuple[str, ...]


AnyMethod = Method[Never, Never, object]  # of whatever types: to be listed, not to be called
_METHODS: dict[tuple[Stage, str], AnyMethod] = {}


Draw = Callable[[S, P], R]


def method(
    *, stage: Stage, group: str, title: Words, source: str, example: str
) -> Callable[[Draw[S, P, R]], Draw[S, P, R]]:
    """Register a function as the method for one stage of one kind of group.

    Raises ValueError where another function already covers it, or where a file of the house stands in the folder of
    another stage. A module of another package names itself in the entry points ``vecpoly.methods`` instead.
    """

    def register(draw: Draw[S, P, R]) -> Draw[S, P, R]:
        if (stage, group) in _METHODS:
            raise ValueError(f"two methods cover the {stage} of {group}")
        if draw.__module__.startswith("vecpoly.") and not draw.__module__.startswith(f"{stage.folder}."):
            raise ValueError(
                f"a method that draws the {stage} belongs into the package {stage.folder}, not into {draw.__module__}"
            )
        _METHODS[stage, group] = Method(
            stage=stage, group=group, title=title, source=source, example=example, draw=draw, signature=_signature(draw)
        )
        return draw

    return register


@dataclass(frozen=True, slots=True)
class Door(Generic[S, P, R]):
    """Through which a planner calls the methods for some kind of piece.

    like: a function of the types that they all have.
    """

    like: Callable[[S, P], R]

    def find(self, stage: Stage, group: str) -> Method[S, P, R]:
        """The method for this stage and kind of group.

        Raises NoMethodError where none is on file, TypeError where it is for other pieces.
        """
        found, needed = find(stage, group), _signature(self.like)
        if found.signature != needed:
            raise TypeError(
                f"{found.draw.__name__} draws {' → '.join(found.signature)}; here {' → '.join(needed)} is needed"
            )
        return cast("Method[S, P, R]", found)


def _signature(draw: Callable[[S, P], R]) -> tuple[str, ...]:
    return tuple(str(kind) for kind in draw.__annotations__.values())


def methods() -> tuple[AnyMethod, ...]:
    """All registered methods, by stage and group."""
    for stage in Stage:
        load_modules(stage.folder)
    load_entries(METHODS)
    return tuple(sorted(_METHODS.values(), key=lambda m: (list(Stage).index(m.stage), m.group)))


def find(stage: Stage, group: str) -> AnyMethod:
    """The method for this stage and kind of group; raises NoMethodError where none is on file."""
    load_modules(stage.folder)
    if (stage, group) not in _METHODS:
        load_entries(METHODS)  # asked only where the house has nothing: other packages add methods, and replace none
    try:
        return _METHODS[stage, group]
    except KeyError:
        covered = ", ".join(sorted({g for s, g in _METHODS if s is stage}))
        raise NoMethodError(
            Words(
                f"没有求 {group} 组{stage.words.zh}的图解法（已有：{covered}）；仍可用 vecpoly exact 求解析解",
                f"no graphical method on file draws the {stage} of a group {group} (there are: {covered}); "
                "'vecpoly exact' still gives the analytic answers",
            )
        ) from None
