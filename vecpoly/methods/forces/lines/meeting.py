"""Where three forces meet (汇交点):
their lines of action and the resultant of several known forces on the diagram, lettered."""

from __future__ import annotations

from ....board.construction import View
from ....board.paper.extent import bounds, lasting
from ....board.paper.marks import Dot, Point, Role, Vector
from ....board.paper.tones import whose
from ....names import Named
from ....plane import Points, dot, nominal, unit
from ....words import Words
from ..state import OFF_SHEET, Statics
from .resultant import Resultant

LETTERS = "KOTXYZNU"
PAST = 12.0  # mm that a line of action is drawn past its ends
LONGEST = 260.0  # mm: a line of action longer than this is drawn at its pin only
STUB = 22.0  # mm that it then has to both sides
Other = tuple[Named | None, Points]  # a force, where it is one, and a point of its line
BEYOND = 30.0  # mm that a meeting point without friction may lie outside the figure


def meeting_letter(st: Statics, x: Points, pin: Points) -> str:
    """A letter for a meeting point that nothing else on the diagram bears; none off the sheet.

    Without friction it is K_0, where friction is to bring it to K.
    """
    if not _fits(st, x, pin):
        return ""
    taken = {mark.label for mark in st.board.marks(View.MECHANISM) if isinstance(mark, Point)} | set(st.desk.at)
    zero = "_0" if st.preliminary else ""
    return next((letter + zero for letter in LETTERS if not {letter, letter + zero} & taken), "")


def _fits(st: Statics, x: Points, pin: Points) -> bool:
    """Whether a meeting point is on the sheet; one without friction is not to make the figure much larger."""
    at = complex(nominal(x))
    if abs(at - complex(nominal(pin))) > OFF_SHEET:
        return False
    if not st.preliminary:
        return True
    low, high = bounds(lasting(st.board.marks(View.MECHANISM)))
    return low.real - BEYOND < at.real < high.real + BEYOND and low.imag - BEYOND < at.imag < high.imag + BEYOND


def draw_meeting(
    st: Statics, x: Points, others: tuple[Other, Other], third: tuple[Points, Points], labels: tuple[str, Named]
) -> None:
    """The meeting point, and the lines that pass through it, on the diagram:
    the reaction's from the meeting point to its pin.

    others: the lines that are known, each with a point. labels: the meeting point's letter, and the reaction.
    """
    board, (u, touch), (letter, named) = st.board, third, labels
    if not _fits(st, x, touch):
        if st.preliminary:
            _draw_stub(st, touch, u, named)
        return
    reach = float(nominal(dot(u, touch - x)))
    low, high = (min(0.0, reach) - PAST, max(0.0, reach) + PAST) if abs(reach) < LONGEST else (-STUB, STUB)
    role = st.ruled(Role.DIRECTION)
    board.join(View.MECHANISM, x + u * low, x + u * high, role, key=named.key)
    board.plot(View.MECHANISM, x, letter, Dot.POINT, key=letter if st.preliminary else "")
    board.plot(View.MECHANISM, x + u * (low if abs(low) > abs(high) else high), named.symbol, Dot.NONE, key=named.key)
    for one, at in others:
        if 1.0 < abs(nominal(at - x)) < LONGEST:
            end = x + unit(x - at) * 6.0
            board.join(View.MECHANISM, at, end, role, key=one.key if one else "")
            name_once(st, one, end)


def name_once(st: Statics, one: Named | None, end: Points) -> None:
    """The name of a reaction at an end of its line, where the diagram does not name it yet."""
    if one and not _is_named(st, one):
        st.board.plot(View.MECHANISM, end, one.symbol, Dot.NONE, key=one.key)


def _is_named(st: Statics, one: Named) -> bool:
    """Whether the diagram names this force already, or that which it stands for: a load, the same in the same joint."""
    marks = st.board.marks(View.MECHANISM)
    named = {mark.key for mark in marks if isinstance(mark, Point | Vector) and mark.label and mark.key}
    return not one.key.startswith("R_") or any(
        whose(key) == whose(one.key) and key.endswith("_0") == one.key.endswith("_0") for key in named
    )


def _draw_stub(st: Statics, touch: Points, u: Points, named: Named) -> None:
    """The reaction's line about its pin alone."""
    st.board.join(View.MECHANISM, touch - u * STUB, touch + u * STUB, Role.IDEAL, key=named.key)
    st.board.plot(View.MECHANISM, touch + u * STUB, named.symbol, Dot.NONE, key=named.key)


def resultant_of(st: Statics, link: str) -> str:
    """P_5: the symbol of the known forces of link 5 joined into one."""
    return f"P_{{{st.mech.number(link)}}}"


def draw_resultant(st: Statics, link: str, load: Resultant) -> None:
    """Parallel forces laid off interchanged, and the line of action of known forces and couples joined into one."""
    if st.preliminary or load.is_couple or load.is_single:
        return
    board = st.board
    if load.interchanged is not None:
        one, two = load.interchanged
        for start, end in (one, two, (one[0], two[0]), (one[1], two[1])):
            board.join(View.MECHANISM, start, end, Role.CONSTRUCTION)
    along = load.line.along
    board.join(View.MECHANISM, load.at - along * PAST, load.at + along * PAST, Role.DIRECTION)
    board.plot(View.MECHANISM, load.at - along * PAST, resultant_of(st, link), Dot.NONE)


def line_of_load(load: Resultant) -> Other:
    """The line of the known load; what is joined of several is no force of its own."""
    return load.forces[0].named if load.is_single else None, load.at


def known_forces(st: Statics, link: str, load: Resultant) -> Words:
    """The one known force, or the resultant of several and how its line is found."""
    if load.is_single:
        return load.symbols
    (joined, joined_en), symbol = load.found, resultant_of(st, link)
    return Words(
        f"已知力 {load.told.zh} 的合力 ${symbol}$（{joined}）",
        f"the resultant ${symbol}$ of {load.told.en} ({joined_en})",
    )


def in_point(letter: str) -> Words:
    """于点 K, at K; in the nameless point where they meet."""
    return Words(f"于 ${letter}$ 点", f"at ${letter}$") if letter else Words("于一点", "at one point")
