"""Claims about the symbols of GB/T 4460 on every diagram of the library: what runs on, what is one, what is pinned."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import pairwise

import pytest

from tests.drawn_library import IDS, drawn, ids
from tests.each import Later, each
from tests.found import FOUND
from vecpoly.board.construction import Figure, View
from vecpoly.board.paper.bodies import Block, FixedGuide, Passing, Plate, Weld
from vecpoly.board.paper.marks import Dot, Mark, Point, Role, Segment
from vecpoly.mechanism.groups.assur import hinges
from vecpoly.mechanism.model import Mechanism
from vecpoly.names import subscripted
from vecpoly.report.picture import scaled

DIAGRAMS = Later(lambda: (*ids(view=View.MECHANISM), *FOUND))
NEAR, END = 0.05, 2.5  # mm: places that are one; nearer to the end of a bar a pin is pinned there


def diagrams(name: str) -> Iterator[Figure]:
    """The figures on which links stand together: the diagram of a mechanism, sketches of structures."""
    for figure in drawn(name).figures(View.MECHANISM):
        if not figure.name or figure.name in ("diagram", "low"):
            yield figure


def lines(marks: tuple[Mark, ...], owner: str) -> list[tuple[complex, complex]]:
    """The bars and the edges of plates of a link."""
    found = [(m.a, m.b) for m in marks if isinstance(m, Segment) and m.role is Role.LINK and m.owner == owner]
    plates = [m.points for m in marks if isinstance(m, Plate) and m.owner == owner]
    return found + [edge for points in plates for edge in pairwise((*points, points[0]))]


def off(at: complex, line: tuple[complex, complex]) -> float:
    """How far a place is from a line, itself within; infinite beyond, and near, its ends."""
    a, b = line
    foot = (at - a) * (b - a).conjugate() / max(abs(b - a), NEAR)
    return abs(foot.imag) if END < foot.real < abs(b - a) - END else float("inf")


def pins(name: str, figure: Figure) -> dict[str, tuple[complex, tuple[str, ...]]]:
    """Where links are hinged: letter, place, links; of a mechanism those that are real."""
    at = {
        m.label: m.at for m in figure.marks if isinstance(m, Point) and m.dot in (Dot.JOINT, Dot.MULTIPLE) and m.label
    }
    subject = drawn(name).problem.subject
    if not isinstance(subject, Mechanism):
        return {}
    thought = {*subject.substitutes, *subject.slot_pins}
    linked = {subscripted(point): links for point, links in hinges(subject).items()}
    return {
        label: (spot, tuple(link for link in linked[label] if link not in thought))
        for label, spot in at.items()
        if label in linked
    }


@each(DIAGRAMS)
def test_a_bar_that_runs_on_past_a_pin_goes_round_it_and_no_other_does(name: str) -> None:
    for figure in diagrams(name):
        halves = [mark for mark in figure.marks if isinstance(mark, Passing)]
        for label, (at, links) in pins(name, figure).items():
            for owner in (f"link {link}" for link in links):
                runs_on = any(off(at, line) < 0.3 for line in lines(figure.marks, owner))
                drawn_so = any(half.owner == owner and abs(half.at - at) < NEAR for half in halves)
                assert runs_on == drawn_so, (label, owner)


@each(Later(lambda: ids(view=View.BODY)))
def test_a_link_by_itself_goes_round_pins_alone(name: str) -> None:
    for figure in drawn(name).figures(View.BODY):
        at = [m.at for m in figure.marks if isinstance(m, Point) and m.dot in (Dot.JOINT, Dot.MULTIPLE)]
        for half in (mark for mark in figure.marks if isinstance(mark, Passing)):
            assert any(abs(half.at - spot) < NEAR for spot in at)


def test_there_are_bars_that_run_on_in_exercises_3_5_and_2_9() -> None:
    for name, letter in (("3-5", "E"), ("2-9", "G"), ("C-conveyor", "C")):
        figure = next(diagrams(name))
        (at,) = {mark.at for mark in figure.marks if isinstance(mark, Point) and mark.label == letter}
        (half,) = [mark for mark in figure.marks if isinstance(mark, Passing) and abs(mark.at - at) < NEAR]
        ends = [
            complex(mark.a if abs(mark.b - at) < NEAR else mark.b)
            for mark in figure.marks
            if isinstance(mark, Segment) and mark.role is Role.LINK and min(abs(mark.a - at), abs(mark.b - at)) < NEAR
        ]
        assert ends and all((half.along.conjugate() * (end - at)).imag < 0 for end in ends), (
            "not away from the other link"
        )


@each(DIAGRAMS)
def test_three_links_on_one_pin_have_a_circle_within_a_circle_and_two_have_one(name: str) -> None:
    for figure in diagrams(name):
        for label, (_, links) in pins(name, figure).items():
            dots = {m.dot for m in figure.marks if isinstance(m, Point) and m.label == label}
            assert dots == {Dot.MULTIPLE if len(links) > 2 else Dot.JOINT}, label


def test_a_compound_hinge_that_is_to_be_found_is_ringed_by_the_step_that_finds_it() -> None:
    figure = next(diagrams("2-6"))
    rings = [mark for mark in figure.marks if isinstance(mark, Point) and mark.dot is Dot.MULTIPLE]
    letters = {m.label for ring in rings for m in figure.marks if isinstance(m, Point) and m.label and m.at == ring.at}
    assert letters == {"C", "F"} and all(ring.step > 1 for ring in rings)


@each(DIAGRAMS)
def test_a_centre_of_mass_that_is_no_pin_is_a_quartered_circle(name: str) -> None:
    problem, figure = drawn(name).problem, next(diagrams(name), None)
    if problem.acting is None or figure is None:
        return
    pinned = {subscripted(point) for point in hinges(drawn(name).problem.mechanism)}
    centres = {subscripted(mass.centre) for mass in problem.acting.masses} - pinned
    dots = {m.label: m.dot for m in figure.marks if isinstance(m, Point) and m.dot is not Dot.NONE}
    assert {label for label, dot in dots.items() if dot is Dot.MASS} == centres & set(dots)


@each((*IDS, *FOUND))
def test_where_a_bar_leaves_a_block_of_its_own_link_the_corner_is_filled(name: str) -> None:
    for figure in drawn(name).figures(View.MECHANISM):
        blocks = [mark for mark in figure.marks if isinstance(mark, Block)]
        for block in blocks:
            bars = [line for line in lines(figure.marks, block.owner) if any(_within(block, end) for end in line)]
            out = [line for line in bars if not all(_within(block, end, NEAR) for end in line)]  # past its walls
            corners = [m for m in figure.marks if isinstance(m, Weld) and m.owner == block.owner and m.at == block.at]
            for start, end in out:
                a, b = (start, end) if _within(block, start) else (end, start)
                assert any(_leaves(corner, a, b) for corner in corners), (a, b)
            assert all(
                abs(abs((m.off / block.along).real) - 4.5) < NEAR or abs(abs((m.off / block.along).imag) - 2.5) < NEAR
                for m in corners
            )


def _leaves(corner: Weld, start: complex, end: complex) -> bool:
    """Whether a filled corner stands on this bar where it comes out of its block."""
    turn, foot = corner.u / (end - start), (corner.at + corner.off - start) / (end - start)
    return abs(turn.imag) < 1e-6 * abs(turn) and turn.real > 0 and abs(foot.imag) * abs(end - start) < NEAR


def _within(block: Block, at: complex, by: float = -NEAR) -> bool:
    """Whether a place is in a block, or by no more than this beyond its walls."""
    foot = (at - block.at) / block.along
    return abs(foot.real) < block.length / 2 + by and abs(foot.imag) < 2.5 + by


@each(DIAGRAMS)
def test_in_a_reduced_picture_each_block_still_stands_on_its_guide(name: str) -> None:
    for figure in diagrams(name):
        for guide in (mark for mark in figure.marks if isinstance(mark, FixedGuide) and mark.about is not None):
            small = scaled(guide, 0.4)
            assert small.about is not None and guide.about is not None
            assert abs(small.about - 0.4 * guide.about) < NEAR
            way, share = (guide.b - guide.a) / abs(guide.b - guide.a), 0.4 if guide.to_scale else 1.0
            ends = ((guide.a, small.a), (guide.b, small.b))
            for before, after in ((one - guide.about, other - small.about) for one, other in ends):
                assert (after / way).imag == pytest.approx((before / way).imag, abs=NEAR)
                assert (after / way).real == pytest.approx(share * (before / way).real, abs=NEAR)
