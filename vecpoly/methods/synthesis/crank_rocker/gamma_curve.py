"""γ_min over the place of A: seven A on the locus, each with its linkage, and the curve through what they give."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import groupby
from math import degrees
from operator import itemgetter

import numpy as np

from ....board.paper.marks import Dot
from ....words import Words
from ..arc_middle import primes_of
from ..chart import Axis, Chart, chart
from ..draft import SHEET, Draft
from ..eta import Straight
from .track import Track

STATIONS, DENSE, FINE = 7, 720, 80  # A on the sheet; trials that tell where A is of use; points of the curve
FURTHEST, OVER = 3.0, 1.25  # chords from C₁, on a locus that is drawn in part; of the way to what is sought


def gamma_curve(draft: Draft, track: Track, sought: Sequence[float]) -> Chart | None:
    """The stations on the sheet and the curve in a figure of its own, as far as the places that are sought; None where
    no A on this locus is of use."""
    run = _useful(track, sought)
    if len(run) < STATIONS:
        return None
    board, places = draft.board, track.place(np.array(run)).tolist()
    fine = np.interp(np.linspace(places[0], places[-1], FINE), places, run)
    gammas = np.degrees(track.least(fine))
    if not np.nanmax(gammas) > 0:
        return None
    primes = primes_of(track.locus)
    for n, place in enumerate(np.linspace(places[0], places[-1], STATIONS + 2)[1:-1], 1):
        at = track.on_sheet(draft, float(np.interp(place, places, run)))
        board.plot(SHEET, at, f"{n}{primes}", Dot.POINT)
    curve = _opened(draft, track, places, float(np.nanmax(gammas)))
    curve.ruled()
    curve.curve(track.place(fine).tolist(), gammas.tolist())
    for n, place in enumerate(np.linspace(places[0], places[-1], STATIONS + 2)[1:-1], 1):
        t = float(np.interp(place, places, run))
        curve.point(float(track.place(t)), degrees(track.least(t)), f"{n}{primes}")
    return curve


def _opened(draft: Draft, track: Track, places: list[float], most: float) -> Chart:
    primes = primes_of(track.locus)
    straight = isinstance(track.locus, Straight)
    over = Axis(symbol="C_{1}A" if straight else "β", unit="mm" if straight else "°", low=places[0], high=places[-1])
    up = Axis(symbol="γ_{min}", unit="°", low=0.0, high=most)
    curve = chart(draft, f"gamma of A{primes}", _title(straight, primes), over, up)
    draft.board.step(
        Words(
            f"对每个 $A$，作曲柄与机架共线的两个位置，量得 $γ_{{min}}$，以{_over_zh(straight, primes)}为横坐标画曲线。",
            f"For each of these points $A$ draw both positions in which the crank is in line with the frame, "
            f"read $γ_{{min}}$, and plot it over {_over_en(straight, primes)}.",
        ),
        curve.place,
    )
    return curve


def _title(straight: bool, primes: str) -> Words:
    """By the locus of A: a problem with two loci has two curves."""
    if straight:
        return Words("$A$ 在直线 $C_{1}C_{2}$ 上时的 $γ_{min}$", "$γ_{min}$ for $A$ on the line $C_{1}C_{2}$")
    return Words(f"$A$ 在圆 $η{primes}$ 上时的 $γ_{{min}}$", f"$γ_{{min}}$ for $A$ on the circle $η{primes}$")


def _over_zh(straight: bool, primes: str) -> str:
    return "图上距离 $C_{1}A$" if straight else f"$β = ∠C_{{1}}O{primes}A$"


def _over_en(straight: bool, primes: str) -> str:
    return "the distance $C_{1}A$ on paper" if straight else f"$β = ∠C_{{1}}O{primes}A$"


def _is_long(track: Track) -> bool:
    """Whether the locus is drawn in part: a straight line, or a circle of which only arcs are."""
    return isinstance(track.locus, Straight) or track.locus.flat


def _useful(track: Track, sought: Sequence[float]) -> list[float]:
    """The longest run of trials in which A is of use; on a locus that is drawn in part not far beyond what is
    sought."""
    far = max((OVER * abs(track.at(t) - track.c1) for t in sought), default=0.0)
    reach = max(FURTHEST * track.chord, far)
    trials = np.linspace(0.0, 1.0, DENSE + 2)[1:-1]
    near = trials[abs(track.at(trials) - track.c1) < reach] if _is_long(track) else trials
    judged = zip(np.isfinite(track.least(near)).tolist(), near.tolist(), strict=True)
    runs = [[t for _, t in run] for valid, run in groupby(judged, itemgetter(0)) if valid]
    return max(runs, key=len, default=[])
