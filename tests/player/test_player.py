"""The step player as a class gets it: one file that loads nothing,
says every step in both languages, and works by hand, key and ear."""

from __future__ import annotations

import re
from dataclasses import replace
from html.parser import HTMLParser
from pathlib import Path

import numpy as np
import pytest
from typer.testing import CliRunner

from tests.laws import few
from tests.player.pages import PLACES as FEWER
from tests.player.pages import motion, solved
from tests.player.pages import page_of as made
from vecpoly.cli.app import app
from vecpoly.player.beats import beats, stepped
from vecpoly.player.figures import shown_figures
from vecpoly.player.page import LIMIT, PLACES, player_html
from vecpoly.player.pointing import pointed
from vecpoly.player.setting.ink import Ink, path
from vecpoly.player.steps import said
from vecpoly.typeset.fonts import Face

KINEMATICS, FORCES, DEVICE, LARGE = "3-9", "4-3a", "5-5", "six-bar-dynamic"
EMPTY = {"meta", "link", "br", "input", "path", "rect", "use", "hr", "img"}


def page_of(name: str) -> str:
    """The page of a problem; the large one without the places of its drive, which would take longer than all others."""
    return made(name, 0) if name == LARGE else made(name)


class Reader(HTMLParser):
    """Reads a page: its text by language, its attributes, whether its elements close in order."""

    def __init__(self) -> None:
        super().__init__()
        self.open: list[str] = []
        self.steps: set[str] = set()
        self.unclosed: list[str] = []
        self.ids: list[str] = []
        self.wanted: list[str] = []
        self.unnamed = 0

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        found = dict(attrs)
        if tag not in EMPTY:
            self.open.append(tag)
        self.steps |= {found["data-step"] or ""} if tag == "g" and "data-step" in found else set()
        self.ids += [found["id"] or ""] if "id" in found else []
        self.wanted += [
            value[1:] for name, value in attrs if name in ("href", "xlink:href") and value and value.startswith("#")
        ]
        self.unnamed += tag == "input" and not found.get("aria-label")

    def handle_startendtag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        self.handle_starttag(tag, attrs)
        if tag not in EMPTY:
            self.open.pop()

    def handle_endtag(self, tag: str) -> None:
        if tag in EMPTY:
            return
        if not self.open or self.open.pop() != tag:
            self.unclosed.append(tag)


def read(page: str) -> Reader:
    reader = Reader()
    reader.feed(page)
    reader.close()
    return reader


@pytest.mark.parametrize("name", few([KINEMATICS, FORCES, DEVICE], 3))
def test_the_page_loads_nothing_from_anywhere(name: str) -> None:
    page = page_of(name)
    assert set(re.findall(r"https?://[^\"' )<]*", page)) <= {"http://www.w3.org/2000/svg"}
    assert not re.search(r"@import|<link|<img|<iframe|\beval\(|new Function|fetch\(|XMLHttpRequest|\bsrc=", page)
    assert all(url.startswith(("data:font/woff;base64,", "#")) for url in re.findall(r"url\(\"?([^)\"]*)", page))
    assert "default-src 'none'" in page  # and the browser is told to allow none


@pytest.mark.parametrize("name", [KINEMATICS, FORCES, DEVICE])
def test_the_page_is_well_formed_and_refers_to_nothing_that_is_not_there(name: str) -> None:
    reader = read(page_of(name))
    assert reader.open == [] and reader.unclosed == [] and reader.unnamed == 0
    assert len(reader.ids) == len(set(reader.ids))
    assert set(reader.wanted) <= set(reader.ids)


@pytest.mark.parametrize(("name", "places"), few([(LARGE, 0), (KINEMATICS, PLACES), (LARGE, PLACES)], 3))
def test_pages_are_under_a_megabyte(name: str, places: int) -> None:
    assert len(made(name, places).encode()) < LIMIT


def test_a_page_that_would_be_too_large_has_every_second_place_only(monkeypatch: pytest.MonkeyPatch) -> None:
    whole = page_of(KINEMATICS)
    monkeypatch.setattr("vecpoly.player.page.LIMIT", len(whole.encode()) - 1)
    page = player_html(solved(KINEMATICS), places=FEWER)
    assert len(page.encode()) < len(whole.encode())
    assert motion(page)["shown"] == motion(whole)["shown"][::2]


@pytest.mark.parametrize("name", [KINEMATICS, FORCES, DEVICE])
def test_every_step_is_told_in_both_languages(name: str) -> None:
    page = page_of(name)
    steps = solved(name).construction.steps
    assert len(re.findall(r'<li id="step-\d+"', page)) == len(steps)
    for step in steps:
        line = re.search(rf'<li id="step-{step.number}".*?</li>', page, re.S)
        assert line is not None
        for attribute, words in (("zh", said(step).zh), ("en", said(step).en)):
            assert f'data-say-{attribute}="{escaped(words)}"' in line[0]
        for shown, sentence in zip(
            re.findall(r'<span class="(?:zh|en)" lang="..">(.*?)</span>(?=<span class="en"|</p>)', line[0], re.S),
            (step.words.zh, step.words.en),
            strict=False,
        ):
            assert letters(re.sub(r"<[^>]*>", "", shown)) == letters(sentence)
        assert line[0].count('class="display"') == len(step.formulas)
        assert ('class="equation"' in line[0]) == (step.equation is not None)


