"""Dyads behind pins that do not move, and behind pins that do: of what rests in all places it is said, and of nothing
else."""

from __future__ import annotations

import re

import numpy as np

from vecpoly import oracle
from vecpoly.check.resting import at_rest
from vecpoly.solution import Solution

from ..family import family

PLACES = np.array([-2e-3, -1e-3, 0.0, 1e-3, 2e-3])
STILL = 1e-12


def as_places_say(solution: Solution) -> str:
    """The links of which it is said, and those of which five positions are one."""
    mech = solution.problem.mechanism
    motion = oracle.solve(mech, mech.drive.position + PLACES, order=0)
    rests = set()
    for name in mech.numbered:
        at, angle = np.asarray(motion.origin(name)), np.exp(1j * np.asarray(motion.angle(name)))
        spread = float(np.abs(np.broadcast_to(at, 5) - at.flat[0]).max()) / mech.scale
        if max(spread, float(np.abs(np.broadcast_to(angle, 5) - angle.flat[0]).max())) < STILL:
            rests.add(name)
    remarks = at_rest(solution.problem)
    told = [re.match(r"links? ([\d, ]+) stands? still wherever", words.en) for words in remarks]
    said = {name for one in told if one is not None for name in one[1].split(", ")}
    if not all("静止" in words.zh for words in remarks if "stand" in words.en):
        return "it is not said in Chinese"
    return "" if said == rests else f"at rest are {sorted(rests)}, said is it of {sorted(said)}"


@family("keys-resting", also=as_places_say, often=3)
def resting(rng: np.random.Generator) -> str:
    """A four-bar; a dyad on its pivot, on a point of the rocker that lies there, or on one that moves; one more."""
    d, f = int(rng.integers(180, 240)), complex(int(rng.integers(260, 320)), int(rng.integers(60, 140)))
    where = str(rng.choice(["D", "G", "C", "S"]))
    rocker = "DC: 130 mm" + (", G: {along: DC, at: 0 mm}" if where == "G" else "")
    links = [f"1: {{AB: {rng.integers(30, 50)} mm}}", "2: {BC: 170 mm}", f"3: {{{rocker}}}"]
    joints, branch = [], ["C left of BD"]
    if where == "S":  # a block on a fixed guide
        links += [f"4: {{DE: {rng.integers(90, 150)} mm}}", "5: {block: E}"]
        joints, branch = [f"5 slides on y = {rng.integers(-60, 60)} mm"], [*branch, "E right of D"]
    else:
        reach = abs(f - d) if where != "C" else 240.0
        links += [f"4: {{{where}E: {0.8 * reach:.2f} mm}}", f"5: {{FE: {0.7 * reach:.2f} mm}}"]
        branch.append(f"E {rng.choice(['left', 'right'])} of {where}F")
    if rng.random() < 0.5:
        links += ["6: {EH: 160 mm}", "7: {KH: 170 mm}"]
        branch.append("H left of EK")
    letters = [letter for letter in "CEH" if any(f"{letter}:" in link or f"{letter} " in link for link in links)]
    asked = ", ".join(f"{kind}_{letter}" for letter in letters for kind in "va")
    drive = f"{{link: 1, phi: {rng.integers(0, 360)} deg, omega: 5 rad/s ccw, alpha: {rng.integers(0, 9)} rad/s^2}}"
    return (
        f"id: t\ntitle: t\nlinks: {{{', '.join(links)}}}\njoints: [{', '.join(joints)}]\n"
        f"frame: {{A: [0 mm, 0 mm], D: [{d} mm, 0 mm], F: [{f.real} mm, {f.imag} mm], K: [420 mm, 40 mm]}}\n"
        f"input: {drive}\nbranch: [{', '.join(branch)}]\nfind: [{asked}]\n"
    )
