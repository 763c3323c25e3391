"""Epicyclic trains by Kutzbach's diagrams and gears by generation: drawn, exact, worked out elsewhere, refused."""

from __future__ import annotations

from math import acos, cos, pi, radians, tan
from typing import Any

import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from tests.cam_cases import CASES, agree, device, drawn
from tests.laws import often
from vecpoly.board.construction import View
from vecpoly.board.paper.marks import Arc, Curve, GearMark, Point, Role, Segment
from vecpoly.errors import NotAskedError, ProblemFileError
from vecpoly.methods.devices.epicyclic.scales import TURNS
from vecpoly.methods.devices.gear_generation.rack import VIEW
from vecpoly.oracle.devices.registry import device_answers
from vecpoly.problem.load import load, loads
from vecpoly.report.answers.notes import notes_of
from vecpoly.solution import solve
from vecpoly.words import Lang

TEETH = st.integers(12, 60)
SPEED = st.integers(-30, 30)


def train_of(case: str) -> Any:
    told = CASES[case]["inputs"]
    z1, z2, *rest = told["teeth"]
    planets = {"planet": z2, "ring": rest[0]} if len(rest) == 1 else {"planet": [z2, rest[0]], "ring": rest[1]}
    turns = {f"omega_{link}": f"{omega} rad/s" for link, omega in told["given"].items()}
    return device("epicyclic", sun=z1, **planets, **turns)


@pytest.mark.parametrize("case", ["train-1", "train-4", "train-5"])
def test_the_speeds_are_those_of_the_worked_train(case: str) -> None:
    train, told = train_of(case), CASES[case]["results"]
    found = agree(train)
    for link in ("1", "2", "3", "H"):
        assert found[f"omega_{link}"] == pytest.approx(told[f"w{link}"], abs=1e-9), link
    for point, speed in told["kutzbach"]["v"].items():
        assert 1e3 * found[f"v_{point}"] == pytest.approx(speed, abs=1e-7), point
    for point, radius in told["kutzbach"]["radii"].items():
        assert 1e3 * train.radii[{"A": "1", "O2": "H", "C": "3"}[point]] == pytest.approx(radius, abs=1e-9)


@pytest.mark.parametrize("case", ["train-1", "train-4"])
def test_all_rays_end_on_the_level_line_on_which_the_speeds_are_read(case: str) -> None:
    figure = drawn(train_of(case)).figure(TURNS)
    assert figure is not None
    [level] = [mark for mark in figure.marks if isinstance(mark, Segment) and mark.role is Role.CONSTRUCTION]
    ends = [mark.at for mark in figure.marks if isinstance(mark, Point) and mark.label != "Π"]
    assert len(ends) == 5 and {end.imag for end in (level.a, level.b, *ends)} == {0}
    assert level.a.real < min(end.real for end in ends) and max(end.real for end in ends) < level.b.real


@pytest.mark.parametrize("planet, ring", [((33, 21), 78), ((40, 15), 79), ((22,), 66)])
def test_the_planets_lie_within_the_body_of_the_ring(planet: tuple[int, ...], ring: int) -> None:
    train: Any = device("epicyclic", sun=22, planet=list(planet), ring=ring, omega_1="20 rad/s", omega_3="0 rad/s")
    figure = drawn(train).figure(View.MECHANISM)
    assert figure is not None
    wheels = [mark for mark in figure.marks if isinstance(mark, GearMark)]
    [body] = [mark for mark in figure.marks if isinstance(mark, Arc) and mark.role is Role.LINK]
    reach = max(abs(wheel.centre) + wheel.radius for wheel in wheels)
    assert body.radius > reach + 1.0 and body.radius >= train.radii["3"] / figure.scale.value + 4.0


@st.composite
def trains(draw: st.DrawFn) -> dict[str, Any]:
    sun, planet = draw(TEETH), draw(TEETH)
    match draw(st.integers(0, 2)):
        case 0:
            teeth: dict[str, Any] = {"planet": planet, "ring": sun + 2 * planet}
        case 1:
            teeth = {"planet": [planet, draw(TEETH)], "ring": draw(st.integers(70, 130))}
        case _:
            teeth = {"planet": [planet, draw(TEETH)], "sun_2": draw(TEETH)}
    links = draw(st.sampled_from([("1", "3"), ("1", "H"), ("3", "H")]))
    speeds = draw(st.tuples(SPEED, SPEED).filter(any))
    return {"sun": sun, **teeth, **{f"omega_{link}": f"{w} rad/s" for link, w in zip(links, speeds, strict=True)}}


