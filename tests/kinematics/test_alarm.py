"""A drawn value that the exact one contradicts never passes as an answer:
in the terminal, on paper, in JSON, by exit code."""

from __future__ import annotations

import json
from collections.abc import Callable, Iterator
from dataclasses import replace
from functools import cache
from math import inf, nan
from pathlib import Path
from types import SimpleNamespace
from typing import Any, cast

import numpy as np
import pdfplumber
import pytest
from typer.testing import CliRunner

import vecpoly
from tests.drawn_library import DRAFTED, drafted, drawn, ids
from tests.flat_positions import FLAT
from tests.laws import few
from vecpoly import load, loads, solve
from vecpoly.answer import YES_NO
from vecpoly.check.alarm import Cause, Weighed, alarm_at
from vecpoly.check.precision import noise
from vecpoly.check.truth import Truth
from vecpoly.cli.app import app
from vecpoly.cli.errors import SUSPECT
from vecpoly.designs.base import Design
from vecpoly.drawing.sheets.boxes.titleblock import LABELS as STRIP
from vecpoly.errors import DeadPointError, NotAskedError, VecpolyError
from vecpoly.methods import answers
from vecpoly.methods.answers import answer
from vecpoly.methods.scaling import scaled
from vecpoly.solution import Solution, fewer_digits
from vecpoly.words import Lang

Spoil = Callable[[complex], complex]
RED = (0.78, 0.0, 0.0)
# were CD as long as AB, this would be a parallelogram, whose rates have all their digits everywhere
NEARLY = """
id: parallelogram
title: parallelogram
frame: {A: [0 mm, 0 mm], D: [100 mm, 0 mm]}
links: {1: {AB: 40 mm}, 2: {BC: 100 mm}, 3: {DC: 40.0000000002 mm}}
input: {link: 1, phi: PHI, omega: 10 rad/s ccw}
branch: [C left of BD]
find: [v_C, a_C, omega_3, alpha_3]
"""


@pytest.fixture
def spoilt(monkeypatch: pytest.MonkeyPatch) -> Iterator[Callable[[Spoil], None]]:
    """Make a method read v_E of 3-9 otherwise, by every hand; sketches are forgotten, before and after."""
    honest = answer

    def spoil(by: Spoil) -> None:
        def read(desk, rel):  # type: ignore[no-untyped-def]
            reading, scalars = honest(desk, rel)
            if rel.key != "v_E":
                return reading, scalars
            assert reading.vector is not None
            vector = by(reading.vector)
            return replace(reading, vector=vector, scalar=abs(vector)), scalars / reading.scalar * abs(vector)

        monkeypatch.setattr(answers, "answer", read)

    scaled.cache_clear()
    yield spoil
    scaled.cache_clear()


@cache
def _by_pencil(name: str) -> Solution | None:
    try:
        return solve(load(name), by="pencil")
    except VecpolyError:
        return None


def test_a_right_drawing_raises_no_alarm_by_any_hand() -> None:
    raised, solved = [], 0
    by_hands = [("drafting", name, drafted(name)) for name in DRAFTED]
    by_hands += [("pencil", name, _by_pencil(name)) for name in few(DRAFTED, 6)]
    for by, name, solution in by_hands:
        solved += solution is not None
        if solution is None or (by == "pencil" and not _finds_all(solution)):
            continue
        raised += [(name, by, key) for key, answer in solution.answers.items() if answer.suspect]
    assert solved > 0.75 * len(by_hands)
    assert raised == []


def _finds_all(solution: Solution) -> bool:
    """Whether a synthesis found on paper the candidates that there are: where it did not, the alarm is right."""
    found, right = solution.construction.candidates, drafted(solution.problem.id)
    return right is not None and [one.verdict for one in found] == [
        one.verdict for one in right.construction.candidates
    ]


def test_a_pencil_that_loses_candidates_of_a_synthesis_is_told_so() -> None:
    tried = (_by_pencil(name) for name in DRAFTED if isinstance(load(name).subject, Design))
    drawn = [one for one in tried if one is not None]
    small = vecpoly.loads(load(FLAT).text + "scales: {mu_l: 0.003 m/mm}\n").solve(by="pencil")
    assert not _finds_all(small), "at this scale a pencil loses candidates"
    for lost in (small, *(one for one in drawn if not _finds_all(one))):
        assert lost.suspect, lost.problem.id
        assert lost.construction.warning is not None and "candidates on paper" in lost.construction.warning.en


