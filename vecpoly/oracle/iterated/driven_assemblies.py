"""Which assembly of a group with a drive inside:
of all there are, the one that the statements, or else the guesses, describe."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import combinations, product

import numpy as np
from numpy.typing import NDArray

from ...errors import AssemblyError
from ...foundation.slotted import replace
from ...mechanism.assembly.branch import margin, opposite
from ...mechanism.model import Mechanism, Side, SideOf
from ...words import Words
from ..run import Run
from ..state import Bodies
from .newton import Newton

Places = dict[str, complex]
States = list[NDArray[np.float64]]


def among(mech: Mechanism, step: Newton, bodies: Bodies, run: Run) -> Newton:
    """The step that starts from the assembly meant; AssemblyError where none, or more than one, is described."""
    own = run.track.own if run.track else 0
    here = {name: body.take(np.array([own])) for name, body in step.known(bodies, run.track, run.q).items()}
    before = {
        p: complex(body.point(local)[0])
        for name, body in here.items()
        if not name.startswith("drive")
        for p, local in mech.link(name).points.items()
    }
    found = list(step.assemblies(here))
    fits = [state for state in found if _fulfils(mech, step, before, state)]
    if len(fits) > 1 and any(p in mech.guesses for name in step.group.links for p in mech.link(name).points):
        fits = [min(fits, key=lambda state: _off(mech, step, state))]
    if len(fits) != 1:
        raise _undecided(mech, step, before, (found, fits), run.text(float(run.q[own])))
    chosen = replace(step)  # with no state found yet
    chosen.begin(fits[0])
    return chosen


def _places(mech: Mechanism, step: Newton, state: NDArray[np.float64]) -> Places:
    return {
        p: complex(pose[0], pose[1]) + complex(np.exp(1j * pose[2])) * local
        for name, pose in zip(step.group.links, state, strict=True)
        for p, local in mech.link(name).points.items()
    }


def _fulfils(mech: Mechanism, step: Newton, before: Places, state: NDArray[np.float64]) -> bool:
    """Whether every statement about the group's points, and what is known already, holds."""
    at = before | _places(mech, step, state)
    told = [s for s in mech.branches if set(s.letters) <= set(at) and not set(s.letters) <= set(before)]
    return all(margin(s, at) > 1e-9 * mech.scale for s in told)


def _off(mech: Mechanism, step: Newton, state: NDArray[np.float64]) -> float:
    """How far the points lie from those guessed (sum of distances, m)."""
    return sum(abs(at - mech.guesses[p]) for p, at in _places(mech, step, state).items() if p in mech.guesses)


def _undecided(mech: Mechanism, step: Newton, before: Places, ways: tuple[States, States], where: str) -> AssemblyError:
    """ways: all assemblies, and those that fulfil the statements."""
    (found, fits), zh, links = ways, step.group.told.zh, step.group.told.en
    if not found:
        return AssemblyError(
            Words(
                f"驱动位置为 {where} 时构件 {zh} 无法装配；请改变驱动位置或尺寸",
                f"links {links} cannot be joined where the drive stands at {where}; change its position, or the "
                "lengths",
            ),
            code="no-assembly",
        )
    if not fits:
        return AssemblyError(
            Words(
                f"驱动位置为 {where} 时，构件 {zh} 的 {len(found)} 种装配方式都不符合 branch 中的说明",
                f"links {links}: none of their {len(found)} assemblies fulfils the branch statements where the "
                f"drive stands at {where}",
            ),
            code="no-branch",
        )
    advice = _advice(mech, step, before, fits)
    return AssemblyError(
        Words(
            f"构件 {zh} 有 {len(found)} 种装配方式，其中 {len(fits)} 种符合说明；{advice.zh}",
            f"links {links} can be assembled in {len(found)} ways, of which {len(fits)} "
            f"fulfil what is said; {advice.en}",
        ),
        code="undecided-assembly",
    )


def _advice(mech: Mechanism, step: Newton, before: Places, fits: States) -> Words:
    """A sentence for `branch` that tells the first of these assemblies from most others, if there is one; guesses."""
    at = [before | _places(mech, step, state) for state in fits]
    points = [p for p in at[0] if p not in before]
    for statement in _statements(points, before, at, 1e-9 * mech.scale):
        margins = [margin(statement, places) for places in at]
        if min(map(abs, margins)) > 1e-6 * mech.scale and len({one > 0 for one in margins}) == 2:
            told = statement if margins[0] > 0 else opposite(statement)
            return Words(
                f"请在 branch 中写明，例如 '{told}'，或以 guesses 给出各点的大致位置",
                f"say in 'branch' which, e.g. '{told}', or give rough places as guesses",
            )
    rough = f"guesses: {{{points[0]}: [x mm, y mm]}}"
    return Words(f"请给出各点的大致位置，例如 {rough}", f"give rough places of its points, e.g. {rough}")


def _statements(points: list[str], before: Places, at: list[Places], apart: float) -> Iterator[SideOf]:
    """Sentences about these points beside known ones, and beside each other."""
    pairs = sorted(combinations(sorted(at[0]), 2), key=lambda pair: len({*pair} - {*before}))
    refs = [pair for pair in pairs if min(abs(places[pair[0]] - places[pair[1]]) for places in at) > apart]
    known = [pair for pair in refs if {*pair} <= {*before}]
    yield from (SideOf(point=point, side=Side.LEFT, ref=pair) for pair, point in product(known, points))
    for ref, point, side in product(before, points, (Side.LEFT, Side.ABOVE)):
        yield SideOf(point=point, side=side, ref=(ref,))
    yield from (
        SideOf(point=point, side=Side.LEFT, ref=pair)
        for pair, point in product(refs[len(known) :], points)
        if point not in pair
    )
