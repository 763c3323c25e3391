"""What may be told while answers can still be handed in again: no number from which the right one follows."""

from __future__ import annotations

from collections.abc import Sequence

from .message import Message, message
from .named import Told

_INSTEAD = {
    Told.OK: Told.RIGHT,
    Told.OK_RECKONED: Told.RIGHT,
    Told.OK_ROUNDED: Told.RIGHT,
    Told.CLOSE: Told.NEARLY,
    Told.WRONG: Told.NOT_RIGHT,
    Told.DIRECTION: Told.TURNED,
    Told.TICK_GIVEN: Told.NOT_RIGHT,
    Told.TICK_UNKNOWN: Told.NOT_RIGHT,
}
_LEFT_OUT = (Told.WRONG_FROM, Told.SWAPPED, Told.EXCHANGED, Told.DEMOTED)  # a share of the value gives it away, too


def veiled(said: Sequence[Message]) -> tuple[Message, ...]:
    """The same sentences without the numbers that give the answer away."""
    return tuple(message(_INSTEAD[one.id]) if one.id in _INSTEAD else one for one in said if one.id not in _LEFT_OUT)
