"""A cam's profile in a mechanism: by the law, by central differences, and by the linkage that replaces it."""

from __future__ import annotations

from math import degrees, radians

import numpy as np
import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st

import vecpoly
from tests.devices.cams_moving import FOLLOWERS, cam_of, motions, moved
from tests.laws import few, often
from vecpoly import oracle
from vecpoly.devices.cams.cam import Cam
from vecpoly.devices.cams.motion import piece_at
from vecpoly.errors import EquilibriumError, NoMethodError, ProblemFileError
from vecpoly.mechanism.model import CamProfile, Mechanism
from vecpoly.methods.exchange.profile import osculated
from vecpoly.oracle.devices.cams.laws import raised
from vecpoly.oracle.devices.cams.shape import profile
from vecpoly.problem.load import load, loads
from vecpoly.problem.problem import Problem
from vecpoly.solution import solve

LIBRARY = ("cam-moves-roller", "cam-moves-arm", "cam-moves-face", "cam-moves-flat-arm")
CLEAR = 1e-3  # rad off the ends of a piece, where the acceleration may jump
Case = tuple[str, str, str, float]


@st.composite
def cases(draw: st.DrawFn) -> Case:
    """Follower, motion, sense, and an angle of the cam (deg) at which nothing jumps."""
    follower = draw(st.sampled_from(sorted(FOLLOWERS)))
    motion, turns = draw(motions("arm" in follower)), draw(st.sampled_from(["ccw", "cw"]))
    return follower, motion, turns, draw(st.floats(0, 360))


def smooth(cam: Cam, turn: float) -> float:
    """The station φ (rad) to which the cam has turned; assumed to be clear of jumps."""
    phi = cam.sense * turn % (2 * np.pi)
    ends = [0.0, *(e for piece in cam.pieces for e in (piece.end, (piece.start + piece.end) / 2))]
    assume(min(abs(phi - end) for end in ends) > CLEAR)
    return phi


def cam_in(mech: Mechanism) -> tuple[CamProfile, Cam]:
    (one,) = mech.cams
    assert isinstance(one.cam, Cam)
    return one, one.cam


def followed(problem: Problem) -> tuple[float, float]:
    """Rate and second rate of the follower: v and a upwards of a guided one, ω and α of an arm."""
    motion, (one, cam) = oracle.solve(problem.mechanism), cam_in(problem.mechanism)
    if cam.arm:
        return float(motion.omega(one.follower)), float(motion.alpha(one.follower))
    return float(np.imag(motion.velocity(one.end))), float(np.imag(motion.acceleration(one.end)))


@settings(max_examples=often(5))
@given(case=cases())
def test_the_follower_moves_as_the_law_says(case: Case) -> None:
    """v = ω ds/dφ, a = ω² d²s/dφ² + α ds/dφ, ω and α those of the cam in the sense for which it was designed."""
    follower, motion, turns, turn = case
    problem = moved(follower, motion, turns, turn)
    cam, drive = cam_of(follower, motion, turns), problem.mechanism.drive
    phi = smooth(cam, radians(turn))
    _, first, second = (float(row[0]) for row in raised(piece_at(cam.pieces, phi)[0], np.array([phi])))
    rate, gain = cam.sense * drive.rate, cam.sense * drive.accel
    way = -cam.side if cam.arm else 1
    expected = way * first * rate, way * (second * rate**2 + first * gain)
    assert followed(problem) == pytest.approx(expected, rel=1e-9, abs=1e-12)


@given(case=cases())
def test_the_follower_rests_on_the_profile_that_was_designed_for_it(case: Case) -> None:
    follower, motion, turns, turn = case
    mech = moved(follower, motion, turns, turn).mechanism
    cam = cam_of(follower, motion, turns)
    phi = smooth(cam, radians(turn))
    touch = complex(oracle.solve(mech).position("T")) * np.exp(-1j * radians(turn))
    assert touch == pytest.approx(complex(profile(cam, piece_at(cam.pieces, phi)[0], np.array([phi]))[0]), abs=1e-12)


@given(case=cases())
def test_both_links_move_alike_across_the_contact(case: Case) -> None:
    """Along the common normal neither body leaves the other nor enters it."""
    follower, motion, turns, turn = case
    mech = moved(follower, motion, turns, turn).mechanism
    smooth(cam_of(follower, motion, turns), radians(turn))
    motion_, (one, _) = oracle.solve(mech), cam_in(mech)
    at, centre = motion_.place("T"), motion_.position(one.centre)
    normal = (complex(at[0]) - complex(centre)) / abs(complex(at[0]) - complex(centre))
    slip = motion_.moving(one.follower).velocity_at(at) - motion_.moving("1").velocity_at(at)
    assert (slip[0] * normal.conjugate()).real == pytest.approx(0, abs=1e-9)


