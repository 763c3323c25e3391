"""A key, and its mutants, at a student's own scales."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from ...foundation.slotted import replace
from ..key import AnswerKey, Graded, Kind
from ..slips.mutants import Mutant, Value


def at_own_scales(key: AnswerKey, own: Mapping[str, float]) -> AnswerKey:
    """The same exact values as other lengths on paper; on a smaller drawing T is as many mm, and so more."""
    ratio = _ratios(key, own)
    if not ratio:
        return key
    scales = {mu: own.get(mu, value) for mu, value in key.scales.items()}
    return replace(key, quantities=tuple(_scaled(one, key, ratio) for one in key.quantities), scales=scales)


def mutants_at(key: AnswerKey, mutants: Sequence[Mutant], own: Mapping[str, float]) -> tuple[Mutant, ...]:
    """The mutants of a key, at a student's own scales."""
    ratio = _ratios(key, own)
    return tuple(_mutant(one, key, ratio) for one in mutants) if ratio else tuple(mutants)


def _ratios(key: AnswerKey, own: Mapping[str, float]) -> dict[str, float]:
    """Own scale over the key's, of those that differ."""
    found = {mu: value / key.scales[mu] for mu, value in own.items() if mu in key.scales}
    return {mu: k for mu, k in found.items() if abs(k - 1) > 1e-9}


def _scaled(one: Graded, key: AnswerKey, ratio: Mapping[str, float]) -> Graded:
    k = ratio.get(one.mu, _of_needs(one, key, ratio))
    if one.kind is Kind.READING:
        return replace(one, exact=one.exact / k, mm=one.exact / k)
    return replace(
        one, mm=one.mm / k if one.mm else None, allowed=one.allowed * max(1.0, k), sigma=one.sigma * max(1.0, k)
    )


def _of_needs(one: Graded, key: AnswerKey, ratio: Mapping[str, float]) -> float:
    """Of a value without a length of its own: the coarsest scale among the lengths below it."""
    return max((ratio.get(key[name].mu, 1.0) for name in one.needs), default=1.0)


def _mutant(mutant: Mutant, key: AnswerKey, ratio: Mapping[str, float]) -> Mutant:
    values = {name: _value(value, key[name], ratio) for name, value in mutant.values.items()}
    return replace(mutant, values=values)


def _value(value: Value, one: Graded, ratio: Mapping[str, float]) -> Value:
    k = ratio.get(one.mu, 1.0) if one.kind is Kind.READING else 1.0
    return replace(value, value=value.value / k, sigma=value.sigma / k)