def basic(data: dict[str, Any]) -> float:
    """(ω_1 − ω_H) / (ω_3 − ω_H), by the teeth: an outer mesh turns the sense, an inner one does not."""
    if not isinstance(data["planet"], list):
        return -float(data["ring"] / data["sun"])
    large, small = data["planet"]
    outer = -large / data["sun"]
    return float(outer * data["ring"] / small if "ring" in data else -outer * data["sun_2"] / small)


@settings(max_examples=often(10), deadline=None)
@given(data=trains())
def test_any_train_moves_as_willis_says(data: dict[str, Any]) -> None:
    assume(
        abs(basic(data) - 1) > 0.05
        and any(data[f"omega_{link}"][0] != "0" for link in "13H" if f"omega_{link}" in data)
    )
    found = device_answers(device("epicyclic", **data))
    w1, w3, arm = (float(found[f"omega_{link}"].real) for link in ("1", "3", "H"))
    assert w1 - arm == pytest.approx(basic(data) * (w3 - arm), abs=1e-7)


@settings(max_examples=often(5), deadline=None)
@given(data=trains())
def test_any_train_that_can_be_read_is_drawn_as_it_is_computed(data: dict[str, Any]) -> None:
    try:
        subject = device("epicyclic", **data)
        found = agree(subject, within=1e-8)
    except (NotAskedError, ValueError):
        assume(False)
    else:
        assert found


@settings(max_examples=often(5), deadline=None)
@given(data=trains())
def test_a_mirrored_train_turns_all_its_links_the_other_way(data: dict[str, Any]) -> None:
    backwards = {key: _reversed(value) if key.startswith("omega") else value for key, value in data.items()}
    try:
        here, there = (agree(device("epicyclic", **one), within=1e-8) for one in (data, backwards))
    except (NotAskedError, ValueError):
        assume(False)
    else:
        signed = [key for key in here if key.startswith(("omega", "v_"))]
        assert signed and {key: there[key] for key in signed} == pytest.approx({key: -here[key] for key in signed})
        assert {key: there[key] for key in here.keys() - set(signed)} == pytest.approx(
            {key: here[key] for key in here.keys() - set(signed)}
        )


def _reversed(speed: str) -> str:
    return speed.removeprefix("-") if speed.startswith("-") else f"-{speed}"


def test_a_ratio_of_ten_thousand_is_known_but_not_measured() -> None:
    for driver in ("H", "1"):
        given_ = {f"omega_{driver}": "100 rad/s", "omega_3": "0 rad/s"}
        train = device("epicyclic", sun=100, planet=[101, 100], sun_2=99, **given_)
        ratio = float(device_answers(train)["i_H1" if driver == "H" else "i_1H"].real)
        assert ratio == pytest.approx(1e4 if driver == "H" else 1e-4, rel=1e-9)
        with pytest.raises(NotAskedError, match="too large to be measured"):
            drawn(train)


@pytest.mark.parametrize("name", ["train-ring", "train-stepped", "train-differential"])
def test_velocities_and_rays_lie_on_the_side_to_which_points_above_the_axis_move(name: str) -> None:
    problem = load(name)
    solution, exact = solve(problem, by="exact"), device_answers(problem.subject)  # type: ignore[arg-type]
    for place, letters in (("radii", {"a": "A", "o_2": "O2", "c": "C"}), ("turns", {"1": "1", "2": "2", "H": "H"})):
        figure = next(one for one in solution.construction.figures if one.view.name == place)
        spots = {mark.label: mark.at for mark in figure.marks if isinstance(mark, Point)}
        for letter, of in letters.items():
            value = exact[f"v_{of}" if place == "radii" else f"omega_{of}"].real
            assert spots[letter].real * value < 0 or abs(spots[letter].real) < 1e-6 > abs(value), letter


TRAIN = load("train-ring").text


