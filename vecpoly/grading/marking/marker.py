"""Mark a sheet: every answer weighed, followed, explained, paid and told of."""

from __future__ import annotations

from collections.abc import Callable, Collection, Sequence
from math import copysign, isfinite, log10

from ...algebra.quantity import number
from ...foundation.slotted import replace
from ...problem.problem import Problem
from ...words import bare
from ..compare.measured import Measured, UnitFault
from ..compare.outcome import Basis, Finding, Outcome
from ..derive.rubric import scale_of
from ..drawings.judging.mark import DrawingMark
from ..equations.mark import only_with_equation, paid_by_equations
from ..key import AnswerKey, Graded, Kind, Points
from ..reading.written import State, Written
from ..rules import USUAL_RULES, Rules
from ..sheet import Sheet
from ..slips.mutants import Mutant
from ..told.message import Message, message
from ..told.named import Told
from .causes import causes
from .drawn import paid_by_length
from .lines import drawn_by, paid_by_lines, with_lengths
from .marked import Marked
from .order import in_order
from .points import earned
from .scaled import at_own_scales, mutants_at
from .solutions import as_answered
from .tell import off_by, sentences, source_of
from .verdict import Verdicts, verdicts
from .why import Causes

Mutants = Callable[[], Sequence[Mutant]]
BLANK = Written(raw="", state=State.BLANK)
ROUND = (1.0, 2.0, 2.5, 5.0, 10.0)
SAME = 1e-6  # of a scale: nearer to each other two are one


def mark(
    problem: Problem,
    key: AnswerKey,
    mutants: Mutants,
    sheet: Sheet,
    rules: Rules = USUAL_RULES,
    drawing: DrawingMark | None = None,
) -> Marked:
    """The marks of a sheet, with a reason for each; drawing: the verdict on the one that was handed in with it.

    problem: the student's own variant, to be drawn anew with own values; mutants: gives those of `slips.mutants`, asked
    only where something is wrong. The same sheet has the same marks whatever is marked before it, and never fewer with
    follow-through than without.
    """
    sheet, order = in_order(key, sheet)
    key, other = as_answered(problem, key, sheet)
    key, equations = paid_by_equations(key, sheet, rules)
    unpaid, lines = paid_by_lines(key, drawing, rules)
    paid = paid_by_length(unpaid, sheet, rules)
    key = at_own_scales(paid, sheet.scales)
    sheet = replace(sheet, drawn=with_lengths(key, drawn_by(unpaid, drawing if lines else None)))
    found = verdicts(problem, key, sheet, rules)
    why = causes(found, mutants_at(paid, mutants(), sheet.scales)) if found.roots() else Causes()
    named = {name for name, said in why.said.items() if said.id is not Told.TWO_SLIPS}
    findings = tuple(_finding(found, why, one, named, rules) for one in key.quantities if _shown(one, sheet))
    findings = only_with_equation(findings, unpaid, key, equations, rules)
    used = {key[name].mu for name in found.given}
    used |= {scale_of(one.block, key.quantities, key.scales) for one in map(key.__getitem__, found.given) if one.at}
    used |= {key[one.key].mu for one in lines if one.earned}
    stated = {mu: worth for mu, worth in key.stated.items() if mu in sheet.stated and mu in {*used, *sheet.scales}}
    faulty = any(one.fault is UnitFault.DIMENSION or (one.fault and not rules.printed) for one in found.given.values())
    return Marked(
        key=key, findings=findings, stated=stated, lost=rules.unit if faulty else 0.0, lines=lines, slips=why.slips,
        equations=equations, roots=tuple(one.key for one in found.roots()), faults=sheet.faults,
        messages=(*order, *other, *_of_scales(key, sheet, used)),
    )  # fmt: skip


def _shown(one: Graded, sheet: Sheet) -> bool:
    return one.key in sheet.answers or one.points.total > 0


def _finding(found: Verdicts, why: Causes, one: Graded, named: set[str], rules: Rules) -> Finding:
    if one.key not in found.sheet.answers:
        return Finding(key=one.key, written=BLANK, outcome=Outcome.BLANK, messages=(message(Told.BLANK),))
    outcome, basis, mine = found.outcome[one.key], found.basis.get(one.key, Basis.EXACT), found.given.get(one.key)
    said = sentences(found, why, one, rules)
    off = off_by(found, one) if mine is not None and mine.at is None else None
    return Finding(
        key=one.key, written=found.sheet.answers[one.key], outcome=outcome, basis=basis, messages=said,
        value=None if mine is None else _signed(mine, one), off=off if off is not None and isfinite(off) else None,
        earned=_points(found, one, one.key in named, rules), chain=_chain(found, one.key),
        for_a_person=outcome.for_a_person or any(each.id is Told.UNDRAWABLE for each in said),
    )  # fmt: skip


def _signed(mine: Measured, one: Graded) -> float:
    """What was written, negative where it was said to turn clockwise."""
    return copysign(mine.value, mine.sense) if one.kind is Kind.SIGNED and mine.sense else mine.value


def _points(found: Verdicts, one: Graded, named: bool, rules: Rules) -> Points:
    """By the better basis: never fewer points than by the exact values alone."""
    mine = found.given.get(one.key)
    best = earned(one, found.outcome[one.key], found.basis.get(one.key, Basis.EXACT), mine, named, rules)
    alone = earned(one, found.exact[one.key], Basis.EXACT, mine, named, rules)
    return max(best, alone, key=lambda points: points.total)


def _chain(found: Verdicts, name: str) -> int:
    """Through how many own values in a row an answer was followed."""
    if found.basis.get(name) is not Basis.OWN:
        return 0
    return 1 + _chain(found, source_of(found, found.key[name]))


def _of_scales(key: AnswerKey, sheet: Sheet, used: Collection[str]) -> list[Message]:
    """Scales that are not stated of figures on which something was answered, and those that nobody would take; that of
    the sheet may be any."""
    lacking = [mu for mu in key.stated if mu in used and mu not in sheet.stated]
    missing = [message(Told.SCALE_UNDECLARED, mu=_mu(mu)) for mu in lacking]
    odd = [
        message(Told.SCALE_ODD, mu=_mu(mu), v=bare(number(value)))
        for mu, value in sheet.scales.items()
        if not _round(value) and abs(value / key.scales.get(mu, value * 2) - 1) > SAME
    ]
    return [*missing, *odd]


def _round(value: float) -> bool:
    """Whether a scale is 1, 2, 2.5 or 5 times a power of ten."""
    digits = 10.0 ** (log10(value) % 1.0)
    return any(abs(digits / step - 1) < SAME for step in ROUND)


def _mu(mu: str) -> str:
    return mu.replace("mu", "μ")
