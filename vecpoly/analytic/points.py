"""The further lettered points of links that are located: from one of their points, by the link's angle and rates."""

from __future__ import annotations

from ..names import subscripted
from ..words import Words
from .equations import Part, Stage
from .stages import ACCELERATION, POSITION, VELOCITY
from .variables import Scope, both


def points(scope: Scope, links: tuple[str, ...]) -> tuple[Stage, ...]:
    """Position, velocity and acceleration of the letters that the links carry beside those located;
    nothing without any."""
    new = scope.further(links)
    if not new:
        return ()
    names = (
        "、".join(f"${subscripted(letter)}$" for _, _, letter in new),
        ", ".join(f"${subscripted(letter)}$" for _, _, letter in new),
    )
    said = Words(f"构件上 {names[0]} 点：", f"Points {names[1]}:" if len(new) > 1 else f"Point {names[1]}:")
    place = [e for link, start, end in new for e in both(scope.xy(end), scope.place(link, start, end))]
    velocity = [e for link, start, end in new for e in both(scope.v(end), scope.velocity(link, start, end))]
    acceleration = [e for link, start, end in new for e in both(scope.a(end), scope.acceleration(link, start, end))]
    return tuple(
        Stage(title, (Part(said, tuple(rows)),))
        for title, rows in ((POSITION, place), (VELOCITY, velocity), (ACCELERATION, acceleration))
    )
