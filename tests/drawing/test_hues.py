"""One hue for one vector wherever it appears; in grey it is known by its letters; and all can be black."""

from __future__ import annotations

from dataclasses import replace
from functools import cache
from io import BytesIO
from itertools import combinations

import numpy as np
import pdfplumber
import pytest

from tests.drawn_library import IDS, drawn
from tests.each import each
from vecpoly.algebra.formula import is_symbol
from vecpoly.board.construction import Construction, Figure
from vecpoly.board.paper.marks import Point, Role, Segment, TurnArrow, Vector
from vecpoly.board.paper.tones import CLOSE, HUES, MANY, key_of, tones, whose
from vecpoly.drawing.beside import beside
from vecpoly.drawing.details.apart import detailed
from vecpoly.drawing.figure import draw_figure
from vecpoly.drawing.hues import dash_of, hue_of, ink_called, ink_of, is_hollow, mark_hue
from vecpoly.drawing.scene import Scene, Stroke, TextBox
from vecpoly.drawing.style import THIN
from vecpoly.drawing.symbols.around import Surroundings
from vecpoly.drawing.symbols.marks import draw
from vecpoly.figures.hue import TONES, Hue
from vecpoly.names import ascii_key
from vecpoly.report.document import report_bytes
from vecpoly.report.flow.equation import EquationFlow, _columns
from vecpoly.report.tables import inks_of
from vecpoly.typeset import Glyphs

FOUR = ("3-9", "3-12", "4-3a", "A-27")  # a block, a slotted link, friction, a six-bar linkage
SPECK = 0.05  # mm: a shorter vector is no more than its arrowhead


def _vectors(figure: Figure) -> list[Vector]:
    return [mark for mark in figure.marks if isinstance(mark, Vector) and key_of(mark) and abs(mark.b - mark.a) > SPECK]


def _inks(construction: Construction, figure: Figure) -> dict[str, set[str]]:
    """The hues in which the shafts of a figure's vectors are drawn, by their keys."""
    found: dict[str, set[str]] = {}
    strokes = [item for item in draw_figure(figure).items if isinstance(item, Stroke)]
    inked = replace(figure, marks=beside(figure.view, figure.marks))
    for mark in _vectors(inked):
        of = {one.hue.name for one in strokes if abs(one.points[0] - mark.a) < 1e-9 and _along(one, mark)}
        found.setdefault(key_of(mark), set()).update(of)
    return found


def _along(stroke: Stroke, mark: Vector) -> bool:
    """Whether it is the shaft, which ends within the head."""
    return stroke.width > THIN and abs(stroke.points[-1] - mark.b) < min(3.0, 0.9 * abs(mark.b - mark.a))


@each(FOUR)
def test_a_vector_has_one_hue_in_equations_polygons_free_bodies_and_tables(name: str) -> None:
    """In each of its equations, on each figure, in the table of readings: that of its tone, and never another."""
    one = drawn(name)
    seen: dict[str, set[str]] = {}
    for figure in one.construction.figures:
        for key, inks in _inks(one.construction, figure).items():
            seen.setdefault(key, set()).update(inks)
    for step in one.construction.steps:
        for column, symbol in (
            zip(_columns(step.equation, "zh", 4.0), step.equation.symbols, strict=True) if step.equation else ()
        ):
            rgb = {item.rgb for item in column.cells[0].items if isinstance(item, Glyphs)}
            seen.setdefault(ascii_key(symbol), set()).update(_named(rgb))
    answers = one.solution.answers
    tones, read = one.construction.tones, {key: answer.reading for key, answer in answers.items()}
    told = {key: ink_called(key, read[key].symbol, tones, read[key].formula) for key in seen if key in read}
    assert {key: {told.get(key, ink_of(key, tones)).name} for key in seen} == seen
    assert len({ink for inks in seen.values() for ink in inks} - {"black"}) >= 4


def _named(rgbs: set[tuple[float, float, float] | None]) -> set[str]:
    by_value = {hue.value: hue.name for hue in TONES}
    return {"black" if rgb is None else by_value[rgb] for rgb in rgbs}


