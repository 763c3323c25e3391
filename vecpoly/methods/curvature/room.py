"""How large the figures of the curvatures are drawn: on one where all fits, on two where points lie far off."""

from __future__ import annotations

from collections.abc import Callable, Mapping

from ...board.construction import View
from ...board.paper.extent import bounds, box_of
from ...board.paper.scales import HALF, SERIES, round_up
from ...board.paper.titled import CURVATURES
from ...board.place import Pane, Place
from ...foundation.slotted import dataclass, replace
from ...plane import Points, nominal
from ..centres.size import MARGIN, Paper, apart, is_shared, too_large
from ..desk import Desk
from .state import CurvatureFigure, Off

NAME, FAR = "curvature", "curvature-far"
LEAST = 22.0  # mm that the mechanism must measure on the figure, for its links to be told apart
AMPLE = 2.4  # times as large the mechanism is on the first of two figures, where this can be
GROWN = 0.1  # of the box of what lies on the first figure: lines that end so near beyond it stay on it
REDUCED = 1000.0  # times smaller than the first the second figure may be, no more
SCALES = tuple(sorted((*SERIES, HALF)))  # 1 : 1.5 and its like among them
Box = tuple[complex, complex]
Draw = Callable[[CurvatureFigure], None]


@dataclass(frozen=True, slots=True, kw_only=True)
class Room:
    """The paper of the figure, and where all does not fit on it: of the second, which points are found there (`names`),
    and beyond which corners of the first (mm on the diagram) lines are drawn there."""

    paper: Paper
    second: Paper | None = None
    names: frozenset[str] = frozenset()
    corners: Box = (0j, 0j)

    def off(self, pane: Place) -> Off | None:
        """What lies off the paper of the first, if anything does."""
        if self.second is None:
            return None
        ratio, factor = self.second.factor / self.paper.factor, self.paper.factor
        low, high = self.corners
        return Off(pane=pane, ratio=ratio, names=self.names, corners=(low * factor, high * factor))


@dataclass(frozen=True, slots=True, kw_only=True)
class Wanted:
    """What is to be drawn (`draw`) of a link, beside a mechanism in this box (mm on the diagram) that must measure
    `least` mm at least; sharing: at which least size (mm) the diagram is drawn to the same scale; reduced: how many
    times smaller than the first a second figure may be."""

    desk: Desk
    link: str
    draw: Draw
    box: Box
    sharing: float
    least: float = LEAST
    reduced: float = REDUCED

    def one(self, box: Box) -> Paper | None:
        """The paper of a figure in this box; None where the mechanism would be too small on it."""
        return fitted(self.desk, self.box, box, self.sharing, least=self.least)


def room_for(want: Wanted) -> Room | None:
    """The paper on which pole, circle and centres fit with the mechanism; where they do not, that of a second figure
    too; None where two do not hold it all."""
    whole = sketched(want)
    told = Pane(View.MECHANISM, FAR) in want.desk.board.scales  # the sheet was laid out for two
    one = None if told else want.one(bounds(whole.board.marks(whole.pane)))
    if one is not None:
        return Room(paper=one)
    return _divided(want, whole.spots, AMPLE * want.least) or _divided(want, whole.spots, want.least)


def _divided(want: Wanted, spots: Mapping[str, complex], least: float) -> Room | None:
    """The points that lie farthest off are left to the second figure, as few as must be for the mechanism to measure
    `least` on the first."""
    low, high = mechanism = box_of([complex(nominal(at)) for at in want.desk.at.values()])
    near = sorted(spots, key=lambda name: abs(spots[name] - (low + high) / 2))
    while near:
        del near[-1]
        box = box_of([low, high, *(spots[name] for name in near)])
        grown = (box[1] - box[0]) * GROWN
        corners = (box[0] - grown, box[1] + grown)
        if _size(mechanism) / too_large(corners) >= least:
            return _on_two(want, frozenset(spots) - frozenset(near), corners)
    return None


def _on_two(want: Wanted, names: frozenset[str], corners: Box) -> Room | None:
    """The papers of both figures; None where the second would be too much smaller than the first."""
    rough = Paper(scale=want.desk.board.scales[View.MECHANISM], factor=1.0, corners=corners, far=frozenset())
    room = Room(paper=rough, second=rough, names=names, corners=corners)
    sketch = sketched(want, room)
    assert sketch.off is not None
    one = replace(want, least=0.0).one(bounds(sketch.board.marks(sketch.pane)))
    assert one is not None
    second = _second(want, bounds(sketch.board.marks(sketch.off.pane)), one)
    return None if second is None else replace(room, paper=one, second=second)


def _size(box: Box) -> float:
    span = box[1] - box[0]
    return max(span.real, span.imag)


def _second(want: Wanted, box: Box, one: Paper) -> Paper | None:
    """The paper of the second figure; None where it would be too much smaller than the first."""
    desk = want.desk
    mu, wished = desk.board.scales[View.MECHANISM], desk.board.scales.get(Pane(View.MECHANISM, FAR))
    own = replace(mu, value=max(one.scale.value, round_up(mu.value * too_large(box), SCALES)))
    if own.value > want.reduced * one.scale.value:
        return None
    scale = apart(wished or own, mu)
    return Paper(scale=scale, factor=mu.value / scale.value, corners=box, far=frozenset())


def sketched(want: Wanted, room: Room | None = None) -> CurvatureFigure:
    """All that is constructed, at the diagram's scale, as an exact hand sketches it."""
    desk = want.desk
    at: dict[str, Points] = {name: complex(nominal(spot)) for name, spot in desk.at.items()}
    sketch = replace(desk, board=desk.board.scratch(), at=at)
    pane = sketch.board.open_pane(View.MECHANISM, NAME, CURVATURES, aside=True)
    off = None if room is None else room.off(sketch.board.open_pane(View.MECHANISM, FAR, CURVATURES, aside=True))
    fig = CurvatureFigure(desk=sketch, link=want.link, pane=pane, factor=1.0, off=off)
    want.draw(fig)
    return fig


def fitted(
    desk: Desk, mechanism: Box, box: Box, sharing: float, name: str = NAME, least: float = LEAST
) -> Paper | None:
    """The scale that the sheet wishes, else the largest round one, no larger than the diagram's; None where the
    mechanism would be smaller on it than `least` (mm)."""
    box, size = box_of([*box, *mechanism]), _size(mechanism)
    mu = desk.board.scales[View.MECHANISM]
    wished = desk.board.scales.get(Pane(View.MECHANISM, name))
    own = replace(mu, value=max(mu.value, round_up(mu.value * too_large(box), SCALES)))
    shared = is_shared(size / too_large(box) >= sharing, own, mu, wished)
    tried = (mu,) if shared else tuple(apart(one, mu) for one in (wished, own) if one is not None)
    fitting = (one for one in tried if size * mu.value / one.value >= min(least, size))
    if (scale := next(fitting, None)) is None:
        return None
    factor, margin = mu.value / scale.value, complex(MARGIN, MARGIN)
    corners = (box[0] * factor - margin, box[1] * factor + margin)
    return Paper(scale=scale, factor=factor, corners=corners, far=frozenset(), shared=shared)