@pytest.mark.parametrize(
    ("old", "new", "said"),
    [
        ("ring: 64", "ring: 65", r"z_3 = z_1 \+ 2 z_2 = 64"),
        ("ring: 64", "sun_2: 30", "one of 'ring' and 'sun_2'"),
        ("sun: 20", "sun: 2", "from 3 to 2000"),
        ("10 rad/s ccw", "0 rad/s", "nothing turns"),
        ("planet: 22, ring: 64", "planet: [22, 70], ring: 64", "more teeth than the planet in it, 70"),
        (", omega_3: 0 rad/s", "", "two of omega_1, omega_3 and omega_H; here stand omega_1"),
        ("planet: 22, ring: 64", "planet: [20, 20], sun_2: 20", "both central gears always turn alike"),
    ],
)
def test_a_train_that_cannot_be_built_is_refused(old: str, new: str, said: str) -> None:
    assert old in TRAIN
    with pytest.raises(ProblemFileError, match=said):
        loads(TRAIN.replace(old, new, 1))


# -- generation ----------------------------------------------------------------------------------------------------


def gear(**data: Any) -> Any:
    return device("gear-generation", **data)


@pytest.mark.parametrize("case", ["gear-1", "gear-2", "gear-4"])
def test_the_tooth_is_that_of_the_numerical_generation(case: str) -> None:
    given_, told = CASES[case]["inputs"], CASES[case]["results"]
    found = agree(gear(m=f"{given_['m']} mm", z=given_["z"], x=str(given_["x"])))
    names = {"s": "tooth_thickness_pitch", "s_tip": "tip_thickness", "r_start": "involute_start_radius"}
    for key in ("r", "rb", "ra", "rf", "x_min", "z_min"):
        assert found[key] == pytest.approx(told[key], abs=2e-9), key
    for key, name in names.items():
        assert found[key] == pytest.approx(told[name], abs=2e-8), key
    assert bool(found["undercut"]) is told["undercut"]


@settings(max_examples=often(6), deadline=None)
@given(z=st.integers(7, 40), x=st.floats(-0.3, 0.6).map(lambda x: round(x, 2)), m=st.integers(2, 20))
def test_any_gear_is_drawn_as_it_is_computed(z: int, x: float, m: int) -> None:
    subject = gear(m=f"{m} mm", z=z, x=str(x), steps=6)
    assume(abs(x - float(device_answers(subject)["x_min"].real)) > 1e-6)
    agree(subject, within=1e-8)


@given(z=st.integers(7, 60), x=st.floats(0, 0.5))
def test_the_tip_is_thinner_than_the_pitch_and_all_grows_with_the_module(z: int, x: float) -> None:
    one, double = (device_answers(gear(m=f"{m} mm", z=z, x=str(x))) for m in (3, 6))
    assert one["s_tip"].real < one["s"].real
    lengths = [key for key in one if key not in ("x_min", "z_min", "undercut")]
    assert [double[key] for key in lengths] == pytest.approx([2 * one[key] for key in lengths], rel=1e-9)
    ra, rb, alpha = one["ra"].real, one["rb"].real, radians(20)
    slope = acos(rb / ra)
    thick = ra * ((pi / 2 + 2 * x * tan(alpha)) * 2 / z + 2 * (tan(alpha) - alpha - tan(slope) + slope))
    assert one["s_tip"] == pytest.approx(max(thick, 0.0), rel=1e-9) and rb == pytest.approx(1.5 * z * cos(alpha))


@pytest.mark.parametrize(("x", "cut"), [("0", True), ("0.4", True), ("0.42", False)])
def test_the_shift_at_which_undercut_ends_is_told(x: str, cut: bool) -> None:
    construction = drawn(gear(m="10 mm", z=10, x=x))
    assert bool(construction.readings["undercut"].scalar) is cut
    assert any("should be at least 0.415" in step.words.en for step in construction.steps) is cut


@pytest.mark.parametrize(
    ("old", "new", "said"),
    [
        ("z: 10", "z: 4", "from 5 to 200"),
        ("steps: 20", "steps: 100", "from 6 to 60"),
        ("x: 0,", "x: 2,", "the shift should be -1 … 1.5"),
        ("m: 10 mm", "m: 10 mm, alpha: 45 deg", "10 … 30 deg"),
        ("m: 10 mm", "m: 10 mm, ha: 2", "0.5 … 1.25"),
    ],
)
def test_a_gear_that_no_rack_cuts_is_refused(old: str, new: str, said: str) -> None:
    text = load("gear-undercut").text
    assert old in text
    with pytest.raises(ProblemFileError, match=said):
        loads(text.replace(old, new, 1))


