"""How an answer fares, and why."""

from __future__ import annotations

from dataclasses import dataclass
from enum import StrEnum

from ...words import Words
from ..key import NOTHING, Points
from ..reading.written import Written
from ..told.message import Message


class Outcome(StrEnum):
    """How an answer fares."""

    RIGHT = "right"
    CLOSE = "close"  # between T and what is wrong: right by another, less accurate hand
    SENSE = "sense"  # the size is right, its sense or sign is not
    UNSAID = "unsaid"  # the size is right, its sense is not said
    DIRECTION = "direction"  # the size is right, its direction is not
    WRONG = "wrong"
    BLANK = "blank"
    NONE = "none"
    UNREADABLE = "unreadable"
    AMBIGUOUS = "ambiguous"

    @property
    def words(self) -> Words:
        """In a word."""
        return _WORDS[self]

    @property
    def is_right(self) -> bool:
        """Whether the number is right."""
        return self in (Outcome.RIGHT, Outcome.CLOSE, Outcome.UNSAID)

    @property
    def for_a_person(self) -> bool:
        """Whether a person must look at it."""
        return self in (Outcome.UNREADABLE, Outcome.AMBIGUOUS)

    @property
    def answered(self) -> bool:
        """Whether there is something to compare."""
        return self.is_right or self in (Outcome.SENSE, Outcome.DIRECTION, Outcome.WRONG)


_WORDS = {
    Outcome.RIGHT: Words("正确", "right"),
    Outcome.CLOSE: Words("接近", "close"),
    Outcome.SENSE: Words("转向或符号错", "wrong sense"),
    Outcome.UNSAID: Words("正确，缺转向", "right, no sense"),
    Outcome.DIRECTION: Words("方向错", "wrong direction"),
    Outcome.WRONG: Words("错误", "wrong"),
    Outcome.BLANK: Words("未答", "blank"),
    Outcome.NONE: Words("未答", "none"),
    Outcome.UNREADABLE: Words("无法识别", "unreadable"),
    Outcome.AMBIGUOUS: Words("自相矛盾", "ambiguous"),
}


class Basis(StrEnum):
    """What a right answer is right by."""

    EXACT = "exact"
    OWN = "own"  # what follows from the student's own earlier values
    SLIP = "slip"  # what follows from a mistake that is told, and costs, elsewhere
    SCALE = "scale"  # the exact value times a wrong scale, which costs once
    DRAWN = "drawn"  # what stands on the student's own drawing


@dataclass(frozen=True, slots=True, kw_only=True)
class Finding:
    """The verdict on one quantity. value, off: in the unit of its key, the latter from the exact value."""

    key: str
    written: Written
    outcome: Outcome
    basis: Basis = Basis.EXACT
    value: float | None = None
    off: float | None = None
    messages: tuple[Message, ...] = ()
    earned: Points = NOTHING
    chain: int = 0  # through how many own values it was followed
    for_a_person: bool = False

    @property
    def is_right(self) -> bool:
        """Whether it is right, by what basis ever."""
        return self.outcome.is_right
