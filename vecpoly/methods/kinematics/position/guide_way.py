"""Which way a swinging guide points: as the branch statements say, else so that the block lies ahead of the letter of
the guide's line, else as the rough places say."""

from __future__ import annotations

import numpy as np

from ....errors import AssemblyError
from ....mechanism.assembly.branch import margin, nearer
from ....mechanism.model import Prismatic, Statement
from ....plane import Points, nominal
from ....words import Words
from ...desk import Desk
from .assembly import HAIR, in_metres

Places = dict[str, complex]


def choose_way(
    desk: Desk, joint: Prismatic, q: str, p: str, ways: tuple[Points, Points]
) -> tuple[Points, Statement | None]:
    """Of two directions of the guide pinned at Q, whose block is pinned at P,
    the one that is meant, and the statement that decided; on paper for another position the one that is carried on.

    Raises AssemblyError where neither fulfils the statements, or nothing tells them apart.
    """
    sides = [complex(nominal(way)) for way in ways]
    trials = [_with_way(desk, joint, q, p, way) for way in sides]
    near, key = nearer(*in_metres(desk, trials), 1e-6 * desk.mech.scale), (joint.guide, joint.block)
    if desk.sides.is_kept and (carried := desk.sides.carry(key, near)) is not None:
        return ways[carried], None
    chosen, deciding = _meant(desk, joint, (q, p), (sides, trials), near)
    return ways[desk.sides.take(key, chosen)], deciding


def _meant(
    desk: Desk, joint: Prismatic, pins: tuple[str, str], ways: tuple[list[complex], list[Places]], near: int | None
) -> tuple[int, Statement | None]:
    """By the statements, else ahead of the letter, else near the rough places."""
    sides, trials = ways
    new = set(trials[0]) - set(desk.at)
    told = [s for s in desk.mech.branches if set(s.letters) <= set(trials[0]) and set(s.letters) & new]
    holds = [[margin(s, trial) > 1e-2 * HAIR * desk.mm(desk.mech.scale) for s in told] for trial in trials]
    fits = [all(held) for held in holds]
    if not any(fits):
        raise _refused(
            joint,
            "no-branch-fits",
            Words("分支说明均不满足", "neither of its directions fulfils the branch statements"),
        )
    if fits[0] != fits[1]:
        return fits.index(True), next(s for s, a, b in zip(told, *holds, strict=True) if a != b)
    ahead = [_travel(desk, joint, *pins, way) > 0 for way in sides]
    if ahead[0] == ahead[1]:
        if near is not None:
            return near, None
        raise _refused(
            joint,
            "branch-missing",
            Words("两个方向都可装配，须以分支说明", "it can point either way, and no branch statement says which"),
        )
    return ahead.index(True), None


def _refused(joint: Prismatic, code: str, why: Words) -> AssemblyError:
    example = f"'{joint.pin} left of ...'"
    return AssemblyError(
        Words(
            f"构件 {joint.guide} 的导路（其上滑块 {joint.block}）：",
            f"the guide of link {joint.guide}, on which link {joint.block} slides: ",
        )
        + why
        + Words(
            f"；请在 branch 中写出该组某点在哪一侧，如 {example}，或以 guesses 给出其大致位置",
            "; say in 'branch' on which side a point of these two links lies, such as "
            f"{example}, or give its rough place as guesses",
        ),
        code=code,
    )


def _with_way(desk: Desk, joint: Prismatic, q: str, p: str, way: complex) -> Places:
    """Every letter that would be known if the guide pointed so."""
    places = {name: complex(nominal(at)) for name, at in desk.at.items()}
    for link, held, axis in _poses(joint, q, p, way):
        points = desk.mech.link(link).points
        places |= {
            name: places[held] + axis * desk.mm(1.0) * (local - points[held])
            for name, local in points.items()
            if name not in desk.at
        }
    return places


def _travel(desk: Desk, joint: Prismatic, q: str, p: str, way: complex) -> float:
    """How far (mm) the sliding pin lies ahead of the letter from which the guide's line is set out;
    else of the guide's pivot."""
    guide, block = (desk.mech.link(link).points for link in (joint.guide, joint.block))
    (_, _, turned), (_, _, axis) = _poses(joint, q, p, way)
    start = joint.origin - guide[q] if joint.through else 0j
    pin = block[joint.pin] - block[p] if joint.through else 0j
    ray = complex(nominal(desk.at[p] - desk.at[q])) + desk.mm(1.0) * (axis * pin - turned * start)
    return float((np.conj(way) * ray).real)


def _poses(joint: Prismatic, q: str, p: str, way: complex) -> tuple[tuple[str, str, complex], tuple[str, str, complex]]:
    """Guide and block: the pin that is placed, and the direction of the x axis."""
    return (
        (joint.guide, q, complex(way * np.exp(-1j * joint.direction))),
        (joint.block, p, complex(way * np.exp(1j * joint.turn))),
    )
