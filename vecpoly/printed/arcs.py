"""An angle beside its arc has the digits of the line that tells it: θ = 40.0° on the sheet as in its step."""

from __future__ import annotations

from collections.abc import Mapping

from ..algebra.formula import named, plain
from ..board.acts import Angle
from ..board.construction import Construction, Figure, Step
from ..board.paper.marks import AngleMark
from ..foundation.slotted import replace
from .told import EQUALS

_DEGREE = "°"
_CLOSE = 0.06  # deg: by which a value to the tenth of the protractor may differ from itself


def arcs_as_told(construction: Construction) -> Construction:
    """The construction with the values beside its arcs as its lines have them, of what has a line."""
    told = {symbol: value for step in construction.steps for symbol, value in _told(step)}
    if not told:
        return construction
    acts = tuple(
        replace(act, label=_as_told(act.label, told)) if isinstance(act, Angle) else act for act in construction.acts
    )
    return replace(construction, acts=acts, figures=tuple(_relabelled(one, told) for one in construction.figures))


def _told(step: Step) -> list[tuple[str, str]]:
    """Symbol and value of each line of a step that ends with an angle."""
    lines = [plain(line).split(EQUALS) for line in step.formulas]
    return [(line[0], line[-1]) for line in lines if len(line) > 1 and line[-1].endswith(_DEGREE)]


def _relabelled(figure: Figure, told: Mapping[str, str]) -> Figure:
    if not any(isinstance(mark, AngleMark) for mark in figure.marks):
        return figure
    marks = tuple(
        replace(mark, label=_as_told(mark.label, told)) if isinstance(mark, AngleMark) else mark
        for mark in figure.marks
    )
    return replace(figure, marks=marks)


def _as_told(label: str, told: Mapping[str, str]) -> str:
    """θ = 40° where the line has 40.0°; another angle of the same name keeps its own."""
    symbol, equals, value = label.rpartition(EQUALS)
    found = told.get(plain(named(symbol)), "") if symbol else ""
    own, line = _size(value), _size(found)
    if own is None or line is None or abs(own - line) > _CLOSE:
        return label
    return f"{symbol}{equals}{found}"


def _size(text: str) -> float | None:
    """The number before the sign of degrees; None of what is none."""
    number = text.removesuffix(_DEGREE).replace("−", "-")
    try:
        return float(number) if text.endswith(_DEGREE) else None
    except ValueError:
        return None
