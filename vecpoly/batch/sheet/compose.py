"""The pages of a question sheet: which there are, and what stands where on each."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

from ...board.construction import Figure
from ...figures import View
from ...foundation.slotted import replace
from ...grading.key import AnswerKey, Graded, Kind
from ...methods.desk import POLE
from ...report.question.working import LEAST_ROOM
from ...solution import Solution
from ...typeset.box import MM
from ...variants.frames import HEIGHT, JITTER, WIDTH, on_sheet
from ...variants.seeds import Seed, Stream
from ...words import Lang
from .blanks import ROW
from .layout import BOTTOM, LEFT, RIGHT, TOP, Blank, Frame, Layout, Page, tags_of
from .text import Placed, squared, text_pages

TITLE = 8.0  # mm over a frame, for its title
_TENTHS = 10


@dataclass(frozen=True, slots=True)
class Composed:
    """One page: its layout, and what of it is text, or which figure it asks for."""

    page: Page
    text: tuple[Placed, ...] = ()
    figure: Figure | None = None


def composed(parts: Sequence[tuple[Solution, AnswerKey, Seed]], lang: Lang) -> tuple[Composed, ...]:
    """All pages of a student's sheet: for each problem its text, a frame for each figure, answers under the frames."""
    pages: list[Composed] = []
    for solution, key, seed in parts:
        name = solution.problem.id
        for text in text_pages(solution, lang):
            pages.append(Composed(_page(len(pages) + 1, name), text=text))
        figures = on_sheet(solution.construction.figures)
        waiting = [one for one in key.quantities if one.asked]
        for i, figure in enumerate(figures):
            mine = [one for one in waiting if _belongs(one, figure, last=i == len(figures) - 1)]
            waiting = [one for one in waiting if one not in mine]
            frame = _frame(figure, seed.stream(_of(figure)))
            here, left = _blanks(mine, frame.at[1] - ROW)
            pages.append(Composed(_page(len(pages) + 1, name, frame, here), figure=figure))
            pages += _more(left, len(pages), name)
        if waiting:
            pages += _more(waiting, len(pages), name)
    return tuple(pages)


def layout_of(pages: Sequence[Composed]) -> Layout:
    """Where everything stands, for the register."""
    return Layout(pages=tuple(one.page for one in pages))


def _page(number: int, problem: str, frame: Frame | None = None, blanks: tuple[Blank, ...] = ()) -> Page:
    return Page(number=number, problem=problem, tags=tags_of(number), frame=frame, blanks=blanks)


def _more(left: Sequence[Graded], count: int, name: str) -> Iterator[Composed]:
    """Pages of answers alone, for those that have no room under a frame; the rest of them is squared."""
    while left:
        count += 1
        here, left = _blanks(left, TOP - ROW)
        room = min(blank.at[1] for blank in here) - ROW - BOTTOM
        yield Composed(_page(count, name, None, here), text=(squared(room),) if room * MM >= LEAST_ROOM else ())


def _of(figure: Figure) -> int:
    """A number of its own for each figure, by which its pole is drawn."""
    return 10_000 + sum(ord(char) * (i + 1) for i, char in enumerate(f"{figure.view.name} {figure.name}"))


def _frame(figure: Figure, stream: Stream) -> Frame:
    x, y = (LEFT + RIGHT - WIDTH) / 2, TOP - TITLE - HEIGHT
    off = [(stream.below(int(2 * JITTER * _TENTHS) + 1) - JITTER * _TENTHS) / _TENTHS for _ in range(2)]
    pole = (round(x + WIDTH / 2 + off[0], 1), round(y + HEIGHT / 2 + off[1], 1)) if figure.view in POLE else None
    name = f"{figure.view.name} {figure.name}".strip()
    return Frame(
        figure=name,
        at=(x, y),
        size=(WIDTH, HEIGHT),
        pole=pole,
        letter=POLE.get(figure.view, ""),
        mu=figure.view.mu.key,
        scale=figure.scale.value,
    )


def _belongs(one: Graded, figure: Figure, *, last: bool) -> bool:
    """Whether an answer is read on this figure, or belongs to no figure and stands under the last."""
    units = {View.MECHANISM: ("m",), View.VELOCITY: ("m/s", "rad/s"), View.ACCELERATION: ("m/s^2", "rad/s^2")}
    return one.unit in units.get(figure.view, ()) or last


def _blanks(asked: Sequence[Graded], top: float) -> tuple[tuple[Blank, ...], Sequence[Graded]]:
    """The rows that have room below a height, plain numbers two in a row, and the answers that have none."""
    rows: list[Blank] = []
    y, beside = top, False
    for i, one in enumerate(asked):
        blank = _blank(one, (LEFT, round(y, 3)))
        if beside and blank.plain and rows[-1].plain:
            rows.append(replace(blank, at=((LEFT + RIGHT) / 2, rows[-1].at[1])))
            beside = False
        elif y < BOTTOM:
            return tuple(rows), asked[i:]
        else:
            rows.append(blank)
            y, beside = y - ROW, True
    return tuple(rows), ()


def _blank(one: Graded, at: tuple[float, float]) -> Blank:
    vector = one.kind is Kind.VECTOR
    return Blank(
        key=one.key,
        symbol=one.symbol,
        unit=one.written_in,
        at=at,
        length=one.mm is not None and bool(one.mm),
        direction=vector,
        sense=one.kind is Kind.SIGNED,
        place=one.kind is Kind.PLACE,
        origin=one.origin,
    )
