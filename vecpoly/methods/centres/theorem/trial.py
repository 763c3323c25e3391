"""A centre of a link none of whose centres lies on two known lines (Ⅲ级杆组):
one trial triangle gives the line that is missing.

P_ka, P_kb, P_kc lie on one known line each, and P_ab, P_bc, P_ac, which are known, lie on one line. Triangles with two
corners on the lines of P_ka and P_kb and with sides through P_ab, P_ac, P_bc have their third corner on a fixed line
(Desargues); it passes through the meeting of the lines of P_ka and P_kb, the triangle that has shrunk to a point. So
one trial gives this line, and it cuts the line of P_kc in P_kc.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from itertools import permutations

import numpy as np

from ....plane import Line, nominal
from ..geometry import Centre, meeting, same, sharpness, through
from .search import Known, Search, Way

OFFSETS = (
    25.0,
    -25.0,
    50.0,
    -50.0,
    90.0,
    -90.0,
)  # mm along its line, from the meeting of the two lines, at which P_ka is tried


@dataclass(frozen=True, slots=True, kw_only=True)
class Trial:
    """P_kc is sought; lines: on which P_ka, P_kb, P_kc lie; corners:
    x, y, z of the trial triangle; start: where the first two lines meet."""

    link: str
    others: tuple[str, str, str]
    ways: tuple[Way, Way, Way]
    start: Centre
    corners: tuple[Centre, Centre, Centre]

    @property
    def locus(self) -> Line | None:
        """The line of all third corners; None where the trial does not give it."""
        return _line(self.corners[2], self.start)


def best_trial(known: Known) -> Search | None:
    """The trial triangle whose line cuts best; None where no link has three such centres."""
    found = [trial for link in known.rank for trial in _trials(known, link)]
    best = max(found, key=_quality, default=None)
    if best is None or _quality(best) < 1e-6:
        return None
    c = best.others[2]
    return Search(
        pair=known.pair(best.link, c),
        ways=(best.ways[2], Way(via="", line=best.locus)),
        quality=_quality(best),
        trial=(best.link, best.others, offset_of(best)),
    )


def _quality(trial: Trial) -> float:
    """How well the line of third corners is found, and meets the line of P_kc."""
    locus, start, corner = trial.locus, trial.start, trial.corners[2]
    if locus is None or not all(corner.at is None or np.isfinite(corner.spot()) for corner in trial.corners):
        return 0.0
    base = 1.0 if start.endless or corner.endless else min(1.0, abs(start.spot() - corner.spot()) / 25.0)
    size = max((abs(one.spot()) for one in trial.corners if not one.endless), default=0.0)
    return sharpness(locus, trial.ways[2].line) * base * min(1.0, 400.0 / (size or 1.0))


def _trials(known: Known, link: str) -> Iterator[Trial]:
    """For every three other links that know each other, and with each of which this one has a line."""
    lines: dict[str, Way] = {}
    for other in known.rank:
        if other != link and known.pair(link, other) not in known.centres:
            way = next((way for way in known.ways(known.pair(link, other)) if way.line is not None), None)
            lines |= {other: way} if way is not None else {}
    for others in permutations(lines, 3):
        pairs = [known.pair(others[i], others[j]) for i, j in ((0, 1), (1, 2), (0, 2))]
        if others[0] < others[1] and all(pair in known.centres for pair in pairs):
            ways = (lines[others[0]], lines[others[1]], lines[others[2]])
            yield from (
                trial for offset in OFFSETS if (trial := trial_at(known, link, others, ways, offset)) is not None
            )


def _line(a: Centre, b: Centre) -> Line | None:
    """The line through two centres; None where they are one, or both at infinity."""
    return None if same(a, b) else through(a, b)


def trial_at(
    known: Known, link: str, others: tuple[str, str, str], ways: tuple[Way, Way, Way], offset: float
) -> Trial | None:
    """The triangle whose first corner stands this far along its line."""
    a, b, c = others
    g, h = ways[0].line, ways[1].line
    if g is None or h is None or ways[2].line is None:
        return None
    endless = sharpness(g, h) <= 1e-6
    start = meeting(g, h, endless)
    x = Centre(at=(g.at if start.at is None else start.at) + g.along * offset)
    side = _line(x, known.of(a, b))
    if side is None or sharpness(side, h) <= 1e-6:
        return None
    y = meeting(side, h, False)
    one, two = _line(x, known.of(a, c)), _line(y, known.of(b, c))
    if one is None or two is None or sharpness(one, two) <= 1e-6:
        return None
    return Trial(link=link, others=others, ways=ways, start=start, corners=(x, y, meeting(one, two, False)))


def offset_of(trial: Trial) -> float:
    g, x = trial.ways[0].line, trial.corners[0]
    assert g is not None
    foot = complex(nominal(g.at)) if trial.start.endless else trial.start.spot()
    return float((np.conj(complex(nominal(g.along))) * (x.spot() - foot)).real)
