"""The problem at other positions of its drive, assembled as it is on the way there."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from itertools import product

import numpy as np

from ...board.construction import View
from ...cycle.sample import sample
from ...errors import VecpolyError
from ...mechanism.assur import decompose
from ...mechanism.branch import margin
from ...mechanism.loads import Loads
from ...mechanism.model import Mechanism, Revolute, Side, SideOf
from ...names import At
from ...problem.problem import Problem, Scales
from .study import Study

_SIDES = (Side.LEFT, Side.RIGHT, Side.ABOVE, Side.BELOW)


def at_position(study: Study, phi: float, *, same_scale: bool = True) -> Problem:
    """The problem with its drive at phi (rad, or m), the diagram to the given position's scale or to its own. Raises AssemblyError where no statement tells the assembly."""
    mech, drives = study.mech, (replace(study.mech.drive, position=phi), *study.mech.drives[1:])
    wanted = _places(mech, phi)
    moved = replace(mech, drives=drives)
    for turned in (False, True):
        if not _same(moved, wanted):
            moved = replace(moved, branches=tuple(_statements(mech, wanted, turned)))
    figure = study.solution.construction.figure(View.MECHANISM)
    return replace(study.problem, subject=moved, loads=_without_roles(study.problem.loads), scales=Scales(mu_l=figure.scale.value if figure and same_scale else None), printed=())


def _without_roles(loads: Loads | None) -> Loads | None:
    """The loads, none called driving or resisting: over a cycle a load may be both in turn."""
    if loads is None:
        return None
    return replace(loads, forces=tuple(replace(f, role="") for f in loads.forces), moments=tuple(replace(m, role="") for m in loads.moments))


def _places(mech: Mechanism, phi: float) -> dict[str, complex]:
    """Where every letter is on the way from the given position."""
    motion = sample(mech, None, np.array([phi])).motion
    return {letter: complex(motion.position(At(letter))[0]) for link in mech.links for letter in link.points} | dict(mech.frame)


def _same(moved: Mechanism, wanted: dict[str, complex]) -> bool:
    """Whether the statements as they stand give this assembly here."""
    try:
        found = _places(moved, moved.drive.position)
    except VecpolyError:
        return False
    return all(abs(found[letter] - place) < 1e-9 * moved.scale for letter, place in wanted.items())


def _statements(mech: Mechanism, at: dict[str, complex], turned: bool) -> Iterator[SideOf]:
    """For each group, on which side of its outer hinges (or of the only one) its inner hinge lies here."""
    for group in decompose(mech):
        pins = [joint.point for joint in group.inner if isinstance(joint, Revolute)]
        outer = [out.joint.point for out in group.outer if isinstance(out.joint, Revolute)]
        for pin in pins:
            refs = [tuple(outer)] if len(outer) == 2 else [(letter,) for letter in outer]
            for ref, side in product(refs, _SIDES[:2] if len(outer) == 2 else _by_reach(at, pin, outer, turned)):
                if margin(SideOf(point=pin, side=side, ref=ref), at) > 0:
                    yield SideOf(point=pin, side=side, ref=ref)
                    break


def _by_reach(at: dict[str, complex], pin: str, outer: list[str], turned: bool) -> tuple[Side, ...]:
    """Sides of a single hinge, those in the direction in which the pin is farther away first (turned: last)."""
    ray = at[pin] - at[outer[0]] if outer else 0j
    return _SIDES if (abs(ray.real) >= abs(ray.imag)) != turned else (*_SIDES[2:], *_SIDES[:2])
