"""The sentences of one finding."""

from __future__ import annotations

from collections.abc import Iterator
from math import floor, isfinite, log10

from ...algebra.quantity import number
from ...names import written_unit
from ...words import Words, bare
from ..compare.band import beside_line, distance, gap, is_other_sense, target_of, widened
from ..compare.measured import UnitFault
from ..compare.outcome import Basis, Outcome
from ..key import Graded, Kind, is_count
from ..rules import Rules
from ..told.message import Message, message
from ..told.named import Told
from .verdict import Verdicts
from .why import Causes

_OTHER_KIND = Words("写的不是所求的那种量", "it is not the kind of answer that is asked")
_ASKED = {
    Kind.PLACE: Words("应写两个坐标，如 (12.5, −30) mm", "two coordinates are asked, as in (12.5, −30) mm"),
    Kind.YES_NO: Words("应写“是”或“否”", "yes or no is asked"),
}
FINEST = 1e-4  # of T: of less so many noughts are no help


def sentences(found: Verdicts, why: Causes, one: Graded, rules: Rules) -> tuple[Message, ...]:
    """What is said of one answer, the outcome first."""
    text = found.sheet.answers[one.key]
    return (
        *_outcome(found, why, one),
        *_sign(found, one),
        *_unit(found, one, rules),
        *_digits(found, one, text.digits, rules),
        *_demoted(found, one),
        *_read(found, one),
    )


def _outcome(found: Verdicts, why: Causes, one: Graded) -> Iterator[Message]:
    outcome, basis = found.outcome[one.key], found.basis.get(one.key, Basis.EXACT)
    raw = found.sheet.answers[one.key]
    reason = _ASKED.get(one.kind) or raw.why or _OTHER_KIND
    match outcome:
        case Outcome.BLANK:
            yield message(Told.BLANK)
        case Outcome.NONE:
            yield message(Told.NONE, raw=raw.raw)
        case Outcome.UNREADABLE:
            yield message(Told.UNREADABLE, raw=raw.raw, why=reason)
        case Outcome.AMBIGUOUS:
            yield message(Told.AMBIGUOUS, raw=raw.raw, why=reason)
        case Outcome.RIGHT | Outcome.CLOSE | Outcome.UNSAID:
            yield _right(found, why, one, outcome, basis)
            if outcome is Outcome.UNSAID or (outcome is Outcome.CLOSE and _is_unsaid(found, one)):
                yield message(Told.SENSE_MISSING)
        case Outcome.SENSE | Outcome.DIRECTION | Outcome.WRONG:
            yield from _wrong(found, why, one, outcome)


def _astray(found: Verdicts, one: Graded) -> Message:
    """By how much a wrong value is off: a place that is near enough along its line, across that."""
    aside = beside_line(found.given[one.key], one, target_of(one))
    if one.leans is not None and abs(off_by(found, one)) <= one.allowed:
        return message(Told.BESIDE, a=f"∠{one.leans:.0f}°", e=_amount(one, aside, 2), t=_amount(one, one.across, 2))
    return message(Told.WRONG, e=_off(found, one), t=_amount(one, one.allowed, 2))


def _is_unsaid(found: Verdicts, one: Graded) -> bool:
    """Whether no sense was written of what turns."""
    return one.kind is Kind.SIGNED and abs(one.exact) > one.allowed and not found.given[one.key].sense


def _right(found: Verdicts, why: Causes, one: Graded, outcome: Outcome, basis: Basis) -> Message:
    match basis:
        case Basis.OWN:
            source = source_of(found, one)
            return message(Told.OK_OWN, src=found.key[source].symbol, v=_mine(found, source))
        case Basis.DRAWN:
            return message(Told.OK_DRAWN, v=_amount(one, _drawn(found, one)))
        case Basis.SLIP | Basis.SCALE:
            return message(Told.OK_SLIP, src=found.key[why.source[one.key]].symbol)
        case Basis.EXACT:
            if one.kind is Kind.YES_NO or (is_count(one) and not off_by(found, one)):
                return message(Told.RIGHT)
            if outcome is Outcome.CLOSE:
                return message(Told.CLOSE, e=_off(found, one), t=_amount(one, one.allowed, 2))
            return _exactly(found, one)


