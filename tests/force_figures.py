"""Free bodies and force polygons like those that the methods draw, for the tests of the drawing."""

from __future__ import annotations

import cmath
import math

from vecpoly.board.construction import Construction, Figure, Scale, View
from vecpoly.board.paper.marks import (
    AngleMark,
    Cell,
    Disc,
    Dot,
    FrictionCircle,
    Ground,
    LinkNumber,
    Mark,
    Note,
    Outline,
    Point,
    Role,
    Segment,
    TurnArrow,
    Vector,
)
from vecpoly.words import Words

MU_L, MU_F = Scale(symbol="μ_l", value=0.002, unit="m"), Scale(symbol="μ_F", value=12.5, unit="N")
PHI = math.radians(8)


def cis(degrees: float) -> complex:
    """The unit vector at an angle."""
    return cmath.rect(1, math.radians(degrees))


def body(name: str, *marks: Mark) -> Figure:
    """A free body of these marks."""
    title = Words(f"构件 {name} 的受力图", f"Free body of link {name}")
    return Figure(view=View.BODY, title=title, scale=MU_L, marks=marks, name=name)


def polygon(name: str, *forces: tuple[str, complex]) -> Figure:
    """The forces one after the other, the last one found."""
    marks: list[Mark] = []
    at = 0j
    for i, (label, force) in enumerate(forces):
        marks += [
            Vector(a=at, b=at + force, role=Role.GIVEN if i == 0 else Role.RESULT, label=label, step=i),
            Point(at=at, label="abcdef"[i], dot=Dot.POINT, step=i),
        ]
        at += force
    title = Words(f"构件 {name} 的力多边形", f"Force polygon of link {name}")
    return Figure(view=View.FORCE, title=title, scale=MU_F, marks=tuple(marks), name=name)


def rod() -> Figure:
    """Two friction circles and two opposite reactions on their common tangent."""
    b, c, tilt = 0j, 78 - 12j, cis(-6)
    line = b + 2.5j * cis(-6), c - 2.0j * cis(-6)
    u = (line[1] - line[0]) / abs(line[1] - line[0])
    assert abs(tilt) == 1
    return body(
        "2",
        Segment(a=b, b=c, role=Role.LINK),
        Point(at=b, label="B", dot=Dot.JOINT),
        Point(at=c, label="C", dot=Dot.JOINT),
        FrictionCircle(centre=b, radius=2.5, label="ρ_B"),
        FrictionCircle(centre=c, radius=2.0, label="ρ_C", enlarged=3),
        Segment(a=line[0] - 18 * u, b=line[1] + 18 * u, role=Role.CENTRE),
        Vector(a=line[0] - 18 * u, b=line[0], role=Role.RESULT, label="R_{12}"),
        Vector(a=line[1] + 18 * u, b=line[1], role=Role.RESULT, label="R_{32}"),
        TurnArrow(at=b, radius=7, start=1.0, ccw=False, label="ω_{21}"),
        TurnArrow(at=c, radius=7, start=2.0, ccw=True, label="ω_{23}"),
        LinkNumber(a=b, b=c, number="2"),
    )


def slide() -> Figure:
    """A block on a fixed face: three forces through one point and the friction angle between normal and reaction."""
    corners = (-11 - 7j, 11 - 7j, 11 + 7j, -11 + 7j)
    foot = -7j
    reaction = cis(90 + 8)
    return body(
        "3",
        Outline(points=corners),
        Outline(points=(-26 - 7j, 26 - 7j, 26 - 13j, -26 - 13j), fixed=True),
        Point(at=0j, label="C", dot=Dot.POINT),
        FrictionCircle(centre=0j, radius=2.2, label="ρ"),
        Vector(a=foot - 24 * reaction, b=foot, role=Role.RESULT, label="R_{43}"),
        Segment(a=foot - 26j, b=foot + 22j, role=Role.CENTRE),
        Point(at=foot + 22j, label="n", dot=Dot.NONE),
        Point(at=foot - 26j, label="n", dot=Dot.NONE),
        AngleMark(at=foot, radius=18, start=-math.pi / 2, sweep=PHI, label="φ"),
        Vector(a=30 + 0j, b=12 + 0j, role=Role.GIVEN, label="F"),
        Vector(a=-28 + 9j, b=-4 + 2j, role=Role.RESULT, label="R_{23}"),
        Vector(a=14 + 14j, b=28 + 14j, role=Role.GIVEN, label="v_{34}"),
        LinkNumber(a=8 + 3j, b=8 + 3j, number="3"),
    )


