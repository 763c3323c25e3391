"""The chapters on the machine: its flywheel tried out, its powers, what its masses do to the frame."""

from __future__ import annotations

import re
from contextlib import closing
from dataclasses import replace
from functools import cache
from itertools import pairwise
from pathlib import Path
from types import SimpleNamespace

import numpy as np
import pytest
import yaml
from hypothesis import given
from hypothesis import strategies as st
from pypdfium2 import PdfDocument

from tests.laws import few
from tests.presses import Kept
from tests.studies import course_report, course_text, course_words, machine, studied
from vecpoly.algebra.quantity import number
from vecpoly.cycle import cycle, extremes
from vecpoly.findings.machine.running import Running, running
from vecpoly.findings.machine.shaking import Shaking
from vecpoly.mechanism.groups.assur import pivot_of
from vecpoly.oracle import solve
from vecpoly.problem.load import load
from vecpoly.report.content import Objects
from vecpoly.report.course.machine.chapters import conclusion as concluded
from vecpoly.report.course.machine.motion import conclusion
from vecpoly.report.course.machine.powers import powers
from vecpoly.report.course.machine.work import pieces
from vecpoly.words import Lang

MACHINES = ("press-flywheel", "engine-flywheel", "shaper-flywheel")
PRESS = MACHINES[0]
CHAPTERS: dict[Lang, tuple[str, ...]] = {
    "zh": ("9机械的运转与飞轮", "10平衡", "11结论"),
    "en": ("9Motionofthemachine,flywheel", "10Balancing", "11Conclusion"),
}


@cache
def running_of(name: str) -> Running:
    found = machine(name).motion
    assert isinstance(found, Running)
    return found


@cache
def shaking_of(name: str) -> Shaking:
    found = machine(name).balance
    assert isinstance(found, Shaking)
    return found


@cache
def told(name: str, lang: Lang) -> tuple[str, int]:
    """All text without blanks, and how many pages it fills."""
    with closing(PdfDocument(course_report(name, lang))) as document:
        pages = [re.sub(r"\s", "", page.get_textpage().get_text_range()) for page in document]
    return "".join(pages), len(pages)


@pytest.mark.parametrize("name", few(MACHINES, 3))
def test_the_true_motion_has_the_unevenness_for_which_the_flywheel_was_found(name: str) -> None:
    run = running_of(name)
    assert run.trial is not None and run.steady is not None and run.steady.delta is not None
    assert run.trial.delta == pytest.approx(run.steady.delta, abs=1e-8)
    assert abs(run.trial.missed) < 1e-8


@pytest.mark.parametrize("name", few(MACHINES, 3))
def test_powers_of_the_loads_add_up_to_the_energy_that_the_links_gain(name: str) -> None:
    run = running_of(name)
    assert run.trial is not None
    assert len(run.trial.flows) == round(np.degrees(run.of.period) / 30)
    for _, flow in run.trial.flows:
        gives, gains = sum(flow.powers.values()), sum(flow.gains.values())
        assert gives == pytest.approx(gains, abs=1e-9 * max(map(abs, flow.powers.values())))
        assert run.name in flow.powers


@pytest.mark.parametrize("name", few(MACHINES, 3))
def test_the_chapter_of_powers_speaks_of_a_flywheel_where_one_is_needed_and_nowhere_else(name: str) -> None:
    run, press = running_of(name), Kept("en", Objects())
    found = run.found
    assert found is not None and found.flywheel > 0
    for one, wheel in ((run, True), (replace(run, found=replace(found, flywheel=0.0)), False)):
        [told] = powers(studied(name), press, one)["words"]
        assert ("with its flywheel" in told) is wheel


