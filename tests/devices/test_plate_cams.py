"""Cams by inversion: drawn, exact, and as worked out elsewhere; their laws; what is refused."""

from __future__ import annotations

from functools import cache
from itertools import product
from math import atan2, degrees, hypot
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from tests.cam_cases import CASES, agree, cam_of, device, drawn, mirrored
from tests.laws import few, often
from vecpoly.board.board import Board
from vecpoly.board.construction import Scale, View
from vecpoly.board.hand import hand
from vecpoly.board.otherwise.slip import Mistake, Slip
from vecpoly.board.place import view_named
from vecpoly.devices.cams.cam import Cam
from vecpoly.devices.cams.motion import Law, Piece
from vecpoly.errors import ProblemFileError
from vecpoly.grading.derive.keyed import answer_key
from vecpoly.grading.slips.mutants import mutants
from vecpoly.methods.devices.cam.laws import lift
from vecpoly.methods.devices.cam.scales import cam_scales
from vecpoly.methods.devices.cam.trying import traced
from vecpoly.mistakes import slips
from vecpoly.oracle.devices.cams.laws import raised
from vecpoly.oracle.devices.registry import device_answers
from vecpoly.plane import nominal
from vecpoly.problem.load import load, loads
from vecpoly.problem.problem import Scales
from vecpoly.solution import solve

MEASURED = ("knife-1", "roller-1", "roller-3", "flat-1", "osc-1")
LAWS = {"cosine": "cosine", "cycloidal": "sine", "parabolic": "parabolic", "uniform": "uniform", "3-4-5": "3-4-5"}
MOTION = ["rise 30 mm in 120 deg cosine", "dwell 30 deg", "return in 120 deg parabolic", "dwell 90 deg"]
DISPLACEMENT = view_named("displacement")


@pytest.mark.parametrize("case", few(MEASURED, 2))
def test_every_station_stands_where_another_program_has_it(case: str) -> None:
    found = agree(cam_of(case))
    for row in CASES[case]["results"]["table"]:
        name = f"{row['phi']:g}"
        assert found[f"r_{name}"] == pytest.approx(hypot(*row["profile"]), abs=2e-8), name
        if row["phi"]:
            travel = found[f"s_{name}"] if "s" in row else found[f"psi_{name}"]
            assert travel == pytest.approx(row.get("s", row.get("psi_deg")), abs=2e-9), name
        if "alpha" in row:
            assert found[f"alpha_{name}"] == pytest.approx(abs(row["alpha"]), abs=2e-9), name


@pytest.mark.parametrize("case", MEASURED)
def test_extremes_are_those_that_were_found_by_sampling(case: str) -> None:
    found, told = device_answers(cam_of(case)), CASES[case]["results"]
    keys = {"alpha_rise": "alpha_max_rise", "alpha_return": "alpha_max_return", "rho_min": "rho_min_pitch_convex"}
    for key, name in {**keys, "rho_profile": "profile_rho_min", "s0": "s0", "psi0": "psi0"}.items():
        if name in told and key in found:
            assert found[key] == pytest.approx(abs(told[name]), rel=2e-4), key
    if case == "flat-1":
        assert [found["b_rise"], found["b_return"]] == pytest.approx(told["face_half_lengths"], rel=1e-9)
        assert found["rho_min"] == pytest.approx(told["rho_min"], abs=1e-8)


def test_the_least_circle_is_found_at_the_foot_of_a_perpendicular_not_at_the_apex() -> None:
    found, told = agree(cam_of("r0-1")), CASES["r0-1"]["results"]
    for key in ("r0", "e", "s0"):
        assert found[key] == pytest.approx(told["minimum"][key], rel=1e-7)
        assert found[f"{key}_apex"] == pytest.approx(told["apex"][key], rel=1e-7)
    assert found["r0_central"] == pytest.approx(told["r0_min_without_offset"], rel=1e-7)
    assert found["r0"] < found["r0_apex"]


def test_the_least_circle_keeps_both_pressure_angles() -> None:
    cam = cam_of("r0-1")
    assert isinstance(cam, Cam)
    found, angles = device_answers(cam), []
    for piece in (piece for piece in cam.pieces if piece.rises):
        s, slope, _ = raised(piece, np.linspace(piece.start, piece.end, 20001))
        leaning = np.arctan2(piece.rises * (1e3 * slope - found["e"]), found["s0"] + 1e3 * s)
        angles.append(float(np.degrees(leaning.max())))
    assert angles == pytest.approx(CASES["r0-1"]["results"]["alpha_max_with_minimum"], rel=1e-5)


