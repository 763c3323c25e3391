"""What the grader makes of each sort of student."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import Any

import numpy as np

from tests.grader_proof.judge import Tally, Trial, apart, named
from tests.grader_proof.students import Cells, Class, drawn_class, times
from tests.grader_proof.telling import alike, as_written, distinct, shows
from vecpoly import Problem
from vecpoly.board.otherwise.amended import Amended
from vecpoly.board.otherwise.slip import Slip
from vecpoly.errors import VecpolyError
from vecpoly.grading.compare.outcome import Basis, Outcome
from vecpoly.grading.derive.keyed import answer_key
from vecpoly.grading.key import Graded, Kind
from vecpoly.grading.rules import Rules

ALONE = Rules(following=False)
REACH = Rules().reach


def right_work(trial: Trial, skill: str, count: int, seed: int) -> Iterator[Tally]:
    """Students who make no mistake."""
    rng = np.random.default_rng(seed)
    group = drawn_class(trial.problem, trial.key, skill, count, seed)
    for student in range(count):
        sheet, tally = trial.mark(group.sheet(student, rng)), Tally()
        written = [one for one in sheet.findings if one.written.raw]
        good = [one.is_right for one in written]
        tally.add(f"{skill}: whole sheets accepted", all(good))
        tally.add(f"{skill}: quantities accepted", sum(good), len(good))
        tally.add(f"{skill}: accused of a slip", bool(sheet.slips))
        full = all(one.outcome is Outcome.RIGHT or one.basis is Basis.OWN for one in written)
        tally.add(f"{skill}: full accuracy on the whole sheet", full)
        yield tally


def single_slips(trial: Trial, count: int, seed: int) -> Iterator[tuple[Slip, Tally]]:
    """Students who each make one mistake of the catalogue that shows."""
    rng = np.random.default_rng(seed)
    shown = [one for one in trial.mutants if shows(trial, one)]
    if not shown:
        return
    made = [(mutant, slip) for mutant in shown for slip in (mutant.slip, *mutant.also)]
    each = max(1, count // len(made))
    for mutant, slip in made:
        try:
            group = drawn_class(trial.problem, trial.key, "pencil", each, seed, Amended(slip=slip))
        except VecpolyError:
            continue  # nobody's figure closes: such a sheet has no numbers
        for student in range(each):
            cells = group.sheet(student, rng)
            mine = as_written(mutant, cells)
            if not _complete(cells, trial) or not shows(trial, mine):
                continue
            sheet, tally = trial.mark(cells), Tally()
            tally.add("single slips caught", bool(sheet.roots))
            told = named(trial, sheet)
            kind = "single slips" if distinct(trial, mine, cells) else "slips that nothing tells apart:"
            rightly = any(alike(trial, one, mine, cells) for one in told)
            tally.add(f"{kind} named rightly", rightly)
            tally.add("single slips named as another", bool(told) and not rightly)
            yield slip, tally


def _complete(cells: Cells, trial: Trial) -> bool:
    """Whether the polygons closed: a sheet without most of its numbers is no work of this kind."""
    return len(cells) >= 0.8 * sum(one.asked or one.kind is Kind.READING for one in trial.key.quantities)


def two_slips(trial: Trial, count: int, seed: int) -> Iterator[Tally]:
    """Students who each make two mistakes."""
    rng = np.random.default_rng(seed)
    shown = [one for one in trial.mutants if shows(trial, one)]
    if len(shown) < 2:
        return
    for n in range(count):
        first, second = (shown[i] for i in rng.choice(len(shown), 2, replace=False))
        try:
            group = drawn_class(
                trial.problem, trial.key, "pencil", 1, seed + n, Amended(slip=first.slip, each=(second.slip,))
            )
        except (VecpolyError, ValueError):
            continue
        cells = group.sheet(0, rng)
        if not _complete(cells, trial):
            continue
        sheet, tally = trial.mark(cells), Tally()
        tally.add("two slips caught", bool(sheet.roots))
        told = named(trial, sheet)
        rightly = any(alike(trial, one, each, cells) for one in told for each in (first, second))
        tally.add("two slips: one of them named", rightly)
        wrong = bool(told) and not rightly
        tally.add("two slips: a third named", wrong)
        yield tally


def uncatalogued(trial: Trial, group: Class, count: int, seed: int) -> Iterator[Tally]:
    """Right work but for one value that is off by no known slip."""
    rng = np.random.default_rng(seed)
    usable = [one for one in trial.key.quantities if _may_be_off(one)]
    for n in range(count if usable else 0):
        cells = group.sheet(n % group.count, rng)
        one = usable[int(rng.integers(len(usable)))]
        factor = float(
            np.exp(rng.choice([-1, 1]) * rng.uniform(np.log(1 + 4 * one.allowed / abs(one.exact)), np.log(3)))
        )
        cells[one.key] = times(cells[one.key], factor)
        sheet, tally = trial.mark(cells), Tally()
        tally.add("uncatalogued errors caught", not sheet[one.key].is_right)
        told = {said.id.value for said in sheet[one.key].messages}
        tally.add("uncatalogued errors named as a slip", bool(sheet.slips))
        tally.add(
            "uncatalogued errors: a factor or another vector offered",
            bool(told & {"pow10", "two_pi", "per_minute", "swapped"}),
        )
        yield tally


def _may_be_off(one: Graded) -> bool:
    """Whether a number can be off by more than its tolerance, and by less than a factor 3."""
    number = one.kind in (Kind.VECTOR, Kind.SIGNED, Kind.SCALAR) and one.asked and not one.demoted
    return number and 2 * one.allowed < abs(one.exact)


def misread(trial: Trial, group: Class, count: int, seed: int) -> Iterator[Tally]:
    """One length misread, and everything gone on with from it, step by step."""
    from vecpoly.board.otherwise.amended import Own
    from vecpoly.foundation.frozen import FrozenMap

    rng = np.random.default_rng(seed)
    lengths = [
        one for one in trial.key.quantities if one.kind is Kind.READING and one.mm and one.mm > 10 and one.mu != "mu_l"
    ]
    for _ in range(count if lengths else 0):
        one = lengths[int(rng.integers(len(lengths)))]
        own = one.exact + float(rng.choice([-1, 1])) * max(5.0, 4 * one.allowed)
        if not 1 / REACH < own / one.exact < REACH:
            continue  # nothing is continued from what is so far off
        exact = drawn_class_exactly(trial, Amended(own=(Own(readings=FrozenMap({one.letters: round(own, 1)})),)))
        cells = exact.sheet(0, rng)
        followed, alone, tally = trial.mark(cells), trial.mark(cells, ALONE), Tally()
        tally.add("follow-through lowered a mark", followed.exactly < alone.exactly - 1e-9)
        others = [each for each in followed.findings if each.written.raw and each.key != one.key]
        tally.add("one misreading costs once", all(each.is_right for each in others))
        yield tally


def drawn_class_exactly(trial: Trial, amended: Amended) -> Class:
    """One student with an exact hand and a misread length."""
    from vecpoly.grading.redraw import by_hands

    return Class(trial.key, by_hands(trial.problem, trial.key, amended), 1)


def blanks(trial: Trial, group: Class, count: int, seed: int) -> Iterator[Tally]:
    """Right work of which a third is left out, and scribbles."""
    rng = np.random.default_rng(seed)
    for n in range(count):
        cells = {
            key: cell if rng.random() > 0.33 else str(rng.choice(["", "—", "?", "abc"]))
            for key, cell in group.sheet(n % group.count, rng).items()
        }
        sheet, tally = trial.mark(cells), Tally()
        good = [one for one in sheet.findings if one.outcome.answered]
        tally.add("blanks: accused of a slip", bool(sheet.slips))
        tally.add("blanks: quantities accepted", sum(one.is_right for one in good), len(good))
        yield tally


def foreign(trial: Trial, others: Sequence[Problem], count: int, seed: int) -> Iterator[Tally]:
    """Another student's right work, handed in as one's own."""
    rng = np.random.default_rng(seed)
    for other in others:
        try:
            theirs = answer_key(other)
            if not apart(trial.key, theirs):
                continue  # the gate of a class hands out no two such variants
            group: Any = drawn_class(other, theirs, "pencil", max(1, count // len(others)), seed)
        except VecpolyError:
            continue
        for n in range(group.count):
            cells = {key: cell for key, cell in group.sheet(n, rng).items() if trial.key.find(key) is not None}
            sheet, tally = trial.mark(cells), Tally()
            tally.add(
                "another student's sheet accepted", all(one.is_right for one in sheet.findings if one.written.raw)
            )
            tally.add(
                "another student's sheet: exact-right quantities",
                sum(one.is_right and one.basis is Basis.EXACT for one in sheet.findings if one.written.raw),
                sum(bool(one.written.raw) for one in sheet.findings),
            )
            yield tally
