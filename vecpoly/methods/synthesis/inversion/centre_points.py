"""Four positions: a fixed pin by trial on its line, until its four inverted places lie on one circle (Burmester)."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from itertools import pairwise

import numpy as np

from ....board.paper.marks import Role
from ....designs.inversion.plan import CentrePoints, On
from ....designs.inversion.refusals import no_centre_point
from ....foundation.frozen import FrozenMap
from ....plane import Line, Points, nominal
from ....words import Words
from ...roots import Curve, halved
from ..draft import SHEET
from ..linkage import pin, pivot
from .curve import centre_point_curve
from .sheet import Places, Sheet, Stands, placed

TRIALS = 2000  # over the whole line, denser where the figure is
REFINED = 80  # halvings
FAR = 1e6  # mm: a pin beyond serves no drawing


@dataclass(frozen=True, slots=True, kw_only=True)
class Bar:
    """A fixed pin that was found, its moving pin in all positions, and their number on the sheet."""

    number: int
    fixed: Points
    moving: Places


def centre_points(sheet: Sheet, stage: CentrePoints) -> Iterator[Sheet]:
    """All bars of both lines, then every pair of them."""
    first = _bars(sheet, stage, stage.lies[0], 0)
    same = stage.lies[0] == stage.lies[1]
    second = first if same else _bars(sheet, stage, stage.lies[1], len(first))
    pairs = [(a, d) for a in first for d in second if (a.number < d.number if same else _apart(a, d))]
    if not pairs:
        raise no_centre_point(stage, len(first) + (0 if same else len(second)))
    bars = {bar.number: bar for bar in (*first, *second)}
    centre_point_curve(sheet, stage.on, {f"M^{{({number})}}": bar.fixed for number, bar in bars.items()})
    for a, d in pairs:
        yield _paired(sheet, stage, a, d)


def _apart(one: Bar, other: Bar) -> bool:
    return abs(complex(nominal(one.fixed - other.fixed))) > 1e-6


def _paired(sheet: Sheet, stage: CentrePoints, *bars: Bar) -> Sheet:
    after = sheet
    labels: dict[str, str] = {}
    for (fixed, moving), bar in zip((stage.one, stage.two), bars, strict=True):
        after = after.with_pin(fixed, (bar.fixed,) * sheet.plan.count).with_pin(moving, bar.moving)
        labels |= {fixed: f"M^{{({bar.number})}}", moving: f"N^{{({bar.number})}}"}
    return replace(after, labels=FrozenMap(labels))


def _bars(sheet: Sheet, stage: CentrePoints, on: On, before: int) -> list[Bar]:
    board = sheet.draft.board
    board.section(Words("圆心点和圆点", "Centre points and circle points"))
    board.step(
        Words(
            "在给定直线上试取固定铰链 $M$，取平面 $S$ 的位置 1 为“机架”，将 $M$ 随 $S$ 反转，"
            "得 $M_2^′$、$M_3^′$、$M_4^′$。"
            "过 $M$、$M_2^′$、$M_3^′$ 作圆，$M_4^′$ 到圆周的偏差随 $M$ 而变；"
            "偏差为零处即圆心点，圆心即圆点 $N_1$。",
            "Try a fixed pin $M$ on the given line. Take the body $S$ in position 1 for the frame and turn $M$ "
            "back with it: $M_2^′$, $M_3^′$, $M_4^′$. How far $M_4^′$ is off the circle through $M$, $M_2^′$, $M_3^′$ "
            "changes with $M$; where it is on it, $M$ is a centre point, the centre of the circle its circle point "
            "$N_1$.",
        ),
        SHEET,
    )
    line = _line(sheet, on)
    spots = [Stands(start=nominal(at.start), end=nominal(at.end)) for at in sheet.bodies[stage.on]]
    found = [t for t in _zeros(lambda t: _off(spots, complex(nominal(line.at + t * line.along)))) if abs(t) < FAR]
    return [_bar(sheet, stage, line, t, before + n) for n, t in enumerate(found, 1)]


def _line(sheet: Sheet, on: On) -> Line:
    at = on.through - on.along * (on.along.conjugate() * on.through).real
    return sheet.draft.board.parallel(placed(sheet.draft, at), np.complex128(on.along))


def _off(spots: Sequence[Stands], m: complex) -> float:
    """The power of M₄′ to the circle through the other three, times the area of their triangle, on scratch paper."""
    first = spots[0]
    seen = [first.start + (m - at.start) / (at.end - at.start) * (first.end - first.start) for at in spots]
    u, v, w = (complex(place - seen[0]) for place in seen[1:])
    centre = 1j * (u * abs(v) ** 2 - v * abs(u) ** 2)
    area = 2 * (u.conjugate() * v).imag
    return float(area * abs(w) ** 2 - 2 * (w.conjugate() * centre).real)


def _zeros(of: Curve) -> list[float]:
    """Every place along the line where the deviation changes its sign; u → t = 100 tan u covers the whole line."""

    def at(u: float) -> float:
        return 100 * float(np.tan(u))

    def off(u: float) -> float:
        return of(at(u))

    places = [float(u) for u in np.linspace(-np.pi / 2, np.pi / 2, TRIALS + 2)[1:-1]]
    tried = [(u, off(u)) for u in places]
    return [at(halved(off, low, high, REFINED)) for (low, a), (high, b) in pairwise(tried) if a * b < 0]


def _bar(sheet: Sheet, stage: CentrePoints, line: Line, t: float, number: int) -> Bar:
    """One centre point, its inverted places, and the circle point where their bisectors meet, in all positions."""
    draft, board = sheet.draft, sheet.draft.board
    here, label = f"M^{{({number})}}", f"N^{{({number})}}"
    board.step(
        Words(
            f"圆心点 ${here}$：反转三次，作中垂线，交点为圆点 ${label}_1$。",
            f"Centre point ${here}$: turned back three times; the bisectors meet in the circle point ${label}_1$.",
        ),
        SHEET,
    )
    fixed = pivot(draft, here, board.lay_off(line.at, line.along, t))
    board.rule(SHEET, line, fixed)
    seen = [fixed, *(sheet.carried(fixed, stage.on, n, 0, here) for n in range(1, sheet.plan.count))]
    first, second = (_between(sheet, one, two) for one, two in _chosen(seen))
    at = board.meet(first, second, Words(f"求 ${label}$", f"finding ${label}$"))
    for bisector in (first, second):
        board.rule(SHEET, bisector, at)
    places = [at, *(sheet.carried(at, stage.on, 0, n, label) for n in range(1, sheet.plan.count))]
    return Bar(
        number=number, fixed=fixed, moving=tuple(pin(draft, f"{label}_{n}", place) for n, place in enumerate(places, 1))
    )


def _between(sheet: Sheet, one: Points, two: Points) -> Line:
    sheet.draft.board.join(SHEET, one, two, Role.CONSTRUCTION)
    return sheet.draft.board.bisector(SHEET, one, two)


def _chosen(seen: list[Points]) -> list[tuple[Points, Points]]:
    """The two chords of the four places whose bisectors cross best."""
    spots = [complex(nominal(at)) for at in seen]
    pairs = [(i, j) for i in range(4) for j in range(i + 1, 4) if abs(spots[j] - spots[i]) > 1e-6]
    best = max(
        ((one, two) for one in pairs for two in pairs if one < two),
        key=lambda both: _sine(*(spots[j] - spots[i] for i, j in both)),
    )
    return [(seen[i], seen[j]) for i, j in best]


def _sine(u: complex, v: complex) -> float:
    return abs((u.conjugate() * v).imag) / (abs(u) * abs(v))