@settings(max_examples=often(8), deadline=None)
@given(rise=st.floats(20, 50), back=st.floats(40, 80), start=st.floats(10, 60), turns=st.sampled_from(["ccw", "cw"]))
def test_with_the_start_bounded_no_smaller_circle_keeps_all_three_pressure_angles(
    rise: float, back: float, start: float, turns: str
) -> None:
    """Against all places of O on a grid of directions: by the cam's motion alone, no bounds drawn."""
    allowed = {"rise": f"{rise} deg", "return": f"{back} deg", "start": f"{start} deg"}
    cam = device("cam", follower={"knife": "yes"}, alpha=allowed, motion=MOTION, turns=turns)
    assert isinstance(cam, Cam)
    found, sense = agree(cam), 1 if turns == "ccw" else -1
    e, s0 = sense * found["e"], found["s0"]
    assert keeps(cam, e, s0, slack=1e-4) and not keeps(cam, 0.999 * e, 0.999 * s0)
    around = np.radians(np.linspace(1, 179, 179))
    assert not any(keeps(cam, 0.999 * found["r0"] * np.cos(at), 0.999 * found["r0"] * np.sin(at)) for at in around)


def keeps(cam: Cam, e: float, s0: float, slack: float = 0.0) -> bool:
    """Whether the follower's pressure angles (mm, the axis at (e, −s0)) stay under what is allowed of each stroke."""
    assert cam.alpha and cam.alpha.start
    good = np.arctan2(e, s0) <= cam.alpha.start.si + slack
    for piece in (piece for piece in cam.pieces if piece.rises):
        s, slope, _ = raised(piece, np.linspace(piece.start, piece.end, 721))
        leaning = np.arctan2(piece.rises * (1e3 * slope - e), s0 + 1e3 * s)
        good &= bool(leaning.max() <= (cam.alpha.rise if piece.rises > 0 else cam.alpha.back).si + slack)
    return bool(good)


# -- the laws of motion --------------------------------------------------------------------------------------------


def lifted(law: Law, u: float, rises: int = 1) -> tuple[float, ...]:
    """s, s′ and s″ of a stroke of 1 m in 1 rad, drawn by the exact hand."""
    board = Board(hand("exact"), {DISPLACEMENT: Scale.of(DISPLACEMENT, 0.02, 0.01)})
    board.step(view_named("mechanism").title)
    piece = Piece(start=0.0, angle=1.0, low=0.0, high=1.0, rises=rises, law=law)
    at = lift(board, DISPLACEMENT, piece, u if rises > 0 else 1 - u)
    return tuple(float(nominal(value)) for value in (at.s, at.slope, at.bend))


@pytest.mark.parametrize("name", LAWS)
def test_each_construction_gives_s_and_its_derivatives(name: str) -> None:
    for u, s, v, a in CASES["laws"]["results"][name]["rows_u_s_v_a"]:
        assert lifted(Law(LAWS[name]), u) == pytest.approx((s, v, a), abs=2e-9), u


@settings(max_examples=often(25), deadline=None)
@given(law=st.sampled_from(list(Law)), u=st.floats(0, 1))
def test_a_return_is_its_rise_run_backwards_and_both_halves_are_alike(law: Law, u: float) -> None:
    up, down, other = lifted(law, u), lifted(law, u, rises=-1), lifted(law, 1 - u)
    assert down == pytest.approx((up[0], -up[1], up[2]), abs=1e-9)
    assert other[:2] == pytest.approx((1 - up[0], up[1]), abs=1e-9)


@pytest.mark.parametrize("law", Law)
def test_a_law_starts_below_and_ends_above_at_rest_unless_it_is_uniform(law: Law) -> None:
    start, end = lifted(law, 0.0), lifted(law, 1.0)
    assert (start[0], end[0]) == pytest.approx((0, 1), abs=1e-12)
    assert (start[1], end[1]) == pytest.approx((1, 1) if law is Law.UNIFORM else (0, 0), abs=1e-12)


@pytest.mark.parametrize(
    ("laws", "said"),
    [(("uniform", "uniform"), "rigid shock"), (("cosine", "parabolic"), "soft shock"), (("sine", "3-4-5"), "no shock")],
)
def test_a_jump_has_its_name(laws: tuple[str, str], said: str) -> None:
    motion = [f"rise 20 mm in 180 deg {laws[0]}", f"return in 180 deg {laws[1]}"]
    steps = drawn(device("cam", follower={"knife": "yes"}, r0="40 mm", motion=motion)).steps
    assert said in steps[0].words.en


