"""Known vectors of a polygon, found ones and directions are told apart at a glance, also in print, also in black."""

from __future__ import annotations

import pytest

from tests.drawn_library import IDS, drawn
from tests.each import each
from vecpoly.board.construction import Figure, Scale, View
from vecpoly.board.paper.marks import Mark, Role, Segment, Vector
from vecpoly.drawing.details.knot import Knot
from vecpoly.drawing.details.within import within
from vecpoly.drawing.figure import Bare
from vecpoly.drawing.legend.kinds import FOUND, KNOWN
from vecpoly.drawing.legend.vectors import key_of_vectors
from vecpoly.drawing.scene import Fill, Item, Stroke
from vecpoly.drawing.style import Hue
from vecpoly.drawing.symbols.around import Surroundings
from vecpoly.drawing.symbols.marks import draw
from vecpoly.words import Words


def _drawn(mark: Mark, view: View = View.VELOCITY) -> tuple[Item, ...]:
    return draw(mark, Surroundings(view=view))


def _width(items: tuple[Item, ...]) -> float:
    return max(item.width for item in items if isinstance(item, Stroke))


def _is_open(items: tuple[Item, ...]) -> bool:
    return any(isinstance(item, Fill) and item.hue is Hue.WHITE for item in items)


def _vector(role: Role, length: float = 40.0) -> Vector:
    return Vector(a=0j, b=complex(length), role=role)


@pytest.mark.parametrize("view", [View.VELOCITY, View.ACCELERATION, View.FORCE])
def test_a_found_vector_is_twice_as_wide_as_a_known_one_and_that_as_a_direction(view: View) -> None:
    found, known = (_width(_drawn(_vector(role), view)) for role in (Role.RESULT, Role.GIVEN))
    direction = _width(_drawn(Segment(a=0j, b=40 + 0j, role=Role.CONSTRUCTION), view))
    assert found >= 1.9 * known and known >= 1.9 * direction


@pytest.mark.parametrize("length", [4.0, 9.0, 40.0])
def test_a_known_vector_has_an_open_head_and_a_found_one_a_filled_one(length: float) -> None:
    assert _is_open(_drawn(_vector(Role.GIVEN, length))) and not _is_open(_drawn(_vector(Role.RESULT, length)))


def test_on_free_bodies_all_forces_have_filled_heads_for_there_nothing_is_laid_off() -> None:
    assert not _is_open(_drawn(_vector(Role.GIVEN), View.BODY))
    assert _width(_drawn(_vector(Role.RESULT), View.BODY)) < _width(_drawn(_vector(Role.RESULT)))


def test_the_white_of_an_open_head_lies_inside_it_and_its_tip_stays_where_it_is() -> None:
    outer, inner = (item for item in _drawn(_vector(Role.GIVEN)) if isinstance(item, Fill))
    assert outer.points[0] == 40 and all(36.9 < z.real < 39.9 and abs(z.imag) < 0.6 for z in inner.points)


def test_the_samples_of_the_legend_are_drawn_as_the_vectors_they_stand_for() -> None:
    scale = Scale(symbol="μ_v", value=0.01, unit="m/s")
    marks = (_vector(Role.GIVEN), _vector(Role.RESULT))
    figure = Figure(view=View.VELOCITY, title=Words("速度", "v"), scale=scale, marks=marks)
    for kind, mark in zip((KNOWN, FOUND), marks, strict=True):
        sample = Bare.of(
            Figure(view=View.VELOCITY, title=figure.title, scale=scale, marks=kind.sample(mark)), "zh"
        ).items
        assert _is_open(sample) is _is_open(_drawn(mark)) and _width(sample) == _width(_drawn(mark))


@each(IDS)
def test_a_motion_of_which_no_part_is_found_has_an_open_head_in_the_legend_and_no_other(name: str) -> None:
    from vecpoly.board.paper.tones import key_of, whose

    figures = [one for one in drawn(name).construction.figures if one.view.images and one.tones]
    entries = [*key_of_vectors(figures, "en")]
    roles: dict[str, set[Role]] = {}
    for figure in figures:
        for mark in figure.marks:
            shown = isinstance(mark, Vector) and not mark.label and abs(mark.b - mark.a) > 0.5
            if shown and isinstance(mark, Vector) and (motion := whose(key_of(mark))) in (figure.tones or {}):
                roles.setdefault(motion, set()).add(mark.role)
    assert len(entries) == len(roles)
    for entry, met in zip(entries, roles.values(), strict=True):
        hollow = any(item.hue is Hue.WHITE for item in entry.sample if isinstance(item, Stroke))
        assert hollow or _is_open(entry.sample) is (Role.RESULT not in met)


def test_a_vector_that_the_ring_of_a_detail_cuts_off_is_as_wide_there_as_the_whole() -> None:
    long = Vector(a=0j, b=60 + 0j, role=Role.RESULT, key="v_C")
    (cut,) = within(long, Knot(30 + 0j, 3.0, 5.0))
    assert isinstance(cut, Segment) and _width(_drawn(cut)) == _width(_drawn(long))
