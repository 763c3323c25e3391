"""How large the figure of the centres is drawn:
μ_l where all fit the paper, else a larger one, and which centres stay off the paper."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from math import isclose

from ...board.construction import Scale, View
from ...board.paper.extent import bounds, box_of
from ...board.paper.scales import round_up
from ...board.place import Pane
from ...foundation.slotted import replace
from ...mechanism.asked.centres import Pair
from ...plane import Line, cross, nominal
from ..desk import Desk
from .direct import Direct, normals
from .geometry import NONE, Centre
from .theorem.search import Known, Search, order
from .theorem.trial import best_trial

NAME = "centres"  # of the figure
ROOMS = ((150.0, 185.0), (225.0, 118.0))  # mm that the figure may fill on a page, upright or across
LEAST = 36.0  # mm that the mechanism must measure on it, for its links to be told apart
MARGIN = 8.0  # mm of paper round the figure
SECOND = "μ_l′"  # of a mechanism that is drawn once more to another scale


@dataclass(frozen=True, slots=True, kw_only=True)
class Survey:
    """What a quick sketch shows: the order of search, and where every centre comes to lie (mm on the diagram)."""

    searches: tuple[Search, ...]
    centres: Mapping[Pair, Centre]


@dataclass(frozen=True, slots=True, kw_only=True)
class Paper:
    """The figure's scale, its size against the diagram's, its corners (mm), and the centres that lie beyond; shared:
    whether the diagram is drawn to that scale for its sake."""

    scale: Scale
    factor: float
    corners: tuple[complex, complex]
    far: frozenset[Pair]
    shared: bool = False

    @property
    def told(self) -> str:
        """The figure's scale, with its symbol."""
        return f"${self.scale.symbol}$ = {self.scale.value:g} m/mm"

    def holds(self, at: complex) -> bool:
        """Whether a point lies on the paper."""
        low, high = self.corners
        return low.real <= at.real <= high.real and low.imag <= at.imag <= high.imag


def survey(desk: Desk, direct: tuple[Direct, ...], far: frozenset[Pair] = frozenset()) -> Survey:
    """Find all centres on the nominal sheet, without leaving a mark."""
    plain = tuple(_plain(one) for one in direct)
    known = Known(desk.mech, {one.pair: one.centre for one in plain if one.centre is not None}, normals(plain), far)
    searches = tuple(order(known, desk.board.hand.nominal.square, best_trial))
    return Survey(searches=searches, centres=known.centres)


def paper_for(desk: Desk, direct: tuple[Direct, ...], sharing: float) -> tuple[Paper, Survey]:
    """The paper, and the search on it; a centre stays off it only where two lines on the paper lead to it. sharing: the
    least size of the mechanism (mm) at which the diagram is drawn to the same scale."""
    kept: set[Pair] = set()
    while True:
        seen = survey(desk, direct)
        paper = _paper(desk, seen, kept, sharing)
        seen = survey(desk, direct, paper.far)
        known = Known(desk.mech, dict(seen.centres), normals(direct), paper.far)
        lost = {pair for pair in paper.far if not _crossed(known.on_paper(pair))}
        if not lost:
            return paper, seen
        kept |= lost


def _crossed(lines: tuple[Line, ...]) -> bool:
    """Whether two of the lines meet at an angle that a hand can measure."""
    return max((abs(float(nominal(cross(g.along, h.along)))) for g in lines for h in lines), default=0.0) > NONE


def _paper(desk: Desk, seen: Survey, kept: set[Pair], sharing: float) -> Paper:
    """The scale that the sheet wishes, else the largest round one on which everything fits; the farthest centres are
    left out where the mechanism would become too small on it: whatever is wished, for the sheet was laid out so."""
    low, high = bounds(desk.board.marks(View.MECHANISM))
    middle, size = (low + high) / 2, max(high.real - low.real, high.imag - low.imag)
    mu, wished = desk.board.scales[View.MECHANISM], desk.board.scales.get(Pane(View.MECHANISM, NAME))
    spots = {pair: centre.spot() for pair, centre in seen.centres.items() if not centre.endless}
    inside = sorted(spots, key=lambda pair: (pair not in kept, abs(spots[pair] - middle)))
    while True:
        corners = box_of([low, high, *(spots[pair] for pair in inside)])
        fitting = replace(mu, value=max(mu.value, round_up(mu.value * too_large(corners))))
        shared = is_shared(size / too_large(corners) >= sharing, fitting, mu, wished)
        if shared or set(inside) <= kept or size * mu.value / fitting.value >= min(LEAST, size):
            break
        inside.pop()
    scale = mu if shared else apart(wished or fitting, mu)
    factor = mu.value / scale.value
    margin = complex(MARGIN, MARGIN)
    return Paper(
        scale=scale,
        factor=factor,
        corners=(corners[0] * factor - margin, corners[1] * factor + margin),
        far=frozenset(set(spots) - set(inside)),
        shared=shared,
    )


def is_shared(large: bool, fitting: Scale, mu: Scale, wished: Scale | None) -> bool:
    """Whether both figures have one μ_l: the mechanism is large enough at it, or all fits the diagram as it is, and the
    sheet was not laid out for another."""
    return (wished is None or isclose(wished.value, mu.value)) and (large or isclose(fitting.value, mu.value))


def apart(scale: Scale, mu: Scale) -> Scale:
    """A second scale of lengths beside that of the diagram, by a name of its own where it is another."""
    return replace(scale, symbol=mu.symbol if isclose(scale.value, mu.value) else SECOND)


def too_large(corners: tuple[complex, complex]) -> float:
    """By what factor the figure must shrink to fit one of the rooms."""
    span = corners[1] - corners[0]
    return min(max(span.real / wide, span.imag / high, 1e-6) for wide, high in ROOMS)


def _plain(one: Direct) -> Direct:
    """As the nominal hand sees it."""
    centre, normal = one.centre, one.normal
    if centre is not None:
        centre = Centre(at=centre.spot()) if not centre.endless else Centre(along=centre.way())
    if normal is not None:
        normal = Line(complex(nominal(normal.at)), complex(nominal(normal.along)))
    return replace(one, centre=centre, normal=normal)