def escaped(text: str) -> str:
    return (
        text.replace("&", "&amp;").replace("<", "&lt;").replace(">", "&gt;").replace('"', "&#34;").replace("'", "&#39;")
    )


def letters(text: str) -> str:
    """What is read of a sentence, without the marks of its notation."""
    plain = (
        text.replace("&lt;", "<")
        .replace("&gt;", ">")
        .replace("&amp;", "&")
        .replace("&quot;", '"')
        .replace("&#x27;", "'")
    )
    return "".join(
        sorted(
            plain.translate(
                str.maketrans({"-": "−", "'": "′", "µ": "μ", "⋅": "·"} | dict.fromkeys("${}_^ \u3000\xa0\n"))
            )
        )
    )


@pytest.mark.parametrize("name", [KINEMATICS, FORCES, DEVICE, LARGE])
def test_each_beat_that_draws_has_its_lines_in_a_group(name: str) -> None:
    drawn = {
        str(mark.step) for figure in stepped(solved(name).construction).figures for mark in figure.marks if mark.step
    }
    groups = read(page_of(name)).steps
    assert groups <= {str(beat.number) for beat in beats(solved(name).construction)}
    assert groups == drawn


def test_the_fonts_inside_have_every_character_that_is_set() -> None:
    from base64 import b64decode
    from io import BytesIO

    from fontTools.ttLib import TTFont

    page = page_of(KINEMATICS)
    fonts = {
        name: TTFont(BytesIO(b64decode(data))).getBestCmap()
        for name, data in re.findall(r"font-family:([\w-]+);src:url\(data:font/woff;base64,([^)]*)\)", page)
    }
    plain = re.sub(r"<style>.*?</style>|<script>.*?</script>|<[^>]*>", "", page, flags=re.S)
    han = {char for char in plain if "\u4e00" <= char <= "\u9fff"}
    assert {ord(char) for char in han} <= set(fonts["vp-vpsong"])
    assert "".join(sorted({chr(c) for c in fonts["vp-stix-italic"]} & set("ABCDEpvωα"))) == "".join(sorted("ABCDEpvωα"))
    assert set(fonts) <= {f"vp-{face.value.lower()}" for face in Face}


def test_what_differs_between_the_languages_is_there_in_both() -> None:
    figures = shown_figures(solved(KINEMATICS).construction, Ink())
    assert all(one.svg.count('<g class="zh">') == one.svg.count('<g class="en">') > 0 for one in figures)


def test_circles_become_arcs_and_polygons_do_not() -> None:
    ring = tuple(3 + 4j + 5 * np.exp(2j * np.pi * k / 48) for k in range(48))
    assert path(ring, True) == "M800-400a500 500 0 1 0 -1000 0a500 500 0 1 0 1000 0z"
    assert path(ring[:13], False) == "M800-400A500 500 0 0 0 300-900"
    assert path(tuple(np.exp(2j * np.pi * k / 6) for k in range(6)), True).startswith("M100 0l")
    assert path((0j, 1 + 1j, 3 - 2j), False) == "M0 0l100-100 200 300"


# -- the command -------------------------------------------------------------------------------------------------


def test_play_writes_the_file_it_names(tmp_path: Path) -> None:
    out = tmp_path / "new" / "play.html"
    done = CliRunner().invoke(app, ["play", KINEMATICS, "-o", str(out), "--places", "4", "--lang", "en"])
    assert done.exit_code == 0, done.output
    assert out.read_text(encoding="utf-8").startswith("<!DOCTYPE html>") and 'data-lang="en"' in out.read_text(
        encoding="utf-8"
    )


def test_play_refuses_an_unknown_problem_in_a_sentence() -> None:
    done = CliRunner().invoke(app, ["play", "no-such-problem"])
    assert done.exit_code == 2 and "Traceback" not in done.output


def test_text_of_a_problem_cannot_break_the_page() -> None:
    solution = solved(DEVICE)
    title = replace(solution.problem.title, zh="</title><script>alert(1)</script>", en='"><b>')
    page = player_html(replace(solution, problem=replace(solution.problem, title=title)))
    assert "<script>alert" not in page and read(page).unclosed == []


def test_a_length_is_pointed_at_beside_the_line_that_takes_it() -> None:
    """What is read when all is drawn glowed in the last line, all at once, and in none of its own."""
    construction = solved("3-9").construction
    cut = beats(construction)
    marked = {
        beat.step: data["marks"] for beat, data in zip(cut, pointed(construction, cut), strict=True) if "marks" in data
    }
    assert {6, 7, 11, 12} <= set(marked)
    assert isinstance(marked[12], list) and len(marked[12]) == 1


def test_lines_of_a_step_appear_from_above_to_below() -> None:
    for step in {beat.step for beat in beats(solved("4-3a").construction)}:
        shown = [n for beat in beats(solved("4-3a").construction) if beat.step == step for n in beat.formulas]
        assert shown == sorted(shown)
