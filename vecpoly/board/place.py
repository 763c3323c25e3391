"""The figures of a sheet: of which kind one is, and which of several."""

from __future__ import annotations

from dataclasses import dataclass
from enum import StrEnum


class View(StrEnum):
    """The kinds of figure on a sheet."""

    MECHANISM = "mechanism"
    VELOCITY = "velocity"
    ACCELERATION = "acceleration"
    BODY = "body"  # a link drawn apart, with the forces on it
    FORCE = "force"  # a force polygon


@dataclass(frozen=True, slots=True)
class Pane:
    """One of several figures of a kind: the free body of link 3, the force polygon of links 2 and 3."""

    view: View
    name: str


Place = View | Pane  # where a mark stands: the only figure of its kind, or one of several


def called(place: Place) -> str:
    """The figure in a key: its kind, and its name where there are several, ``velocity``, ``force 23``."""
    return f"{place.view.value} {place.name}" if isinstance(place, Pane) else place.value


def view_of(place: Place) -> View:
    """The kind of figure."""
    return place.view if isinstance(place, Pane) else place
