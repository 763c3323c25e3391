"""Four positions: a fixed pin by trial on its line, until its four inverted places lie on one circle (Burmester)."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from math import inf

import numpy as np

from ....board.paper.marks import Role
from ....designs.inversion.plan import CentrePoints, On
from ....designs.inversion.refusals import no_centre_point
from ....foundation.frozen import FrozenMap
from ....foundation.slotted import replace
from ....plane import Line, Points, Reals, lines_meet, nominal
from ....words import Words
from ..draft import SHEET
from ..linkage import pin, pivot
from .curve import centre_point_curve
from .sheet import Places, Sheet, placed
from .trial import centre_places

SHORT, FLAT = 1e-6, 1e-9  # mm, sine: no chord, no meeting

_BY_TRIAL = Words(
    "在给定直线上试取固定铰链 $M$，取平面 $S$ 的位置 1 为“机架”，将 $M$ 随 $S$ 反转，得 $M_2^′$、$M_3^′$、$M_4^′$。"
    "过 $M$、$M_2^′$、$M_3^′$ 作圆，$M_4^′$ 到圆周的偏差随 $M$ 而变；偏差为零处即圆心点，圆心即圆点 $N_1$。",
    "Try a fixed pin $M$ on the given line. Take the body $S$ in position 1 for the frame and turn $M$ back with it: "
    "$M_2^′$, $M_3^′$, $M_4^′$. How far $M_4^′$ is off the circle through $M$, $M_2^′$, $M_3^′$ changes with $M$; "
    "where it is on it, $M$ is a centre point, the centre of the circle its circle point $N_1$.",
)
_AGAIN = Words(
    "在另一给定直线上同样试取固定铰链 $M$，求其上的圆心点和圆点。",
    "Try the fixed pin $M$ on the other given line in the same way, for the centre points and circle points there.",
)


@dataclass(frozen=True, slots=True, kw_only=True)
class Bar:
    """A fixed pin that was found, its moving pin in all positions, and their number on the sheet."""

    number: int
    fixed: Points
    moving: Places


def centre_points(sheet: Sheet, stage: CentrePoints) -> Iterator[Sheet]:
    """All bars of both lines, then every pair of them."""
    sheet.draft.board.section(Words("圆心点和圆点", "Centre points and circle points"))
    sheet.draft.board.step(_BY_TRIAL, SHEET)
    first = _bars(sheet, stage, stage.lies[0], 0)
    same = stage.lies[0] == stage.lies[1]
    if not same:
        sheet.draft.board.step(_AGAIN, SHEET)
    second = first if same else _bars(sheet, stage, stage.lies[1], len(first))
    pairs = [(a, d) for a in first for d in second if (a.number < d.number if same else _apart(a, d))]
    if not pairs:
        raise no_centre_point(stage, len(first) + (0 if same else len(second)), sheet.draft.valid)
    sheet.draft.paired([{stage.one[0]: a.fixed, stage.two[0]: d.fixed} for a, d in pairs])
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
    line = _line(sheet, on)
    found = centre_places(line, sheet.bodies[stage.on])
    return [_bar(sheet, stage, line, t, before + n) for n, t in enumerate(found, 1)]


def _line(sheet: Sheet, on: On) -> Line:
    at = on.through - on.along * (on.along.conjugate() * on.through).real
    return sheet.draft.board.parallel(placed(sheet.draft, at), np.complex128(on.along))


def _bar(sheet: Sheet, stage: CentrePoints, line: Line, t: Reals, number: int) -> Bar:
    """One centre point, its inverted places, and the circle point where their bisectors meet, in all positions."""
    draft, board = sheet.draft, sheet.draft.board
    here, label = f"M^{{({number})}}", f"N^{{({number})}}"
    board.step(
        Words(
            f"将圆心点 ${here}$ 反转三次，作中垂线，交点为圆点 ${label}_1$。",
            f"Turn the centre point ${here}$ back three times; the bisectors meet at the circle point ${label}_1$.",
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
    """The two chords of the four places whose bisectors tell the centre best."""
    spots = [complex(nominal(at)) for at in seen]
    pairs = [(i, j) for i in range(4) for j in range(i + 1, 4) if abs(spots[j] - spots[i]) > SHORT]
    best = min(
        ((one, two) for one in pairs for two in pairs if one < two),
        key=lambda both: _doubt(*((spots[i], spots[j]) for i, j in both)),
    )
    return [(seen[i], seen[j]) for i, j in best]


def _doubt(one: tuple[complex, complex], two: tuple[complex, complex]) -> float:
    """How far off their meeting may be, in errors of one place: a bisector turns about the middle of its chord, the
    more the shorter that is, and flat meetings run away."""
    u, v = one[1] - one[0], two[1] - two[0]
    sine = abs((u.conjugate() * v).imag) / (abs(u) * abs(v))
    if sine < FLAT:
        return inf
    middle, other = sum(one) / 2, sum(two) / 2
    centre = complex(lines_meet(Line(middle, 1j * u), Line(other, 1j * v)))
    return (2 + 2 * abs(centre - middle) / abs(u) + 2 * abs(centre - other) / abs(v)) / sine