@given(case=cases())
def test_velocities_and_accelerations_are_central_differences(case: Case) -> None:
    follower, motion, turns, turn = case
    mech = moved(follower, motion, turns, turn, alpha=0.0).mechanism
    smooth(cam_of(follower, motion, turns), radians(turn))
    step, own, (one, _) = 1e-5, mech.drive.position, cam_in(mech)
    found = oracle.solve(mech, np.array([own - step, own, own + step]))
    for letter in (one.end, "T"):
        at = np.asarray(found.position(letter))
        if letter != "T":  # the point of contact wanders over both bodies
            expected = (at[2] - at[0]) / (2 * step) * mech.drive.rate
            assert np.asarray(found.velocity(letter))[1] == pytest.approx(expected, abs=2e-8)
    speed = np.asarray(found.velocity(one.end))
    expected = (speed[2] - speed[0]) / (2 * step) * mech.drive.rate
    assert np.asarray(found.acceleration(one.end))[1] == pytest.approx(expected, abs=2e-6)


@settings(max_examples=often(4))
@given(case=cases())
def test_the_linkage_that_replaces_the_pair_moves_as_the_law_says(case: Case) -> None:
    """The drawn centre of curvature, in the ordinary mechanism of a disc: it knows nothing of the law."""
    problem = moved(*case)
    smooth(cam_of(*case[:3]), radians(case[3]))
    try:
        replaced, _ = osculated(problem.mechanism)
    except NoMethodError as error:
        assume(error.code not in ("no-centre", "follower-rests"))
        raise
    one, cam = cam_in(problem.mechanism)
    disc = Mechanism(**{name: getattr(replaced, name) for name in replaced.__dataclass_fields__ if name != "cams"})
    other, exact = oracle.solve(disc), oracle.solve(problem.mechanism)
    size = max(abs(complex(exact.acceleration(one.end))), 1.0)
    assert complex(other.position(one.end)) == pytest.approx(complex(exact.position(one.end)), abs=1e-9)
    assert complex(other.velocity(one.end)) == pytest.approx(complex(exact.velocity(one.end)), abs=1e-8)
    assert complex(other.acceleration(one.end)) == pytest.approx(complex(exact.acceleration(one.end)), abs=1e-6 * size)
    assert cam.r0 is not None


@pytest.mark.parametrize("name", few(tuple(LIBRARY), 5))
def test_the_drawing_agrees_with_the_law_at_every_station(name: str) -> None:
    problem = vecpoly.load(name)
    (one, cam), refused = cam_in(problem.mechanism), []
    for phi, _ in cam.places[::2]:
        try:
            solution = solve(
                problem.vary(phi=f"{cam.sense * degrees(phi)!r} deg"), by="exact", repeats=0, precise=False
            )
        except NoMethodError as error:
            assert error.code in ("no-centre", "follower-rests")
            refused.append(phi)
            continue
        for key, answer in solution.answers.items():
            assert answer.drawn == pytest.approx(answer.exact, abs=1e-8), (degrees(phi), key)
    rests = [phi for phi, _ in cam.places[::2] if piece_at(cam.pieces, phi)[0].law is None]
    assert set(rests) <= set(refused) and len(refused) <= len(rests) + 2, (one.link, refused)


LOADED = {"cam-roller-load": 2, "cam-face-load": 3, "cam-knife-load": 0}  # places at rest, or locked on the return


@pytest.mark.parametrize("name", few(tuple(LOADED), 3))
def test_reactions_with_friction_agree_over_the_cycle(name: str) -> None:
    """Without roles, for the load helps on the return; where the follower rests friction has no sense."""
    problem = vecpoly.loads(
        f"extends: {name}\nid: turned\nloads: {{Q: {{role: null}}, M: {{role: null}}}}\nfind: [R_12, M]\n"
    )
    refused = []
    for phi in range(20, 360, 45):
        try:
            answers = solve(problem.vary(phi=f"{phi} deg"), by="exact", repeats=0, precise=False).answers
        except EquilibriumError:
            refused.append(phi)
            continue
        for key in ("R_12", "M"):
            assert answers[key].drawn == pytest.approx(answers[key].exact, rel=1e-8, abs=1e-8), (phi, key)
    assert len(refused) == LOADED[name], refused


def test_a_cam_named_by_its_file_is_the_cam_of_that_file() -> None:
    (profile_,) = load("cam-moves-roller").mechanism.cams
    assert profile_.cam == load("cam-roller-offset").subject


