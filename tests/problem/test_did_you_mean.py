"""Claims about what is offered instead of a misspelt symbol, unit, sense, letter or link."""

from __future__ import annotations

import pytest

from tests.drawn_library import IDS
from tests.each import each
from vecpoly import load, solve
from vecpoly.answer import Answer
from vecpoly.errors import AssemblyError, FaultError, ProblemFileError
from vecpoly.names import Kind, Rel
from vecpoly.problem.asked.hints import nothing_asked
from vecpoly.problem.load import loads
from vecpoly.problem.text.spelling import intended, plain
from vecpoly.units.reading import Dim, read

FOUR_BAR = """id: 四杆-1
title: {zh: 铰链四杆机构}
frame: {A: [0 mm, 0 mm], D: [120 mm, 0 mm]}
links:
  1: {AB: 40 mm}
  2: {BC: 100 mm}
  3: {CD: 80 mm}
input: {link: 1, phi: 60 deg, omega: 10 rad/s ccw}
branch: [C above AD]
find: [v_C]
"""


@pytest.mark.parametrize(
    ("written", "key"),
    [
        ("ω3", "omega_3"),
        ("w3", "omega_3"),
        ("omega3", "omega_3"),
        ("ω₃", "omega_3"),
        ("ε2", "alpha_2"),
        ("a_2", "alpha_2"),
        ("vE", "v_E"),
        ("v_{CB}", "v_CB"),
        ("v_C/B", "v_CB"),
        ("V_E", "v_E"),
        ("v_e", "v_E"),
        ("a^n_CB", "an_CB"),
        ("a_CB^n", "an_CB"),
        ("a^k_{B3B2}", "ak_B3B2"),
        ("|v_E|", "v_E"),
        ("theta_3", None),
        ("v_5", None),
        ("foo", None),
        ("R12", None),
    ],
)
def test_a_symbol_as_people_write_it_leads_to_its_key(written: str, key: str | None) -> None:
    assert intended(written) == key


def faults(old: str, new: str) -> str:
    with pytest.raises(ProblemFileError) as caught:
        loads(FOUR_BAR.replace(old, new), "x.yaml")
    assert all(fault.words.zh != fault.words.en for fault in caught.value.faults)
    return str(caught.value)


def test_every_misspelt_symbol_is_told_with_what_is_meant() -> None:
    text = faults("[v_C]", "[w3, v_c, v_E, omega_7]")
    assert text.count("\n") == 3 and "did you mean 'omega_3'" in text and "did you mean 'v_C'" in text
    assert "point 'E' does not exist" in text and "link '7' does not exist; known: 1, 2, 3" in text


@pytest.mark.parametrize(
    ("written", "key"),
    [
        ("ω3", "omega_3"),
        ("ω₃", "omega_3"),
        ("$ω_3$", "omega_3"),
        ("ε2", "alpha_2"),
        ("a_{C}", "a_C"),
        ("vC", "v_C"),
        ("v_C/B", "v_CB"),
        ("a^n_{CB}", "an_CB"),
        ("R₁₂", "R_12"),
        ("R_{12}", "R_12"),
        ("M_{1}", "M_1"),
    ],
)
def test_a_symbol_with_the_letters_and_figures_of_one_key_is_that_key(written: str, key: str) -> None:
    loaded = FOUR_BAR + 'loads: {F_3: {on: 3, at: C, size: 9 N, direction: 0 deg}, M_1: {on: 1, size: "?"}}\n'
    (ask,) = loads(loaded.replace("[v_C]", f'["{written}"]')).asks
    assert ask.rel.key == key


@each(IDS)
def test_every_symbol_of_motion_may_be_asked_for_as_it_is_printed(name: str) -> None:
    for ask in load(name).asks:
        if isinstance(ask.rel, Rel) and ask.rel.kind is not Kind.P:  # r_E is printed, p_E is asked
            assert plain(ask.rel.symbol) == plain(ask.rel.key) == ask.rel.key


@pytest.mark.parametrize(
    ("old", "new", "remedy"),
    [
        ("rad/s", "Rad/s", "did you mean 'rad/s'"),
        ("80 mm", "80 MM", "did you mean 'mm'"),
        ("rad/s", "R/min", "did you mean 'r/min'"),
        ("branch", "brnch", "did you mean 'branch'"),
        ("3: {CD: 80 mm}", "3: {CD: 80 mm}\n  4: {AD: 120 mm}", "link 4 is the frame itself; leave it out"),
    ],
)
def test_units_keys_and_the_frame_are_put_right(old: str, new: str, remedy: str) -> None:
    assert remedy in faults(old, new)


@pytest.mark.parametrize(
    ("text", "si"),
    [("10 rad/s CCW", 10.0), ("10 rad/s CW", -10.0), ("10 rad/s Clockwise", -10.0), ("10 rad/s anticlockwise", 10.0)],
)
def test_senses_are_read_in_any_capitals(text: str, si: float) -> None:
    assert read(text, Dim.OMEGA).si == si


def test_an_unknown_unit_that_is_like_none_lists_the_units() -> None:
    with pytest.raises(FaultError, match="known: mm cm m"):
        read("3 furlong", Dim.LENGTH)


