"""A crank-rocker from K, the frame and one limit of its rocker: a ray from A at θ to AC₁ meets the circle of C."""

from __future__ import annotations

from math import pi

import numpy as np

from ....algebra.quantity import Quantity
from ....board.paper.marks import Role
from ....designs.crank_rocker import CrankRocker
from ....plane import Line, Points, Reals, cross, distance, foot, nominal, unit
from ....plane.geometry import dot
from ....words import Words
from ..angles import marked, valued
from ..draft import SHEET, Draft
from ..limits.judged import BESIDE, judged, limits_of, settled
from ..linkage import pin, pivot

SIDES = (("朝 $D$ 一侧", "on the side of $D$"), ("另一侧", "on the other side"))


def by_limit(draft: Draft, design: CrankRocker, theta: Quantity) -> None:
    """AD and ∠ADC, then C₂ where the ray meets the circle about D, on either side of AC₁."""
    board = draft.board
    board.section(Words("已知极限位置", "The given limit position"))
    board.step(
        Words(
            "选 $μ_l$，画机架 $AD$；作 $∠ADC_1$，截取 $DC_1 = l_CD/μ_l$，得摇杆的一个极限位置，连 $AC_1$。",
            "Choose $μ_l$ and draw the frame $AD$; set out $∠ADC_1$ and lay off $DC_1 = l_CD/μ_l$: one limit position "
            "of "
            "the rocker. Join $AC_1$.",
        ),
        SHEET,
    )
    assert design.AD is not None and design.ADC is not None
    a = pivot(draft, "A", 0j)
    d = pivot(draft, "D", board.lay_off(a, 1 + 0j, draft.mm(design.AD.si), key="AD"))
    rocker = board.ray(d, unit(a - d), -board.given(design.ADC.si, "ADC"), key="DC1")
    c1 = pin(draft, "C_1", board.lay_off(d, rocker.along, draft.mm(design.CD.si), key="CD"))
    board.join(SHEET, a, d, Role.CONSTRUCTION)
    for end in (a, d):
        board.join(SHEET, c1, end, Role.CONSTRUCTION)
    marked(draft, d, (a, c1), valued(draft, "∠ADC_1", np.degrees(design.ADC.si)), key="ADC")
    radius = np.abs(c1 - d)
    _other_limits(draft, (a, d, c1), radius, theta)


def _other_limits(draft: Draft, pins: tuple[Points, Points, Points], radius: Reals, theta: Quantity) -> None:
    board, (a, d, c1) = draft.board, pins
    board.section(Words("另一极限位置", "The other limit position"))
    towards = 1.0 if float(nominal(cross(c1 - a, d - a))) > 0 else -1.0
    level = float(nominal(theta.value)) < 1e-9
    for way, side in zip((towards, -towards)[: 1 if level else 2], SIDES, strict=False):
        board.step(
            Words(
                f"过 $A$ 在{side[0]}作与 $AC_1$ 成 $θ$ 角的射线，以 $D$ 为圆心、$DC_1$ 为半径作弧，求另一极限位置。",
                f"Through $A$ draw a ray at $θ$ to $AC_1$ {side[1]}, and an arc about $D$ with the radius $DC_1$; "
                "the other limit position lies where they meet.",
            ),
            SHEET,
        )
        ray = board.ray(a, unit(c1 - a), way * theta.value * pi / 180, key="AC2" if way == towards else "")
        _meetings(draft, ray, pins, radius, level)


def _meetings(draft: Draft, ray: Line, pins: tuple[Points, Points, Points], radius: Reals, level: bool) -> None:
    board, (a, d, c1) = draft.board, pins
    gap = float(nominal(np.abs(cross(ray.along, d - a))))
    if gap > float(nominal(radius)):
        board.remark(
            Words(
                f" 此射线距 $D$ {gap:.1f} mm，大于圆的半径 {float(nominal(radius)):.1f} mm，不相交。",
                f" The ray passes $D$ at {gap:.1f} mm, more than the radius of {float(nominal(radius)):.1f} mm, "
                "and does not meet it.",
            )
        )
        board.arcs_past(SHEET, d, radius, c1, d + radius * unit(foot(ray, d) - d))
        board.rule(SHEET, ray, a + ray.along * np.abs(c1 - a))
        return
    ends = board.arc_on_line(ray, d, radius, Words("求 $C_2$", "finding $C_2$"))
    away = max(ends, key=lambda at: float(nominal(distance(c1, at))))
    found = (away,) if level else tuple(sorted(ends, key=lambda at: _crank(pins, at)))  # at θ = 0 it goes through C₁
    board.arcs_past(SHEET, d, radius, c1, *found)
    board.remark(_named(draft, len(found)))
    for c2 in found:
        letter = draft.letter("C2")
        c2 = pin(draft, letter, c2)
        board.rule(SHEET, ray, c2)
        ahead = float(nominal(dot(ray.along, c2 - a) / radius)) > BESIDE
        verdict = judged(a, d, c1, c2, seen=ahead)
        settled(draft, limits_of(a, d, c1, c2, ("A", "C_1", letter)), verdict)


def _crank(pins: tuple[Points, Points, Points], c2: Points) -> float:
    """Twice the crank that a meeting gives, as it stands on the sheet: solutions are numbered by their cranks."""
    a, _, c1 = pins
    return abs(float(nominal(distance(a, c2) - distance(a, c1))))


def _named(draft: Draft, count: int) -> Words:
    """The letters of the meetings, each with the primes of its solution."""
    letters = [f"${draft.letter('C2', after)}$" for after in range(count)]
    if count == 1:
        return Words(f"交点为 {letters[0]}。", f" They intersect at {letters[0]}.")
    return Words(f"两交点为 {'、'.join(letters)}。", f" The two points of intersection are {' and '.join(letters)}.")