@pytest.mark.parametrize(
    ("by", "cause"),
    [
        (lambda v: 1.2 * v, Cause.APART),
        (lambda v: -v, Cause.APART),
        (lambda v: v * 1.00001, Cause.APART),
        (lambda v: v * 1j, Cause.APART),
        (lambda v: complex(nan, nan), Cause.NOT_FINITE),
        (lambda v: complex(inf, 0), Cause.NOT_FINITE),
    ],
    ids=["too long", "reversed", "off by 1e-5", "turned by 90°", "nan", "infinite"],
)
def test_a_method_that_draws_something_else_is_found_out(
    spoilt: Callable[[Spoil], None], by: Spoil, cause: Cause
) -> None:
    spoilt(by)
    solution = solve(load("3-9"))
    assert solution.suspect
    assert [key for key, answer in solution.answers.items() if answer.suspect] == ["v_E"]
    assert solution.answers["v_E"].suspect is cause
    assert solution.construction.warning is not None
    assert "v_{E}" in solution.construction.warning.zh and "v_{E}" in solution.construction.warning.en


@pytest.mark.parametrize("by", ["exact", "pencil"])
def test_where_there_is_an_alarm_it_is_the_same_hand_that_draws(spoilt: Callable[[Spoil], None], by: str) -> None:
    """What was solved in haste is solved again with care."""
    spoilt(lambda v: 1.2 * v)
    solution = solve(load("3-9"), by=by, repeats=0, precise=False)
    assert solution.suspect and solution.construction.hand == by


def test_the_alarm_is_a_flag_in_the_json_and_an_exit_code(spoilt: Callable[[Spoil], None], tmp_path: Path) -> None:
    spoilt(lambda v: 1.2 * v)
    run = CliRunner().invoke(app, ["solve", "3-9", "--json", str(tmp_path / "a.json")])
    assert run.exit_code == SUSPECT == 3
    assert "not to be taken as an answer" in run.stderr
    data = json.loads((tmp_path / "a.json").read_text(encoding="utf-8"))
    assert data["suspect"] is True
    assert [key for key, one in data["answers"].items() if one["suspect"]] == ["v_E"]


