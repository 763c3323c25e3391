"""The box for one's own answers in a real browser: the verdicts of `vecpoly check`, and nothing told before it is
asked."""

from __future__ import annotations

import json
import re
from base64 import b64decode
from pathlib import Path
from typing import Any

import pytest

from tests.chromium import Page
from tests.grading.cases import key_of, marked
from tests.laws import few
from tests.player.boxes import asked, at, html_of, judging, solution_of
from vecpoly.grading.compare.outcome import Finding, Outcome
from vecpoly.grading.key import Graded, Kind
from vecpoly.grading.student import check_answers
from vecpoly.player.page import player_html
from vecpoly.printed.units import printed_unit
from vecpoly.problem.load import load

NAMES = ("3-9", "4-3a")
SENSES = {"": 0, "ccw": 1, "cw": -1}
FACTORS = (1.0, 1.3, 0.5, 2.0, 10.0)


def judged(name: str, key: str, text: str) -> Finding:
    """What `check_answers` tells of one answer, by a key and mutants that are drawn once."""
    return marked(name, {key: text})[key]


def tried(one: Graded) -> list[tuple[str, str]]:
    """Values to be checked, each with a sense: right, just right, close, wrong by this and that, turned."""
    sizes = [abs(one.exact) * factor for factor in FACTORS]
    sizes += [abs(one.exact) + times * one.allowed for times in (0.9, -1.2, 2.2)]
    ways = ["ccw" if one.exact > 0 else "cw"] if one.kind is Kind.SIGNED else [""]
    cells = [(f"{size:.4g}", way) for size in sizes if size > 0 for way in ways]
    if one.kind is Kind.SIGNED:
        cells += [(f"{abs(one.exact):.4g}", way) for way in ("", "cw", "ccw")]
    return [cell for cell in cells if "e" not in cell[0]]


@pytest.mark.parametrize("name", few(NAMES, 2))
def test_the_box_says_what_the_program_says(name: str, chrome: Page, boxes: Path) -> None:
    judging(chrome, boxes, name)
    cells = [(index, one, *cell) for index, one in enumerate(asked(name)) for cell in tried(one)]
    words = [[index, f"{float(text) * printed_unit(one.unit)[0]:.10g}", SENSES[way]] for index, one, text, way in cells]
    verdicts = chrome.value(f"{json.dumps(words)}.map((typed) => check.judge(...typed).verdict)")
    assert len(cells) > 60
    for (_, one, text, way), theirs in zip(cells, verdicts, strict=True):
        mine = judged(name, one.key, f"{text} {way}".strip())
        expected = "right" if mine.outcome in (Outcome.RIGHT, Outcome.UNSAID) else mine.outcome.value
        expected = "wrong" if expected == "sense" else expected
        assert theirs == expected, (one.key, text, way, mine)


@pytest.mark.parametrize(("name", "key"), few([("3-9", "ak_C2C3"), ("4-3a", "M")], 2))
def test_what_is_judged_here_is_what_the_program_says(name: str, key: str) -> None:
    written = f"{abs(key_of(name)[key].exact) * 1.3:.4g}"
    assert check_answers(load(name), {key: written}).answers == (judged(name, key, written),)


@pytest.mark.parametrize(("problem", "key"), [("3-9", "ak_C2C3"), ("3-9", "v_E"), ("4-3a", "M")])
def test_reasons_are_those_of_the_program(problem: str, key: str, chrome: Page, boxes: Path) -> None:
    judging(chrome, boxes, problem)
    index = [one.key for one in asked(problem)].index(key)
    exact = key_of(problem)[key].exact
    for factor in few((0.5, 10.0, 1.6, 0.1, 0.01, 100.0), 2):
        mine = judged(problem, key, f"{exact * factor:.4g}")
        ids = {one.id.value for one in mine.messages}
        names = json.loads(chrome.value(f"JSON.stringify(check.judge({index}, '{exact * factor:.4g}').said)"))
        assert ("two_slips" in names) is ("two_slips" in ids) and ("sense" in names) is ("sense" in ids)
        assert any(name.startswith("pow10") for name in names) is ("pow10" in ids)


