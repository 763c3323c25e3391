"""The structural error of a function generator: where its output link is, less where the function has it."""

from __future__ import annotations

from cmath import exp
from dataclasses import dataclass
from math import degrees

import numpy as np

from ....algebra.quantity import magnitude
from ....algebra.worked import stated
from ....designs.generator.formula import Value
from ....designs.generator.function_generator import ERROR, FunctionGenerator
from ....designs.ranges import extremes
from ....foundation.slotted import replace
from ....plane import Points, Reals, circles_meet, cross, distance, nominal
from ....plane.geometry import dot
from ....words import Words
from ..chart import Axis, chart
from ..inversion.sheet import Sheet
from .greatest import place_of_greatest

STATIONS = 60
LEAST = 1e-9  # of the length of a link: at a dead point


@dataclass(frozen=True, slots=True)
class Output:
    """The linkage as it was found, moved on scratch paper: C by two arcs, on the side on which it stands."""

    design: FunctionGenerator
    d: Points
    ab: Reals
    bc: Reals
    cd: Reals
    ways: tuple[int, int]  # of AM and DN: whether the pins lie on these lines or on the lines produced backwards
    left: bool  # of the ray DB

    @classmethod
    def of(cls, sheet: Sheet, design: FunctionGenerator) -> Output:
        """From the pins in the first position."""
        b, c, d = (sheet.pins[letter][0] for letter in "BCD")
        way, other = (
            1 if float(nominal(dot(sheet.bodies[line][0].along, at))) > 0 else -1
            for line, at in (("AM", b), ("DN", c - d))
        )
        left = float(nominal(cross(d - b, c - b))) > 0
        return cls(design, d, np.abs(b), distance(b, c), distance(d, c), (way, other), left)

    def nominally(self) -> Output:
        """As on the nominal sheet: moved to many places at once."""
        d, ab, bc, cd = map(nominal, (self.d, self.ab, self.bc, self.cd))
        return replace(self, d=d, ab=ab, bc=bc, cd=cd)

    def error(self, share: Value) -> Reals:
        """How far C is ahead of its place (rad), at a share of the range."""
        phi, psi = self.design.angles_at(share)
        b: Points = self.ways[0] * self.ab * np.exp(1j * phi)
        right, left = circles_meet(self.d, self.cd, b, self.bc)
        c = left if self.left else right
        return np.asarray(np.angle(self.ways[1] * (c - self.d) * np.exp(-1j * psi)))


def passes(sheet: Sheet, design: FunctionGenerator) -> bool:
    """Whether the loop can be closed all over the range: at its ends, and with AB on the line of AD."""
    assert design.phi is not None
    one = Output.of(sheet, design).nominally()
    ab, bc, cd, d = (float(value) for value in (one.ab, one.bc, one.cd, np.abs(one.d)))
    places = extremes(*sorted(end.si for end in design.phi))
    bases = [abs(d - one.ways[0] * ab * exp(1j * phi)) for phi in places]
    slack = LEAST * (bc + cd)
    return all(abs(bc - cd) - slack <= base <= bc + cd + slack for base in bases)


def error_curve(sheet: Sheet, design: FunctionGenerator) -> None:
    """The curve over φ, and its greatest ordinate."""
    draft, output = sheet.draft, Output.of(sheet, design)
    ideal, shares = output.nominally(), np.arange(STATIONS + 1) / STATIONS
    worst = place_of_greatest(lambda share: np.abs(ideal.error(share)))
    phis = np.degrees(design.angles_at(shares)[0]).tolist()
    errors = np.degrees(ideal.error(shares)).tolist()
    over = Axis(symbol="φ", unit="°", low=min(phis), high=max(phis))
    up = Axis(symbol="ε", unit="°", low=min(0.0, *errors), high=max(0.0, *errors))
    curve = chart(draft, "error", Words("结构误差曲线", "Structural error"), over, up)
    draft.board.step(
        Words(
            "使 $AB$ 逐点转过给定范围，用两弧求 $C$，得 $DC$ 的实际转角 $ψ$ 与函数要求的转角之差 $ε$，画误差曲线；"
            "三个精确点处 $ε = 0$。误差最大处：",
            "Turn $AB$ through its range, find $C$ by two arcs, and plot the error $ε$ by which the angle $ψ$ of $DC$ "
            "is "
            "ahead of the function's. At the three precision points $ε = 0$. The maximum error is:",
        ),
        curve.place,
    )
    curve.ruled()
    curve.curve(phis, errors)
    phi, value = degrees(design.angles_at(worst)[0]), np.degrees(output.error(worst))
    curve.point(phi, float(nominal(value)), "ε_{max}")
    draft.board.write(stated(magnitude("φ", phi, "deg")))
    draft.stated(draft.of_this(ERROR), np.abs(value))
