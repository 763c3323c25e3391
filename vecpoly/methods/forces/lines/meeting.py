"""Where three forces meet (汇交点):
their lines of action and the resultant of several known forces on the diagram, lettered."""

from __future__ import annotations

from ....board.construction import View
from ....board.paper.marks import Dot, Point, Role
from ....plane import Points, dot, nominal, unit
from ....words import Words
from ..state import OFF_SHEET, Statics
from .resultant import Resultant

RESULTANT = "P"  # symbol of several known forces joined into one
LETTERS = "KOTXYZNU"
PAST = 12.0  # mm that a line of action is drawn past its ends
LONGEST = 260.0  # mm: a line of action longer than this is drawn at its pin only


def meeting_letter(st: Statics, x: Points, pin: Points) -> str:
    """A letter for a meeting point that nothing else on the diagram bears;
    none off the sheet and in the pass without friction."""
    if st.preliminary or abs(complex(nominal(x - pin))) > OFF_SHEET:
        return ""
    taken = {mark.label for mark in st.board.marks(View.MECHANISM) if isinstance(mark, Point)} | set(st.desk.at)
    return next((letter for letter in LETTERS if letter not in taken), "")


def draw_meeting(
    st: Statics, x: Points, others: tuple[Points, Points], third: tuple[Points, Points], labels: tuple[str, str]
) -> None:
    """The meeting point, and the lines that pass through it, on the diagram:
    the reaction's from the meeting point to its pin.

    labels: the meeting point's letter, and the reaction's symbol.
    """
    if st.preliminary or abs(complex(nominal(x - third[1]))) > OFF_SHEET:
        return
    board, (u, touch), (letter, symbol) = st.board, third, labels
    reach = float(nominal(dot(u, touch - x)))
    low, high = (min(0.0, reach) - PAST, max(0.0, reach) + PAST) if abs(reach) < LONGEST else (-22.0, 22.0)
    board.join(View.MECHANISM, x + u * low, x + u * high, Role.DIRECTION)
    board.plot(View.MECHANISM, x, letter, Dot.POINT)
    board.plot(View.MECHANISM, x + u * (low if abs(low) > abs(high) else high), symbol, Dot.NONE)
    for at in others:
        if 1.0 < abs(nominal(at - x)) < LONGEST:
            board.join(View.MECHANISM, at, x + unit(x - at) * 6.0, Role.DIRECTION)


def draw_resultant(st: Statics, load: Resultant) -> None:
    """Parallel forces laid off interchanged, and the line of action of several known forces joined into one."""
    if st.preliminary or load.is_couple or len(load.forces) < 2:
        return
    board = st.board
    if load.interchanged is not None:
        one, two = load.interchanged
        for start, end in (one, two, (one[0], two[0]), (one[1], two[1])):
            board.join(View.MECHANISM, start, end, Role.CONSTRUCTION)
    along = load.line.along
    board.join(View.MECHANISM, load.at - along * PAST, load.at + along * PAST, Role.DIRECTION)
    board.plot(View.MECHANISM, load.at - along * PAST, RESULTANT, Dot.NONE)


def known_forces(load: Resultant) -> Words:
    """The one known force, or the resultant P of several and how its line is found."""
    if len(load.forces) == 1:
        return load.symbols
    joined, joined_en = load.found
    return Words(
        f"已知力 {load.symbols.zh} 的合力 ${RESULTANT}$（{joined}）",
        f"the resultant ${RESULTANT}$ of {load.symbols.en} ({joined_en})",
    )


def in_point(letter: str) -> Words:
    """于点 K, in K; in the nameless point where they meet."""
    return Words(f"于 ${letter}$ 点", f"in ${letter}$") if letter else Words("于一点", "in one point")
