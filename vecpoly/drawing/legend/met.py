"""By what the kinds of line and symbol of a legend are known."""

from __future__ import annotations

from collections.abc import Callable, Sequence

from ...board.construction import Figure, View
from ...board.paper.marks import Curve, Dot, Mark, Point, Role, Segment
from .letters import is_of_cam, is_of_curvature

Met = Callable[[Figure, Mark], bool]


def in_polygon(figure: Figure) -> bool:
    """Whether vectors are laid end to end on it."""
    return not figure.view.bodies and figure.view is not View.MECHANISM and figure.view.across is None


def traced(role: Role, *types: type[Mark]) -> Met:
    """Whether it is a line of these, drawn for this reason."""
    return lambda _, mark: isinstance(mark, types) and getattr(mark, "role", None) is role


def dotted(dot: Dot) -> Met:
    """Whether it is a point drawn so."""
    return lambda _, mark: isinstance(mark, Point) and mark.dot is dot


def in_centre_polygon(figure: Figure) -> bool:
    """Whether its sides are instant centres."""
    return figure.name == "centre polygon"


def of_profile(role: Role) -> Met:
    """Whether it is the pitch curve of a cam, or its profile beside that."""
    return lambda figure, mark: (
        isinstance(mark, Curve)
        and mark.role is role
        and is_of_cam(figure)
        and {Role.HIDDEN, Role.LINK} <= {one.role for one in figure.marks if isinstance(one, Curve)}
    )


def on_curvature(role: Role, *types: type[Mark]) -> Met:
    """The same on a curvature drawing."""
    drawn = traced(role, *types)
    return lambda figure, mark: drawn(figure, mark) and is_of_curvature(figure)


def imagined(figure: Figure, mark: Mark) -> bool:
    """Whether it is dashed and fine, and no link in another position."""
    if not isinstance(mark, Segment) or mark.role is not Role.HIDDEN or in_centre_polygon(figure):
        return False
    return not of_rotor(figure) and not any(getattr(one, "role", None) is Role.OTHER for one in figure.marks)


def of_rotor(figure: Figure) -> bool:
    """Whether it shows the masses of a rotor from its end."""
    return figure.view.name == "end-view"


def area(points: Sequence[complex]) -> float:
    """Of a polygon, mm²."""
    return abs(sum((a.conjugate() * b).imag for a, b in zip(points, (*points[1:], *points[:1]), strict=True))) / 2


def has_lobes(figure: Figure) -> bool:
    """Whether areas between two curves of moments are hatched on it, one of them A_1."""
    return any(isinstance(mark, Point) and mark.label == "A_1" for mark in figure.marks)
