"""Free bodies, and groups drawn apart, that stand larger where their page has white, or their letters crowd."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from math import floor, log10

import pytest

from tests.drawn_library import drafted
from tests.drawn_sheets import laid
from vecpoly.board.acts.inkless import is_reading
from vecpoly.board.construction import Figure, View
from vecpoly.board.paper.arrow_radius import STEP, STEPS
from vecpoly.board.paper.marks import Block, FrictionCircle, Point, Role, Segment, TurnArrow
from vecpoly.board.paper.scales import HALF, SERIES
from vecpoly.drawing.details.larger import larger
from vecpoly.drawing.figure import drawing
from vecpoly.drawing.sheets.detailing import arrangements
from vecpoly.drawing.sheets.paging import best_paged
from vecpoly.drawing.sheets.scales.enlarging import ABOUT, MANY, MOST

SOME = ("crank-pin-in-slot", "2-6", "2-8full", "boom-thrust")


def _pairs(name: str) -> Iterator[tuple[Figure, Figure]]:
    """Each figure as it was constructed, and as it stands on its sheet."""
    solution = drafted(name)
    assert solution is not None
    made = {(one.view, one.name): one for one in solution.construction.figures}
    for sheet in laid(name):
        for one in sheet.figures:
            if one.figure is not None and (one.view, one.name) in made:
                yield made[one.view, one.name], one.figure


def _larger(name: str) -> list[tuple[Figure, Figure]]:
    return [(old, new) for old, new in _pairs(name) if new.scale.value < old.scale.value]


def _dots(figure: Figure) -> list[complex]:
    return [mark.at for mark in figure.marks if isinstance(mark, Point)]


def _most_about_one(figure: Figure) -> int:
    at = [label.centre for label in drawing(figure, lang="zh").labels]
    return max(sum(abs(z - w) <= ABOUT for w in at) for z in at)


@pytest.mark.parametrize("name", ["crank-pin-in-slot", "2-8full"])
def test_a_figure_in_which_letters_crowd_is_drawn_larger_and_fewer_stand_about_one_of_them_then(name: str) -> None:
    ((old, new),) = _larger(name)
    assert _most_about_one(old) >= MANY
    assert _most_about_one(new) < _most_about_one(old)


@pytest.mark.parametrize("name", SOME)
def test_what_is_larger_is_similar_and_true_to_a_round_scale_that_has_a_name_of_its_own(name: str) -> None:
    found = _larger(name)
    assert found
    for old, new in found:
        times = old.scale.value / new.scale.value
        assert 1.0 < times <= MOST + 1e-9
        assert _dots(new) == pytest.approx([times * at for at in _dots(old)])
        if old.scale.symbol:
            assert new.scale.symbol not in {one.scale.symbol for one, _ in _pairs(name)}
            mantissa = new.scale.value / 10.0 ** floor(log10(new.scale.value))
            assert any(mantissa == pytest.approx(step) for step in (*SERIES, HALF))


@pytest.mark.parametrize("name", ["two-trains-one-sun", "plate-two-slides", "boom-thrust"])
def test_a_figure_on_which_anything_is_read_stands_as_it_was_constructed(name: str) -> None:
    solution = drafted(name)
    assert solution is not None
    read = {act.figure for act in solution.construction.acts if is_reading(act)}
    found = [(old, new) for old, new in _pairs(name) if f"{old.view.name} {old.name}".strip() in read]
    assert len(found) > 1 and all(new.scale == old.scale for old, new in found)
    assert all(old.view is View.BODY for old, _ in _larger(name))


@pytest.mark.parametrize("name", SOME)
def test_larger_figures_ask_for_no_further_sheet(name: str) -> None:
    solution = drafted(name)
    assert solution is not None
    pages = best_paged(arrangements(solution.construction.figures, "zh"), solution.problem.paper)
    assert pages is not None and len(laid(name)) <= len(pages)


def test_a_circle_diagram_is_no_larger_than_it_was_constructed_beside_its_mechanism() -> None:
    found = [(old, new) for old, new in _pairs("3-3") if not old.scale.symbol]
    assert found and all(_dots(new) == _dots(old) for old, new in found)


def test_a_friction_circle_grows_with_its_body_and_a_block_keeps_its_size() -> None:
    circle = FrictionCircle(centre=4 + 2j, radius=1.5, enlarged=3.0)
    block, rod = Block(at=10 + 0j, along=1j), Segment(a=0j, b=3 + 4j, role=Role.LINK)
    old = next(one for one, _ in _pairs("2-6"))
    round_, slid, long = larger(replace(old, marks=(circle, block, rod)), 2.0).marks
    assert round_ == FrictionCircle(centre=8 + 4j, radius=3.0, enlarged=3.0)
    assert slid == Block(at=20 + 0j, along=1j) and isinstance(long, Segment) and abs(long.b - long.a) == 10.0


@pytest.mark.parametrize("name", ["2-6", "2-10", "2-13", "crank-pin-in-slot"])
def test_a_curved_arrow_is_a_symbol_and_no_larger_in_a_figure_that_is_larger(name: str) -> None:
    turned = 0
    for old, new in _pairs(name):
        radii = [[mark.radius for mark in one.marks if isinstance(mark, TurnArrow)] for one in (old, new)]
        turned += len(radii[0]) if new.marks != old.marks else 0
        assert all(was <= now <= was + STEP * STEPS for was, now in zip(*radii, strict=True))
    assert turned
