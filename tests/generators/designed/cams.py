"""Cams that are designed: every follower, every law, given or least basic circle."""

from __future__ import annotations

import numpy as np

from ..family import family
from .written import task

LAWS = ("uniform", "parabolic", "cosine", "sine", "3-4-5")


def _motion(rng: np.random.Generator, by: str) -> str:
    up, back = (int(x) for x in rng.integers(60, 150, 2))
    one, two = (str(law) for law in rng.choice(LAWS, 2))
    top = int(rng.integers(0, 50))
    rest = 360 - up - back - top
    dwell = f"dwell {top} deg, " if top else ""
    return f"[rise {by} in {up} deg {one}, {dwell}return in {back} deg {two}, dwell {rest} deg]"


@family("design-cam", first=1)
def cam(rng: np.random.Generator) -> str:
    """A plate cam for any follower."""
    offset, oa = int(rng.integers(-15, 16)), int(rng.integers(60, 110))
    followers = {
        "knife": "{knife: yes}",
        "roller": f"{{roller: {rng.integers(4, 16)} mm, offset: {offset} mm}}",
        "flat": "{flat: yes}",
        "arm": f"{{roller: {rng.integers(4, 12)} mm, arm: {{OA: {oa} mm, AB: {rng.integers(50, 90)} mm}}}}",
        "flat-arm": f"{{flat: yes, arm: {{OA: {oa} mm, face: {rng.integers(0, 10)} mm, side: left}}}}",
    }
    key = str(rng.choice(list(followers)))
    by = f"{rng.integers(8, 30)} deg" if "arm" in key else f"{rng.integers(8, 40)} mm"
    data = {
        "follower": followers[key],
        "r0": f"{rng.integers(25, 70)} mm",
        "turns": str(rng.choice(["ccw", "cw"])),
        "motion": _motion(rng, by),
    }
    find = "rho_min, r_60, theta_60" if "flat" in key else "alpha_max, rho_min, r_60, theta_60, alpha_60"
    find += "" if key == "knife" else ", undercut"
    return task("cam", data, find, "device")


@family("design-least-circle", often=2)
def least_circle(rng: np.random.Generator) -> str:
    """The least basic circle for given pressure angles."""
    data = {
        "follower": "{knife: yes}",
        "alpha": f"{{rise: {rng.integers(20, 45)} deg, return: {rng.integers(45, 80)} deg}}",
        "turns": str(rng.choice(["ccw", "cw"])),
        "motion": _motion(rng, f"{rng.integers(10, 40)} mm"),
    }
    if rng.integers(2):  # the other side is bounded too where the rise begins
        data["alpha"] = data["alpha"].replace("}", f", start: {rng.integers(10, 60)} deg}}")
    return task("cam", data, "r0, e, s0", "device")
