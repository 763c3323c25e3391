"""Branch statements that cannot both be so, wherever the mechanism stands: C left of BD and C right of BD."""

from __future__ import annotations

from collections.abc import Hashable, Mapping

from ...errors import FaultError
from ...mechanism.assembly.statements import Form, Shaped, SideOf, Statement
from ...mechanism.dimensions.placements import Side
from ...words import Words

_FIRST = (Side.LEFT, Side.ABOVE)


def check_opposed(text: str, statement: Statement, told: Mapping[str, Statement]) -> None:
    """Raises FaultError where one of those told before, by its text, says the opposite."""
    about, sense = _said(statement)
    for before, other in told.items():
        if _said(other) == (about, not sense):
            raise FaultError(
                Words(
                    f"'{text}' 与 '{before}' 互相矛盾；请只保留正确的一条",
                    f"'{text}' and '{before}' contradict each other; keep the one that is meant",
                ),
                code="contradiction",
            )


def _said(statement: Statement) -> tuple[Hashable, bool]:
    """What the statement is about, and which of the two it says."""
    match statement:
        case Shaped(corners=corners, form=form):
            return ("form", frozenset(corners)), form is Form.PARALLELOGRAM
        case SideOf(point=point, side=side, ref=(other,)):
            axis = "across" if side in (Side.LEFT, Side.RIGHT) else "up"
            return (axis, frozenset((point, other))), (side in _FIRST) == (point < other)
        case SideOf(point=point, side=side, ref=(one, two)) if side in (Side.LEFT, Side.RIGHT):
            letters = (point, one, two)  # C left of BD: BDC is gone round counter-clockwise, and so are CBD and DCB
            turned = sum(a > b for i, a in enumerate(letters) for b in letters[i + 1 :]) % 2 == 1
            return ("turn", frozenset(letters)), (side is Side.LEFT) != turned
        case SideOf(point=point, side=side, ref=ref):
            return ("over", point, frozenset(ref)), side is Side.ABOVE
    raise AssertionError(statement)
