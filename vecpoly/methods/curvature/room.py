"""How large the figure of the curvatures is drawn, and what to say where it does not fit a sheet."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from math import degrees, inf, radians

from ...board.construction import View
from ...board.paper.extent import bounds, box_of
from ...board.paper.scales import HALF, SERIES, round_up
from ...board.place import Pane
from ...errors import NotAskedError, VecpolyError
from ...plane import Points, nominal
from ...words import Words
from ..centres.size import MARGIN, Paper, apart, is_shared, too_large
from ..desk import Desk
from ..positions.placed import placed_as_told
from .state import CurvatureFigure

NAME = "curvature"
TITLE = Words("曲率作图", "Curvatures")
STEPS = (5, -5, 10, -10, 15, -15, 20, -20, 30, -30, 40, -40, 50, -50, 60, -60, 80, -80, 100, -100, 120, -120, 150, 180)
FINE, MOST = 5.0, 36  # deg, how many of them: the steps by which a range is followed
LEAST = 22.0  # mm that the mechanism must measure on the figure, for its links to be told apart
EASY = 1.25  # times as large it must be where a position is recommended: what is lettered does not shrink with it
SCALES = tuple(sorted((*SERIES, HALF)))  # 1 : 1.5 and its like among them
Box = tuple[complex, complex]
Draw = Callable[[CurvatureFigure], None]


def paper_for(desk: Desk, link: str, draw: Draw, sharing: float) -> Paper:
    """The paper on which pole, circle and centres fit with the mechanism. sharing: the least size of the mechanism (mm)
    at which the diagram is drawn to the same scale.

    Raises NotAskedError where the mechanism would become too small, with a position in which it would not.
    """
    found = fitted(desk, _box(desk, link, draw), sharing)
    if found is None:
        raise _refused(desk, link, draw)
    return found


def _refused(desk: Desk, link: str, draw: Draw) -> NotAskedError:
    """With the range of the drive, about the nearest position of those tried, in which all fits."""

    def fits(phi: float) -> bool:
        try:
            box = _box(placed_as_told(desk, radians(phi)), link, draw)
            return fitted(desk, box, inf, least=EASY * LEAST) is not None
        except VecpolyError:
            return False

    here = degrees(desk.mech.drive.position)
    steps = () if desk.mech.drive.slide or desk.thought else STEPS
    other = next((round(here + step, 6) for step in steps if fits(here + step)), None)
    if other is None:
        return NotAskedError(_off_the_sheet(None), code="off-the-sheet")
    low, high = (_end(fits, other, sense * FINE) for sense in (-1, 1))
    return NotAskedError(_off_the_sheet((low, high)), code="off-the-sheet", numbers={"from": low, "to": high})


def _end(fits: Callable[[float], bool], phi: float, step: float) -> float:
    """How far one may go on by these steps."""
    for _ in range(MOST):
        if not fits(phi + step):
            break
        phi += step
    return phi


def _box(desk: Desk, link: str, draw: Draw) -> Box:
    """The corners (mm on the diagram) of all that is constructed, as an exact hand sketches it."""
    at: dict[str, Points] = {name: complex(nominal(spot)) for name, spot in desk.at.items()}
    sketch = replace(desk, board=desk.board.scratch(), at=at)
    pane = sketch.board.open_pane(View.MECHANISM, NAME, TITLE, aside=True)
    draw(CurvatureFigure(desk=sketch, link=link, pane=pane, factor=1.0))
    return bounds(sketch.board.marks(pane))


def fitted(desk: Desk, box: Box, sharing: float, name: str = NAME, least: float = LEAST) -> Paper | None:
    """The scale that the sheet wishes, else the largest round one, no larger than the diagram's; None where the
    mechanism would be smaller on it than `least` (mm)."""
    low, high = bounds(desk.board.marks(View.MECHANISM))
    box, size = box_of([*box, low, high]), max(high.real - low.real, high.imag - low.imag)
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


def _off_the_sheet(fitting: tuple[float, float] | None) -> Words:
    words = Words(
        "瞬心、拐点圆或曲率中心远在图纸之外，机构将小到无法作图",
        "the pole, the inflection circle or a centre of curvature lies far off the sheet; the mechanism would be too "
        "small to be drawn",
    )
    if fitting is None:
        return words + Words("；请另取原动件位置", "; choose another input position")
    low, high = fitting
    if high - low < FINE:
        return words + Words(f"；可取 φ = {low % 360:g}°", f"; φ = {low % 360:g}° would do")
    return words + Words(
        f"；可取 φ = {low % 360:g}° 至 {high % 360:g}°", f"; φ from {low % 360:g}° to {high % 360:g}° would do"
    )
