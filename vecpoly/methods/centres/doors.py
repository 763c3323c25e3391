"""The doors of the methods by instant centres."""

from __future__ import annotations

from ...mechanism.asked.centres import Pair
from ...names import Named, Rel
from ...problem.asked.asks import AskPoint
from ..desk import Desk
from ..registry import Door
from .find.motions import Motions
from .find.speeds import Drawn
from .state import CentreFigure
from .theorem.search import Search


def _search(fig: CentreFigure, search: Search) -> None: ...


def _slowest(motions: Motions, ask: AskPoint) -> None: ...


def _limit(desk: Desk, named: Named) -> None: ...


def _ratio(motions: Motions, pair: Pair) -> None: ...


def _velocity(motions: Motions, rel: Rel) -> Drawn | None: ...


SEARCHES, SLOWEST, LIMITS, RATIOS, VELOCITIES = (
    Door(_search),
    Door(_slowest),
    Door(_limit),
    Door(_ratio),
    Door(_velocity),
)