@pytest.mark.parametrize("name", few(MACHINES, 3))
def test_the_conclusion_tells_the_flywheel_by_areas_and_exactly_where_nobody_asked_for_it(name: str) -> None:
    run, unasked = running_of(name), SimpleNamespace(given=SimpleNamespace(problem=SimpleNamespace(asks=())))
    assert run.found is not None and run.by_areas is not None
    [told] = conclusion(unasked, run)  # type: ignore[arg-type]
    for value in (run.surplus, run.by_areas, run.found.flywheel):
        assert number(value, 4) in told.zh and number(value, 4) in told.en
    [told] = conclusion(unasked, replace(run, found=None))  # type: ignore[arg-type]
    assert number(run.surplus, 4) in told.en and "flywheel" not in told.en


@pytest.mark.parametrize("name", few(MACHINES, 3))
def test_surplus_and_deficit_alternate_and_leave_nothing_over_a_period(name: str) -> None:
    run = running_of(name)
    parts = pieces(run)
    gains = [gain for _, _, gain, _ in parts]
    assert len(gains) > 1 and all(a * b < 0 for a, b in pairwise(gains))
    assert sum(gains) == pytest.approx(0.0, abs=1e-9 * run.surplus)
    heights = [0.0, *(end for *_, end in parts)]
    assert max(heights) - min(heights) == pytest.approx(run.surplus, rel=1e-9)


def test_a_stretch_from_a_gain_to_as_great_a_loss_is_one_too() -> None:
    """E = sin ψ J: its second stretch falls from 1 J to −1 J."""
    psi = np.linspace(0.0, 2 * np.pi, 100)
    course = SimpleNamespace(
        moments=np.cos,
        works=np.sin,
        sampled=lambda _: (psi, psi),
        of_pieces=lambda of, at: of(at),
        at=lambda of, q: of(q),
    )
    found = pieces(SimpleNamespace(of=course, surplus=2.0))  # type: ignore[arg-type]
    assert [gain for _, _, gain, _ in found] == pytest.approx([1.0, -2.0, 1.0])


def test_the_conclusion_tells_the_greatest_shaking_force_of_the_machine() -> None:
    (said,) = concluded(studied(PRESS), machine(PRESS))
    top = shaking_of(PRESS).force.highest
    assert top is not None and f"maximum shaking force is {number(top.value, 4)} N" in said.en


