"""What stands on a sheet has an entry in its legend, unless the standards for drawings have it."""

from __future__ import annotations

from collections.abc import Iterator

import pytest
import shapely

import vecpoly
from tests.drawn_library import DRAFTED, IDS, drawn
from tests.drawn_sheets import laid
from tests.each import each
from tests.found import APART, FOUND
from vecpoly.board.construction import Figure, View
from vecpoly.board.paper.marks import (
    AngleMark,
    Arc,
    Block,
    Cell,
    Curve,
    Dot,
    FixedGuide,
    Ground,
    ImageOf,
    LinkNumber,
    Mark,
    Note,
    Outline,
    Passing,
    Point,
    RightAngle,
    Role,
    Segment,
    Slot,
    TurnArrow,
    Vector,
)
from vecpoly.drawing.legend.circles import FINE, ROUNDS, THIN
from vecpoly.drawing.legend.kinds import KINDS, is_seen
from vecpoly.drawing.legend.legend import entries
from vecpoly.drawing.legend.on_sheet import with_legend

SIGNS = (AngleMark, Block, Cell, FixedGuide, Ground, LinkNumber, Note, RightAngle, Slot, TurnArrow)  # GB/T 4460, 4458


def _is_sign(figure: Figure, mark: Mark) -> bool:
    """Whether the standards for drawings have it: points and pins, bars, guides, fixed bodies, dimensions, an axis and
    the curve over it."""
    on_axes = figure.view.across is not None or any(_is_axis(one) for one in figure.marks)
    match mark:
        case Point():
            return True
        case Segment(role=Role.LINK) | Arc(role=Role.LINK) | Curve(role=Role.LINK):
            return True
        case Outline(fixed=fixed):
            return fixed
        case ImageOf(points=points):
            return not is_seen(points)
        case Vector(role=Role.CONSTRUCTION) | Segment(owner="spring"):
            return True
        case (
            Vector(role=Role.DIRECTION)
            | Vector(role=Role.RESULT, label="")
            | Curve(role=Role.RESULT | Role.GIVEN)
            | Segment(role=Role.RESULT)
        ):
            return on_axes or figure.view is not View.MECHANISM
        case _:
            return isinstance(mark, SIGNS)


def _is_axis(mark: Mark) -> bool:
    return isinstance(mark, Vector) and mark.role is Role.DIRECTION


def _is_covered(figure: Figure, mark: Mark) -> bool:
    """Whether it is a centre line under a bar, or what goes on past a pin under the ring of a multiple joint."""
    if isinstance(mark, Passing):
        rings = [one.at for one in figure.marks if isinstance(one, Point) and one.dot is Dot.MULTIPLE]
        return any(abs(at - mark.at) < 0.1 for at in rings)
    if not isinstance(mark, Segment) or mark.role is not Role.CENTRE:
        return False
    bars = [_line(one) for one in figure.marks if isinstance(one, Segment) and one.role is Role.LINK]
    return any(bar.buffer(0.11).contains(_line(mark)) for bar in bars)


def _line(mark: Segment) -> shapely.LineString:
    return shapely.LineString([(z.real, z.imag) for z in (mark.a, mark.b)])


def _unexplained(name: str) -> Iterator[tuple[str, Mark]]:
    for figure in drawn(name).construction.figures:
        for mark in figure.marks:
            plain = _is_sign(figure, mark) or _is_covered(figure, mark)
            if not plain and not any(kind.met(figure, mark) for kind in KINDS):
                yield figure.view.name, mark


@each([*IDS, *FOUND, *APART])
def test_every_line_and_sign_that_is_seen_has_an_entry_or_is_one_of_the_standards(name: str) -> None:
    assert not [*_unexplained(name)]


@each([*IDS, *FOUND, *APART])
def test_no_legend_says_outline_where_it_can_say_of_what(name: str) -> None:
    """Nor names a line twice, by two kinds that stand for the same."""
    for figure in drawn(name).construction.figures:
        for mark in figure.marks:
            words = [kind.words.en for kind in (*ROUNDS, *FINE, *THIN) if kind.met(figure, mark)]
            assert len(words) <= 1 and "outline or connecting line" not in words


@each(DRAFTED)
def test_every_sheet_on_which_anything_asks_for_a_legend_has_one(name: str) -> None:
    """Also a full one: its figures make room for the band, as close together as they may stand."""
    for sheet in laid(name):
        figures = [one.figure for one in sheet.figures if one.figure is not None]
        assert bool(with_legend(sheet).results) is bool(entries(figures, sheet.lang))


