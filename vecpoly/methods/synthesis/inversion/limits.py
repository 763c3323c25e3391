"""The other limit of a rocker: a ray at θ from the pivot of the crank meets the circle of the rocker's pin."""

from __future__ import annotations

from collections.abc import Iterator
from math import degrees

import numpy as np

from ....board.paper.marks import Role
from ....designs.inversion.plan import Limits
from ....designs.inversion.refusals import no_limit
from ....plane import Line, Points, Reals, cross, nominal, unit
from ....plane.geometry import dot
from ....words import Words
from ..draft import SHEET
from ..linkage import pin
from .sheet import Places, Sheet, Stands, lettered


def limits(sheet: Sheet, stage: Limits) -> Iterator[Sheet]:
    """Every C₂ that makes C₁ the limit that it is; then A B is half the difference of AC₁ and AC₂."""
    board, c = sheet.draft.board, stage.pin
    board.section(Words("摇杆的极限位置", "Limit positions of the rocker"))
    theta = degrees(stage.theta)
    board.step(
        Words(
            f"极位夹角 $θ = 180°(K − 1)/(K + 1)$ = {theta:.4g}°。连 ${stage.about}{c}_1$，过 ${stage.about}$ 作与"
            f"它成 $θ$ 的射线，与以 ${stage.pivot}$ 为圆心、${stage.pivot}{c}_1$ 为半径的弧相交于 ${c}_2$。",
            f"The angle between the limit positions is $θ = 180°(K − 1)/(K + 1)$ = {theta:.4g}°. Join "
            f"${stage.about}{c}_1$; a ray at $θ$ to it from ${stage.about}$ meets the arc about ${stage.pivot}$ "
            f"through ${c}_1$ at ${c}_2$.",
        ),
        SHEET,
    )
    a, d = sheet.pins[stage.about][0], sheet.pins[stage.pivot][0]
    c1 = sheet.pins[c][0]
    board.join(SHEET, a, c1, Role.CONSTRUCTION)
    met = [c2 for ray in _rays(sheet, stage, a, c1) for c2 in _meetings(sheet, ray, d, np.abs(c1 - d))]
    board.arcs_past(SHEET, d, np.abs(c1 - d), c1, *met)
    kept = [c2 for c2 in met if float(nominal((c1 - c2).real)) * stage.limit.sense > 0]
    if not kept:
        raise no_limit(stage, len(met))
    if len(kept) < len(met):
        board.remark(_other_side(stage))
    return (_swung(sheet, stage, a, d, (c1, c2)) for c2 in kept)


def _other_side(stage: Limits) -> Words:
    """That a meeting would make C₁ the other limit."""
    side = stage.limit.label
    return Words(
        f"（射线与圆在 ${stage.pin}_1$ {side.zh}侧的交点舍去：取它则 ${stage.pin}_1$ 不是{side.zh}极限。）",
        f" (Where it meets the circle on the {side.en} of ${stage.pin}_1$ is rejected: ${stage.pin}_1$ would not be "
        f"the {side.en} limit.)",
    )


def _rays(sheet: Sheet, stage: Limits, a: Points, c1: Points) -> list[Line]:
    """Both rays at θ to AC₁."""
    base = unit(c1 - a)
    return [sheet.draft.board.ray(a, base, way * stage.theta, key=f"{stage.about}{stage.pin}2") for way in (1, -1)]


def _meetings(sheet: Sheet, ray: Line, centre: Points, radius: Reals) -> Iterator[Points]:
    """Where a ray meets the circle, ahead of its start."""
    if abs(float(nominal(cross(ray.along, centre - ray.at)))) > float(nominal(radius)):
        return
    what = Words("求另一极限位置", "finding the other limit")
    for at in reversed(sheet.draft.board.arc_on_line(ray, centre, radius, what)):
        if float(nominal(dot(ray.along, at - ray.at))) > 0:
            sheet.draft.board.rule(SHEET, ray, at)
            yield at


def _swung(sheet: Sheet, stage: Limits, a: Points, d: Points, c: tuple[Points, Points]) -> Sheet:
    """C₂ with its letter, the crank pin in both limits, and the rocker in both."""
    draft, board, (c1, c2) = sheet.draft, sheet.draft.board, c
    letter = draft.letter(f"{stage.pin}2")
    places: Places = (c1, pin(draft, letter, c2))
    far = int(float(nominal(np.abs(c2 - a))) > float(nominal(np.abs(c1 - a))))
    crank = (np.abs(places[far] - a) - np.abs(places[1 - far] - a)) / 2
    long, short = (f"{stage.about}{stage.pin}_{n + 1}" for n in (far, 1 - far))
    coupler, own = f"{stage.crank}{stage.pin}", f"{stage.about}{stage.crank}"
    board.step(
        Words(
            f"两极限位置上曲柄与连杆共线，${long}$ = ${coupler} + {own}$，${short}$ = ${coupler} − {own}$，故 "
            f"${own}$ = $({long} − {short})/2$；由此在 ${long}$ 上、${short}$ 的反向延长线上定出 "
            f"${stage.crank}$ 的两位置。",
            f"In the limits crank and coupler are in line: ${long}$ = ${coupler} + {own}$ and ${short}$ = "
            f"${coupler} − {own}$, so that ${own}$ = $({long} − {short})/2$. Lay it off on ${long}$, and on ${short}$ "
            f"produced beyond ${stage.about}$: both positions of ${stage.crank}$.",
        ),
        SHEET,
    )
    b = tuple(board.lay_off(a, (1 if n == far else -1) * unit(at - a), crank) for n, at in enumerate(places))
    stands = tuple(Stands(start=d, end=at) for at in places)
    found = sheet.with_pin(stage.pin, places).with_pin(stage.crank, lettered(draft, stage.crank, b))
    return found.with_body(stage.of, stands)
