"""The small figure beside a vector equation is the polygon that this equation draws, and can be read."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator
from functools import cache
from typing import Any, cast

import numpy as np

from tests.drawn_library import IDS as TAKEN
from tests.drawn_library import drawn
from tests.each import Later, each
from tests.label_faults import faults
from vecpoly.board.construction import Construction, EquationTable, Step
from vecpoly.board.paper.marks import Vector
from vecpoly.board.paper.tones import key_of, known_as
from vecpoly.drawing.figure import Bare, Drawing
from vecpoly.drawing.hues import hue_of
from vecpoly.drawing.inset.chain import chain_of
from vecpoly.drawing.inset.inset import EDGE, MANY, SHARE, Outline, inset
from vecpoly.drawing.inset.letters import lettered
from vecpoly.drawing.scene import Fill, Layer, Scene, Stroke, TextBox
from vecpoly.drawing.style import Hue
from vecpoly.foundation.slotted import replace
from vecpoly.report.flow.results.illustrated import HIGH, WIDE

SIZES = (1.0, 0.95, 0.9, 0.85, 0.8, 0.75)  # of the largest for which there is room, less the letters
SMALLEST = 7.0 / 72.0 * 25.4  # mm: letters of 7 pt
CORNERS = 4  # of an arrow's head, at most


@cache
def insets(name: str) -> tuple[tuple[Step, Outline, Scene], ...]:
    """The small figures of a problem, each with its step."""
    made = drawn(name).construction
    outlines = ((step, Outline.of(made, step)) for step in made.steps)
    scenes = ((step, one, inset(one, "zh", WIDE, HIGH)) for step, one in outlines if one is not None)
    return tuple((step, one, scene) for step, one, scene in scenes if scene is not None)


def arrows(scene: Scene) -> list[tuple[complex, complex, Hue]]:
    """Tail, head and hue of every arrow that is inked."""
    shafts = [one for one in scene.items if isinstance(one, Stroke) and one.layer is Layer.LINE and not _is_white(one)]
    heads = [one for one in scene.items if isinstance(one, Fill) and len(one.points) <= CORNERS and not _is_white(one)]
    return [(one.points[0], _tip(one, head), one.hue) for one, head in zip(shafts, heads, strict=True)]


def _is_white(item: Stroke | Fill) -> bool:
    return item.hue is Hue.WHITE


def _tip(shaft: Stroke, head: Fill) -> complex:
    return max(head.points, key=lambda z: abs(z - shaft.points[0]))


def equation(step: Step) -> EquationTable:
    assert step.equation is not None
    return step.equation


DRAWN = Later(lambda: [name for name in TAKEN if insets(name)])


@each(DRAWN)
def test_its_arrows_are_those_of_the_equation_on_the_sheet_all_made_smaller_alike(name: str) -> None:
    for _, outline, scene in insets(name):
        factors = [
            (tip - tail) / (one.b - one.a)
            for (tail, tip, _), one in zip(arrows(scene), outline.chain.vectors, strict=True)
        ]
        assert np.allclose(factors, factors[0]) and abs(factors[0].imag) < 1e-9 < factors[0].real


@each(DRAWN)
def test_its_arrows_stand_for_terms_of_the_equation_each_once(name: str) -> None:
    for step, outline, _ in insets(name):
        keys = [known_as("", symbol) for symbol in equation(step).symbols]
        terms = [next(key for key in keys if key in (one.key, key_of(one))) for one in outline.chain.vectors]
        assert not Counter(terms) - Counter(keys) and len(terms) <= MANY


@each(DRAWN)
def test_its_chains_stand_on_the_sheet_tail_to_head_and_end_in_one_point(name: str) -> None:
    for _, outline, _ in insets(name):
        chain, standing = outline.chain, set(outline.figure.marks)
        for side in chain.sides:
            assert np.isclose(sum(one.b - one.a for one in side), chain.end - chain.start, atol=0.1)
            assert standing.issuperset(side)
        assert len(chain.sides) > 1 or np.isclose(chain.start, chain.end, atol=0.01)


@each(DRAWN)
def test_its_arrows_have_the_hues_of_their_terms(name: str) -> None:
    for step, outline, scene in insets(name):
        table = equation(step)
        tones = {known_as("", symbol): tone for symbol, tone in zip(table.symbols, table.tones, strict=True)}
        for (_, _, hue), one in zip(arrows(scene), outline.chain.vectors, strict=True):
            assert hue is hue_of(tones[key_of(one)] if key_of(one) in tones else tones[one.key])


@each(DRAWN)
def test_no_letter_of_it_touches_a_line_or_another_letter(name: str) -> None:
    for step, _, scene in insets(name):
        boxes = [one.rect for one in scene.items if isinstance(one, TextBox)]
        lines = tuple(one for one in scene.items if not isinstance(one, TextBox))
        letters = cast(Any, [one for one in scene.items if isinstance(one, TextBox)])
        on_lines = [
            fault for fault in faults(Drawing(scene, letters, lines, scene.extents)) if " on label " not in fault
        ]
        assert not on_lines, (step.number, on_lines)
        assert not any(a.grown(-0.05).overlaps(b.grown(-0.05)) for n, a in enumerate(boxes) for b in boxes[:n])


@each(DRAWN)
def test_it_fits_its_place_and_its_letters_are_seven_points_high(name: str) -> None:
    for _, _, scene in insets(name):
        assert SHARE * scene.extents.width <= WIDE and SHARE * scene.extents.height <= HIGH
        sizes = [
            max(g.size for g in one.box.items if hasattr(g, "size")) for one in scene.items if isinstance(one, TextBox)
        ]
        assert sizes and SHARE * min(sizes) / 72.0 * 25.4 >= SMALLEST


@each(Later(lambda: [name for name in TAKEN if any(unlettered(name))]))
def test_only_a_polygon_too_small_to_be_seen_or_without_room_for_all_its_letters_has_none(name: str) -> None:
    for step, outline in unlettered(name):
        wide, high = WIDE / SHARE - 2 * EDGE, HIGH / SHARE - 2 * EDGE
        factor = min(wide / max(outline.extent.width, 1e-6), high / max(outline.extent.height, 1e-6))
        legible = [size * factor for size in SIZES] if outline.is_legible(SIZES[-1] * factor) else []
        assert not any(has_room(outline, size) for size in legible), step.number


def has_room(outline: Outline, factor: float) -> bool:
    """Whether all letters of a polygon of this size have a place, and all of it lies within its own."""
    figure, corners = outline.at(factor)
    bare = Bare.of(figure, "zh")
    letters = lettered(bare, corners)
    if letters is None:
        return False
    own = Scene.of(bare.items + tuple(item for one in letters for item in one.items())).extents
    return SHARE * own.width <= WIDE and SHARE * own.height <= HIGH


def test_letters_that_take_each_other_s_places_are_placed_together() -> None:
    found = insets("letters-in-each-other-s-way")
    assert [step.words.en.partition(" and draw")[0] for step, _, _ in found] == ["Write the equilibrium of link 1"]


def unlettered(name: str) -> Iterator[tuple[Step, Outline]]:
    """The steps of a problem that draw a polygon of which there is no small figure."""
    made, shown = drawn(name).construction, [step for step, _, _ in insets(name)]
    for step in made.steps:
        outline = Outline.of(made, step)
        if outline is not None and step not in shown:
            yield step, outline


def test_most_equations_of_motion_draw_a_polygon_that_is_found() -> None:
    steps = [(drawn(name).construction, step) for name in TAKEN for step in drawn(name).construction.steps]
    asked = [(made, step) for made, step in steps if step.equation is not None and step.view is not None]
    found = [1 for made, step in asked if _chain(made, step)]
    assert len(found) > 0.9 * len(asked)


def _chain(made: Construction, step: Step) -> bool:
    assert step.view is not None
    figure = made.figure(step.view)
    return figure is not None and chain_of(figure, step) is not None


def test_an_arrow_that_is_missing_or_off_makes_no_polygon_of_the_equation() -> None:
    made = drawn("3-9").construction
    step, outline, _ = insets("3-9")[0]
    for gone in outline.chain.vectors:
        bent = [replace(one, b=one.b + 1.0) if one is gone else one for one in outline.figure.marks]
        less = [one for one in outline.figure.marks if one is not gone]
        for marks in (bent, less):
            assert chain_of(replace(outline.figure, marks=tuple(marks)), step) is None
    assert _chain(made, step) and any(isinstance(one, Vector) for one in outline.figure.marks)


def test_where_all_is_black_it_is_black() -> None:
    made = drawn("3-9").construction.toned({})
    outlines = [found for step in made.steps if (found := Outline.of(made, step)) is not None]
    scenes = [scene for one in outlines if (scene := inset(one, "zh", WIDE, HIGH)) is not None]
    assert len(scenes) == 2 and all(hue is Hue.BLACK for scene in scenes for _, _, hue in arrows(scene))
