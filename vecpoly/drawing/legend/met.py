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
    """Whether it is dashed and fine, and none of what the other kinds have."""
    if not _fine(mark) or in_centre_polygon(figure) or of_rotor(figure):
        return False
    taken = in_axial_view(figure, mark) or to_counterweight(figure, mark)
    return not taken and not any(getattr(one, "role", None) is Role.OTHER for one in figure.marks)


def in_axial_view(figure: Figure, mark: Mark) -> bool:
    """Whether it is a plane of a rotor that is seen from its side."""
    return _fine(mark) and figure.title.zh == "轴向简图"


def to_counterweight(figure: Figure, mark: Mark) -> bool:
    """Whether it leads to a mass that is hung on a link."""
    return _fine(mark) and any(isinstance(one, Point) and one.label.startswith("m_{c") for one in figure.marks)


def _fine(mark: Mark) -> bool:
    return isinstance(mark, Segment) and mark.role is Role.HIDDEN


def of_rotor(figure: Figure) -> bool:
    """Whether it shows the masses of a rotor from its end."""
    return figure.view.name == "end-view"


def area(points: Sequence[complex]) -> float:
    """Of a polygon, mm²."""
    return abs(sum((a.conjugate() * b).imag for a, b in zip(points, (*points[1:], *points[:1]), strict=True))) / 2


def has_lobes(figure: Figure) -> bool:
    """Whether areas between two curves of moments are hatched on it, one of them A_1."""
    return any(isinstance(mark, Point) and mark.label == "A_1" for mark in figure.marks)
