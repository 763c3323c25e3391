"""n of an input, and pivots with an index, O1 and O2, as books write them."""

from __future__ import annotations

import re

import pytest

from vecpoly.algebra.formula import Sym, plain, row, sym
from vecpoly.errors import ProblemFileError
from vecpoly.problem.editors import json_schema
from vecpoly.problem.load import load, loads
from vecpoly.problem.problem import Problem
from vecpoly.problem.schema.faults import Path
from vecpoly.problem.text.chinese import joint
from vecpoly.problem.text.respelled import _Speller
from vecpoly.solution import solve
from vecpoly.typeset.layout import layout

SLOTTER = """\
id: slotter
title: {zh: 插床, en: Slotting machine at O1}
frame: {O1: [0 mm, 0 mm], O2: [-150 mm, 0 mm]}
links:
  1: {O1A: 75 mm}
  2: {block: A}
  3: {slot: O2, B: {O2B: 100 mm, angle: 180 deg from line}}
  4: {BC: 125 mm}
  5: {block: C}
joints: [2 slides in 3, 5 slides on x = -270 mm]
input: {link: 1, phi: 150 deg, n: 60 r/min cw}
branch: [C below B]
find: [v_C, a_C, omega_3, alpha_3]
"""
SCHEMA = json_schema()
PLAIN = SLOTTER.replace("O1", "P").replace("O2", "Q").replace("n: 60", "omega: 60")


def answers(problem: Problem) -> dict[str, object]:
    return {key: repr(answer.exact) for key, answer in solve(problem).answers.items()}


@pytest.mark.parametrize("written", ["O1", "O_1", "O₁"])
def test_a_pivot_with_an_index_is_one_letter_however_it_is_written(written: str) -> None:
    problem = loads(SLOTTER.replace("O1", written))
    assert list(problem.mechanism.frame) == ["O₁", "O₂"]
    assert answers(problem) == answers(loads(PLAIN))


def test_its_figure_is_an_index_wherever_it_is_printed() -> None:
    assert sym("O₁") == Sym("O", "1") and sym("o₁^′") == Sym("o", "1", "′")
    assert sym("O₁_2") == Sym("O", "1,2")  # that pivot, thought on link 2
    assert layout(row("l_O₁A"), 4.0).descent > layout(row("l_OA"), 4.0).descent  # hangs under the letter in an index
    steps = "".join(step.words.zh for step in solve(loads(SLOTTER)).construction.steps)
    assert "o₂b : o₂a_{3} = O₂B : O₂A" in steps
    assert plain(row("O₂A")) == "O_2A"


def test_sentences_keep_their_letters_and_other_letters_their_links() -> None:
    problem = loads(SLOTTER.replace("find: [v_C", "find: [v_A3, v_C"))
    assert problem.title.en == "Slotting machine at O1"
    assert "v_A3" in solve(problem).answers


def test_the_speed_of_an_input_may_be_its_n_and_so_may_a_range() -> None:
    varied = loads(SLOTTER + "vary: {n: 40 r/min cw .. 80 r/min cw by 20 r/min, O1A: 70 mm .. 80 mm by 5 mm}\n")
    assert [one.name for one in varied.ranges] == ["omega", "O₁A"]
    assert varied.mechanism.drive.rate == loads(PLAIN).mechanism.drive.rate


def test_what_extends_it_calls_the_pivots_alike() -> None:
    def held(name: str) -> str | None:
        return SLOTTER if name == "base" else None

    longer = loads("id: longer\nextends: base\nlinks: {1: {O1A: 80 mm}}\n", resolver=held)
    assert list(longer.mechanism.link("1").points) == ["O₁", "A"]
    assert answers(longer) == answers(loads(PLAIN.replace("PA: 75 mm", "PA: 80 mm")))


@pytest.mark.parametrize(
    ("changed", "line", "said"),
    [
        (
            SLOTTER.replace("n: 60 r/min cw", "n: 60 r/min cw, omega: 6 rad/s cw"),
            11,
            "n and omega are one and the same",
        ),
        (SLOTTER.replace("n: 60 r/min cw", "n: 60 r/min cw, ω: 6 rad/s cw"), 11, "ω and n are one and the same"),
        (SLOTTER.replace("{O1:", "{O_1: [9 mm, 0 mm], O1:"), 3, "O_1 and O1 are one and the same"),
        (SLOTTER.replace("2: {block: A}", "2: {block: A, O: {AO: 9 mm}}"), 3, "O1 is read as point O of link 1"),
        (SLOTTER.replace("O1A: 75 mm", "O1A: 75"), 5, "links.1.O₁A"),
    ],
)
def test_what_is_said_twice_or_doubtfully_is_refused_at_its_line(changed: str, line: int, said: str) -> None:
    with pytest.raises(ProblemFileError, match=rf"line {line}\b.*{said}"):
        loads(changed)


