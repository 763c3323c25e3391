"""Couplers and rods whose curvatures are asked, by each construction; a third party takes the circle through three
places of the point."""

from __future__ import annotations

import numpy as np

from vecpoly import oracle
from vecpoly.errors import VecpolyError
from vecpoly.solution import Solution

from .family import family

WAYS = ("bobillier", "euler-savary", "hartmann", "aronhold")
STEP, CLOSE = 1e-3, 2e-3  # rad from place to place; how near the circle through three of them comes to the exact one


def three_places(solution: Solution) -> str:
    """The circle through three neighbouring places of E has the radius that was found."""
    mech = solution.problem.mechanism
    found = solution.answers.get("rho_E")
    if found is None:
        return ""
    here, unit = mech.drive.position, mech.scale if mech.drive.slide else 1.0
    try:
        wide, near = (
            _through(*np.ravel(oracle.solve(mech, [here - step, here, here + step]).position("E")))
            for step in (STEP * unit, STEP * unit / 2)
        )
    except VecpolyError:
        return ""  # too near the end of the range
    slack = CLOSE * found.exact + 4 * abs(near - wide)
    return "" if abs(near - found.exact) <= slack else f"rho_E {found.exact} against {near} through three places"


def _through(a: complex, b: complex, c: complex) -> float:
    area = abs(((b - a).conjugate() * (c - a)).imag) / 2
    return float(abs(b - a) * abs(c - b) * abs(c - a) / (4 * area)) if area else float("inf")


@family("curvature", also=three_places)
def curvature(rng: np.random.Generator) -> str:
    """A four-bar, a slider-crank or a swinging block, in any position, by any construction."""
    ab, bc, cd, ad = rng.integers(30, 90, 4)
    way = rng.choice(WAYS)
    point = f"E: {{along: BC, at: {rng.integers(-20, 80)} mm, left: {rng.integers(-40, 40)} mm}}"
    sort = rng.choice(["four-bar", "slider", "block"] if way != "aronhold" else ["slider", "block"])
    body = {
        "four-bar": f"""frame: {{A: [0 mm, 0 mm], D: [{ad} mm, {rng.integers(-20, 20)} mm]}}
links: {{1: {{AB: {ab} mm}}, 2: {{BC: {bc} mm, {point}}}, 3: {{DC: {cd} mm}}}}
branch: [C {rng.choice(["left", "right"])} of BD]""",
        "slider": f"""frame: {{A: [0 mm, 0 mm]}}
links: {{1: {{AB: {ab} mm}}, 2: {{BC: {ab + bc} mm, {point}}}, 3: {{block: C}}}}
joints: [3 slides on y = {rng.integers(-20, 20)} mm]
branch: [C right of B]""",
        "block": f"""frame: {{A: [0 mm, 0 mm], C: [{ab + rng.integers(10, 60)} mm, 0 mm]}}
links: {{1: {{AB: {ab} mm}}, 2: {{rod: B, {point}}}, 3: {{block: C}}}}
joints: [2 passes through 3]""",
    }[str(sort)]
    ball = ", U_2" if sort != "block" and rng.integers(2) else ""
    return f"""
id: curvature
title: curvature
{body}
input: {{link: 1, phi: {rng.integers(0, 360)} deg, omega: ccw}}
method: curvature
construction: {way}
find: [P_24, W_2, delta_2, p_OE, rho_E{ball}]
"""


@family("curvature-cylinder", also=three_places)
def with_cylinder(rng: np.random.Generator) -> str:
    """The rod of a cylinder that swings a lever, by any construction."""
    d = complex(*rng.integers(-400, 400, 2))
    reach, lean = int(rng.integers(100, 500)), rng.uniform(0, 2 * np.pi)
    c = reach * np.exp(1j * lean)
    side = "left" if (d.conjugate() * c).imag > 0 else "right"
    point = f"E: {{along: C, at: {rng.integers(-200, 200)} mm, left: {rng.integers(-150, 150)} mm}}"
    return f"""
id: curvature
title: curvature
frame: {{A: [0 mm, 0 mm], D: [{d.real} mm, {d.imag} mm]}}
links: {{1: {{AC: {reach} mm}}, 2: {{cylinder: D}}, 3: {{piston: C, {point}}}}}
joints: [3 slides in 2]
input: {{cylinder: 2-3, length: {abs(c - d):.6f} mm, v: {rng.choice([0.1, -0.05])} m/s}}
branch: [C {side} of AD]
method: curvature
construction: {rng.choice(WAYS)}
find: [P_34, W_3, Wr_3, delta_3, p_OE, rho_E]
"""


@family("curvature-rolling", also=three_places, often=1)
def rolling(rng: np.random.Generator) -> str:
    """A gear on an arm that rolls on a fixed one, outside or inside."""
    fixed, mine = int(rng.integers(30, 120)), int(rng.integers(10, 60))
    inside = bool(rng.random() < 0.5) and mine < fixed - 8
    arm = fixed - mine if inside else fixed + mine
    how = "inside" if inside else "on"
    angle = f"angle: {rng.integers(-180, 180)} deg"
    return f"""
id: curvature
title: curvature
frame: {{A: [0 mm, 0 mm]}}
links: {{1: {{AB: {arm} mm}}, 2: {{gear: B, radius: {mine} mm, E: {{BE: {rng.integers(5, 90)} mm, {angle}}}}}}}
joints: [2 rolls {how} circle about A of {fixed} mm at H]
input: {{link: 1, phi: {rng.integers(0, 360)} deg, omega: ccw}}
method: curvature
construction: euler-savary
find: [P_23, W_2, Wr_2, delta_2, p_OE, rho_E]
"""