# -- any cam -------------------------------------------------------------------------------------------------------

ANY_LAW = st.sampled_from([law.value for law in Law])
END = st.sampled_from([{"knife": "yes"}, {"roller": "8 mm"}, {"flat": "yes"}])


@st.composite
def cams(draw: st.DrawFn) -> dict[str, Any]:
    end = dict(draw(END))
    if "flat" not in end and draw(st.booleans()):
        end["offset"] = f"{draw(st.integers(-20, 20))} mm"
    rise, back = draw(st.integers(80, 150)), draw(st.integers(80, 150))
    high = draw(st.integers(5, 30))
    motion = [f"rise {high} mm in {rise} deg {draw(ANY_LAW)}", f"return in {back} deg {draw(ANY_LAW)}"]
    return {"follower": end, "r0": "60 mm", "motion": [*motion, f"dwell {360 - rise - back} deg"], "stations": "30 deg"}


@settings(max_examples=often(4), deadline=None)
@given(data=cams())
def test_any_cam_is_drawn_as_the_oracle_computes_it(data: dict[str, Any]) -> None:
    agree(device("cam", **data), within=1e-8)


@settings(max_examples=often(4), deadline=None)
@given(data=cams())
def test_a_mirrored_cam_has_the_same_answers(data: dict[str, Any]) -> None:
    end = dict(data["follower"])
    if "offset" in end:
        end["offset"] = f"{-int(end['offset'].split()[0])} mm"
    one, other = (
        device_answers(device("cam", **data)), device_answers(device("cam", **data | {"follower": end, "turns": "cw"}))
    )  # fmt: skip
    assert mirrored({key: float(np.real(value)) for key, value in other.items()}) == pytest.approx(
        one, rel=1e-9, abs=1e-9
    )


@pytest.mark.parametrize("case", ["roller-1", "roller-3", "osc-1"])
def test_no_point_of_the_profile_is_nearer_to_a_place_of_the_roller_than_its_radius(case: str) -> None:
    cam = cam_of(case)
    assert isinstance(cam, Cam)
    parts = traced(Board(hand("exact"), cam_scales(cam, Scales())), cam)
    centres = np.concatenate([part.pitch for part in parts])
    for part in parts:
        assert np.abs(part.edge - part.pitch) == pytest.approx(cam.follower.radius, abs=1e-12)
        assert (np.abs(part.edge[::5, None] - centres[None, :]) > cam.follower.radius - 1e-5).all()


def test_neighbouring_faces_meet_on_the_profile() -> None:
    """The envelope by its definition: two faces that are nearly one meet where both touch."""
    cam = cam_of("flat-1")
    assert isinstance(cam, Cam) and cam.r0
    board = Board(hand("exact"), {**cam_scales(cam, Scales()), View.MECHANISM: Scale.of(View.MECHANISM, 1e-3)})
    part = traced(board, cam, [2000] * len(cam.pieces))[0]
    normals, distance = part.pitch / np.abs(part.pitch), np.abs(part.pitch)
    for i in range(100, 1900, 200):
        (a, b), (p, q) = normals[i : i + 2], distance[i : i + 2]
        met = 1j * (a * q - b * p) / (np.conj(a) * b).imag  # Re(z ā) = p, Re(z b̄) = q
        assert abs(met - part.edge[i]) < 1e-4


# -- undercut ------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("follower", "r0", "spoilt"),
    few(
        [
            ({"roller": "10 mm"}, "50 mm", False),
            ({"roller": "46 mm"}, "50 mm", False),
            ({"roller": "49 mm", "offset": "6 mm"}, "50 mm", True),
            ({"flat": "yes"}, "50 mm", False),
            ({"flat": "yes"}, "12 mm", True),
        ],
        2,
    ),
)
def test_a_roller_larger_than_the_least_radius_and_a_circle_too_small_for_a_face_are_told(
    follower: dict[str, Any], r0: str, spoilt: bool
) -> None:
    subject = device("cam", follower=follower, r0=r0, motion=MOTION)
    construction = drawn(subject)
    assert bool(construction.readings["undercut"].scalar) is spoilt is bool(device_answers(subject)["undercut"])
    assert ("must" in construction.steps[-3 if "flat" in follower else -1].words.en) is spoilt


