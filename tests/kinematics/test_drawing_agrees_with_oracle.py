"""Random linkages: the exact hand agrees with the oracle on every quantity, or both refuse."""

from __future__ import annotations

from dataclasses import replace
from math import pi

import numpy as np
import pytest
from hypothesis import HealthCheck, assume, given, settings
from hypothesis import strategies as st

from tests.at_once import scaled
from tests.laws import often
from vecpoly import oracle
from vecpoly.board.hand import hand
from vecpoly.check.nudged import nudged
from vecpoly.errors import AssemblyError, DeadPointError, VecpolyError
from vecpoly.mechanism.model import ByOffsets, Drive, Link, Mechanism, Prismatic, Revolute, Side, SideOf
from vecpoly.methods.plan import construct
from vecpoly.names import parse_rel
from vecpoly.problem.asked.asks import AskRel
from vecpoly.problem.problem import Problem
from vecpoly.words import Words

lengths = st.floats(0.02, 0.3)
angles = st.floats(-pi, pi)
rates = st.sampled_from([-12.0, -1.0, 3.0, 10.0])
accels = st.sampled_from([0.0, 5.0, -20.0])
sides = st.sampled_from([Side.LEFT, Side.RIGHT])
CHECKED = settings(max_examples=often(15), suppress_health_check=[HealthCheck.filter_too_much])


def agree(mech: Mechanism, keys: str) -> None:
    """The drawing and the oracle agree within 1e-9 of the largest quantity of the kind, or both refuse."""
    problem = Problem(
        id="random", title=Words("", ""), subject=mech, asks=tuple(AskRel(rel=parse_rel(k)) for k in keys.split())
    )
    try:
        truth, near = (values(mech, keys, step) for step in (0.0, 1e-12))
    except DeadPointError:
        assume(False)  # within a hair of a dead point either may still find its way
    except AssemblyError:
        with pytest.raises(VecpolyError):
            construct(problem, hand("exact"))
        return
    size = {stem: max(abs(v) for k, v in truth.items() if k[0] == stem) for stem in {k[0] for k in truth}}
    try:
        drawn = readings(problem)
    except DeadPointError:
        motion = oracle.solve(mech)
        assert abs(np.sin(motion.angle("2") - motion.angle("3"))) < 1e-7, "refused as a dead point far from one"
        return
    off = {
        key: abs(drawn[key] - value) - 1e-9 * max(size[key[0]], 1e-9) - 100 * abs(near[key] - value)
        for key, value in truth.items()
    }
    if max(off.values()) > 0:
        shaken = scatter(problem, drawn)
        assert {key: gap for key, gap in off.items() if gap > 10 * shaken[key]} == {}


def readings(problem: Problem) -> dict[str, complex]:
    """What the exact hand reads."""
    found = construct(scaled(problem), hand("exact"))[0].readings
    return {key: complex(one.scalar) if one.vector is None else one.vector for key, one in found.items()}


def scatter(problem: Problem, drawn: dict[str, complex]) -> dict[str, float]:
    """How far the drawn values move when every length moves by a few units in the last place:
    what rounding alone does beside a dead point."""
    rng = np.random.default_rng(0)
    worst = dict.fromkeys(drawn, 0.0)
    for _ in range(4):
        there = readings(replace(problem, subject=nudged(problem.mechanism, rng)))
        worst = {key: max(off, abs(there[key] - drawn[key])) for key, off in worst.items()}
    return worst


def values(mech: Mechanism, keys: str, step: float) -> dict[str, complex]:
    """The oracle's answers at the input position shifted by a step:
    how much they move tells how well they are conditioned."""
    motion = oracle.solve(mech, mech.drive.position + step)
    return {key: complex(motion.value(parse_rel(key))) for key in keys.split()}


def crank(length: float, phi: float, rate: float, accel: float) -> tuple[Link, Drive]:
    return Link(name="1", points={"A": 0j, "B": complex(length)}), Drive(link="1", position=phi, rate=rate, accel=accel)