def _exactly(found: Verdicts, one: Graded) -> Message:
    """By how much a right value is off, in mm where it is drawn; of what few digits let pass, that they do."""
    off, allowed = abs(off_by(found, one)), _amount(one, one.allowed, 2)
    if off > one.allowed * (1 + 1e-9):
        wide = widened(found.given[one.key], target_of(one))
        return message(Told.OK_ROUNDED, e=_off(found, one), t=allowed, w=_amount(one, wide, 2))
    if one.allowed_mm is None or one.kind not in (Kind.READING, Kind.VECTOR):
        return message(Told.OK_RECKONED, e=_off(found, one), t=allowed)
    mm = off * one.allowed_mm / one.allowed
    return message(Told.OK, e=_rounded(mm, one.allowed_mm), t=number(one.allowed_mm, 2))


def _drawn(found: Verdicts, one: Graded) -> float:
    """What stands on the own drawing, as it is written down: mm of a length, SI of a value."""
    size = abs(found.sheet.drawn[one.key])
    return size / found.key.scales[one.mu] if one.kind is Kind.READING else size


def _wrong(found: Verdicts, why: Causes, one: Graded, outcome: Outcome) -> Iterator[Message]:
    said = why.said.get(one.key)
    if outcome is Outcome.WRONG and one.key in found.contradicted:
        yield message(Told.NOT_RIGHT)
        return
    if outcome is Outcome.SENSE:
        yield message({Kind.SIGNED: Told.SENSE, Kind.VECTOR: Told.REVERSED}.get(one.kind, Told.SIGN))
    elif outcome is Outcome.DIRECTION:
        direction = found.given[one.key].direction
        assert direction is not None and one.degrees is not None
        yield message(Told.DIRECTION, d=f"{direction.beside(one.degrees):.0f}")
    elif (one.kind is Kind.YES_NO or is_count(one)) and (said is None or said.id is Told.TWO_SLIPS):
        yield message(Told.NOT_RIGHT)
    elif said is None or said.id in (Told.TWO_SLIPS, Told.SWAPPED, Told.EXCHANGED):
        nothing = not found.given[one.key].value and abs(one.exact) <= one.allowed and one.at is None
        yield (message(Told.NOT_ZERO) if nothing else _astray(found, one))
    if outcome is not Outcome.WRONG and found.exact[one.key] is Outcome.WRONG and one.key in found.followed:
        source = source_of(found, one)
        yield message(Told.SIZE_OWN, src=found.key[source].symbol, v=_mine(found, source))
    if said is not None:
        yield said
    if one.key not in why.slips and _turns_otherwise(found, one):
        yield message(Told.SENSE_TOO)
    followed = found.followed.get(one.key)
    if outcome is Outcome.WRONG and followed is not None and followed.target is not None and said is None:
        source = source_of(found, one)
        own = _amount(one, followed.target.value)
        if not found.exact[source].is_right:
            yield message(Told.WRONG_FROM, src=found.key[source].symbol, v=_mine(found, source), own=own)
    elif followed is not None and followed.target is None:
        yield message(Told.UNDRAWABLE)
    if outcome is Outcome.WRONG:
        yield from (message(Told.NOT_FOLLOWED, src=found.key[name].symbol) for name in found.follower.refused(one))


def source_of(found: Verdicts, one: Graded) -> str:
    """The own value that a step was continued from: of several the one that is farthest off."""
    sources = found.followed[one.key].sources
    return max(sources, key=lambda name: abs(off_by(found, found.key[name])) / max(found.key[name].allowed, 1e-300))


def _demoted(found: Verdicts, one: Graded) -> Iterator[Message]:
    """What “right” is worth where a drawing can hardly tell it from another value."""
    if one.demoted and found.outcome[one.key].is_right and found.basis.get(one.key, Basis.EXACT) is Basis.EXACT:
        whole = max(abs(each.exact) for each in found.key.quantities if each.unit == one.unit)
        size = whole if one.kind is Kind.PLACE or not one.exact else abs(one.exact)
        along = "" if one.leans is None else f" ∠{one.leans:.0f}°"
        yield message(Told.DEMOTED, t=_amount(one, one.allowed, 2) + along, share=f"{100 * one.allowed / size:.0f}")


