"""A found by trial: γ_min of the linkage with its A here or there, on scratch paper, until it is as wanted."""

from __future__ import annotations

from collections.abc import Iterator

from ....designs.crank_rocker import CrankRocker
from ....plane import Points
from ....words import Words
from ..draft import SHEET, Draft
from ..eta import Locus
from .refine import meetings, summit
from .rocker import Rocker
from .track import Track


def by_trial(draft: Draft, design: CrankRocker, rocker: Rocker, locus: Locus) -> Iterator[Points]:
    """Every A with the given γ_min; or the one with the greatest."""
    best = design.best is not None
    draft.board.step(
        Words(
            "在此轨迹上依次取 $A$，作出各机构曲柄与机架共线的两位置，量得 $γ_min$ 随 $A$ 的变化，"
            + ("取 $γ_min$ 最大的一点为 $A$。" if best else "取 $γ_min$ 等于给定值的点为 $A$。"),
            "Take $A$ here and there on this locus, draw each linkage with its crank on the line of the frame and read "
            + (
                "how $γ_min$ changes; $A$ is where it is greatest."
                if best
                else "how $γ_min$ changes; $A$ is where it is as given."
            ),
        ),
        SHEET,
    )
    track = Track(rocker, locus)
    found = summit(track) if design.gamma_min is None else meetings(track, design.gamma_min.si)
    for t in found:
        yield track.on_sheet(draft, t)