def test_a_heart_cam_cannot_be_followed_by_a_roller() -> None:
    motion = ["rise 30 mm in 180 deg uniform", "return in 180 deg uniform"]
    subject = device("cam", follower={"roller": "5 mm"}, r0="40 mm", motion=motion)
    assert drawn(subject).readings["undercut"].scalar == 1 == device_answers(subject)["undercut"]


# -- mistakes ------------------------------------------------------------------------------------------------------


@cache
def catalogue(name: str) -> tuple[Slip, ...]:
    """The mistakes that can be made with a problem."""
    return tuple(slips(load(name)))


@pytest.mark.parametrize(
    ("mistake", "key", "wrong"),
    [
        (Mistake.DROPPED, "r_r", "r_60"),  # the pitch curve is taken for the profile
        (Mistake.REVERSED, "e", "alpha_60"),  # the guide on the other side
        (Mistake.REVERSED, "mechanism alpha_rise:OP", "alpha_rise"),
    ],
)
def test_a_mistake_with_offset_roller_or_centre_can_be_made(mistake: Mistake, key: str, wrong: str) -> None:
    problem, slip = load("cam-roller-offset"), Slip(mistake, key)
    assert slip in catalogue("cam-roller-offset")
    right, other = (
        solve(problem, by="exact", repeats=0, precise=False, slip=one).answers[wrong].drawn for one in (None, slip)
    )
    assert abs(other - right) > 0.5


@pytest.mark.parametrize(("name", "shows"), [("cam-rocker", "alpha_60"), ("cam-flat-arm", "r_210")])
def test_the_angle_of_an_arm_may_be_set_out_towards_the_axis(name: str, shows: str) -> None:
    """ψ, from the first place of the arm, to the other side: as s of a guided follower may be laid off inwards. Where
    the arm has not swung there is nothing to set out wrongly."""
    problem, slip = load(name), Slip(Mistake.OTHER_SIDE, "ψ")
    assert slip in catalogue(name) and Slip(Mistake.COMPLEMENT, "ψ") not in catalogue(name)
    right, wrong = (
        {key: one.drawn for key, one in solve(problem, by="exact", repeats=0, precise=False, slip=made).answers.items()}
        for made in (None, slip)
    )
    assert wrong["r_60"] < right["r_60"] - 5.0 and abs(wrong[shows] - right[shows]) > 5.0
    assert wrong["psi0"] == right["psi0"]


@pytest.mark.parametrize("name", ["cam-rocker", "cam-flat-arm", "cam-flat-face", "cam-heart", "cam-roller-offset"])
def test_a_profile_that_is_asked_shows_which_way_it_was_inverted(name: str) -> None:
    problem, slip = load(name), Slip(Mistake.FORWARDS, "inversion")
    key = answer_key(problem)
    (made,) = mutants(problem, key, [slip])
    assert any(key[one].asked for one in made.values)


# -- refusals ------------------------------------------------------------------------------------------------------

TEXT = load("cam-roller-offset").text


@pytest.mark.parametrize(
    ("old", "new", "said"),
    [
        ("offset: 6 mm", "offset: 60 mm", "must be less than r0"),
        ("roller: 10 mm", "roller: 55 mm", "must be less than r0"),
        ("roller: 10 mm,", "", "knife edge, a roller or a flat face"),
        ("roller: 10 mm", "roller: 10 mm, knife: yes", "here stand knife, roller"),
        ("roller: 10 mm, offset: 6 mm", "flat: yes, offset: 6 mm", "leave out 'offset'"),
        ("roller: 10 mm, offset: 6 mm", "roller: 10 mm, arm: {OA: 10 mm, AB: 10 mm}", "a length is|is not an angle"),
        ("dwell 90 deg", "dwell 80 deg", "add up to 350 deg.*add 10 deg"),
        ("return in", "return 20 mm in", "stands 10 mm above its start"),
        ("return in", "return 40 mm in", "does not stand that high"),
        ("deg cosine", "deg cosin", "no law of motion; there are uniform"),
        ("rise 30 mm in 120 deg cosine", "rise quickly", "write e.g. rise 30 mm"),
        ("r0: 50 mm", "alpha: {rise: 30 deg, return: 95 deg}", "between 0 and 90 deg"),
        ("r0: 50 mm", "alpha: {rise: 30 deg, return: 70 deg, start: 0 deg}", "alpha.start = 0 deg.*between 0 and 90"),
        ("r0: 50 mm", "", "write one of r0 and alpha"),
        ("stations: 15 deg", "stations: 2 deg", "5 … 45 deg"),
    ],
)
def test_what_cannot_be_made_is_refused_with_the_range_that_can(old: str, new: str, said: str) -> None:
    assert old in TEXT
    with pytest.raises(ProblemFileError, match=said):
        loads(TEXT.replace(old, new, 1))