def test_nothing_is_told_before_it_is_asked(chrome: Page, boxes: Path) -> None:
    text = re.sub(r"<script.*?</script>", "", html_of("3-9"), flags=re.S)
    (block,) = re.findall(r'<details id="check">.*?</details>', text, re.S)
    shown = [row["shown"] for row in rows("3-9")]
    assert shown and not [one for one in shown if one in block]
    assert not [one for one in shown if len(one.partition(" ")[0]) > 4 and one.partition(" ")[0] in block]
    at(chrome, boxes, "3-9")
    assert chrome.value("all('#check .said').every((node) => node.textContent === '')")
    chrome.value("one('#check').open = true, one('#own-1').value = '0.3', one('#check form').requestSubmit()")
    said = json.loads(chrome.value("JSON.stringify(all('#check .said').map((node) => node.textContent))"))
    assert said[0] and not any(said[1:])
    chrome.value("one('#reveal').click()")
    told = json.loads(chrome.value("JSON.stringify(all('#check .said').map((node) => node.textContent))"))
    assert told == shown


@pytest.mark.parametrize(
    ("factor", "told"),
    few([(1.004, r"off by \+0\.4 % \(allowed ±"), (1.5, "about 50 % too large"), (0.4, "about 60 % too small"),
     (4.0, "about 4 times what it should be"), (1.0, "^Correct$")], 2),
)  # fmt: skip
def test_an_answer_is_told_by_how_much_it_is_off_and_a_wrong_one_only_about(
    factor: float, told: str, chrome: Page, boxes: Path
) -> None:
    at(chrome, boxes, "3-9", "en")
    value = f"{factor * abs(key_of('3-9')['v_E'].exact):.5g}"
    index = [one.key for one in asked("3-9")].index("v_E")
    chrome.value(
        f"one('#check').open = true, one('#own-{index + 1}').value = '{value}', one('#check form').requestSubmit()"
    )
    said = chrome.value(f"all('#check .said')[{index}].innerText")
    assert re.search(told, said), said
    if factor == 1.0:
        assert "%" not in said


def rows(name: str) -> list[dict[str, str]]:
    (data,) = re.findall(r'id="answers">([^<]+)<', html_of(name))
    found: list[dict[str, str]] = json.loads(b64decode(data))["rows"]
    return found


def test_keys_typed_into_the_box_do_not_turn_the_pages(chrome: Page, boxes: Path) -> None:
    at(chrome, boxes, "3-9")
    chrome.value("one('#check').open = true, one('#own-1').focus()")
    before = chrome.value("player.step")
    chrome.press("ArrowRight")
    chrome.press("End")
    assert chrome.value("player.step") == before


@pytest.mark.parametrize(
    ("text", "value"),
    [
        ("0.3", 0.3),
        ("０．３", 0.3),
        ("1.2×10^3", 1200.0),
        ("-2", -2.0),
        ("3e-2", 0.03),
        ("1.2×10³", 1200.0),
        ("0.012×100", 1.2),
        ("0.12 x 10", 1.2),
        ("12×10^{-1}", 1.2),
        ("12·10^(-1)", 1.2),
    ],
)
def test_numbers_are_read_as_people_write_them(text: str, value: float, chrome: Page, boxes: Path) -> None:
    judging(chrome, boxes, "3-9")
    assert chrome.value(f"check.read({json.dumps(text)}).value") == pytest.approx(value)
    assert chrome.value("check.read('abc') === null && check.read('') === null && check.read('.') === null")
    assert chrome.value("check.read('1e400') === null")


@pytest.mark.parametrize("name", few(NAMES, 2))
def test_the_box_is_small(name: str) -> None:
    without = player_html(solution_of(name), places=0)
    assert len(html_of(name)) - len(without) < 80_000 and 'id="check"' not in without


def test_the_box_takes_another_solution_that_serves_as_well(chrome: Page, boxes: Path) -> None:
    judging(chrome, boxes, "two-solutions")
    keys = [one.key for one in asked("two-solutions")]

    def found(**typed: str) -> list[dict[str, Any]]:
        rows = json.dumps([[typed[key], 0, ""] for key in keys])
        return json.loads(chrome.value(f"JSON.stringify(check.verdicts({rows}))"))  # type: ignore[no-any-return]

    assert all(one["said"] == ["right", "other_solution:2"] for one in found(BC="97.8", AD="163.1"))
    assert all(one["said"] == ["right"] for one in found(BC="97.8", AD="80.9"))
    assert [one["verdict"] for one in found(BC="128", AD="163.1")] == ["wrong", "wrong"]
