"""The columns of a table together: was one other length at the bottom of all, and what else was wrong then?

Angles are looked at first: if one other length makes more of their columns right than the length that is given, the table was
computed with it, and every other column is compared with that mechanism.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace

from ..words import Words
from .table_explain import (
    Explanation,
    Suspect,
    accepted,
    explain,
    explained_by,
    lengths_found,
    rates_found,
    suspect,
)
from .table_fit import Fit
from .table_guess import Slip
from .table_truth import solved
from .table_weigh import Column, Level, Weighing, weigh

Found = Mapping[int, list[tuple[Fit, Explanation]]]


@dataclass(frozen=True, slots=True, eq=False)
class Base:
    """Another value of one length, and the mechanism that has it."""

    fit: Fit
    by: Suspect


def weighed_by(column: Column, by: Suspect) -> Weighing:
    """The column against this mechanism as it is."""
    return weigh(column, by.truth.of(column.target), by.truth.sensitivity[column.target.key])


def explained(columns: Sequence[Column], given: Suspect, weighed: Sequence[Weighing]) -> list[tuple[Explanation, ...]]:
    """The explanations of every column that needs one, best first; none where a column is right, or no usual slip explains it."""
    needy = [i for i, one in enumerate(weighed) if one.level >= Level.LOW]
    told: list[tuple[Explanation, ...]] = [()] * len(weighed)
    if not needy:
        return told
    found = _lengths(columns, given, [i for i in needy if columns[i].target.is_place] or needy)
    base = _base(columns, given, weighed, found)
    if base is not None:
        for i in needy:
            told[i] = _as_base(columns[i], base, weighed[i], found.get(i, ()))
        _further(columns, base.by, weighed, told, {}, needy)
        for i in needy:
            told[i] = tuple(_under(base, one) for one in told[i])
    found |= _lengths(columns, given, [i for i in needy if not told[i] and i not in found])
    _further(columns, given, weighed, told, found, needy)
    return _common_first(told)


def _lengths(columns: Sequence[Column], given: Suspect, which: Sequence[int]) -> dict[int, list[tuple[Fit, Explanation]]]:
    """Lengths with which these columns become right."""
    return dict(zip(which, lengths_found([columns[i] for i in which], given), strict=True)) if which else {}


def _common_first(told: list[tuple[Explanation, ...]]) -> list[tuple[Explanation, ...]]:
    """Of explanations that fit a column equally, the one that explains most columns comes first."""
    count = Counter(one.words.en for slips in told for one in slips)
    return [tuple(sorted(slips, key=lambda one: -count[one.words.en])) for slips in told]


def _base(columns: Sequence[Column], given: Suspect, weighed: Sequence[Weighing], found: Found) -> Base | None:
    """The other length with which most columns of places (of all columns, where there are no places) become right."""
    places = [i for i, column in enumerate(columns) if column.target.is_place] or list(range(len(columns)))
    best, most = None, sum(weighed[i].level < Level.WRONG for i in places)
    tried = {(fit.length.words.en, fit.value): fit for i in places for fit, one in found.get(i, ()) if accepted(one.after, weighed[i])}
    for fit in tried.values():
        motion = solved(fit.length.instead(fit.value), given.truth.positions)
        after = [weigh(columns[i], columns[i].target.of(motion), given.truth.sensitivity[columns[i].target.key]) for i in places] if motion else []
        right = sum(one.level < Level.WRONG for one in after)
        if right > most:
            best, most = fit, right
    by = suspect(best.length.instead(best.value), given.truth.positions, columns) if best else None
    return Base(best, by) if best and by else None


def _as_base(column: Column, base: Base, before: Weighing, found: Sequence[tuple[Fit, Explanation]]) -> tuple[Explanation, ...]:
    """The column right with the base as it is; lengths of its own that are as good are told too."""
    after = weighed_by(column, base.by)
    if not accepted(after, before):
        return ()
    own = [one for fit, one in found if fit.length.words != base.fit.length.words and one.after.level <= after.level
           and one.after.rows_right >= 0.9 * after.rows_right]
    return (explained_by(base.fit, after, Slip.LENGTH), *own)


def _further(columns: Sequence[Column], by: Suspect, weighed: Sequence[Weighing], told: list[tuple[Explanation, ...]],
             found: Found, needy: Sequence[int]) -> None:
    """Fill in the explanations of the columns that have none yet."""
    left = [i for i in needy if not told[i]]
    moving = [i for i in left if not columns[i].target.is_place]
    rates = dict(zip(moving, rates_found([columns[i] for i in moving], by), strict=True)) if moving else {}
    for i in left:
        known = [one for _, one in (*found.get(i, ()), *rates.get(i, ()))]
        told[i] = explain(columns[i], columns, by, weighed[i], known)


def _under(base: Base, one: Explanation) -> Explanation:
    """The explanation with the base's length said, where it is not said already."""
    if one.slip in (Slip.LENGTH, Slip.RATES):
        return one
    name, value = base.fit.length.words, f"{1e3 * base.fit.value:.6g} mm"
    return replace(one, words=Words(f"按 {name.zh} = {value}：{one.words.zh}", f"with {name.en} = {value}: {one.words.en}"))
