"""What the player says aloud: formulas, equations, vectors and readings as `tagging/speech.py` reads them out."""

from __future__ import annotations

import json
import re
from html import unescape
from pathlib import Path
from typing import Any

import pytest

from tests.chromium import Page
from tests.laws import few
from tests.player.pages import page_of, solved
from tests.texts import CRANK
from vecpoly.player.beats import beats
from vecpoly.player.page import player_html
from vecpoly.player.pointing import pointed
from vecpoly.problem.load import loads
from vecpoly.solution import solve
from vecpoly.tagging.speech import said, spoken, words_said
from vecpoly.words import Lang

KINEMATICS, FORCES = "3-9", "4-3a"
LANGS: tuple[Lang, ...] = ("zh", "en")


def told(page: str, number: int) -> str:
    """A step of the page."""
    found = re.search(rf'<li id="step-{number}".*?</li>', page, re.S)
    assert found is not None
    return found[0]


@pytest.mark.parametrize("name", few([KINEMATICS, FORCES], 2))
def test_every_formula_is_read_out_in_both_languages(name: str) -> None:
    for step in solved(name).construction.steps:
        own = told(page_of(name, 0, "en"), step.number)
        lines = re.findall(r'<p class="display"[^>]*><span class="formula" role="img" ([^>]*)>', own)
        heard = [{key: unescape(text) for key, text in re.findall(r'([\w-]+)="([^"]*)"', line)} for line in lines]
        assert {(one["data-zh"], one["data-en"], one["aria-label"]) for one in heard} == {
            (said(node, "zh"), said(node, "en"), said(node, "en")) for node in step.formulas
        }


@pytest.mark.parametrize("name", [KINEMATICS, FORCES])
def test_every_equation_is_read_out_with_its_directions_and_magnitudes(name: str) -> None:
    steps = [step for step in solved(name).construction.steps if step.equation is not None]
    assert steps
    for step in steps:
        labels = [
            unescape(text)
            for text in re.findall(r'role="group" aria-label="([^"]*)"', told(page_of(name), step.number))
        ]
        assert len(labels) == 2 and step.equation is not None
        for lang, label in zip(LANGS, labels, strict=True):
            for symbol in step.equation.symbols:
                assert spoken(symbol, lang) in label
            assert {"zh": "方向", "en": "Direction"}[lang] in label and {"zh": "大小", "en": "Magnitude"}[lang] in label


def test_a_power_is_never_read_as_a_second_number() -> None:
    large = loads(CRANK.replace("omega: 10 rad/s", "omega: 40000 rad/s").replace("find: [v_C]", "find: [v_C, a_C]"))
    page = player_html(solve(large, repeats=0), places=0)
    heard = [unescape(text) for text in re.findall(r'(?:aria-label|data-(?:say-)?(?:zh|en))="([^"]*)"', page)]
    assert any("squared" in one for one in heard) and any("to the power of" in one for one in heard)
    assert not any(re.search(r"[\^_{}$]|10 \d\b", one) for one in heard)


@pytest.mark.parametrize("name", [KINEMATICS, FORCES, "A-27", "six-bar-dynamic"])
def test_a_vector_is_named_by_the_symbol_of_its_equation(name: str) -> None:
    construction = solved(name).construction
    data: list[dict[str, Any]] = pointed(construction, beats(construction))
    symbols = {one for step in construction.steps if step.equation for one in step.equation.symbols}
    heard = {tuple(one["say"]) for one in data if "say" in one}
    known = {(f"作 {spoken(one, 'zh')}", f"draw {spoken(one, 'en')}") for one in symbols}
    assert heard & known and not any(re.search(r"[_{}]", text) for one in heard for text in one)


def test_a_step_is_told_whole_when_it_begins_and_then_what_is_new(chrome: Page, tmp_path: Path) -> None:
    page = show(chrome, tmp_path, "step=5")
    number = page.value("player.step")
    step = solved(KINEMATICS).construction.steps[number - 1]
    assert step.equation is None and step.formulas
    for lang in LANGS:
        page.value(f"player.setLang('{lang}'); 0")
        whole = page.value(f"beat.said(beat.first({number}))")
        assert words_said(step.words.of(lang), lang) in whole
        assert all(whole.count(said(node, lang)) == 1 for node in step.formulas)
    at = page.value("cut.findIndex((one) => one.say) + 1")
    assert page.value(f"beat.said({at})").startswith(("draw ", "Step "))


def test_readings_are_told_with_their_units_and_senses_in_words(chrome: Page, tmp_path: Path) -> None:
    page = show(chrome, tmp_path, "turn=0&lang=en")
    answers = solved(KINEMATICS).answers
    heard = page.value("player.said(0)").split(". ", 1)[1].split("; ")
    assert len(heard) == len(answers)
    for line, answer in zip(heard, answers.values(), strict=True):
        assert line.startswith(spoken(answer.reading.symbol, "en"))
        assert ("per second squared" in line) is (answer.reading.unit in ("m/s^2", "rad/s^2"))
        if answer.sense:
            assert line.endswith(" counter-clockwise" if answer.sense == "ccw" else " clockwise")
    between = page.value("player.said(0.5)")
    assert "about" in between and "metres per second" in between


def show(page: Page, folder: Path, where: str) -> Page:
    file = folder / "page.html"
    file.write_text(page_of(KINEMATICS), encoding="utf-8")
    page.open(f"{file.as_uri()}#{where}")
    page.wait("player.ready")
    return page


def test_the_data_of_the_page_hold_no_second_spelling_of_a_letter() -> None:
    found = re.search(r'id="motion">(.*?)</script>', page_of(KINEMATICS), re.S)
    assert found is not None
    points = [point for figure in json.loads(found[1])["figures"] for point in figure["points"]]
    assert points and all(one["say"] == [spoken(one["letter"], lang) for lang in LANGS] for one in points)
