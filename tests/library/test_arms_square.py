"""Claims about the arms of forces: each that has a letter stands square on a line of action, and says so."""

from __future__ import annotations

from collections.abc import Iterator

from tests.drawn_library import drawn, ids
from tests.each import Later, each
from tests.found import FOUND
from vecpoly.board.construction import Figure, View
from vecpoly.board.paper.marks import Dot, Point, RightAngle, Role, Segment, Vector

GROUPS = (
    "guided-couple",
    "plate-two-slides",
    "C-inertia",
    "two-trains-one-sun",
)  # with arms on free bodies of whole groups
IDS = Later(lambda: (*ids(view=View.BODY), *FOUND, *(name for name in GROUPS if name not in ids(view=View.BODY))))
NEAR, ON = 0.02, 1e-3  # mm, of a mark from where it belongs; of a place from the line on which it lies
PAST = 2.0  # mm: so far a line that is carried on to an arm is seen beyond it
Line = tuple[complex, complex]


def arms(figure: Figure) -> Iterator[tuple[str, Line]]:
    """The letters of arms of moments, and what they stand on."""
    lines = [m for m in figure.marks if isinstance(m, Segment) and m.role is Role.CONSTRUCTION]
    for mark in figure.marks:
        if isinstance(mark, Point) and mark.dot is Dot.NONE and mark.label.startswith("h"):
            yield mark.label, next((m.a, m.b) for m in lines if abs((m.a + m.b) / 2 - mark.at) < NEAR)


def square(figure: Figure, arm: Line) -> list[complex]:
    """The ends of an arm at which a right angle between it and what is square to it is marked."""
    a, b = arm
    along = (b - a) / abs(b - a)
    return [
        end
        for end, back in ((a, along), (b, -along))
        for m in figure.marks
        if isinstance(m, RightAngle) and abs(m.at - end) < NEAR
        if min(abs(m.u - back), abs(m.v - back), abs(m.u + back), abs(m.v + back)) < 1e-6
        and abs((m.u * m.v.conjugate()).real) < 1e-6
    ]


def beyond(figure: Figure, arm: Line, foot: complex) -> float:
    """How far (mm) the line square to the arm on which it ends goes on beyond its foot, to that side where it is
    shorter: all that is drawn of it there, a line and the arrow from which it is carried on; −1 where there is none."""
    across = 1j * (arm[1] - arm[0]) / abs(arm[1] - arm[0])
    reach, covered = [0.0, 0.0], False
    for m in figure.marks:
        if isinstance(m, Segment | Vector) and abs(m.b - m.a) > ON:
            a, b = ((z - foot) / across for z in (m.a, m.b))
            low, high = sorted((a.real, b.real))
            if max(abs(a.imag), abs(b.imag)) < ON and low < PAST and high > -PAST:
                covered |= low < ON and high > -ON
                reach = [max(reach[0], -low), max(reach[1], high)]
    return min(reach) if covered else -1.0


@each(IDS)
def test_an_arm_with_a_letter_is_square_to_the_line_of_action_on_which_it_ends_and_a_mark_says_so(name: str) -> None:
    for figure in drawn(name).figures(View.BODY):
        for letter, arm in arms(figure):
            feet = square(figure, arm)
            assert feet, (figure.name, letter)
            assert beyond(figure, arm, feet[0]) >= (PAST if letter == "h" else 0.0), (figure.name, letter)