@pytest.mark.parametrize(
    ("name", "told", "untold"),
    [
        ("8-10", {"given position", "other given positions"}, {"other solution"}),
        ("K-crank-rocker-gamma", {"other solution", "another position"}, {"given position"}),
        ("four-positions", {"solution rejected"}, {"other solution"}),
        ("curv-6", {"fixed centrode", "moving centrode"}, {"path of a point"}),
        ("curv-3", {"path of a point", "osculating circle"}, {"base circle", "outline or connecting line"}),
        (
            "gear-undercut",
            {"base circle", "successive positions of the rack", "flank of the rack", "tip, reference, root circle"},
            {"other positions", "outline or connecting line"},
        ),
        ("curv-4", {"return circle", "osculating circle", "return pole"}, {"normal of a contact"}),
        ("curv-5", {"pole positions, moving plane"}, {"return circle"}),
        (
            "cam-flat-face",
            {"radius at $φ$ = 60°", "farthest instant centre, rise, return"},
            {"nearest, farthest contact"},
        ),
        (
            "cam-flat-arm",
            {"nearest, farthest contact", "foot of $A$ on that face", "base circle", "circle of the pivots"},
            {"farthest instant centre, rise, return", "offset circle", "circle of a pin"},
        ),
        ("cam-roller-offset", {"base circle", "offset circle", "roller"}, {"circle of the pivots"}),
        ("travel-doubler", {"image of a gear", "pitch circle or line"}, {"circle of a pin", "base circle"}),
        ("rack-drives-pinion", {"image of a gear"}, {"circle of a pin"}),
        ("4-4", {"base circle", "link in place of a contact"}, {"offset circle", "extended or auxiliary line"}),
        ("3-6", {"instant centre, at rest", "acceleration pole"}, {"pole positions, fixed plane", "instant centre"}),
        ("5-1", {"lines of action that meet"}, {"extended or auxiliary line"}),
        ("8-15", {"circle of a pin"}, {"image of a gear", "base circle"}),
        ("engine-four", {"middle plane"}, {"extended or auxiliary line"}),
        ("6-1", {"outline of the rotor"}, {"roller"}),
        ("return-spring", {"arm of a force", "$v$ projected on a force"}, {"instant centre"}),
        ("5-2", {"normal of a contact", "angle of friction", "force that prevents sliding"}, {"pole normal"}),
        ("cam-moves-arm", {"osculating circle of the profile"}, {"osculating circle"}),
        ("6-6", {"concentrated mass", "balancing mass"}, {"hole to drill, negative mass"}),
        ("rotor-blind-hole", {"hole to drill, negative mass"}, {"balancing mass"}),
        (
            "field-four-runs",
            {"triangle of error between the arcs", "trial weight", "balancing mass"},
            {"image of a link", "concentrated mass", "body of a link"},
        ),
        ("balance-four-bar", {"counterweight"}, {"body of a link", "concentrated mass"}),
        ("balance-slider-crank", {"counterweight"}, {"body of a link", "concentrated mass"}),
        ("6-5", {"correction plane"}, {"inflection pole"}),
        ("engine-single", {"counterweight"}, {"concentrated mass", "correction plane"}),
        ("straight-roberts", {"coupler curve"}, {"to a centre at infinity"}),
        ("3-1d", {"to a centre at infinity"}, {"coupler curve"}),
        ("stephenson-valve-gear", {"image of a link"}, {"outline or connecting line"}),
    ],
)
def test_lines_of_one_look_are_told_by_what_they_are_where_they_stand(
    name: str, told: set[str], untold: set[str]
) -> None:
    figures = [one.figure for sheet in laid(name) for one in sheet.figures if one.figure is not None]
    found = {one.words.en for one in entries(figures, "en")}
    assert told <= found and not untold & found


def test_a_hole_that_is_shown_along_the_shaft_of_a_rotor_is_explained_as_from_its_end() -> None:
    """Each of its figures may come on a sheet of its own."""
    masses = {
        "1": {"m": "6 kg", "r": "103 mm", "at": "101 deg", "z": "1058 mm"},
        "2": {"hole": "39 mm", "r": "284 mm", "at": "267 deg", "z": "60 mm"},
    }
    planes = {"I": {"z": "-93 mm", "r": "250 mm"}, "II": {"z": "245 mm", "r": "250 mm"}}
    data = {"disc": {"b": "40 mm", "density": "7850 kg/m^3"}, "masses": masses, "correct": planes}
    asked = {"id": "t", "title": "t", "device": "rotor", "data": data, "find": ["m_bI"]}
    figures = vecpoly.problem(asked).solve(by="exact").construction.figures
    (along,) = (figure for figure in figures if figure.view is View.MECHANISM)
    assert "hole to drill, negative mass" in {
        kind.words.en for mark in along.marks for kind in KINDS if kind.met(along, mark)
    }
