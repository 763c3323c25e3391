"""One guess at how a column came about: the slip, in words, and the numbers to which it leads."""

from __future__ import annotations

from dataclasses import dataclass
from enum import StrEnum

from ...oracle import Motion
from ...words import Words
from ..table.target import Reals


class Slip(StrEnum):
    """The usual slips."""

    LENGTH = "another length"
    RATES = "rates with another length"
    FACTOR = "constant factor"
    OMEGA = "omega of the drive"
    UNIT = "unit"
    SIGN = "sign"
    ZERO = "zero of the angle"
    QUADRANT = "quadrant"
    BRANCH = "other assembly"
    SWAPPED = "another column"
    TERM = "missing term"
    DIVISOR = "missing divisor"
    DIFFERENCE = "finite difference"
    RADIANS = "degrees taken for radians"
    DRIVE = "position of the drive"
    FORMULA = "slips in a formula"


@dataclass(frozen=True, slots=True, kw_only=True, eq=False)
class Guess:
    """What the column would hold (SI); `parameter` is the length (m),
    factor or angle (rad) that was found; `fitted`: by fit.

    whole_turns: None compares angles but for whole turns, False does not.
    """

    slip: Slip
    words: Words
    expected: Reals
    parameter: float | None = None
    whole_turns: bool | None = None
    length: str = ""  # symbol of the length that was found
    odd: int = 0  # how many digits more than usual its number needs


Told = tuple[Slip, Words, Motion, Reals]  # a slip that is another motion, the motion, and the positions of its drive