@pytest.mark.parametrize(
    "command",
    few(
        [
            ["play", "3-9", "--places", "0", "-o", "x.html"],
            ["cycle", "3-9", "-o", "x.csv"],
            ["draw", "3-9", "-o", "x.svg"],
            ["report", "3-9", "-o", "x.pdf"],
        ],
        2,
    ),
    ids=lambda words: words[0],
)
def test_every_command_that_draws_leaves_with_the_code_of_the_alarm(
    spoilt: Callable[[Spoil], None], command: list[str], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    assert CliRunner().invoke(app, command).exit_code == 0
    spoilt(lambda v: -v)
    run = CliRunner().invoke(app, [*command, "--lang", "zh"])
    assert run.exit_code == SUSPECT
    assert "不得作为答案" in run.stderr


@pytest.mark.parametrize(("lang", "said"), few([("zh", "不得作为答案"), ("en", "not to be taken as an answer")], 2))
def test_report_and_sheet_carry_a_red_box(
    spoilt: Callable[[Spoil], None], tmp_path: Path, lang: Lang, said: str
) -> None:
    spoilt(lambda v: 1.2 * v)
    solve(load("3-9")).report(tmp_path / "x.pdf", lang=lang)
    with pdfplumber.open(tmp_path / "x.pdf") as pdf:
        told = [(page, page.extract_text().replace("\n", " ")) for page in pdf.pages]
        assert said in told[0][1]
        ((sheet, words),) = [(page, text) for page, text in told if STRIP["bar"].of(lang) in text]
        assert said in words
        red = [shape for shape in (*sheet.rects, *sheet.curves) if shape["stroking_color"] == pytest.approx(RED)]
        assert len(red) == 2  # the sheet's frame and the box
        box, frame = sorted(shape["width"] for shape in red)
        assert box > 0.95 * frame


def test_the_player_opens_with_the_alarm(spoilt: Callable[[Spoil], None], tmp_path: Path) -> None:
    from vecpoly.player.page import player

    assert player(solve(load("3-9"), repeats=0, precise=False), places=0).warning is None
    spoilt(lambda v: 1.2 * v)
    page = player(solve(load("3-9"), repeats=0, precise=False), places=0)
    assert page.warning is not None
    assert 'id="alarm"' in page.html


def weighed(**changed: Any) -> Weighed:
    right = Weighed(drawn=1.0, exact=1.0, ideal=1.0, true=1.0, reach=0.01, noise=0.0, size=1.0, own=1.0)
    return replace(right, **changed)


def test_a_value_is_judged_on_both_sides_of_its_expected_error() -> None:
    assert weighed(drawn=1.0099).cause is None
    assert weighed(drawn=1.0101).cause is Cause.BEYOND
    assert weighed(drawn=0.9899).cause is Cause.BEYOND
    assert weighed(drawn=1.05, reach=nan).cause is None  # no repeated hand, no promise; the ideal hand still is judged
    assert weighed(drawn=nan).cause is Cause.NOT_FINITE


def test_a_reading_is_no_answer_where_its_expected_error_is_as_large_as_the_quantity() -> None:
    assert weighed(drawn=1.09, reach=50.0).cause is weighed(drawn=1.3, reach=0.4).cause is None
    assert weighed(drawn=1.11, reach=50.0).cause is weighed(reach=50.0, expected=1.01).cause is Cause.VAGUE
    assert weighed(reach=50.0, expected=0.99).cause is weighed(size=1e6, drawn=1.09, reach=0.9).cause is None
    assert weighed(size=1e6, drawn=1.11, reach=0.9).cause is Cause.VAGUE
    assert weighed(reach=50.0, expected=1.01, steady=False).cause is None  # the pencil shows what comes of it
    slot = """
id: nearly-equal
title: a slotted lever nearly on the crank's own circle
frame: {A: [0 mm, 0 mm], D: [0 mm, -50 mm]}
links: {1: {AB: 50 mm}, 2: {block: B}, 3: {slot: D}}
joints: [2 slides in 3]
input: {link: 1, phi: 269.9 deg, omega: 8 rad/s ccw}
find: [omega_3, alpha_3, v_B3B2, ak_B3B2]
"""
    assert solve(loads(slot)).answers["alpha_3"].suspect is Cause.VAGUE
    assert not solve(loads(slot.replace("269.9", "200"))).suspect


LOOSE = """
id: loose
title: a loose linkage
synthesis: crank-rocker
data: {K: 1.9, CD: 60 mm, ADC: 50 deg, AD: 61 mm}
"""


@pytest.mark.parametrize("asked", ["", "find: [gamma_min]", "find: [theta, gamma_min]", "find: [AB, gamma_min, BC]"])
def test_whether_a_value_is_suspect_does_not_depend_on_what_else_is_asked(asked: str) -> None:
    """γ_min is read as 4.2° ± 9.8°, and is 1.9°."""
    solution = solve(loads(LOOSE + asked))
    assert solution.suspect and solution.answers["gamma_min"].suspect is Cause.VAGUE


@pytest.mark.parametrize(
    ("text", "vague"),
    [
        ("synthesis: slider-crank\ndata: {K: 1.0005, H: 60 mm, e: 5 mm}", {"BC", "alpha_max"}),
        (
            "device: epicyclic\ndata: {sun: 99, planet: [101, 100], sun_2: 100, m: 2 mm, omega_H: 1 rad/s ccw, "
            "omega_3: 0 rad/s}",
            {"i_H1"},
        ),
    ],
)
def test_what_is_read_with_an_error_beyond_itself_is_no_answer_however_near_it_lies(text: str, vague: set[str]) -> None:
    """i_H1 is read as −50 ± 230, and is −49.5."""
    found = solve(loads(f"id: vague\ntitle: vague\n{text}")).answers
    assert {key for key, one in found.items() if one.suspect is Cause.VAGUE} == vague


def test_what_vanishes_is_no_less_an_answer_for_being_asked_alone() -> None:
    for name, key in (("5-1", "F_r"), ("3-7b", "ar_B3B2"), ("engine-four", "F_I")):
        problem = load(name)
        alone = replace(problem, asks=tuple(ask for ask in problem.asks if ask.rel.key == key))
        assert not solve(alone).suspect, key


def test_only_the_noise_of_the_exact_value_excuses_an_ideal_hand() -> None:
    assert weighed(ideal=1.0 + 1e-8).cause is None
    assert weighed(ideal=1.0 + 1e-6).cause is Cause.APART
    assert weighed(ideal=1.0 + 1e-6, noise=2e-6).cause is None


def test_a_hand_that_scatters_is_allowed_five_sigma_or_the_tail_of_its_repetitions() -> None:
    assert alarm_at(3.0, [0.0], scatters=False) == 3.0
    assert alarm_at(3.0, [0.0], scatters=True) == 5.0
    assert alarm_at(3.0, [0.0, *[-1.0, 0.0, 9.0] * 100], scatters=True) == 9.0


def test_sigma_from_few_hands_may_be_too_small_and_is_allowed_more() -> None:
    """As often as σ from 200 hands comes out so much too small, it does so from 20, by the quantile of χ²."""
    by = {many: np.random.default_rng(7).normal(size=(20_000, many)).std(axis=1) for many in (20, 200)}
    least = {many: float(np.quantile(found, 0.001)) for many, found in by.items()}
    allowed = alarm_at(3.0, [0.0] * 21, scatters=False) / 3.0
    assert allowed == pytest.approx(least[200] / least[20], rel=0.06)
    assert alarm_at(3.0, [0.0] * 11, scatters=False) == inf


@pytest.mark.parametrize("seed", few(range(3), 3))
def test_five_hands_that_round_alike_raise_no_false_alarm(seed: int) -> None:
    for name in ("3-5", "ex10", "5-4", "4-7"):
        assert not solve(load(name), repeats=5, seed=seed, precise=False).suspect


@pytest.mark.parametrize("phi", ["0.001 deg", "-0.001 deg"])
def test_beside_a_change_point_what_has_no_digits_left_is_refused(phi: str) -> None:
    with pytest.raises(DeadPointError, match="digits are left") as refusal:
        solve(loads(NEARLY.replace("PHI", phi)))
    assert "位有效数字" in refusal.value.words.zh


@pytest.mark.parametrize(
    ("off", "zh", "en"),
    [
        (0.005, "只剩 2 位", "2 digits are left"),
        (0.05, "只剩 1 位", "1 digit is left"),
        (0.5, "一位有效数字也不剩", "no digit"),
    ],
)
def test_what_is_left_of_a_value_is_counted_in_words(off: float, zh: str, en: str) -> None:
    problem = loads(NEARLY.replace("PHI", "40 deg"))
    truth = SimpleNamespace(values={"omega_3": 1.0}, nearby=({"omega_3": 1.0 + off}, {"omega_3": 1.0 - off / 2}))
    with pytest.raises(DeadPointError, match=en) as refusal:
        noise(problem, cast(Truth, truth), {"omega_3": 1.0})
    assert zh in refusal.value.words.zh


def test_where_digits_are_lost_it_is_said_how_many_are_left() -> None:
    near, far = (solve(loads(NEARLY.replace("PHI", phi))) for phi in ("0.1 deg", "40 deg"))
    assert 3 <= near.answers["alpha_3"].digits < 7
    assert near.as_json()["answers"]["alpha_3"]["exact_digits"] == near.answers["alpha_3"].digits
    said = fewer_digits(near)
    assert said is not None and all("α_{3}" in text.replace("α_3", "α_{3}") for text in (said.zh, said.en))
    assert fewer_digits(far) is None
    assert "exact_digits" not in far.as_json()["answers"]["alpha_3"]


def test_a_value_that_is_not_finite_still_gives_a_report_that_says_so(
    spoilt: Callable[[Spoil], None], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    spoilt(lambda v: complex(nan, nan))
    monkeypatch.chdir(tmp_path)
    for command in (
        ["solve", "3-9"],
        ["solve", "3-9", "--json", "-"],
        ["report", "3-9"],
        ["play", "3-9", "--places", "0"],
    ):
        run = CliRunner().invoke(app, [*command, "--lang", "en"])
        assert run.exit_code == SUSPECT, (command, run.output, run.exception)
        assert "not finite" in run.stderr


def test_what_is_found_on_the_way_is_weighed_too_though_nobody_asked(monkeypatch: pytest.MonkeyPatch) -> None:
    import vecpoly.methods.kinematics.turning as turning

    problem = load("3-9")
    only = replace(problem, asks=tuple(ask for ask in problem.asks if ask.rel.key == "v_E"))
    assert not solve(only).suspect
    honest = turning._rate
    monkeypatch.setattr(turning, "_rate", lambda *given: 1.2 * honest(*given))
    solution = solve(only)
    assert [key for key, answer in solution.answers.items() if answer.suspect] == []
    assert solution.suspect
    assert solution.construction.warning is not None and "ω_{2}" in solution.construction.warning.en


def test_an_answer_of_yes_or_no_carries_the_flag_too() -> None:
    answers = [
        answer
        for solution in (drawn(name).solution for name in ids(mechanisms=False))
        for answer in solution.answers.values()
        if answer.reading.unit == YES_NO
    ]
    assert len(answers) > 10
    assert all(answer.as_json()["suspect"] is False for answer in answers)


def test_what_cannot_be_read_on_paper_is_refused_by_name() -> None:
    text = """
id: far
title: a point 18 km away
frame: {A: [0 mm, 0 mm], D: [164 mm, 148 mm]}
links: {1: {AB: 46 mm}, 2: {block: B}, 3: {slot: D, C: {along: D, at: 221 mm, left: 18 km}}}
joints: [2 slides in 3]
input: {link: 1, phi: 1 deg, omega: 4 rad/s}
find: [v_C, an_B]
"""
    assert not solve(loads(text), by="exact", repeats=0, precise=False).suspect
    with pytest.raises(NotAskedError, match="its lines on paper have no length") as caught:
        solve(loads(text))
    assert caught.value.code == "unreadable" and "没有长度" in caught.value.words.zh
