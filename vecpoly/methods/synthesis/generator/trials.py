"""The crank by two trials: of its length as it should be, both bisectors meet the line of the output link in one point.

For a crank of any length the first and second, and the first and third inverted pins ask for places P and Q of C. Along
the line 1/DP and 1/DQ are linear in the inverse of the crank, so that two trials tell where P and Q fall together.
"""

from __future__ import annotations

import numpy as np

from ....algebra.quantity import Quantity, Sum, magnitude
from ....board.board import Board
from ....board.construction import View
from ....board.paper.marks import Dot, Role
from ....board.place import Pane
from ....errors import NotAskedError
from ....plane import Line, Points, Reals, nominal
from ....plane.geometry import dot
from ....words import Words
from ..inversion.sheet import Sheet, Stands, transferred
from .trying import Angles, others, trial_cranks

_TRIALS = (("E", "P", "Q"), ("F", "P^′", "Q^′"))  # letters of both


def crank_length(sheet: Sheet, pairs: Angles, kept: int) -> Reals:
    """AB on paper; negative where B lies on the lines of the input link produced backwards."""
    draft = sheet.draft
    board, frame = draft.board, abs(complex(nominal(sheet.pins["D"][0])))
    place = board.open_pane(View.MECHANISM, "trial cranks", Words("试取曲柄", "Two trial cranks"))
    board.section(Words("曲柄长度", "The length of the crank"))
    board.step(_told(kept), place)
    _given(sheet, place, kept)
    lengths = [length * frame for length in trial_cranks(pairs, kept)]
    numbers = [_off(sheet, place, length, letters, kept) for length, letters in zip(lengths, _TRIALS, strict=True)]
    board.step(_FOUND, place)
    e, f = numbers
    if not nominal(f.value - e.value):
        raise _alike()
    ae, af = (magnitude(symbol, length, "mm") for symbol, length in zip(("AE", "AF"), lengths, strict=True))
    return board.compute("AB", (f - e) / (f / ae - e / af), "mm").value


def _alike() -> NotAskedError:
    """Both trials read alike: the task is ill-conditioned beyond drawing."""
    return NotAskedError(
        Words(
            "AB 无从量取：两次试作中 P、Q 都几乎重合，图上读不出曲柄长；该题对数据敏感（病态），"
            "请拉大各组对应角之间的间隔，或用 vecpoly exact",
            "AB cannot be read: in both trials P and Q all but fall together, and the paper does not tell the crank; "
            "the task is ill-conditioned, take pairs of angles further apart, or use 'vecpoly exact'",
        ),
        code="unreadable",
    )


def _told(kept: int) -> Words:
    own, (one, two) = kept + 1, (n + 1 for n in others(kept))
    return Words(
        f"任取曲柄长 $AE$，得 $E_1$、$E_2$、$E_3$；取 $DN_{own}$ 为“机架”反转，得 $E_{one}^′$、$E_{two}^′$。"
        f"$E_{own} E_{one}^′$ 的中垂线交 $DN_{own}$ 于 $P$，$E_{own} E_{two}^′$ 的中垂线交 $DN_{own}$ 于 $Q$；"
        "$P$、$Q$ 不重合，曲柄长不对。另取曲柄长 $AF$，同样得 $P^′$、$Q^′$。",
        f"Take any crank $AE$: $E_1$, $E_2$, $E_3$. With $DN_{own}$ for the frame inversion gives $E_{one}^′$ and "
        f"$E_{two}^′$; the bisector of $E_{own} E_{one}^′$ meets $DN_{own}$ at $P$, that of $E_{own} E_{two}^′$ at "
        "$Q$. As they differ the crank has not the right length. Another crank $AF$ gives $P^′$ and $Q^′$ likewise.",
    )


_FOUND = Words(
    "$1/DP$、$1/DQ$ 都与 $1/AE$ 成线性关系，故 $k = 1/DP − 1/DQ = PQ/(DP·DQ)$ 也是；$k = 0$ 时 $P$、$Q$ 重合于 $C$。"
    "由"
    "两次试作量得的 $k_E$、$k_F$ 线性内插（各线段以指向标线方向为正）：",
    "The values $1/DP$ and $1/DQ$ are linear in $1/AE$, and so is $k = 1/DP − 1/DQ = PQ/(DP·DQ)$; where $k = 0$ both "
    "fall together in $C$. By interpolation between $k_E$ and $k_F$, as read in both trials (a length along its line "
    "counts as positive):",
)


def _given(sheet: Sheet, place: Pane, kept: int) -> None:
    """The pivots, the lines of the input link, and the line of the output link that is kept."""
    board = sheet.draft.board
    for letter in ("A", "D"):
        board.plot(place, sheet.pins[letter][0], letter, Dot.JOINT)
    for n, stands in enumerate(sheet.bodies["DN"]):
        board.join(place, stands.start, stands.end, Role.GIVEN if n == kept else Role.CONSTRUCTION)
        board.plot(place, stands.end, f"N_{n + 1}", Dot.POINT)
    for stands in sheet.bodies["AM"]:
        board.join(place, stands.start, stands.end, Role.CONSTRUCTION)


def _off(sheet: Sheet, place: Pane, length: float, letters: tuple[str, str, str], kept: int) -> Quantity:
    """k = PQ/(DP·DQ) of a trial crank."""
    board, d, first = sheet.draft.board, sheet.pins["D"][0], sheet.bodies["DN"][kept]
    e, *names = letters
    crank = [_laid(board, stands, length) for stands in sheet.bodies["AM"]]
    for n, (stands, at) in enumerate(zip(sheet.bodies["AM"], crank, strict=True), 1):
        board.join(place, stands.start, at, Role.CONSTRUCTION)
        board.plot(place, at, f"{e}_{n}", Dot.POINT)
    p, q = (_met(sheet, place, crank, (kept, n), (e, name)) for n, name in zip(others(kept), names, strict=True))
    signs = [float(np.sign(nominal(dot(first.along, span)))) for span in (q - p, p - d, q - d)]
    pq = board.measure(p, q, f"{names[0]} {names[1]}")
    dp, dq = (board.measure(d, at, f"D {name}") for at, name in zip((p, q), names, strict=True))
    return board.compute(f"k_{e}", Sum((pq / (dp * dq),), (int(np.prod(signs)),)), "1/mm")


def _met(sheet: Sheet, place: Pane, crank: list[Points], at: tuple[int, int], letters: tuple[str, str]) -> Points:
    """Where the bisector of the pin in the position that is kept and the inverted pin meets the output link's line."""
    board, d, (kept, n), (e, name) = sheet.draft.board, sheet.pins["D"][0], at, letters
    here, there = sheet.bodies["DN"][kept], sheet.bodies["DN"][n]
    seen = transferred(sheet.draft, (d, there.end, crank[n]), (d, here.end), f"{e}_{n + 1}", place)
    board.plot(place, seen, f"{e}_{n + 1}^′", Dot.POINT)
    board.join(place, crank[kept], seen, Role.CONSTRUCTION)
    bisector = board.bisector(place, crank[kept], seen)
    met = board.meet(bisector, Line(d, here.along), Words(f"求 ${name}$", f"finding ${name}$"))
    board.rule(place, bisector, met)
    board.join(place, d, met, Role.CONSTRUCTION)
    board.plot(place, met, name, Dot.POINT)
    return met


def _laid(board: Board, stands: Stands, length: float) -> Points:
    """A trial crank on a line of the input link, on either side of A."""
    return board.lay_off(stands.start, np.sign(length) * stands.along, abs(length))
