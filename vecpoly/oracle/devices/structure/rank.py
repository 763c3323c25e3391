"""Degree of freedom by rank: F = 3n − rank J − idle turns, in the given position and in one a little further on.

A constraint that is redundant only in the given position (a singular one: dead point, stretched links) becomes
independent when the chain has moved; one that is redundant by its sizes stays so.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ....devices.structure_pairs import FRAME, Chain, Form
from ....foundation.slotted import replace
from .rows import Floats, Rows

# share of the largest singular value below which one counts as zero; places are written to about 1e-6 of the size
RANK = 2e-5
DRIVES = 2e-6  # the same where a driver is held fast: one that hardly moves the others still says how they move
LOOSE = 1e-3  # share of a dependence below which a constraint has no part in it: rounding of what is written
CLOSED = 2e-5  # by how much constraints may be broken in the second position, in sizes: rounding of what is written
STEP, TRIES, ROUNDS = 0.06, 4, 30  # first move along the motion, in rad or sizes; directions tried; Newton rounds


@dataclass(frozen=True, slots=True, kw_only=True)
class Ranks:
    """Of a chain: coordinates, constraints, rank here and further on (the same where it does not move), and idle links.

    twice: constraints that a pair repeats of another pair between the same two links.
    """

    coordinates: int
    constraints: int
    here: int
    onward: int
    moved: bool
    idle: tuple[str, ...]
    twice: int

    @property
    def freedom(self) -> int:
        """F = 3n − rank − F′ of a chain that moves.

        One that cannot (what the rank leaves is a play of the second order) is a truss: its surplus of constraints
        makes F negative, and of these only such count as redundant as two links have twice.
        """
        if self.moved:
            return self.coordinates - self.onward - len(self.idle)
        return min(self.coordinates - self.constraints + self.twice - len(self.idle), 0)

    @property
    def redundant(self) -> int:
        """p′: constraints beyond those that take freedoms."""
        return self.freedom + len(self.idle) - self.coordinates + self.constraints

    @property
    def singular(self) -> bool:
        """Whether the given position is a special one."""
        return self.here < self.onward


def ranks(chain: Chain) -> Ranks:
    """Rank of the constraints here and in a second position."""
    here = Rows(chain, _size(chain), np.zeros(3 * len(chain.links)))
    jac = here.jacobian()
    first = rank(jac)
    positions = [rows for seed in range(TRIES) if (rows := _onward(here, seed)) is not None]
    onward = max((rank(rows.jacobian()) for rows in positions), default=first)
    return Ranks(
        coordinates=jac.shape[1],
        constraints=jac.shape[0],
        here=first,
        onward=max(first, onward),
        moved=bool(positions),
        idle=_idle(chain, [jac, *(rows.jacobian() for rows in positions)]),
        twice=_twice(chain),
    )


def rank(jac: Floats, share: float = RANK) -> int:
    """How many constraints are independent."""
    if not jac.size:
        return 0
    values = np.linalg.svd(jac, compute_uv=False)
    return int((values > share * max(float(values[0]), 1e-300)).sum())


def determined(chain: Chain, drivers: tuple[str, ...]) -> bool:
    """Whether the chain moves, and its drivers alone say how: holding them fast leaves only idle turns."""
    found = ranks(chain)
    if found.freedom < 1 or found.freedom != len(drivers):
        return False
    here = Rows(chain, _size(chain), np.zeros(3 * len(chain.links)))
    positions = [here, *(rows for seed in range(TRIES) if (rows := _onward(here, seed)) is not None)]
    return max(
        rank(np.vstack([rows.jacobian(), *(_held(rows, link) for link in drivers)]), DRIVES) for rows in positions
    ) == found.coordinates - len(found.idle)


def _held(rows: Rows, link: str) -> Floats:
    """The driver's own coordinate: its turn, or its travel where it slides on the frame."""
    slide = next((p for p in rows.chain.at(link) if p.form is Form.P and FRAME in p.links), None)
    row, i = np.zeros(len(rows.pose)), rows.column(link)
    if slide is None:
        row[i + 2] = 1.0
    else:
        row[i : i + 2] = slide.along.real, slide.along.imag
    return row


def _size(chain: Chain) -> float:
    places = [pair.at for pair in chain.pairs]
    return max((abs(p - q) for p in places for q in places), default=0.0) or 1.0


def _onward(rows: Rows, seed: int) -> Rows | None:
    """The chain moved a little along its motion and closed again; None where it cannot move this way."""
    jac = rows.jacobian()
    free = np.linalg.svd(jac)[2][rank(jac) :] if jac.size else np.eye(len(rows.pose))
    if not len(free):
        return None
    way = np.random.default_rng(seed).normal(size=len(free)) @ free
    moved = replace(rows, pose=rows.pose + STEP * way / max(np.abs(way).max(), 1e-12))
    for _ in range(ROUNDS):
        step = np.linalg.lstsq(moved.jacobian(), moved.residual(), rcond=RANK)[0]
        moved = replace(moved, pose=moved.pose - step)
        if np.abs(step).max() < 1e-12:
            break
    closed = np.abs(moved.residual()).max(initial=0.0) < CLOSED
    return moved if closed and np.abs(moved.pose - rows.pose).max() > STEP / 4 else None


def _twice(chain: Chain) -> int:
    """How many constraints pairs between the same two links have in common."""
    surplus = 0
    for links in {frozenset(pair.links) for pair in chain.pairs if len(pair.links) == 2}:
        alone = Chain(
            tuple(link for link in chain.links if link in links),
            tuple(pair for pair in chain.pairs if set(pair.links) == links),
        )
        jac = Rows(alone, _size(chain), np.zeros(3 * len(alone.links))).jacobian()
        surplus += len(jac) - rank(jac)
    return surplus


def dependent(chain: Chain) -> tuple[str, ...]:
    """Letters of the pairs whose constraints depend on each other in every position:
    where the left null space of the Jacobian reaches."""
    here = Rows(chain, _size(chain), np.zeros(3 * len(chain.links)))
    positions = [rows for seed in range(TRIES) if (rows := _onward(here, seed)) is not None] or [here]
    jac = max((rows.jacobian() for rows in positions), key=rank)
    left = np.linalg.svd(jac)[0][:, rank(jac) :]
    owners = [pair.letter for pair in chain.pairs for _ in range((2 if pair.form.is_lower else 1) * pair.count)]
    return tuple(
        dict.fromkeys(letter for letter, row in zip(owners, left, strict=True) if np.abs(row).max(initial=0.0) > LOOSE)
    )


def _idle(chain: Chain, jacobians: list[Floats]) -> tuple[str, ...]:
    """Links with a higher pair that may turn while all else stands still, in every position: rollers."""
    return tuple(
        link
        for i, link in enumerate(chain.links)
        if any(not pair.form.is_lower for pair in chain.at(link))
        and all(rank_of_columns(jac, i) < 3 for jac in jacobians)
    )


def rank_of_columns(jac: Floats, index: int) -> int:
    """Rank of the three columns of one link."""
    return rank(jac[:, 3 * index : 3 * index + 3])
