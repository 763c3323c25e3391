"""The chapter on balancing: shaking force and moment over the cycle, and what counterweights leave of them."""

from __future__ import annotations

from math import isfinite
from typing import Any

import numpy as np

from ....algebra.quantity import number
from ....cycle import Extremes, table
from ....cycle.shaking import FORCE, MOMENT, about
from ....findings.machine.shaking import Shaking
from ....findings.shown import places
from ....findings.study.study import Study
from ....mechanism.counterweights import translating
from ....words import Lang, Words, joined
from ..numbering import Press
from ..results.mirrored import half, mirror, told
from ..results.plots import curve, swept
from ..results.tabled import given_place, laid_out, without_repeat
from . import counterweighted
from .sums import displayed, shaking

_EXTREMES = {"zh": ["量", "最大值", "位置", "最小值", "位置"], "en": ["Quantity", "Maximum", "At", "Minimum", "At"]}

_HODOGRAPH = Words(
    "$F_I$ 的矢端曲线上，由极点到曲线的矢量即该位置的惯性力。",
    "In the hodograph the vector from the pole to the curve is the force at that position.",
)
_FLAT, _NOTHING = 0.12, 1e-9  # of the larger component: a hodograph so low is a line; rounding


def sections(study: Study, press: Press, found: Shaking) -> list[dict[str, Any]]:
    """What acts on the frame; what counterweights leave."""
    parts = [_acting(study, press, found)]
    if _bounded(found) and (found.weights or found.best is not None or found.designed is not None):
        parts.append(counterweighted.section(study, press, found))
    return parts


def _bounded(found: Shaking) -> bool:
    """Whether the force has a maximum value: at a change point, and where a drive goes through a dead point, it has
    none."""
    return found.force.highest is None or isfinite(found.force.highest.value)


def _acting(study: Study, press: Press, found: Shaking) -> dict[str, Any]:
    """Over one turn: what the masses do repeats itself whatever the period of the loads is."""
    turn, turns = study.turn.once, study.varies(MOMENT.key)
    parts = (*FORCE.parts, *([MOMENT.key] if turns else []))
    across, made = _across(study), without_repeat(table(turn, parts, study.rows[study.rows < len(turn.phi)]))
    about, near = mirror(made), given_place(study)
    plots = [] if across else [swept(study, press.lang, FORCE.key, turn)]
    plots += [curve(study, press.lang, [FORCE.key], turn)]
    plots += [curve(study, press.lang, [MOMENT.key], turn)] if turns else []
    title = Words("惯性力和惯性力矩", "Shaking force and shaking moment")
    return {
        "title": Words("机构对机架的惯性力和惯性力矩", "Shaking force and shaking moment on the frame").of(press.lang),
        "lead": _lead(study).of(press.lang),
        "formulas": displayed(press, shaking()),
        "words": [_words(study, across).of(press.lang), *([told(made, about, near).of(press.lang)] if about else [])],
        "tables": [_extremes(study, press, found), laid_out(half(made, about, near) if about else made, press, title)],
        "figures": press.figures(plots),
    }


def _lead(study: Study) -> Words:
    pivot = about(study.mech)
    return Words(
        f"原动件按题设匀速运动时，运动构件的惯性力系向固定点 ${pivot}$ 简化，得主矢和主矩：",
        "With the input link moving uniformly as given, the inertia forces of all moving links, reduced to the fixed "
        f"point ${pivot}$, are a force and a moment:",
    )


def _told(study: Study) -> Words:
    pivot = about(study.mech)
    hung = Words("、重力和所求的配重", ", weights and the counterweights asked for")
    beside = Words("和重力", " and weights") if study.problem.counterweights is None else hung
    return Words(
        f"$M_I$ 以逆时针为正，$r_{{Si}}$ 为由 ${pivot}$ 到质心 $S_i$ 的矢径；二者由机架承受，载荷{beside.zh}不计在内。",
        f"$M_I$ is positive counter-clockwise, and $r_{{Si}}$ is the position vector of the centre of mass $S_i$ from "
        f"${pivot}$. The frame has to bear both; loads{beside.en} are not among them. ",
    ) + _without_inertia(study)