@pytest.mark.parametrize(
    ("arm", "said"),
    [("{OA: 200 mm, AB: 70 mm}", "between 130 mm and 270 mm"), ("{OA: 40 mm, AB: 30 mm}", "swing less than")],
)
def test_an_arm_that_does_not_close_is_refused(arm: str, said: str) -> None:
    text = load("cam-rocker").text.replace("{OA: 80 mm, AB: 70 mm}", arm).replace("rise 25 deg", "rise 125 deg")
    with pytest.raises(ProblemFileError, match=said):
        loads(text)


# -- by hand -------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    "name",
    few(
        [
            "cam-heart",
            "cam-roller-offset",
            "cam-flat-face",
            "cam-flat-arm",
            "cam-rocker",
            "cam-undercut",
            "cam-least-circle",
        ],
        3,
    ),
)
def test_a_careful_hand_is_off_by_no_more_than_its_drawing_error(name: str) -> None:
    solution = solve(load(name), repeats=60)
    assert not solution.suspect
    for answer in solution.answers.values():
        assert abs(answer.deviation) <= 1.7 * answer.expected_error + 1e-9 * abs(answer.exact), answer.key


# -- arms to the left, flat faces that swing -----------------------------------------------------------------------


@settings(max_examples=often(3))
@given(swing=st.integers(5, 12), turns=st.sampled_from(["ccw", "cw"]), off=st.integers(-8, 8))
def test_a_flat_face_that_swings_is_drawn_as_its_support_function_has_it(swing: int, turns: str, off: int) -> None:
    motion = [f"rise {swing} deg in 120 deg cosine", "dwell 30 deg", "return in 120 deg sine", "dwell 90 deg"]
    arm = {"OA": "90 mm", "face": f"{off} mm", "side": "left" if off % 2 else "right"}
    agree(device("cam", follower={"flat": "yes", "arm": arm}, r0="45 mm", motion=motion, turns=turns))


@pytest.mark.parametrize("follower", few([{"roller": "8 mm"}, {"knife": "yes"}, {"flat": "yes"}], 3))
def test_an_arm_to_the_left_is_the_mirror_image_of_one_to_the_right(follower: dict[str, str]) -> None:
    arm = {"OA": "80 mm", **({"face": "4 mm"} if "flat" in follower else {"AB": "70 mm"})}
    motion = ["rise 12 deg in 120 deg cosine", "dwell 30 deg", "return in 120 deg parabolic", "dwell 90 deg"]
    right, left = (
        agree(
            device("cam", follower={**follower, "arm": {**arm, "side": side}}, r0="40 mm", motion=motion, turns=turns)
        )
        for side, turns in (("right", "ccw"), ("left", "cw"))
    )
    assert right == pytest.approx(mirrored(left), abs=1e-9)


def test_where_the_acceleration_jumps_the_radius_just_before_counts_too() -> None:
    """It falls to 38.5148 mm there, by differences of the pitch curve; at the piece's beginning it is 38.5209 mm."""
    motion = ["rise 11 deg in 149 deg 3-4-5", "dwell 14 deg", "return in 93 deg parabolic", "dwell 104 deg"]
    arm = {"OA": "65 mm", "AB": "82 mm"}
    found = agree(device("cam", follower={"roller": "9 mm", "arm": arm}, r0="40 mm", motion=motion, turns="cw"))
    assert found["rho_min"] == pytest.approx(38.5148, abs=5e-5)


@pytest.mark.parametrize(
    ("arm", "said"),
    [
        ("{OA: 90 mm, AB: 70 mm, side: left}", "leave out AB"),
        ("{OA: 90 mm, face: 50 mm}", "does not touch the base circle from above.*between -45 mm and 45 mm"),
        ("{OA: 50 mm, face: 0 mm}", "would stand nearly across OA; let it swing less than"),
    ],
)
def test_a_flat_face_that_cannot_swing_so_is_refused(arm: str, said: str) -> None:
    text = load("cam-flat-arm").text.replace("{OA: 90 mm, face: 6 mm, side: left}", arm).replace("12 deg", "25 deg")
    with pytest.raises(ProblemFileError, match=said):
        loads(text)


