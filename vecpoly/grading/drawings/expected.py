"""What should be drawn of a problem: the vectors of every polygon, and the points of the diagram, in mm."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass

from ...board.acts import Act, Arrow, Locate, Plot, Tint
from ...board.construction import Construction
from ...board.hand import hand
from ...board.otherwise.amended import AS_DRAWN, Amended, plain_letters
from ...board.paper.marks import FixedGuide, Plate, Role, Segment, Slot
from ...board.place import Pane, Place, View, called, view_of
from ...figures.energy import INDICATOR
from ...foundation.slotted import replace
from ...mechanism.model import Mechanism
from ...methods.desk import Desk
from ...methods.drawn import Drawn
from ...methods.plan import sketched
from ...problem.problem import Problem
from ...solution import constructed, scales_of
from ...task import task_of
from .segment import SHORTEST

NOTHING = 1e-6  # mm
NO_POLYGON = (View.MECHANISM, View.BODY, INDICATOR)  # the last: each on its own line, beside one another


@dataclass(frozen=True, slots=True, kw_only=True)
class Edge:
    """A vector of a polygon, from a to b (mm from where the figure has its origin).

    keys: of the quantities that it stands for, the first drawn first; a line between two lettered points that need not
    be drawn has none. tail, tip: letters at its ends; given: its size is known before the polygon is drawn; act: the
    number of the act that drew it.
    """

    keys: tuple[str, ...]
    a: complex
    b: complex
    tail: tuple[str, ...] = ()
    tip: tuple[str, ...] = ()
    given: bool = False
    act: int = -1

    @property
    def along(self) -> complex:
        """The vector."""
        return self.b - self.a

    @property
    def key(self) -> str:
        """The quantity; empty for a line that need not be drawn."""
        return self.keys[0] if self.keys else ""

    @property
    def letters(self) -> str:
        """As lines are read off: bc2."""
        return (self.tail[0] if self.tail else "") + (self.tip[0] if self.tip else "")


@dataclass(frozen=True, slots=True, kw_only=True)
class Vertex:
    """A place with its letters; act: the number of the act that found it, by which an own place goes on."""

    letters: tuple[str, ...]
    at: complex
    act: int = -1


@dataclass(frozen=True, slots=True, kw_only=True)
class Shape:
    """A figure as it should be: its name (``velocity``, ``force 23``), its μ (SI per mm), vectors, places, images."""

    name: str
    view: View
    mu: float
    edges: tuple[Edge, ...]
    vertices: tuple[Vertex, ...]
    images: tuple[tuple[complex, ...], ...] = ()

    @property
    def diagram(self) -> bool:
        """Whether it is the kinematic diagram, whose lines have no sense."""
        return self.view is View.MECHANISM

    def vertex(self, at: complex) -> Vertex | None:
        """The lettered place here."""
        return next((one for one in self.vertices if abs(one.at - at) < NOTHING), None)

    def edge(self, key: str) -> Edge | None:
        """The vector of this quantity."""
        return next((one for one in self.edges if key in one.keys), None)


@dataclass(frozen=True, slots=True, kw_only=True)
class Expected:
    """All figures of one solution."""

    shapes: tuple[Shape, ...]
    construction: Construction

    def shape(self, name: str) -> Shape | None:
        """The figure of this name."""
        return next((one for one in self.shapes if one.name == name), None)


def settled(problem: Problem) -> Problem:
    """The problem with the scales of its exact drawing, which then stay whatever is drawn otherwise."""
    drawn = constructed(problem, hand("exact"), AS_DRAWN)
    return replace(problem, scales=scales_of(drawn.construction))


def expected(problem: Problem, amended: Amended = AS_DRAWN, sketch: Desk | None = None) -> Expected:
    """The figures as an exact hand draws them, with this done otherwise; sketch: of this problem, where there is one.

    Raises what drawing raises.
    """
    return shapes(task_of(problem).draw(hand("exact"), amended, sketch))


def sketch_of(problem: Problem) -> Desk | None:
    """What every further drawing of a problem with a mechanism can start from."""
    return sketched(problem)[0] if isinstance(problem.subject, Mechanism) else None


def shapes(drawn: Drawn) -> Expected:
    """The figures of a drawing."""
    construction = drawn.construction
    places = {called(place): place for act in construction.acts if (place := act.head.place) is not None}
    found = [_shape(name, place, construction) for name, place in places.items() if _counts(place)]
    return Expected(shapes=tuple(one for one in found if one.edges), construction=construction)


def _is_polygon(place: Place) -> bool:
    """Whether vectors are added up there; what stands on a sketch, or on a body, is drawn to no scale."""
    return view_of(place) not in NO_POLYGON


def _counts(place: Place) -> bool:
    return view_of(place) is not View.BODY and not (isinstance(place, Pane) and place.aside)


def _shape(name: str, place: Place, construction: Construction) -> Shape:
    acts = [act for act in construction.acts if act.head.place is not None and called(act.head.place) == name]
    vertices = tuple(_vertices(acts))
    lines = _links(construction) if place is View.MECHANISM else _vectors(acts, vertices) if _is_polygon(place) else ()
    figure = construction.figure(place)
    return Shape(
        name=name,
        view=view_of(place),
        mu=figure.scale.value if figure else 1.0,
        edges=tuple(lines),
        vertices=vertices,
        images=tuple(act.points for act in acts if isinstance(act, Tint)),
    )


def _vertices(acts: Iterable[Act]) -> Iterator[Vertex]:
    found: list[Vertex] = []
    for act in acts:
        if isinstance(act, Locate | Plot) and (name := _letter(act)):
            known = next((n for n, one in enumerate(found) if abs(one.at - act.at) < NOTHING), None)
            number = act.number if isinstance(act, Locate) else -1
            if known is None:
                found.append(Vertex(letters=(name,), at=act.at, act=number))
            else:
                old = found[known]
                letters = tuple(dict.fromkeys((*old.letters, name)))
                found[known] = replace(old, letters=letters, act=max(old.act, number))
    yield from found


def _letter(act: Locate | Plot) -> str:
    """The plain letter: c2, n2'; nothing for words along a direction."""
    name = plain_letters(act.key or (act.label if isinstance(act, Plot) else ""))
    return name if name[:1].isascii() and name[:1].isalpha() and "R" not in name[:1] else ""