def _sign(found: Verdicts, one: Graded) -> Iterator[Message]:
    if one.unsigned and one.key in found.given and found.sheet.answers[one.key].value < 0:
        yield message(Told.SIGN_FREE)


def _unit(found: Verdicts, one: Graded, rules: Rules) -> Iterator[Message]:
    mine = found.given.get(one.key)
    if mine is None:
        return
    if mine.fault is UnitFault.MISSING and not rules.printed:
        yield message(Told.UNIT_MISSING, u=written_unit(one.written_in))
    if mine.fault is UnitFault.DIMENSION:
        unit, asked = found.sheet.answers[one.key].unit, written_unit(one.written_in)
        given = unit.text if unit else ""
        yield message(Told.UNIT_WRONG, given=given, u=asked) if asked else message(Told.UNIT_NONE, given=given)


def _digits(found: Verdicts, one: Graded, digits: int, rules: Rules) -> Iterator[Message]:
    if not found.outcome[one.key].answered or one.kind is Kind.YES_NO or is_count(one) or not digits:
        return
    if digits < rules.few_digits and abs(off_by(found, one)) > 1e-9 * abs(one.exact):
        yield message(Told.FEW_DIGITS, n=str(digits))
    if digits > rules.many_digits:
        yield message(Told.MANY_DIGITS, n=str(digits))


def _read(found: Verdicts, one: Graded) -> Iterator[Message]:
    """A value against the student's own length × own μ, or against what else follows from it."""
    if one.kind is not Kind.VECTOR and (follows := found.contradicted.get(one.key)) is not None:
        own = _amount(one, follows.value)
        yield message(Told.WRONG_FROM, src=found.key[one.line].symbol, v=_mine(found, one.line), own=own)
    if one.line not in found.given or one.mu not in found.key.scales or one.kind is not Kind.VECTOR:
        return
    if (mine := found.given.get(one.key)) is None:
        return
    mm, mu = abs(found.given[one.line].value), found.key.scales[one.mu]
    if abs(abs(mine.value) - mm * mu) > mu * found.key.allowance.reading + mine.half:
        yield message(Told.READ, mm=number(mm, 4), mu=number(mu, 3), own=_amount(one, mm * mu))


def off_by(found: Verdicts, one: Graded) -> float:
    """How far an answer is from the exact value: where its size is wrong and its sense too, both together."""
    mine = found.given[one.key]
    if mine.at is not None and one.at is not None:
        return distance(mine, one, target_of(one))
    if _turns_otherwise(found, one):
        return abs(mine.value) + abs(one.exact)
    return gap(mine.value, one, target_of(one))


def _turns_otherwise(found: Verdicts, one: Graded) -> bool:
    """Whether a wrong size has the wrong sense as well."""
    return found.outcome[one.key] is Outcome.WRONG and is_other_sense(found.given[one.key], one)


def _off(found: Verdicts, one: Graded) -> str:
    off = abs(off_by(found, one))
    return _with_unit(_rounded(off / one.one, one.allowed / one.one), one) if isfinite(off) else "?"


def _rounded(off: float, allowed: float) -> str:
    """An error to two digits; a small one to the decimals of T with two digits, beyond which nobody measures."""
    if off >= allowed or allowed < FINEST:
        return bare(number(off, 2))
    return f"{off:.{max(0, 1 - floor(log10(allowed * (1 + 1e-9))))}f}"


def _mine(found: Verdicts, name: str) -> str:
    one, mine = found.key[name], found.given[name]
    if mine.at is not None:
        return f"({', '.join(bare(number(way / one.one, 4)) for way in mine.at)}) {written_unit(one.written_in)}"
    return _amount(one, mine.value if one.kind is Kind.SCALAR else abs(mine.value), 4)


def _amount(one: Graded, value: float, digits: int = 3) -> str:
    """A number with the unit of its quantity, as it is printed."""
    return _with_unit(bare(number(value / one.one, digits)), one)


def _with_unit(text: str, one: Graded) -> str:
    unit = written_unit(one.written_in)
    return text + unit if unit == "°" else f"{text} {unit}".strip()
