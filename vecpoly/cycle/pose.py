"""A problem with its drive at other positions, assembled there as it is on the way from its own position."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from itertools import product

import numpy as np
from numpy.typing import ArrayLike, NDArray

from .. import oracle
from ..errors import VecpolyError
from ..foundation.slotted import replace
from ..mechanism.assembly.branch import margin, opposite
from ..mechanism.assembly.four_bar import fourth_corner
from ..mechanism.assembly.start import Start
from ..mechanism.assembly.statements import Form
from ..mechanism.groups.assur import decompose, ends
from ..mechanism.model import Mechanism, Prismatic, Revolute, Shaped, Side, SideOf, Statement
from ..names import At
from ..oracle import placed as placed
from ..problem.problem import Problem
from .sample import travel

SAME = 1e-9  # of the mechanism's size: as far apart as two solutions of one assembly may be
NEAR = 1e-5  # of that size: farther apart they are two assemblies; near a limit position rounding alone makes 1e-7
_SIDES = (Side.LEFT, Side.RIGHT, Side.ABOVE, Side.BELOW)
Places = Mapping[str, complex]


def posed(problem: Problem, positions: ArrayLike) -> Iterator[Problem | None]:
    """The problem with its drive at each of these positions (rad, or m of travel);
    None where it cannot be assembled, or no statement tells how."""
    mech, where = problem.mechanism, np.atleast_1d(np.asarray(positions, dtype=np.float64))
    for position, (at, starts) in zip(where, _followed(mech, where), strict=True):
        own = mech if position == mech.drive.position else replace(mech, starts=starts)
        there = _assembled(own, float(position), at)
        if there is None:
            yield None
        else:
            yield replace(problem, subject=there, loads=problem.loads and problem.loads.at(there))


def _followed(mech: Mechanism, positions: NDArray[np.float64]) -> Iterator[tuple[Places, tuple[Start, ...]]]:
    """Where every letter is at each position (m), and how gears and racks stand there; NaN where it cannot be."""
    motion = oracle.solve(mech, positions, order=0, strict=False)
    letters = [letter for link in mech.links for letter in link.points]
    at = {letter: np.broadcast_to(motion.position(At(letter)), positions.shape) for letter in letters}
    stands = [(one, _gone(motion, one.link) if one.slide else motion.angle(one.link)) for one in mech.starts]
    for i in range(len(positions)):
        starts = (Start(link=one.link, value=float(values[i]), slide=one.slide) for one, values in stands)
        yield {letter: complex(values[i]) for letter, values in at.items()} | dict(mech.frame), tuple(starts)


def _gone(motion: oracle.Motion, link: str) -> NDArray[np.float64]:
    """How far along its guide from the guide's origin the pin of a link's slide is (m)."""
    joint = next(one for one in motion.mech.joints if isinstance(one, Prismatic) and link in ends(one))
    return travel(motion, joint, joint.origin)


def _assembled(mech: Mechanism, position: float, at: Places) -> Mechanism | None:
    """The mechanism with its drive there and statements that put the letters at these places:
    its own as long as they do."""
    if not np.isfinite(list(at.values())).all():
        return None
    moved = replace(
        mech,
        drives=(replace(mech.drive, position=position), *mech.drives[1:]),
        guesses={letter: at[letter] for letter in mech.guesses},
    )
    best, least = None, np.inf
    for branches in _statements(mech, at):
        there = replace(moved, branches=branches)
        if (gap := _gap(there, at)) < least:
            best, least = there, gap
        if least < SAME * mech.scale:
            break
    return best if least < NEAR * mech.scale else None


def _gap(mech: Mechanism, at: Places) -> float:
    """How far the letters come to lie from these places by the statements (m);
    infinite where these lead to no assembly."""
    try:
        motion = oracle.solve(mech, order=0)
    except VecpolyError:
        return np.inf
    return max(abs(complex(motion.position(At(letter))) - place) for letter, place in at.items())


def _statements(mech: Mechanism, at: Places) -> Iterator[tuple[Statement, ...]]:
    """The mechanism's own statements; those turned round that no longer hold;
    new ones for every group, a single hinge read in two ways."""
    yield mech.branches
    yield tuple(s if margin(s, at) >= 0 else opposite(s) for s in mech.branches)
    yield tuple(_fresh(mech, at, False))
    yield tuple(_fresh(mech, at, True))


def _fresh(mech: Mechanism, at: Places, turned: bool) -> Iterator[Statement]:
    """For each group, on which side of its outer hinges (or of the only one) its inner hinge lies here;
    of a swinging guide some point of it."""
    known = set(mech.frame) | set(mech.link(mech.drive.link).points)
    for group in decompose(mech):
        pins = [joint.point for joint in group.inner if isinstance(joint, Revolute)]
        outer = tuple(out.joint.point for out in group.outer if isinstance(out.joint, Revolute))
        own = {point for name in group.links for point in mech.link(name).points} - known
        if group.dyad is not None and (corner := fourth_corner(mech, group.dyad)) is not None:
            yield from _figure(at, (corner, outer[0], pins[0], outer[1]), mech.scale)
            continue
        for pin in pins or sorted(own, key=lambda letter: -_aside(at, letter, outer))[:1]:
            refs = [outer] if len(outer) == 2 else [(letter,) for letter in outer]
            sides = _SIDES[:2] if len(outer) == 2 and pins else _by_reach(at, pin, outer, turned)
            refs = refs if pins else [(letter,) for letter in outer[:1]]
            yield from [
                s
                for s in (SideOf(point=pin, side=side, ref=ref) for ref, side in product(refs, sides))
                if margin(s, at) > 0
            ][:1]
        known |= own


def _figure(at: Places, corners: tuple[str, str, str, str], scale: float) -> Iterator[Statement]:
    """Parallelogram or antiparallelogram, where it can be told: at a change point it is taken for the former."""
    parallel = Shaped(corners=corners, form=Form.PARALLELOGRAM)
    yield parallel if margin(parallel, at) > -NEAR * scale else Shaped(corners=corners, form=Form.ANTIPARALLELOGRAM)


def _aside(at: Places, letter: str, outer: tuple[str, ...]) -> float:
    """How far a point lies from the pin about which it swings."""
    return abs(at[letter] - at[outer[0]]) if outer else 0.0


def _by_reach(at: Places, pin: str, outer: tuple[str, ...], turned: bool) -> tuple[Side, ...]:
    """Sides of a single hinge, those in the direction in which the pin is farther away first (turned: last)."""
    ray = at[pin] - at[outer[0]] if outer else 0j
    return _SIDES if (abs(ray.real) >= abs(ray.imag)) != turned else (*_SIDES[2:], *_SIDES[:2])
