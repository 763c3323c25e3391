"""Claims about mechanisms and sentences that the library has not: racks on turning links, guides told by a statement,
trial lines."""

from __future__ import annotations

import re
from math import degrees, radians

import pytest
from hypothesis import example, given, settings
from hypothesis import strategies as st
from typer.testing import CliRunner

from tests.drawn_library import drawn, ids
from tests.each import Later, each
from tests.laws import often
from vecpoly import oracle
from vecpoly.cli.app import app
from vecpoly.cycle.facts.path import path
from vecpoly.cycle.whole_cycle import cycle
from vecpoly.errors import AssemblyError
from vecpoly.mechanism.groups.other_inputs import other_inputs
from vecpoly.mechanism.model import FRAME, Prismatic, Revolute
from vecpoly.problem.load import load, loads
from vecpoly.solution import Solution, solve

RACK = """
id: rack-on-its-arm
title: A planet pushes a rack that slides along the arm
frame: {{A: [0 mm, 0 mm]}}
links:
  1: {{AB: {arm} mm}}
  2: {{gear: B, radius: {gear} mm}}
  3: {{block: E, rack: E, s: {start} mm}}
joints: [2 rolls on circle about A of {sun} mm at H, 3 slides on AB with E {gear} mm {side}, 2 rolls on 3 at K]
input: {{link: 1, phi: {phi} deg, omega: {omega} rad/s ccw, alpha: 5 rad/s^2 ccw}}
find: [v_E, a_E, omega_2, omega_3, alpha_3, v_K3K1, ak_K3K1, ar_K3K1]
"""


def agrees(solution: Solution) -> None:
    """Drawn by the exact hand, every answer is the oracle's."""
    for key, answer in solution.answers.items():
        assert answer.drawn == pytest.approx(answer.exact, rel=1e-8, abs=1e-8), key
        if answer.exact_vector is not None:
            assert answer.drawn_vector == pytest.approx(answer.exact_vector, rel=1e-8, abs=1e-8), key


@settings(max_examples=often(6))
@example(gear=18, sun=39, start=72, phi=24, omega=3, side="left")  # B stands at the very end of the slot
@example(gear=15, sun=57, start=72, phi=0, omega=2, side="left")
@given(
    gear=st.integers(15, 30),
    sun=st.integers(30, 60),
    start=st.integers(60, 90),
    phi=st.integers(0, 359),
    omega=st.integers(2, 20),
    side=st.sampled_from(["left", "right"]),
)
def test_a_rack_on_a_turning_guide_has_the_sliding_and_coriolis_terms_of_the_oracle(
    gear: int, sun: int, start: int, phi: int, omega: int, side: str
) -> None:
    agrees(
        solve(
            loads(RACK.format(arm=gear + sun, gear=gear, sun=sun, start=start, phi=phi, omega=omega, side=side)),
            by="exact",
            repeats=0,
        )
    )


TURNED = """
id: block-turned-on-its-guide
title: A block whose axis stands at an angle to its guide
frame: {A: [0 mm, 0 mm], C: [100 mm, 0 mm]}
links: {1: {AB: 30 mm}, 2: {slot: C}, 3: {block: B, G: {BG: 40 mm, angle: 60 deg from line}}}
joints: [3 slides in 2 turned 30 deg]
input: {link: 1, phi: 50 deg, omega: 10 rad/s ccw}
find: [p_G, v_G, a_G, omega_2]
"""


@pytest.mark.parametrize("turn", [0, 30, -75])
def test_points_of_a_block_that_is_turned_on_its_guide_are_the_oracle_s(turn: int) -> None:
    agrees(solve(loads(TURNED.replace("30 deg]", f"{turn} deg]")), by="exact", repeats=0))


@pytest.mark.parametrize("side", ["left", "right"])
def test_a_guide_that_a_statement_decides_says_by_which(side: str) -> None:
    text = re.sub(r"(?ms)^printed:.*", "", load("3-9").text)
    zh, en = {"left": ("左侧", "left"), "right": ("右侧", "right")}[side]
    told = solve(loads(f"{text}\nbranch: [E {side} of BC]\n"), repeats=0).construction.steps[1].words
    assert (
        f"of the two, $E$ to the {en} of the directed line $BC$" in told.en
        and f"（取 $E$ 在有向线 $BC$ {zh}的一个方向）" in told.zh
    )
    alone = solve(loads(text), repeats=0).construction.steps[1].words
    assert "of the two" not in alone.en and "（" not in alone.zh


@each(Later(lambda: [name for name in ids(mechanisms=False) if name.startswith("2-")]))
def test_of_the_groups_that_are_detached_the_first_is_told_to_be_farthest_from_the_input(name: str) -> None:
    parts: dict[str, list[tuple[bool, bool]]] = {}
    for step in drawn(name).construction.steps:
        if re.search("[Dd]etach links", step.words.en):
            far = "Start farthest from the input" in step.words.en, "从远离原动件处开始" in step.words.zh
            parts.setdefault(step.section.en, []).append(far)
    for told in parts.values():
        assert told[0] == (True, True) and not any(map(any, told[1:]))


@pytest.mark.parametrize("name", ["class-iii"])
def test_of_several_places_that_cannot_be_assembled_the_first_that_was_asked_for_is_named(name: str) -> None:
    mech = load(name).mechanism
    _, high = oracle.spans(mech)[-1]
    asked = [mech.drive.position, high + radians(9.0), high + radians(12.0)]
    with pytest.raises(AssemblyError, match=re.escape(f"stands at {degrees(asked[1]):.6g}°")):
        oracle.solve(mech, asked)


@pytest.mark.parametrize(("name", "unit"), [("3-9", "°"), ("elliptic-trammel", " mm")])
def test_the_places_of_extremes_carry_the_unit_of_the_drive(name: str, unit: str) -> None:
    shown = CliRunner().invoke(app, ["cycle", name, "-n", "25"]).stdout
    rows = shown[shown.index("────") :].partition("\n \n")[0].splitlines()[1:]
    ends = [line.rstrip() for line in rows if re.search(r"\d(°| mm)\s*$", line)]
    assert len(ends) > 5 and all(line.endswith(unit) for line in ends)


@pytest.mark.parametrize("name", ["3-5", "3-8", "3-12", "A-27"])
def test_what_else_could_drive_is_every_link_on_the_frame_but_the_driver(name: str) -> None:
    mech = load(name).mechanism
    pairs = [
        (j.a, j.b) if isinstance(j, Revolute) else (j.guide, j.block)
        for j in mech.joints
        if isinstance(j, Revolute | Prismatic)
    ]
    beside = {
        link for pair in pairs if FRAME in pair for link in pair if link in mech.numbered and link != mech.drive.link
    }
    assert beside and set(other_inputs(mech, lambda _: True)) == beside


@pytest.mark.parametrize(("sense", "turns"), [("ccw", 1), ("cw", -1)])
def test_the_tangent_of_a_path_turns_as_the_drive_does(sense: str, turns: int) -> None:
    turn = cycle(loads(re.sub(r"omega: [^,}]*", f"omega: 10 rad/s {sense}", load("3-9").text)), n=73)
    assert path(turn, "B").turning == path(turn, "E").turning == turns
