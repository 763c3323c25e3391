"""The columns of a table together: was one slip at the bottom of all (another length,
assembly, zero of the drive), and what else then?

Places are looked at first: if one other mechanism makes more of their columns right than the one that is given, the
table was computed with it, and every other column is compared with that mechanism.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass

from ...foundation.slotted import replace
from ...mechanism.model import Mechanism
from ...oracle import Motion
from ...words import Words
from ..table.target import Reals
from ..table.truth import solved
from ..table.weigh import Column, Level, Weighing, weigh
from .by_fit import explained_by, lengths_found, rates_found
from .explain import LOOSE, SURE, Explanation, Suspect, accepted, explain, noise_of, plausible, suspect
from .fit import Fit, polished
from .formula_search import in_formulas
from .guess import Slip
from .shift import shifts_found

UNDER = 4.0  # times the table's noise that a column may scatter under what explains the places
NEARER = 0.2  # of its deviation that a column may keep to be one that the base brings nearer
Found = Mapping[int, list[tuple[Fit, Explanation]]]


@dataclass(frozen=True, slots=True, kw_only=True, eq=False)
class Base:
    """Another mechanism by which the whole table may have been computed:
    what it explains, and how its columns are then introduced."""

    slip: Slip
    words: Words
    under: Words
    mech: Mechanism
    positions: Reals
    motion: Motion
    fit: Fit | None = None
    equals: tuple[Base, ...] = ()  # others that explain the places as well

    def explains(self, after: Weighing) -> Explanation:
        """A column that is right with it."""
        return (
            explained_by(self.fit, after, Slip.LENGTH)
            if self.fit
            else Explanation(slip=self.slip, words=self.words, after=after)
        )


def weighed_by(column: Column, by: Suspect) -> Weighing:
    """The column against this mechanism as it is."""
    return weigh(column, by.truth.of(column.target), by.truth.sensitivity[column.target.key])


def explained(columns: Sequence[Column], given: Suspect, weighed: Sequence[Weighing]) -> list[tuple[Explanation, ...]]:
    """The explanations of every column that needs one, best first;
    none where a column is right, or no usual slip explains it."""
    needy = [i for i, one in enumerate(weighed) if one.level >= Level.LOW]
    told: list[tuple[Explanation, ...]] = [()] * len(weighed)
    if not needy:
        return told
    noise = noise_of(weighed)
    lost = [columns[i] for i in needy if weighed[i].level is Level.WRONG]
    given = replace(given, motions=[*given.motions, *shifts_found(lost, given.thin, given.truth)])
    found = _lengths(columns, given, [i for i in needy if columns[i].target.is_place] or needy)
    base = _sharpened(_base(columns, given, weighed, found, noise), columns, given, weighed)
    by = suspect(base.mech, base.positions, columns) if base else None
    if base is not None and by is not None:
        under = [weighed_by(column, by) for column in columns]
        noise = noise_of(under) if noise == LOOSE else noise
        for i in needy:
            told[i] = (
                tuple(one.explains(under[i]) for one in (base, *base.equals))
                if accepted(under[i], weighed[i], UNDER * noise)
                else ()
            )
        _further(columns, by, weighed, told, {}, needy, noise)
        for i in needy:
            told[i] = tuple(_under(base, one) for one in told[i])
    found |= _lengths(columns, given, [i for i in needy if not told[i] and i not in found])
    _further(columns, given, weighed, told, found, needy, noise)
    wrong = [i for i in needy if not told[i] and weighed[i].level is Level.WRONG]
    for i, one in in_formulas(columns, by or given, weighed, told, wrong, noise):
        told[i] = tuple(_under(base, slip) for slip in one) if base else one
    return _common_first(told)


def _lengths(
    columns: Sequence[Column], given: Suspect, which: Sequence[int]
) -> dict[int, list[tuple[Fit, Explanation]]]:
    """Lengths with which these columns become right."""
    return dict(zip(which, lengths_found([columns[i] for i in which], given), strict=True)) if which else {}


def _common_first(told: list[tuple[Explanation, ...]]) -> list[tuple[Explanation, ...]]:
    """What explains most columns comes first; what fits one column only,
    beside a slip that many share, is chance and is dropped."""
    count = Counter(one.words.en for slips in told for one in slips)
    kept = [
        [one for one in slips if 2 * count[one.words.en] >= max(count[other.words.en] for other in slips)]
        for slips in told
    ]
    return [
        tuple(sorted(slips, key=lambda one: (-count[one.words.en] if count[one.words.en] > 1 else 0, *plausible(one))))
        for slips in kept
    ]


def _base(
    columns: Sequence[Column], given: Suspect, weighed: Sequence[Weighing], found: Found, noise: float
) -> Base | None:
    """The other mechanism with which most columns of places (of all columns,
    where there are no places) become right."""
    places = [i for i, column in enumerate(columns) if column.target.is_place] or list(range(len(columns)))
    fits = {
        (fit.length.words.en, fit.value): (fit, one)
        for i in places
        for fit, one in found.get(i, ())
        if accepted(one.after, weighed[i], noise)
    }
    equal: list[Base] = []
    best, most = None, (sum(one.level < Level.WRONG for one in (weighed[i] for i in places)), 0.0)
    for base in _bases([fit for fit, _ in sorted(fits.values(), key=lambda known: plausible(known[1]))], given):
        after = [
            weigh(columns[i], columns[i].target.of(base.motion), given.truth.sensitivity[columns[i].target.key])
            for i in places
        ]
        right = [
            one
            for one, before in zip(after, (weighed[i] for i in places), strict=True)
            if one.level < Level.WRONG and (one.doubt <= SURE or one.spread <= noise or one.spread <= before.spread)
        ]
        score = len(right), -round(sum(one.spread for one in right) / max(len(right), 1), 1)
        if score[0] > most[0] or (best is not None and score > most):
            best, most, equal = base, score, []
        elif best is not None and score == most and base.fit is None and best.fit is None:
            equal.append(base)
    return replace(best, equals=tuple(equal)) if best else None


def _bases(fits: Sequence[Fit], given: Suspect) -> Iterator[Base]:
    truth = given.truth
    for fit in fits:
        mech, name, value = fit.length.instead(fit.value), fit.length.words, f"{1e3 * fit.value:.6g} mm"
        if (motion := solved(mech, truth.positions)) is not None:
            under = Words(f"按 {name.zh} = {value}：", f"with {name.en} = {value}: ")
            yield Base(
                slip=Slip.LENGTH, words=name, under=under, mech=mech, positions=truth.positions, motion=motion, fit=fit
            )
    for slip, words, motion, positions in given.motions:
        yield Base(
            slip=slip,
            words=words,
            under=words + Words("；此外", "; besides, "),
            mech=motion.mech,
            positions=positions,
            motion=motion,
        )


def _sharpened(
    base: Base | None, columns: Sequence[Column], given: Suspect, weighed: Sequence[Weighing]
) -> Base | None:
    """The length of the base found once more, from all columns that it brings much nearer."""
    if base is None or base.fit is None:
        return base
    sensitivity = given.truth.sensitivity
    after = [weigh(column, column.target.of(base.motion), sensitivity[column.target.key]) for column in columns]
    nearer = [
        column
        for column, one, before in zip(columns, after, weighed, strict=True)
        if before.level is Level.WRONG and one.spread < NEARER * before.spread
    ]
    fit = (
        polished(nearer, given.truth, base.fit, lambda mech: solved(mech, given.truth.positions))
        if len(nearer) > 1
        else base.fit
    )
    return next(_bases([fit], given), None)


def _further(
    columns: Sequence[Column],
    by: Suspect,
    weighed: Sequence[Weighing],
    told: list[tuple[Explanation, ...]],
    found: Found,
    needy: Sequence[int],
    noise: float,
) -> None:
    """Fill in the explanations of the columns that have none yet."""
    left = [i for i in needy if not told[i]]
    moving = [i for i in left if not columns[i].target.is_place]
    rates = dict(zip(moving, rates_found([columns[i] for i in moving], by), strict=True)) if moving else {}
    for i in left:
        known = [one for _, one in (*found.get(i, ()), *rates.get(i, ()))]
        told[i] = explain(columns[i], columns, by, weighed[i], known, noise)


def _under(base: Base, one: Explanation) -> Explanation:
    """The explanation with the base said, where it is not said already."""
    if one.words == base.words or (base.fit is not None and (one.slip in (Slip.LENGTH, Slip.RATES) or one.length)):
        return one
    return replace(one, words=base.under + one.words)
