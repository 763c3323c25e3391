"""The exercises of chapter 3, drawn by the exact hand, give the known answers; laws of the construction hold."""

from __future__ import annotations

import json
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path

import pytest

from tests.drawn_library import hanging
from tests.texts import CRANK
from vecpoly.algebra.formula import Sym
from vecpoly.board.construction import View
from vecpoly.board.hand import hand
from vecpoly.drawing.sheets.paper import DrawingPaper
from vecpoly.methods import scaling
from vecpoly.methods.plan import construct
from vecpoly.problem.load import load, loads
from vecpoly.problem.problem import Scales

KNOWN: dict[str, dict[str, float | list[float]]] = json.loads(
    (Path(__file__).resolve().parents[1] / "data" / "ch3.json").read_text(encoding="utf-8")
)


def cases() -> Iterator[tuple[str, str]]:
    for name, answers in KNOWN.items():
        for key in answers:
            yield name, key


@pytest.fixture(scope="module")
def drawn() -> dict[str, object]:
    return {name: construct(load(name), hand("exact"))[0] for name in KNOWN}


@pytest.mark.parametrize(("name", "key"), list(cases()))
def test_the_exact_hand_draws_the_known_answer(drawn, name: str, key: str) -> None:  # type: ignore[no-untyped-def]
    reading, known = drawn[name].readings[key], KNOWN[name][key]
    if isinstance(known, list):
        truth = complex(*known)
        assert abs(reading.vector - truth) <= 1e-9 * max(abs(truth), 1e-6)
    else:
        assert reading.scalar == pytest.approx(known, rel=1e-9, abs=1e-12)


@pytest.mark.parametrize("name", ["3-5", "3-9", "3-10", "3-12"])
def test_another_scale_changes_millimetres_and_not_answers(name: str) -> None:
    problem = load(name)
    coarse = replace(problem, scales=Scales({"mu_l": 0.004, "mu_v": 0.02, "mu_a": 0.1}))
    fine = replace(problem, scales=Scales({"mu_l": 0.001, "mu_v": 0.007, "mu_a": 0.03}))
    one, two = (construct(p, hand("exact"))[0].readings for p in (coarse, fine))
    for key, reading in one.items():
        assert reading.scalar == pytest.approx(two[key].scalar, rel=1e-9, abs=1e-12)
        if reading.mm and (other := two[key].mm) and key.startswith("v"):
            assert reading.mm * 0.02 == pytest.approx(other * 0.007)


@pytest.mark.parametrize(("told", "called"), [("", {"a_B"}), (", alpha: 5 rad/s^2 ccw", {"a^n_B", "a^t_B"})])
def test_the_acceleration_of_an_even_crank_is_that_of_its_pin_else_the_normal_part(told: str, called: set[str]) -> None:
    turning = CRANK.replace("10 rad/s ccw", f"10 rad/s ccw{told}").replace("[v_C]", "[a_C]")
    steps = construct(loads(turning), hand("exact"))[0].steps
    first = next(step for step in steps if step.view is View.ACCELERATION)
    found = [sym for sym in hanging(first.formulas, Sym) if sym.base == "a"]
    assert {f"a^{sym.sup}_{sym.sub}" if sym.sup else f"a_{sym.sub}" for sym in found} == called


def test_the_swinging_block_asks_for_an_expanded_link_where_the_guide_is_offset() -> None:
    steps = construct(load("3-10"), hand("exact"))[0].steps
    assert any("扩大构件" in step.words.zh and "extend" in step.words.en.lower() for step in steps)


@pytest.mark.parametrize(("name", "why"), [("3-7b", "ω_3"), ("3-7c", "相对速度"), ("3-7d", "不存在")])
def test_a_vanishing_coriolis_term_is_explained(name: str, why: str) -> None:
    reading = construct(load(name), hand("exact"))[0].readings["ak_B3B2"]
    assert reading.scalar == 0
    assert reading.remark is not None and why in reading.remark.zh


def test_every_equation_has_exactly_two_question_marks_per_solved_side() -> None:
    for name in KNOWN:
        for step in construct(load(name), hand("exact"))[0].steps:
            if step.equation is None:
                continue
            cells = zip(step.equation.directions, step.equation.magnitudes, strict=True)
            unknown = sum((d.zh == "?") + (m == "?") for d, m in cells)
            assert unknown in (2, 4), (name, step.number)  # 4 where the sum itself is written in front


@pytest.mark.parametrize("name", list(KNOWN))
def test_readings_are_rounded_once_to_the_hand_s_graduation(name: str) -> None:
    readings = construct(load(name), hand("drafting"))[0].readings
    for reading in readings.values():
        if reading.mm is not None:
            assert reading.mm * 10 == pytest.approx(round(reading.mm * 10), abs=1e-6)


def test_a_problem_drawn_by_another_hand_is_sketched_once_and_keeps_its_scales(monkeypatch: pytest.MonkeyPatch) -> None:
    problem, paper = replace(load("3-12"), id="sketched once"), DrawingPaper()
    first = construct(problem, hand("exact"), paper)
    monkeypatch.setattr(scaling, "draw", lambda *_: pytest.fail("it was sketched anew"))
    again = construct(replace(problem), hand("pencil", seed=3), paper)
    assert [one.scale for one in again.construction.figures] == [one.scale for one in first.construction.figures]
    assert again.ideal == first.ideal and again.motion == first.motion


def test_another_scale_given_or_another_paper_is_no_longer_the_same_drawing() -> None:
    problem = load("3-10")
    given = replace(problem, scales=Scales({"mu_v": 0.02}))
    a4, letter = DrawingPaper(), DrawingPaper(problem.on("letter").paper)
    mu = [
        [one.scale.value for one in construct(*drawn).construction.figures]
        for drawn in ((problem, hand("exact"), a4), (given, hand("exact"), a4), (problem, hand("exact"), letter))
    ]
    assert mu[0][1] != mu[1][1] == 0.02
    assert mu[0] != mu[2]
