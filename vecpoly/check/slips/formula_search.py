"""Columns that no single slip explains:
several at once in the formula of the point, at the rates with which the table was computed."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

from ...oracle import Motion
from ...words import Words
from ..table.weigh import Column, Weighing, weigh
from .by_fit import mixed_or_none
from .explain import Explanation, Suspect, accepted, equals
from .formula import MOST_SLIPS, beyond_chance, formulas, ways_to
from .formula_words import told as told_of
from .guess import Slip


@dataclass(frozen=True, slots=True, eq=False)
class Rates:
    """A motion whose rates may have gone into the formula, how it is introduced,
    and the symbol of the other length in it."""

    motion: Motion
    words: Words
    length: str = ""


def in_formulas(
    columns: Sequence[Column],
    by: Suspect,
    weighed: Sequence[Weighing],
    told: Sequence[tuple[Explanation, ...]],
    which: Sequence[int],
    noise: float,
) -> Iterator[tuple[int, tuple[Explanation, ...]]]:
    """The columns that come out with as few slips as possible, and these slips."""
    motions = list(_rates(by, told)) if which else []
    for i in which:
        column, tried = columns[i], 0
        known = [(rates, ways) for rates in motions if (ways := ways_to(column.target, rates.motion))]
        for count in range(1, MOST_SLIPS + 1):
            found = []
            for rates, ways in known:
                trials, near = formulas(column, ways, count)
                tried += trials
                for one in near:
                    after = weigh(column, one.expected, by.truth.sensitivity[column.target.key])
                    if accepted(after, weighed[i], noise) and beyond_chance(column, weighed[i], after, tried):
                        words, symbol = told_of(column.target, one.slipped), f"${column.target.symbol}$"
                        found.append(
                            Explanation(
                                slip=Slip.FORMULA,
                                words=rates.words
                                + Words(f"{symbol} 的公式中，", f"in the formula of {symbol}, ")
                                + words,
                                after=after,
                                length=rates.length,
                                alone=Words("公式中，", "in its formula, ") + words,
                                slips=count,
                            )
                        )
            if found:
                yield i, equals(found)
                break


def _rates(by: Suspect, told: Sequence[tuple[Explanation, ...]]) -> Iterator[Rates]:
    """The rates of the mechanism itself, and those with another length by which other columns are explained."""
    yield Rates(by.truth.motion, Words.same(""))
    others = {(one.length, one.parameter): one for slips in told for one in slips if one.slip is Slip.RATES}
    for (name, value), one in others.items():
        length = next((length for length in by.truth.lengths if length.words.en == name), None)
        if (
            length is not None
            and value is not None
            and (motion := mixed_or_none(by.truth.motion, length.instead(value))) is not None
        ):
            yield Rates(motion, one.words + Words("；此外，", "; besides, "), name)
