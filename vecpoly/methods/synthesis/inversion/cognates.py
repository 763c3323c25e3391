"""Roberts's figure: parallelograms at both pivots, similar triangles on their sides, a third parallelogram."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from itertools import groupby, pairwise
from math import ceil, radians, sin

import numpy as np

from ....board.paper.marks import Role
from ....designs.inversion.cognates import LEFT, RIGHT, Cognates
from ....designs.verdict import Verdict
from ....names import Named
from ....plane import Points, circles_meet, nominal, unit
from ....words import Words
from ..draft import SHEET, Draft
from ..linkage import drawn, pin, pivot
from ..registry import design_method

FLAT = sin(radians(20))  # parallels that meet flatter than this give a bad point: a hand carries the side over
TURN = 48  # positions of the crank in which the coupler curve is drawn and the cognates are tried


@design_method(
    Cognates,
    title=Words("四杆机构的同源机构", "Cognates of a four-bar linkage"),
    source="机械原理, theorem of Roberts and Chebyshev: three four-bars lead one point along one curve",
    example="cognates",
)
def draw_cognates(draft: Draft, design: Cognates) -> None:
    """The four-bar, then its cognates A G H F and D M N F, their lengths, and a trial over the turn."""
    pins = _fourbar(draft, design)
    pins |= _parallelograms(draft, pins)
    pins |= _triangles(draft, pins)
    pins |= _third_pivot(draft, pins)
    _lengths(draft, pins)
    _tried(draft, _Figure.of(pins))
    draft.candidate(Verdict.VALID, (0.0,), **pins)


def _fourbar(draft: Draft, design: Cognates) -> dict[str, Points]:
    board = draft.board
    board.section(Words("给定的四杆机构", "The given four-bar linkage"))
    board.step(
        Words(
            "选 $μ_l$，画出四杆机构 $ABCD$ 和连杆上的点 $E$。",
            "Choose $μ_l$ and draw the four-bar linkage $ABCD$ with the point $E$ of its coupler.",
        ),
        SHEET,
    )
    a = pivot(draft, "A", np.complex128(0))
    d = pivot(draft, "D", board.lay_off(a, 1 + 0j, draft.mm(design.AD.si), key="AD"))
    ray = board.ray(a, 1 + 0j, board.given(design.phi.si, "phi"), key="AB")
    b = pin(draft, "B", board.lay_off(a, ray.along, draft.mm(design.AB.si), key="AB"))
    both = board.arcs(b, draft.mm(design.BC.si), d, draft.mm(design.CD.si), Words("求 $C$", "finding $C$"))
    c = pin(draft, "C", both[0 if design.side == "left" else 1])
    place = design.E.at
    e = pin(draft, "E", board.lay_off(b, unit(c - b) * place / abs(place), draft.mm(abs(place)), key="E"))
    drawn(draft, (a, b, c, d))
    drawn(draft, (b, e, c))
    return {"A": a, "B": b, "C": c, "D": d, "E": e}


def _parallelograms(draft: Draft, pins: Mapping[str, Points]) -> dict[str, Points]:
    """A G E B and D M E C."""
    draft.board.section(Words("同源机构", "The cognates"))
    draft.board.step(
        Words(
            "作平行四边形 $AGEB$ 和 $DMEC$，得 $G$、$M$。",
            "Complete the parallelograms $AGEB$ and $DMEC$ to find $G$ and $M$.",
        ),
        SHEET,
    )
    return {
        "G": pin(draft, "G", _fourth(draft, pins["A"], pins["B"], pins["E"], "G")),
        "M": pin(draft, "M", _fourth(draft, pins["D"], pins["C"], pins["E"], "M")),
    }


def _fourth(draft: Draft, one: Points, corner: Points, other: Points, letter: str) -> Points:
    """The corner opposite `corner`, where parallels to its sides meet; laid off where they meet flat."""
    board, sides = draft.board, (unit(other - corner), unit(one - corner))
    if abs(float(np.imag(complex(nominal(np.conj(sides[0]) * sides[1]))))) < FLAT:
        return board.lay_off(one, sides[0], np.abs(other - corner))
    first, second = board.parallel(one, sides[0]), board.parallel(other, sides[1])
    at = board.meet(first, second, Words(f"求 ${letter}$", f"finding ${letter}$"))
    for line in (first, second):
        board.rule(SHEET, line, at)
    return at


def _triangles(draft: Draft, pins: Mapping[str, Points]) -> dict[str, Points]:
    """GEH and MNE similar to BCE."""
    board = draft.board
    board.step(
        Words(
            "在 $GE$ 上作 $△GEH ∽ △BCE$，在 $ME$ 上作 $△MEN ∽ △CBE$（字母顺序的转向相同）。",
            "On $GE$ draw $GEH$ similar to $BCE$, and on $ME$ draw $MEN$ similar to $CBE$, each with the same order of "
            "letters.",
        ),
        SHEET,
    )
    b, c, e = pins["B"], pins["C"], pins["E"]
    h = pin(draft, "H", board.image((b, c, e), (pins["G"], e)))
    n = pin(draft, "N", board.image((c, b, e), (pins["M"], e)))
    return {"H": h, "N": n}


_CHAINS = (  # thinner than the four-bar that is given, each in lines of its own
    ("AGHF", Role.GIVEN),
    ("GEH", Role.GIVEN),
    ("DMNF", Role.OTHER),
    ("MEN", Role.OTHER),
)


def _third_pivot(draft: Draft, pins: Mapping[str, Points]) -> dict[str, Points]:
    """E H F N a parallelogram; ADF similar to BCE as a check."""
    board = draft.board
    board.step(
        Words(
            "作平行四边形 $EHFN$，$F$ 为第三个固定铰链。同源机构为 $AGHF$ 和 $DMNF$，"
            "$E$ 分别是 $GH$、$MN$ 上的连杆点。",
            "Complete the parallelogram $EHFN$: $F$ is the third fixed pivot. The cognates are $AGHF$ and $DMNF$, with "
            "$E$ on the couplers $GH$ and $MN$.",
        ),
        SHEET,
    )
    f = pivot(draft, "F", _fourth(draft, pins["N"], pins["E"], pins["H"], "F"))
    true = board.image((pins["B"], pins["C"], pins["E"]), (pins["A"], pins["D"]))
    off = abs(complex(nominal(true - f)))
    board.remark(
        Words(
            f"校核：$△ADF ∽ △BCE$，由此所得 $F$ 相差 {off:.2f} mm。",
            f" Check: $ADF$ is similar to $BCE$; $F$ found so differs by {off:.2f} mm.",
        )
    )
    for chain, role in _CHAINS:
        for one, two in pairwise(chain):
            board.join(SHEET, {**pins, "F": f}[one], {**pins, "F": f}[two], role)
    return {"F": f}


def _lengths(draft: Draft, pins: Mapping[str, Points]) -> None:
    draft.board.step(Words("由图量得两同源机构各构件长度：", "Measure the lengths of both cognates:"), SHEET)
    for letters in (*LEFT, *RIGHT):
        one, two = letters[0], letters[1]
        spaced = f"{one} {two}"
        on_paper = draft.board.measure(pins[one], pins[two], spaced)
        draft.length(draft.of_this(Named(letters, f"l_{{{letters}}}", "mm")), on_paper, spaced)


@dataclass(frozen=True, slots=True, kw_only=True)
class _Figure:
    """The nominal figure, for scratch paper."""

    pins: Mapping[str, complex]

    @classmethod
    def of(cls, pins: Mapping[str, Points]) -> _Figure:
        return cls(pins={letter: complex(nominal(at)) for letter, at in pins.items()})

    def bar(self, one: str, two: str) -> float:
        """A length that was found."""
        return abs(self.pins[two] - self.pins[one])

    def led(self, turned: float) -> complex | None:
        """E with the crank turned on, C on its side; none where the links do not reach."""
        a, d = self.pins["A"], self.pins["D"]
        b = a + (self.pins["B"] - a) * np.exp(1j * turned)
        c = self._met(b, "B", d, "D", "C")
        if c is None:
            return None
        return complex(b + (self.pins["E"] - self.pins["B"]) / (self.pins["C"] - self.pins["B"]) * (c - b))

    def _met(self, one: complex, letter: str, two: complex, other: str, sought: str) -> complex | None:
        """Two arcs, on the side on which the figure has the pin."""
        pins = self.pins
        left, right = circles_meet(one, self.bar(letter, sought), two, self.bar(other, sought))
        span, place = pins[other] - pins[letter], pins[sought] - pins[letter]
        at = complex(nominal(left if (span.conjugate() * place).imag > 0 else right))
        return at if np.isfinite(at) else None

    def off(self, e: complex) -> float:
        """By how much the couplers of both cognates would have to stretch if E were there; the better assembly."""
        return max(self._gap(e, "A", "G", "H"), self._gap(e, "D", "M", "N"))

    def _gap(self, e: complex, pivot: str, near: str, far: str) -> float:
        ends = [
            circles_meet(self.pins[fixed], self.bar(fixed, moving), e, self.bar("E", moving))
            for fixed, moving in ((pivot, near), ("F", far))
        ]
        wide = [abs(complex(one) - complex(two)) for one in ends[0] for two in ends[1]]
        return float(np.fmin.reduce(np.abs(np.array(wide) - self.bar(near, far))))  # NaN where no two of them meet


def _tried(draft: Draft, figure: _Figure) -> None:
    """The coupler curve over a turn of the crank, and whether both cognates close with E on it."""
    board = draft.board
    board.section(Words("轨迹的校核", "A check of the path"))
    spots = [figure.led(turned) for turned in np.linspace(0, 2 * np.pi, TURN + 1)]
    reached = [at for at in spots if at is not None]
    worst = max(ceil(100 * max(figure.off(at) for at in reached)), 1) / 100  # mm, as far as one can be told
    board.step(
        Words(
            f"曲柄 $AB$ 转一周，描出 $E$ 的轨迹（{len(reached)} 点）。在各点处两同源机构均能闭合，连杆长度相差不超过 "
            f"{worst:.2f} mm，故三者的 $E$ 点轨迹相同。",
            f"Turn the crank $AB$ once and plot the path of $E$ ({len(reached)} points). With $E$ in each of them both "
            f"cognates close, their couplers being off by at most {worst:.2f} mm: all three lead $E$ along one path.",
        ),
        SHEET,
    )
    for reaches, piece in groupby(spots, lambda at: at is not None):
        if reaches and len(places := [np.complex128(at) for at in piece if at is not None]) > 1:
            board.curve(SHEET, places, Role.CENTRE)
