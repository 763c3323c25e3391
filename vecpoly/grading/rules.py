"""How marks follow from outcomes: what a lecturer may set."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

Lines = Literal["told", "given", "required"]


@dataclass(frozen=True, slots=True, kw_only=True)
class Rules:
    """Shares of the points of a quantity, and guards of the follow-through.

    close: of the accuracy mark between T and what is wrong. own: of what is right by own earlier values only. slip: of
    the method mark where a mistake is named. turned: of the method mark where a direction is wrong. unit: points lost
    once a problem where units are missing or wrong; printed: whether the sheet prints them. independent: nothing is
    continued from these. first: nothing is continued from others while these are not answered. reach: own values
    farther off than this factor are not continued from. drawing: whether verdicts on a drawing are only told, give the
    points of its lines where one is handed in, or are the only way to these points. open: answers may be handed in
    again, so that no feedback tells the right values. compensatory: whether numbers have their accuracy marks also
    where the vector equation is not, or wrongly, ticked.
    """

    close: float = 0.5
    own: float = 1.0
    slip: float = 0.5
    turned: float = 0.5
    unit: float = 0.5
    printed: bool = True
    independent: tuple[str, ...] = ()
    first: tuple[str, ...] = ()
    reach: float = 5.0
    few_digits: int = 2
    many_digits: int = 4
    following: bool = True
    drawing: Lines = "given"
    open: bool = False
    compensatory: bool = True


USUAL_RULES = Rules()
