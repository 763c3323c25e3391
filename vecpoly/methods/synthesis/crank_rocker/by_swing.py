"""A crank-rocker from K and the swing of its rocker: A on a circle from which C₁C₂ is seen under θ."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from ....algebra.quantity import Quantity
from ....board.paper.marks import Role
from ....designs.crank_rocker import CrankRocker
from ....plane import Points, nominal, unit
from ....words import Words
from ..draft import SHEET, Draft
from ..eta import Eta, Locus, Straight, eta
from ..limits.judged import BESIDE, judged, limits_of, settled
from ..linkage import pin, pivot
from .pivots import pivots
from .rocker import Rocker


def by_swing(draft: Draft, design: CrankRocker, theta: Quantity) -> None:
    """The two limit positions of the rocker, the circle η and its mirror image, and A on each of them."""
    rocker = _rocker(draft, design)
    for locus in _loci(draft, rocker, theta):
        _solutions(draft, design, rocker, locus)


def _rocker(draft: Draft, design: CrankRocker) -> Rocker:
    board = draft.board
    assert design.swing is not None
    board.section(Words("摇杆的极限位置", "Limit positions of the rocker"))
    board.step(
        Words(
            "选 $μ_l$，任取 $D$ 点，按摇杆长 $l_CD$ 和摆角 $ψ$ 作摇杆的两极限位置 $C_{1}D$、$C_{2}D$，连 "
            "$C_{1}C_{2}$。",
            "Choose $μ_l$ and a point $D$; with the length $l_CD$ and the swing $ψ$ draw the rocker in its limit "
            "positions "
            "$C_{1}D$ and $C_{2}D$. Join $C_{1}C_{2}$.",
        ),
        SHEET,
    )
    d, half = pivot(draft, "D", 0j), board.given(design.swing.si, "swing") / 2
    c1, c2 = (
        pin(
            draft,
            f"C_{i}",
            board.lay_off(d, board.ray(d, 1j, way * half, key=f"DC{i}").along, draft.mm(design.CD.si), key=f"CD{i}"),
        )
        for i, way in ((1, 1), (2, -1))
    )
    for one, other in ((d, c1), (d, c2), (c1, c2)):
        board.join(SHEET, one, other, Role.CONSTRUCTION)
    return Rocker(d=d, c1=c1, c2=c2)


def _loci(draft: Draft, rocker: Rocker, theta: Quantity) -> Iterator[Locus]:
    """Where C₁C₂ is seen under θ: two circles, or the line itself where θ = 0."""
    board, chord = draft.board, unit(rocker.c2 - rocker.c1)
    board.section(Words("$A$ 点所在的圆", "The circle of $A$"))
    if float(nominal(theta.value)) < 1e-9:
        board.step(
            Words(
                "$K = 1$，$θ = 0$，无急回；$A$ 在直线 $C_{1}C_{2}$ 上。",
                "With $K = 1$ and $θ = 0$ there is no quick return, and $A$ lies on the line $C_{1}C_{2}$.",
            ),
            SHEET,
        )
        yield Straight(line=board.parallel(rocker.c1, chord, key="C1C2"))
        return
    for way in (-1, 1):
        size = float(nominal(np.abs(rocker.c1 - rocker.d)))
        draft.begins()
        yield eta(draft, (rocker.c1, rocker.c2), theta, way, way < 0, size)


def _solutions(draft: Draft, design: CrankRocker, rocker: Rocker, locus: Locus) -> None:
    """Each A on this locus, and its linkage."""
    for a in pivots(draft, design, rocker, locus):
        letter = draft.letter("A")
        a = pivot(draft, letter, a)
        if isinstance(locus, Eta) and locus.flat:
            locus.arc(draft, rocker.c1, a)
        verdict = judged(a, rocker.d, rocker.c1, rocker.c2, seen=_sees(a, rocker, locus))
        settled(draft, limits_of(a, rocker.d, rocker.c1, rocker.c2, (letter, "C_1", "C_2")), verdict)


def _sees(a: Points, rocker: Rocker, locus: Locus) -> bool:
    """Whether the chord is seen under θ from there, and not under 180° − θ."""
    place = complex(nominal((a - rocker.c1) / (rocker.c2 - rocker.c1)))
    if isinstance(locus, Straight):
        return not -BESIDE <= place.real <= 1 + BESIDE
    return place.imag * locus.side > BESIDE
