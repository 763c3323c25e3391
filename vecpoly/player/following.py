"""What follows from one's own earlier answers, without anything solved: each answer as a polynomial in those before it.

Between the lengths that are laid off and the ends of a polygon everything is linear, and ω²l and 2ωv are quadratic: so
few terms say exactly what the construction would give. Where they do not, nothing is continued.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from itertools import combinations_with_replacement
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..board.otherwise.amended import Amended, Own
from ..errors import VecpolyError
from ..foundation.slotted import replace
from ..grading.compare.measured import Measured
from ..grading.compare.own import Follower
from ..grading.key import AnswerKey, Graded, Kind
from ..grading.redraw import by_hands
from ..grading.rules import USUAL_RULES
from ..problem.problem import Problem

DEGREE, MOST = 3, 5  # of the polynomial; answers that one rests on
QUOTIENTS = 2  # answers of which it may also have the reciprocals: η = M_0/M
FAR = 4.0  # times the exact value, and a quarter of it: how far own values are tried
SPARE = 12  # trials more than there are terms, by which the polynomial is tested
NOTHING = 1e-9  # of an answer: a smaller term is none
TRUE = 0.1  # of what is allowed: so near a polynomial must come


@dataclass(frozen=True, slots=True, kw_only=True)
class Following:
    """An answer over its exact value, as a polynomial in those of others over theirs. sources: their numbers; terms:
    of each term the sources that are multiplied, counted on from the last where it is divided by them; share: of the
    value, that is allowed; sizes: in the sizes of the others, whatever their senses."""

    sources: tuple[int, ...]
    terms: tuple[tuple[int, ...], ...]
    factors: tuple[complex, ...]
    share: float
    sizes: bool = False


def followings(problem: Problem, key: AnswerKey, asked: Sequence[Graded]) -> tuple[Following | None, ...]:
    """For each answer what follows from the others; None where nothing does, or no polynomial says it."""
    rng = np.random.Generator(np.random.PCG64(0))
    trials = [_Trial.of(problem, key, one, asked, rng) for one in asked]
    own = tuple(each for one in trials if one is not None for each in one.own)
    try:
        found = by_hands(problem, key, Amended(own=own)) if own else {}
    except VecpolyError:
        return (None,) * len(asked)
    made: list[Following | None] = []
    at = 0
    for one in trials:
        if one is None or one.step.key not in found:
            made.append(None)
        else:
            made.append(one.fitted(found[one.step.key][at : at + len(one.own)]))
        at += 0 if one is None else len(one.own)
    return tuple(made)


@dataclass(frozen=True, slots=True, kw_only=True)
class _Trial:
    """One answer, and the hands that go on with other values before it. ratios: a row a hand, a column a source."""

    step: Graded
    sources: tuple[int, ...]
    terms: tuple[tuple[int, ...], ...]
    ratios: NDArray[Any]
    own: tuple[Own, ...]
    share: float

    @classmethod
    def of(
        cls, problem: Problem, key: AnswerKey, step: Graded, asked: Sequence[Graded], rng: np.random.Generator
    ) -> _Trial | None:
        given = {one.key: _written(one, 1.0) for one in asked if one.key != step.key}
        follower = Follower(problem=problem, key=key, given=given, rules=USUAL_RULES)
        names = [one.key for one in asked]
        sources = tuple(sorted({names.index(name) for name in follower.inputs(step).sources}))
        if not step.exact or not 0 < len(sources) <= MOST:
            return None
        terms = tuple(_terms(len(sources)))
        ratios = np.exp(rng.uniform(-np.log(FAR), np.log(FAR), (2 * len(terms) + SPARE, len(sources))))
        signed = [n for n, at in enumerate(sources) if asked[at].kind is Kind.SIGNED]
        ratios[:, signed] *= rng.choice([-1.0, 1.0], (len(ratios), len(signed)))
        own = tuple(_own(follower, step, [asked[at] for at in sources], row) for row in ratios)
        return cls(step=step, sources=sources, terms=terms, ratios=ratios, own=own, share=follower.allowed(step, 1.0))

    def fitted(self, found: NDArray[Any]) -> Following | None:
        """The polynomial through the first hands, if it also says what the others found."""
        over = found / abs(self.step.exact) if self.step.kind is Kind.VECTOR else found / self.step.exact
        if not np.all(np.isfinite(over)):
            return None
        for sizes in (False, True):
            ratios = np.abs(self.ratios) if sizes else self.ratios
            if (found_one := self._fit(over, ratios)) is not None:
                return replace(found_one, sizes=sizes)
        return None

    def _fit(self, over: NDArray[Any], ratios: NDArray[Any]) -> Following | None:
        both = np.concatenate([ratios, 1.0 / ratios], axis=1)
        table = np.stack([np.prod(both[:, list(term)], axis=1) for term in self.terms], axis=1)
        weight = 1.0 / np.maximum(np.abs(over), 0.1)
        many = len(over) - SPARE
        factors = np.linalg.lstsq(table[:many] * weight[:many, None], over[:many] * weight[:many], rcond=None)[0]
        if np.max(np.abs(table @ factors - over) * weight) > TRUE * self.share:
            return None
        kept = [n for n, factor in enumerate(factors) if abs(factor) > NOTHING]
        return Following(
            sources=self.sources, terms=tuple(self.terms[n] for n in kept),
            factors=tuple(complex(factors[n]) for n in kept), share=self.share,
        )  # fmt: skip


def _terms(count: int) -> Iterator[tuple[int, ...]]:
    """Every product of a few sources, and of few sources their quotients too."""
    factors = range(count * (2 if count <= QUOTIENTS else 1))
    for degree in range(DEGREE + 1):
        for term in combinations_with_replacement(factors, degree):
            if not any(at + count in term for at in term):  # nothing is divided by itself
                yield term


def _own(follower: Follower, step: Graded, sources: Sequence[Graded], ratios: NDArray[Any]) -> Own:
    changed = {one.key: _written(one, float(ratio)) for one, ratio in zip(sources, ratios, strict=True)}
    other = Follower(
        problem=follower.problem, key=follower.key, given={**follower.given, **changed}, rules=follower.rules
    )
    inputs = other.inputs(step)
    return inputs.frozen()


def _written(one: Graded, ratio: float) -> Measured:
    value = ratio * one.exact
    return Measured(value=value, sense=0 if one.kind is not Kind.SIGNED or not value else 1 if value > 0 else -1)
