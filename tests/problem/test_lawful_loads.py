"""Claims about loads that depend on place and speed, as they are written: in both languages, refused in words."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from tests.lawful import CARD, COIL, CUT, ENGINE, PLAIN, SPRING, UNKNOWN, slider
from vecpoly import load
from vecpoly.errors import ProblemFileError
from vecpoly.problem.problem import Problem
from vecpoly.record import from_json, to_json
from vecpoly.solution import solve

MOTOR = "M_d: {on: 1, motor: [200 N*m, 2 N*m*s]}"
WIDE = ENGINE.replace(CARD, "columns: [phi (deg), p (MPa)], rows: [[0, 1], [540, 2]]")


@pytest.mark.parametrize(
    ("english", "chinese"),
    [
        ("C moves left", "C 向左运动"),
        ("C moves left", "C点左移"),
        ("C moves along 30 deg", "C 沿 30 deg 运动"),
        ("2 turns ccw", "构件 2 逆时针转动"),
        ("2 turns cw", "2 顺时针"),
    ],
)
def test_a_sense_of_motion_may_be_written_in_either_language(english: str, chinese: str) -> None:
    text = "F: {on: 3, at: C, size: 30 N, direction: 0 deg, while: SAID}"
    assert slider(text.replace("SAID", english)).loads == slider(text.replace("SAID", chinese)).loads
    constant = slider(CUT, unknown="M_d: {on: 1, size: 常数}", find="M_b").loads
    assert constant == slider(CUT, unknown="M_d: {on: 1, size: constant}", find="M_b").loads


@pytest.mark.parametrize(
    ("entry", "says"),
    [
        (CUT.replace("C moves left", "A moves left"), "point A is fixed to the frame and does not move"),
        (CUT.replace("C moves left", "X moves left"), "no moving link has a point 'X'"),
        (CUT.replace("C moves left", "C goes left"), "'C goes left' is not understood; write e.g. E moves left"),
        (CUT.replace("[5 %, 95 %]", "[95 %, 5 %]"), "goes from 95 % to 5 %, which is reversed"),
        (CUT.replace("[5 %, 95 %]", "[5 %, 195 %]"), "'195 %' is no part of a stroke"),
        (CUT.replace("while: C moves left, ", ""), "'between' is part of a stroke; say of which point and which way"),
        (CUT.replace("C moves left", "2 turns ccw"), "a link that turns has none"),
        (CUT.replace("while: C moves left, between: [5 %, 95 %]", "during: [30 deg, 400 deg]"), "beyond the period"),
        (CUT.replace("while: C moves left, between: [5 %, 95 %]", "during: [30 deg, 30 deg]"), "no place between"),
        (CUT.replace("3000 N", '"?"'), "cannot act at some only"),
        (WIDE, "covers 540 deg, more than one turn .360 deg. and not two"),
        (ENGINE.replace(", bore: 50 mm", ""), "give the piston's area: 5000 mm.2 or its bore"),
        (ENGINE.replace("p (MPa)", "F (N)"), "the table gives forces or moments already"),
        (ENGINE.replace("[30, 2]", "[-3, 2]"), "is not greater than the one before"),
        (ENGINE.replace("s (mm)", "s"), "the head 's' names no unit"),
        (ENGINE.replace(CARD, "table: none.csv"), "none.csv lies outside the library"),
        (SPRING.replace("D-C3", "D-C"), "links 2, 3 meet at C; say on which the spring pulls, e.g. C2"),
        (SPRING.replace("D-C3", "A-D"), "are on one link .both on the frame."),
        (SPRING.replace("l_0: 80 mm, ", ""), "the free length of the spring is missing"),
        (SPRING.replace("k: 5 N/mm", "k: 5 N*m/rad"), "is not a stiffness"),
        (SPRING.replace("k: 5 N/mm", "k: -5 N/mm"), "must be greater than zero"),
        (SPRING.replace("}", ", on: 3}"), "leave out on"),
        (COIL.replace("phi_0: 10 deg", "l_0: 10 mm"), "has no l_0; write phi_0: 30 deg"),
        (COIL.replace("4-2", "2-2"), "goes from one link to another"),
        (COIL.replace("4-2", "7-2"), "link '7' does not exist"),
        (MOTOR.replace("on: 1", "on: 2"), "acts on the driving link, which must turn; here it is on link 2"),
        (MOTOR.replace("200 N", "-200 N"), "a must be positive, b not negative"),
        (UNKNOWN.replace("M_1", "M_2").replace('"?"', "constant"), "2 loads are unknown .M_1, M_2."),
        ("M_2: {on: 2, size: constant}", "acts on the driving link, which must turn; here it is on link 2.* on: 1"),
        ("M_2: {on: 2, size: 3 N*m, k: 3 N/mm}", "k belong to a spring or a damper"),
    ],
)
def test_what_contradicts_itself_is_refused_in_words_with_what_to_do(entry: str, says: str) -> None:
    with pytest.raises(ProblemFileError) as refused:
        slider(entry)
    [fault, *_] = refused.value.faults
    assert re.search(says, fault.words.en) and re.search("[\u4e00-\u9fff]", fault.words.zh)
    assert fault.path[0] == "loads" and all(str(key) in entry for key in fault.path[1:])


@pytest.mark.parametrize(
    ("entry", "code"),
    [
        (WIDE, "no-period"),
        (ENGINE.replace("[30, 2]", "[-3, 2]"), "contradiction"),
        (ENGINE.replace("[0, 3]", "[-5, 3]"), "out-of-range"),
    ],
)
def test_what_is_wrong_with_the_rows_of_a_table_is_told_at_its_rows_and_of_its_kind(entry: str, code: str) -> None:
    with pytest.raises(ProblemFileError) as refused:
        slider(entry)
    [fault, *_] = refused.value.faults
    assert (fault.path[-1], fault.code) == ("rows", code)


@pytest.mark.parametrize("entry", [SPRING, MOTOR])
def test_what_depends_on_the_speed_wants_it_as_a_number(entry: str) -> None:
    with pytest.raises(ProblemFileError, match="depends on the speed, and the input gives only its sense"):
        slider(entry, plain=PLAIN.replace("300 r/min ccw", "ccw"))


def test_a_card_is_read_beside_the_file_that_names_it_and_nowhere_else(tmp_path: Path) -> None:
    text = f"{PLAIN}loads:\n  {ENGINE.replace(CARD, 'table: card.csv')}\n  {UNKNOWN}\nfind: [M_1, F]\n"
    (tmp_path / "in").mkdir()
    file, outside = tmp_path / "in" / "a.yaml", tmp_path / "card.csv"
    outside.write_text("s (mm); p (MPa)\n0; 3\n30; 2\n120; 0.4\n60; 0.2\n0; 0.1\n")
    file.write_text(text.replace("card.csv", "../card.csv"))
    with pytest.raises(ProblemFileError, match="lies outside"):
        load(str(file))
    (tmp_path / "in" / "card.csv").write_bytes(outside.read_bytes())
    file.write_text(text)
    beside = load(str(file))
    assert tmp_path / "in" / "card.csv" in beside.files
    assert beside.solve(by="exact").answers["F"].exact == solve(slider(ENGINE, find="F"), by="exact").answers["F"].exact


def test_what_is_varied_is_what_is_drawn() -> None:
    problem = load("return-spring")
    stiffer = problem.vary(k_F_s="4 N/mm", l_0_F_s="100 mm")
    pull, before = (one.solve(by="exact").answers["F_s"].drawn for one in (stiffer, problem))
    assert pull - 30 == pytest.approx(2 * (before - 30) - 4000 * 0.01, rel=1e-9)
    later = load("shaper-cut").vary(phi="200 deg")
    assert later.solve(by="exact").answers["F_r"].drawn == 0.0


@pytest.mark.parametrize("name", ["return-spring", "shaper-cut", "engine-card"])
def test_a_record_keeps_windows_tables_springs_and_the_constant(name: str) -> None:
    problem = load(name)
    assert from_json(to_json(problem), Problem) == problem


def test_of_which_line_the_free_angle_of_a_torsion_spring_is_stands_beside_it() -> None:
    """Turned round, DC is 180° from CD: the file's letters decide, so that the reader must see them."""
    told = [datum.words for datum in load("return-spring").given.loads if datum.words is not None]
    assert any("$φ_0$ = 90 deg (angle of $DC$ from the $x$ axis)" in words.en for words in told)
    assert any("$φ_0$ = 90 deg（$DC$ 自 $x$ 轴起的转角）" in words.zh for words in told)
