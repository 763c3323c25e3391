"""Points of a body that only translates have one velocity, v_C = v_B3, and links of a sliding pair one turn,
ω_3 = ω_2: it is worked out once, and once answered."""

from __future__ import annotations

from cmath import isclose
from collections.abc import Iterable, Mapping

from ...algebra.formula import Node, Row, Txt, plain, row
from ...printed.told import EQUALS
from ...solution import Answer, Solution
from ...typeset.box import Rgb
from ...words import Lang
from ..tables import inks_of
from ..values import called
from .line import result_of

TURNS = ("rad/s", "rad/s^2")
_SAME = 1e-9  # share by which one vector may differ from itself


def is_same(one: Answer, other: Answer) -> bool:
    """Whether both are one vector, by the drawing and exactly, read as one length; or one turn of two links."""
    if _turns_with(one, other) or _turns_with(other, one):
        return True
    vectors = (one.drawn_vector, other.drawn_vector), (one.exact_vector, other.exact_vector)
    if (one.reading.mm, one.reading.unit) != (other.reading.mm, other.reading.unit) or one.is_place:
        return False
    return bool(one.reading.mm) and all(a and b and isclose(a, b, rel_tol=_SAME) for a, b in vectors)


def _turns_with(one: Answer, other: Answer) -> bool:
    """Whether the line of one turn says that it is the other: ω_3 = ω_2 = 1.995 rad/s."""
    match one.reading.formula:
        case Row((_, Txt(equal), as_found, Txt())) if equal == EQUALS and one.reading.unit in TURNS:
            return one.reading.unit == other.reading.unit and plain(as_found) == plain(row(other.reading.symbol))
        case _:
            return False


def twins(answers: Iterable[Answer], inks: Mapping[str, Rgb | None] | None = None) -> dict[str, Answer]:
    """The answers that are the same vector as one before them, by their keys, each with that one; inks: of what is
    printed in colours, in which none may have a colour of its own."""
    first: list[Answer] = []
    found: dict[str, Answer] = {}
    for one in answers:
        twin = next((other for other in first if is_same(one, other) and _fits(one, other, inks or {})), None)
        if twin is None:
            first.append(one)
        else:
            found[one.key] = twin
    return found


def _fits(one: Answer, other: Answer, inks: Mapping[str, Rgb | None]) -> bool:
    return inks.get(one.key) in (None, inks.get(other.key))


def named_once(every: Iterable[Answer], solution: Solution, lang: Lang) -> list[tuple[Answer, str]]:
    """Every vector once, with all that it is called: v_B3 = v_C."""
    some = list(every)
    keys = [one.key for one in some]
    same = twins(some, dict(zip(keys, inks_of(solution, keys), strict=True)))
    names: dict[str, list[str]] = {}
    for one in some:
        names.setdefault(same.get(one.key, one).key, []).append(called(one.reading.symbol, one.key, lang))
    return [(one, " = ".join(names[one.key])) for one in some if one.key not in same]


def lines_of_twins(solution: Solution, lang: Lang) -> Mapping[int, Node]:
    """What stands in place of the line of each: v_C = v_B3 = 11.95 m/s; by the identity of the line."""
    answers = solution.answers
    return {
        id(answers[key].reading.formula): Row(
            (
                row(answers[key].reading.symbol),
                Txt(" = "),
                row(first.reading.symbol),
                Txt(f" = {result_of(answers[key], lang)}"),
            )
        )
        for key, first in twins(answers.values()).items()
        if answers[key].reading.formula is not None
    }