@pytest.mark.parametrize(("asked", "drawn"), [("an_BC", "an_CB"), ("at_BC", "at_CB"), ("v_BC", "v_CB")])
def test_a_relative_vector_the_other_way_round_is_the_one_drawn_turned(asked: str, drawn: str) -> None:
    found = solve(loads(FOUR_BAR.replace("[v_C]", f"[{asked}, {drawn}, a_C]")), by="exact", repeats=0).answers
    assert_turned(found[asked], found[drawn])


def test_a_coriolis_term_the_other_way_round_is_the_one_drawn_turned() -> None:
    text = load("3-9").text.replace("id: 3-9", "id: x")
    found = solve(
        loads(text[: text.index("find:")] + "find: [a_C2, ak_C3C2, ak_C2C3]\n"), by="exact", repeats=0
    ).answers
    assert_turned(found["ak_C3C2"], found["ak_C2C3"])


def assert_turned(asked: Answer, drawn: Answer) -> None:
    """Equal and opposite, as drawn and in truth."""
    assert asked.drawn_vector is not None and drawn.drawn_vector is not None and abs(asked.drawn_vector) > 0.1
    assert asked.drawn_vector == pytest.approx(-drawn.drawn_vector) and asked.exact == pytest.approx(
        abs(asked.drawn_vector)
    )


def test_a_problem_that_asks_nothing_is_told_what_it_might_ask() -> None:
    problem = loads(FOUR_BAR.replace("find: [v_C]\n", ""))
    assert problem.id == "四杆-1" and problem.title.en == problem.title.zh == "铰链四杆机构"
    assert "find: [v_C, a_C, omega_3, alpha_3]" in nothing_asked(problem).en and not nothing_asked(loads(FOUR_BAR)).en


def test_of_what_is_known_the_numbered_ones_are_not_listed() -> None:
    """AB, and not AB_1 to AB_9 for each of nine solutions."""
    text = "id: t\ntitle: t\nsynthesis: angle-pairs\ndata:\n  guide: on y = 19 mm\n"
    text += "  pairs: [51 deg -> 123 mm, 78 deg -> 99 mm, 114 deg -> 93 mm]\nfind: [omega_1]\n"
    with pytest.raises(ProblemFileError, match=r"known: AB, BC, delta_B$"):
        loads(text)


def test_lengths_that_are_nothing_beside_the_others_end_in_no_traceback() -> None:
    text = load("whitworth-by-K").text.replace("id: whitworth-by-K", "id: x")
    at = text.index("AB: ")
    changed = text[:at] + "AB: 1e-19 m" + text[text.index(",", at) :]
    solution = solve(loads(changed), repeats=0)
    assert solution.answers["theta"].exact == pytest.approx(60.0)
    (told,) = [one.broken.en for one in solution.verification if one.broken is not None]
    assert told.startswith("nothing is left of $l_{") and told.endswith("as read")


def test_of_assemblies_without_number_six_are_told() -> None:
    """The slot leads through the crank's pivot, and all of it is on the circle of nothing: B is nowhere held."""
    text = load("3-14").text.replace("id: 3-14", "id: x").replace("frame: {A:", "frame: {C:").replace("{AB:", "{CA:")
    with pytest.raises(AssemblyError, match=r"joined in \d+ ways") as told:
        solve(loads(text), repeats=0)
    assert str(told.value).count("B: [") <= 6


@pytest.mark.parametrize(
    ("key", "kind", "right"), [("design", "crank-rocker", "synthesis"), ("task", "rotor", "device")]
)
def test_a_kind_under_a_key_of_ones_own_is_told_where_it_belongs(key: str, kind: str, right: str) -> None:
    with pytest.raises(ProblemFileError, match=f"line 3.*'{key}' is no key of a problem; write {right}: {kind}"):
        loads(f"id: t\ntitle: t\n{key}: {kind}\ndata: {{K: 1.5}}\n")


ROTOR = """\
id: t
title: t
device: rotor
data:
  masses: {1: {m: 5 kg, r: 100 mm, at: 0 deg}}
  correct: {I: {r: 150 mm}}
"""


@pytest.mark.parametrize(
    ("changed", "said"),
    [
        (ROTOR.replace("at: 0", "angle: 0"), "unknown key 'angle'; known: U, at, b, density, depth, hole"),
        (ROTOR.replace("{I: {r: 150 mm}}", "{r: 150 mm}"), "as correct: {I: {r: 150 mm}}"),
        (
            "id: t\ntitle: t\ndevice: structure\ndata: {joints: {A: R(0,1) at (0,0), B: R(1,2) at (9,0)}}\n",
            "line 4.*cut at its comma; .* goes between quotes",
        ),
        (
            FOUR_BAR + "loads: {F: {on: 3, at: {along: CD, at: 9 mm}, size: 1 N, direction: 0 deg}}\n",
            "loads.F.at: the letter of a point of the link is expected",
        ),
    ],
)
def test_what_is_known_at_a_place_is_what_that_very_place_may_hold(changed: str, said: str) -> None:
    with pytest.raises(ProblemFileError, match=said):
        loads(changed)
