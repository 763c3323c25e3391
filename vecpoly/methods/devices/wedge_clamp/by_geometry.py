"""Self-locking of a clamping wedge by geometry: two reactions in one line, within both friction cones."""

from __future__ import annotations

import numpy as np

from ....algebra.formula import sym
from ....algebra.quantity import Quantity, number
from ....board.construction import Pane, View
from ....board.paper.marks import Role
from ....devices.wedge_clamp import LIMIT, WedgeClamp
from ....plane import Line, Points, lines_meet, nominal
from ....words import Words
from ..bench import Bench
from ..inclined import between, body, cone, gauged, numbered, ray, row_of
from .shape import LENGTH, corners

CONE = 36.0
FACE, BESIDE = 46.0, 5.0  # mm: of the wedge at the limit; from a face to the number of the body there


def by_geometry(bench: Bench, device: WedgeClamp, slope: Points, phi: Quantity) -> None:
    """Without F the wedge is a two-force body: both reactions lie in one line, inside both friction cones."""
    board = bench.board
    board.section(Words("方法一：由二力平衡", "Method 1: equilibrium of two forces"))
    place = board.open_pane(View.BODY, "cones", Words("两摩擦锥", "The two friction cones"))
    board.step(
        Words(
            "去掉 $F$ 后楔块 3 为二力构件，$R_13$ 与 $R_23$ 须等值、反向、共线。两工作面的法线 $n_13$、"
            "$n_23$ 夹角为 $α$，而两反力偏离各自法线都不能超过 $φ$。只有公共作用线同时落在两个摩擦锥内时楔块才不会"
            "退出，故自锁条件为 $α ≤ 2φ$。",
            "Without $F$ wedge 3 is a two-force body: $R_13$ and $R_23$ are equal, opposite and "
            "collinear. The normals $n_13$ and $n_23$ of the faces make the angle $α$, and "
            "neither reaction can deviate from its normal by more than $φ$. The wedge stays in "
            "only where the common line of action lies within both friction cones; so the "
            "condition of self-locking is $α ≤ 2φ$.",
        ),
        place,
    )
    _cones(bench, place, slope, phi)
    _verdict(bench, device, phi)
    _limit(bench, phi)


def _cones(bench: Bench, place: Pane, slope: Points, phi: Quantity) -> None:
    it = corners(slope)
    body(bench, place, "link 3", *it)
    under = complex(LENGTH * 0.42, 0)
    over = lines_meet(Line(under, 1j), Line(it[2], slope))
    for at, outward, label in ((under, -1j, "n_{13}"), (over, 1j * slope, "n_{23}")):
        cone(bench, place, at, outward, phi.value, CONE, label)
    bench.board.join(place, under, over, Role.HIDDEN)


def _verdict(bench: Bench, device: WedgeClamp, phi: Quantity) -> None:
    """Whether α ≤ 2φ."""
    board = bench.board
    steep, twice = (number(float(nominal(z))) for z in (np.degrees(device.alpha.si), 2 * phi.value))
    if device.alpha.si <= np.radians(2 * phi.value):
        board.remark(
            Words(
                f"本题 $α$ = {steep}° ≤ $2φ$ = {twice}°，两锥有公共的作用线，楔块自锁。",
                f" Here $α$ = {steep}° ≤ $2φ$ = {twice}°: the cones share a line and the wedge is self-locking.",
            )
        )
    else:
        board.remark(
            Words(
                f"本题 $α$ = {steep}° > $2φ$ = {twice}°，任何连线都不能同时落在两锥内，楔块不自锁。",
                f" Here $α$ = {steep}° > $2φ$ = {twice}°: no line lies within both cones and the "
                "wedge is not self-locking.",
            )
        )


def _limit(bench: Bench, phi: Quantity) -> None:
    """The largest α: both reactions lean by φ and lie in one line."""
    board = bench.board
    limit = board.open_pane(View.BODY, "limit", Words("自锁极限", "Limit of self-locking"))
    board.step(
        Words(
            "作极限位置：两反力各偏 $φ$ 而恰好共线。自公共作用线向两侧各量 $φ$ 得两法线，作其垂线为两工作面"
            "（与 1 接触的在下，与 2 接触的在上），量其夹角：",
            "The limit: both reactions are inclined by $φ$ and just collinear. Set off $φ$ to "
            "either side of the common line to get the normals; the faces are perpendicular to "
            "them (on 1 below, on 2 above). Read the angle between the faces:",
        ),
        limit,
    )
    turn = np.exp(1j * np.radians(phi.value))
    one, other = board.turn(1j * turn), board.turn(1j / turn)
    for along, length, label in ((1j, 46.0, "R_{13} = −R_{23}"), (one, 38.0, "n_{13}"), (other, 38.0, "n_{23}")):
        ray(bench, limit, 0j, along, length, label)
    under, over = 1j * one, 1j * other  # from the edge back along the faces: as the wedge lies, thick end at the left
    body(bench, limit, "link 3", 0j, over * FACE, under * FACE)
    places = ((-0.9 * FACE, "3"), (over * 0.7 * FACE + BESIDE * 1j, "2"), (under * 0.7 * FACE - BESIDE * 1j, "1"))
    numbered(bench, limit, *places)
    between(bench, limit, 0j, 1j, one, 28.0, "φ")
    between(bench, limit, 0j, other, 1j, 28.0, "φ")
    between(bench, limit, 0j, over, under, 24.0, LIMIT.symbol)
    found = gauged(bench, other, one)
    bench.stated(LIMIT, found, row_of(sym(LIMIT.symbol), f" = 2$φ$ = {number(float(nominal(found)))}°"))
