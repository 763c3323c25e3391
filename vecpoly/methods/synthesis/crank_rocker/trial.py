"""A found by trial: γ_min of the linkage with its A here or there, on scratch paper, until it is as wanted."""

from __future__ import annotations

from collections.abc import Iterator
from math import degrees

from ....designs.crank_rocker import CrankRocker
from ....plane import Points
from ....words import Words
from ..arc_middle import called, primes_of
from ..draft import SHEET, Draft
from ..eta import Locus
from .gamma_curve import gamma_curve
from .refine import meetings, summit
from .rocker import Rocker
from .track import Track


def by_trial(draft: Draft, design: CrankRocker, rocker: Rocker, locus: Locus) -> Iterator[Points]:
    """Every A with the given γ_min; or the one with the greatest."""
    best, board, primes = design.best is not None, draft.board, primes_of(locus)
    board.step(
        Words(
            f"在{called(locus).zh}上依次取 $A$ 的若干位置 1{primes}、2{primes}、3{primes}…。",
            f"Choose trial positions 1{primes}, 2{primes}, 3{primes}, ... of $A$ on {called(locus).en}.",
        ),
        SHEET,
    )
    track = Track(rocker, locus)
    places = list(summit(track) if design.gamma_min is None else meetings(track, design.gamma_min.si))
    curve = gamma_curve(draft, track, places)
    if curve is not None:
        letters = [f"${draft.letter('A', n)}$" for n in range(len(places))] or ["$A$"]
        zh, en = "、".join(letters), " and ".join(letters) + " the point" + "s" * (len(letters) > 1)
        board.step(
            Words(
                f"取曲线上 $γ_{{min}}$ 最大的一点为 {zh}。",
                f"Take as {en} for which the curve has its maximum $γ_{{min}}$.",
            )
            if best
            else Words(
                f"取曲线上 $γ_{{min}}$ 等于给定值的点为 {zh}。",
                f"Take as {en} for which the curve has the given $γ_{{min}}$.",
            ),
            SHEET,
            again=Words(f"在此曲线上同样选取 {zh}。", f"Choose {' and '.join(letters)} on this curve in the same way."),
        )
    if not places and curve is not None:
        _nowhere(draft, best)
    for t in places:
        if curve is not None:
            curve.point(float(track.place(t)), degrees(track.least(t)), draft.letter("A"))
        yield track.on_sheet(draft, t)


def _nowhere(draft: Draft, best: bool) -> None:
    """The curve does not go as far, or has no top."""
    draft.board.remark(
        Words(" 此曲线没有最高点。", " This curve has no highest point.")
        if best
        else Words(" 此曲线达不到给定值，无解。", " This curve does not reach the given value: no solution here.")
    )
