"""Plate cams that move their followers: any follower, law and sense, at any place of the turn."""

from __future__ import annotations

import numpy as np

from tests.devices.cams_moving import FOLLOWERS, LAWS, moved
from vecpoly.mechanism.model import Mechanism
from vecpoly.solution import Solution

from .equilibrium import in_equilibrium
from .family import family


def moved_as_the_law_says(solution: Solution) -> str:
    """What is drawn with the centre of curvature is what the law gives, to rounding."""
    mech = solution.problem.subject
    assert isinstance(mech, Mechanism) and mech.cams
    for key, answer in solution.answers.items():
        if abs(answer.drawn - answer.exact) > 0.25 * abs(answer.exact) + 5 * answer.expected_error + 1e-6:
            return f"{key}: {answer.drawn} drawn, {answer.exact} by the law"
    return ""


@family("plate cam", moved_as_the_law_says, often=1, first=1)
def plate_cam(rng: np.random.Generator) -> str:
    """A rise or a return, off its ends, where there is a polygon to draw."""
    follower = str(rng.choice(sorted(FOLLOWERS)))
    by = f"{rng.integers(6, 12)} {'deg' if 'arm' in follower else 'mm'}"
    up, back = (int(rng.integers(100, 130)) for _ in range(2))
    one, two = (str(rng.choice(LAWS)) for _ in range(2))
    turns = str(rng.choice(["ccw", "cw"]))
    motion = f"[rise {by} in {up} deg {one}, dwell 20 deg, return in {back} deg {two}, dwell {340 - up - back} deg]"
    share = float(rng.uniform(0.15, 0.4)) + 0.5 * float(rng.integers(0, 2))
    start, wide = (0, up) if rng.random() < 0.5 else (up + 20, back)
    phi = (1 if turns == "ccw" else -1) * (start + share * wide)
    return moved(follower, motion, turns, round(phi, 3), alpha=0.0).text


@family("plate cam with a dyad", moved_as_the_law_says, often=1, first=1)
def plate_cam_with_a_dyad(rng: np.random.Generator) -> str:
    """A rocker hung on the follower's tip, which a profile whose curvature changes must not carry away."""
    return hung_on(*followed(rng), side=float(rng.choice([-1, 1])))


@family("forces-plate-cam-with-a-dyad", in_equilibrium, often=1, first=4)
def forces_on_a_plate_cam_with_a_dyad(rng: np.random.Generator) -> str:
    """The same with masses and loads, frictionless or not."""
    text = hung_on(*followed(rng), side=float(rng.choice([-1, 1])))
    centre = f"{{along: BC, at: {rng.integers(30, 120)} mm}}"
    loads = f"masses: {{7: {{mass: 1 kg, inertia: 0.002 kg*m^2, centre: {centre}}}}}\n"
    loads += f"loads:\n  Q: {{on: 2, at: B, size: {rng.integers(600, 900)} N, direction: -90 deg}}\n"
    loads += (
        f'  M_8: {{on: 8, size: {rng.integers(1, 9)} N*m {rng.choice(["cw", "ccw"])}}}\n  M_1: {{on: 1, size: "?"}}\n'
    )
    if rng.random() < 0.5:
        loads += (
            f"friction: {{O: {{rho: 3 mm}}, C: {{rho: 2 mm}}{', T: {phi: 5 deg}' if 'radius: 0 mm' in text else ''}}}\n"
        )
    return text.replace("find: [", f"{loads}find: [M_1, R_12, R_27, ")


def followed(rng: np.random.Generator) -> tuple[str, str, str, float]:
    """A follower with a tip, its motion, the sense of its cam, the angle at which it stands."""
    follower = str(rng.choice([one for one in sorted(FOLLOWERS) if "face" not in one]))
    by = f"{rng.integers(6, 12)} {'deg' if 'arm' in follower else 'mm'}"
    laws, turns = [str(rng.choice(LAWS)) for _ in range(2)], str(rng.choice(["ccw", "cw"]))
    motion = f"[rise {by} in 120 deg {laws[0]}, dwell 20 deg, return in 110 deg {laws[1]}, dwell 110 deg]"
    phi = (1 if turns == "ccw" else -1) * float(rng.uniform(20, 100) + 140 * rng.integers(0, 2))
    return follower, motion, turns, round(phi, 3)


def hung_on(follower: str, motion: str, turns: str, phi: float, side: float = 1.0) -> str:
    """The cam's mechanism with the dyad BC, CG on its tip."""
    text = moved(follower, motion, turns, phi, alpha=0.0).text
    lines = text.splitlines()
    at = next(i for i, line in enumerate(lines) if line.startswith("joints:"))
    lines[at:at] = ["  7: {BC: 150 mm}", "  8: {GC: 140 mm}"]
    lines = [line.replace("O: [0 mm, 0 mm]", f"O: [0 mm, 0 mm], G: [{160 * side:g} mm, 120 mm]") for line in lines]
    return "\n".join(lines).replace("find: [", "branch: [C above B]\nfind: [omega_8, v_C, a_C, p_C, ") + "\n"