@pytest.mark.parametrize("name", few(MACHINES, 3))
def test_the_shaking_force_and_moment_are_the_rates_of_the_momenta(name: str) -> None:
    """F_I = −d/dt Σ m v_S and M_I = −d/dt Σ (r_S × m v_S + J ω), by central differences."""
    problem = load(name)
    mech, loads = problem.mechanism, problem.acting
    assert loads is not None
    turn, phi, step = cycle(problem), np.linspace(0.1, 6.1, 13), 1e-4

    def momenta(at: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        bodies = solve(mech, at).bodies
        linear, angular = np.zeros(at.shape, complex), np.zeros(at.shape)
        for mass in loads.masses:
            body, local = bodies[mass.link], mech.link(mass.link).points[mass.centre]
            speed, place = body.velocity_of(local), body.point(local) - mech.frame["A"]
            linear = linear + mass.mass * speed
            angular = angular + mass.mass * (place.conjugate() * speed).imag + mass.inertia * body.omega
        return linear, angular

    pace = mech.drive.rate / (2 * step)
    linear, angular = (-pace * (b - a) for a, b in zip(momenta(phi - step), momenta(phi + step), strict=True))
    force, moment = turn.at("shaking_F", phi), turn.at("shaking_M", phi)
    assert np.allclose(force, linear, atol=1e-5 * np.abs(linear).max())
    assert np.allclose(moment, angular, atol=1e-5 * np.abs(angular).max())


@given(share=st.floats(-1.0, 1.0), turned=st.floats(-3.0, 3.0))
def test_no_other_counterweight_on_the_crank_leaves_a_smaller_mean_square(share: float, turned: float) -> None:
    study, best = studied(PRESS), shaking_of(PRESS).best
    assert best is not None
    force, phi = np.asarray(study.turn.column("shaking_F"))[:-1], study.turn.phi[:-1]

    def left(product: float, angle: float) -> float:
        pull = product * study.mech.drive.rate**2 * np.exp(1j * (phi + angle))
        return float(np.sqrt(np.mean(np.abs(force + pull) ** 2)))

    assert left(best.product, best.angle) == pytest.approx(best.mean_after, rel=1e-9)
    assert left(best.product * (1 + share), best.angle + turned) >= best.mean_after * (1 - 1e-12)


@pytest.mark.parametrize("name", few(["press-flywheel", "shaper-flywheel"], 2))
def test_with_centres_of_mass_on_their_pivots_the_force_is_what_counterweights_leave(name: str) -> None:
    problem, found = load(name), shaking_of(name)
    loads = problem.acting
    assert loads is not None and problem.machine is not None and found.weights
    moved = {one.link for one in found.weights}
    masses = tuple(
        replace(mass, centre=pivot_of(problem.mechanism, mass.link)) if mass.link in moved else mass
        for mass in loads.masses
    )
    moving = replace(problem.machine, loads=replace(loads, masses=masses))
    highest = extremes(cycle(replace(problem, machine=moving)), "shaking_F").highest
    assert highest is not None and highest.value == pytest.approx(found.left, rel=1e-9)


@pytest.mark.parametrize(("name", "lang"), few([*((name, "zh") for name in MACHINES), (PRESS, "en")], 4))
def test_the_assignment_has_both_chapters_and_the_flywheel_in_twenty_to_thirty_pages(name: str, lang: Lang) -> None:
    text, pages = told(name, lang)
    run = running_of(name)
    assert all(title in text for title in CHAPTERS[lang])
    assert run.found is not None and f"{run.found.flywheel:.4g}" in text
    assert 20 <= pages <= 30


def test_a_mechanism_without_masses_and_loads_has_no_such_chapter_and_no_word_of_it() -> None:
    text, _ = course_text("3-9", "zh")
    assert re.search(r"9\s*结论", text)
    assert "机械的运转" not in text


def test_nor_has_one_with_loads_but_without_masses() -> None:
    text, _ = course_words("4-3a", "en")
    assert re.search(r"9\s+Conclusion", text)
    assert "no chapter" not in text and "Motion of the machine" not in text


def test_without_a_constant_moment_of_its_own_one_is_thought_that_does_the_same_work() -> None:
    problem = load(PRESS)
    own = running_of(PRESS)
    assert problem.machine is not None
    bare = replace(problem, machine=replace(problem.machine, loads=replace(problem.machine.loads, constant=None)))
    found = running(bare)
    assert isinstance(found, Running) and found.thought
    assert found.constant == pytest.approx(own.constant, rel=1e-12)
    assert not own.thought


def test_one_place_and_an_array_of_one_place_are_not_mistaken_for_each_other() -> None:
    turn = cycle(load(PRESS))
    assert np.shape(turn.at("v_C", np.array([1.0]))) == (1,)
    assert np.shape(turn.at("v_C", 1.0)) == ()


def test_the_assignment_of_chapter_7_holds_every_problem_of_its_folder() -> None:
    root = Path(__file__).resolve().parents[2] / "problems"
    listed = yaml.safe_load((root / "assignment-ch7.yaml").read_text(encoding="utf-8"))["problems"]
    assert sorted(listed) == sorted(path.stem for path in (root / "ch7").glob("*.yaml"))


def test_sums_over_all_links_are_displayed_and_stand_in_no_sentence() -> None:
    """M_e = was left at the end of a line, its sum at the beginning of the next."""
    text, _ = course_text("six-bar-dynamic", "zh")
    chapter = text[text.index("机械的运转") : text.index("个周期内的功")]
    assert chapter.count("<formula ref=") >= 2 and "Σ[" not in chapter


def test_the_difference_of_two_energies_has_one_count_of_decimals() -> None:
    text, _ = course_text("six-bar-dynamic", "zh")
    assert "2.3 − (−1011.4) = 1013.7 J" in text


def test_the_zeros_of_the_equivalent_inertia_are_all_told() -> None:
    text, _ = course_text("six-bar-dynamic", "zh")
    assert "（$φ_1$ = 196.8°、343.2°）" in text.replace("$φ_{1}$", "$φ_1$")
