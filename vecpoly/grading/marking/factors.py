"""One factor behind many values: a wrong scale, a power of ten, everything drawn larger."""

from __future__ import annotations

from collections.abc import Sequence
from math import log10

from ..compare.outcome import Basis, Outcome
from ..key import Graded, Kind
from ..told.message import Message, message
from ..told.named import Told
from .verdict import Verdicts
from .why import Causes

TENFOLD = 0.02  # as near to a power of ten a factor is one
FINEST = 1e-6  # of a value: T of what is counted
ALIKE = 3  # values that one factor must explain, at least


def of_factors(found: Verdicts, why: Causes) -> None:
    """One factor on everything, or on all that is read at one scale: it costs once."""
    if not _of_everything(found, why):
        _of_scales(found, why)


def _of_everything(found: Verdicts, why: Causes) -> bool:
    """Whether all numbers, but for what is right, are right ones by one factor, lengths on paper too, or values of
    several scales. An angle or a ratio has no size to be off by: it is wrong by itself, and told so."""
    numbers = [found.key[name] for name, mine in found.given.items() if mine.at is None and mine.yes is None]
    wrong = [one for one in numbers if found.exact[one.key] is Outcome.WRONG and one.exact]
    sized = [one for one in wrong if one.unit not in ("deg", "")]
    at_one_scale = len({one.mu for one in wrong}) == 1 or all(one.kind is not Kind.READING for one in wrong)
    begun = sum(one in sized for one in found.roots())  # what follows from one length is no factor of everything
    if at_one_scale or begun < 2 or len(sized) < ALIKE or not _but(found, numbers, wrong):
        return False
    k = _mean(found, sized)
    if not k or not all(_scaled(found, one, k) for one in wrong):
        return False
    said = _power(k) or message(Told.EVERYTHING, k=f"{k:.3g}")
    _once(found, why, sized, said)
    why.said |= {one.key: said for one in wrong if one not in sized}
    return True


def _but(found: Verdicts, numbers: Sequence[Graded], wrong: Sequence[Graded]) -> bool:
    """Whether all numbers but the wrong ones are right."""
    return all(found.exact[one.key].is_right for one in numbers if one not in wrong)


def _of_scales(found: Verdicts, why: Causes) -> None:
    """One factor on all values of a scale, whose lengths are right or not written, or on all its lengths: the scale was
    wrong, or is another than the one that is stated."""
    for mu in found.key.scales:
        drawn = [one for one in found.key.quantities if one.mu == mu and one.key in found.given]
        lengths = [one for one in drawn if one.kind is Kind.READING]
        values = [one for one in drawn if one.kind is Kind.VECTOR and one.exact]
        if len(lengths) >= ALIKE:
            _by_one_factor(found, why, lengths, mu)
        if all(found.exact[one.key].is_right for one in lengths) and len(values) >= ALIKE:
            _by_one_factor(found, why, values, mu)


def _by_one_factor(found: Verdicts, why: Causes, drawn: Sequence[Graded], mu: str) -> None:
    """What is wrong by one factor costs once: a power of ten is one of the unit, another factor one of the scale."""
    k = _mean(found, drawn)
    if k and all(found.exact[one.key] is Outcome.WRONG and _scaled(found, one, k) for one in drawn):
        said = _power(k) or message(Told.SCALE_CONST, k=f"{k:.3g}", mu=mu.replace("mu", "μ"))
        _once(found, why, drawn, said)


def _once(found: Verdicts, why: Causes, wrong: Sequence[Graded], said: Message) -> None:
    """The first of these that is paid tells why, and costs; the others are right by it."""
    first = next((one.key for one in wrong if one.points.total), wrong[0].key)
    why.said[first] = said
    for name in (one.key for one in wrong if one.key != first):
        found.outcome[name], found.basis[name], why.source[name] = Outcome.RIGHT, Basis.SCALE, first
    found.outcome[first], found.basis[first] = Outcome.WRONG, Basis.EXACT


def _mean(found: Verdicts, drawn: Sequence[Graded]) -> float:
    """By what these are off, the more exactly known the heavier."""
    weights = [(one.exact / max(one.allowed, FINEST * abs(one.exact))) ** 2 for one in drawn]
    ratios = (abs(found.given[one.key].value / one.exact) for one in drawn)
    return sum(weight * ratio for weight, ratio in zip(weights, ratios, strict=True)) / sum(weights)


def _power(k: float) -> Message | None:
    """That it is a power of ten, where it is one."""
    power = round(log10(k))
    return message(Told.POW10, n=str(power)) if power and abs(k / 10.0**power - 1) < TENFOLD else None


def _scaled(found: Verdicts, one: Graded, k: float) -> bool:
    off = abs(abs(found.given[one.key].value) / k - abs(one.exact))
    return off <= found.key.allowance.wrong * one.allowed