@CHECKED
@given(lengths, lengths, lengths, lengths, angles, rates, accels, sides, st.floats(-0.1, 0.1))
def test_four_bars(
    ab: float, bc: float, cd: float, ad: float, phi: float, rate: float, accel: float, side: Side, left: float
) -> None:
    one, drive = crank(ab, phi, rate, accel)
    mech = Mechanism(
        frame={"A": 0j, "D": complex(ad)},
        links=(
            one,
            Link(
                name="2",
                points={"B": 0j, "C": complex(bc), "E": complex(bc / 2, left)},
                placements=(ByOffsets(point="E", base=("B", "C"), along=bc / 2, left=left),),
            ),
            Link(name="3", points={"D": 0j, "C": complex(cd)}),
        ),
        joints=(
            Revolute(point="A", a="0", b="1"),
            Revolute(point="B", a="1", b="2"),
            Revolute(point="C", a="2", b="3"),
            Revolute(point="D", a="0", b="3"),
        ),
        drives=(drive,),
        branches=(SideOf(point="C", side=side, ref=("B", "D")),),
    )
    agree(mech, "v_B v_C v_CB v_E a_B a_C a_E an_CB at_CB an_C at_C omega_2 omega_3 alpha_2 alpha_3")


@CHECKED
@given(lengths, lengths, st.floats(-0.1, 0.1), angles, angles, rates, accels, sides)
def test_slider_cranks(
    ab: float, bc: float, offset: float, tilt: float, phi: float, rate: float, accel: float, side: Side
) -> None:
    one, drive = crank(ab, phi, rate, accel)
    mech = Mechanism(
        frame={"A": 0j},
        links=(one, Link(name="2", points={"B": 0j, "C": complex(bc)}), Link(name="3", points={"C": 0j})),
        joints=(
            Revolute(point="A", a="0", b="1"),
            Revolute(point="B", a="1", b="2"),
            Revolute(point="C", a="2", b="3"),
            Prismatic(guide="0", block="3", origin=complex(0, offset), direction=tilt, pin="C"),
        ),
        drives=(drive,),
        branches=(SideOf(point="C", side=side, ref=("B",)),),
    )
    agree(mech, "v_B v_C v_CB a_C an_CB at_CB omega_2 alpha_2")


@CHECKED
@given(lengths, lengths, angles, rates, accels, st.floats(-0.05, 0.05))
def test_swinging_blocks(ab: float, ac: float, phi: float, rate: float, accel: float, offset: float) -> None:
    one, drive = crank(ab, phi, rate, accel)
    mech = Mechanism(
        frame={"A": 0j, "C": complex(-ac)},
        links=(one, Link(name="2", points={"B": 0j, "E": 0.05 + 0.04j}), Link(name="3", points={"C": 0j})),
        joints=(
            Revolute(point="A", a="0", b="1"),
            Revolute(point="B", a="1", b="2"),
            Revolute(point="C", a="0", b="3"),
            Prismatic(guide="2", block="3", origin=0j, direction=0.0, pin="C", offset=offset),
        ),
        drives=(drive,),
    )
    agree(mech, "v_C2 v_C2B v_C2C3 v_E a_E an_C2B at_C2B ak_C2C3 ar_C2C3 omega_2 omega_3 alpha_2 alpha_3")


@CHECKED
@given(lengths, lengths, angles, rates, accels, st.floats(-0.05, 0.05))
def test_slotted_rockers(ab: float, ac: float, phi: float, rate: float, accel: float, offset: float) -> None:
    one, drive = crank(ab, phi, rate, accel)
    mech = Mechanism(
        frame={"A": 0j, "C": complex(0, -ac)},
        links=(one, Link(name="2", points={"B": 0j}), Link(name="3", points={"C": 0j, "D": 0.15 + 0.05j})),
        joints=(
            Revolute(point="A", a="0", b="1"),
            Revolute(point="B", a="1", b="2"),
            Revolute(point="C", a="0", b="3"),
            Prismatic(guide="3", block="2", origin=0j, direction=0.0, pin="B", offset=offset),
        ),
        drives=(drive,),
    )
    agree(mech, "v_B3 v_B3B2 v_D a_B3 an_B3 at_B3 ak_B3B2 ar_B3B2 a_D omega_3 alpha_3")


