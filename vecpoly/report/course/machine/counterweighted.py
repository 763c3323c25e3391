"""What counterweights leave of the shaking force: those that the problem asks for, the crank's alone, and those that
bring each link's own centre of mass to its pivot; what each is for is said, so that they are not taken for each other.
"""

from __future__ import annotations

from math import degrees
from typing import Any

from ....algebra.quantity import number
from ....findings.machine.shaking import Best, Shaking
from ....findings.study.study import Study
from ....mechanism.asked.counterweights import product
from ....mechanism.counterweights import translating
from ....words import Words, joined
from ..numbering import Press

_WEIGHTS = {"zh": ["构件", "支点", "$m_c r_c$ /(kg·m)", "方位"], "en": ["Link", "Pivot", "$m_c r_c$ /(kg·m)", "Where"]}
_NONE = Words.same("")


def section(study: Study, press: Press, found: Shaking) -> dict[str, Any]:
    """Those asked for, the crank's alone, then those of all links: their table follows."""
    words = [
        *([_designed(study, found, found.designed)] if found.designed is not None else []),
        *([_crank(study, found.best)] if found.best else []),
        *([_static(study, found)] if found.weights else []),
    ]
    return {
        "title": Words("配重的作用", "What counterweights leave").of(press.lang),
        "words": [w.of(press.lang) for w in words],
        "tables": [_weights(study, press, found)] if len(found.weights) > 1 else [],
        "figures": [],
    }


def concluded(study: Study, found: Shaking) -> Words:
    """What is left of the force, behind its maximum: with the counterweights asked for, else with the crank's."""
    best = found.best
    if found.designed is not None:
        symbols, left = _symbols(study), _left(found.designed)
        return Words(
            f"；加上所求的配重（{symbols.zh}）后，{left.zh}",
            f"; with the counterweights asked for, {symbols.en}, {left.en}",
        )
    if best is None:
        return _NONE
    saved = f"{100 * (1 - best.mean_after / best.mean_before):.1f} %"
    return Words(
        f"；原动件上加质径积 {number(best.product, 4)} kg·m 的配重后，其均方根值减小 {saved}",
        f"; a counterweight of {number(best.product, 4)} kg·m on the driving link lowers its root mean square by "
        f"{saved}",
    )


def _symbols(study: Study) -> Words:
    asked = study.problem.counterweights
    mounts = () if asked is None else asked.mounts
    return joined([Words.same(f"${product(study.mech.number(one.link)).symbol}$") for one in mounts])


def _left(size: float) -> Words:
    if not size:
        return Words(
            "任何位置的惯性力都为零，即惯性力完全平衡（惯性力矩未平衡）",
            "the force is zero in every position: it is fully balanced, its moment is not",
        )
    return Words(f"惯性力最大为 {number(size, 4)} N", f"the force is {number(size, 4)} N at most")


def _designed(study: Study, found: Shaking, size: float) -> Words:
    """The counterweights that the problem asks for; that what follows are others."""
    symbols, left = _symbols(study), _left(size)
    top = number(found.force.highest.value, 4) if found.force.highest is not None else "0"
    told = Words(
        f"加上所求的配重（质径积 {symbols.zh}）后，{left.zh}；未加时最大为 {top} N。",
        f"With the counterweights asked for (mass-radius products {symbols.en}) {left.en}; without them it is {top} N "
        "at most. ",
    )
    if not (found.weights or found.best):
        return told
    return told + Words(
        f"以下的配重是另外的措施，仅作比较：它们加在未装上述配重的机构上，其质径积不是所求的 {symbols.zh}。",
        "The counterweights that follow are other measures, for comparison: they are hung on the mechanism without "
        f"those above, and their products are not {symbols.en}.",
    )


def _static(study: Study, found: Shaking) -> Words:
    top = found.force.highest.value if found.force.highest is not None else 0.0
    left, share = number(found.left, 4), 100 * (found.left / top - 1) if top else 0.0
    change = (f"{abs(share):.1f} %", Words("减小", "less") if share < 0 else Words("增大", "more"))
    cause = _cause(study, found)
    return _needed(study, found) + Words(
        f"；此时惯性力的最大值为 {left} N，比原来{change[1].zh} {change[0]}{cause.zh}。",
        f"; the maximum force is then {left} N, {change[0]} {change[1].en} than without{cause.en}.",
    )


def _cause(study: Study, found: Shaking) -> Words:
    """From which links the force comes that no counterweight on a fixed pivot takes away."""
    sliding = translating(study.mech)
    kinds = (
        (Words("作平面运动的构件 {}", "{}, in general plane motion"), [x for x in found.rest if x not in sliding]),
        (Words("移动的构件 {}", "{}, in translation"), [x for x in found.rest if x in sliding]),
    )
    told = [_links(study, words, links) for words, links in kinds if links]
    if not told or not found.left:
        return _NONE
    return Words(
        f"，由{'和'.join(one.zh for one in told)} 引起", f", and comes from {' and from '.join(one.en for one in told)}"
    )


def _links(study: Study, words: Words, links: list[str]) -> Words:
    numbers = joined([Words.same(study.mech.number(link)) for link in links])
    many = "links" if len(links) > 1 else "link"
    return Words(words.zh.format(numbers.zh), words.en.format(f"{many} {numbers.en}"))


def _needed(study: Study, found: Shaking) -> Words:
    """The counterweights for static balance: of one link all that is to be told, of several the table follows."""
    if len(found.weights) > 1:
        return Words(
            "若在绕固定支点转动（摆动）的构件上各加配重，使构件自身的质心移到支点（静平衡），所需质径积如下表",
            "With a counterweight on each link that turns about a fixed pivot, which brings its own centre of mass to "
            "the pivot (static balance), the products of mass and radius are those below",
        )
    (one,) = found.weights
    link, size = study.mech.number(one.link), number(one.product, 4)
    return Words(
        f"若在绕固定支点 ${one.pivot}$ 转动（摆动）的构件 {link} 上加配重，使构件自身的质心移到支点（静平衡），所需"
        f"质径积为 {size} kg·m，位于与质心相对的一侧",
        f"With a counterweight on link {link}, which brings its own centre of mass to the fixed pivot ${one.pivot}$ "
        f"(static balance), the product of mass and radius is {size} kg·m, opposite the centre of mass",
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
