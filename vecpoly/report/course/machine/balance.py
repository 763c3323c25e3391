"""The chapter on balancing: shaking force and moment over the cycle, and what counterweights leave of them."""

from __future__ import annotations

from math import degrees, isfinite
from typing import Any

import numpy as np

from ....algebra.quantity import number
from ....cycle import Extremes, table
from ....cycle.shaking import FORCE, MOMENT, about
from ....findings.machine.shaking import Best, Shaking
from ....findings.shown import places
from ....findings.study.study import Study
from ....words import Lang, Words
from ..numbering import Press
from ..results.mirrored import half, mirror, told
from ..results.plots import curve, swept
from ..results.tabled import given_place, laid_out, without_repeat
from .sums import displayed, shaking

_EXTREMES = {"zh": ["量", "最大值", "位置", "最小值", "位置"], "en": ["Quantity", "Maximum", "At", "Minimum", "At"]}
_WEIGHTS = {"zh": ["构件", "支点", "$m_c r_c$ /(kg·m)", "方位"], "en": ["Link", "Pivot", "$m_c r_c$ /(kg·m)", "Where"]}

_HODOGRAPH = Words(
    "$F_I$ 的矢端曲线上，由极点到曲线的矢量即该位置的惯性力。",
    "In the hodograph the vector from the pole to the curve is the force at that position.",
)
_FLAT, _NOTHING = 0.12, 1e-9  # of the larger component: a hodograph so low is a line; rounding


def sections(study: Study, press: Press, found: Shaking) -> list[dict[str, Any]]:
    """What acts on the frame; what counterweights leave."""
    parts = [_acting(study, press, found)]
    if _bounded(found) and (found.weights or found.best is not None):
        parts.append(_counterweights(study, press, found))
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
    return Words(
        f"$M_I$ 以逆时针为正，$r_{{Si}}$ 为由 ${pivot}$ 到质心 $S_i$ 的矢径；二者由机架承受，载荷和重力不计在内。",
        f"$M_I$ is positive counter-clockwise, and $r_{{Si}}$ is the position vector of the centre of mass $S_i$ from "
        f"${pivot}$. The frame has to bear both; loads and weights are not among them. ",
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


def _counterweights(study: Study, press: Press, found: Shaking) -> dict[str, Any]:
    """The crank's alone, then those of all links: their table follows."""
    static = [_static(study, found)] if found.weights else []
    words = [*([_crank(study, found.best)] if found.best else []), *static]
    return {
        "title": Words("配重的作用", "What counterweights leave").of(press.lang),
        "words": [w.of(press.lang) for w in words],
        "tables": [_weights(study, press, found)] if len(found.weights) > 1 else [],
        "figures": [],
    }


def _static(study: Study, found: Shaking) -> Words:
    top = found.force.highest.value if found.force.highest is not None else 0.0
    left, share = number(found.left, 4), 100 * (found.left / top - 1) if top else 0.0
    change = (f"{abs(share):.1f} %", Words("减小", "less") if share < 0 else Words("增大", "more"))
    return _needed(study, found) + Words(
        f"；此时惯性力的最大值为 {left} N，比原来{change[1].zh} {change[0]}，由作平面运动和移动的构件引起。",
        f"; the maximum force is then {left} N, {change[0]} {change[1].en} than without, and comes from the links "
        "that slide or move in general.",
    )


def _needed(study: Study, found: Shaking) -> Words:
    """The counterweights for static balance: of one link all that is to be told, of several the table follows."""
    if len(found.weights) > 1:
        return Words(
            "若在绕固定支点转动（摆动）的构件上各加配重，使其质心移到支点（静平衡），所需质径积如下表",
            "With a counterweight on each link that turns about a fixed pivot, which brings its centre of mass to the "
            "pivot (static balance), the products of mass and radius are those below",
        )
    (one,) = found.weights
    link, product = study.mech.number(one.link), number(one.product, 4)
    return Words(
        f"若在绕固定支点 ${one.pivot}$ 转动（摆动）的构件 {link} 上加配重，使其质心移到支点（静平衡），所需质径积为 "
        f"{product} kg·m，位于与质心相对的一侧",
        f"With a counterweight on link {link}, which brings its centre of mass to the fixed pivot ${one.pivot}$ "
        f"(static balance), the product of mass and radius is {product} kg·m, opposite the centre of mass",
    )


def _crank(study: Study, best: Best) -> Words:
    link, angle = study.mech.number(study.mech.drive.link), degrees(best.angle) % 360.0
    product, told = number(best.product, 4), f"{angle:.1f}".removesuffix(".0") + "°"
    sizes = tuple(number(one, 4) for one in (best.before, best.after, best.mean_before, best.mean_after))
    return Words(
        f"若只在原动件 {link} 上加一个配重，则使惯性力均方值最小的质径积为 {product} kg·m，其方位由构件 {link} 的轴线"
        "逆时针量起 "
        f"{told}：它消去惯性力中随曲柄转动的分量，最大值由 {sizes[0]} N 变为 {sizes[1]} N，均方根值由 {sizes[2]} N 减"
        f"至 {sizes[3]} N。",
        f"With one counterweight only, on the driving link {link}, the mean square of the force is least for a "
        f"product of {product} "
        f"kg·m at {told} counter-clockwise from the link's own axis: it takes away that part of the force which turns "
        "with the "
        f"crank. The maximum force changes from {sizes[0]} N to {sizes[1]} N, and its root mean square falls from "
        f"{sizes[2]} N to {sizes[3]} N.",
    )


def _weights(study: Study, press: Press, found: Shaking) -> str:
    side = Words("与质心相对的一侧", "opposite the centre of mass").of(press.lang)
    rows = [(study.mech.number(one.link), f"${one.pivot}$", number(one.product, 4), side) for one in found.weights]
    return press.table(
        Words("各构件静平衡的配重", "Counterweights for static balance"), _WEIGHTS[press.lang], rows, "ccrl"
    )


def conclusion(study: Study, found: Shaking) -> list[Words]:
    """The maximum shaking force, and what the crank's counterweight leaves."""
    top, best = found.force.highest, found.best
    if top is None or not _bounded(found):
        return []
    size, place = number(top.value, 4), study.where(top.phi)
    less = (
        Words(
            f"；原动件上加质径积 {number(best.product, 4)} kg·m 的配重后，其均方根值减小 {_saved(best)}",
            f"; a counterweight of {number(best.product, 4)} kg·m on the driving link lowers its root mean square by "
            f"{_saved(best)}",
        )
        if best is not None
        else Words.same("")
    )
    return [
        Words(
            f"机架所受惯性力最大为 {size} N（{place}）{less.zh}。",
            f"The maximum shaking force is {size} N ({place}){less.en}.",
        )
    ]


def _saved(best: Best) -> str:
    return f"{100 * (1 - best.mean_after / best.mean_before):.1f} %"
