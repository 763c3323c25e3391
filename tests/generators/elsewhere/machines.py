"""Mechanisms whose statements are true at the given position, and many of them nowhere else."""

from __future__ import annotations

import re
from collections.abc import Callable

import numpy as np

from ..running.machines import SORTS, Turning, crank_rocker, driven
from .statements import Untold, restated

Random = np.random.Generator


def aslant(rng: Random) -> Turning:
    """A slider-crank whose guide lies in any direction."""
    crank = rng.uniform(30, 80)
    rod, offset = crank * rng.uniform(2.2, 4.5), crank * rng.uniform(-0.9, 0.9)
    angle = int(rng.integers(-180, 180))
    k = offset * 1j * np.exp(1j * np.radians(angle))
    text = (
        f"frame: {{A: [0 mm, 0 mm], K: [{k.real:.3f} mm, {k.imag:.3f} mm]}}\n"
        f"links: {{1: {{AB: {crank:.3f} mm}}, 2: {{BC: {rod:.3f} mm}}, 3: {{block: C}}}}\n"
        f"joints: [3 slides on line through K at {angle} deg]\n"
        f"branch: [C {'right' if abs(angle) < 90 else 'left'} of B]\n"
    )
    return Turning(text=text, slider=("3", "C"), rocker=None, masses=("A", "B", "C"))


def any_four_bar(rng: Random) -> Turning:
    """Any lengths: as a rule the crank does not turn right round."""
    ab, bc, cd, ad = rng.integers(30, 120, 4)
    text = (
        f"frame: {{A: [0 mm, 0 mm], D: [{ad} mm, {rng.integers(-20, 20)} mm]}}\n"
        f"links: {{1: {{AB: {ab} mm}}, 2: {{BC: {bc} mm}}, 3: {{CD: {cd} mm}}}}\n"
        f"branch: [C {rng.choice(['left', 'right'])} of BD]\n"
    )
    return Turning(text=text, slider=None, rocker="3", masses=("A", "B", "C"))


def short_rod(rng: Random) -> Turning:
    """An offset slider-crank with a rod hardly longer than the crank."""
    crank = int(rng.integers(30, 90))
    text = (
        f"frame: {{A: [0 mm, 0 mm]}}\n"
        f"links: {{1: {{AB: {crank} mm}}, 2: {{BC: {crank + rng.integers(10, 60)} mm}}, 3: {{block: C}}}}\n"
        f"joints: [3 slides on y = {rng.integers(-20, 20)} mm]\nbranch: [C {rng.choice(['left', 'right'])} of B]\n"
    )
    return Turning(text=text, slider=("3", "C"), rocker=None, masses=("A", "B", "C"))


def six_bar(rng: Random) -> Turning:
    """A crank-rocker, on whose rocker hangs a rod with a slider or with another rocker."""
    made = crank_rocker(rng)
    reach, rod = rng.uniform(60, 150), rng.uniform(180, 320)
    links = made.text.replace("3: {CD:", f"3: {{F: {{along: DC, at: {reach:.3f} mm, left: 10 mm}}, CD:")
    if rng.random() < 0.5:
        more = f", 4: {{FG: {rod:.3f} mm}}, 5: {{block: G}}"
        joints = f"joints: [5 slides on y = {rng.integers(-30, 30)} mm]\n"
        return _joined(links, more, joints, f"G {rng.choice(['left', 'right'])} of F", ("5", "G"))
    more = f", 4: {{FG: {rod:.3f} mm}}, 5: {{GH: {rng.uniform(180, 320):.3f} mm}}"
    links = links.replace("D: [", f"H: [{rng.integers(150, 400)} mm, {rng.integers(-150, 150)} mm], D: [")
    return _joined(links, more, "", f"G {rng.choice(['left', 'right'])} of FH", None)


def _joined(links: str, more: str, joints: str, branch: str, slider: tuple[str, str] | None) -> Turning:
    text = re.sub(r"(3: \{.*\})\}\n", rf"\1{more}}}\n", links)
    text = joints + re.sub(r"branch: \[(.*)\]", rf"branch: [\1, {branch}]", text)
    return Turning(text=text, slider=slider, rocker="3", masses=("A", "B", "C", "G", "G"))


Sort = Callable[[Random], Turning]
ALL: tuple[Sort, ...] = (*SORTS, aslant, six_bar)
BARS: tuple[Sort, ...] = (SORTS[0], SORTS[1], aslant, six_bar, any_four_bar)  # with a coupler BC, which carries E
SMALL: tuple[Sort, ...] = (any_four_bar, any_four_bar, short_rod)  # of which curvatures are found on the sheet


def made(rng: Random, sorts: tuple[Sort, ...] = ALL) -> tuple[str, Turning]:
    """A mechanism with its drive, and what of it slides or swings."""
    while True:
        one = sorts[int(rng.integers(len(sorts)))](rng)
        point = f"E: {{along: BC, at: {rng.integers(-40, 140)} mm, left: {rng.integers(-60, 60)} mm}}"
        text = re.sub(r"2: \{BC: ([\d.]+ mm)\}", rf"2: {{BC: \1, {point}}}", driven(rng, one))
        try:
            return restated(rng, f"id: elsewhere\ntitle: elsewhere\n{text}"), one
        except Untold:
            continue
