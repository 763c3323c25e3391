"""What each load does round the cycle, drive or resist, and where there is no equilibrium, for what cause."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

from ...oracle.forces import Cause
from ...oracle.forces.acting import given, sought
from ...oracle.forces.pairs import Pair, pairs_of
from ..cycle import Cycle
from ..root import ridders
from ..sample import sample

__all__ = ["Cause", "Duty", "Still", "duties", "idle", "stills", "within"]

Reals = NDArray[np.float64]
Codes = NDArray[np.int_]
PARTS, ROUNDS = 128, 5  # a boundary's bracket is cut into 128, five times: to 1e-13 rad
_CAUSES = 8  # more than there are
_EDGE = 1e-6  # rad, or m
_NOTHING = 1e-12  # of the greatest power: none
_IDLE = 1e-9  # of what the loads could do at their speeds: a load that never does more does no work


@dataclass(frozen=True, slots=True)
class Duty:
    """A stretch low..high of the drive (rad, or m;
    over a whole turn's end it goes on past it) with the same part for every load.

    cause: why there is no equilibrium, NONE where there is. drives, resists:
    names of the loads whose power is positive, negative.
    """

    low: float
    high: float
    cause: Cause
    drives: tuple[str, ...]
    resists: tuple[str, ...]

    def holds(self, phi: float, turn: float, edge: float = 0.0) -> bool:
        """Whether the position lies in it, or beyond its ends by no more than `edge`;
        turn: 2π where the drive turns right round, else 0."""
        return any(self.low - edge <= phi + k * turn <= self.high + edge for k in ((-1, 0, 1) if turn else (0,)))


@dataclass(frozen=True, slots=True)
class Still:
    """A position at which two links with friction between them do not move against each other:
    friction changes its side there.

    who: the links by their printed numbers; letter: of the pin or contact, "" of a slide;
    turns: the relative motion is a rotation.
    """

    phi: float
    who: tuple[str, str]
    letter: str
    turns: bool


@lru_cache(maxsize=4)
def duties(cycle: Cycle) -> tuple[Duty, ...]:
    """The stretches in order of the drive's position, their ends to full accuracy; () without loads."""
    if cycle.loads is None:
        return ()
    names = _names(cycle)
    return tuple(
        Duty(low, high, Cause(code % _CAUSES), *_sorted(names, code // _CAUSES))
        for low, high, code in _stretches(cycle, lambda q: _codes(cycle, q))
    )


@lru_cache(maxsize=4)
def stills(cycle: Cycle) -> tuple[Still, ...]:
    """Where a pair with friction changes the sense of its relative motion, in order of the drive's position; not where
    there is no equilibrium on either side."""
    if cycle.loads is None:
        return ()
    phi, found = _grid(cycle), list[Still]()
    for index, pair in enumerate(_pairs(cycle, phi)):
        if not pair.rubs or pair.rate is None or pair.rate.size == 1:
            continue
        with np.errstate(invalid="ignore"):
            change = np.flatnonzero(pair.rate[:-1] * pair.rate[1:] < 0)
        letter = pair.text.en.rpartition(" ")[2]
        letter = letter if len(letter) and letter.isalpha() else ""
        places = ridders(lambda q, k=index: _rate(cycle, k, q), phi[change], phi[change + 1])  # type: ignore[misc]
        found += [Still(_reduced(cycle, float(q)), pair.who, letter, pair.turns) for q in places if np.isfinite(q)]
    turn = cycle.period
    free = (one for one in found if not any(duty.cause and duty.holds(one.phi, turn, _EDGE) for duty in duties(cycle)))
    return tuple(sorted(free, key=lambda still: still.phi))


def within(cycle: Cycle, duty: Duty) -> tuple[float, float]:
    """The ends of a stretch among the positions of one turn: over the turn's end the second is less than the first."""
    if not cycle.whole or duty.high - duty.low > cycle.period - _EDGE:
        return duty.low, duty.high
    low, high = _reduced(cycle, duty.low), _reduced(cycle, duty.high)
    return low, cycle.low + cycle.period if high < cycle.low + _EDGE else high


def idle(cycle: Cycle, name: str) -> tuple[float, ...]:
    """Positions at which the power of this load vanishes and changes its sign: dead points where it drives."""
    phi, index = _grid(cycle), _names(cycle).index(name)
    power = _power(cycle, index, phi)
    with np.errstate(invalid="ignore"):
        change = np.flatnonzero(power[:-1] * power[1:] < 0)
    found = ridders(lambda q: _power(cycle, index, q), phi[change], phi[change + 1])
    return tuple(sorted(_reduced(cycle, float(q)) for q in found if np.isfinite(q)))


def _names(cycle: Cycle) -> tuple[str, ...]:
    """The loads by name: those of known size as `Forces.powers` has them, the balancing one last."""
    assert cycle.loads is not None
    return (*(load.name for load in cycle.loads.all if load.size is not None), cycle.loads.unknown.name)


def _sorted(names: tuple[str, ...], signs: int) -> tuple[tuple[str, ...], tuple[str, ...]]:
    """Names that drive and that resist, out of their signs as ternary digits."""
    digits = [signs // 3**i % 3 for i in range(len(names))]
    return tuple(n for n, d in zip(names, digits, strict=True) if d == 1), tuple(
        n for n, d in zip(names, digits, strict=True) if d == 2
    )


def _grid(cycle: Cycle) -> Reals:
    """The grid on which turning points are sought, as far as the drive goes."""
    phi = cycle.on_grid(cycle.drive.key)[0]
    return np.asarray(phi if cycle.whole else phi[(phi > cycle.low) & (phi < cycle.high)], np.float64)


def _reduced(cycle: Cycle, phi: float) -> float:
    return cycle.low + (phi - cycle.low) % cycle.period if cycle.whole else phi


def _pairs(cycle: Cycle, phi: Reals) -> tuple[Pair, ...]:
    """All pairs, with the rates of their relative motion."""
    assert cycle.loads is not None
    bodies = sample(cycle.mech, None, phi).motion.bodies
    return pairs_of(cycle.mech, bodies, bodies, cycle.loads.friction)


def _rate(cycle: Cycle, index: int, phi: Reals) -> Reals:
    rate = _pairs(cycle, phi)[index].rate
    assert rate is not None
    return rate


def _power(cycle: Cycle, index: int, phi: Reals) -> Reals:
    """Of one load (W), by its place in `_names`; of unit size where it balances."""
    assert cycle.loads is not None
    bodies = sample(cycle.mech, None, phi).motion.bodies
    acts = (
        *given(cycle.mech, cycle.loads, bodies, phi)[: len(_names(cycle)) - 1],
        sought(cycle.mech, cycle.loads, bodies),
    )
    return np.broadcast_to(acts[index].power(bodies), phi.shape)


def _codes(cycle: Cycle, phi: Reals) -> Codes:
    """Cause, and the sign of every load's power, as one number; where there is no equilibrium the cause alone."""
    statics, count = sample(cycle.mech, cycle.loads, phi).statics, len(_names(cycle))
    powers = np.array([np.broadcast_to(p, phi.shape) for p in (*statics.powers[: count - 1], statics.powers[-1])])
    with np.errstate(invalid="ignore"):
        small = _NOTHING * np.nanmax(np.abs(powers), axis=0, initial=0.0)
        digits = np.where(powers > small, 1, np.where(powers < -small, 2, 0))
    if _rests(cycle):  # what is left of the powers is rounding
        digits[:] = 0
    signs = (digits * 3 ** np.arange(count)[:, None]).sum(axis=0)
    causes = statics.causes.astype(np.int_)
    return np.where(causes != Cause.NONE, causes, _CAUSES * signs)


@lru_cache(maxsize=4)
def _rests(cycle: Cycle) -> bool:
    """Whether no given load does any work, so that there is none for the balancing load either."""
    assert cycle.loads is not None
    phi = _grid(cycle)
    bodies = sample(cycle.mech, None, phi).motion.bodies
    every = [part for one in given(cycle.mech, cycle.loads, bodies, phi) for part in one.parts]
    with np.errstate(invalid="ignore"):
        could = max((float(np.nanmax(one.could(bodies))) for one in every), default=0.0)
        done = max((float(np.nanmax(np.abs(one.power(bodies)))) for one in every), default=0.0)
    return not cycle.loads.friction and done <= _IDLE * could


def _stretches(cycle: Cycle, codes: Callable[[Reals], Codes]) -> Iterator[tuple[float, float, int]]:
    """Runs of equal codes on the grid, each boundary found by cutting its bracket."""
    phi = _grid(cycle)
    code = codes(phi)
    change = np.flatnonzero(code[:-1] != code[1:])
    left, right, first = phi[change], phi[change + 1], code[change]
    for _ in range(ROUNDS if len(change) else 0):
        cuts = left[:, None] + (right - left)[:, None] * np.arange(1, PARTS) / PARTS
        same = codes(cuts.ravel()).reshape(cuts.shape) == first[:, None]
        count = np.argmin(np.append(same, np.zeros((len(left), 1), bool), axis=1), axis=1)
        left, right = left + (right - left) * count / PARTS, left + (right - left) * (count + 1) / PARTS
    inner = (left + right) / 2
    if not cycle.whole:
        edges = [cycle.low, *inner, cycle.high]
        yield from (
            (float(a), float(b), int(code[k]))
            for a, b, k in zip(edges[:-1], edges[1:], [0, *(change + 1)], strict=True)
        )
        return
    full = cycle.period
    keep = inner < phi[0] + full  # the grid goes round and a little on
    inner, change = inner[keep], change[keep]
    if not len(inner):
        yield cycle.low, cycle.high, int(code[0])
        return
    last = float(inner[-1])
    for a, b, k in zip([last - full, *inner[:-1]], inner, change, strict=True):
        yield float(a), float(b), int(code[k])
