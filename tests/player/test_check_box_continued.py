"""The box goes on with one's own earlier answers, and looks at directions, as `vecpoly check` does."""

from __future__ import annotations

import json
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest

from tests.chromium import Page
from tests.grading.cases import key_of, marked, problem_of
from tests.laws import few
from tests.player.boxes import asked, at, judging
from vecpoly.board.otherwise.amended import Amended, Own
from vecpoly.grading.compare.outcome import Basis, Finding
from vecpoly.grading.key import Graded, Kind
from vecpoly.grading.redraw import by_hands
from vecpoly.printed.units import printed_unit

OTHERWISE = [
    ("3-9", "omega_2", 1.3), ("3-9", "an_C2B", 0.6), ("3-9", "v_C2C3", 1.4), ("3-9", "ak_C2C3", 2.5),
    ("3-12", "omega_2", 1.6), ("3-12", "v_D5D4", 1.8), ("3-12", "ak_D5D4", 2.0),
    ("3-12", "omega_5", -1.0),
]  # fmt: skip


def going_on(name: str, own: str, factor: float) -> dict[str, float]:
    """Everything as it follows from another value of one quantity."""
    key = key_of(name)
    value = factor * abs(key[own].exact)
    found = by_hands(problem_of(name), key, Amended(own=(Own(values={own: value}),)))
    values = {one.key: found[one.key][0] for one in asked(name)}
    sizes = {k: float(abs(v)) if key[k].kind is Kind.VECTOR else float(v.real) for k, v in values.items()}
    return sizes | {own: factor * key[own].exact}


def typed(one: Graded, value: float | None, direction: str = "") -> list[Any]:
    """As it stands in the box: text, sense, direction."""
    if value is None:
        return ["", 0, ""]
    sense = 0 if one.kind is not Kind.SIGNED else 1 if value > 0 else -1
    size = value if one.kind is Kind.SCALAR else abs(value)
    return [f"{size * printed_unit(one.unit)[0]:.5g}", sense, direction]


def written(one: Graded, value: float) -> str:
    """The same for the program."""
    if one.kind is Kind.SIGNED:
        return f"{abs(value):.5g} {'ccw' if value > 0 else 'cw'}"
    return f"{value if one.kind is Kind.SCALAR else abs(value):.5g}"


def both(page: Page, name: str, values: dict[str, float]) -> Iterator[tuple[Finding, dict[str, Any]]]:
    """What the program and the box say of each answer."""
    every = asked(name)
    theirs = page.value(f"JSON.stringify(check.verdicts({json.dumps([typed(o, values.get(o.key)) for o in every])}))")
    checked = marked(name, {o.key: written(o, values[o.key]) for o in every if o.key in values})
    mine = {key: checked[key] for key in values}
    yield from ((mine[o.key], said) for o, said in zip(every, json.loads(theirs), strict=True) if o.key in mine)


@pytest.mark.parametrize(("name", "own", "factor"), few(OTHERWISE, 3))
def test_what_follows_from_ones_own_value_is_right_in_the_box_as_in_the_program(
    name: str, own: str, factor: float, chrome: Page, boxes: Path
) -> None:
    judging(chrome, boxes, name)
    values = going_on(name, own, factor)
    followed = 0
    for mine, theirs in both(chrome, name, values):
        right = theirs["verdict"] in ("right", "close")
        if mine.basis in (Basis.EXACT, Basis.OWN):
            assert right is mine.is_right, (mine.key, mine.outcome, mine.basis, theirs)
        followed += mine.basis is Basis.OWN and theirs["said"][0].startswith("ok_own")
    assert followed >= 1
    assert not any(said["verdict"] == "right" for one, said in both(chrome, name, {own: values[own]}))


def test_what_is_missing_between_is_reckoned_from_the_value_before_it(chrome: Page, boxes: Path) -> None:
    judging(chrome, boxes, "3-9")
    values = going_on("3-9", "omega_2", 1.3)
    few = {key: values[key] for key in ("omega_2", "alpha_3", "a_E", "omega_3")}
    found = {mine.key: (mine, theirs) for mine, theirs in both(chrome, "3-9", few)}
    assert all(found[key][0].basis is Basis.OWN for key in ("alpha_3", "omega_3"))
    assert all(found[key][1]["verdict"] == "right" for key in ("alpha_3", "omega_3"))
    far = going_on("3-9", "omega_2", 1.3) | {"omega_2": 30 * key_of("3-9")["omega_2"].exact}
    assert all(mine.is_right is (theirs["verdict"] in ("right", "close")) for mine, theirs in both(chrome, "3-9", far)
               if mine.basis in (Basis.EXACT, Basis.OWN))  # fmt: skip


@pytest.mark.parametrize(
    ("off", "verdict", "sentence"),
    [(0, "right", "right"), (1.5, "right", "right"), (40, "wrong", "dir:40"), (180, "wrong", "reversed")],
)
def test_a_direction_is_looked_at_where_it_is_written(
    off: float, verdict: str, sentence: str, chrome: Page, boxes: Path
) -> None:
    judging(chrome, boxes, "3-9")
    index = [one.key for one in asked("3-9")].index("v_E")
    one = asked("3-9")[index]
    assert one.degrees is not None
    text, aim = f"{one.exact:.4g}", f"{one.degrees + off:.1f}"
    mine = marked("3-9", {"v_E": f"{text} ∠ {aim}°"})["v_E"]
    assert mine.is_right is (verdict == "right")
    for call in (f"check.judge({index}, '{text}', 0, '{aim}')", f"check.judge({index}, '{text} ∠ {aim}°')"):
        assert json.loads(chrome.value(f"JSON.stringify({call})")) == {"verdict": verdict, "said": [sentence]}


@pytest.mark.parametrize(("turn", "verdict"), [(0, "right"), (4, "wrong"), (2, "wrong")])
def test_an_arrow_is_looked_at_as_the_marking_does(turn: int, verdict: str, chrome: Page, boxes: Path) -> None:
    judging(chrome, boxes, "3-9")
    index = [one.key for one in asked("3-9")].index("v_E")
    one = asked("3-9")[index]
    assert one.degrees is not None
    text, arrow = f"{one.exact:.4g}", "→↗↑↖←↙↓↘"[(round(one.degrees / 45) + turn) % 8]
    mine = marked("3-9", {"v_E": f"{text} {arrow}"})["v_E"]
    assert mine.is_right is (verdict == "right")
    for call in (f"check.judge({index}, '{text}', 0, '{arrow}')", f"check.judge({index}, '{text} {arrow}')"):
        assert json.loads(chrome.value(f"JSON.stringify({call})"))["verdict"] == verdict
    assert json.loads(chrome.value(f"JSON.stringify(check.judge({index}, '{text}', 0, 'there'))"))["said"] == ["unread"]


def test_the_sentence_names_the_own_value_as_it_was_typed(chrome: Page, boxes: Path) -> None:
    at(chrome, boxes, "3-9", "en")
    names = [one.key for one in asked("3-9")]
    for key, value in going_on("3-9", "omega_2", 1.3).items():
        if key in ("omega_2", "omega_3"):
            size, sense, _ = typed(key_of("3-9")[key], value)
            n = names.index(key) + 1
            chrome.value(
                f"one('#own-{n}').value = '{size}', one('select', all('#check .asked')[{n - 1}]).value = '{sense}'"
            )
    chrome.value("one('#check').open = true, one('#check form').requestSubmit()")
    said = chrome.value(f"all('#check .said')[{names.index('omega_3')}].innerText")
    assert "continued from your" in said and "2.59" in said
