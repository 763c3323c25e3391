"""The figures of a sheet: of which kind one is, and which of several."""

from __future__ import annotations

from dataclasses import field

from ..figures import View, view_named, views
from ..foundation.slotted import dataclass

__all__ = ["Pane", "Place", "View", "called", "named", "view_named", "view_of", "views"]


@dataclass(frozen=True, slots=True)
class Pane:
    """One of several figures of a kind: the free body of link 3, the force polygon of links 2 and 3.

    aside: it lies beside the figures of its kind (a lever, a polygon of centres),
    and does not tell how large they are to be drawn.
    """

    view: View
    name: str
    aside: bool = field(default=False, compare=False)


Place = View | Pane  # where a mark stands: the only figure of its kind, or one of several


def called(place: Place) -> str:
    """The figure in a key: its kind, and its name where there are several, ``velocity``, ``force 23``."""
    return f"{place.view.name} {place.name}" if isinstance(place, Pane) else place.name


def named(place: Place | None, key: str) -> tuple[str, ...]:
    """The names of something on a figure: with the figure before it, and without."""
    return (key,) if place is None else (f"{called(place)}:{key}", key)


def view_of(place: Place) -> View:
    """The kind of figure."""
    return place.view if isinstance(place, Pane) else place