@CHECKED
@given(angles, rates, accels, st.floats(0.05, 0.3), st.floats(0.05, 0.3), sides, st.complex_numbers(max_magnitude=0.4))
def test_six_bars_with_a_slotted_link(
    phi: float, rate: float, accel: float, along: float, left: float, side: Side, pivot: complex
) -> None:
    """A guide on a moving link: the coupler point F of a double crank drives a slotted link about G."""
    one, drive = crank(0.28, phi, rate, accel)
    mech = Mechanism(
        frame={"A": 0j, "D": 0.16j, "G": pivot},
        links=(
            one,
            Link(name="2", points={"B": 0j, "C": 0.35 + 0j, "F": complex(along, left)}),
            Link(name="3", points={"C": 0j, "D": 0.32 + 0j}),
            Link(name="4", points={"F": 0j}),
            Link(name="5", points={"G": 0j}),
        ),
        joints=(
            Revolute(point="A", a="0", b="1"),
            Revolute(point="B", a="1", b="2"),
            Revolute(point="C", a="2", b="3"),
            Revolute(point="D", a="0", b="3"),
            Revolute(point="F", a="2", b="4"),
            Revolute(point="G", a="0", b="5"),
            Prismatic(guide="5", block="4", origin=0j, direction=0.0, pin="F"),
        ),
        drives=(drive,),
        branches=(SideOf(point="C", side=side, ref=("B", "D")),),
    )
    agree(mech, "v_F a_F omega_5 alpha_5 v_F5F4 ak_F5F4")


@CHECKED
@given(angles, rates, accels, angles)
def test_a_slider_on_a_moving_guide(phi: float, rate: float, accel: float, tilt: float) -> None:
    """RRP on a moving link: a rod from a crank's pin ends in a block that slides along the rocker."""
    one, drive = crank(0.05, phi, rate, accel)
    mech = Mechanism(
        frame={"A": 0j, "D": 0.2 + 0j},
        links=(
            one,
            Link(name="2", points={"B": 0j, "C": 0.2 + 0j, "F": 0.05 + 0.03j}),
            Link(name="3", points={"D": 0j, "C": 0.15 + 0j}),
            Link(name="4", points={"F": 0j, "H": 0.3 + 0j}),
            Link(name="5", points={"H": 0j}),
        ),
        joints=(
            Revolute(point="A", a="0", b="1"),
            Revolute(point="B", a="1", b="2"),
            Revolute(point="C", a="2", b="3"),
            Revolute(point="D", a="0", b="3"),
            Revolute(point="F", a="2", b="4"),
            Revolute(point="H", a="4", b="5"),
            Prismatic(guide="3", block="5", origin=0j, direction=tilt, pin="H"),
        ),
        drives=(drive,),
        branches=(SideOf(point="C", side=Side.LEFT, ref=("B", "D")), SideOf(point="H", side=Side.RIGHT, ref=("F",))),
    )
    agree(mech, "v_C v_H v_HF a_H an_HF at_HF omega_4 alpha_4 omega_5")


def test_a_crank_in_line_but_for_the_smallest_number_there_is() -> None:
    """The sliding velocity is then too small to have a direction; the drawing takes it for none."""
    one, drive = crank(0.25, 2.2250738585e-313, -12.0, 0.0)
    mech = Mechanism(
        frame={"A": 0j, "C": complex(-0.25)},
        links=(one, Link(name="2", points={"B": 0j, "E": 0.05 + 0.04j}), Link(name="3", points={"C": 0j})),
        joints=(
            Revolute(point="A", a="0", b="1"),
            Revolute(point="B", a="1", b="2"),
            Revolute(point="C", a="0", b="3"),
            Prismatic(guide="2", block="3", origin=0j, direction=0.0, pin="C"),
        ),
        drives=(drive,),
    )
    agree(mech, "v_C2 v_C2B v_E a_E at_C2B omega_2 alpha_2")