def crank() -> Figure:
    """A couple of two reactions at the arm h and the moment that holds it."""
    a, b, u = 0j, 38 * cis(52), cis(-17)
    return body(
        "1",
        Segment(a=a, b=b, role=Role.LINK),
        Ground(at=a, down=-1j),
        Point(at=a, label="A", dot=Dot.NONE),
        Point(at=b, label="B", dot=Dot.JOINT),
        FrictionCircle(centre=a, radius=3, label="ρ_A"),
        FrictionCircle(centre=b, radius=2.5, label="ρ_B"),
        Segment(a=a + 3j * u - 30 * u, b=a + 3j * u + 30 * u, role=Role.CENTRE),
        Segment(a=b - 2.5j * u - 14 * u, b=b - 2.5j * u + 30 * u, role=Role.CENTRE),
        Vector(a=b - 2.5j * u + 26 * u, b=b - 2.5j * u, role=Role.RESULT, label="R_{21}"),
        Vector(a=a + 3j * u - 26 * u, b=a + 3j * u, role=Role.RESULT, label="R_{41}"),
        Segment(
            a=a + 3j * u - 12 * u,
            b=a + 3j * u - 12 * u + (((b - 2.5j * u - a - 3j * u) / u).imag * 1j * u),
            role=Role.CONSTRUCTION,
        ),
        TurnArrow(at=a, radius=12, start=2.4, ccw=True, label="ω_1"),
        TurnArrow(at=b, radius=9, start=0.3, ccw=False, label="M_1"),
    )


def wedge() -> Figure:
    """A wedge between two hatched bodies, a force at its back."""
    fixed = (-40 - 20j, 40 - 20j, 40 - 28j, -40 - 28j)
    upper, normal = -5 - 3.5j, cis(-72)
    lower = 4 - 20j
    return body(
        "1",
        Outline(points=(-34 - 20j, 30 - 20j, 30 + 7j)),
        Outline(points=fixed, fixed=True),
        Vector(a=upper - 30 * normal * cis(8), b=upper, role=Role.RESULT, label="R_{21}"),
        Segment(a=upper - 34 * normal, b=upper + 8 * normal, role=Role.CENTRE),
        AngleMark(at=upper, radius=24, start=cmath.phase(-normal), sweep=PHI, label="φ"),
        Point(at=upper - 34 * normal, label="n", dot=Dot.NONE),
        Vector(a=lower - 30 * cis(98), b=lower, role=Role.RESULT, label="R_{31}"),
        Segment(a=lower - 34j, b=lower + 5j, role=Role.CENTRE),
        AngleMark(at=lower, radius=22, start=-math.pi / 2, sweep=PHI, label="φ"),
        Vector(a=52 - 8j, b=31 - 8j, role=Role.GIVEN, label="F"),
        LinkNumber(a=14 - 12j, b=14 - 12j, number="1"),
        Note(at=30 + 7j, words=Words("楔块左移", "wedge moves left")),
    )


def cam() -> Figure:
    """An eccentric disc under a lever with a rounded tip."""
    a, o, e, c = 0j, 9.7 + 5.2j, 9.5 + 34.7j, 59 + 13j
    touch = o + 24 * (e - o) / abs(e - o)
    n = (e - o) / abs(e - o)
    r = n * cis(9)
    return body(
        "12",
        Disc(centre=o, radius=24),
        Disc(centre=e, radius=5.5),
        Segment(a=c, b=e, role=Role.LINK),
        Ground(at=c, down=-1j),
        Ground(at=a, down=-1j),
        Point(at=a, label="A", dot=Dot.NONE),
        Point(at=o, label="O", dot=Dot.POINT),
        Point(at=e, label="E", dot=Dot.POINT),
        Point(at=c, label="C", dot=Dot.NONE),
        Point(at=touch, label="K", dot=Dot.POINT),
        FrictionCircle(centre=a, radius=2.5, label="ρ_A"),
        FrictionCircle(centre=c, radius=2, label="ρ_C"),
        Segment(a=touch - 6 * n, b=touch + 40 * n, role=Role.CENTRE),
        Vector(a=touch + 36 * r, b=touch, role=Role.RESULT, label="R_{21}"),
        AngleMark(at=touch, radius=27, start=cmath.phase(n), sweep=math.radians(9), label="φ"),
        Vector(a=-9.7 + 68j, b=-9.7 + 43j, role=Role.GIVEN, label="Q"),
        Segment(a=e, b=-9.7 + 43j, role=Role.LINK),
        TurnArrow(at=a, radius=10, start=3.5, ccw=True, label="M_1"),
        LinkNumber(a=c, b=e, number="2"),
    )


def tight_polygon() -> Figure:
    """Four forces, one of them short, two almost parallel."""
    return polygon(
        "3",
        ("F", 62 + 0j),
        ("R_{43}", cmath.rect(19, math.radians(98))),
        ("F_{I3}", 6 + 3j),
        ("R_{23}", -(62 + 6 + 3j + cmath.rect(19, math.radians(98)))),
    )


