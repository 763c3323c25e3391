"""By what the kinds of line and symbol of a legend are known."""

from __future__ import annotations

from collections.abc import Callable

from ...board.construction import Figure, View
from ...board.paper.marks import Arc, Curve, Disc, Dot, Lump, Mark, Outline, Plate, Point, Role, Segment, Vector
from ...board.paper.titled import ALONG_AXIS, SYNTHESIS
from .letters import is_of_cam, is_of_curvature

_PLACES = ("alpha_rise", "alpha_return", "rho_min")  # of a cam, each with a figure of its own
_LONG = 1.5  # rad: a circle of which no more is drawn is where something meets
Met = Callable[[Figure, Mark], bool]


def in_polygon(figure: Figure) -> bool:
    """Whether vectors are laid end to end on it."""
    return figure.view.is_polygon


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


def is_lone_profile(figure: Figure, mark: Mark) -> bool:
    """Whether it is the profile of a cam that has no pitch curve beside it."""
    return isinstance(mark, Curve) and mark.role is Role.RESULT and is_of_cam(figure)


def on_curvature(role: Role, *types: type[Mark]) -> Met:
    """The same on a curvature drawing."""
    drawn = traced(role, *types)
    return lambda figure, mark: drawn(figure, mark) and is_of_curvature(figure)


def imagined(figure: Figure, mark: Mark) -> bool:
    """Whether it is dashed and fine, and none of what the other kinds have."""
    if not _fine(mark) or in_centre_polygon(figure) or of_rotor(figure):
        return False
    return not (in_axial_view(figure, mark) or to_counterweight(figure, mark) or _of_linkages(figure))


def _of_linkages(figure: Figure) -> bool:
    """Whether it is the sheet on which a linkage is found, or has one in several positions."""
    solution = figure.title.zh.startswith(SYNTHESIS.zh)  # of several each has its number behind the title
    return solution or any(getattr(one, "role", None) is Role.OTHER for one in figure.marks)


def in_axial_view(figure: Figure, mark: Mark) -> bool:
    """Whether it is a plane of a rotor that is seen from its side."""
    return _fine(mark) and figure.title == ALONG_AXIS


def to_counterweight(figure: Figure, mark: Mark) -> bool:
    """Whether it leads to a mass that is hung on a link."""
    return _fine(mark) and any(is_lump(Lump.COUNTERWEIGHT)(figure, one) for one in figure.marks)


def designed(role: Role, *, given: bool) -> Met:
    """Whether it is a line, in this role, of the sheet on which a linkage is found: given, or a bar of a solution
    that is not the one in thick lines."""
    drawn = traced(role, Segment)
    return lambda figure, mark: (
        drawn(figure, mark)
        and figure.view is View.MECHANISM
        and not figure.name
        and (mark.step <= 1 or not _between_pins(figure, mark)) is given
        and _of_linkages(figure)
    )


def _between_pins(figure: Figure, mark: Mark) -> bool:
    """Whether it is a bar, with a pin at either end."""
    pins = [one.at for one in figure.marks if isinstance(one, Point) and one.dot in (Dot.JOINT, Dot.MULTIPLE)]
    return isinstance(mark, Segment) and all(any(abs(pin - end) < 0.1 for pin in pins) for end in (mark.a, mark.b))


def is_cognate(role: Role) -> Met:
    """Whether it is a bar in this role, thinner than those of the linkage beside it, where all lead a point along one
    path."""
    drawn = traced(role, Segment)
    return lambda figure, mark: drawn(figure, mark) and _has_path(figure) and _between_pins(figure, mark)


def _has_path(figure: Figure) -> bool:
    return any(isinstance(one, Curve) and one.role is Role.CENTRE for one in figure.marks)


def is_other_position(figure: Figure, mark: Mark) -> bool:
    """Whether it is a bar in another position, and not of another linkage that leads a point along one path."""
    return traced(Role.OTHER, Segment)(figure, mark) and not is_cognate(Role.OTHER)(figure, mark)


def is_other_solution(figure: Figure, mark: Mark) -> bool:
    """Whether it is a bar of a solution that is not the one in thick lines."""
    return traced(Role.SECOND, Segment)(figure, mark) and not _has_path(figure)


def osculates(figure: Figure, mark: Mark) -> bool:
    """Whether it is the circle about a centre of curvature K."""
    return (
        isinstance(mark, Arc)
        and abs(mark.sweep) > _LONG
        and mark.role is Role.CONSTRUCTION
        and any(
            isinstance(one, Point) and one.label[:1] == "K" and abs(one.at - mark.centre) < 0.1 for one in figure.marks
        )
    )


def is_path(figure: Figure, mark: Mark) -> bool:
    """Whether it is what a point of a link passes on a curvature drawing."""
    return isinstance(mark, Curve) and mark.role is Role.GIVEN and is_of_curvature(figure)


def is_coupler_curve(figure: Figure, mark: Mark) -> bool:
    """Whether it is the curve that a linkage was found for."""
    found = isinstance(mark, Curve) and mark.role is Role.RESULT and figure.view is View.MECHANISM and not figure.name
    return found and any(getattr(one, "role", None) is Role.OTHER for one in figure.marks)