@pytest.mark.parametrize("rise", [30, 50, 70])
def test_a_rise_that_begins_beyond_the_allowed_angle_on_the_other_side_is_told(rise: int) -> None:
    text = load("cam-least-circle").text.replace("rise: 30 deg", f"rise: {rise} deg")
    solution = solve(loads(text), repeats=0)
    e, s0 = (float(solution.answers[key].drawn.real) for key in ("e", "s0"))
    begins = degrees(atan2(e, s0))
    told = [step.words.en for step in solution.construction.steps if "third line" in step.words.en]
    assert bool(told) is (begins > rise) and all(f"about {begins:.0f}°" in words for words in told)


def test_between_two_stations_nothing_is_asked_and_the_nearest_are_named() -> None:
    text = load("cam-roller-offset").text
    assert "find: [" in text
    with pytest.raises(ProblemFileError, match="there is no station at 200, the nearest are s_195 and s_210"):
        loads(text.replace("find: [", "find: [s_200, "))


ARM = {"roller": "8.5 mm", "arm": {"OA": "84 mm", "AB": "73 mm"}}


WAYS = [(turns, side, law) for law in ("cosine", "3-4-5", "uniform") for side in ("right", "left") for turns in
        ("ccw", "cw")]  # fmt: skip


@pytest.mark.parametrize(("turns", "side", "law"), few(WAYS, 8))
def test_an_arm_that_turns_faster_than_the_cam_keeps_its_roller_outside(turns: str, side: str, law: str) -> None:
    """P comes from infinity on the other side: the normal into the cam then leads away from it (r was off by 10 mm)."""
    follower = {**ARM, "arm": {**ARM["arm"], "side": side}}  # type: ignore[dict-item]
    for up, down in ((30, 150), (120, 30)):
        rest = f"dwell {300 - up - down} deg"
        motion = [f"rise 40 deg in {up} deg {law}", "dwell 60 deg", f"return in {down} deg {law}", rest]
        agree(device("cam", follower=follower, r0="34 mm", motion=motion, turns=turns, stations="5 deg"))


@pytest.mark.parametrize(("turns", "law"), few([*product(("ccw", "cw"), ("parabolic", "sine"))], 4))
def test_where_arm_and_cam_turn_alike_the_normal_is_parallel_to_the_line_of_their_pivots(turns: str, law: str) -> None:
    """30° in 60° with twice the mean speed: P is at infinity in the middle (it was refused as a dead point)."""
    motion = [f"rise 30 deg in 60 deg {law}", "dwell 60 deg", f"return in 60 deg {law}", "dwell 180 deg"]
    agree(device("cam", follower=ARM, r0="34 mm", motion=motion, turns=turns))


LEAST = {"cosine": 18.849, "sine": 24.0, "3-4-5": 22.5, "uniform": 12.0}
ALIKE = [(*way, *law) for law in LEAST.items() for way in (("ccw", "rise"), ("cw", "return"))]


@pytest.mark.parametrize(("turns", "with_it", "law", "least"), few(ALIKE, 5))
def test_a_flat_face_that_would_swing_as_fast_as_the_cam_is_refused_with_the_range(
    turns: str, with_it: str, law: str, least: float
) -> None:
    """Seen from the cam it stands still for a moment and is touched at infinity; swinging against the cam it may."""
    text = load("cam-flat-arm").text.replace("r0: 45 mm", f"r0: 45 mm\n  turns: {turns}")
    strokes = {"rise": "rise 12 deg in {} deg {}", "return": "return in {} deg {}"}

    def posed(stroke: str, angle: float) -> str:
        other = "return" if stroke == "rise" else "rise"
        parts = {stroke: strokes[stroke].format(angle, law), other: strokes[other].format(120, "sine")}
        motion = f"{parts['rise']}, dwell 90 deg, {parts['return']}, dwell {150 - angle:g} deg"
        return text[: text.index("  motion:")] + f"  motion: [{motion}]\nfind: [psi0, l_min, l_max, rho_min]\n"

    with pytest.raises(ProblemFileError, match="take more than"):
        loads(posed(with_it, least - 0.5))
    against = "return" if with_it == "rise" else "rise"
    for stroke, angle in ((with_it, least + 3.0), (against, least - 0.5)):
        assert not solve(loads(posed(stroke, angle)), by="exact", repeats=0).suspect
