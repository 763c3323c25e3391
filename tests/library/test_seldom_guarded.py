"""What only few problems show: driven slides with a turn, pins in slots, curves that cross themselves or have no end,
the last digit, knots drawn apart."""

from __future__ import annotations

import math
import re
from itertools import combinations, pairwise
from unicodedata import normalize

import numpy as np
import pytest
import shapely

from tests.drawn_library import IDS, LIBRARY, drawn, ids
from tests.each import Later, each
from vecpoly import oracle
from vecpoly.board.construction import Figure, Scale, View
from vecpoly.board.paper.marks import Arc, Dot, FrictionCircle, ImageOf, Point, Role, Segment, Vector
from vecpoly.board.ruler import READABLE
from vecpoly.check.printed.answers import check_problem
from vecpoly.check.printed.verdict import Verdict
from vecpoly.cycle.facts.path import Path, Shape, path
from vecpoly.cycle.facts.path_words import path_sentences
from vecpoly.cycle.whole_cycle import cycle
from vecpoly.drawing.details.apart import ROMAN, detailed, shown
from vecpoly.drawing.details.knot import Knot
from vecpoly.drawing.details.knots import ABOUT, LINES, ROUND, TWINS, knots
from vecpoly.errors import NoMethodError, NotAskedError
from vecpoly.problem.load import loads
from vecpoly.solution import solve
from vecpoly.words import Words

# -- a slide that drives, its line turned from its guide ------------------------------------------------------------

DRIVEN = """
id: driven
title: driven
frame: {D: [120 mm, 40 mm]}
links: {1: {slot: C}, 2: {block: B}, 3: {DB: 70 mm, E: {along: DB, at: 100 mm, left: 15 mm}}}
joints: [2 slides in 1, 1 slides on y = 0 mm turned %(turn)s deg]
input: {link: 1, s: 90 mm, v: %(v)s m/s, a: 2 m/s^2}
branch: [B %(side)s D]
find: [p_B, v_B, a_B, v_E, a_E, omega_3, alpha_3]
"""


@pytest.mark.parametrize("side", ["above", "below"])
@pytest.mark.parametrize(("turn", "v"), [("60", "0.4"), ("120", "-0.4"), ("90", "0.4")])
def test_a_driven_slide_whose_slot_is_turned_from_its_guide_is_drawn_as_the_oracle_has_it(
    turn: str, v: str, side: str
) -> None:
    solution = solve(loads(DRIVEN % {"turn": turn, "v": v, "side": side}), by="exact", repeats=0)
    assert len(solution.answers) == 7
    for answer in solution.answers.values():
        one, two = (
            (answer.drawn_vector, answer.exact_vector)
            if answer.drawn_vector is not None
            else (answer.drawn, answer.exact)
        )
        assert one is not None and two is not None and abs(one - two) <= 1e-9 * max(abs(two), 0.1), answer.key


def test_turning_the_slot_of_a_driven_slide_moves_what_it_drives() -> None:
    places = [
        solve(loads(DRIVEN % {"turn": turn, "v": "0.4", "side": "above"}), by="exact", repeats=0)
        .answers["p_B"]
        .drawn_vector
        for turn in ("60", "90", "120")
    ]
    assert all(one is not None and two is not None and abs(two - one) > 0.005 for one, two in pairwise(places))


# -- pins in slots --------------------------------------------------------------------------------------------------

PIN = """
id: pin
title: pin
frame: {A: [0 mm, 0 mm], C: [0 mm, -90 mm]}
links: {1: {AB: 40 mm}, 2: {slot: C, E: {along: C, at: 160 mm}}}
joints: [B runs in 2]
input: {link: 1, phi: 35 deg, omega: 10 rad/s ccw}
find: [omega_2, alpha_2, v_E, a_E]
"""


def turns_told(text: str) -> set[str]:
    """The links of which a sentence tells ω or α."""
    return set(re.findall(r"[ωα]_\{?(\w+)", text))


def test_a_pin_that_runs_in_a_slot_has_no_turn_of_its_own_to_tell() -> None:
    problem = loads(PIN)
    solution = solve(problem, by="exact", repeats=0)
    said = [step.words for step in solution.construction.steps]
    assert {name for words in said for text in (words.zh, words.en) for name in turns_told(text)} == {"1", "2"}
    assert not any("移动副" in words.zh or "sliding pair" in words.en for words in said)
    for answer in solution.answers.values():
        assert answer.drawn == pytest.approx(answer.exact, rel=1e-9)