def is_arc_of_cam(role: Role) -> Met:
    """Whether it is a part of a cam's curve about one place: of its profile, or (dashed) of the pitch curve."""
    drawn = traced(role, Curve)
    return lambda figure, mark: drawn(figure, mark) and figure.view is View.MECHANISM and figure.name in _PLACES


def is_base_circle(figure: Figure, mark: Mark) -> bool:
    """Whether it is that of a wheel, on which its teeth are generated."""
    lettered = any(isinstance(one, Point) and one.label.replace("{", "").startswith("r_b") for one in figure.marks)
    return lettered and isinstance(mark, Arc) and mark.role is Role.HIDDEN and figure.view is View.MECHANISM


def is_outline(figure: Figure, mark: Mark) -> bool:
    """Whether it is a full line, neither thick nor fine, that is known for what it is: an outline, a line between two
    places; not the coil of a spring, which the standards have."""
    thin = isinstance(mark, Arc | Segment) and mark.role is Role.GIVEN
    known = (
        mark.owner == "spring"
        or is_flow(figure, mark)
        or in_polygon(figure)
        or in_centre_polygon(figure)
        or on_curvature(Role.GIVEN, Arc)(figure, mark)
    )
    known = known or is_cognate(Role.GIVEN)(figure, mark)
    return thin and not known and not any(designed(Role.GIVEN, given=one)(figure, mark) for one in (True, False))


def is_flow(figure: Figure, mark: Mark) -> bool:
    """Whether it is an arrow between the machines of a train, or a line that arrows branch from."""
    flows = figure.name == "train" and any(isinstance(one, Vector) and not one.label for one in figure.marks)
    return flows and isinstance(mark, Vector | Segment) and mark.role is Role.GIVEN and not getattr(mark, "label", "")


def is_force(figure: Figure, mark: Mark) -> bool:
    """Whether it is a force where it acts, on a link or on the mechanism: whatever it is called, motions are in small
    letters."""
    acts = figure.view.bodies or figure.view is View.MECHANISM
    named = isinstance(mark, Vector) and (mark.label[:1].isupper() or mark.label == "mg")
    return named and acts and not of_rotor(figure) and getattr(mark, "role", None) in (Role.GIVEN, Role.RESULT)


def is_speed(figure: Figure, mark: Mark) -> bool:
    """Whether it is a velocity where it is, at a point of a link."""
    acts = figure.view.bodies or figure.view is View.MECHANISM
    return isinstance(mark, Vector) and acts and mark.label[:1] in ("v", "u")


def is_solid(mark: Mark) -> bool:
    """Whether it is a tinted body of a link."""
    shaped = isinstance(mark, Plate) or (isinstance(mark, Disc) and mark.lump is Lump.NONE)
    return shaped or (isinstance(mark, Outline) and not mark.fixed)


def at_infinity(figure: Figure, mark: Mark) -> bool:
    """Whether it is an arrow towards a centre at infinity."""
    far = any("∞" in getattr(one, "label", "") for one in figure.marks)
    return far and isinstance(mark, Vector) and mark.role is Role.DIRECTION and figure.view is View.MECHANISM


def is_lump(*kinds: Lump) -> Met:
    """Whether it is a mass that is thought at one place, of these kinds."""
    return lambda _, mark: isinstance(mark, Disc) and mark.lump in kinds


def is_added(figure: Figure, mark: Mark) -> bool:
    """Whether it is a mass that is added to a rotor."""
    return (of_rotor(figure) or figure.title == ALONG_AXIS) and traced(Role.RESULT, Arc)(figure, mark)


def is_void(figure: Figure, mark: Mark) -> bool:
    """Whether it is the edge of a hole or a keyway that a disc has, which is no rim about its axis."""
    return isinstance(mark, Arc) and of_rotor(figure) and mark.role is Role.GIVEN and abs(mark.centre) > 0.1


def taken_off(figure: Figure, mark: Mark) -> bool:
    """Whether it is where a joint was that went with a group."""
    apart = figure.name.startswith(("group ", "left "))
    return apart and isinstance(mark, Point) and mark.dot is Dot.POINT and bool(mark.label)


def bored(figure: Figure, mark: Mark) -> bool:
    """Whether it is a ring on a rotor where mass is missing, from its end or along its shaft."""
    return isinstance(mark, Arc) and mark.role is Role.HIDDEN and (of_rotor(figure) or along_shaft(figure))


def allowed(figure: Figure, mark: Mark) -> bool:
    """Whether it is the circle within which a rest of unbalance may be."""
    return isinstance(mark, Arc) and mark.role is Role.HIDDEN and figure.view.is_polygon and not of_rotor(figure)


def _fine(mark: Mark) -> bool:
    return isinstance(mark, Segment) and mark.role is Role.HIDDEN


def of_rotor(figure: Figure) -> bool:
    """Whether it shows the masses of a rotor from its end."""
    return figure.view.name == "end-view"


def along_shaft(figure: Figure) -> bool:
    """Whether it shows where the masses of a rotor stand along its shaft."""
    return figure.view is View.MECHANISM and any(mark.owner == "shaft" for mark in figure.marks)


def has_lobes(figure: Figure) -> bool:
    """Whether areas between two curves of moments are hatched on it, one of them A_1."""
    return any(isinstance(mark, Point) and mark.label == "A_1" for mark in figure.marks)
