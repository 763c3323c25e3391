"""A crank that drives a row of four-bars, one after another: as many dyads as one likes."""

from __future__ import annotations

from cmath import rect
from math import radians, sin

from vecpoly.problem.load import loads
from vecpoly.problem.problem import Problem

LETTERS = tuple(f"{letter}{mark}" for mark in ("", "a", "b") for letter in "BCDEFGHIJKLMNOPQRSTUVWXYZ")
PITCH = 180.0  # mm between two fixed pivots


def chain(dyads: int) -> Problem:
    """Crank 1 about A, then couplers 2, 4, 6 ... and rockers 3, 5, 7 ..., each rocker driving the next coupler."""
    frame, links, pin, at = ["A: [0 mm, 0 mm]"], ["1: {AB: 80 mm}"], "B", rect(80, radians(70))
    for k in range(dyads):
        pivot, tip, rocker = LETTERS[2 * k + 1], LETTERS[2 * k + 2], 80 + 7 * (k % 5)
        new = PITCH * (k + 1) + rect(rocker, radians(70 + 25 * sin(1 + k)))
        frame.append(f"{pivot}: [{PITCH * (k + 1):g} mm, 0 mm]")
        links += [f"{2 * k + 2}: {{{pin}{tip}: {abs(new - at):.6f} mm}}", f"{2 * k + 3}: {{{pivot}{tip}: {rocker} mm}}"]
        pin, at = tip, new
    sides = [f"{LETTERS[2 * k + 2]} left of {LETTERS[2 * k]}{LETTERS[2 * k + 1]}" for k in range(dyads)]
    return loads(
        "\n".join(
            [
                f"id: chain-{dyads}",
                "title: {zh: 四杆链, en: A chain of four-bars}",
                f"frame: {{{', '.join(frame)}}}",
                "links:",
                *(f"  {link}" for link in links),
                "input: {link: 1, phi: 70 deg, omega: 10 rad/s ccw}",
                f"branch: [{', '.join(sides)}]",
                f"find: [v_{pin}, omega_{2 * dyads + 1}, a_{pin}]",
            ]
        )
    )
