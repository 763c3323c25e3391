"""The force polygon of one link: its known forces head to tail,
the unknown ones closing it, letters a b c ... at the corners; the next polygon goes on with d e f ..."""

from __future__ import annotations

from collections.abc import Sequence

from ....board.construction import Pane, View
from ....board.paper.marks import Dot
from ....plane import Reals, nominal
from ....vector.close import close
from ....vector.equation import UNKNOWN, Equation, Term
from ....words import Words
from ..acting import Drawn
from ..lines.arms import newtons
from ..lines.resultant import Resultant
from ..state import Statics

_ROW = "abcdefgklmnqrstuvw"
_LETTERS = (*_ROW, *(f"{letter}_{turn}" for turn in range(1, 10) for letter in _ROW))  # of as many corners as need be


def corner_letters(st: Statics, pane: Pane | None = None) -> tuple[str, ...]:
    """The letters of the corners of a polygon (`pane`, where it is begun): none that another polygon has, so that the
    two letters of a side name one side; without friction, where friction is to follow, a_0 b_0 c_0 ..."""
    taken, zero = st.board.lettered(View.FORCE, besides=pane), "_0" if st.preliminary else ""
    return tuple(letter for one in _LETTERS if (letter := one + zero) not in taken)


def pane_of(st: Statics, link: str) -> Pane:
    """The figure of the link's polygon."""
    number = st.mech.number(link)
    return st.polygon(number, Words(f"构件 {number} 的力多边形", f"Force polygon of link {number}"))


def draw_polygon(
    st: Statics, link: str, load: Resultant, unknown: Sequence[Term], figure: Pane | None = None
) -> dict[str, Drawn]:
    """ΣF = 0 drawn into the step that is open: where every unknown force stands, by its key.
    figure: another than the link's."""
    pane, n = figure or pane_of(st, link), len(load.forces)
    letters = corner_letters(st, pane)
    known = [
        Term(
            rel=f.named,
            symbol=f.named.symbol,
            direction=f.direction,
            magnitude=f.size,
            vector=f.vector,
            tip=letters[i + 1],
        )
        for i, f in enumerate(load.forces)
    ]
    eq = Equation(left=(*known, *unknown), right=())
    st.board.equate(eq.table())
    st.board.plot(pane, 0j, letters[0], Dot.POINT)
    ends = close(st.board, pane, 0j, eq, corner=letters[n + 1]).ends
    found: dict[str, Drawn] = {}
    for i, term in enumerate(unknown, start=n):
        start, end = ends[term.rel.key]
        last = i == n + len(unknown) - 1
        found[term.rel.key] = Drawn(
            place=pane, start=start, end=end, letters=f"{letters[i]} {letters[0] if last else letters[i + 1]}"
        )
        if not last:
            st.board.plot(pane, complex(nominal(end)), letters[i + 1], Dot.POINT)
    return found


def closing_side(st: Statics, by: str, on: str, load: Resultant, figure: Pane | None = None) -> Drawn:
    """The one force of which nothing is known: the side that closes the polygon of all others."""
    named = st.named(by, on)
    closing = Term(rel=named, symbol=named.symbol, direction=UNKNOWN, magnitude="?")
    return draw_polygon(st, on, load, (closing,), figure)[named.key]


def answered(st: Statics, by: str, on: str, load: Resultant) -> Drawn | None:
    """That force: the only known one turned round (none that stands on no polygon), or the closing side."""
    if len(load.forces) != 1:
        return closing_side(st, by, on, load)
    drawn = load.forces[0].drawn
    return None if drawn is None else drawn.reversed()


def unread(st: Statics, load: Resultant) -> Reals | None:
    """The size (N) of that force where it is the only known one turned round, and stands on no polygon: it is not
    read anew."""
    if len(load.forces) != 1 or load.forces[0].drawn is not None:
        return None
    return newtons(st, load.forces[0])