def test_a_force_is_known_by_its_hue_on_the_diagram_too() -> None:
    """Its line of action, the letter of that, the load itself, the force in the polygon and on both free bodies."""
    construction = drawn("4-6").construction
    by_view = {figure.view.name: draw_figure(figure) for figure in construction.figures}
    hue = ink_of("R_41", construction.tones)
    assert hue in TONES and ink_of("R_14_0", construction.tones) == hue
    thin = {item.hue for item in by_view["mechanism"].items if isinstance(item, Stroke) and item.width <= THIN}
    assert hue in thin and Hue.GREY in thin
    for view in ("mechanism", "force"):
        assert hue in {item.hue for item in by_view[view].items if isinstance(item, TextBox)}


@each(IDS)
def test_a_symbol_has_one_ink_in_equations_figures_and_tables(name: str) -> None:
    """By what is printed, not by keys: the F′ asked as F is that of its equation, not the F of the diagram."""
    one = drawn(name)
    tones, seen = one.construction.tones, dict[str, set[Hue]]()
    for figure in one.construction.figures:
        for mark in figure.marks if figure.view.across is None else ():
            if isinstance(mark, Vector | TurnArrow) and is_symbol(mark.label):
                ink = mark_hue(mark, figure.view, mark.label, figure.tones)
                seen.setdefault(ascii_key(mark.label), set()).add(ink)
    for step in one.construction.steps:
        for symbol, tone in zip(step.equation.symbols, step.equation.tones, strict=True) if step.equation else ():
            seen.setdefault(ascii_key(symbol), set()).add(hue_of(tone))
    for key, answer in one.solution.answers.items():
        symbol = ascii_key(answer.reading.symbol)
        if symbol in seen:
            (rgb,) = inks_of(one.solution, (key,))
            assert {hue.value for hue in seen[symbol]} == {rgb or Hue.BLACK.value}, symbol
    assert all(len(inks) == 1 for inks in seen.values()), seen
    assert all(ink_of(key, tones) in inks for key, inks in seen.items())


@each(IDS)
def test_vectors_of_one_figure_or_equation_that_are_not_one_have_different_tones(name: str) -> None:
    """Where more are drawn than there are tones, those that are left are black."""
    construction = drawn(name).construction
    tones = construction.tones
    together = [{whose(key_of(mark)) for mark in _vectors(figure)} for figure in construction.figures]
    together += [set(map(whose, map(ascii_key, s.equation.symbols))) for s in construction.steps if s.equation]
    for group in together:
        toned = [tones[one] for one in group if one in tones]
        assert len(toned) == len(set(toned)) and set(toned) <= set(range(1, MANY + 1))


def test_beyond_the_hues_vectors_have_hollow_shafts_and_none_is_left_black() -> None:
    """Thirteen and sixteen vectors in one figure: the first eight full, the others with the same hues again."""
    construction = drawn("stephenson-valve-gear").construction
    for figure in construction.figures[1:]:
        scene = draw_figure(figure)
        toned = {whose(key_of(mark)): construction.tones[whose(key_of(mark))] for mark in _vectors(figure)}
        assert len(toned) > HUES and len(set(toned.values())) == len(toned)
        hollow = {key for key, tone in toned.items() if tone > HUES}
        cores = [item for item in scene.items if isinstance(item, Stroke) and item.hue == Hue.WHITE]
        assert len(cores) >= len(hollow) > 0
        assert {whose(m.key) for m in _vectors(figure) if is_hollow(key_of(m), construction.tones)} == hollow


@each(IDS)
def test_in_grey_two_vectors_of_one_figure_differ_in_letters_or_in_dashes(name: str) -> None:
    """The symbol beside it, the letters at its ends, or its pattern."""
    for figure in drawn(name).construction.figures:
        lettered = [mark for mark in figure.marks if isinstance(mark, Point) and mark.label]
        seen: dict[tuple[object, ...], Vector] = {}
        for mark in _vectors(figure):
            ends = tuple(frozenset(p.label for p in lettered if abs(p.at - z) < SPECK) for z in (mark.a, mark.b))
            look = (mark.label, ends, dash_of(key_of(mark)))
            other = seen.setdefault(look, mark)  # one that coincides with it is the same line on paper
            assert abs(other.a - mark.a) + abs(other.b - mark.b) < SPECK or mark.label, (figure.name, look)


def test_a_component_is_the_motion_that_it_is_part_of_and_a_reaction_that_of_its_joint() -> None:
    assert len({whose(key) for key in ("v_CB", "v_BC", "an_CB", "at_CB", "a_CB")}) == 1
    assert len({whose(key) for key in ("R_12", "R_21", "R_12_0", "R_21,0", "R_12_n", "R_12_t", "Rt_12")}) == 1
    assert len({whose(key) for key in ("v_C2B", "v_C2C3", "v_C2", "R_12", "R_23", "R'_12", "F", "F_I2", "M_1")}) == 9
    assert whose("F'_0") == whose("F'") != whose("F")


