"""What is asked but was needed by no equation:
points given by their vectors, points under which a link only passes, components."""

from __future__ import annotations

from collections.abc import Sequence

from ...board.construction import View
from ...errors import NotAskedError
from ...mechanism.model import FRAME
from ...names import At, Kind
from ...problem.asked.asks import Ask, AskPoint, AskRel
from ...words import Words
from ..desk import VECTOR, Desk
from .components import draw_components
from .given_vector import find_point
from .image import imaged


def draw_wanted(desk: Desk, asks: Sequence[Ask], view: View) -> None:
    """All of this on one polygon."""
    velocity = view is View.VELOCITY
    for ask in asks:
        if isinstance(ask, AskPoint) and ask.slowest is None and (ask.velocity is not None) == velocity:
            find_point(desk, ask)
    rels = [ask.rel for ask in asks if isinstance(ask, AskRel)]
    for rel in rels:
        if rel.kind is VECTOR[view]:
            for at in filter(None, (rel.to, rel.ref)):
                _ensure(desk, view, at)
    if velocity:
        return
    for rel in rels:
        if rel.kind is Kind.V:
            _ensure(desk, View.VELOCITY, rel.to)
        elif rel.kind in (Kind.AN, Kind.AT):
            draw_components(desk, rel)


def _ensure(desk: Desk, view: View, at: At) -> None:
    if not at.link or desk.has_tip(view, at) or not {at.point, str(at)} & set(desk.at):
        return
    if at.link == FRAME:
        raise NotAskedError(
            Words(
                f"{at} 是机架上的点，没有速度和加速度；请勿求它",
                f"{at} is a point of the frame and rests; do not ask for it",
            ),
            code="of-the-frame",
        )
    imaged(desk, view, at.link, desk.canonical(at))