WRONG = {
    "radius: 10 mm": ("radius: 9 mm", "roller's radius (mm) is 9 here and 10 there"),
    "x = 6 mm": ("x = 5 mm", "offset (mm) is 5 here and 6 there"),
    "2 slides on x = 6 mm": ("2 slides on y = 6 mm", "moves upright"),
    "profile of cam-roller-offset": ("profile of 3-9", "'3-9' is no cam"),
    "about O": ("about X", "turns about no fixed pivot"),
    "1: {cam: profile of cam-roller-offset about O}": (
        "1: {cam: cam-roller-offset}",
        "is no cam; name the cam problem",
    ),
    "of cam-roller-offset": ("of cam-undercut", "is not that of the cam problem"),
    "about O}": ("about O, OB: 3 mm}", "has OB besides"),
}


@pytest.mark.parametrize("part", list(WRONG))
def test_a_follower_that_is_not_the_cam_problems_is_refused_with_both_numbers(part: str) -> None:
    text = load("cam-moves-roller").text
    assert part in text
    with pytest.raises(ProblemFileError) as refused:
        solve(loads(text.replace(part, WRONG[part][0])))
    assert WRONG[part][1] in refused.value.words.en


ARM = """
id: arm
title: arm
frame: {O: [0 mm, 0 mm], A: [AT, 0 mm]}
links:
  1: {cam: {about: O, r0: 45 mm, turns: ccw, follower: {flat: yes, arm: {OA: 90 mm, face: 6 mm, side: WHERE}},
            motion: [rise 12 deg in 130 deg cosine, dwell 20 deg, return 12 deg in 120 deg sine, dwell 90 deg]}}
  2: {AE: 120 mm, face: {through: A, OFF: 6 mm}}
joints: [1 touches 2 at T SIDE of the face]
input: {link: 1, phi: 50 deg, omega: 10 rad/s ccw}
find: [omega_2]
"""


@pytest.mark.parametrize(("where", "at", "side"), [("right", "90 mm", "left"), ("left", "-90 mm", "right")])
def test_a_cam_on_the_wrong_side_of_a_face_is_refused_though_the_face_is_as_far_from_its_pivot(
    where: str, at: str, side: str
) -> None:
    """With both on the other side the distance is the same, and the drawing was of another follower."""
    text = ARM.replace("WHERE", where).replace("AT", at)
    other = "left" if side == "right" else "right"
    found = solve(loads(text.replace("OFF", other).replace("SIDE", side)), by="exact", repeats=0).answers["omega_2"]
    assert found.drawn == pytest.approx(found.exact, rel=1e-9)
    with pytest.raises(ProblemFileError) as refused:
        loads(text.replace("OFF", side).replace("SIDE", other))
    assert f"has the cam on the {side} of its face" in refused.value.words.en


def test_an_undercut_profile_moves_nothing() -> None:
    text = load("cam-moves-roller").text.replace("cam-roller-offset", "cam-undercut")
    wide = text.replace("radius: 10 mm", "radius: 18 mm").replace("x = 6 mm", "x = -10 mm")
    problem = loads(wide)
    for attempt in (lambda: oracle.solve(problem.mechanism), lambda: solve(problem)):
        with pytest.raises(NoMethodError, match="undercut"):
            attempt()


WANDERING = {
    "loads:\n  F: {on: 1, at: K, size: 9 N, direction: 0 deg}\n  M_b: {on: 1, size: '?'}": "is not on link 1; known: O",
    "loads:\n  F: {spring: O-K, k: 5 N/mm, l_0: 20 mm}\n  M_b: {on: 1, size: '?'}": "no moving link has a point 'K'",
    "loads:\n  F: {on: 2, at: B, size: 9 N, direction: -90 deg, while: K moves left}\n  M_b: {on: 1, size: '?'}": (
        "no moving link has a point 'K'"
    ),
    "masses: {1: {mass: 2 kg, centre: K}}": "is not on link 1; known: O",
    "target: {point: K, through: [[60 mm, 0 mm], [50 mm, 9 mm], [30 mm, 9 mm]]}": "no moving link carries a point 'K'",
}


@pytest.mark.parametrize("said", list(WANDERING))
def test_nothing_is_fixed_to_the_centre_of_curvature_which_wanders_over_its_cam(said: str) -> None:
    text = load("cam-moves-roller").text
    assert load("cam-moves-roller").mechanism.cams[0].centre == "K"
    with pytest.raises(ProblemFileError) as refused:
        loads(f"{text}\n{said}\n")
    assert WANDERING[said] in refused.value.words.en


def test_the_mass_of_a_cam_is_at_its_pivot_where_nothing_else_is_said() -> None:
    text = load("cam-moves-roller").text.replace("find: [", "find: [J_e, ")
    told = f"{text}\nmasses: {{1: {{mass: 2 kg, inertia: 0.5 kg*m^2}}}}\n"
    assert solve(loads(told), by="exact", repeats=0, precise=False).answers["J_e"].drawn == pytest.approx(
        0.5, rel=1e-12
    )