def test_a_block_in_a_slot_turns_with_it_and_is_said_to() -> None:
    text = PIN.replace("2: {slot: C, E: {along: C, at: 160 mm}}", "2: {block: B}, 3: {slot: C}").replace(
        "B runs in 2", "2 slides in 3"
    )
    steps = solve(
        loads(text.replace("alpha_2, v_E, a_E", "omega_3, alpha_3")), by="exact", repeats=0
    ).construction.steps
    assert sum("组成移动副" in step.words.zh and "form a sliding pair" in step.words.en for step in steps) == 2


@each(Later(ids))
def test_a_step_tells_turns_of_links_that_are_there_only(name: str) -> None:
    problem = drawn(name).problem
    there = {link.name for link in problem.mechanism.links if link.name[0].isdigit()} | {"x", "y"}
    there |= {"m"} if problem.machine is not None else set()  # the mean
    for step in drawn(name).construction.steps:
        told = {part for part in turns_told(step.words.zh) | turns_told(step.words.en) if len(part) == 1}
        summed = {"i"} if "Σ" in step.words.en and "Σ" in step.words.zh else set[str]()  # over all links
        assert told <= there | summed, step.number


def test_the_slowest_point_of_a_link_that_only_translates_is_refused() -> None:
    text = """
id: t
title: t
frame: {A: [0 mm, 0 mm], D: [100 mm, 0 mm]}
links: {1: {AB: 40 mm}, 2: {BC: 100 mm}, 3: {DC: 40 mm}}
branch: [C above AD]
input: {link: 1, phi: 60 deg, omega: 10 rad/s ccw}
method: centres
find: [{point: E2, on: 2, slowest: BC}]
"""
    with pytest.raises((NoMethodError, NotAskedError), match="only translates here"):
        solve(loads(text), repeats=0)


# -- paths ----------------------------------------------------------------------------------------------------------

COUPLER = """
id: p
title: p
frame: {A: [0 mm, 0 mm], D: [%(d)s mm, 0 mm]}
links: {1: {AB: %(a)s mm}, 2: {BC: %(b)s mm, E: {along: BC, at: %(at)s mm, left: %(left)s mm}}, 3: {DC: %(c)s mm}}
branch: [C above AD]
input: {link: 1, phi: 60 deg, omega: 10 rad/s %(sense)s}
find: [v_E]
"""
CURVES = [
    (30, 90, 80, 100, 45, 60),
    (30, 90, 80, 100, 45, 0),
    (30, 90, 80, 100, 150, -40),
    (40, 120, 100, 130, 60, -30),
    (25, 100, 60, 100, 50, -20),
    (30, 95, 80, 120, 170, -150),
    (40, 85, 110, 75, 160, 50),
    (30, 65, 110, 110, 50, -110),
    (20, 80, 105, 95, 140, 100),
]


def coupler(a: int, b: int, c: int, d: int, at: int, left: int, sense: str = "ccw") -> tuple[Path, str, list[complex]]:
    """The path of a coupler point, what is told of it, and the curve as a fine chain of points."""
    problem = loads(COUPLER % {"a": a, "b": b, "c": c, "d": d, "at": at, "left": left, "sense": sense})
    turn = cycle(problem)
    found = path(turn, "E")
    chain = np.asarray(oracle.solve(problem.mechanism, np.linspace(0, 2 * np.pi, 1500)).position("E"))
    return found, " ".join(words.en + words.zh for words in path_sentences(turn, found)), [complex(z) for z in chain]


@pytest.mark.parametrize("curve", CURVES)
def test_a_curve_that_crosses_itself_is_told_from_one_that_does_not(curve: tuple[int, int, int, int, int, int]) -> None:
    found, said, chain = coupler(*curve)
    simple = shapely.LineString([(z.real, z.imag) for z in chain[:-2]]).is_simple
    assert simple == (not found.crossings)
    assert ("does not cross itself" in said) == ("不自交" in said) == (simple and abs(found.turning or 0) == 1)
    assert ("figure of eight" in said) == ("8 字形" in said) == (found.turning == 0 and len(found.crossings) == 1)
    assert ("inner loop" in said) == ("内环" in said) == (abs(found.turning or 0) == 2 and len(found.crossings) == 1)


