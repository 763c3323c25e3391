"""What is told to somebody who checks his own answers: nobody marks them by hand, and no points are taken off."""

from __future__ import annotations

from collections.abc import Sequence

from .message import Message, message
from .named import Told

_INSTEAD = {
    Told.UNREADABLE: Told.NOT_READ,
    Told.AMBIGUOUS: Told.CONTRADICTION,
    Told.UNDRAWABLE: Told.NOT_CLOSED,
    Told.UNIT_WRONG: Told.NO_UNIT_OF_IT,
    Told.UNIT_NONE: Told.HAS_NO_UNIT,
    Told.UNIT_MISSING: Told.NO_UNIT,
    Told.OK_OWN: Told.FOLLOWS_OWN,
    Told.OK_SLIP: Told.FOLLOWS_SLIP,
    Told.OK_DRAWN: Told.FOLLOWS_DRAWN,
    Told.SCALE_CONST: Told.ONE_FACTOR,
}
_RIGHT = (Told.OK, Told.OK_RECKONED, Told.OK_ROUNDED)
_MISNAMED = (Told.UNIT_WRONG, Told.UNIT_NONE, Told.NO_UNIT_OF_IT, Told.HAS_NO_UNIT)


def alone(said: Sequence[Message]) -> tuple[Message, ...]:
    """The same sentences without what is done with a class; of a wrong unit that the number alone is right."""
    misnamed = has_wrong_unit(said)
    kept = (message(Told.NUMBER_RIGHT) if misnamed and one.id in _RIGHT else one for one in said)
    return tuple(message(_INSTEAD.get(one.id, one.id), **one.numbers) for one in kept)


def has_wrong_unit(said: Sequence[Message]) -> bool:
    """Whether what was written has the unit of something else."""
    return any(one.id in _MISNAMED for one in said)
