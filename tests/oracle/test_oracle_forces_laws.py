"""Laws of statics with friction, on random slider-cranks, four-bars and cams."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from math import pi, radians

import numpy as np
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from tests.laws import often
from tests.oracle.test_oracle_forces_models import (
    disc_cam,
    four_bar,
    heavy,
    out_of_balance,
    slider_crank,
    softened,
    turned,
)
from vecpoly.errors import AssemblyError, EquilibriumError, LockedError
from vecpoly.mechanism.asked.forces import pairs
from vecpoly.mechanism.loads import Force, Friction, Loads, Moment
from vecpoly.mechanism.model import Mechanism
from vecpoly.oracle import solve
from vecpoly.oracle.forces import Forces, forces

Case = tuple[Callable[[float], Mechanism], Callable[[float], Loads]]  # both as functions of how far the paper is turned
few = settings(max_examples=often(30))


def real(low: float, high: float) -> st.SearchStrategy[float]:
    return st.floats(low, high, allow_nan=False)


@st.composite
def slider_cranks(draw: st.DrawFn) -> Case:
    ab, ratio, y, phi = draw(real(0.03, 0.12)), draw(real(1.8, 5.0)), draw(real(-0.4, 0.4)), draw(real(0, 2 * pi))
    rate, toward = draw(st.sampled_from([-3.0, 3.0])), draw(real(0, 2 * pi))
    rho, angle = [ab * draw(real(0.001, 0.08)) for _ in "ABC"], draw(real(0.001, 0.25))
    weighed = draw(st.booleans())
    rough = Friction(pins=dict(zip("ABC", rho, strict=True)), slides={("3", "0"): angle})

    def loads(tilt: float) -> Loads:
        force = Force(name="F", link="3", point="C", direction=toward + tilt, size=500.0)
        return Loads(
            forces=(force,),
            moments=(Moment(name="M_1", link="1"),),
            friction=rough,
            masses=heavy(ab) if weighed else (),
        )

    return lambda tilt: slider_crank(ab, ratio * ab, y * ab, phi, rate, tilt=tilt, S=0.4 * ratio * ab), loads


@st.composite
def four_bars(draw: st.DrawFn) -> Case:
    ab, phi, rate = draw(real(0.03, 0.12)), draw(real(0, 2 * pi)), draw(st.sampled_from([-3.0, 3.0]))
    bc, cd, da = (ab * draw(real(2.0, 4.0)) for _ in range(3))
    toward, resisting = draw(real(0, 2 * pi)), draw(real(-40.0, 40.0))
    rough = Friction(pins={letter: ab * draw(real(0.001, 0.08)) for letter in "ABCD"})

    def loads(tilt: float) -> Loads:
        force = Force(name="F", link="2", point="S", direction=toward + tilt, size=300.0)
        return Loads(
            forces=(force,),
            moments=(Moment(name="M_1", link="1"), Moment(name="M_3", link="3", size=resisting)),
            friction=rough,
        )

    return lambda tilt: four_bar(ab, bc, cd, da, phi, rate, tilt=tilt, S=bc * (0.5 + 0.2j)), loads


@st.composite
def cams(draw: st.DrawFn) -> Case:
    e, phi, rate, tip = (
        draw(real(0.006, 0.018)),
        draw(real(0, 2 * pi)),
        draw(st.sampled_from([-3.0, 3.0])),
        draw(real(0.005, 0.02)),
    )
    pivot, lever = complex(draw(real(0.11, 0.13)), draw(real(-0.02, 0.03))), draw(real(0.1, 0.12))
    rough = Friction(
        pins={"A": draw(real(1e-4, 6e-3)), "P": draw(real(1e-4, 6e-3))}, contacts={"K": draw(real(0.001, 0.2))}
    )

    def mech(tilt: float) -> Mechanism:
        return disc_cam(e, 0.046, pivot, lever, tip, 0.15, phi, rate, "left", tilt=tilt)

    across = np.angle(complex(solve(mech(0.0)).position("G") - pivot)) + pi / 2  # presses the tip on the cam

    def loads(tilt: float) -> Loads:
        return Loads(
            forces=(Force(name="Q", link="2", point="G", direction=across + tilt, size=200.0),),
            moments=(Moment(name="M_1", link="1"),),
            friction=rough,
        )

    return mech, loads


cases = st.one_of(slider_cranks(), four_bars(), cams())


def solved(case: Case, share: float = 1.0, tilt: float = 0.0) -> Forces:
    """The equilibrium, where there is one and the joints move."""
    try:
        return forces(case[0](tilt), softened(case[1](tilt), share))
    except (AssemblyError, EquilibriumError):
        assume(False)
        raise


def largest(result: Forces) -> float:
    """The largest reaction, with friction or without."""
    return max(
        abs(complex(result.value(key)))
        for a, b in pairs(result.mech)
        for key in [f"R_{result.mech.number(a)}{result.mech.number(b)}"]
        for key in (key, f"{key}_0")
    )


def lasting(case: Case) -> Forces:
    """As `solved`, away from dead points, where small differences of position are large differences of force."""
    result = solved(case)
    known = max(
        [abs(load.size) / (1.0 if isinstance(load, Force) else 0.05) for load in result.loads.all if load.size],
        default=1.0,
    )
    assume(largest(result) < 100 * max(known, 1.0))
    return result


@few
@given(cases)
def test_every_link_is_in_equilibrium_when_summed_by_a_stranger(case: Case) -> None:
    result = lasting(case)
    assert out_of_balance(result, result.mech, result.loads) < 1e-9


@few
@given(cases)
def test_reaction_is_opposite_and_on_the_same_line(case: Case) -> None:
    result = lasting(case)
    for a, b in pairs(result.mech):
        i, j = result.mech.number(a), result.mech.number(b)
        for key in ("R_{}{}", "R_{}{}_0"):
            assert complex(result.value(key.format(i, j))) == -complex(result.value(key.format(j, i)))
        assert complex(result.line(i, j)) == complex(result.line(j, i)) or not abs(complex(result.value(f"R_{i}{j}")))


@few
@given(cases)
def test_power_in_is_power_out_and_losses(case: Case) -> None:
    result = solved(case)
    assert abs(result.power_in - result.power_out - result.loss) <= 1e-9 * result.power_in
    assert result.loss >= 0


@few
@given(cases)
def test_efficiency_lies_between_nothing_and_one(case: Case) -> None:
    result = solved(case)
    eta = float(result.value("eta"))
    assert 0 <= eta <= 1 + 1e-12 if result.loads.dynamic else 0 < eta <= 1 + 1e-12


@few
@given(cases)
def test_little_friction_tends_to_none(case: Case) -> None:
    assume(largest(lasting(case)) > 0)
    result = solved(case, 1e-7)
    for key in ("R_12", "R_21"):
        assert abs(complex(result.value(key)) - complex(result.value(f"{key}_0"))) <= 1e-4 * largest(result)
    arm = result.mech.scale * largest(result)
    assert abs(result.value("M_1") - result.value("M_1_0")) <= 1e-4 * arm


@few
@given(cases, real(0.05, 0.95))
def test_more_friction_never_raises_the_efficiency(case: Case, share: float) -> None:
    """Without masses: where inertia forces drive in one position and resist in another, η has no such order."""
    bare = (case[0], lambda tilt: replace(case[1](tilt), masses=()))
    less = solved(bare, share)
    try:
        more = forces(less.mech, bare[1](0.0))
    except LockedError:
        return
    except EquilibriumError:
        assume(False)
        raise
    assert more.value("eta") <= less.value("eta") + 1e-12


@few
@given(cases, real(0.05, 0.95))
def test_what_locks_with_little_friction_locks_with_more(case: Case, share: float) -> None:
    bare = (case[0], lambda tilt: replace(case[1](tilt), masses=()))
    mech, q = case[0](0.0), case[0](0.0).drive.position + np.linspace(0.0, 2 * pi, 90)
    try:
        less, more = (forces(mech, softened(bare[1](0.0), s), q, strict=False).value("eta") for s in (share, 1.0))
    except AssemblyError:
        assume(False)
        raise
    assert not (np.isnan(less) & (more > 0)).any()


@few
@given(cases, real(-pi, pi))
def test_turning_the_paper_turns_the_forces_and_nothing_else(case: Case, tilt: float) -> None:
    result = lasting(case)
    other, size = forces(case[0](tilt), case[1](tilt)), largest(result)
    assert abs(other.value("M_1") - result.value("M_1")) <= 1e-8 * size * result.mech.scale
    assert abs(other.value("eta") - result.value("eta")) <= 1e-7
    for a, b in pairs(result.mech):
        i, j = result.mech.number(a), result.mech.number(b)
        one, two = complex(result.value(f"R_{i}{j}")) * turned(tilt), complex(other.value(f"R_{i}{j}"))
        assert abs(one - two) <= 1e-8 * size
        if abs(one) > 1e-3 * size:
            away = complex(result.line(i, j)) * turned(tilt) - complex(other.line(i, j))
            assert abs((away.conjugate() * two).imag) <= 1e-7 * size * result.mech.scale


@few
@given(cases)
def test_virtual_power_and_equilibrium_agree_without_friction(case: Case) -> None:
    result = lasting(case)
    assert abs(result.value("M_1_power") - result.value("M_1_0")) <= 1e-9 * largest(result) * result.mech.scale


@few
@given(cases)
def test_friction_is_against_the_motion_in_every_joint(case: Case) -> None:
    """The reaction does negative work on the relative motion of the two links, in every joint."""
    result = lasting(case)
    motion = solve(result.mech)
    for a, b in pairs(result.mech):
        i, j = result.mech.number(a), result.mech.number(b)
        force, at = complex(result.value(f"R_{i}{j}")), np.array([complex(result.line(i, j))])
        slip = complex((motion.body(b).velocity_at(at) - motion.body(a).velocity_at(at))[0])
        assert (force.conjugate() * slip).real <= 1e-12 * abs(force) * abs(slip)


def test_friction_is_solved_on_the_branch_that_begins_without_it() -> None:
    """Near locking the balancing force is large and follows the friction without a jump,
    up to the share at which it locks."""
    mech = slider_crank(0.08, 0.23, -0.015, radians(172.0))
    loads = Loads(
        forces=(Force(name="F", link="3", point="C", direction=pi),),
        moments=(Moment(name="M_1", link="1", size=-50.0),),
        friction=Friction(pins={"A": 0.006, "B": 0.005, "C": 0.004}, slides={("3", "0"): radians(8.0)}),
    )
    found = [
        float(forces(mech, softened(loads, share), strict=False).value("F")) for share in np.linspace(0.0, 1.0, 21)
    ]
    lives = np.isfinite(found)
    assert lives[0] and not lives[-1] and (np.diff(lives.astype(int)) <= 0).all()
    alive = np.array(found)[lives]
    assert (alive > 0).all() and (np.diff(alive) > 0).all() and (np.diff(alive, 2) > 0).all()