def test_among_these_curves_some_cross_themselves_and_some_do_not() -> None:
    crossings = [len(coupler(*curve)[0].crossings) for curve in CURVES]
    assert 0 in crossings and max(crossings) >= 1


def test_a_curve_is_gone_round_the_other_way_when_the_crank_turns_the_other_way() -> None:
    (one, said, _), (two, told, _) = coupler(*CURVES[0]), coupler(*CURVES[0], sense="cw")
    assert one.turning == -(two.turning or 0) == 1
    assert (
        "once counter-clockwise" in said
        and "once clockwise" in told
        and "切线逆时针转过 360°" in said
        and "切线顺时针转过 360°" in told
    )


def test_the_box_of_a_path_without_end_holds_what_is_near() -> None:
    problem = loads("""
id: e
title: e
frame: {A: [0 mm, 0 mm]}
links: {1: {slot: A}, 2: {block: B}, 3: {block: B}}
joints: [2 slides in 1, 3 slides on x = 50 mm]
input: {link: 1, phi: 20 deg, omega: 10 rad/s ccw}
find: [v_B]
""")
    found = path(cycle(problem), "B")
    assert math.isinf(found.length) and not found.closed and found.turning is None and found.shape is Shape.LINE
    assert found.low.real == pytest.approx(0.05) and found.high.real == pytest.approx(0.05)
    assert (
        found.low.imag < -0.5
        and found.high.imag > 0.5
        and max(abs(found.low), abs(found.high)) <= 1e3 * problem.mechanism.scale
    )


# -- the last printed digit -----------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("half_units", "verdict"),
    [
        (0.98, Verdict.REPRODUCED),
        (-0.98, Verdict.REPRODUCED),
        (1.02, Verdict.ROUNDING),
        (-1.02, Verdict.ROUNDING),
        (3.9, Verdict.ROUNDING),
        (4.1, Verdict.WRONG),
    ],
)
def test_half_a_unit_of_the_last_digit_divides_reproduced_from_rounding(half_units: float, verdict: Verdict) -> None:
    true = float(np.real(oracle.solve(loads(PIN).mechanism).omega("2")))
    text = f"{true:.2f}"
    there = (float(text) + half_units * 0.01 / 2) / true  # the printed number stays, the truth moves
    scaled = PIN.replace("omega: 10 rad/s ccw", f"omega: {10 * there:.12f} rad/s ccw")
    answers = check_problem(loads(scaled + f"printed: [{{symbol: omega_2, value: {text} rad/s}}]\n")).answers
    assert [answer.verdict for answer in answers] == [verdict]


# -- a knot drawn apart ---------------------------------------------------------------------------------------------


def knotted() -> Figure:
    """A polygon with four letters within 3 mm, lines that pass through the knot,
    end in it, pass beside it; an arrow whose tip lies beyond."""
    spots = [20 + 10j, 21.5 + 10.4j, 20.6 + 11.6j, 22 + 12j]
    letters = tuple(Point(at=z, label=letter, dot=Dot.POINT) for z, letter in zip(spots, "bcde", strict=True))
    lines = (
        Segment(a=0j, b=40 + 21j, role=Role.DIRECTION),
        Vector(a=0j, b=spots[0], role=Role.GIVEN),
        Vector(a=spots[1], b=60 + 5j, role=Role.RESULT),
        Segment(a=-30j, b=70 - 20j, role=Role.DIRECTION),
        Vector(a=spots[0], b=spots[3], role=Role.RESULT),
    )
    return Figure(
        view=View.VELOCITY,
        title=Words("速度多边形", "Velocity polygon"),
        scale=Scale(symbol="μ_v", value=0.01, unit="m/s"),
        marks=(Point(at=0j, label="p", dot=Dot.POLE), *letters, *lines, ImageOf(points=(0j, spots[1], 60 + 40j))),
    )


def details() -> list[tuple[Figure, Knot, Figure]]:
    """Every knot with its figure and its detail: of the library, and of one made here."""
    figures = [knotted(), *(f for name in IDS for f in drawn(name).construction.figures)]
    return [
        (f, knot, detail) for f in figures if knots(f) for knot, detail in zip(shown(f), detailed(f)[1:], strict=True)
    ]