def _vectors(acts: Sequence[Act], vertices: Sequence[Vertex]) -> Iterator[Edge]:
    found: list[Edge] = []
    for act in acts:
        if isinstance(act, Arrow) and act.key and abs(act.b - act.a) > SHORTEST:
            same = next((n for n, one in enumerate(found) if _same(one, act)), None)
            if same is not None:
                found[same] = replace(found[same], keys=tuple(dict.fromkeys((*found[same].keys, act.key))))
            else:
                tail, tip = (_letters(vertices, at) for at in (act.a, act.b))
                given = act.role is Role.GIVEN
                found.append(Edge(keys=(act.key,), a=act.a, b=act.b, tail=tail, tip=tip, given=given, act=act.number))
    yield from found


def _same(one: Edge, act: Arrow) -> bool:
    return abs(one.a - act.a) < SHORTEST and abs(one.b - act.b) < SHORTEST


def _letters(vertices: Iterable[Vertex], at: complex) -> tuple[str, ...]:
    return next((one.letters for one in vertices if abs(one.at - at) < NOTHING), ())


def _links(construction: Construction) -> Iterator[Edge]:
    """The lines of the kinematic diagram, by which it is found on a sheet."""
    figure = construction.figure(View.MECHANISM)
    for mark in figure.marks if figure else ():
        match mark:
            case Segment(role=Role.LINK) | FixedGuide() | Slot():
                yield Edge(keys=(), a=mark.a, b=mark.b)
            case Plate(points=points):
                for a, b in zip(points, points[1:] + points[:1], strict=True):
                    yield Edge(keys=(), a=a, b=b)
            case _:
                continue