@pytest.mark.parametrize(
    ("said", "english"),
    [
        ("滑块 4 在构件 5 的槽中滑动", "4 slides in 5"),
        ("4在5中滑动", "4 slides in 5"),
        ("滑块 4 沿导杆 5 移动 turned 30 deg", "4 slides on 5 turned 30 deg"),
        ("5 沿 y=600 mm 移动", "5 slides on y = 600 mm"),
        ("滑块 3 沿过 K 点与 x 轴成 -12° 的直线移动", "3 slides on line through K at -12°"),
        ("构件 3 的 C 点沿 AD 滑动", "C of 3 slides on AD"),
        ("导杆 2 穿过滑块 3", "2 passes through 3"),
        ("销 B 在构件 3 的槽中滑动", "B runs in 3"),
        ("齿轮 4 与齿轮 3 在 H 处啮合", "4 rolls on 3 at H"),
        ("4 与 3 在 H 点内啮合", "4 rolls inside 3 at H"),
        ("齿轮 3 在 D 处沿 y = 0 mm 滚动", "3 rolls on y = 0 mm at D"),
        ("3 在 D 处沿 y = 0 mm 下方滚动", "3 rolls below y = 0 mm at D"),
        ("凸轮 1 与推杆 2 在 K 处接触 right of the face", "1 touches 2 at K right of the face"),
        ("1 与 2 在 K 处内切", "1 touches 2 inside at K"),
        ("4 slides in 5", "4 slides in 5"),
        ("4 和 5 一起动", "4 和 5 一起动"),
    ],
)
def test_a_joint_may_be_said_in_chinese_and_the_schema_takes_what_is_understood(said: str, english: str) -> None:
    assert joint(said) == english
    pattern = SCHEMA["properties"]["joints"]["items"]["pattern"]
    assert bool(re.fullmatch(pattern, said)) is (said == "4 slides in 5" or said != english)


def test_a_mechanism_said_in_chinese_is_that_said_in_english() -> None:
    chinese = SLOTTER.replace(
        "2 slides in 3, 5 slides on x = -270 mm", "滑块 2 在导杆 3 中滑动，滑块 5 沿 x = -270 mm 移动"
    )
    assert loads(chinese).mechanism == loads(SLOTTER).mechanism


def test_the_side_of_a_point_may_be_said_in_chinese() -> None:
    def points(side: str) -> object:
        triangle = f"{{BC: 125 mm, E: {{BE: 80 mm, CE: 70 mm, side: {side}}}}}"
        return loads(SLOTTER.replace("{BC: 125 mm}", triangle)).mechanism.link("4").points

    assert points("BC 左侧") == points("left of BC")


def test_the_motion_of_a_cam_may_be_said_in_chinese() -> None:
    base = "id: cam\ntitle: cam\ndevice: cam\ndata: {{follower: {{knife: yes}}, r0: 40 mm, turns: ccw, motion: [{}]}}\n"
    said = base.format("推程 30 mm 120° 余弦加速度, 远休止 30°, 回程 120° 等加速等减速运动, 近休 90°")
    told = base.format("rise 30 mm in 120 deg cosine, dwell 30 deg, return in 120 deg parabolic, dwell 90 deg")
    pieces = [loads(text).subject.pieces for text in (said, told)]  # type: ignore[union-attr]
    assert pieces[0] == pieces[1]


def test_masses_angles_and_answers_have_the_symbols_of_the_textbook() -> None:
    base = SLOTTER.replace("phi: 150 deg", "φ: 150 deg").replace("find: [", "find: [η, M_1, ")
    base += (
        "loads: {M_1: {on: 1, size: '?'}, F: {on: 5, at: C, size: 9 N, direction: 90 deg}}\nfriction: {A: {ρ: 2 mm}}\n"
    )
    symbols = loads(base + "masses: {4: {m: 2 kg, J_S: 0.1 kg*m^2, S: {along: BC, at: 50 mm}}}\n")
    words = loads(base + "masses: {4: {mass: 2 kg, inertia: 0.1 kg*m^2, centre: {along: BC, at: 50 mm}}}\n")
    assert answers(symbols) == answers(words)
    assert {"m", "J_S", "S"} <= SCHEMA["$defs"]["MassSpec"]["properties"].keys()
    assert {"n", "φ"} <= SCHEMA["$defs"]["InputSpec"]["properties"].keys()
    assert [str(ask.rel) for ask in symbols.asks][:2] == ["eta", "M_1"]


def test_the_n_of_a_device_stays_its_own() -> None:
    text = load("7-6").text.replace("id: 7-6", "id: x")
    assert [one.name for one in loads(text + "\nvary: {n: 900 r/min .. 1100 r/min by 100 r/min}\n").ranges] == ["n"]


def test_greek_is_spelt_out_where_a_quantity_is_named_and_nowhere_else() -> None:
    speller = _Speller(["O₁"], {})
    named: list[Path] = [("find", 0), ("printed", 0, "symbol")]
    others: list[Path] = [("printed", 0, "value"), ("links", "1", "angle"), ("loads", "M_1", "direction")]
    for path in named:
        assert speller.value("φ_1", path) == "phi_1" and speller.value("η", path) == "eta", path
    for path in others:
        assert speller.value("η from O1A", path) == "η from O₁A", path
