"""A cam replaced by a linkage of lower pairs: with the centre of curvature that was drawn it moves as the law says."""

from __future__ import annotations

from cmath import exp, phase
from math import radians

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from tests.laws import often
from vecpoly import oracle
from vecpoly.board.board import Board
from vecpoly.board.construction import View
from vecpoly.board.hand import hand
from vecpoly.devices.cams.cam import Cam
from vecpoly.methods.devices.cam.diagram import place_of
from vecpoly.methods.devices.cam.laws import Lift, lift
from vecpoly.methods.devices.cam.pose import centre_of_curvature, pose
from vecpoly.methods.devices.cam.scales import cam_scales
from vecpoly.names import At, Kind, Rel
from vecpoly.plane import nominal
from vecpoly.problem.load import load, loads
from vecpoly.problem.problem import Problem, Scales


def drawn(cam: Cam, phi: float) -> tuple[complex, complex, Lift]:
    """B and the centre of curvature K as they stand in the frame (mm), and s with its derivatives."""
    board = Board(hand("exact"), cam_scales(cam, Scales()))
    board.step(View.MECHANISM.title)
    mm = 1e3 * board.scale_of(View.MECHANISM).value
    piece = next(piece for piece in cam.pieces if piece.start <= phi < piece.end)
    at = lift(board, place_of(cam), piece, phi)
    it = pose(board, View.MECHANISM, cam, phi, at)
    back = exp(1j * cam.sense * phi)
    b, k = (mm * back * complex(nominal(spot)) for spot in (it.b, centre_of_curvature(board, it)[0]))
    return b, k, at


def linkage(links: str, b: complex, k: complex, sense: str, *, frame: str = "O: [0 mm, 0 mm]") -> Problem:
    """The crank OK, as the cam turns with 1 rad/s, and the rod KB."""
    size, turn = abs(k), f"{k.real!r} mm, {k.imag!r} mm"
    text = f"""
id: replaced
title: {{zh: 高副低代, en: replaced}}
frame: {{{frame}}}
links: {{1: {{OK: {size!r} mm}}, 2: {{KB: {abs(b - k)!r} mm}}, {links}
guesses: {{B: [{b.real!r} mm, {b.imag!r} mm], K: [{turn}]}}
input: {{link: 1, phi: {phase(k)!r} rad, omega: 1 rad/s {sense}}}
find: [v_B]
"""
    return loads(text)


def moves(problem: Problem, kind: Kind) -> complex:
    return complex(oracle.solve(problem.mechanism).value(Rel(kind, At("B"))))


@settings(max_examples=often(6), deadline=None)
@given(degrees=st.integers(3, 117) | st.integers(153, 267))
def test_a_slider_crank_in_place_of_the_cam_has_its_velocity_and_acceleration(degrees: int) -> None:
    cam = load("cam-roller-offset").subject
    assert isinstance(cam, Cam)
    b, k, at = drawn(cam, radians(degrees))
    replaced = linkage("3: {block: B}}\njoints: [3 slides on x = 6 mm]", b, k, cam.turns)
    assert moves(replaced, Kind.V) == pytest.approx(1j * float(nominal(at.slope)), abs=1e-9)
    assert moves(replaced, Kind.A) == pytest.approx(1j * float(nominal(at.bend)), abs=1e-9)


@settings(max_examples=often(6), deadline=None)
@given(degrees=st.integers(3, 117) | st.integers(153, 267))
def test_a_four_bar_in_place_of_the_cam_swings_as_the_arm_does(degrees: int) -> None:
    cam = load("cam-rocker").subject
    assert isinstance(cam, Cam) and cam.arm
    b, k, at = drawn(cam, radians(degrees))
    frame = "O: [0 mm, 0 mm], A: [80 mm, 0 mm]"
    replaced = linkage("3: {AB: 70 mm}}", b, k, cam.turns, frame=frame)
    motion = oracle.solve(replaced.mechanism)
    omega, alpha = (float(motion.value(Rel(kind, At("", "3"))).real) for kind in (Kind.OMEGA, Kind.ALPHA))
    assert (omega, alpha) == pytest.approx((-float(nominal(at.slope)), -float(nominal(at.bend))), abs=1e-8)
