"""A coupler point as far from the moving hinge as the coupler's and the rocker's other ends: its curve has an axis
(Roberts), and its rates come in pairs."""

from __future__ import annotations

import cmath
from collections.abc import Iterator

import numpy as np

from ..mechanism.groups.assur import Dyad, decompose, pivot_of
from ..mechanism.model import FRAME, Revolute
from ..words import Words
from .study.study import Study

_EQUAL = 1e-6  # of a length


def symmetry(study: Study) -> Iterator[Words]:
    """Of every point E shown with BC = CD = CE: E's curve is symmetrical about a line through D;
    equal speeds at equal angles from B, A, D in line."""
    if not study.whole.whole or study.mech.drive.accel:
        return
    for dyad in (group.dyad for group in decompose(study.mech) if group.dyad is not None and group.kind == "RRR"):
        yield from _one(study, dyad)


def _one(study: Study, d: Dyad) -> Iterator[Words]:
    assert isinstance(d.outer_j, Revolute) and isinstance(d.inner, Revolute) and isinstance(d.outer_k, Revolute)
    ends = ((d.outer_j.point, d.link_j, d.parent_j), (d.outer_k.point, d.link_k, d.parent_k))
    (fixed, rocker, ground), (moving, coupler, crank) = ends if d.parent_j == FRAME else ends[::-1]
    pivot, c, mech = pivot_of(study.mech, crank), d.inner.point, study.mech
    if ground != FRAME or not pivot or crank != mech.drive.link:
        return
    points, size = mech.link(coupler).points, abs(mech.link(coupler).points[c] - mech.link(coupler).points[moving])
    other = abs(mech.link(rocker).points[c] - mech.link(rocker).points[fixed])
    for e in (e for e in study.points if e in points and e not in (c, moving)):
        if max(abs(other - size), abs(abs(points[e] - points[c]) - size)) > _EQUAL * size:
            continue
        line = cmath.phase(
            (mech.frame[fixed] - mech.frame[pivot]) / (mech.link(crank).points[moving] - mech.link(crank).points[pivot])
        )
        if not _mirrored(study, e, line):
            continue
        bars = " = ".join(f"$l_{{{''.join(sorted(pair))}}}$" for pair in ((moving, c), (c, fixed), (c, e)))
        at = study.where(line)
        yield Words(
            f"{bars}，故 ${e}$ 点的轨迹关于过 ${fixed}$ 的一条直线对称；曲柄从 ${pivot}{moving}$ 与 "
            f"${pivot}{fixed}$ 重合的位置（{at}）向两侧转过相同角度时，$|v_{{{e}}}|$、$|a_{{{e}}}|$ 分别相等，"
            "故其最大值各出现在两个对称位置。",
            f"As {bars}, the curve of ${e}$ is symmetrical about a line through ${fixed}$. At equal "
            f"angles of the crank on either side of the position in which ${pivot}{moving}$ lies "
            f"along ${pivot}{fixed}$ ({at}) $|v_{{{e}}}|$ is the same, and so is $|a_{{{e}}}|$: "
            "their largest values occur in two symmetrical positions.",
        )


def _mirrored(study: Study, point: str, line: float) -> bool:
    """Whether it is so, at some angles to either side."""
    away = np.linspace(0.2, 3.0, 8)
    for key in (f"v_{point}", f"a_{point}"):
        after, before = (np.abs(study.whole.at(key, line + sign * away)) for sign in (1.0, -1.0))
        if not np.allclose(after, before, rtol=1e-9):
            return False
    return True
