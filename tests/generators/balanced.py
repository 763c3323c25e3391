"""Random linkages with counterweights: judged by the places of the finished linkage; its centre of mass is to rest."""

from __future__ import annotations

import numpy as np

from vecpoly.devices.balancing.asked import CLOSES
from vecpoly.mechanism.asked.counterweights import bearing, product, weight
from vecpoly.oracle import solve
from vecpoly.oracle.forces.laws.drives import drive_range
from vecpoly.solution import Solution

from .family import family

CLOSE = 1e-7  # of all masses times the size of the linkage
HEAD = "id: balanced\ntitle: {zh: 平衡, en: balanced}\nframe: {A: [0 mm, 0 mm]"


def centre_rests(solution: Solution) -> str:
    """Σ m r of all links and of the counterweights as drawn, at places over the range of the drive."""
    problem = solution.problem
    mech, asked = problem.mechanism, problem.counterweights
    assert asked is not None
    low, high, _ = drive_range(mech)
    motion = solve(mech, np.linspace(low, high, 17)[1:-1], order=0)
    total = np.zeros(15, np.complex128)
    for mass in asked.loads.masses:
        total = total + mass.mass * motion.bodies[mass.link].point(mech.link(mass.link).points[mass.centre])
    spared = 0.0  # what is so little beside the rest that nothing is hung for it
    for one in asked.mounts:
        no, points = mech.number(one.link), mech.link(one.link).points
        found = [float(np.real(solution.answers[named(no).key].drawn)) for named in (product, bearing, weight)]
        if np.isnan(found[1]) and found[0] <= CLOSES * asked.own * mech.scale:
            spared += found[0]
            continue
        pivot = points[one.outlets[0].point]
        line = points[one.towards] - pivot
        place = pivot + found[0] / found[2] * np.exp(1j * np.radians(found[1])) * line / abs(line)
        total = total + found[2] * motion.bodies[one.link].point(place)
    added = float(np.real(solution.answers["m_c"].drawn))
    size = (asked.own + added) * mech.scale
    moved = float(np.abs(total - total.mean()).max())
    return "" if moved < CLOSE * size + 2 * spared else f"the centre of mass moves: {moved / size:.2g} of all"


def _find(links: str) -> str:
    keys = [f"{stem}_c{no}" for no in links for stem in ("W", "theta", "m")]
    return f"find: [{', '.join(keys)}, m_c, ratio_c]\n"


def _mass(rng: np.random.Generator, link: int, line: str, long: float) -> str:
    """A mass somewhere about a line of a link: on it, or beside it, between its ends or beyond."""
    at, left = rng.uniform(-0.3, 1.3) * long, rng.choice([0.0, rng.uniform(-0.4, 0.4) * long])
    aside = f", left: {left:.4f} mm" if left else ""
    return f"  {link}: {{mass: {rng.uniform(0.2, 5):.4f} kg, centre: {{along: {line}, at: {at:.4f} mm{aside}}}}}\n"


def _hung(rng: np.random.Generator, links: str) -> str:
    said = ", ".join(f"{no}: {{r: {rng.uniform(30, 200):.3f} mm}}" for no in links)
    return f"counterweights: {{{said}}}\n{_find(links)}"


def _turn(rng: np.random.Generator) -> str:
    return f"input: {{link: 1, phi: {rng.uniform(0, 360):.3f} deg, omega: 8 rad/s ccw}}\n"


@family("balanced-four-bar", also=centre_rests, often=3)
def four_bar(rng: np.random.Generator) -> str:
    """A crank-rocker with counterweights on two of its three links, or with a dyad on its rocker and three of them."""
    a, d = rng.uniform(40, 90), rng.uniform(200, 300)
    b, c = rng.uniform(0.9, 1.1) * d, rng.uniform(0.7, 0.95) * d
    six = rng.random() < 0.4
    links = f"links:\n  1: {{AB: {a:.3f} mm}}\n  2: {{BC: {b:.3f} mm}}\n"
    masses = "masses:\n" + "".join(_mass(rng, no, line, long) for no, line, long in ((1, "AB", a), (2, "BC", b)))
    masses += _mass(rng, 3, "DC", c)
    if not six:
        links += f"  3: {{CD: {c:.3f} mm}}\n"
        named = str(rng.choice(["13", "12", "23"]))
        return (
            f"{HEAD}, D: [{d:.3f} mm, 0 mm]}}\n{links}{_turn(rng)}branch: [C left of BD]\n{masses}{_hung(rng, named)}"
        )
    e, f = rng.uniform(0.5, 0.8) * c, rng.uniform(1.0, 1.2) * d
    links += f"  3: {{CD: {c:.3f} mm, E: {{along: DC, at: {e:.3f} mm}}}}\n  4: {{EF: {f:.3f} mm}}\n"
    links += f"  5: {{FG: {0.95 * d:.3f} mm}}\n"
    masses += _mass(rng, 4, "EF", f) + _mass(rng, 5, "GF", 0.95 * d)
    frame = f"{HEAD}, D: [{d:.3f} mm, 0 mm], G: [{2.1 * d:.3f} mm, 0 mm]}}\n"
    return f"{frame}{links}{_turn(rng)}branch: [C left of BD, F left of EG]\n{masses}{_hung(rng, '135')}"


@family("balanced-slider-crank", also=centre_rests)
def slider_crank(rng: np.random.Generator) -> str:
    """Offset or not; rod and crank, or a shaper's rod and slotted link."""
    if rng.random() < 0.3:
        return _shaper(rng)
    r, offset = rng.uniform(30, 80), rng.choice([0.0, rng.uniform(-30, 30)])
    long = rng.uniform(2.5, 4) * r + abs(offset)
    masses = "masses:\n" + _mass(rng, 1, "AB", r) + _mass(rng, 2, "BC", long)
    masses += f"  3: {{mass: {rng.uniform(0.2, 5):.4f} kg}}\n"
    links = f"links:\n  1: {{AB: {r:.3f} mm}}\n  2: {{BC: {long:.3f} mm}}\n  3: {{block: C}}\n"
    joints = f"joints: [3 slides on y = {offset:.3f} mm]\nbranch: [C right of B]\n"
    return f"{HEAD}}}\n{links}{joints}{_turn(rng)}{masses}{_hung(rng, '12')}"


def _shaper(rng: np.random.Generator) -> str:
    r, down = rng.uniform(60, 110), rng.uniform(300, 420)
    arm, rod = rng.uniform(1.3, 1.5) * down, rng.uniform(120, 180)
    links = (
        f"links:\n  1: {{AB: {r:.3f} mm}}\n  2: {{block: B}}\n  3: {{slot: D, C: {{along: D, at: {arm:.3f} mm}}}}\n"
        f"  4: {{CE: {rod:.3f} mm}}\n  5: {{block: E}}\n"
        f"joints: [2 slides in 3, 5 slides on y = {arm - down - 12:.3f} mm]\nbranch: [E left of C]\n"
    )
    at, left = rng.uniform(0.2, 0.7) * arm, rng.uniform(-40, 40)
    masses = (
        f"masses:\n  2: {{mass: {rng.uniform(1, 3):.3f} kg}}\n"
        f"  3: {{mass: {rng.uniform(5, 20):.3f} kg, centre: {{along: D, at: {at:.3f} mm, left: {left:.3f} mm}}}}\n"
        f"{_mass(rng, 4, 'CE', rod)}  5: {{mass: {rng.uniform(10, 70):.3f} kg}}\n"
    )
    return f"{HEAD}, D: [0 mm, {-down:.3f} mm]}}\n{links}{_turn(rng)}{masses}{_hung(rng, '134')}"
