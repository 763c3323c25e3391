"""The framed answer of a problem: what was asked, each value once, with unit and direction, and beside what was read
its exact value, its deviation and its expected error; then what is no number that was read, the notes, and what was
concluded beside."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from collections.abc import Set as AbstractSet

from ...foundation.slotted import dataclass, replace
from ...printed.midway import some_go_down
from ...solution import Answer, Solution
from ...words import Lang, Words, stopped
from ..flow.results.box import AnswerBox
from ..flow.results.framed import FramedTable
from ..flow.results.tabled import TabledAnswers
from ..values import is_worded
from .alike import twins
from .line import AnswerLine, answer_line
from .notes import notes_of, scales_of
from .order import Part, arranged, as_found, broken
from .rows import places_table, values_table
from .tables import counted
from .verdict import is_ill, remarks_on

_COMPARED = Words(
    "精确值由解析法求得，预期误差为读数和作图误差的 3σ",
    "Exact values are analytic; the expected error is 3σ of drawing and reading",
)
_DIRECTED = Words(
    "方向角（∠）自 $x$ 轴正向起，逆时针为正", "direction angles (∠) are counter-clockwise from the $x$ axis"
)


_EVEN = Words(
    "修约时拟舍弃部分恰为 5，末位取偶（GB/T 8170）",
    "A result exactly midway between two digits is rounded to the even one (GB/T 8170)",
)


@dataclass(frozen=True, slots=True, kw_only=True)
class Explained:
    """What answers before this one have explained: what is exact and what an expected error is; the angles; how a
    result is rounded that lies midway."""

    compared: bool = False
    directed: bool = False
    rounded: bool = False


NOTHING_YET = Explained()


def explained_by(things: Iterable[object]) -> Explained:
    """What the answers among these explain."""
    answers = [one for one in things if isinstance(one, AnswerBox)]
    return Explained(
        compared=any(one.compared for one in answers),
        directed=any(one.directed for one in answers),
        rounded=any(_EVEN.of(one.lang) in one.notes for one in answers),
    )


def answer_box(
    solution: Solution,
    lang: Lang,
    said: Iterable[str] = (),
    answers: Iterable[Answer] | None = None,
    explained: Explained = NOTHING_YET,
) -> AnswerBox:
    """Every asked quantity once, by solutions or kinds; said: conclusions that are no quantity."""
    parts = arranged(map(as_found, answers or solution.answers.values()))
    every = [one for part in parts for one in part.answers]
    rows = frozenset(one.key for one in in_rows(every))
    tables = _tables(parts, rows, solution, lang)
    lines = _lines(parts, rows, solution, lang)
    notes, scales = notes_of(every, lang), scales_of(every, solution, lang)
    even = (_EVEN.of(lang),) if some_go_down(solution.construction) and not explained.rounded else ()
    if not tables:
        box = AnswerBox(lines, tuple(said), lang, (*notes, *scales, *even))
        told = _DIRECTED if box.directed and not explained.directed else None
        return box if told is None else AnswerBox(lines, tuple(said), lang, (*box.notes, _begun(told.of(lang))))
    over = [name for table in tables for name in table.over]
    notes = (*notes, *remarks_on(over, any(is_ill(one, solution) for one in every), lang), *even)
    made = TabledAnswers(tables, lines, tuple(said), lang, notes)
    head = _head(scales, made, explained, lang)
    return TabledAnswers(tables, lines, tuple(said), lang, notes, head)


def in_rows(every: Sequence[Answer]) -> list[Answer]:
    """The answers that have rows: what was read, and what was computed where that is no more; counts, and what is told
    in words, have lines of their own."""
    numbers = [one for one in every if not (_is_count(one) or one.undefined)]
    read = [one for one in numbers if one.is_place or not one.computed]
    return numbers if len(numbers) <= 2 * len(read) else read


def _is_count(one: Answer) -> bool:
    return counted(one) or is_worded(one.key, one.reading.unit)


def _tables(parts: Sequence[Part], rows: frozenset[str], solution: Solution, lang: Lang) -> list[FramedTable]:
    """Of values, and of places where there are several or nothing else."""
    kept = _among(parts, rows)
    places = [one for part in kept for one in part.answers if one.is_place]
    apart = len(places) > 1 or len(places) == len(rows)
    spots = {one.key for one in places} if apart else set()
    made = (values_table(_among(kept, rows - spots), solution, lang), places_table(_among(kept, spots), solution, lang))
    return [table for table in made if table is not None]


def _among(parts: Sequence[Part], keys: AbstractSet[str]) -> list[Part]:
    """The parts with these answers alone."""
    some = [replace(part, answers=tuple(one for one in part.answers if one.key in keys)) for part in parts]
    return [part for part in some if part.answers]


def _lines(parts: Sequence[Part], rows: frozenset[str], solution: Solution, lang: Lang) -> list[AnswerLine]:
    """What has no row."""
    idle = broken(solution)
    same = twins([one for part in parts for one in part.answers if one.key not in rows])
    return [
        answer_line(one, solution, lang, heading=part.heading(lang, idle), also=_also(one, same), read=False)
        for part in parts
        for one in part.answers
        if one.key not in same and one.key not in rows
    ]


def _head(scales: Sequence[str], answer: AnswerBox, explained: Explained, lang: Lang) -> str:
    """The scales, and what the columns mean where that was not told before."""
    told = [_COMPARED] if not explained.compared else []
    told += [_DIRECTED] if answer.directed and not explained.directed else []
    meant = Words("；", "; ").of(lang).join(one.of(lang) for one in told)
    sentences = [stopped(text, lang) for text in (*scales, _begun(meant)) if text]
    return ("" if lang == "zh" else " ").join(sentences)


def _begun(text: str) -> str:
    return text[:1].upper() + text[1:]


def _also(answer: Answer, same: Mapping[str, Answer]) -> tuple[str, ...]:
    """The keys of what is the same vector."""
    return tuple(key for key, first in same.items() if first is answer)