def test_there_are_knots_to_draw_apart() -> None:
    assert len(details()) >= 40 * len(IDS) / len(LIBRARY) and len(detailed(knotted())) == 2


def test_nothing_of_a_detail_lies_outside_its_ring_and_all_is_as_many_times_larger() -> None:
    for figure, knot, detail in details():
        size = knot.radius * knot.factor
        assert (
            detail.scale.value == pytest.approx(figure.scale.value / knot.factor)
            and f"{knot.factor:g}:1" in detail.title.zh
        )
        for mark in detail.marks:
            points = {Point: ("at",), Segment: ("a", "b"), Vector: ("a", "b")}.get(type(mark), ())
            assert all(abs(getattr(mark, name)) <= size + 1e-9 for name in points), mark
            if isinstance(mark, ImageOf):
                assert all(abs(z) <= size + 1e-9 for z in mark.points)
        rings = [m for m in detail.marks if isinstance(m, Arc)]
        assert [(m.centre, m.radius) for m in rings] == [(0j, size)]


def test_lines_of_a_detail_are_the_pieces_of_the_lines_that_pass_through_the_knot() -> None:
    for figure, knot, detail in details():
        lines = [m for m in figure.marks if isinstance(m, Segment | Vector) and abs(m.b - m.a) > 0.05]
        passing = [
            m
            for m in lines
            if shapely.LineString([(m.a.real, m.a.imag), (m.b.real, m.b.imag)]).distance(
                shapely.Point(knot.centre.real, knot.centre.imag)
            )
            < knot.radius - 1e-6
        ]
        pieces = [m for m in detail.marks if isinstance(m, Segment | Vector)]
        assert len(pieces) == len(passing)  # none in a series of points alone
        for whole, piece in zip(passing, pieces, strict=True):
            a, b = (z / knot.factor + knot.centre for z in (piece.a, piece.b))
            along = (whole.b - whole.a) / abs(whole.b - whole.a)
            assert max(abs(((z - whole.a) * along.conjugate()).imag) for z in (a, b)) < 1e-9
            assert isinstance(piece, Vector) == (isinstance(whole, Vector) and abs(b - whole.b) < 1e-9)
            assert abs(abs(b - knot.centre) - knot.radius) < 1e-9 or abs(b - whole.b) < 1e-9
            assert abs(abs(a - knot.centre) - knot.radius) < 1e-9 or abs(a - whole.a) < 1e-9


def test_letters_of_a_knot_stand_in_the_detail_and_those_of_three_places_in_the_figure_too() -> None:
    """A pole and a joint keep theirs."""
    for figure, knot, detail in details():
        left = {m.at for m in detailed(figure)[0].marks if isinstance(m, Point) and knot.holds(m.at) and m.label}
        inside = [m.label for m in figure.marks if isinstance(m, Point) and knot.holds(m.at) and m.label]
        small = [m for m in figure.marks if isinstance(m, Vector) and 0.1 < abs(m.b - m.a) < READABLE]
        held = [m for m in small if knot.holds(m.a) and knot.holds(m.b) and abs(m.b - m.a) * knot.factor >= READABLE]
        circles = [m for m in figure.marks if isinstance(m, FrictionCircle) and knot.holds(m.centre)]
        places = [m.at for m in figure.marks if isinstance(m, Point) and knot.holds(m.at) and m.label]
        twins = any(TWINS[0] <= abs(a - b) <= TWINS[1] for a, b in combinations(places, 2))
        assert sum(all(abs(at - one) > 0.3 for one in [*left][:n]) for n, at in enumerate(left)) <= 3
        ends = [end for m in figure.marks if isinstance(m, Segment | Vector) for end in (m.a, m.b)]
        hidden = any(sum(abs(end - (a + b) / 2) <= ABOUT for end in ends) >= LINES for a, b in combinations(places, 2))
        assert len(inside) >= 3 or held or twins or hidden or any(2 * m.radius < ROUND for m in circles)
        assert set(inside) <= {m.label for m in detail.marks if isinstance(m, Point)}
        names = {m.label for m in detailed(figure)[0].marks if isinstance(m, Point)}
        assert any(
            f" {name}（" in detail.title.zh and f" {normalize('NFKC', name)} (" in detail.title.en
            for name in names & set(ROMAN)
        )
