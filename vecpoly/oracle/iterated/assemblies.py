"""Which assembly of a group that is solved by iteration:
the one that the branch statements and the guesses describe."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np
from numpy.typing import NDArray

from ...errors import BranchError
from ...mechanism.assembly.branch import margin
from ...mechanism.assembly.told import as_guesses, which
from ...mechanism.groups.assur import Group
from ...mechanism.model import Mechanism
from ...words import Words
from ..state import Body, Reals

States = NDArray[np.float64]  # positions × links × (x, y, φ)
Places = dict[str, complex]
SAME = 1e-6  # of the mechanism's size, and rad: assemblies nearer than this are one


def chosen(mech: Mechanism, group: Group, found: States, known: Mapping[str, Body]) -> States:
    """One of the states found: it fulfils the statements and lies nearest to the guesses; NaN where none was found.

    Raises BranchError where several are left and no guess tells them apart.
    """
    before = _places(mech, known)
    after = {k: before | placed(mech, group, found[k]) for k in _distinct(mech, found)}
    told = [s for s in mech.branches if _letters(after) >= set(s.letters) and not set(before) >= set(s.letters)]
    fits = [k for k, at in after.items() if all(margin(s, at) > 1e-9 * mech.scale for s in told)]
    if not fits:
        return np.asarray(found[next(iter(after), 0)])
    if not is_guessed(mech, group) and len(fits) > 1:
        raise BranchError(
            _which(mech, group, [after[k] for k in fits]), code="which-assembly", numbers={"assemblies": len(fits)}
        )
    off = distances(mech, group, found)
    return np.asarray(found[min(fits, key=lambda k: float(off[k]))])


def is_guessed(mech: Mechanism, group: Group) -> bool:
    """Whether a guess says anything of this group."""
    return any(p in mech.guesses for name in group.links for p in mech.link(name).points)


def placed(mech: Mechanism, group: Group, state: NDArray[np.float64]) -> Places:
    """Where the group's letters are in this state (m)."""
    at: Places = {}
    for name, (x, y, phi) in zip(group.links, state, strict=True):
        at |= {p: complex(x, y) + complex(np.exp(1j * phi)) * local for p, local in mech.link(name).points.items()}
    return at


def distances(mech: Mechanism, group: Group, found: States) -> Reals:
    """How far the points lie from those guessed (sum of distances, m)."""
    letters = {p for name in group.links for p in mech.link(name).points} & set(mech.guesses)
    return np.array(
        [sum(abs(at[p] - mech.guesses[p]) for p in letters) for at in (placed(mech, group, state) for state in found)],
        dtype=np.float64,
    )


def _places(mech: Mechanism, bodies: Mapping[str, Body]) -> Places:
    return {
        p: complex(body.point(local)[-1])
        for name, body in bodies.items()
        for p, local in mech.link(name).points.items()
    }


def _letters(after: Mapping[int, Places]) -> set[str]:
    return set(next(iter(after.values()), {}))


def _distinct(mech: Mechanism, found: States) -> list[int]:
    """Every assembly once."""
    kept: list[int] = []
    at, unit, near = found[:, :, :2], np.exp(1j * found[:, :, 2]), SAME * max(mech.scale, 1e-12)
    for k in np.flatnonzero(np.isfinite(found).all(axis=(1, 2))):
        shifted, turned = np.abs(at[kept] - at[k]).max(axis=(1, 2)), np.abs(unit[kept] - unit[k]).max(axis=1)
        if (np.maximum(shifted, turned) > near).all():
            kept.append(int(k))
    return kept


def _which(mech: Mechanism, group: Group, fits: list[Places]) -> Words:
    """The assemblies there are, by two points of the link that has most of them."""
    points = max((tuple(mech.link(name).points) for name in group.links), key=len)[:2]
    return which(group.told, len(fits), as_guesses(fits, points, 1e3))