def _without_inertia(study: Study) -> Words:
    """Of which links that turn no moment of inertia is given."""
    given, loads = {datum.symbol for datum in study.problem.given.data}, study.problem.acting
    still = translating(study.mech)
    masses = () if loads is None or not study.varies(MOMENT.key) else loads.masses
    bare = (one for one in masses if not one.inertia and one.inertia_symbol not in given)
    links = dict.fromkeys(study.mech.number(one.link) for one in bare if one.link not in still)
    if not links:
        return Words.same("")
    told = joined([Words.same(link) for link in links])
    many = "links" if len(links) > 1 else "link"
    return Words(
        f"构件 {told.zh} 的转动惯量题目未给出，取 $J_{{Si}}$ = 0。",
        f"No moment of inertia is given of {many} {told.en}: $J_{{Si}}$ = 0 is taken. ",
    )


def _words(study: Study, across: str) -> Words:
    """What the symbols mean, and what the hodograph shows or would show."""
    return _told(study) + (_along(study, across) if across else _HODOGRAPH)


def _across(study: Study) -> str:
    """The component that is nearly nothing beside the other, so that a hodograph would be a line; none mostly."""
    sizes = {part: float(np.nanmax(np.abs(study.turn.once.real(part)))) for part in FORCE.parts}
    small, large = sorted(sizes, key=sizes.__getitem__)
    return small if sizes[small] < _FLAT * sizes[large] else ""


def _along(study: Study, across: str) -> Words:
    """What the hodograph would show."""
    size = float(np.nanmax(np.abs(study.turn.once.real(across))))
    other = next(part for part in FORCE.parts if part != across)
    top = float(np.nanmax(np.abs(study.turn.once.real(other))))
    axis, symbol = other.rpartition(".")[2], study.turn.once.info(across).symbol
    if size <= _NOTHING * top:
        return Words(f"$F_I$ 始终沿 ${axis}$ 方向。", f"$F_I$ acts along ${axis}$ throughout.")
    share = f"{number(size, 3)} N", f"{100 * size / top:.1f} %"
    return Words(
        f"$F_I$ 基本沿 ${axis}$ 方向：$|{symbol}|$ 最大 {share[0]}，仅为另一分量最大值的 {share[1]}。",
        f"$F_I$ acts nearly along ${axis}$: $|{symbol}|$ is at most {share[0]}, {share[1]} of the largest of the other "
        "component.",
    )


def _extremes(study: Study, press: Press, found: Shaking) -> str:
    rows = []
    for column, one in ((FORCE, found.force), (MOMENT, found.moment)):
        if one.highest is not None and one.lowest is not None and not one.is_constant:
            unit = f"({column.unit})" if "·" in column.unit else column.unit
            symbol = f"$|{column.symbol}|$" if column.is_vector else f"${column.symbol}$"
            rows.append((f"{symbol} /{unit}", *_spots(study, one, press.lang)))
    title = Words("惯性力、惯性力矩的极值", "Extremes of the shaking force and the shaking moment")
    return press.table(title, _EXTREMES[press.lang], rows, "lrrrr")


def _spots(study: Study, one: Extremes, lang: Lang) -> tuple[str, ...]:
    """Greatest and least, each with all its places."""
    assert one.highest is not None and one.lowest is not None
    return tuple(
        text
        for spot in (one.highest, one.lowest)
        for text in (number(spot.value, 5), places(study, one, spot).of(lang).split(" = ")[1])
    )


def conclusion(study: Study, found: Shaking) -> list[Words]:
    """The maximum shaking force, and what the counterweights that are asked for leave of it, else the crank's."""
    top = found.force.highest
    if top is None or not _bounded(found):
        return []
    size, place = number(top.value, 4), study.where(top.phi)
    less = counterweighted.concluded(study, found)
    bare = Words("，未加配重", ", without counterweights") if found.designed is not None else Words.same("")
    return [
        Words(
            f"机架所受惯性力最大为 {size} N（{place}{bare.zh}）{less.zh}。",
            f"The maximum shaking force is {size} N ({place}{bare.en}){less.en}.",
        )
    ]
