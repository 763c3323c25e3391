"""Linkages of which pressure and transmission angles are asked; a third party takes the velocities of the points."""

from __future__ import annotations

import numpy as np

from vecpoly import oracle
from vecpoly.mechanism.asked.pressure import driven_links
from vecpoly.mechanism.model import Prismatic
from vecpoly.solution import Solution

from .family import family

CLOSE = 1e-6  # deg
SLOW = 1e-5  # of the greatest velocity: the direction of a slower one is rounding


def by_velocities(solution: Solution) -> str:
    """α is the angle of the rod, or of the normal of the guide, to the velocity of the driven link's own point."""
    mech = solution.problem.mechanism
    motion = oracle.solve(mech, order=1)
    for driven in driven_links(mech):
        here = complex(motion.position(driven.at))
        if isinstance(driven.press, Prismatic):
            turned = complex(motion.bodies[driven.press.guide].unit[0])
            line = 1j * turned * np.exp(1j * driven.press.direction)
        else:
            line = here - complex(motion.position(driven.press))
        velocity = complex(motion.moving(driven.link).velocity_at(np.array([here]))[0])
        if abs(velocity) < SLOW * mech.scale * abs(mech.drive.rate):
            continue
        across = line.conjugate() * velocity
        alpha = float(np.degrees(np.arctan2(abs(across.imag), abs(across.real))))
        found = solution.answers[driven.alpha.key].drawn
        if abs(alpha - found) > CLOSE or abs(solution.answers[driven.gamma.key].drawn - 90.0 + alpha) > CLOSE:
            return f"{driven.alpha.key} drawn {found}, by velocities {alpha}"
    return ""


@family("pressure angle", also=by_velocities)
def pressed(rng: np.random.Generator) -> str:
    """A four-bar, a slider-crank driven from either end, a guide bar with an offset, a yoke, or a six-bar, anywhere."""
    ab, bc, cd, ad = rng.integers(25, 90, 4)
    off, side = rng.integers(-15, 15), rng.choice(["left", "right"])
    crank = f"{{link: 1, phi: {rng.integers(0, 360)} deg, omega: {rng.choice(['cw', 'ccw'])}}}"
    body = {
        "four-bar": f"""frame: {{A: [0 mm, 0 mm], D: [{ad} mm, {off} mm]}}
links: {{1: {{AB: {ab} mm}}, 2: {{BC: {bc} mm}}, 3: {{DC: {cd} mm}}}}
branch: [C {side} of BD]
input: {crank}""",
        "slider": f"""frame: {{A: [0 mm, 0 mm]}}
links: {{1: {{AB: {ab} mm}}, 2: {{BC: {ab + bc} mm}}, 3: {{block: C}}}}
joints: [3 slides on y = {off} mm]
branch: [C right of B]
input: {crank}""",
        "piston": f"""frame: {{A: [0 mm, 0 mm]}}
links: {{1: {{block: C}}, 2: {{CB: {bc} mm}}, 3: {{AB: {ab} mm}}}}
joints: [1 slides on y = {off} mm]
branch: [B {side} of CA]
input: {{link: 1, s: {rng.integers(20, 150)} mm, v: {rng.choice([-1, 1])} m/s}}""",
        "guide": f"""frame: {{A: [0 mm, 0 mm], C: [{off} mm, {-ad} mm]}}
links: {{1: {{AB: {ab} mm}}, 2: {{block: B}}, 3: {{slot: C}}}}
joints: [2 slides on 3 with B {abs(off)} mm {side}]
input: {crank}""",
        "yoke": f"""frame: {{A: [0 mm, 0 mm]}}
links: {{1: {{AB: {ab} mm}}, 2: {{block: B}}, 3: {{slot: C}}}}
joints: [2 slides in 3, 3 slides on x = 0 mm turned {-rng.integers(40, 140)} deg]
input: {crank}""",
        "six-bar": f"""frame: {{A: [0 mm, 0 mm], D: [{ad} mm, 0 mm], G: [{ad + cd} mm, {off} mm]}}
links:
  1: {{AB: {ab} mm}}
  2: {{BC: {bc} mm}}
  3: {{DC: {cd} mm, E: {{along: DC, at: {rng.integers(10, 80)} mm, left: {off} mm}}}}
  4: {{EF: {bc} mm}}
  5: {{GF: {ab} mm}}
branch: [C {side} of BD, F {rng.choice(["left", "right"])} of EG]
input: {crank}""",
    }
    sort = str(rng.choice(list(body)))
    find = "alpha_C, gamma_C, alpha_F, gamma_F" if sort == "six-bar" else "alpha, gamma"
    return f"id: pressed\ntitle: pressed\n{body[sort]}\nfind: [{find}]\n"
