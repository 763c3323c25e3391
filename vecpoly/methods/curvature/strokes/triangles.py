"""Euler and Savary by similar triangles: XP² = XJ · XO on every normal, with signs."""

from __future__ import annotations

from math import radians

import numpy as np

from ....plane import Line, Points, nominal, unit
from ....words import Words
from ..state import CurvatureFigure, Ray
from .circle import refuse_inflected

LETTERS = "abcdefghijklmqrs"  # of auxiliary points; the others stand for lines and polygons
ALONG = 1e-9  # sine of a direction that lies along the normal
AUXILIARY = 50.0  # degrees from the normal to the auxiliary ray


def inflection_by_triangles(fig: CurvatureFigure, ray: Ray) -> tuple[Points, str]:
    """J on the normal of a known path: XJ = XP²/XO."""
    assert ray.x is not None and ray.o is not None
    x, name = fig.shown(ray.moving), fig.free("J", ray.name)
    aux = _auxiliary(fig)
    fig.board.step(
        Words(
            f"按欧拉—萨瓦里公式求 ${name}$：过 ${x}$ 任作射线，取 ${x}{aux[0]} = {x}{fig.p}$；过 ${fig.p}$ 作 "
            f"${ray.fixed}{aux[0]}$ 的平行线得 ${aux[1]}$，再过 ${aux[1]}$ 作 ${aux[0]}{fig.p}$ 的平行线，交法线于 "
            f"${name}$（${x}{name} = {x}{fig.p}^2/{x}{ray.fixed}$）。",
            f"The Euler–Savary equation gives ${x}{name} = {x}{fig.p}^2/{x}{ray.fixed}$. To construct it, step off "
            f"${x}{aux[0]} = {x}{fig.p}$ on any ray from ${x}$; the parallel to ${ray.fixed}{aux[0]}$ through "
            f"${fig.p}$ cuts the ray in ${aux[1]}$, and the parallel to ${aux[0]}{fig.p}$ through "
            f"${aux[1]}$ cuts the normal in "
            f"${name}$.",
        ),
        fig.pane,
    )
    found = _third(fig, ray.x, ray.o, ray.line, aux)
    j = fig.letter(name, fig.board.follow(fig.pane, ray.x, found - ray.x, f"{ray.moving}{name}"))
    fig.thin(ray.line, fig.pole, j)
    return j, name


def centre_by_triangles(fig: CurvatureFigure, letter: str) -> None:
    """O of a path from the point J in which its normal leaves the inflection circle: EO = EP²/EJ."""
    refuse_inflected(fig, letter)
    mine, e, shown = fig.ray_of(letter), fig.at(letter), fig.shown(letter)
    name, o, aux = fig.free("J", letter), fig.free("O", letter), _auxiliary(fig)
    fig.board.step(
        Words(
            f"由 ${fig.w}$ 向 ${fig.p}{shown}$ 作垂线，垂足 ${name}$ 在拐点圆上。过 ${shown}$ 任作射线，"
            f"取 ${shown}{aux[0]} = {shown}{fig.p}$；过 ${fig.p}$ 作 ${name}{aux[0]}$ 的平行线得 ${aux[1]}$，"
            f"再过 ${aux[1]}$ 作 ${aux[0]}{fig.p}$ 的平行线，交 ${fig.p}{shown}$ 于曲率中心 ${o}$"
            f"（${shown}{o} = {shown}{fig.p}^2/{shown}{name}$）。",
            f"The foot ${name}$ of the perpendicular from ${fig.w}$ to ${fig.p}{shown}$ lies on the inflection circle. "
            f"On any ray from ${shown}$ step off ${shown}{aux[0]} = {shown}{fig.p}$; the parallel to ${name}{aux[0]}$ "
            f"through ${fig.p}$ gives ${aux[1]}$, and the parallel to ${aux[0]}{fig.p}$ through ${aux[1]}$ cuts "
            f"${fig.p}{shown}$ in the centre of curvature ${o}$ (${shown}{o} = {shown}{fig.p}^2/{shown}{name}$).",
        ),
        fig.pane,
    )
    drop = fig.normal(mine, fig.opposite)
    j = fig.letter(name, fig.meet(drop, mine, "垂足", "the foot of the perpendicular"))
    fig.thin(drop, fig.opposite, j)
    found = _third(fig, e, j, mine, aux)
    centre = fig.centre(letter, o, fig.board.follow(fig.pane, e, found - e, f"{letter}{o}"))
    fig.thin(mine, fig.pole, e, centre, j)


def _auxiliary(fig: CurvatureFigure) -> tuple[str, str]:
    """The two auxiliary points, by small letters."""
    free = [letter for letter in LETTERS if letter not in fig.taken] + ["x", "y"]
    fig.taken.update(free[:2])
    return free[0], free[1]


def _third(fig: CurvatureFigure, x: Points, o: Points, line: Line, aux: tuple[str, str]) -> Points:
    """The point at XP²/XO from X on the line through X, P and O: two pairs of parallels at an auxiliary ray."""
    board, p = fig.board, fig.pole
    along = unit(p - x) * np.exp(1j * _side(x, p, fig.opposite))
    first = board.lay_off(x, along, np.abs(p - x))
    ray = Line(x, along)
    cut = board.parallel(p, unit(first - o))
    second = fig.meet(cut, ray, f"{aux[1]} 点", f"point {aux[1]}")
    back = board.parallel(second, unit(first - p))
    found = fig.meet(back, line, "法线上的点", "the point of the normal")
    for at, name in ((first, aux[0]), (second, aux[1])):
        fig.letter(name, at)
    fig.thin(ray, x, first, second)
    fig.thin(fig.through(o, first), o, first)
    fig.thin(cut, p, second)
    fig.thin(fig.through(first, p), first, p)
    fig.thin(back, second, found)
    return found


def _side(x: Points, p: Points, w: Points) -> float:
    """To which side of the normal the auxiliary ray goes: away from the inflection pole where that is known."""
    u, v = complex(nominal(p - x)), complex(nominal(w - p))
    return radians(-AUXILIARY if (u.conjugate() * v).imag > ALONG * abs(u) * abs(v) else AUXILIARY)
