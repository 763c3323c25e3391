"""The limits of self-locking of a wedge pair, from the normals of its faces:
two reactions in one line, each leaning by φ."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from ....algebra.formula import sym
from ....algebra.quantity import number
from ....board.construction import Pane, View
from ....board.paper.marks import Dot, Role
from ....devices.wedges import LOCK_DIRECT, LOCK_REVERSE
from ....names import Named
from ....plane import Points, nominal
from ....words import Words
from ..bench import Bench
from ..inclined import gauged, ray, row_of
from ..sketches.wedges import Shapes

RAY, LINE = 34.0, 46.0  # mm: normals, lines of the two reactions


def limits(bench: Bench, it: Shapes, phi: Mapping[str, float]) -> None:
    """With the same φ on all faces:
    half the angle between n_12 and −n_32 locks the drive, half of that between n_12 and n_31 the return stroke."""
    board = bench.board
    board.section(Words("自锁条件", "Self-locking"))
    place = board.open_pane(View.BODY, "limits", Words("自锁极限", "Limits of self-locking"))
    normals = {"n_{12}": it.normal, "−n_{32}": 1 + 0j, "n_{31}": 1j * it.guide}
    board.step(
        Words(
            "求各面摩擦角相同时的极限值。正行程：$R_12$ 与 $R_32$ 各偏转 $φ$ 后若反向共线，则二者自行平衡，"
            "无论 $F$ 多大都顶不起 $Q$，正行程自锁。故极限摩擦角为 $n_12$ 与 $−n_32$ 夹角之半，即 $β/2$：",
            "The limits, with the same friction angle on all faces. Lifting: if $R_12$ and "
            "$R_32$, each turned by $φ$, become collinear and opposite, they balance each other "
            "and no $F$ lifts $Q$, however large: lifting is self-locking. So the limit is half "
            "the angle between $n_12$ and $−n_32$, that is $β/2$:",
        ),
        place,
    )
    for label, normal in normals.items():
        ray(bench, place, 0j, normal, RAY, label)
    direct = _half(bench, place, normals, ("−n_{32}", "n_{12}"), LOCK_DIRECT, "R_{12} = −R_{32}")
    board.step(
        Words(
            "反行程：$R_21$ 与 $R_31$ 各偏转 $φ$ 后若反向共线，则楔块 1 为二力平衡，不需 $F'$，反行程自锁。"
            "故极限摩擦角为 $n_12$ 与 $n_31$ 夹角之半，即 $(180° − α − β)/2$。",
            "Return stroke: if $R_21$ and $R_31$, each turned by $φ$, become collinear and "
            "opposite, wedge 1 rests without $F'$: the return stroke is self-locking. So the limit is "
            "half the angle between $n_12$ and $n_31$, that is $(180° − α − β)/2$.",
        ),
        place,
    )
    back = _half(bench, place, normals, ("n_{12}", "n_{31}"), LOCK_REVERSE, "R_{31} = −R_{21}")
    if len(set(phi.values())) == 1:
        _verdict(bench, phi["12"], direct, back)


def _half(
    bench: Bench, place: Pane, normals: dict[str, Points], pair: tuple[str, str], named: Named, common: str
) -> float:
    """Bisect the angle between two normals, read it with the protractor, and halve it (deg)."""
    one, other = (bench.board.turn(normals[name]) for name in pair)
    between = gauged(bench, one, other)
    start, whole = float(np.angle(nominal(one))), float(np.angle(nominal(other / one)))
    middle = np.exp(1j * (start + whole / 2)) * LINE
    radius = 20.0 if named is LOCK_DIRECT else 24.0
    bench.board.arrow(place, 0j, middle, Role.RESULT)
    bench.board.plot(place, middle, common, Dot.NONE)
    for first in (one, middle):
        bench.board.angle(place, 0j, first, whole / 2, radius, named.symbol)
    half = between / 2
    shown = number(float(nominal(between))), number(float(nominal(half)))
    bench.stated(
        named, half, row_of(sym(named.symbol), f" = ∠(${pair[0]}$, ${pair[1]}$)/2 = {shown[0]}°/2 = {shown[1]}°")
    )
    return float(nominal(half))


def _verdict(bench: Bench, phi: float, direct: float, back: float) -> None:
    """Which way is self-locking with this friction angle (deg)."""
    locked = [
        words
        for words, limit in ((Words("正行程", "lifting"), direct), (Words("反行程", "the return stroke"), back))
        if phi >= limit
    ]
    names = Words("、".join(words.zh for words in locked), " and ".join(words.en for words in locked))
    said = (
        Words(f"{names.zh}自锁", f"self-locking: {names.en}")
        if locked
        else Words("正、反行程都不自锁", "neither way is self-locking")
    )
    bench.board.remark(Words(f"本题 $φ$ = {number(phi)}°，{said.zh}。", f" Here $φ$ = {number(phi)}°: {said.en}."))
