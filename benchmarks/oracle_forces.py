"""The oracle of forces over a whole cycle, with friction, against a frictionless numpy closed form written by hand.

Slider-crank of exercise 4-3 at 3,601 positions, F drives one way and resists the other: the oracle gives the moment on
the crank and the three reactions with friction circles at A, B, C and the friction angle in the guide (and the
frictionless ones besides), the closed form gives the frictionless ones. Both run in turn, many times; the ratio is that
of the least CPU times. Run: python -m benchmarks.oracle_forces
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from vecpoly.mechanism.loads import Force, Friction, Loads, Moment
from vecpoly.mechanism.model import Drive, Link, Mechanism, Prismatic, Revolute, Side, SideOf
from vecpoly.oracle.forces import Forces, forces

from .timing import best

Reals = NDArray[np.float64]
AB, BC, GUIDE_Y, SIZE = 0.08, 0.23, -0.015, 1000.0
FIRST = 0.0005  # rad: beside the positions in which a joint does not turn
POSITIONS: Reals = FIRST + np.linspace(0.0, 2 * np.pi, 3601)


def mechanism() -> Mechanism:
    """The slider-crank as the oracle gets it."""
    links = (
        Link(name="1", points={"A": 0j, "B": AB}),
        Link(name="2", points={"B": 0j, "C": BC}),
        Link(name="3", points={"C": 0j}),
    )
    pins = (("A", "0", "1"), ("B", "1", "2"), ("C", "2", "3"))
    guide = Prismatic(guide="0", block="3", origin=1j * GUIDE_Y, direction=0.0, pin="C")
    return Mechanism(
        frame={"A": 0j},
        links=links,
        joints=(*(Revolute(point=p, a=a, b=b) for p, a, b in pins), guide),
        drives=(Drive(link="1", position=1.0, rate=1.0),),
        branches=(SideOf(point="C", side=Side.RIGHT, ref=("B",)),),
    )


def loads() -> Loads:
    """F to the left on the slider, friction in every joint."""
    friction = Friction(pins={"A": 0.006, "B": 0.005, "C": 0.004}, slides={("3", "0"): np.radians(8.0)})
    return Loads(
        forces=(Force(name="F", link="3", point="C", direction=np.pi, size=SIZE),),
        moments=(Moment(name="M_1", link="1"),),
        friction=friction,
    )


def by_hand(theta: Reals) -> tuple[Reals, ...]:
    """M_1, R_12 and R_43 without friction: real arithmetic for this mechanism and nothing else."""
    bx, by = AB * np.cos(theta), AB * np.sin(theta)
    dy = GUIDE_Y - by
    dx = np.sqrt(BC * BC - dy * dy)
    push = SIZE * dy / dx  # across the guide: the rod carries the force along itself
    moment = bx * push - by * SIZE
    return moment, np.full_like(theta, SIZE), push, -push


def by_oracle(mech: Mechanism, given: Loads) -> Forces:
    """Everything, with friction and without."""
    result = forces(mech, given, POSITIONS, strict=False)
    for key in ("M_1", "R_12", "R_41", "R_43", "eta"):
        result.value(key)
    return result


def run() -> str:
    """Check that both agree without friction, then time them in turn: one line of the report."""
    mech, given = mechanism(), loads()
    result, (moment, rx, ry, guide) = by_oracle(mech, given), by_hand(POSITIONS)
    ours = (
        result.value("M_1_0"),
        result.value("R_12_0").real,
        result.value("R_12_0").imag,
        result.value("R_43_0").imag,
    )
    worst = max(
        float(np.abs(a - b).max() / np.abs(b).max()) for a, b in zip(ours, (moment, rx, ry, guide), strict=True)
    )
    assert worst < 1e-12, worst
    locked = int(np.isnan(result.value("M_1")).sum())
    oracle, hand = best(lambda: by_oracle(mech, given), lambda: by_hand(POSITIONS), runs=60)
    return (
        f"forces with friction, slider-crank 4-3, {len(POSITIONS)} positions ({locked} locked): "
        f"{1e3 * oracle:.2f} ms = {oracle / hand:.0f} × numpy closed form without friction by hand "
        f"({1e6 * hand:.0f} µs); largest relative difference without friction {worst:.1e}"
    )


if __name__ == "__main__":
    print(run())
