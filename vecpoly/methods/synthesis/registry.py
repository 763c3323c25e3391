"""The construction of a task of synthesis is a function registered by `design_method`; adding the file adds it."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Generic, Never, TypeVar, cast

from ...board.paper.titled import SYNTHESIS
from ...designs.base import Design
from ...errors import NoMethodError
from ...foundation.plugins import load_modules
from ...words import Words
from .draft import Draft

D = TypeVar("D", bound=Design)
Of = TypeVar("Of", bound=Design, contravariant=True)
Draw = Callable[[Draft, D], None]


@dataclass(frozen=True, slots=True, kw_only=True)
class DesignMethod(Generic[Of]):
    """A registered construction: the task it solves, title, source, a library problem that shows it."""

    design: type[Design]
    title: Words
    source: str
    example: str
    draw: Callable[[Draft, Of], None]
    sheet: Words


AnyDesign = DesignMethod[Never]
_METHODS: dict[type[Design], AnyDesign] = {}


def design_method(
    design: type[D], *, title: Words, source: str, example: str, sheet: Words = SYNTHESIS
) -> Callable[[Draw[D]], Draw[D]]:
    """Register the construction of a task of synthesis; raises ValueError where it has one.

    sheet: what its figure is called.
    """

    def register(draw: Draw[D]) -> Draw[D]:
        if design in _METHODS:
            raise ValueError(f"two constructions solve the synthesis {design.kind}")
        made: DesignMethod[D] = DesignMethod(
            design=design, title=title, source=source, example=example, draw=draw, sheet=sheet
        )
        _METHODS[design] = made
        return draw

    return register


def design_methods() -> tuple[AnyDesign, ...]:
    """All registered constructions, by the name of the task."""
    load_modules("vecpoly.methods.synthesis")
    return tuple(sorted(_METHODS.values(), key=lambda m: m.design.kind))


def find_design(design: D) -> DesignMethod[D]:
    """The construction of this task; raises NoMethodError where none is on file."""
    load_modules("vecpoly.methods.synthesis")
    try:
        return cast("DesignMethod[D]", _METHODS[type(design)])  # what is on file under a class draws that class
    except KeyError:
        raise NoMethodError(
            Words(
                f"没有求解综合题型 {design.kind} 的图解法",
                f"no construction on file solves the synthesis {design.kind}",
            )
        ) from None
