"""One vector, one hue: in the player as on paper, in each term of its equations and each arrow of its figures."""

from __future__ import annotations

import cmath
import re
from html import unescape

import pytest

from tests.laws import few
from tests.player.pages import page_of, solved
from vecpoly.board.construction import Figure
from vecpoly.board.paper.marks import Vector
from vecpoly.board.paper.tones import key_of as key_of_mark
from vecpoly.drawing.beside import beside
from vecpoly.drawing.hues import ink_of
from vecpoly.player.figures import key_of
from vecpoly.player.steps import vector
from vecpoly.tagging.speech import said
from vecpoly.words import Lang

FOUR = ("3-9", "3-12", "4-3a", "A-27")  # a block, a slotted link, friction, a six-bar linkage
SHORT = 1.0  # mm: of a shorter vector there is little but its arrowhead
LANGS: tuple[Lang, ...] = ("zh", "en")
TERM = re.compile(r'(?:style="color:var\(--(tone-\d)\)">)?<span class="formula" role="img" aria-label="([^"]*)">')
SHAFT = re.compile(r"M(-?\d+) ?(-?\d+)l(-?\d+) ?(-?\d+)")


@pytest.mark.parametrize("name", few(FOUR, 2))
def test_every_term_of_an_equation_has_the_hue_of_its_vector(name: str) -> None:
    toned = 0
    for step in solved(name).construction.steps:
        if step.equation is None:
            continue
        own = re.search(rf'<li id="step-{step.number}".*?</li>', page_of(name, 0), re.S)
        assert own is not None
        found = [(tone, unescape(label)) for tone, label in TERM.findall(own[0])]
        assert found == [
            (f"tone-{tone}" if tone else "", said(vector(symbol), lang))
            for lang in LANGS
            for symbol, tone in zip(step.equation.symbols, step.equation.tones, strict=True)
        ]
        toned += sum(map(bool, step.equation.tones))
    assert toned >= 3


@pytest.mark.parametrize("name", few(FOUR, 2))
def test_every_arrow_of_a_figure_has_the_hue_of_its_vector(name: str) -> None:
    page, construction = page_of(name, 0), solved(name).construction
    inks = dict(re.findall(r"\.(s\d+)\{stroke:var\(--([\w-]+)\)", page))
    toned = 0
    for figure in construction.figures:
        shafts = _shafts(page, figure, inks)
        for mark in _vectors(figure):
            ink = ink_of(key_of_mark(mark), construction.tones).name.replace("_", "-")
            drawn = {
                one for one, start, along in shafts if abs(start - mark.a) < 0.02 and _alike(along, mark.b - mark.a)
            }
            assert ink in drawn, (figure.view.name, mark.key)
            toned += ink.startswith("tone")
    assert toned >= 4


def _vectors(figure: Figure) -> list[Vector]:
    """The vectors as they are inked: side by side where several lie on one line."""
    inked = beside(figure.view, figure.marks)
    found = [mark for mark in inked if isinstance(mark, Vector) and key_of_mark(mark)]
    return [mark for mark in found if abs(mark.b - mark.a) > SHORT]


def _shafts(page: str, figure: Figure, inks: dict[str, str]) -> list[tuple[str, complex, complex]]:
    """The straight lines of a figure of the page: ink, where they begin (mm), and their direction."""
    own = re.search(
        rf'<g class="figure" data-key="{key_of(figure)}".*?(?=<g class="figure"|<g id="turned")', page, re.S
    )
    assert own is not None
    return [
        (inks[look], complex(int(x), -int(y)) / 100, complex(int(dx), -int(dy)))
        for look, path in re.findall(r'<path class="(s\d+)" d="([^"]*)"', own[0])
        for x, y, dx, dy in SHAFT.findall(path)
    ]


def _alike(along: complex, way: complex) -> bool:
    """Whether a line runs the way of a vector."""
    return abs(along) > 0 and abs(cmath.phase(along / way)) < 0.03
