"""Students who drew rightly and write down something else: nothing at all, another sense or direction, another name's
value, everything by a factor. No mistake of the catalogue is behind it."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from tests.grader_proof.judge import Tally, Trial
from tests.grader_proof.students import Class, times
from vecpoly.grading.key import Graded, Kind

PLAIN = 2.0  # T: what differs by more is another value
TURNED = (50.0, 180.0)  # degrees by which a direction is wrong, each way
FACTOR = (1.25, 1.6)  # of everything, each way


def zeros(trial: Trial, group: Class, count: int, seed: int) -> Iterator[Tally]:
    """0 in every cell, or in a third of them and the rest right."""
    rng = np.random.default_rng(seed)
    for n in range(count):
        cells = group.sheet(n % group.count, rng)
        share = 1.0 if n % 2 else 0.33
        chosen = [name for name in cells if _number(trial.key[name]) and rng.random() < share]
        sheet, tally = trial.mark(cells | {name: _zero(cells[name]) for name in chosen}), Tally()
        wrong = [name for name in chosen if abs(trial.key[name].exact) > PLAIN * trial.key[name].allowed]
        tally.add("zeros taken as right", sum(sheet[name].is_right for name in wrong), len(wrong))
        tally.add("zeros accused of a slip", bool(sheet.slips) if share == 1 else 0)
        yield tally


def _zero(cell: str) -> str:
    _, blank, rest = cell.partition(" ")
    return "0" if "∠" in rest else f"0{blank}{rest}"


def turned(trial: Trial, group: Class, count: int, seed: int) -> Iterator[Tally]:
    """One direction or sense that is another, the rest right: beside lengths, and with none written."""
    rng = np.random.default_rng(seed)
    usable = [one for one in trial.key.quantities if _has_direction(one)]
    for n in range(count if usable else 0):
        cells = group.sheet(n % group.count, rng)
        one = usable[int(rng.integers(len(usable)))]
        if n % 2:
            cells = {name: text for name, text in cells.items() if trial.key[name].kind is not Kind.READING}
        if one.key not in cells:
            continue
        cells[one.key] = _otherwise(one, cells[one.key], rng)
        sheet, tally = trial.mark(cells), Tally()
        tally.add("another direction or sense caught", not sheet[one.key].is_right)
        tally.add("another direction or sense named as a slip", bool(sheet.slips))
        others = [each for each in sheet.findings if each.written.raw and each.key != one.key]
        tally.add("one direction or sense costs once", all(each.is_right for each in others))
        yield tally


def _has_direction(one: Graded) -> bool:
    sized = abs(one.exact) > PLAIN * one.allowed
    return one.asked and not one.demoted and sized and one.kind in (Kind.VECTOR, Kind.SIGNED) and (
        one.kind is Kind.SIGNED or one.degrees is not None
    )  # fmt: skip


def _otherwise(one: Graded, cell: str, rng: np.random.Generator) -> str:
    size = cell.partition(" ")[0]
    if one.kind is Kind.SIGNED:
        return f"{size} {'cw' if one.exact > 0 else 'ccw'}"
    assert one.degrees is not None
    return f"{size} ∠ {one.degrees + rng.choice([-1, 1]) * rng.uniform(*TURNED):.0f}°"


def exchanged(trial: Trial, group: Class, count: int, seed: int) -> Iterator[Tally]:
    """Two values of one kind and unit in each other's cells, the rest right."""
    rng = np.random.default_rng(seed)
    asked = [one for one in trial.key.quantities if one.asked and not one.demoted and _number(one)]
    pairs = [(a, b) for n, a in enumerate(asked) for b in asked[n + 1 :] if _exchangeable(a, b)]
    for n in range(count if pairs else 0):
        one, other = pairs[int(rng.integers(len(pairs)))]
        cells = group.sheet(n % group.count, rng)
        if not {one.key, other.key} <= set(cells):
            continue
        cells |= {one.key: cells[other.key], other.key: cells[one.key]}
        sheet, tally = trial.mark(cells), Tally()
        tally.add("names exchanged: caught", not (sheet[one.key].is_right and sheet[other.key].is_right))
        tally.add("names exchanged: named as a slip", bool(sheet.slips))
        yield tally


def _exchangeable(one: Graded, other: Graded) -> bool:
    apart = abs(abs(one.exact) - abs(other.exact)) > PLAIN * max(one.allowed, other.allowed)
    return apart and one.kind is other.kind and one.unit == other.unit


def scaled(trial: Trial, group: Class, count: int, seed: int) -> Iterator[Tally]:
    """Every number by one factor, lengths on paper too."""
    rng = np.random.default_rng(seed)
    for n in range(count):
        k = float(rng.uniform(*FACTOR) ** rng.choice([-1, 1]))
        cells = group.sheet(n % group.count, rng)
        sizes = {name: times(text, k) for name, text in cells.items() if _number(trial.key[name])}
        sheet, tally = trial.mark(cells | sizes), Tally()
        tally.add("everything by a factor: named as a slip", bool(sheet.slips))
        yield tally


def _number(one: Graded) -> bool:
    return one.kind in (Kind.READING, Kind.VECTOR, Kind.SIGNED, Kind.SCALAR)


TRIALS = (zeros, turned, exchanged, scaled)
