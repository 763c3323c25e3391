"""Exact powers of a train of machines: every machine's balance η P_in = Σ P_next is one row of a linear system."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from ...devices.power_train import ETA, POWER, POWER_OUT, PowerTrain, eta_prime, out, share
from ...devices.train import Part, Train, ends, parts
from .registry import Values, answers


@answers(PowerTrain)
def power_train(device: PowerTrain) -> Values:
    """All powers in kW from the balances of all machines; efficiencies as their quotients."""
    given = {
        id(end): (end.P.si if end.P else end.F.si * end.v.si if end.F and end.v else 0.0) / 1e3
        for end in ends(device.train)
    }
    taken = _balance(device.train, given)
    motor = taken[id(device.train[0])]
    values: dict[str, complex | float] = {}
    for letter, end in zip(device.letters, ends(device.train), strict=True):
        alone = _balance(device.train, {id(end): given[id(end)]})  # powers superpose: the others idle
        values |= {out(letter).key: given[id(end)], share(letter).key: alone[id(device.train[0])]}
    nodes = [part for part in parts(device.train) if part.parallel is not None]
    for i, node in enumerate(nodes):
        useful = sum(given[id(end)] for end in ends((node,)))
        values[eta_prime(i, len(nodes)).key] = useful / taken[id(node)]
    total = sum(given.values())
    return values | {POWER_OUT.key: total, ETA.key: total / motor, POWER.key: motor}


def _balance(train: Train, given: dict[int, float]) -> dict[int, float]:
    """The power that every part takes, by id, when the ends deliver what is given."""
    everything = list(parts(train))
    column = {id(part): i for i, part in enumerate(everything)}
    rows, right = np.zeros((len(everything), len(everything))), np.zeros(len(everything))
    for part, after in _followers(train):
        row = column[id(part)]
        rows[row, row] = part.eta if part.parallel is None else 1.0
        for index in after:
            rows[row, column[index]] -= 1.0
        right[row] = given.get(id(part), 0.0)
    solved = np.linalg.solve(rows, right)
    return {id(part): float(solved[i]) for i, part in enumerate(everything)}


def _followers(train: Train) -> Iterator[tuple[Part, list[int]]]:
    """Every part with the ids of those that its power runs on to."""
    for part, after in zip(train, (*train[1:], None), strict=True):
        branches = part.parallel or ()
        yield part, [id(branch[0]) for branch in branches] + ([id(after)] if after else [])
        for branch in branches:
            yield from _followers(branch)
