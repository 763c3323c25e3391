"""Linkages of the tests of curvatures, as problems: four-bars, slider-cranks, rods through a swinging block."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import vecpoly

DATA: dict[str, Any] = json.loads((Path(__file__).resolve().parents[1] / "data" / "curvature.json").read_text("utf-8"))
WAYS = ("bobillier", "euler-savary", "hartmann", "aronhold")


def case_problem(case: dict[str, Any], way: str = "bobillier", find: tuple[str, ...] = ()) -> vecpoly.Problem:
    """A case as a problem: coupler 2 with its points, E for E1 and F for E2."""
    letters = dict(zip("EF", case["points"].values(), strict=False))
    points = {one: f"{{along: BC, at: {x} mm, left: {y} mm}}" for one, (x, y) in letters.items()}
    further = "".join(f", {one}: {text}" for one, text in points.items())
    asked = find or ("P_24", "W_2", "Wr_2", "delta_2", *(f"{kind}{one}" for one in letters for kind in ("p_O", "rho_")))
    return vecpoly.loads(f"""
id: case
title: case
{_body(case, further)}
input: {{link: 1, phi: {case["phi"]} deg, omega: 7 rad/s ccw}}
method: curvature
construction: {way}
find: [{", ".join(asked)}]
""")


def _body(case: dict[str, Any], further: str) -> str:
    ab = f"1: {{AB: {case['AB']} mm}}"
    if "D_at" in case or "CD" in case:
        at = case.get("D_at", [0, 0])
        side = case["branch"].removeprefix("C ")
        return f"""frame: {{A: [0 mm, 0 mm], D: [{at[0]} mm, {at[1]} mm]}}
links: {{{ab}, 2: {{BC: {case["BC"]} mm{further}}}, 3: {{DC: {case["CD"]} mm}}}}
branch: [C {side}]"""
    if "guide_y" not in case:
        return f"""frame: {{A: [0 mm, 0 mm], C: [{case["C_at"][0]} mm, {case["C_at"][1]} mm]}}
links: {{{ab}, 2: {{rod: B{further}}}, 3: {{block: C}}}}
joints: [2 passes through 3]"""
    return f"""frame: {{A: [0 mm, 0 mm]}}
links: {{{ab}, 2: {{BC: {case["BC"]} mm{further}}}, 3: {{block: C}}}}
joints: [3 slides on y = {case["guide_y"]} mm]
branch: [C right of B]"""
