"""The limits of self-locking of a ring-spring buffer: reactions along F where it is pushed, along Q on release."""

from __future__ import annotations

import numpy as np

from ....algebra.formula import sym
from ....algebra.quantity import Quantity, number
from ....board.construction import Pane, View
from ....devices.ring_spring import GREATEST, LEAST, RingSpring
from ....plane import Points, nominal
from ....words import Words
from ..bench import Bench
from ..inclined import between, gauged, ray, row_of


def limits(bench: Bench, device: RingSpring, phi: Quantity) -> None:
    """Pushing: the reactions are vertical, none of them against Q. Releasing:
    they are horizontal, none of them against F."""
    board = bench.board
    board.section(Words("不自锁的条件", "Conditions against self-locking"))
    place = board.open_pane(View.BODY, "limits", Words("自锁极限", "Limits of self-locking"))
    turn = np.exp(1j * np.radians(phi.value))
    push, release = board.turn(1j / turn), board.turn(turn)
    _least(bench, place, push, release)
    _greatest(bench, place, release)
    _verdict(bench, float(np.degrees(device.alpha.si)), float(nominal(phi.value)))


def _least(bench: Bench, place: Pane, push: Points, release: Points) -> None:
    """The least α: the normal of the face leans by φ from the vertical; both normals are drawn."""
    bench.board.step(
        Words(
            "压缩行程的极限：$R_12$、$R_42$ 竖直（与 $F$ 平行），没有水平分力与 $Q$ 平衡，无论 $F$ 多大都压不动。"
            "自竖直线量 $φ$ 得法线 $n$，它与 $F$ 的夹角为 $α$ 的下限。由 $η = tan(α − φ)/tan α > 0$ 同样得 $α > "
            "φ$。",
            "The limit of compression: $R_12$ and $R_42$ are vertical, along $F$; they have no "
            "horizontal component to balance $Q$, and no $F$ moves the wedges. Set off $φ$ from "
            "the vertical to get the normal $n$; its angle with $F$ is the lower limit of $α$. The "
            "condition $η = tan(α − φ)/tan α > 0$ gives $α > φ$ as well.",
        ),
        place,
    )
    for along, label in ((1j, "R_{42}"), (push, "n"), (release, "n'"), (1 + 0j, "R'_{42}")):
        ray(bench, place, 0j, along, 40.0, label)
    between(bench, place, 0j, push, 1j, 30.0, f"{LEAST.symbol} = φ")
    least = gauged(bench, push, 1j)
    bench.stated(LEAST, least, row_of(sym(LEAST.symbol), f" = $φ$ = {number(float(nominal(least)))}°"))


def _greatest(bench: Bench, place: Pane, release: Points) -> None:
    """The greatest α: the normal of the face leans by φ from the horizontal."""
    bench.board.step(
        Words(
            "回弹行程的极限：$R'_12$、$R'_42$ 水平（与 $Q$ 平行），没有竖直分力推回楔块 1。自水平线量 $φ$ 得法线 "
            "$n'$，它与 $F$ 的夹角为 $α$ 的上限。由 $η' = tan α/tan(α + φ) > 0$ 同样得 $α < 90° − φ$。",
            "The limit of release: $R'_12$ and $R'_42$ are horizontal, along $Q$; they have no "
            "vertical component to push wedge 1 back. Set off $φ$ from the horizontal to get the "
            "normal $n'$; its angle with $F$ is the upper limit of $α$. The condition $η' = tan α/tan(α + φ) > "
            "0$ gives $α < 90° − φ$ as well.",
        ),
        place,
    )
    between(bench, place, 0j, release, 1j, 18.0, GREATEST.symbol)
    between(bench, place, 0j, 1 + 0j, release, 30.0, "φ")
    greatest = gauged(bench, release, 1j)
    bench.stated(
        GREATEST, greatest, row_of(sym(GREATEST.symbol), f" = 90° − $φ$ = {number(float(nominal(greatest)))}°")
    )


def _verdict(bench: Bench, alpha: float, phi: float) -> None:
    """Where α stands between its limits (deg)."""
    if alpha < 90.0 - phi - 1e-9:
        bench.board.remark(
            Words(
                f"本题 $φ$ < $α$ = {number(alpha)}° < $90° − φ$，两个行程都不自锁。",
                f" Here $φ$ < $α$ = {number(alpha)}° < $90° − φ$: neither stroke is self-locking.",
            )
        )
    else:
        bench.board.remark(
            Words(
                f"本题 $α$ = {number(alpha)}° ≥ $90° − φ$，回弹行程自锁。",
                f" Here $α$ = {number(alpha)}° ≥ $90° − φ$: the release is self-locking.",
            )
        )
