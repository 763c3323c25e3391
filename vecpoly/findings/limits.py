"""Why a driven link turns back where it does: what stands in one line, or at right angles, at its limit positions."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ..cycle.sample import sample
from ..mechanism.groups.assur import Dyad, decompose, hinges
from ..mechanism.model import FRAME, Prismatic, Revolute
from ..words import Words
from .study.study import Study

_SMALL = 1e-5  # of a velocity's size


@dataclass(frozen=True, slots=True)
class Limit:
    """What is seen at a limit; kind: folded, stretched (crank and coupler in one line), still, square."""

    kind: str
    words: Words


def limit(study: Study, key: str, phi: float) -> Limit | None:
    """The reason of a limit of φ or s (its key) with the drive at phi; None where no simple one holds."""
    dyad = _dyad(study, key)
    if dyad is None:
        return None
    near, far = (dyad.outer_j, dyad.parent_j), (dyad.outer_k, dyad.parent_k)
    if FRAME not in (near[1], far[1]):
        return None
    joint, parent = near if near[1] != FRAME else far
    if not isinstance(joint, Revolute):
        return None
    here = sample(study.mech, None, np.array([phi]))
    p, v = complex(here.value(f"p_{joint.point}")[0]), complex(here.value(f"v_{joint.point}")[0])
    fastest = float(np.nanmax(np.abs(study.whole.on_grid(f"v_{joint.point}")[1])))
    if abs(v) < _SMALL * fastest:
        return Limit("still", Words(f"${joint.point}$ 点速度为零", f"$v_{{{joint.point}}}$ = 0"))
    if isinstance(dyad.inner, Revolute):
        c = complex(here.value(f"p_{dyad.inner.point}")[0])
        return _coupler(study, parent, (joint.point, p), (dyad.inner.point, c), v)
    if not isinstance(dyad.inner, Prismatic):
        return None
    line = complex(here.motion.bodies[dyad.inner.guide].unit[0] * np.exp(1j * dyad.inner.direction))
    return _guide(study, (parent, joint.point), v, dyad.inner.guide, line)


def _dyad(study: Study, key: str) -> Dyad | None:
    """The group in which the link on the frame is solved."""
    stem, _, rest = key.partition("_")
    for dyad in (group.dyad for group in decompose(study.mech) if group.dyad is not None):
        own = [name for name, parent in ((dyad.link_j, dyad.parent_j), (dyad.link_k, dyad.parent_k)) if parent == FRAME]
        names = [study.mech.number(name) for name in own]
        frame = study.mech.frame_number
        if any(rest == name if stem == "phi" else rest in (name + frame, frame + name) for name in (*own, *names)):
            return dyad
    return None


def _coupler(
    study: Study, parent: str, start: tuple[str, complex], end: tuple[str, complex], v: complex
) -> Limit | None:
    """The coupler's first pin moves at right angles to the coupler;
    on a link about a fixed pivot both are in one line."""
    (p, at), (c, to) = start, end
    along = (to - at) / abs(to - at)
    if abs((v * along.conjugate()).real) > _SMALL * abs(v):
        return None
    pivot = _pivot(study, parent)
    if not pivot:
        return Limit("square", Words(f"$v_{{{p}}}$ ⊥ ${p}{c}$", f"$v_{{{p}}}$ ⊥ ${p}{c}$"))
    away, span = at - study.mech.frame[pivot], 1e3 * abs(to - study.mech.frame[pivot])
    stretched = (away * along.conjugate()).real > 0
    crank, rod = f"$l_{{{_letters(pivot, p)}}}$", f"$l_{{{_letters(p, c)}}}$"
    longer, other = (rod, crank) if abs(to - at) > abs(away) else (crank, rod)
    sum_ = f"${pivot}{c}$ = " + (f"{crank} + {rod}" if stretched else f"{longer} − {other}")
    kind = Words("拉直共线", "stretched in one line") if stretched else Words("重叠共线", "folded into one line")
    return Limit(
        "stretched" if stretched else "folded",
        Words(
            f"${pivot}{p}$ 与 ${p}{c}$ {kind.zh}，{sum_} = {span:.4g} mm",
            f"${pivot}{p}$ and ${p}{c}$ are {kind.en}, {sum_} = {span:.4g} mm",
        ),
    )


def _guide(study: Study, pin: tuple[str, str], v: complex, bar: str, line: complex) -> Limit | None:
    """The block's pin (its link, its letter) moves along the guide, which a link of the group carries: there are others
    in the mechanism."""
    parent, p = pin
    guide = Words(f"构件 {study.mech.number(bar)} 的导路", f"the slideway of link {study.mech.number(bar)}")
    if abs((v * line.conjugate()).imag) > _SMALL * abs(v):
        return None
    pivot = _pivot(study, parent)
    if pivot:
        return Limit("square", Words(f"${pivot}{p}$ 垂直于", f"${pivot}{p}$ is at right angles to ") + guide)
    return Limit("square", Words(f"$v_{{{p}}}$ 沿", f"$v_{{{p}}}$ is along ") + guide)


def _pivot(study: Study, link: str) -> str:
    """The fixed pivot about which a link turns."""
    return next((letter for letter, names in hinges(study.mech).items() if FRAME in names and link in names), "")


def _letters(one: str, two: str) -> str:
    return "".join(sorted((one, two)))