def train() -> Figure:
    """Machines in series and in parallel."""
    marks: list[Mark] = []
    for i, x in enumerate((0.0, 42.0)):
        marks += [
            Cell(
                at=complex(x, 0),
                width=26,
                height=14,
                words=Words(f"机器 {i + 1}\n$η_{i + 1}$ = 0.9{i}", f"machine {i + 1}\n$η_{i + 1}$ = 0.9{i}"),
            ),
            Vector(a=complex(x - 29, 0), b=complex(x - 13, 0), role=Role.RESULT, label=f"P_{i}"),
        ]
    marks += [
        Cell(at=84 + 14j, width=26, height=14, words=Words("运输机 3", "conveyor number 3")),
        Cell(at=84 - 14j, width=26, height=14, words=Words("机器 4", "machine 4")),
        Segment(a=55 + 0j, b=62 + 0j, role=Role.RESULT),
        Segment(a=62 - 14j, b=62 + 14j, role=Role.RESULT),
        Vector(a=62 + 14j, b=71 + 14j, role=Role.RESULT, label="P'_2"),
        Vector(a=62 - 14j, b=71 - 14j, role=Role.RESULT, label="P''_2"),
    ]
    title = Words("机组的功率流", "Flow of power through the machines")
    return Figure(view=View.MECHANISM, title=title, scale=Scale(symbol="", value=0.0, unit=""), marks=tuple(marks))


def mechanism() -> Figure:
    """The slider-crank of the bodies above."""
    a, b, c = 0j, 38 * cis(52), 120 - 7.5j
    marks = (
        Segment(a=a, b=b, role=Role.LINK),
        Segment(a=b, b=c, role=Role.LINK),
        Ground(at=a, down=-1j),
        Point(at=a, label="A", dot=Dot.NONE),
        Point(at=b, label="B", dot=Dot.JOINT),
        Outline(points=(c - 9 - 5j, c + 9 - 5j, c + 9 + 5j, c - 9 + 5j)),
        Outline(points=(c - 30 - 5j, c + 30 - 5j, c + 30 - 10j, c - 30 - 10j), fixed=True),
        Point(at=c, label="C", dot=Dot.JOINT),
        FrictionCircle(centre=a, radius=3, label="ρ_A"),
        FrictionCircle(centre=b, radius=2.5, label="ρ_B"),
        FrictionCircle(centre=c, radius=2, label="ρ_C"),
        Vector(a=c + 32, b=c + 9, role=Role.GIVEN, label="F"),
        TurnArrow(at=a, radius=10, start=1.5, ccw=True, label="ω_1"),
        TurnArrow(at=a, radius=15, start=3.4, ccw=False, label="M_1"),
        LinkNumber(a=a, b=b, number="1"),
        LinkNumber(a=b, b=c, number="2"),
    )
    return Figure(view=View.MECHANISM, title=Words("机构运动简图", "Kinematic diagram"), scale=MU_L, marks=marks)


def velocity() -> Figure:
    """A velocity polygon."""
    marks = (
        Point(at=0j, label="p", dot=Dot.POLE),
        Vector(a=0j, b=-40 + 30j, role=Role.GIVEN, label="v_B"),
        Vector(a=0j, b=-52 + 0j, role=Role.RESULT, label="v_C"),
        Vector(a=-40 + 30j, b=-52 + 0j, role=Role.RESULT, label="v_{CB}"),
        Point(at=-40 + 30j, label="b", dot=Dot.POINT),
        Point(at=-52 + 0j, label="c", dot=Dot.POINT),
    )
    return Figure(
        view=View.VELOCITY,
        title=Words("速度多边形", "Velocity polygon"),
        scale=Scale(symbol="μ_v", value=0.02, unit="m/s"),
        marks=marks,
    )


def crank_polygon() -> Figure:
    """Two equal and opposite forces."""
    return polygon("1", ("R_{21}", 58 * cis(163)), ("R_{41}", -58 * cis(163)))


def rod_polygon() -> Figure:
    """Two equal and opposite forces."""
    return polygon("2", ("R_{12}", 50 * cis(-17)), ("R_{32}", -50 * cis(-17)))


SINGLE = {make.__name__: make for make in (rod, slide, crank, wedge, cam, tight_polygon, train, mechanism, velocity)}


def slider_crank(*more: Figure) -> Construction:
    """Eight figures: mechanism, velocities, three free bodies, three polygons."""
    figures = (mechanism(), velocity(), crank(), rod(), slide(), tight_polygon(), rod_polygon(), crank_polygon(), *more)
    return Construction(problem="4-3", hand="drafting", figures=figures, steps=(), readings={})
