"""The structural error of a function generator: where its output link is, less where the function has it."""

from __future__ import annotations

from cmath import exp
from math import degrees

import numpy as np

from ....algebra.quantity import magnitude
from ....algebra.worked import stated
from ....designs.generator.function_generator import ERROR, FunctionGenerator
from ....designs.ranges import extremes
from ....plane import Points, Reals, circles_meet, cross, distance, nominal
from ....plane.geometry import dot
from ....words import Words
from ..chart import Axis, chart
from ..inversion.sheet import Sheet
from .greatest import place_of_greatest

STATIONS = 60
LEAST = 1e-9  # of the length of a link: at a dead point


class Output:
    """The linkage as it was found, moved on scratch paper: C by two arcs, on the side on which it stands."""

    def __init__(self, sheet: Sheet, design: FunctionGenerator) -> None:
        self.design, pins = design, sheet.pins
        self.d, b, c = pins["D"][0], pins["B"][0], pins["C"][0]
        self.ab, self.bc, self.cd = np.abs(b), distance(b, c), distance(self.d, c)
        along = sheet.bodies["AM"][0].along, sheet.bodies["DN"][0].along
        self.ways = tuple(
            1 if float(nominal(dot(way, at))) > 0 else -1 for way, at in zip(along, (b, c - self.d), strict=True)
        )
        self.left = float(nominal(cross(self.d - b, c - b))) > 0

    def error(self, share: float) -> Reals:
        """How far C is ahead of its place (rad), at a share of the range."""
        phi, psi = self.design.angles_at(share)
        b: Points = self.ways[0] * self.ab * exp(1j * phi)
        right, left = circles_meet(self.d, self.cd, b, self.bc)
        c = left if self.left else right
        return np.asarray(np.angle(self.ways[1] * (c - self.d) * exp(-1j * psi)))

    def size(self, share: float) -> float:
        """The size of the error on the nominal sheet."""
        return abs(float(nominal(self.error(share))))


def passes(sheet: Sheet, design: FunctionGenerator) -> bool:
    """Whether the loop can be closed all over the range: at its ends, and with AB on the line of AD."""
    assert design.phi is not None
    one = Output(sheet, design)
    ab, bc, cd, d = (float(nominal(value)) for value in (one.ab, one.bc, one.cd, np.abs(one.d)))
    places = extremes(*sorted(end.si for end in design.phi))
    bases = [abs(d - one.ways[0] * ab * exp(1j * phi)) for phi in places]
    slack = LEAST * (bc + cd)
    return all(abs(bc - cd) - slack <= base <= bc + cd + slack for base in bases)


def error_curve(sheet: Sheet, design: FunctionGenerator) -> None:
    """The curve over φ, and its greatest ordinate."""
    draft, output = sheet.draft, Output(sheet, design)
    shares = [n / STATIONS for n in range(STATIONS + 1)]
    worst = place_of_greatest(output.size)
    phis = [degrees(design.angles_at(share)[0]) for share in shares]
    errors = [degrees(float(nominal(output.error(share)))) for share in shares]
    over = Axis(symbol="φ", unit="°", low=min(phis), high=max(phis))
    up = Axis(symbol="ε", unit="°", low=min(0.0, *errors), high=max(0.0, *errors))
    curve = chart(draft, "error", Words("结构误差曲线", "Structural error"), over, up)
    draft.board.step(
        Words(
            "使 $AB$ 逐点转过给定范围，用两弧求 $C$，得 $DC$ 的实际转角 $ψ$ 与函数要求的转角之差 $ε$，画误差曲线；"
            "三个精确点处 $ε = 0$。误差最大处：",
            "Turn $AB$ through its range, find $C$ by two arcs, and plot the error $ε$ by which the angle $ψ$ of $DC$ "
            "is "
            "ahead of the function's. At the three precision points $ε = 0$. The greatest error:",
        ),
        curve.place,
    )
    curve.ruled()
    curve.curve(phis, errors)
    phi, value = degrees(design.angles_at(worst)[0]), np.degrees(output.error(worst))
    curve.point(phi, float(nominal(value)), "ε_{max}")
    draft.board.write(stated(magnitude("φ", phi, "deg")))
    draft.stated(draft.of_this(ERROR), np.abs(value))
