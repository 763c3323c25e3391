"""Symbols on the page of the player: titles set as mathematics, words of indices upright, numbers with their units."""

from __future__ import annotations

import json
import re

import pytest

from tests.laws import few
from tests.player.pages import page_of, solved
from vecpoly.board.paper.marks import words_of
from vecpoly.player.figures import key_of
from vecpoly.player.setting.type import Faces, words_html

TITLES = ("8-4", "A-30-b")  # whose titles hold a symbol


@pytest.mark.parametrize("name", few(TITLES, 2))
def test_titles_hold_no_sign_of_their_symbols(name: str) -> None:
    page = page_of(name, 0)
    page = page[: page.rindex("<script>")]
    heading = page[page.index("<h1>") : page.index("</h1>")]
    assert "<i>" in heading, "a symbol is italic in the heading"
    titles = [*re.findall(r"<title.*?</title>", page), *re.findall(r' data-title-\w+="[^"]*"', page), heading]
    assert len(titles) == 5 and not any(sign in title for title in titles for sign in "${}")


@pytest.mark.parametrize(
    ("text", "kept"),
    [
        ("$l_{BC}$ = 180 mm, $φ_1$ = 64°", "=\u00a0180\u00a0mm, "),
        ("$μ_W = 0.15$ kg·m/mm and more", "\u00a0kg·m/mm and more"),
        ("$A$(165, −65) mm and more", "(165,\u00a0−65)\u00a0mm and more"),
        ("$ω_{21}$ = −0.2 − 1 = −1.2 rad/s, so", ">\u00a0=\u00a0−0.2\u00a0−\u00a01 =\u00a0−1.2\u00a0rad/s, so"),
        ("see link 3 there", "see link\u00a03 there"),
        (
            "so $ω = −0.2 − 1 = −1.2$ rad/s, clockwise",
            " =\u00a0−0.2\u00a0−\u00a01 =\u00a0−1.2</span>\u00a0rad/s, clockwise",
        ),
    ],
)
def test_no_line_parts_a_number_from_its_sign_or_its_unit(text: str, kept: str) -> None:
    assert kept in words_html(text, Faces())


def test_words_of_an_index_are_upright_and_its_letters_italic() -> None:
    said = words_html("$γ_{min}$, $n_{maxB}$, $l_{AB}$", Faces())
    assert re.findall(r"<sub>(.*?)</sub>", said) == ["min", "max<i>B</i>", "<i>AB</i>"]


def test_a_figure_that_moves_has_its_words_in_both_languages() -> None:
    """∥导路 along a guide, ∥guide."""
    found = re.search(r'<script type="application/json" id="motion">(.*?)</script>', page_of("3-12", 2), re.S)
    assert found is not None
    told = {one["key"]: [part["lang"] for part in one["sets"]] for one in json.loads(found[1])["figures"]}
    worded = {
        key_of(figure)
        for figure in solved("3-12").construction.figures
        if any(words.zh != words.en for mark in figure.marks if (words := words_of(mark)) is not None)
    }
    assert worded and {key for key, langs in told.items() if langs == ["zh", "en"]} == worded