def test_every_tone_can_be_read_and_told_from_the_others_by_eyes_that_confuse_hues() -> None:
    """Contrast at least 4.5 to 1 on white (WCAG); CIE76 at least 20, to deutan and protan eyes too (Machado 2009)."""
    linear = np.array([_linear(hue.value) for hue in (*TONES, Hue.BLACK)])
    luminance = linear @ _XYZ[1]
    assert all(1.05 / (light + 0.05) >= 4.5 for light in luminance[:-1])
    for eyes in (np.eye(3), _DEUTAN, _PROTAN):
        seen = [_lab(rgb) for rgb in linear @ eyes.T]
        assert min(float(np.linalg.norm(a - b)) for a, b in combinations(seen, 2)) > 20


def test_no_two_hues_look_alike() -> None:
    """CIEDE2000 at least 18: of the purple, the plum and the dark blue that stood side by side it was 14."""
    seen = [_lab(rgb) for rgb in np.array([_linear(hue.value) for hue in TONES])]
    assert min(_unlike(a, b) for a, b in combinations(seen, 2)) > 18


def _unlike(one: np.ndarray, other: np.ndarray) -> float:
    """CIEDE2000 (Sharma, Wu, Dalal 2005)."""
    labs = np.array([one, other])
    seventh = np.hypot(*labs[:, 1:].T).mean() ** 7
    a, b = labs[:, 1] * (1.5 - 0.5 * np.sqrt(seventh / (seventh + 25.0**7))), labs[:, 2]
    chroma, angle = np.hypot(a, b), np.degrees(np.arctan2(b, a)) % 360
    turn = (angle[1] - angle[0] + 180) % 360 - 180
    light, strong, way = labs[:, 0].mean(), chroma.mean(), angle[0] + turn / 2
    arcs = np.cos(np.radians([way - 30, 2 * way, 3 * way + 6, 4 * way - 63]))
    t = 1 + arcs @ [-0.17, 0.24, 0.32, -0.20]
    parts = (
        (labs[1, 0] - labs[0, 0]) / (1 + 0.015 * (light - 50) ** 2 / np.sqrt(20 + (light - 50) ** 2)),
        (chroma[1] - chroma[0]) / (1 + 0.045 * strong),
        2 * np.sqrt(chroma.prod()) * np.sin(np.radians(turn / 2)) / (1 + 0.015 * strong * t),
    )
    bent = np.sin(np.radians(60 * np.exp(-((((way % 360) - 275) / 25) ** 2))))
    rotation = -2 * np.sqrt(strong**7 / (strong**7 + 25.0**7)) * bent
    return float(np.sqrt(sum(part**2 for part in parts) + rotation * parts[1] * parts[2]))


_XYZ = np.array([[0.4124, 0.3576, 0.1805], [0.2126, 0.7152, 0.0722], [0.0193, 0.1192, 0.9505]])
_DEUTAN = np.array([[0.367322, 0.860646, -0.227968], [0.280085, 0.672501, 0.047413], [-0.01182, 0.04294, 0.968881]])
_PROTAN = np.array([[0.152286, 1.052583, -0.204868], [0.114503, 0.786281, 0.099216], [-0.003882, -0.048116, 1.051998]])


def _linear(rgb: tuple[float, float, float]) -> list[float]:
    return [part / 12.92 if part <= 0.04045 else ((part + 0.055) / 1.055) ** 2.4 for part in rgb]


def _lab(linear: np.ndarray) -> np.ndarray:
    white = np.array([0.9505, 1.0, 1.089])
    x, y, z = (np.cbrt(t) if t > 0.008856 else 7.787 * t + 16 / 116 for t in _XYZ @ np.clip(linear, 0, 1) / white)
    return np.array([116 * y - 16, 500 * (x - y), 200 * (y - z)])


@pytest.mark.parametrize(("style", "plain"), [("solution", True), ("question", False)])
def test_an_examination_is_printed_in_black_and_so_is_every_question(style: str, plain: bool) -> None:
    page = report_bytes([drawn("4-3a").solution], style=style, plain=plain)
    assert _hues_of_lines(page) == set() and len(_hues_of_lines(_coloured())) >= 4


