"""The force polygons of two wedges, joined at their common side: that of wedge 2 first, then that of wedge 1."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from ....algebra.quantity import Quantity
from ....board.construction import View
from ....devices.wedges import DRIVE, HOLD, IDEAL, REACTIONS, Wedges
from ....names import Named, reaction
from ....plane import Points, nominal
from ....words import Words
from ..bench import Bench
from ..equilibrium import balance, drawn, driven, given, letter, sought
from ..inclined import facing, leaned
from ..sketches.wedges import Shapes
from ..strokes import Corners, Stroke, strokes

R12, R32, R31 = REACTIONS
LOAD, R21 = Named("Q", "Q", "N"), reaction("2", "1")
LIFT, SMOOTH, BACK = strokes(DRIVE, IDEAL, HOLD, Words("正行程", "lifting"), Words("反行程", "return stroke"))
ALONG_GUIDE = Words("∥导路", "∥ guide")
Angles = Mapping[str, Quantity]  # friction angles in degrees, by face


@dataclass(frozen=True, slots=True)
class Lines:
    """Unit vectors: the reactions on 2, 2 and 1, and the normals of the guides they lean from."""

    r12: Points
    r32: Points
    r31: Points
    n32: Points
    n31: Points


def over(it: Shapes, lines: Lines) -> bool:
    """Whether wedge 1 is pressed against the upper side of its guide."""
    return float(nominal((lines.n31 / (1j * it.guide)).real)) < 0


def lines_of(it: Shapes, phi: Angles, sense: int) -> Lines:
    """Where the reactions point when 2 rises (sense +1) or sinks (−1)."""
    r12 = leaned(it.normal, sense * it.face, phi["12"].value)
    n32, n31 = facing(-1 + 0j, r12), facing(1j * it.guide, -r12)
    return Lines(
        r12, leaned(n32, sense * 1j, phi["23"].value), leaned(n31, sense * it.guide, phi["13"].value), n32, n31
    )


def polygon(bench: Bench, device: Wedges, it: Shapes, lines: Lines, stroke: Stroke, lead: Words) -> Corners:
    """Q = ab, R_32 = bc, R_12 = ca; R_31 = cd, F = da: Q, R_32, R_12 close on wedge 2; −R_12, R_31 and the force on
    wedge 1 are joined to them at the common side."""
    board, place = bench.board, bench.board.open_pane(View.FORCE, stroke.drive.key, stroke.title)
    by_1, by_3, on_1, under = (stroke.force(force) for force in (R12, R32, R21, R31))
    drive, lean, tips = stroke.drive, stroke.lean, stroke.corners()
    board.step(
        lead
        + Words(
            f"按 $μ_F$ 作楔块 2 的力多边形：$ab$ 代表 $Q$，过 $b$ 作 ${by_3.symbol}$ 的方向线，"
            f"过 $a$ 作 ${by_1.symbol}$ 的方向线，交于 ${tips[0]}$。",
            "Draw the force polygon of wedge 2 to the scale $μ_F$: $ab$ stands for "
            f"$Q$; the direction of ${by_3.symbol}$ through $b$ and that of "
            f"${by_1.symbol}$ through $a$ meet at ${tips[0]}$.",
        ),
        place,
    )
    terms = (
        given(bench, place, LOAD, device.Q.si, -1j, "b"),
        sought(by_3, lines.r32, lean),
        sought(by_1, lines.r12, lean),
    )
    refusal = sum(float(np.degrees(np.arctan(device.friction(face).si))) for face in ("12", "23"))
    b, c = driven(bench, place, 0j, terms, lambda: device.locked(refusal)).ends[by_3.key]
    board.step(
        Words(
            f"楔块 1 的力多边形：$a$${tips[0]}$ 即 ${on_1.symbol}$；过 ${tips[0]}$ 作 ${under.symbol}$ 的方向线，"
            f"过 $a$ 作 ${drive.symbol}$ 的方向线，交于 ${tips[1]}$。",
            f"In the polygon of wedge 1 $a$${tips[0]}$ is ${on_1.symbol}$; the direction of "
            f"${under.symbol}$ through ${tips[0]}$ and that of ${drive.symbol}$ through $a$ meet "
            f"at ${tips[1]}$.",
        ),
        place,
    )
    _, d = balance(
        bench, place, 0j, drawn(on_1, c), sought(under, lines.r31, lean), sought(drive, it.guide, ALONG_GUIDE)
    ).ends[under.key]
    letter(bench, place, {"a": 0j, tips[0]: c, tips[1]: d})
    return Corners(place, 0j, b, c, d)