@pytest.mark.parametrize("name", ["train-ring", "train-stepped", "train-differential", "gear-undercut", "gear-shifted"])
def test_a_careful_hand_is_off_by_no_more_than_its_drawing_error(name: str) -> None:
    solution = solve(load(name), repeats=60)
    assert not solution.suspect
    for answer in solution.answers.values():
        assert abs(answer.deviation) <= 1.7 * answer.expected_error + 1e-9 * abs(answer.exact), answer.key


def test_a_tip_near_the_limit_is_judged_by_the_exact_hand_and_left_open_by_one_that_cannot_tell() -> None:
    exact, drafted = drawn(gear(m="10 mm", z=10, x="0.45")), solve(load("gear-shifted"), by="drafting").construction
    told = [one.readings["s_tip"].remark for one in (exact, drafted)]
    assert told[0] is not None and "齿顶过薄" in told[0].zh and "the tip is too thin" in told[0].en
    assert told[1] is not None and "不能由图判定" in told[1].zh and "reading error" in told[1].en
    assert not any(" m$" in text or "0.239" in text for one in told if one for text in (one.zh, one.en))


@pytest.mark.parametrize(("m", "z", "x"), [(5, 8, "0.6"), (2, 12, "0.9"), (4, 9, "0.8")])
def test_a_tooth_whose_flanks_meet_before_its_tip_circle_is_pointed_and_that_is_an_answer(
    m: float, z: int, x: str
) -> None:
    assert device_answers(gear(m=f"{m} mm", z=z, x=x))["s_tip"] == 0.0
    data = f"data: {{m: {m} mm, z: {z}, x: {x}, steps: 20}}"
    text = f"id: t\ntitle: t\ndevice: gear-generation\n{data}\nfind: [s_tip]\n"
    for hand in ("exact", "drafting", "pencil"):
        solution = solve(loads(text), by=hand)
        answer = solution.answers["s_tip"]
        assert answer.drawn == 0.0 and answer.suspect is None, hand
        told = solution.construction.readings["s_tip"].remark
        assert told is not None and "pointed" in told.en and "smaller shift" in told.en and "变尖" in told.zh


@pytest.mark.parametrize("lang", ["zh", "en"])
def test_what_the_tip_is_stands_in_the_answer_and_no_undercut_stands_there_once(lang: Lang) -> None:
    notes = notes_of(list(solve(load("gear-shifted"), by="exact").answers.values()), lang)
    assert sum("0.25·m" in note for note in notes) == 1
    assert not any("x_min" in note for note in notes)
    cut = notes_of(list(solve(load("gear-undercut"), by="exact").answers.values()), lang)
    assert sum("x_min" in note for note in cut) == 1


def test_every_symbol_of_the_tip_is_lettered_on_the_sheet_and_the_circle_of_the_module_is_the_reference_circle() -> (
    None
):
    steps = solve(load("gear-shifted"), by="exact").construction.steps
    said = " ".join(step.words.en for step in steps)
    assert "reference circle" in said and "pitch circle" not in said
    assert not any("δ" in str(formula) for step in steps for formula in step.formulas)


@pytest.mark.parametrize(("angle", "whole"), [("20 deg", 17), ("15 deg", 30), ("25 deg", 12)])
def test_the_least_number_of_teeth_is_told_as_the_whole_number_of_the_textbooks(angle: str, whole: int) -> None:
    steps = drawn(gear(m="10 mm", z=10, x="0", alpha=angle)).steps
    assert any(f"= {whole}." in step.words.en for step in steps)


@pytest.mark.parametrize("name", ["gear-undercut", "gear-shifted"])
def test_the_start_of_the_involute_is_marked_on_the_tooth_and_where_it_is_cut(name: str) -> None:
    figure = solve(load(name)).construction.figure(VIEW)
    assert figure is not None
    spots = {mark.label: mark.at for mark in figure.marks if isinstance(mark, Point)}
    start, corner = spots["S"], spots["S′"]
    assert abs(start) == pytest.approx(abs(corner), abs=0.05)
    ends = [curve.points[0] for curve in figure.marks if isinstance(curve, Curve) and curve.role is Role.LINK]
    assert start in ends and abs(start - corner) > 5.0