@cache
def _coloured() -> bytes:
    return report_bytes([drawn("4-3a").solution])


@cache
def _hues_of_lines(pdf: bytes) -> set[tuple[float, ...]]:
    """The inks of lines and letters that are neither black nor grey, nor the pale squares to work on."""
    with pdfplumber.open(BytesIO(pdf)) as pages:
        inks = {
            tuple(ink)
            for page in pages.pages
            for one in (*page.lines, *page.curves, *page.chars)
            for ink in (one["stroking_color"], one["non_stroking_color"])
            if isinstance(ink, tuple) and len(ink) == 3
        }
    return {ink for ink in inks if max(ink) - min(ink) > 0.02 and min(ink) < 0.7}


def test_what_stands_after_a_coloured_symbol_is_black_again() -> None:
    """In one line of type as in the next."""
    equation = next(step.equation for step in drawn("3-9").construction.steps if step.equation)
    assert any(equation.tones) and isinstance(EquationFlow(equation), EquationFlow)
    with pdfplumber.open(BytesIO(report_bytes([drawn("3-9").solution]))) as pages:
        signs = [char for page in pages.pages for char in page.chars if char["text"] in "=+?"]
    assert signs and all(_grey(sign["non_stroking_color"]) for sign in signs)


def _grey(ink: float | tuple[float, ...]) -> bool:
    return not isinstance(ink, tuple) or max(ink) - min(ink) < 0.02


def test_a_scene_in_black_keeps_every_line_of_the_coloured_one() -> None:
    """Only inks differ: no line, no letter moves."""
    figure = drawn("3-9").construction.figures[1]
    black = drawn("3-9").construction.toned({}).figures[1]
    assert _shapes(draw_figure(figure)) == _shapes(draw_figure(black))
    assert {item.hue for item in draw_figure(black).items} <= {Hue.BLACK, Hue.GREY, Hue.WHITE, Hue.PLATE}
    assert hue_of(0) is Hue.BLACK and any(item.hue in TONES for item in draw_figure(figure).items)


def _shapes(scene: Scene) -> list[object]:
    return [item.points if not isinstance(item, TextBox) else (item.x, item.y, item.box) for item in scene.items]


def test_couples_and_lines_have_the_hue_of_their_force_or_none() -> None:
    """As they are drawn: a couple in that of its vector, a line of action in that of its force, else in no tone."""
    figures = drawn("4-3a").construction.figures
    seen: set[type] = set()
    for figure in figures:
        around = Surroundings.of(figure.view, figure.marks, "zh", figure.tones)
        for mark in figure.marks:
            if not (isinstance(mark, TurnArrow) or (isinstance(mark, Segment) and mark.key.startswith("R_"))):
                continue
            inks = {item.hue for item in draw(mark, around) if isinstance(item, Stroke)}
            own = Hue.BLACK if mark in around.common else ink_of(key_of(mark), figure.tones)
            assert inks == {own} if own in TONES else not inks & set(TONES), (figure.name, mark)
            seen |= {type(mark)} if own in TONES else set()
    assert seen == {TurnArrow, Segment}


def test_the_line_on_which_both_reactions_of_a_two_force_link_lie_has_the_ink_of_neither() -> None:
    """It changed its colour half way, and once more in the detail."""
    figure = drawn("4-3b").construction.figures[0]
    common = Surroundings.of(figure.view, figure.marks, "en", figure.tones).common
    assert {line.key.removesuffix("_0") for line in common} >= {"R_21", "R_32"}
    assert len({ink_of(line.key, figure.tones) for line in common}) == 2
    for one in detailed(figure)[1:]:
        assert not any(isinstance(mark, Segment) and mark.key == "R_32" for mark in one.marks)


def test_hues_that_are_close_stand_side_by_side_only_where_no_other_is_left() -> None:
    few = tones([tuple(Vector(a=0j, b=1j, role=Role.GIVEN, key=f"v_{letter}", step=1) for letter in "ABCDEF")], [])
    assert not any({a, b} <= set(few.values()) for a, b in CLOSE)
    assert len(set(few.values())) == 6


def test_motions_of_one_point_that_nothing_shows_together_have_one_hue() -> None:
    """v_K of the pitch point, and a_K5 of the rack; a_K4 of the gear, which stands beside a_K5, has its own."""
    found = drawn("travel-doubler").construction.tones
    assert found["motion K"] == found["motion K5"] != found["motion K4"]
